// Whether a recovery keeps what a property asks for beyond touching a boundary, where it moves
// within another zone than that of the property.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/analysis/recoveries_in_space.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// What a robot surely has of the boundary of the zone wherever the property holds, in mm; 0:
// nothing is known.
std::int64_t surely_off_mm(const ir::Block& property, const std::vector<ir::Param>& params,
                           ir::ZoneIndex zone);

// How much more than its body takes a robot has of the boundary of the zone of a step wherever a
// recovery takes over, in mm: as all monitors that it drives for ask for, or one that is relied on
// (fences.h).
std::int64_t starts_off_mm(const ir::Decision& decision, const ir::Recovery& step);

// Each place of the one lies in the other, so far from its boundary where that is more than
// touching. false also where that is not known, as below.
bool region_lies_deep(const geometry::Region& inner, const geometry::Region& outer,
                      std::int64_t mm);

// Each place of the inner zone is as far from the boundary of the outer one as is asked for, and in
// it. false also where that is not known: an outline of very many vertices is not offset.
bool lies_deep(const ir::Module& module, const ExactZone& exact, const ExactSolid& solid,
               ir::ZoneIndex inner, const Standoff& outer);

// Of a fence with heights: at each of them a zone of the plane lies in it, as far from its walls as
// is asked for. Who stays in the zone and keeps its height keeps the fence.
bool lies_level(const ir::Module& module, const ExactZone& exact, const ExactSolid& solid,
                ir::ZoneIndex inner, const Standoff& outer);

// The two have the same places, and so the same boundary.
bool lies_all_over(const ir::Module& module, const ExactZone& exact, const ExactSolid& solid,
                   ir::ZoneIndex inner, ir::ZoneIndex outer);

// What is strict asks for a step of the grid more than touching; a robot that holds strays by more,
// which the look-ahead covers.
inline constexpr std::int64_t touching_mm = 1;

// The ways of a recovery keep from the boundary of their zone what they need, or as much as the
// robot has where it sets out, if that is less (templates.md): a robot that sets out beside a
// machine may be led past a wall as near. So they keep a standoff from the wall where the zone has
// that boundary and no other, where each place of the zone is so far off, or where the
// property of its own monitor asks for as much from the boundary of the zone, so that the robot has
// it when it engages (theory, arbitration: the invariant holds when the module is armed, and until
// then its look-ahead keeps it). Where `judged` is another monitor, somebody may have broken that
// before: it counts as far as nobody is accepted to (`relied_on`). Who is put where its own
// property is false has no such standoff to begin with, and of that nothing is claimed (rule 11).
// The zone of `step` lies in that of the fence. Who only claims to stay in its zone may be anywhere
// in it: each place has to be so far off.
bool keeps_off(const ir::Module& module, const ir::Decision& decision, const ExactZone& exact,
               const ExactSolid& solid, const ir::Monitor& driving, const ir::Monitor& judged,
               const ir::Recovery& step, const Standoff& fence);

// What is left of a zone so far off, as it would be written, such as `yard & shrink(hall, 0.5 m)`;
// "": one of the two has no name.
std::string deep_text(const ir::Module& module, ir::ZoneIndex zone, const Standoff& fence);

}  // namespace rtac::analysis
