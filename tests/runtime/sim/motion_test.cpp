#include <gtest/gtest.h>

#include <cmath>

#include "rtac/sim/adversary.h"
#include "rtac/sim/math.h"
#include "tests/runtime/sim/scene.h"

namespace rtac::sim::testing {
namespace {

// Runs a bang-bang controller every 10 ms and shows every physics step to `check`.
template <class Output, class Check>
void run_wildly(const RobotLimits& limits, TimeUs until_us, Check check) {
  World<Output> world({robot_at(limits, {0, 0})}, quiet());
  BangBang<Output> wild(limits, 5, 5 * ms, 400 * ms);
  TruthState before = world.truth(0);
  TimeUs before_us = 0;
  world.on_step([&](TimeUs now_us) {
    check(before, world.truth(0), 1e-6 * static_cast<double>(now_us - before_us));
    before = world.truth(0);
    before_us = now_us;
  });
  Observation observation;
  for (TimeUs t = 0; t < until_us; t += 10 * ms) {
    world.robot(0).sense(observation);
    world.robot(0).actuate(wild.command(observation));
    world.wait_until(t + 10 * ms);
  }
}

TEST(PointMass, NeverExceedsItsLimitsUnderBangBang) {
  // The look-ahead is only sound if the simulated drone keeps what the specification declares.
  const RobotLimits limits = drone_limits();
  double fastest = 0;
  double hardest = 0;
  run_wildly<Acceleration>(limits, 60 * s,
                           [&](const TruthState& a, const TruthState& b, double dt) {
                             const double change = length(b.velocity - a.velocity) / dt;
                             const bool slows = dot(b.velocity - a.velocity, a.velocity) < 0;
                             const double bound = slows ? limits.brake_mps2 : limits.accel_mps2;
                             ASSERT_LE(length(b.velocity), limits.speed_mps * (1 + 1e-12));
                             ASSERT_LE(change, bound * (1 + 1e-6));
                             fastest = std::max(fastest, length(b.velocity));
                             hardest = std::max(hardest, change);
                           });
  EXPECT_NEAR(fastest, 1.0, 1e-9);  // and reaches them
  EXPECT_NEAR(hardest, 2.0, 1e-6);
}

TEST(PointMass, StopsWithinItsBrakingDistance) {
  // v^2 / 2b = 0.25 m from 1 m/s at 2 m/s^2, counted from the instant the command acts.
  World<Acceleration> world({robot_at(drone_limits(), {0, 0})}, quiet());
  world.robot(0).actuate({{1, 0}});
  world.wait_until(2 * s);
  world.robot(0).actuate({{-2, 0}});
  world.wait_until(2 * s + 20 * ms);
  ASSERT_NEAR(world.truth(0).velocity.x, 1, 1e-12);
  const double from = world.truth(0).position.x;
  world.wait_until(2 * s + 520 * ms);
  EXPECT_NEAR(world.truth(0).velocity.x, 0, 1e-12);
  EXPECT_NEAR(world.truth(0).position.x - from, 0.25, 1e-9);
}

TEST(PointMass, BrakesHardButSpeedsUpGently) {
  // After the turning point the same command is acceleration, bounded by `accel`.
  World<Acceleration> world({robot_at(drone_limits(), {0, 0})}, quiet());
  world.robot(0).actuate({{1, 0}});
  world.wait_until(1 * s + 20 * ms);  // 1 m/s
  world.robot(0).actuate({{-5, 0}});
  world.wait_until(1 * s + 40 * ms);
  const double speed = world.truth(0).velocity.x;
  world.wait_until(1 * s + 40 * ms + 750 * ms);
  EXPECT_NEAR(speed, 1.0, 1e-12);
  EXPECT_NEAR(world.truth(0).velocity.x, -0.25, 1e-9);  // 0.5 s of braking, 0.25 s at 1 m/s^2
}

TEST(PointMass, FollowsTheExactParabola) {
  World<Acceleration> world({robot_at(drone_limits(), {1, 2})}, quiet());
  world.robot(0).actuate({{0.3, -0.4}});
  world.wait_until(20 * ms + 1500 * ms);
  EXPECT_NEAR(world.truth(0).position.x, 1 + 0.5 * 0.3 * 2.25, 1e-11);
  EXPECT_NEAR(world.truth(0).position.y, 2 - 0.5 * 0.4 * 2.25, 1e-11);
}

TEST(Unicycle, NeverExceedsItsLimitsUnderBangBang) {
  const RobotLimits limits = turtle_limits();
  double fastest = 0;
  double turning = 0;
  run_wildly<Twist>(limits, 60 * s, [&](const TruthState& a, const TruthState& b, double dt) {
    const double change = std::abs(b.speed_mps - a.speed_mps) / dt;
    const bool grows = std::abs(b.speed_mps) > std::abs(a.speed_mps);
    ASSERT_LE(std::abs(b.speed_mps), limits.speed_mps);
    ASSERT_LE(std::abs(b.turn_radps), limits.turn_radps);
    if (a.speed_mps * b.speed_mps >= 0) {
      ASSERT_LE(change, (grows ? limits.accel_mps2 : limits.brake_mps2) * (1 + 1e-9));
    }
    ASSERT_LE(std::abs(b.turn_radps - a.turn_radps) / dt, limits.turn_accel_radps2 * (1 + 1e-9));
    ASSERT_NEAR(length(b.velocity), std::abs(b.speed_mps), 1e-12);
    fastest = std::max(fastest, std::abs(b.speed_mps));
    turning = std::max(turning, std::abs(b.turn_radps));
  });
  EXPECT_EQ(fastest, limits.speed_mps);
  EXPECT_EQ(turning, limits.turn_radps);
}

TEST(Unicycle, StaysWithinThePlanarAccelerationOfTheTheory) {
  // theory: unicycle, A_eff = sqrt(A^2 + (V W)^2) with A the larger of accel and brake.
  const RobotLimits limits = turtle_limits();
  const double bound = std::hypot(limits.brake_mps2, limits.speed_mps * limits.turn_radps);
  run_wildly<Twist>(limits, 60 * s, [&](const TruthState& a, const TruthState& b, double dt) {
    ASSERT_LE(length(b.velocity - a.velocity) / dt, bound * (1 + 1e-9));
  });
}

TEST(Unicycle, ReversalFallsThroughZeroAtBrakeThenGrowsAtAccel) {
  RobotLimits limits = turtle_limits();
  limits.latency_us = 0;
  World<Twist> world({robot_at(limits, {0, 0})}, quiet());
  world.robot(0).actuate({0.2, 0});
  world.wait_until(1 * s);
  world.robot(0).actuate({-0.2, 0});
  world.wait_until(1 * s + 200 * ms);
  EXPECT_NEAR(world.truth(0).speed_mps, 0, 1e-12);  // 0.2 m/s at 1 m/s^2
  world.wait_until(1 * s + 400 * ms);
  EXPECT_NEAR(world.truth(0).speed_mps, -0.1, 1e-12);  // 0.2 s at 0.5 m/s^2
}

TEST(Unicycle, DrivesTheCircleItIsToldTo) {
  RobotLimits limits = turtle_limits();
  limits.latency_us = 0;
  limits.turn_accel_radps2 = 0;  // at once
  limits.accel_mps2 = 1e9;
  World<Twist> world({robot_at(limits, {0, 0})}, quiet());
  world.robot(0).actuate({0.2, 0.5});  // radius 0.4 m about (0, 0.4)
  double worst = 0;
  world.on_step([&](TimeUs) {
    const double radius = length(world.truth(0).position - Vec2{0, 0.4});
    worst = std::max(worst, std::abs(radius - 0.4));
  });
  world.wait_until(20 * s);
  EXPECT_LT(worst, 1e-6);
  EXPECT_NEAR(wrap_angle(world.truth(0).heading_rad - 10.0), 0, 1e-9);
}

TEST(World, NonFiniteCommandsAreZero) {
  World<Twist> world({robot_at(turtle_limits(), {0, 0})}, quiet());
  world.robot(0).actuate({NAN, 1});
  world.robot(0).actuate({0.2, INFINITY});
  world.wait_until(1 * s);
  EXPECT_EQ(world.truth(0).position.x, 0);
  EXPECT_EQ(world.truth(0).heading_rad, 0);
  World<Acceleration> drones({robot_at(drone_limits(), {0, 0})}, quiet());
  drones.robot(0).actuate({{NAN, 1}});
  drones.wait_until(1 * s);
  EXPECT_EQ(drones.truth(0).position.y, 0);
}

TEST(World, CommandsActExactlyAfterTheLatency) {
  // Off the 1 ms grid on purpose: 20.123 ms.
  RobotLimits limits = drone_limits();
  limits.latency_us = 20'123;
  World<Acceleration> world({robot_at(limits, {0, 0})}, quiet());
  world.wait_until(7'777);
  world.robot(0).actuate({{1, 0}});
  world.wait_until(7'777 + 20'123);
  EXPECT_EQ(world.truth(0).velocity.x, 0);
  world.wait_until(7'777 + 20'123 + 100);
  EXPECT_NEAR(world.truth(0).velocity.x, 100e-6, 1e-15);
}

TEST(World, CommandsUnderWayKeepTheirOrderAndDistance) {
  World<Acceleration> world({robot_at(drone_limits(), {0, 0})}, quiet());
  world.robot(0).actuate({{1, 0}});
  world.wait_until(5 * ms);
  world.robot(0).actuate({{0, 1}});
  world.wait_until(40 * ms);
  EXPECT_NEAR(world.truth(0).velocity.x, 0.005, 1e-12);
  EXPECT_NEAR(world.truth(0).velocity.y, 0.015, 1e-12);
}

TEST(World, TheCommandQueueIsBoundedAndSaysSo) {
  World<Acceleration> world({robot_at(drone_limits(), {0, 0})}, quiet());
  for (int i = 0; i < 300; ++i) world.robot(0).actuate({{0, 0}});
  EXPECT_EQ(world.lost(), 300 - 256);
}

TEST(World, TheCommandQueueIsAsLongAsIsAskedFor) {
  WorldOptions options = quiet();
  options.commands_max = 300;
  World<Acceleration> world({robot_at(drone_limits(), {0, 0})}, options);
  for (int i = 0; i <= 300; ++i) world.robot(0).actuate({{0, 0}});
  EXPECT_EQ(world.lost(), 1);
}

TEST(World, StepsAreNeverLongerThanAMillisecond) {
  WorldOptions options;
  options.step_us = 50'000;
  World<Twist> world({robot_at(turtle_limits(), {0, 0})}, options);
  TimeUs before = 0;
  world.on_step([&](TimeUs now_us) {
    EXPECT_GT(now_us, before);
    EXPECT_LE(now_us - before, 1000);
    before = now_us;
  });
  EXPECT_TRUE(world.wait_until(3 * s + 17));
  EXPECT_EQ(before, 3 * s + 17);
}

TEST(World, EndsWhenToldTo) {
  WorldOptions options = quiet();
  options.end_us = 1 * s;
  World<Twist> world({robot_at(turtle_limits(), {0, 0})}, options);
  EXPECT_TRUE(world.wait_until(1 * s));
  EXPECT_FALSE(world.wait_until(2 * s));
  EXPECT_EQ(world.now_us(), 1 * s);
  World<Twist> other({robot_at(turtle_limits(), {0, 0})}, quiet());
  other.on_step([&](TimeUs now_us) {
    if (now_us >= 5 * ms) other.stop();
  });
  EXPECT_FALSE(other.wait_until(1 * s));
  EXPECT_EQ(other.now_us(), 5 * ms);
}

}  // namespace
}  // namespace rtac::sim::testing
