// What both glues between words of 64 bits and the structs of a kernel begin with.
#pragma once

#include <functional>
#include <string>

#include "compiler/driver/decision_engine.h"

namespace rtac::driver {

// C functions `rtac_point` and `rtac_scalar` for a kernel whose types begin with `prefix`: from
// { x_lo, x_hi, y_lo, y_hi, stamp_us, valid, z_lo, z_hi } and { lo, hi, stamp_us, valid }.
// `in_space`: points have heights.
std::string glue_readers(const std::string& prefix, bool in_space);

// Sets a plain input of a decision: `stamp` and `valid` are C, and `end(k, which)` is the step of
// the grid below (0) or above (1) component k.
std::string take_input(const DecisionInterface::Input& input, const std::string& stamp,
                       const std::string& valid,
                       const std::function<std::string(std::size_t, std::size_t)>& end);

}  // namespace rtac::driver
