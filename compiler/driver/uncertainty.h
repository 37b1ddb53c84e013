// How much is not known of the quantities of a property: the error that a specification declares,
// how far robots may have moved since they were seen, and what the integers of the kernel add.
#pragma once

#include <vector>

#include "compiler/ir/module.h"
#include "compiler/support/rational.h"

namespace rtac::driver {

// By value of the block: the most that lies between the two ends of its interval, in steps of its
// grid, as long as every input is known. Of a comparison: of its margin, in steps of its operands;
// of other margins 0. `decision`: of the monitors of robots, null when there is none.
std::vector<Rational> widths(const ir::Watch& watch, const ir::Block& block,
                             const ir::Decision* decision = nullptr);

// Whether the operation rounds: the lower end down and the upper end up.
bool rounds(const ir::Op& op);

}  // namespace rtac::driver
