#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "rtac/sim/math.h"
#include "tests/runtime/sim/scene.h"

namespace rtac::sim::testing {
namespace {

Observation sensed(World<Twist>& world, int robot = 0) {
  Observation observation;
  observation.self = robot;
  world.robot(robot).sense(observation);
  return observation;
}

TEST(Sensing, AgesReachTheirBoundButNeverExceedIt) {
  // Declared age 200 ms: the oldest sample in use must come up to 199 ms, else tests run in a
  // milder world than the specification allows.
  World<Twist> world({robot_at(turtle_limits(), {1, 1})}, quiet());
  std::array<TimeUs, 3> oldest{};
  world.on_step([&](TimeUs now_us) {
    const Observation o = sensed(world);
    const std::array<TimeUs, 3> ages{now_us - o.position.stamp_us, now_us - o.heading.stamp_us,
                                     now_us - o.battery.stamp_us};
    for (std::size_t i = 0; i < ages.size(); ++i) oldest[i] = std::max(oldest[i], ages[i]);
  });
  world.wait_until(20 * s);
  EXPECT_LE(oldest[0], 199 * ms);
  EXPECT_GE(oldest[0], 198 * ms);
  EXPECT_LE(oldest[1], 199 * ms);
  EXPECT_GE(oldest[1], 198 * ms);
  EXPECT_LE(oldest[2], 4999 * ms);
  EXPECT_GE(oldest[2], 4998 * ms);
}

TEST(Sensing, SensesHaveTheirOwnClocks) {
  // Equal stamps would hide the error of ignoring unequal ones (theory: unequal stamps).
  World<Twist> world({robot_at(turtle_limits(), {1, 1}), robot_at(turtle_limits(), {2, 2})},
                     quiet());
  world.wait_until(1 * s);
  const Observation a = sensed(world, 0);
  const Observation b = sensed(world, 1);
  EXPECT_NE(a.position.stamp_us, a.velocity.stamp_us);
  EXPECT_NE(a.position.stamp_us, a.heading.stamp_us);
  EXPECT_NE(a.position.stamp_us, b.position.stamp_us);
}

TEST(Sensing, StampsAreTheTrueSamplingTimes) {
  // Without noise, the sample is the truth of the very microsecond of its stamp.
  RobotLimits limits = turtle_limits();
  World<Twist> world({robot_at(limits, {1, 1})}, quiet());
  std::map<TimeUs, Vec2> history;
  history[0] = world.truth(0).position;
  world.on_step([&](TimeUs now_us) { history[now_us] = world.truth(0).position; });
  world.robot(0).actuate({0.2, 0.4});
  for (TimeUs t = 0; t < 5 * s; t += 37 * ms) {
    world.wait_until(t);
    const Observation o = sensed(world);
    ASSERT_EQ(history.count(o.position.stamp_us), 1u);
    EXPECT_EQ(o.position.value.x, history[o.position.stamp_us].x);
    EXPECT_EQ(o.position.value.y, history[o.position.stamp_us].y);
  }
}

TEST(Sensing, EverythingIsKnownFromTheStart) {
  World<Twist> world({robot_at(turtle_limits(), {1, 2}, 0.5)}, quiet());
  const Observation o = sensed(world);
  EXPECT_EQ(o.position.stamp_us, 0);
  EXPECT_EQ(o.position.value.y, 2);
  EXPECT_EQ(o.heading.value, 0.5);
  EXPECT_EQ(o.battery.value, 1);
}

TEST(Sensing, WithoutAgeBoundEveryCallMeasures) {
  RobotLimits limits = turtle_limits();
  limits.position_age_us = 0;
  World<Twist> world({robot_at(limits, {1, 1})}, WorldOptions{});
  world.wait_until(123'456);
  const Observation first = sensed(world);
  const Observation second = sensed(world);
  EXPECT_EQ(first.position.stamp_us, 123'456);
  EXPECT_NE(first.position.value.x, second.position.value.x);  // fresh noise
}

struct Errors {
  double position = 0, velocity = 0, heading = 0, battery = 0, least_position = 1;
};

Errors largest_errors(NoiseModel noise) {
  WorldOptions options;
  options.noise = noise;
  RobotSetup setup = robot_at(turtle_limits(), {1, 1}, 3.13);  // near the wrap of the heading
  setup.battery = 0.5;
  setup.limits.idle_per_s = 0;
  setup.limits.battery_age_us = 200 * ms;
  World<Twist> world({setup}, options);
  Errors worst;
  for (TimeUs t = 0; t < 400 * s; t += 100 * ms) {
    world.wait_until(t);
    const Observation o = sensed(world);
    const double position = length(o.position.value - Vec2{1, 1});
    worst.position = std::max(worst.position, position);
    worst.least_position = std::min(worst.least_position, position);
    worst.velocity = std::max(worst.velocity, length(o.velocity.value));
    worst.heading = std::max(worst.heading, std::abs(wrap_angle(o.heading.value - 3.13)));
    worst.battery = std::max(worst.battery, std::abs(o.battery.value - 0.5));
  }
  return worst;
}

TEST(Noise, UniformStaysWithinItsBoundsAndComesNearThem) {
  const Errors worst = largest_errors(NoiseModel::uniform);
  const RobotLimits limits = turtle_limits();
  EXPECT_LE(worst.position, limits.position_error_m * (1 + 1e-9));
  EXPECT_GT(worst.position, 0.98 * limits.position_error_m);
  EXPECT_LE(worst.velocity, limits.velocity_error_mps);
  EXPECT_GT(worst.velocity, 0.98 * limits.velocity_error_mps);
  EXPECT_LE(worst.heading, limits.heading_error_rad * (1 + 1e-9));
  EXPECT_GT(worst.heading, 0.98 * limits.heading_error_rad);
  EXPECT_LE(worst.battery, limits.battery_error * (1 + 1e-9));
  EXPECT_GT(worst.battery, 0.98 * limits.battery_error);
  EXPECT_LT(worst.least_position, 0.2 * limits.position_error_m);
}

TEST(Noise, ExtremeIsAlwaysOnTheBound) {
  const Errors worst = largest_errors(NoiseModel::extreme);
  const RobotLimits limits = turtle_limits();
  EXPECT_NEAR(worst.position, limits.position_error_m, 1e-12);
  EXPECT_NEAR(worst.least_position, limits.position_error_m, 1e-12);
  EXPECT_NEAR(worst.heading, limits.heading_error_rad, 1e-12);
}

TEST(Noise, NoneIsExact) {
  EXPECT_EQ(largest_errors(NoiseModel::none).position, 0);
}

}  // namespace
}  // namespace rtac::sim::testing
