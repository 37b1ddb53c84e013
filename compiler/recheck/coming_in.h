// The straight way of a recovery into its zone, from where it may take over outside of that, and
// what keeps its height (docs/templates.md).
#pragma once

#include "compiler/recheck/claims.h"

namespace rtac::recheck {

// Whether each body that may be where a recovery takes over lies in the zone already: as the
// property of `judged` says, and those of monitors which look ahead as far as they have to and
// which nobody is accepted to break. false also where that is not known.
bool starts_within(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                   const sema::Monitor& judged, sema::ZoneId zone);

// Whether the way into the zone, which lies in the fence, does not lead out of that. `v`: what is
// claimed of the cells of the zone.
bool comes_in_within(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                     const sema::Monitor& judged, sema::ZoneId zone, sema::ZoneId fence,
                     const Values& v);

// Whether a zone of the plane lies in one with heights at each of them, so far from its walls.
bool lies_level(Claims& claims, sema::ZoneId inner, sema::ZoneId outer, const Rational& off);

// Whether a recovery keeps the limits of height of a property, wherever it moves within its zones
// or lands.
bool keeps_its_heights(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                       const sema::Controller& recovery, const sema::Expr& property);

}  // namespace rtac::recheck
