// Robots and a zone shared by the tests of the simulator.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rtac/sim/world.h"
#include "rtac/zone.h"

namespace rtac::sim::testing {

inline constexpr TimeUs ms = 1000;
inline constexpr TimeUs s = 1'000'000;

inline RobotLimits drone_limits() {
  RobotLimits limits;
  limits.radius_m = 0.08;
  limits.speed_mps = 1.0;
  limits.accel_mps2 = 1.0;
  limits.brake_mps2 = 2.0;
  limits.position_error_m = 0.02;
  limits.velocity_error_mps = 0.02;
  limits.position_age_us = 50 * ms;
  limits.velocity_age_us = 50 * ms;
  limits.latency_us = 20 * ms;
  return limits;
}

inline RobotLimits turtle_limits() {
  RobotLimits limits;
  limits.radius_m = 0.11;
  limits.unicycle = true;
  limits.speed_mps = 0.22;
  limits.accel_mps2 = 0.5;
  limits.brake_mps2 = 1.0;
  limits.turn_radps = 2.84;
  limits.turn_accel_radps2 = 10;
  limits.position_error_m = 0.02;
  limits.velocity_error_mps = 0.01;
  limits.heading_error_rad = 0.035;
  limits.battery_error = 0.005;
  limits.position_age_us = limits.velocity_age_us = limits.heading_age_us = 200 * ms;
  limits.battery_age_us = 5 * s;
  limits.hears_age_us = 200 * ms;
  limits.latency_us = 40 * ms;
  limits.drive_per_m = 0.012;
  limits.idle_per_s = 0.0003;
  limits.drain_per_s = 0.05;
  limits.charge_per_s = 0.01;
  return limits;
}

inline RobotSetup robot_at(const RobotLimits& limits, Vec2 start, double heading_rad = 0) {
  RobotSetup setup;
  setup.limits = limits;
  setup.start = start;
  setup.heading_rad = heading_rad;
  return setup;
}

inline WorldOptions quiet() {  // without noise
  WorldOptions options;
  options.noise = NoiseModel::none;
  return options;
}

// A 4 m x 4 m room with a 1 m x 1 m pillar: one outer ring, one hole.
class Room {
 public:
  Room() {
    add({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    add({{2, 2}, {2, 3}, {3, 3}, {3, 2}});
    view_.name = "room";
    view_.edges_mm = edges_mm_.data();
    view_.edge_count = edges_mm_.size() / 4;
    view_.ring_start = rings_.data();
    view_.ring_count = rings_.size();
  }
  Room(const Room&) = delete;
  Room& operator=(const Room&) = delete;
  [[nodiscard]] const ZoneView& view() const { return view_; }

 private:
  void add(const std::vector<Vec2>& corners) {
    rings_.push_back(edges_mm_.size() / 4);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 a = corners[i];
      const Vec2 b = corners[(i + 1) % corners.size()];
      for (const double value : {a.x, a.y, b.x, b.y}) {
        edges_mm_.push_back(static_cast<std::int32_t>(1000 * value));
      }
    }
  }
  std::vector<std::int32_t> edges_mm_;
  std::vector<std::size_t> rings_;
  ZoneView view_;
};

}  // namespace rtac::sim::testing
