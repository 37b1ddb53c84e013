// What both glues between words of 64 bits and the structs of a kernel begin with.
#pragma once

#include <string>

namespace rtac::driver {

// C functions `rtac_point` and `rtac_scalar` for a kernel whose types begin with `prefix`: from
// { x_lo, x_hi, y_lo, y_hi, stamp_us, valid, z_lo, z_hi } and { lo, hi, stamp_us, valid }.
// `in_space`: points have heights.
std::string glue_readers(const std::string& prefix, bool in_space);

}  // namespace rtac::driver
