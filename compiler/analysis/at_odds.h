// Conditions that no state satisfies, since they ask one signal for more and for less.
#pragma once

#include <optional>
#include <vector>

#include "compiler/ir/module.h"

namespace rtac::analysis {

// Two comparisons that exclude each other: a signal would have to be at least what the one asks
// for, and at most what the other one does.
struct AtOdds {
  ir::ValueId least, most;
};

// Of the comparisons that all have to hold for a margin to be true; none: no two of them exclude
// each other, whatever the parameters become.
std::optional<AtOdds> at_odds(const ir::Block& block, ir::ValueId margin,
                              const std::vector<ir::Param>& params);

}  // namespace rtac::analysis
