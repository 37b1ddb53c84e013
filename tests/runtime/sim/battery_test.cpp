#include <gtest/gtest.h>

#include "tests/runtime/sim/scene.h"

namespace rtac::sim::testing {
namespace {

RobotSetup docked_robot(Vec2 start, double battery) {
  RobotSetup setup = robot_at(turtle_limits(), start);
  setup.battery = battery;
  setup.has_dock = true;
  setup.dock = {1, 1};
  return setup;
}

TEST(Battery, FallsWithMetresAndSeconds) {
  World<Twist> world({robot_at(turtle_limits(), {0, 0})}, quiet());
  world.robot(0).actuate({-0.2, 0});  // backwards costs as much
  world.wait_until(100 * s);
  const double metres = -world.truth(0).position.x;
  EXPECT_NEAR(metres, 19.95, 0.05);
  EXPECT_NEAR(world.truth(0).battery, 1 - 0.012 * metres - 0.0003 * 100, 1e-9);
}

// What it takes per metre and what it takes per second at most are two limits (rule 6.7).
TEST(Battery, FallsNoFasterThanItMayDrain) {
  RobotSetup setup = robot_at(turtle_limits(), {0, 0});
  setup.limits.drain_per_s = 0.001;
  World<Twist> world({setup}, quiet());
  world.robot(0).actuate({0.2, 0});  // 0.0024 a second
  world.wait_until(10 * s);
  const double before = world.truth(0).battery;
  world.wait_until(60 * s);
  EXPECT_NEAR(world.truth(0).battery, before - 0.001 * 50, 1e-9);
}

TEST(Battery, StopsAtZero) {
  RobotSetup setup = robot_at(turtle_limits(), {0, 0});
  setup.battery = 0.0001;
  World<Twist> world({setup}, quiet());
  world.wait_until(10 * s);
  EXPECT_EQ(world.truth(0).battery, 0);
}

TEST(Battery, ChargesAtTheDockUpToFull) {
  World<Twist> world({docked_robot({1.1, 1.1}, 0.5)}, quiet());  // 0.141 m away
  world.wait_until(10 * s);
  EXPECT_NEAR(world.truth(0).battery, 0.6, 1e-9);
  EXPECT_TRUE(world.truth(0).charging);
  world.wait_until(60 * s);
  EXPECT_EQ(world.truth(0).battery, 1);
  EXPECT_FALSE(world.truth(0).charging);  // full: waiting here is no progress
}

TEST(Battery, DoesNotChargeBesideTheDockOrWhileMoving) {
  World<Twist> beside({docked_robot({1.1, 1.12}, 0.5)}, quiet());  // 0.156 m away
  beside.wait_until(1 * s);
  EXPECT_LT(beside.truth(0).battery, 0.5);
  World<Twist> moving({docked_robot({0.95, 1.0}, 0.5)}, quiet());
  moving.robot(0).actuate({0.03, 0});
  moving.wait_until(200 * ms);
  const double before = moving.truth(0).battery;
  moving.wait_until(300 * ms);
  EXPECT_FALSE(moving.truth(0).charging);
  EXPECT_LT(moving.truth(0).battery, before);
}

// A hold sways as its senses err: that is how it rests, and the dock feeds it meanwhile (rule 6.7).
TEST(Battery, ChargesWhoSwaysNoFasterThanItsHold) {
  RobotSetup setup = docked_robot({0.95, 1.0}, 0.5);
  setup.dock_speed_mps = 0.03;
  World<Twist> world({setup}, quiet());
  world.robot(0).actuate({0.03, 0});
  world.wait_until(200 * ms);
  const double before = world.truth(0).battery;
  world.wait_until(300 * ms);
  EXPECT_TRUE(world.truth(0).charging);
  EXPECT_NEAR(world.truth(0).battery, before + 0.1 * setup.limits.charge_per_s, 1e-9);
}

}  // namespace
}  // namespace rtac::sim::testing
