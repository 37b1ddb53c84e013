#include "compiler/analysis/reach.h"

#include <algorithm>

namespace rtac::analysis {
namespace {

std::int64_t div_up(std::int64_t a, std::int64_t b) {
  return (a + b - 1) / b;
}

// A sample off the grid lies between two grid values on either axis.
std::int64_t off_grid(const ir::Body& body) {
  return body.in_space ? 3 : 2;
}

struct Speeds {
  std::int64_t cap_mmps, first_mmps, gain_mmps;
};
Speeds speeds(const ir::Body& body, const ir::Motion& motion, std::int64_t measured_mmps,
              std::int64_t t_us) {
  const std::int64_t seen = measured_mmps + body.velocity_error_mmps + off_grid(body);
  const std::int64_t cap = motion.recovery ? std::max(motion.speed_mmps, seen) : motion.speed_mmps;
  return {cap, std::min(cap, seen), div_up(motion.accel_mmps2 * div_up(t_us, 1000), 1000)};
}

}  // namespace

std::int64_t horizon_us_max(const ir::Body& body, std::int64_t lookahead_us) {
  return body.position_age_us + lookahead_us + body.latency_us + body.jitter_us;
}

std::int64_t apart_mmps(const ir::Body& body) {
  const std::int64_t apart_ms = div_up(std::max(body.position_age_us, body.velocity_age_us), 1000);
  return div_up(body.accel_mmps2 * apart_ms, 1000);
}

std::int64_t way_mm(const ir::Body& body, const ir::Motion& motion, std::int64_t measured_mmps,
                    std::int64_t t_us) {
  const Speeds s = speeds(body, motion, measured_mmps, t_us);
  const std::int64_t t_ms = div_up(t_us, 1000);
  if (s.first_mmps + s.gain_mmps <= s.cap_mmps) {
    return div_up(s.first_mmps * t_ms, 1000) + div_up(motion.accel_mmps2 * t_ms * t_ms, 2'000'000);
  }
  const std::int64_t rest = s.cap_mmps - s.first_mmps;
  return div_up(s.cap_mmps * t_ms, 1000) - rest * rest / (2 * motion.accel_mmps2);
}

std::int64_t disc_mm(const ir::Body& body, const ir::Motion& motion, std::int64_t measured_mmps,
                     std::int64_t t_us) {
  const Speeds s = speeds(body, motion, measured_mmps, t_us);
  const std::int64_t last = std::min(s.cap_mmps, s.first_mmps + s.gain_mmps);
  const std::int64_t stop = div_up(last * last, 2 * body.brake_mmps2);
  const std::int64_t tube = body.radius_mm + div_up(last * body.brake_lag_ms, 1000) +
                            div_up(stop * body.brake_lag_permille, 1000) + body.hold_mm +
                            div_up(stop * ir::sway_permille(body), 1000);
  return body.position_error_mm + off_grid(body) + way_mm(body, motion, measured_mmps, t_us) +
         stop + tube;
}

std::int64_t standing_mm(const ir::Body& body, std::int64_t period_us) {
  const ir::Motion pushed{"", 0, body.disturbance_mmps2, true, {}};
  const std::int64_t until_us = period_us + body.latency_us + body.jitter_us;
  return disc_mm(body, pushed, 0, until_us) - body.radius_mm;
}

}  // namespace rtac::analysis
