#include "motion.h"

#include <algorithm>
#include <cmath>

#include "rtac/sim/math.h"

namespace rtac::sim {
namespace {

Eigen::Vector3d limited(const Eigen::Vector3d& v, double bound) {
  const double squared = v.squaredNorm();
  if (squared <= bound * bound) return v;
  return v * (bound / std::sqrt(squared));
}

// One stretch of constant acceleration; returns the metres driven.
double accelerate(Body& body, const Eigen::Vector3d& u, double speed_max, double dt_s) {
  const Eigen::Vector3d next = limited(body.velocity + dt_s * u, speed_max);
  const Eigen::Vector3d moved = 0.5 * dt_s * (body.velocity + next);
  body.position += moved;
  body.velocity = next;
  return moved.norm();
}

// Moves `value` towards `target` by at most `rate` * `left_s`, adds the integral to `area` and
// takes the time needed from `left_s`.
void slew(double& value, double target, double rate, double& left_s, double& area) {
  const double gap = target - value;
  if (gap == 0) return;
  const double reach = rate * left_s;
  if (std::abs(gap) < reach) {
    const double used_s = std::abs(gap) / rate;
    area += 0.5 * (value + target) * used_s;
    value = target;
    left_s -= used_s;
    return;
  }
  const double next = value + (gap > 0 ? reach : -reach);
  area += 0.5 * (value + next) * left_s;
  value = next;
  left_s = 0;
}

// Signed metres along the heading while the speed approaches its set-point.
double advance_speed(double& speed, double target, const RobotLimits& limits, double dt_s) {
  double left_s = dt_s;
  double distance = 0;
  const bool reverses = speed * target < 0;
  if (reverses || std::abs(target) < std::abs(speed)) {
    slew(speed, reverses ? 0.0 : target, limits.brake_mps2, left_s, distance);
  }
  if (left_s > 0) slew(speed, target, limits.accel_mps2, left_s, distance);
  return distance + speed * left_s;
}

double advance_turn(double& turn, double target, const RobotLimits& limits, double dt_s) {
  if (limits.turn_accel_radps2 <= 0) {
    turn = target;
    return turn * dt_s;
  }
  double left_s = dt_s;
  double angle = 0;
  slew(turn, target, limits.turn_accel_radps2, left_s, angle);
  return angle + turn * left_s;
}

}  // namespace

Acceleration accepted(const Acceleration& command) {
  return is_finite(command.value_mps2) && std::isfinite(command.up_mps2) ? command : Acceleration{};
}

Twist accepted(const Twist& command) {
  const bool finite = std::isfinite(command.speed_mps) && std::isfinite(command.turn_radps);
  return finite ? command : Twist{};
}

double advance(Body& body, const Acceleration& command, const RobotLimits& limits, double dt_s) {
  const double up_mps2 = limits.in_space ? command.up_mps2 : 0;
  const Eigen::Vector3d wanted(command.value_mps2.x, command.value_mps2.y, up_mps2);
  const double accel = limits.accel_mps2;
  const double brake = std::max(accel, limits.brake_mps2);
  double driven = 0;
  double left_s = dt_s;
  const double slowing = wanted.dot(body.velocity);
  if (slowing < 0) {
    // It slows until u . (v + u t) = 0; what remains of the step speeds it up again.
    const Eigen::Vector3d u = limited(wanted, brake);
    const double turning_s = -u.dot(body.velocity) / u.squaredNorm();
    const double braking_s = std::min(left_s, turning_s);
    driven += accelerate(body, u, limits.speed_mps, braking_s);
    left_s -= braking_s;
  }
  if (left_s > 0) driven += accelerate(body, limited(wanted, accel), limits.speed_mps, left_s);
  body.speed_mps = body.velocity.norm();
  return driven;
}

double advance(Body& body, const Twist& command, const RobotLimits& limits, double dt_s) {
  const double speed_max = limits.speed_mps;
  const double turn_max = limits.turn_radps > 0 ? limits.turn_radps : HUGE_VAL;
  const double speed_target = clamp(command.speed_mps, -speed_max, speed_max);
  const double turn_target = clamp(command.turn_radps, -turn_max, turn_max);
  const double moved = advance_speed(body.speed_mps, speed_target, limits, dt_s);
  const double turned = advance_turn(body.turn_radps, turn_target, limits, dt_s);
  const SinCos middle = sin_cos(body.heading_rad + 0.5 * turned);
  body.position += moved * Eigen::Vector3d(middle.cos, middle.sin, 0);
  body.heading_rad = wrap_angle(body.heading_rad + turned);
  const SinCos ahead = turned == 0 ? middle : sin_cos(body.heading_rad);
  body.velocity = body.speed_mps * Eigen::Vector3d(ahead.cos, ahead.sin, 0);
  return std::abs(moved);
}

}  // namespace rtac::sim
