#include "rtac/safe/pilot.h"

#include <algorithm>
#include <cmath>

#include "angles.h"
#include "rtac/safe/pace.h"

namespace rtac::safe {
namespace {

// Directions of what lasts, in a quarter of a circle.
constexpr int directions = 90;

double velocity_delay_s(const Setting& setting) {
  return delay_s(setting, setting.limits.velocity_age_us);
}

// How far from the end of a leg a point mass may come to a stand. What lasts and is against its way
// by `back` stops it where the set-point v is no more, (v^2 + 2 v late) / (2 d) before the end as
// approach_speed has it; what is beside it, by `aside` over the gain. Below the creep nothing stops
// it: it passes the end.
double stand_off_m(const Setting& setting) {
  const RobotLimits& l = setting.limits;
  const double steers_mps2 =
      (l.accel_mps2 > 0 ? std::min(l.accel_mps2, l.brake_mps2) : l.brake_mps2) - l.disturbance_mps2;
  const double planned_mps2 = pace::planned_braking * steers_mps2;
  if (!(planned_mps2 > 0)) return 0;
  const double reaction_s = velocity_delay_s(setting);
  const double lasts_mps = l.velocity_error_mps + l.disturbance_mps2 * settling_s(setting);
  const double gain_per_s = lateral_gain_per_s(setting);
  double farthest_m = 0;
  for (int k = 0; k < directions; ++k) {
    const double from_rad = detail::pi / 2 * k / directions;
    const double to_rad = detail::pi / 2 * (k + 1) / directions;
    const double set_mps = pace::arrival_margin * lasts_mps * std::cos(from_rad);
    if (set_mps <= pace::creep_mps) break;
    const double late_mps = planned_mps2 * reaction_s;
    const double along_m = set_mps * (set_mps + 2 * late_mps) / (2 * planned_mps2);
    const double aside_m = lasts_mps * std::sin(to_rad) / gain_per_s;
    farthest_m = std::max(farthest_m, norm(Vec2{along_m, aside_m}));
  }
  return farthest_m;
}

}  // namespace

double delay_s(const Setting& setting, TimeUs age_us) {
  return 1e-6 * static_cast<double>(age_us + setting.period_us + setting.limits.latency_us);
}

Vec2 nearest_on(const Leg& leg, Vec2 at) {
  const double length_m = norm(leg.to - leg.from);
  if (length_m <= point_m) return leg.to;
  const Vec2 along = (1 / length_m) * (leg.to - leg.from);
  return leg.from + std::clamp(dot(at - leg.from, along), 0.0, length_m) * along;
}

double end_reach_m(const Setting& setting) {
  const RobotLimits& l = setting.limits;
  const double least_m = std::max(0.02, l.position_error_m);
  return l.unicycle ? least_m : std::max(least_m, stand_off_m(setting));
}

double settling_s(const Setting& setting) {
  return std::max(pace::velocity_time_s, pace::velocity_time_delays * velocity_delay_s(setting));
}

double lateral_gain_per_s(const Setting& setting) {
  const double late_s = settling_s(setting) + delay_s(setting, setting.limits.position_age_us);
  return std::min(pace::lateral_gain_per_s, pace::lateral_rad_per_delay / late_s);
}

double run_out_m(const Setting& setting) {
  const RobotLimits& l = setting.limits;
  const double steers_mps2 = l.accel_mps2 > 0 ? std::min(l.accel_mps2, l.brake_mps2) : l.brake_mps2;
  const double planned_mps2 = pace::planned_braking * (steers_mps2 - l.disturbance_mps2);
  if (planned_mps2 <= 0) return 0;
  return setting.speed_mps * velocity_delay_s(setting) +
         setting.speed_mps * setting.speed_mps / (2 * planned_mps2);
}

bool LegTracker::advance(Path& way, Vec2 at, double reach_m) {
  while (!way.finished()) {
    const Vec2 to = way.points[way.index];
    const Bearing here = bearing(way, at);
    // Passing the end counts too: a leg is not driven backwards because of a small offset.
    const bool last = way.index + 1 == way.points.size();
    const bool passed = here.remaining_m <= (last ? 0.25 * reach_m : 0.0);
    if (norm(to - at) > reach_m && !passed) return true;
    from_ = to;
    ++way.index;
  }
  return false;
}

LegTracker::Bearing LegTracker::bearing(const Path& way, Vec2 at) const {
  const Vec2 to = way.points[way.index], along = to - from_;
  const double length = norm(along);
  Bearing leg;
  leg.direction = length > point_m ? (1 / length) * along : Vec2{1, 0};
  leg.remaining_m = length > point_m ? dot(to - at, leg.direction) : 0.0;
  leg.lateral_m = leg.direction.x * (at.y - from_.y) - leg.direction.y * (at.x - from_.x);
  leg.corner_rad = detail::pi;
  if (way.index + 1 < way.points.size()) {
    const Vec2 next = way.points[way.index + 1] - to;
    if (norm(next) > point_m) {
      leg.corner_rad = std::fabs(detail::wrapped(detail::angle(next) - detail::angle(along)));
    }
  }
  return leg;
}

// With speed u at the corner and planned braking d, v is right when v r + (v^2 - u^2) / (2 d) is
// what remains: what it comes on until the brake acts, at the speed that it has by then and not at
// the full one, which would leave it to creep over a stretch that it takes seconds for.
double approach_speed(const LegTracker::Bearing& leg, double speed_mps, double brake_mps2,
                      double reaction_s) {
  const double corner_mps = speed_mps * std::max(0.0, 1 - leg.corner_rad / pace::sharp_corner_rad);
  const double planned_mps2 = pace::planned_braking * brake_mps2;
  const double late_mps = planned_mps2 * reaction_s;
  const double room_m = std::max(0.0, leg.remaining_m - corner_mps * reaction_s);
  const double square = (late_mps + corner_mps) * (late_mps + corner_mps);
  const double allowed_mps = std::sqrt(square + 2 * planned_mps2 * room_m) - late_mps;
  return std::min(speed_mps, std::max(allowed_mps, pace::creep_mps));
}

}  // namespace rtac::safe
