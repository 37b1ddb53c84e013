#include <gtest/gtest.h>

#include <cmath>

#include "rtac/sim/math.h"
#include "tests/runtime/sim/scene.h"

namespace rtac::sim::testing {
namespace {

std::vector<RobotSetup> pair_of_robots(TimeUs hears_age_us = 200 * ms) {
  RobotLimits limits = turtle_limits();
  limits.hears_age_us = hears_age_us;
  return {robot_at(limits, {1, 1}), robot_at(limits, {2, 2})};
}

Observation heard_by(World<Twist>& world, int robot) {
  Observation observation;
  observation.self = robot;
  world.robot(robot).sense(observation);
  return observation;
}

TEST(Announcements, ArriveAfterHalfTheirAgeBoundLessAMillisecond) {
  World<Twist> world(pair_of_robots(), quiet());
  world.wait_until(10 * ms);
  Announcement announcement;
  announcement.lease_end_us = 77;
  (void)announcement.plan.points.push({3, 3});
  world.robot(0).announce(announcement);
  world.wait_until(10 * ms + 99 * ms - 1);
  EXPECT_EQ(heard_by(world, 1).others[0].position.stamp_us, never_us);
  world.wait_until(10 * ms + 99 * ms);
  const Announcement heard = heard_by(world, 1).others[0];
  EXPECT_EQ(heard.position.stamp_us, 10 * ms);
  EXPECT_EQ(heard.velocity.stamp_us, 10 * ms);
  EXPECT_EQ(heard.position.value.x, 1);
  EXPECT_EQ(heard.lease_end_us, 77);
  EXPECT_EQ(heard.plan.points.size(), 1u);
  EXPECT_EQ(heard_by(world, 0).others[0].position.stamp_us, never_us);  // never its own
}

TEST(Announcements, SentEveryHalfAgeAreNeverHeardTooOld) {
  World<Twist> world(pair_of_robots(), quiet());
  TimeUs oldest = 0;
  world.on_step([&](TimeUs now_us) {
    if (now_us < 200 * ms) return;
    oldest = std::max(oldest, now_us - heard_by(world, 1).others[0].position.stamp_us);
  });
  for (TimeUs t = 0; t < 5 * s; t += 100 * ms) {
    world.wait_until(t);
    world.robot(0).announce({});
  }
  EXPECT_LE(oldest, 199 * ms);
  EXPECT_GE(oldest, 198 * ms);
}

TEST(Announcements, CarryAMeasurementWithinTheDeclaredError) {
  WorldOptions options;
  options.noise = NoiseModel::extreme;
  World<Twist> world(pair_of_robots(0), options);  // heard at once
  world.robot(0).announce({});
  const Observation o = heard_by(world, 1);
  EXPECT_EQ(o.others[0].position.stamp_us, 0);
  EXPECT_NEAR(length(o.others[0].position.value - Vec2{1, 1}), 0.02, 1e-12);
}

TEST(Announcements, ManyUnderWayArriveInOrderAndTooManyAreCounted) {
  World<Twist> world(pair_of_robots(), quiet());
  for (TimeUs t = 1; t <= 300; ++t) {
    world.wait_until(t * 100);
    Announcement announcement;
    announcement.lease_end_us = t;
    world.robot(0).announce(announcement);
  }
  EXPECT_EQ(world.lost(), 300 - 128);
  world.wait_until(99 * ms + 5000);
  EXPECT_EQ(heard_by(world, 1).others[0].lease_end_us, 50);
  world.wait_until(1 * s);
  EXPECT_EQ(heard_by(world, 1).others[0].lease_end_us, 128);
}

TEST(Announcements, FaultsAreHeardByTheFaultyRobotOnly) {
  std::vector<RobotSetup> robots = pair_of_robots(0);
  robots.push_back(robot_at(robots[0].limits, {3, 3}));
  World<Twist> world(robots, quiet());
  world.inject({1, Sense::announcements, FaultKind::drop, 10 * ms, 20 * ms});
  world.inject({1, Sense::announcements, FaultKind::nan, 20 * ms, 30 * ms});
  world.inject({1, Sense::announcements, FaultKind::jump, 30 * ms, 40 * ms, 0.7});
  world.robot(0).announce({});
  EXPECT_EQ(heard_by(world, 1).others[0].position.stamp_us, 0);
  world.wait_until(10 * ms);
  world.robot(0).announce({});
  EXPECT_EQ(heard_by(world, 1).others[0].position.stamp_us, 0);
  EXPECT_EQ(heard_by(world, 2).others[0].position.stamp_us, 10 * ms);
  world.wait_until(20 * ms);
  world.robot(0).announce({});
  EXPECT_TRUE(std::isnan(heard_by(world, 1).others[0].position.value.x));
  world.wait_until(30 * ms);
  world.robot(0).announce({});
  const Announcement displaced = heard_by(world, 1).others[0];
  EXPECT_NEAR(length(displaced.position.value - Vec2{1, 1}), 0.7, 1e-9);
  EXPECT_EQ(displaced.velocity.value.x, 0);  // a jump moves the position only
}

}  // namespace
}  // namespace rtac::sim::testing
