// A retreat that drives beside the border of its zone alone: who is clear enough of it does not set
// out, and who is not is led no farther than a way is long.
#pragma once

#include <cstdint>
#include <optional>

#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/straight_in.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// How far from the boundary of its zone a body is at most, in mm, that is driven by a retreat of
// the plane, the recovery of `driving` but for brakes before it, from where it takes over while the
// property of `at` holds: the robot is in its zone. nullopt: nothing bounds that, as where other
// robots of the fleet may stand in its way, or it is no such recovery.
std::optional<std::int64_t> by_border_mm(const sema::RobotKind& kind, const TakeOver& at,
                                         const ir::Monitor& driving);

// How far from there a body is at most wherever monitor `k` lets such a retreat go: by then it has
// been led by it, or has braked where the look-ahead of its monitors failed, which ask for nothing
// but that zone. nullopt: it may be elsewhere, as where inputs have it drive.
std::optional<std::int64_t> let_go_within_mm(const sema::RobotKind& kind, const TakeOver& at,
                                             std::size_t k);

// Whether all of the zone that is no farther from its boundary lies in the fence, as deep.
bool border_lies_deep(const TakeOver& at, ir::ZoneIndex zone, std::int64_t near_mm,
                      const Standoff& fence);

}  // namespace rtac::analysis
