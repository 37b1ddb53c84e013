// How fast a property of lengths can lose its margin while the robots move.
#pragma once

#include <cstdint>
#include <optional>

#include "compiler/ir/module.h"

namespace rtac::codegen {

// Bound on how fast the margin of `property` shrinks when no robot is faster than `speed_mmps`:
// clearances change by the speed of one robot, distances by that of two, or of one and of the
// agent; `and`, `or` and the quantifiers take the largest of their parts. nullopt: there is none,
// because the property is about a charge (the price of a way jumps), about time, or constant.
std::optional<std::int64_t> closing_mmps(const ir::Block& property, std::int64_t speed_mmps,
                                         const std::vector<ir::Agent>& agents = {});

}  // namespace rtac::codegen
