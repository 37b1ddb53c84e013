// What a monitor of a robot says that is judged now.
#pragma once

#include <cstdint>
#include <set>

#include "compiler/ir/module.h"

namespace rtac::ir {

// The facts of the property and the return condition of the monitor, and those that they have parts
// in: indices of Decision::facts.
std::set<std::uint32_t> facts_of(const Decision& decision, const Monitor& monitor);

// Whether the fact speaks of what robots sense: it is known within more than the grid of its
// inputs.
bool speaks_of_robot(const PlainMonitor& fact);

// Whether some monitor of a decision says when control may return.
bool has_return_conditions(const Module& module);

}  // namespace rtac::ir
