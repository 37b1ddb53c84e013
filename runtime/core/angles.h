// Angles in radians, counter-clockwise from +x.
#pragma once

#include <cmath>

#include "rtac/types.h"

namespace rtac::detail {

inline constexpr double pi = 3.14159265358979323846;

inline double angle(Vec2 v) {
  return std::atan2(v.y, v.x);
}
// In (-pi, pi], whatever the number of turns.
inline double wrapped(double a_rad) {
  return std::remainder(a_rad, 2 * pi);
}
inline bool finite(Vec2 v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}
inline bool finite(double v) {
  return std::isfinite(v);
}

}  // namespace rtac::detail
