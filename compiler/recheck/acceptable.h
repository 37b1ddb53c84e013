// What nobody can accept of a recovery, whatever the specification acknowledges.
#pragma once

#include <optional>

#include "compiler/recheck/claims.h"

namespace rtac::recheck {

// `acknowledge R may break M` of the recovery of M itself is about what happens while R drives
// where it should: others that come near, zones that come and go, speeds, and ways of which nothing
// is shown. Where R moves, or claims to stay, is no part of that: its zone lies in what M keeps the
// robot in, as far from the boundary as M asks for, and within its heights (5016, 5019, 5034); else
// there is no program. nullopt: it is so.
std::optional<Doubt> leads_elsewhere(const sema::Spec& spec, const sema::Decision& d,
                                     Claims& claims, const sema::Monitor& m);

// That one zone lies in another one: of what keeps its height at each of them in a zone that has
// some; nobody claims that of what is external.
Claim lies_in_claim(Claims& claims, const sema::Controller& recovery, sema::ZoneId inner,
                    sema::ZoneId outer);

// How far from the boundary of `outer` each place of `inner`, where the recovery of `driving`
// moves, has to be for what `m` asks of it; 0: it lies in it, or the robot has as much where it
// sets out, and ways lose nothing of that. A property that somebody is accepted to break, or whose
// monitor looks less far ahead than it has to, gives the robot nothing.
Rational standoff_needed(const sema::Spec& spec, const sema::Decision& d,
                         const sema::Monitor& driving, const sema::Monitor& m, sema::ZoneId inner,
                         sema::ZoneId outer);

}  // namespace rtac::recheck
