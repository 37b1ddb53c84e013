// When a sample can be acted on.
#pragma once

#include <cmath>

#include "rtac/types.h"

namespace rtac {

inline bool is_finite(double value) {
  return std::isfinite(value);
}
inline bool is_finite(Vec2 value) {
  return std::isfinite(value.x) && std::isfinite(value.y);
}

inline bool is_finite(Vec3 value) {
  return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

// Received, finite, not from the future, and not older than declared; at least one period is always
// granted, because an input without a declared age has to arrive every tick.
template <class T>
bool usable(const Sample<T>& sample, TimeUs now_us, TimeUs age_us_max, TimeUs period_us) {
  if (sample.stamp_us == never_us || sample.stamp_us > now_us) return false;
  const TimeUs limit_us = age_us_max > period_us ? age_us_max : period_us;
  return now_us - sample.stamp_us <= limit_us && is_finite(sample.value);
}

}  // namespace rtac
