#include "compiler/analysis/reach.h"

#include <algorithm>

namespace rtac::analysis {
namespace {

std::int64_t div_up(std::int64_t a, std::int64_t b) {
  return (a + b - 1) / b;
}

}  // namespace

std::int64_t horizon_us_max(const ir::Body& body, std::int64_t lookahead_us) {
  return body.position_age_us + lookahead_us + body.latency_us;
}

std::int64_t disc_mm(const ir::Body& body, const ir::Motion& motion, std::int64_t measured_mmps,
                     std::int64_t t_us) {
  // 2: a sample off the grid lies between two grid values on either axis
  const std::int64_t v_error = body.velocity_error_mmps + 2;
  const std::int64_t p_error = body.position_error_mm + 2;
  const std::int64_t t_ms = div_up(t_us, 1000);
  const std::int64_t cap =
      motion.recovery ? std::max(motion.speed_mmps, measured_mmps + v_error) : motion.speed_mmps;
  const std::int64_t gain = div_up(motion.accel_mmps2 * t_ms, 1000);
  const std::int64_t s0 = std::min(cap, measured_mmps + v_error);
  const std::int64_t s1 = std::min(cap, s0 + gain);
  const std::int64_t way =
      s0 + gain <= cap
          ? div_up(s0 * t_ms, 1000) + div_up(motion.accel_mmps2 * t_ms * t_ms, 2'000'000)
          : div_up(cap * t_ms, 1000) - (cap - s0) * (cap - s0) / (2 * motion.accel_mmps2);
  const std::int64_t stop = div_up(s1 * s1, 2 * body.brake_mmps2);
  const std::int64_t tube = body.radius_mm + div_up(s1 * body.brake_lag_ms, 1000) +
                            div_up(stop * body.brake_lag_permille, 1000) + body.hold_mm;
  return p_error + way + stop + tube;
}

}  // namespace rtac::analysis
