#include "rtac/safe/claim.h"

#include <algorithm>

#include "rtac/sample.h"
#include "rtac/zone.h"

namespace rtac::safe {
namespace {

constexpr double s_per_us = 1e-6;

}  // namespace

// theory, the disc: a mover that is at most as fast as it claims, or as it was found.
bool claim_holds(const Claim& claim, const RobotLimits& limits, TimeUs period_us,
                 const Observation& observation) {
  const TimeUs now_us = observation.now_us;
  const bool seen = usable(observation.position, now_us, limits.position_age_us, period_us) &&
                    usable(observation.velocity, now_us, limits.velocity_age_us, period_us);
  if (!seen || !is_finite(observation.height_m) || !is_finite(observation.climb_mps)) return false;
  const Sample<Vec2>&position = observation.position, &velocity = observation.velocity;
  const Vec3 place = position_of(observation), measured = velocity_of(observation);
  // theory, unequal stamps: the velocity may have changed between the two
  const TimeUs apart_us = std::max(position.stamp_us, velocity.stamp_us) -
                          std::min(position.stamp_us, velocity.stamp_us);
  const double error_mps =
      limits.velocity_error_mps + claim.accel_mps2 * static_cast<double>(apart_us) * s_per_us;
  const double measured_mps = norm(measured);
  if (measured_mps - error_mps > claim.speed_mps) return false;
  const double first_mps = measured_mps + error_mps, cap_mps = std::max(claim.speed_mps, first_mps);
  const double horizon_s =
      static_cast<double>(now_us - position.stamp_us + claim.reaction_us) * s_per_us;
  const double last_mps = std::min(cap_mps, first_mps + claim.accel_mps2 * horizon_s);
  const double way_m = std::min(
      first_mps * horizon_s + claim.accel_mps2 * horizon_s * horizon_s / 2, cap_mps * horizon_s);
  const double stop_m = last_mps * last_mps / (2 * limits.brake_mps2);
  const double need_m = limits.position_error_m + way_m + stop_m * (1 + claim.brake_bend) +
                        last_mps * claim.brake_lag_s + claim.hold_m + limits.radius_m;
  const double clear_m = claim.solid != nullptr ? signed_clearance(*claim.solid, place)
                                                : signed_clearance(*claim.zone, position.value);
  return clear_m >= need_m;
}

}  // namespace rtac::safe
