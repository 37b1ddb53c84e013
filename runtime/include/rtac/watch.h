// What the monitors without a robot of a generated module tell: one finding per monitor and tick.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "rtac/decision.h"
#include "rtac/kernel_bridge.h"
#include "rtac/types.h"

namespace rtac {

struct Finding {
  Verdict verdict = Verdict::is_unknown;
  // Why it is not true: margin (false), within_error or input (unknown).
  Reason reason = Reason::input;
  const char* input = "";  // the one that is missing; "clock" when a tick was missed or repeated
  // Lower end of the margin, in `unit`; infinite when truth values decide or nothing is known.
  double margin = -std::numeric_limits<double>::infinity();
  const char* unit = "";
};
struct PlainMonitorInfo {
  const char* name;
  const char* requirement_id;
  const char* requirement_text;
  const char* source_file;
  int source_line;
};

namespace bridge {

struct MarginUnit {
  const char* text;
  double scale;  // `text` units in what margins count the millionths of
};

// Margins of findings, in millionths of their scale: infinite ones.
inline constexpr std::int64_t infinite_margin = 500'000'000'000'000'000;

inline std::int64_t floor_quotient(std::int64_t a, std::int64_t b) {  // b > 0
  return a / b - (a % b < 0 ? 1 : 0);
}

// What is not finite, and what is finite and off every grid.
inline constexpr std::int64_t no_number = std::numeric_limits<std::int64_t>::min();
inline constexpr std::int64_t off_grid = std::numeric_limits<std::int64_t>::max();

// KernelSample { stamp_us, valid, between, numbers }: its numbers, and bits of `between`, follow.
template <class KernelSample>
void start_sample(KernelSample& to, TimeUs stamp_us) {
  to = KernelSample{};
  to.stamp_us = stamp_us;
  to.valid = stamp_us != never_us;
}
// A number of a sample, on a grid of `step` / `per_unit` SI units: the last step that is not above
// it. Returns 1 when it lies behind that, before the next one.
inline std::uint32_t put_number(std::int64_t& to, double si, double per_unit, std::int64_t step) {
  std::int64_t lo = 0, hi = 0;
  to = std::isfinite(si) ? off_grid : no_number;
  if (!grid_pair(si, per_unit, lo, hi)) return 0;
  to = floor_quotient(lo, step);
  return -floor_quotient(-hi, step) > to ? 1 : 0;
}
// A parameter is the grid value that was meant: 0.4 is 400 mm, although the nearest double is more,
// and so is what is as near as the roundings of a decimal and of the two operations below allow.
// Between two grid values it takes the tighter one.
inline bool grid_param(double si, double per_unit, std::int64_t step, bool up, std::int64_t& to) {
  constexpr double meant = 4 * std::numeric_limits<double>::epsilon();  // relative
  std::int64_t lo = 0, hi = 0;
  const double steps = si * per_unit / static_cast<double>(step);
  const double nearest = std::nearbyint(steps);
  if (!grid_pair(si, per_unit, lo, hi)) return false;
  if (std::fabs(steps - nearest) <= meant * std::fabs(nearest)) {
    to = static_cast<std::int64_t>(nearest);
  } else {
    to = up ? -floor_quotient(-hi, step) : floor_quotient(lo, step);
  }
  return true;
}

// What leaves the range, or is looser than what was given before, is ignored.
inline void tighten(std::int64_t& param, double si, double per_unit, std::int64_t step,
                    std::int64_t least, std::int64_t most, bool up) {
  std::int64_t steps = 0;
  if (!grid_param(si, per_unit, step, up, steps) || steps < least || steps > most) return;
  if (up ? steps > param : steps < param) param = steps;
}

// KernelFinding { verdict, reason, input, unit, lo, hi }
template <class KernelFinding>
Finding finding_of(const KernelFinding& from, const MarginUnit* units, const char* const* inputs) {
  Finding to;
  to.verdict = static_cast<Verdict>(from.verdict);
  to.reason = static_cast<Reason>(from.reason);
  to.input = inputs[from.input];
  to.unit = units[from.unit].text;
  if (from.lo >= infinite_margin) {
    to.margin = std::numeric_limits<double>::infinity();
  } else if (from.lo > -infinite_margin) {
    to.margin = static_cast<double>(from.lo) * units[from.unit].scale / 1e6;
  }
  return to;
}

}  // namespace bridge
}  // namespace rtac
