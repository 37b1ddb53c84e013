// Point mass: accelerations in the map frame.
#include <algorithm>
#include <cmath>

#include "angles.h"
#include "rtac/safe/grid_route.h"
#include "rtac/safe/pace.h"
#include "rtac/safe/pilot.h"
#include "rtac/sample.h"

namespace rtac::safe {
namespace {

constexpr double s_per_us = 1e-6;
// For what sampling adds, and the tail of its approach.
constexpr double sway_slack_m = 0.01;

Acceleration commanded(Vec3 a) {
  return {{a.x, a.y}, a.z};
}

}  // namespace

Pilot<Acceleration>::Pilot(const Setting& setting)
    : limits_(setting.limits),
      period_us_(setting.period_us),
      speed_mps_(setting.speed_mps),
      reaction_s_(delay_s(setting, setting.limits.velocity_age_us)),
      settling_s_(safe::settling_s(setting)),
      lateral_gain_per_s_(safe::lateral_gain_per_s(setting)),
      end_reach_m_(safe::end_reach_m(setting)) {
  // theory: sampled brake, eta = eps_v + b (h + l), the age of the sample being part of the lag.
  // What pushes the robot changes the speed in the meantime, too. It takes over at eta b / (b - d):
  // below that speed the velocity may be wrong by an angle at which the push makes up for what is
  // left of the brake along the way, and the robot would go on for ever (docs: lemmas,
  // sampled_brake).
  const double eta_mps =
      limits_.velocity_error_mps + (limits_.brake_mps2 + limits_.disturbance_mps2) * reaction_s_;
  rest_mps_ = eta_mps * limits_.brake_mps2 / (limits_.brake_mps2 - limits_.disturbance_mps2);
  const double late_s =
      std::max(delay_s(setting, limits_.velocity_age_us + limits_.position_age_us),
               pace::hold_delay_least_s);
  omega_radps_ = std::min(pace::hold_max_radps, pace::hold_rad_per_delay / late_s);
  const double share_mps2 =
      (limits_.brake_mps2 - limits_.disturbance_mps2) / pace::hold_brake_shares;
  if (limits_.velocity_error_mps > 0) {
    omega_radps_ = std::min(omega_radps_, share_mps2 / limits_.velocity_error_mps);
  }
  if (limits_.position_error_m > 0) {
    omega_radps_ = std::min(omega_radps_, std::sqrt(share_mps2 / limits_.position_error_m));
  }
  // lemma hold, and the error of the measurement that tells
  sway_m_ = 2 * limits_.position_error_m + 2 * limits_.velocity_error_mps / omega_radps_ +
            limits_.disturbance_mps2 / (omega_radps_ * omega_radps_) + sway_slack_m;
  // What drives off with less than the brake has to be slow: as its measurement can tell, and by no
  // more than a creep.
  const double steers_mps2 = steering_limit();
  ready_mps_ =
      2 * limits_.velocity_error_mps + std::min(steers_mps2 * reaction_s_, pace::creep_mps);
}

void Pilot<Acceleration>::engage(const Observation& observation) {
  latched_ = driving_ = false;
  on_leg_.reset();
  rest_.reset();
  // Also when it can steer: the very first command may have to do without a measurement. An older
  // velocity, of an earlier engagement, must not steer the blind brake.
  if (observation.velocity.stamp_us == never_us || !is_finite(velocity_of(observation))) {
    last_velocity_ = {};
    last_seen_us_ = never_us;
  } else {
    last_velocity_ = velocity_of(observation);
    last_seen_us_ = observation.velocity.stamp_us;
  }
}

void Pilot<Acceleration>::go_on(const Halt& halt) {
  latched_ = halt.latched;
  hold_at_ = halt.place;
  on_leg_ = halt.leg;
  leg_mps_ = std::min(halt.leg_mps, limits_.speed_mps);
  if (latched_) leave_far_leg();
  rest_.go_on(halt);
}

std::optional<Halt> Pilot<Acceleration>::halting() const {
  return Halt{latched_, hold_at_, on_leg_, leg_mps_, rest_.since_us(), rest_.seen_us()};
}

bool Pilot<Acceleration>::can_steer(const Observation& observation) const {
  const TimeUs now_us = observation.now_us;
  return usable(observation.position, now_us, limits_.position_age_us, period_us_) &&
         usable(observation.velocity, now_us, limits_.velocity_age_us, period_us_) &&
         is_finite(observation.height_m) && is_finite(observation.climb_mps);
}

// What `drive` commands at most. What is left of it slows down against whatever pushes.
double Pilot<Acceleration>::steering_limit() const {
  return limits_.accel_mps2 > 0 ? std::min(limits_.accel_mps2, limits_.brake_mps2)
                                : limits_.brake_mps2;
}

// Within what is declared a stop ends no further beside its leg, or its prolongation, than
// - it drove beside it: the correction to the leg settles where it makes up for the errors of the
//   place and of the velocity, and for what a push adds to the speed while that settles (as
//   pushed_speed of analysis/travel.cpp); half of it more until then (as analysis/limits.cpp);
// - its velocity leads aside while it stops: that correction and these errors, for the time s / (2
//   b) that the straight stop takes at the full speed s;
// - the stop bends from the straight one (lemma sampled_brake), and its hold sways.
// What legs keep clear is reckoned for such stops (cruise_clearance_mm).
double Pilot<Acceleration>::stray_m() const {
  const double b = limits_.brake_mps2, d = limits_.disturbance_mps2, left = b - d;
  const double pushed_mps = d * settling_s_;
  const double settled_m =
      limits_.position_error_m + (limits_.velocity_error_mps + pushed_mps) / lateral_gain_per_s_;
  const double beside_m = 1.5 * settled_m;
  const double aside_mps = lateral_gain_per_s_ * (beside_m + settled_m);
  const double s = leg_mps_ + limits_.velocity_error_mps + 2 * pushed_mps;
  const double eta_mps = rest_mps_ * left / b;
  const double bend_m = (eta_mps * (s + eta_mps) + d * s * s / (2 * b)) / left;
  return beside_m + aside_mps * s / (2 * b) + bend_m + sway_m_;
}

bool Pilot<Acceleration>::at_rest(const Observation& observation) const {
  return latched_ && norm(velocity_of(observation)) <= ready_mps_;
}

Acceleration Pilot<Acceleration>::limited(Vec3 a, double limit_mps2) const {
  const double size = norm(a);
  return commanded(size > limit_mps2 ? (limit_mps2 / size) * a : a);
}

Acceleration Pilot<Acceleration>::against(Vec3 v) const {
  return commanded((-limits_.brake_mps2 / std::max(norm(v), limits_.brake_mps2 * reaction_s_)) * v);
}

// By its velocity, if that is all it sees; else along the last known direction for as long as that
// speed takes to vanish. A hold stays where it was latched: anew after every gap, its place would
// wander off with the noise.
Acceleration Pilot<Acceleration>::brake_blind(const Observation& observation) {
  driving_ = false;
  const bool sees_speed =
      usable(observation.velocity, observation.now_us, limits_.velocity_age_us, period_us_) &&
      std::isfinite(observation.climb_mps);
  if (sees_speed && !latched_) {
    last_velocity_ = velocity_of(observation);
    last_seen_us_ = observation.velocity.stamp_us;
    return against(last_velocity_);
  }
  const double speed = norm(last_velocity_);
  if (latched_ || last_seen_us_ == never_us || speed <= limits_.velocity_error_mps) {
    last_velocity_ = {};  // at rest when last seen: any push would only start a motion
    return {};
  }
  const double blind_s = static_cast<double>(observation.now_us - last_seen_us_) * s_per_us;
  if (speed - limits_.brake_mps2 * blind_s <= 0) return {};
  return commanded((-limits_.brake_mps2 / speed) * last_velocity_);
}

Acceleration Pilot<Acceleration>::halt(const Observation& observation) {
  driving_ = false;
  const Vec3 v = velocity_of(observation), p = position_of(observation);
  last_velocity_ = v;
  last_seen_us_ = observation.velocity.stamp_us;
  const double speed = norm(v), b = limits_.brake_mps2;
  if (!latched_ && rest_.admits(observation, limits_.latency_us)) rest_.sees(speed <= rest_mps_);
  if (!latched_ && rest_.tells_where(observation)) {
    latched_ = true;
    // Where the remaining speed comes to rest, so that the hold begins without a step back.
    hold_at_ = p + (reaction_s_ / 2) * v;
    leave_far_leg();
  }
  if (!latched_) return against(v);
  const Vec3 spring = (omega_radps_ * omega_radps_) * (hold_at_ - p);
  const Vec3 damper = (-2 * omega_radps_) * v;
  return limited(spring + damper, b);
}

// Stop by stop, noise would carry it off: the next leg begins where this one has ended. But further
// off than its stop explains something else has carried the robot away, or it was blind, and nobody
// has looked at what lies between: it stays, and its next leg begins there. Past the end of the leg
// it may have come on by a straight stop.
void Pilot<Acceleration>::leave_far_leg() {
  if (!on_leg_) return;
  const Vec2 at{hold_at_.x, hold_at_.y}, way = on_leg_->to - on_leg_->from;
  const double length_m = norm(way);
  const double past_m = leg_mps_ * leg_mps_ / (2 * limits_.brake_mps2);
  Leg prolonged = *on_leg_;
  if (length_m > point_m) prolonged.to = prolonged.to + (past_m / length_m) * way;
  // what is not a number is not near either
  if (!(norm(at - nearest_on(prolonged, at)) <= stray_m())) on_leg_.reset();
}

// The nearest place of its leg, if it was stopped on one.
Vec3 Pilot<Acceleration>::sets_out_from() const {
  if (!on_leg_) return hold_at_;
  const Vec2 nearest = nearest_on(*on_leg_, {hold_at_.x, hold_at_.y});
  return {nearest.x, nearest.y, hold_at_.z};
}

// The spring pulls the robot after it, no faster than the place moves: it is critically damped, and
// knows nothing of that speed.
bool Pilot<Acceleration>::carry(Vec3 to, double step_m) {
  on_leg_.reset();
  return move_hold(to, step_m);
}

bool Pilot<Acceleration>::move_hold(Vec3 to, double step_m) {
  const Vec3 left = to - hold_at_;
  const double left_m = norm(left);
  hold_at_ = left_m <= step_m ? to : hold_at_ + (step_m / left_m) * left;
  return left_m <= step_m;
}

Vec2 Pilot<Acceleration>::on_way(const Observation& observation) const {
  const Vec2 p = observation.position.value;
  if (!latched_) return driving_ && on_leg_ ? nearest_on(*on_leg_, p) : p;
  const Vec3 first = sets_out_from();
  return {first.x, first.y};
}

bool Pilot<Acceleration>::sets_out(const Observation& observation, Vec2 at) {
  if (!latched_) {
    if (on_leg_) return false;  // it was stopped
    tracker_.begin(at);
    return true;
  }
  const double step_m = speed_mps_ * static_cast<double>(period_us_) * s_per_us;
  if (!move_hold(sets_out_from(), step_m) || !at_rest(observation)) return false;
  if (norm(hold_at_ - position_of(observation)) > sway_m_) return false;
  tracker_.begin({hold_at_.x, hold_at_.y});
  return true;
}

Acceleration Pilot<Acceleration>::drive(const Observation& observation, Vec2 at, Path& way) {
  const Vec2 v = observation.velocity.value, p = observation.position.value;
  if (!driving_ && !sets_out(observation, at)) return halt(observation);
  if (!tracker_.advance(way, p, end_reach_m_)) {
    on_leg_.reset();
    return halt(observation);
  }
  on_leg_ = {tracker_.from(), way.points[way.index]};
  leg_mps_ = speed_mps_;
  driving_ = true;
  latched_ = false;
  rest_.reset();
  last_velocity_ = velocity_of(observation);
  last_seen_us_ = observation.velocity.stamp_us;
  const LegTracker::Bearing leg = tracker_.bearing(way, p);
  const double limit = steering_limit();
  const double speed =
      approach_speed(leg, speed_mps_, limit - limits_.disturbance_mps2, reaction_s_);
  const Vec2 left{-leg.direction.y, leg.direction.x};
  Vec2 wanted = speed * leg.direction + (-lateral_gain_per_s_ * leg.lateral_m) * left;
  if (const double size = norm(wanted); size > speed_mps_) wanted = (speed_mps_ / size) * wanted;
  const Vec2 pull = (1 / settling_s_) * (wanted - v);
  return limited({pull.x, pull.y, 0}, limit);
}

bool Pilot<Acceleration>::recedes(const Observation&, Vec2 at, Vec2 target, Vec2 from) const {
  if (!safe::recedes(at, target, from)) return false;
  if (!latched_) return true;
  const Vec3 first = sets_out_from();
  return norm(first - hold_at_) <= sway_m_ ||
         safe::recedes({hold_at_.x, hold_at_.y}, {first.x, first.y}, from);
}

}  // namespace rtac::safe
