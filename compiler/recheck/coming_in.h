// The straight way of a recovery into its zone, from where it may take over outside of that, and
// what keeps its height (docs/templates.md).
#pragma once

#include <vector>

#include "compiler/recheck/claims.h"

namespace rtac::recheck {

// A zone that is not left, and how far from its boundary.
struct Held {
  sema::ZoneId zone;
  Rational gap;
};
// What is kept wherever a property holds, whatever its parameters become: of each entry at least
// one of its zones.
std::vector<std::vector<Held>> held_in(const sema::Spec& spec, const sema::Expr& property);

// Whether a monitor keeps what it says until its recovery takes over, whoever drives: it looks
// ahead as far as it has to, and nobody is accepted to break it.
bool relied_on(const sema::Spec& spec, const sema::Decision& d, const sema::Monitor& m);

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

// The same of ways that stay, of each of these `or`s, where a body lies in one of its zones.
bool comes_in_by_sides(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                       const sema::Monitor& judged, sema::ZoneId zone,
                       const std::vector<std::vector<sema::ZoneId>>& either, const Values& v);

// Whether a zone of the plane lies in one with heights at each of them, so far from its walls.
bool lies_level(Claims& claims, sema::ZoneId inner, sema::ZoneId outer, const Rational& off);

// Whether a recovery keeps the limits of height of a property, wherever it moves within its zones
// or lands.
bool keeps_its_heights(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                       const sema::Controller& recovery, const sema::Expr& property);

// Whether a recovery that lands comes straight down within a zone that the property asks for, from
// wherever it is above, and ends as far above the floor as is asked.
bool comes_down_within(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                       const sema::Controller& recovery, const sema::Expr& property,
                       sema::ZoneId zone);

}  // namespace rtac::recheck
