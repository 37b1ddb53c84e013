// Between the doubles of an application and the integers of a generated kernel. Only generated
// code includes this. Every conversion rounds outward, so that a kernel never sees a measurement
// that is better than the real one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "rtac/decision.h"
#include "rtac/types.h"

namespace rtac::bridge {

// Generated code states the ABI that it was written for; see RTAC_ABI in the build.
inline constexpr int abi = 3;

// As far as any grid goes: the compiler refuses limits of inputs beyond it. Every double on the way
// is exact in int64, and so are its neighbours on the grid.
inline constexpr double grid_limit = 1e15;
// Margins of decisions, in millionths of their scale: from here on nothing is known of them.
inline constexpr std::int64_t margin_limit = 1'000'000'000'000'000;

// Largest and smallest grid value around `si * per_unit`, exact for every double: the error of the
// product is recovered by a fused multiply-add.
inline bool grid_pair(double si, double per_unit, std::int64_t& lo, std::int64_t& hi) {
  const double product = si * per_unit;
  if (!(std::fabs(product) <= grid_limit)) return false;  // also NaN
  const double error = std::fma(si, per_unit, -product);
  const double below = std::floor(product), above = std::ceil(product);
  lo = static_cast<std::int64_t>(below) - (below == product && error < 0 ? 1 : 0);
  hi = static_cast<std::int64_t>(above) + (above == product && error > 0 ? 1 : 0);
  return true;
}

// The same for a coordinate: what is finite and too far saturates; the kernel knows it as outside.
inline bool grid_coordinate(double si, std::int64_t& lo, std::int64_t& hi) {
  if (grid_pair(si, 1000, lo, hi)) return true;
  lo = hi = static_cast<std::int64_t>(si < 0 ? -grid_limit : grid_limit);
  return std::isfinite(si);
}

// KernelPoint { x_lo, x_hi, y_lo, y_hi, stamp_us, valid }
template <class KernelPoint>
void put(KernelPoint& to, const Sample<Vec2>& from) {
  const bool x = grid_coordinate(from.value.x, to.x_lo, to.x_hi);
  const bool y = grid_coordinate(from.value.y, to.y_lo, to.y_hi);
  to.stamp_us = from.stamp_us;
  to.valid = from.stamp_us != never_us && x && y;
}
// The same in space, KernelPoint { ..., z_lo, z_hi }; `height`: the third component.
template <class KernelPoint>
void put_in_space(KernelPoint& to, const Sample<Vec2>& from, double height) {
  put(to, from);
  const bool z = grid_coordinate(height, to.z_lo, to.z_hi);
  to.valid = to.valid != 0 && z;
}
// KernelScalar { lo, hi, stamp_us, valid }, in ppm
template <class KernelScalar>
void put_ratio(KernelScalar& to, const Sample<double>& from) {
  to.stamp_us = from.stamp_us;
  to.valid = from.stamp_us != never_us && grid_pair(from.value, 1e6, to.lo, to.hi);
}
// The same in mrad; an angle beyond all bounds is no angle.
template <class KernelScalar>
void put_angle(KernelScalar& to, const Sample<double>& from) {
  to.stamp_us = from.stamp_us;
  to.valid = from.stamp_us != never_us && grid_pair(from.value, 1000, to.lo, to.hi);
}
// KernelPlan { valid, count, index, x[], y[] }: way-points to the nearest mm
template <class KernelPlan>
void put(KernelPlan& to, const Path& from, std::size_t capacity) {
  to.count = static_cast<std::int32_t>(from.points.size());
  to.index = static_cast<std::int32_t>(std::min(from.index, from.points.size() + 1));
  to.valid = from.points.size() <= capacity;
  for (std::size_t i = 0; i < from.points.size() && to.valid != 0; ++i) {
    const Vec2 p = from.points[i];
    to.valid = std::isfinite(p.x) && std::isfinite(p.y);
    if (to.valid != 0) {
      to.x[i] = std::llround(std::clamp(p.x * 1000, -grid_limit, grid_limit));
      to.y[i] = std::llround(std::clamp(p.y * 1000, -grid_limit, grid_limit));
    }
  }
}

// Millionths of the scale to the unit of the record; the kernel's bounds mean "unknown". The
// quotient, and not the product with 1e-6, is the double nearest to the decimal number, which is
// why logs show "42.6848".
inline double margin_of(std::int64_t millionths) {
  if (millionths <= -margin_limit) return -std::numeric_limits<double>::infinity();
  if (millionths >= margin_limit) return std::numeric_limits<double>::infinity();
  return static_cast<double>(millionths) / 1e6;
}

// KernelOut { found { reason, index, input, other }, monitors[] { now, ahead, safer, ... } }
template <class KernelOut>
void take_findings(const KernelOut& from, int monitor_count, DecisionRecord& to) {
  to.previous_mode = to.mode;
  to.mode = from.mode;
  to.deciding_monitor = from.monitor;
  to.reason = static_cast<Reason>(from.found.reason);
  to.reason_index = from.found.index;
  to.reason_input = static_cast<InputField>(from.found.input);
  to.reason_other = from.found.other;
  for (int k = 0; k < monitor_count; ++k) {
    MonitorRecord& record = to.monitors[static_cast<std::size_t>(k)];
    record.now = static_cast<Verdict>(from.monitors[k].now);
    record.ahead = static_cast<Verdict>(from.monitors[k].ahead);
    record.safer = static_cast<Verdict>(from.monitors[k].safer);
    record.engaged = from.monitors[k].engaged != 0;
    record.margin = margin_of(from.monitors[k].margin);
  }
}

// Of a decision with a monitor that mixes units: KernelOut { monitors[] { unit } }
template <class KernelOut>
void take_units(const KernelOut& from, int monitor_count, DecisionRecord& to) {
  for (int k = 0; k < monitor_count; ++k) {
    MonitorRecord& record = to.monitors[static_cast<std::size_t>(k)];
    const int unit = from.monitors[k].unit;
    record.unit = static_cast<MarginUnit>(unit);
    if (to.info == nullptr || unit <= static_cast<int>(MarginUnit::count)) continue;
    if (unit < to.info->unit_count) record.margin *= to.info->units[unit].scale;
  }
}

}  // namespace rtac::bridge
