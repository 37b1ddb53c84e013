#include <gtest/gtest.h>

#include <cmath>

#include "rtac/sim/math.h"
#include "tests/runtime/sim/scene.h"

namespace rtac::sim::testing {
namespace {

Observation sensed(World<Twist>& world) {
  Observation observation;
  world.robot(0).sense(observation);
  return observation;
}

TEST(Faults, DroppedSamplesGrowOldAndComeBack) {
  World<Twist> world({robot_at(turtle_limits(), {1, 1})}, quiet());
  world.inject({0, Sense::position, FaultKind::drop, 1 * s, 3 * s});
  world.wait_until(3 * s);
  const Observation o = sensed(world);
  EXPECT_LT(o.position.stamp_us, 1 * s);
  EXPECT_GT(o.velocity.stamp_us, 2 * s);  // the others go on
  world.wait_until(4 * s);
  EXPECT_GE(sensed(world).position.stamp_us, 4 * s - 199 * ms);
}

TEST(Faults, NanArrivesAsNanWithAFreshStamp) {
  World<Twist> world({robot_at(turtle_limits(), {1, 1})}, quiet());
  for (const Sense sense : {Sense::position, Sense::velocity, Sense::heading, Sense::battery}) {
    world.inject({0, sense, FaultKind::nan, 0, 100 * s});
  }
  world.wait_until(20 * s);
  const Observation o = sensed(world);
  EXPECT_TRUE(std::isnan(o.position.value.x) && std::isnan(o.velocity.value.y));
  EXPECT_TRUE(std::isnan(o.heading.value) && std::isnan(o.battery.value));
  EXPECT_GE(o.position.stamp_us, 20 * s - 199 * ms);
}

TEST(Faults, FrozenValuesKeepComingWithFreshStamps) {
  // The nasty one: age checks cannot see it.
  World<Twist> world({robot_at(turtle_limits(), {1, 1})}, quiet());
  world.robot(0).actuate({0.2, 0});
  world.inject({0, Sense::position, FaultKind::freeze, 2 * s, 100 * s});
  world.wait_until(2 * s + 199 * ms);
  const double frozen_x = sensed(world).position.value.x;
  world.wait_until(5 * s);
  const Observation o = sensed(world);
  EXPECT_EQ(o.position.value.x, frozen_x);
  EXPECT_GT(o.position.stamp_us, 4 * s);
  EXPECT_GT(world.truth(0).position.x, frozen_x + 0.5);
}

TEST(Faults, JumpsDisplaceByTheirSize) {
  World<Twist> world({robot_at(turtle_limits(), {1, 1})}, quiet());
  world.inject({0, Sense::position, FaultKind::jump, 1 * s, 2 * s, 0.5});
  world.inject({0, Sense::battery, FaultKind::jump, 0, 100 * s, -0.25});
  world.wait_until(2 * s);
  EXPECT_NEAR(length(sensed(world).position.value - Vec2{1, 1}), 0.5, 1e-9);
  world.wait_until(3 * s);
  EXPECT_EQ(sensed(world).position.value.x, 1);
  world.wait_until(10 * s);
  EXPECT_NEAR(sensed(world).battery.value, world.truth(0).battery - 0.25, 0.01);
}

TEST(Faults, OfUnknownRobotsAreIgnored) {
  World<Twist> world({robot_at(turtle_limits(), {1, 1})}, quiet());
  world.inject({-1, Sense::position, FaultKind::nan, 0, 100 * s});
  world.inject({1, Sense::position, FaultKind::nan, 0, 100 * s});
  world.wait_until(1 * s);
  EXPECT_EQ(sensed(world).position.value.x, 1);
}

}  // namespace
}  // namespace rtac::sim::testing
