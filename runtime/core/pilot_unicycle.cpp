// Unicycle: speed and turn rate in the body frame.
#include <algorithm>
#include <cmath>

#include "angles.h"
#include "rtac/safe/grid_route.h"
#include "rtac/safe/pace.h"
#include "rtac/safe/pilot.h"
#include "rtac/sample.h"

namespace rtac::safe {
namespace {

// What a base that stands may move by.
constexpr double base_moves_m = 0.01;
// Sideways part of a motion that the pursuit of a receding leg may have for a moment.
constexpr double sideways_rad = 0.1;

}  // namespace

// The gain leaves room for the delay of the heading and for a turn rate that changes slowly, and
// asks for no more than the turn limit while it drives.
Steering steering_of(const Setting& setting) {
  const RobotLimits& l = setting.limits;
  const double heading_s = delay_s(setting, l.heading_age_us);
  const double position_s = delay_s(setting, l.position_age_us);
  Steering s;
  s.turn_max_radps = pace::turn_radps_max;
  if (l.turn_radps > 0) s.turn_max_radps = std::min(s.turn_max_radps, l.turn_radps);
  const auto ahead_m = [&](double gain_per_s) {
    return std::max({pace::aim_ahead_m, pace::aim_ahead_turns * setting.speed_mps / gain_per_s,
                     pace::aim_ahead_delays * setting.speed_mps * position_s});
  };
  s.gain_per_s = std::min(pace::turn_gain_per_s, pace::turn_rad_per_delay / heading_s);
  if (l.turn_accel_radps2 > 0) {
    s.gain_per_s = std::min(s.gain_per_s, l.turn_accel_radps2 / s.turn_max_radps);
  }
  const double errors_rad = l.heading_error_rad + l.position_error_m / ahead_m(s.gain_per_s);
  s.turn_end_rad = std::max(pace::turn_end_rad, pace::turn_end_errors * errors_rad);
  s.turn_begin_rad = std::max(pace::turn_begin_rad, pace::turn_begin_errors * errors_rad);
  s.gain_per_s = std::min(s.gain_per_s, s.turn_max_radps / s.turn_begin_rad);
  s.aim_ahead_m = ahead_m(s.gain_per_s);
  return s;
}

Pilot<Twist>::Pilot(const Setting& setting)
    : limits_(setting.limits),
      period_us_(setting.period_us),
      speed_mps_(setting.speed_mps),
      end_reach_m_(safe::end_reach_m(setting)),
      reaction_s_(delay_s(setting, 0)),
      steering_(steering_of(setting)) {
  // measured to be still, it may be faster than that by the error, and its brake is what it is
  const double brake_mps2 = limits_.brake_mps2 > 0 ? limits_.brake_mps2 : limits_.accel_mps2;
  const double fastest_mps = 2 * limits_.velocity_error_mps + pace::still_mps;
  stops_us_ = brake_mps2 > 0 ? static_cast<TimeUs>(std::ceil(1e6 * fastest_mps / brake_mps2)) : 0;
}

void Pilot<Twist>::engage(const Observation&) {
  latched_ = driving_ = turning_ = has_rested_ = false;
  not_at_rest();
}

void Pilot<Twist>::not_at_rest() {
  rest_.reset();
  still_samples_ = 0;
}

// At rest it is for whoever takes over, too.
void Pilot<Twist>::go_on(const Halt& halt) {
  latched_ = has_rested_ = halt.latched;
  rests_at_ = halt.place;
  rest_.go_on(halt);
}

std::optional<Halt> Pilot<Twist>::halting() const {
  return Halt{latched_, rests_at_, std::nullopt, 0, rest_.since_us(), rest_.seen_us()};
}

bool Pilot<Twist>::can_steer(const Observation& observation) const {
  const TimeUs now_us = observation.now_us;
  return usable(observation.position, now_us, limits_.position_age_us, period_us_) &&
         usable(observation.velocity, now_us, limits_.velocity_age_us, period_us_) &&
         usable(observation.heading, now_us, limits_.heading_age_us, period_us_);
}

// The base brakes by itself: speed and turn 0 at once, never a ramp (theory: unicycle).
Twist Pilot<Twist>::brake_blind(const Observation&) {
  latched_ = driving_ = false;
  not_at_rest();
  return {};
}

Twist Pilot<Twist>::halt(const Observation& observation) {
  driving_ = false;
  const bool carried_off = has_rested_ && !rests_near(observation.position.value);
  if (carried_off) {
    latched_ = has_rested_ = false;
    not_at_rest();
  }
  if (latched_) return {};
  if (rest_.admits(observation, limits_.latency_us)) {
    const bool still =
        norm(observation.velocity.value) <= limits_.velocity_error_mps + pace::still_mps;
    rest_.sees(still);
    still_samples_ = still ? still_samples_ + 1 : 0;
  }
  latched_ = still_samples_ >= pace::rest_samples && rest_.tells_where(observation, stops_us_);
  if (latched_ && !has_rested_) {
    has_rested_ = true;
    rests_at_ = position_of(observation);
  }
  return {};
}

Twist Pilot<Twist>::drive(const Observation& observation, Vec2 at, Path& way) {
  const Vec2 p = observation.position.value;
  if (has_rested_ && !rests_near(p)) return halt(observation);  // nobody looked from there
  if (!driving_) tracker_.begin(at);
  if (!tracker_.advance(way, p, end_reach_m_)) {
    return halt(observation);
  }
  latched_ = has_rested_ = false;
  not_at_rest();
  leg_ = {tracker_.from(), way.points[way.index]};
  const LegTracker::Bearing leg = tracker_.bearing(way, p);
  const bool sharp = dot(leg.direction, leg_direction_) < std::cos(pace::sharp_corner_rad);
  if (!driving_ || sharp) turning_ = true;
  driving_ = true;
  leg_direction_ = leg.direction;
  const Vec2 left{-leg.direction.y, leg.direction.x};
  const Vec2 aim = steering_.aim_ahead_m * leg.direction + (-leg.lateral_m) * left;
  const double error = detail::wrapped(detail::angle(aim) - observation.heading.value);
  if (std::fabs(error) > steering_.turn_begin_rad) turning_ = true;
  if (std::fabs(error) < steering_.turn_end_rad) turning_ = false;
  Twist out;
  out.turn_radps =
      std::clamp(steering_.gain_per_s * error, -steering_.turn_max_radps, steering_.turn_max_radps);
  if (!turning_) {
    const double brake = limits_.brake_mps2 > 0 ? limits_.brake_mps2 : limits_.accel_mps2;
    out.speed_mps = approach_speed(leg, speed_mps_, brake, reaction_s_);
  }
  return out;
}

bool Pilot<Twist>::rests_near(Vec2 measured) const {
  const double off_m = norm(measured - Vec2{rests_at_.x, rests_at_.y});
  return off_m <= 2 * limits_.position_error_m + base_moves_m;
}

Vec2 Pilot<Twist>::on_way(const Observation& observation) const {
  if (latched_) return {rests_at_.x, rests_at_.y};
  const Vec2 p = observation.position.value;
  return driving_ ? nearest_on(leg_, p) : p;
}

// Turning in place moves nothing, so that the heading counts once it drives.
bool Pilot<Twist>::recedes(const Observation& observation, Vec2 at, Vec2 target, Vec2 from) const {
  if (!safe::recedes(at, target, from)) return false;
  if (!driving_ || turning_) return true;
  const Vec2 forward{std::cos(observation.heading.value), std::sin(observation.heading.value)};
  return dot(forward, at - from) >= -std::sin(sideways_rad) * norm(at - from);
}

}  // namespace rtac::safe
