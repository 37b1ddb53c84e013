// Two small plants with noise, latency and limits, to drive a safe controller in a closed loop.
#pragma once

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

#include "rtac/controller.h"
#include "rtac/types.h"

namespace rtac::test {

inline RobotLimits drone_limits() {
  RobotLimits l;
  l.radius_m = 0.08, l.speed_mps = 1, l.accel_mps2 = 1, l.brake_mps2 = 1;
  l.position_error_m = 0.02, l.velocity_error_mps = 0.02;
  l.position_age_us = l.velocity_age_us = 50'000, l.latency_us = 20'000;
  return l;
}
inline RobotLimits cart_limits() {
  RobotLimits l;
  l.radius_m = 0.11, l.unicycle = true, l.speed_mps = 0.22, l.accel_mps2 = 1, l.brake_mps2 = 1;
  l.turn_radps = 2.84, l.turn_accel_radps2 = 10;
  l.position_error_m = 0.02, l.velocity_error_mps = 0.01, l.heading_error_rad = 0.035;
  l.position_age_us = l.velocity_age_us = l.heading_age_us = l.hears_age_us = 200'000;
  l.latency_us = 40'000;
  return l;
}

class Noise {
 public:
  double scalar(double bound) { return std::uniform_real_distribution<>(-bound, bound)(engine_); }
  Vec2 disc(double bound) {  // uniform angle, radius up to the bound
    const double angle = scalar(3.14159265358979), radius = std::fabs(scalar(bound));
    return {radius * std::cos(angle), radius * std::sin(angle)};
  }

  void seed(unsigned value) { engine_.seed(value); }

 private:
  std::mt19937_64 engine_{7};
};

constexpr TimeUs step_us = 1000;

// Commands act after the latency; samples are of the instant they are asked for.
template <class Output>
class Plant {
 public:
  Plant(const RobotLimits& robot, Vec2 start) : limits(robot), p(start) { seen.robots = 1; }

  const Observation& observe() {
    seen.now_us = now_us;
    seen.position = {p + noise.disc(noisy * limits.position_error_m), now_us};
    seen.velocity = {v + velocity_bias + noise.disc(noisy * limits.velocity_error_mps), now_us};
    seen.heading = {heading + noise.scalar(noisy * limits.heading_error_rad), now_us};
    return seen;
  }
  void apply(const Output& out, TimeUs duration_us) {
    waiting.push_back({now_us + limits.latency_us, out});
    for (const TimeUs end_us = now_us + duration_us; now_us < end_us; now_us += step_us) {
      while (!waiting.empty() && waiting.front().first <= now_us) {
        acting = waiting.front().second;
        waiting.pop_front();
      }
      move(1e-6 * static_cast<double>(step_us));
    }
  }

  RobotLimits limits;
  TimeUs now_us = 0;
  Vec2 p, v;
  double heading = 0, speed = 0, turn = 0;
  double noisy = 1;
  Vec2 velocity_bias;  // an error need not have a mean of zero
  Vec2 push_mps2;      // of a point mass
  Observation seen;
  Noise noise;

 private:
  void move(double dt);
  Output acting{};
  std::deque<std::pair<TimeUs, Output>> waiting;
};

template <>
inline void Plant<Acceleration>::move(double dt) {
  v = v + dt * (acting.value_mps2 + push_mps2);
  if (norm(v) > limits.speed_mps) v = (limits.speed_mps / norm(v)) * v;
  p = p + dt * v;
}

template <>
inline void Plant<Twist>::move(double dt) {
  const auto slew = [&](double& value, double target, double rate) {
    value += std::clamp(target - value, -rate * dt, rate * dt);
  };
  slew(speed, acting.speed_mps, limits.accel_mps2);
  slew(turn, acting.turn_radps, limits.turn_accel_radps2);
  heading += dt * turn;
  v = {speed * std::cos(heading), speed * std::sin(heading)};
  p = p + dt * v;
}

// What a pilot commands that looks from where it is measured.
template <class Pilot, class Output>
Output driven(Pilot& pilot, Plant<Output>& plant, Path& way) {
  const Observation& seen = plant.observe();
  return pilot.drive(seen, seen.position.value, way);
}

// One decision period of a safe controller on its plant.
template <class Output>
void tick(SafeController<Output>& controller, Plant<Output>& plant, Gate gate, TimeUs period_us) {
  plant.apply(controller.command(plant.observe(), gate), period_us);
}

}  // namespace rtac::test
