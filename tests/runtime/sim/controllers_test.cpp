#include "rtac/sim/controllers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "rtac/sim/adversary.h"
#include "rtac/sim/math.h"
#include "tests/runtime/sim/scene.h"

namespace rtac::sim::testing {
namespace {

// Drives robot 0 for a time; the way-point index moves on within `reach_m`.
template <class Output>
void drive(World<Output>& world, Controller<Output>& controller, Observation& observation,
           TimeUs until_us, TimeUs period_us, double reach_m) {
  for (TimeUs t = world.now_us(); t < until_us; t += period_us) {
    world.robot(0).sense(observation);
    Path& plan = observation.plan;
    if (!plan.finished() &&
        length(plan.points[plan.index] - observation.position.value) < reach_m) {
      ++plan.index;
    }
    world.robot(0).actuate(controller.command(observation));
    world.wait_until(t + period_us);
  }
}

TEST(FollowPlan, UnicycleReachesEveryWayPoint) {
  World<Twist> world({robot_at(turtle_limits(), {0, 0}, pi)}, WorldOptions{});
  FollowPlan<Twist> follow(turtle_limits());
  Observation observation;
  for (const Vec2 point : {Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}}) {
    ASSERT_TRUE(observation.plan.points.push(point));
  }
  drive<Twist>(world, follow, observation, 60 * s, 100 * ms, 0.08);
  EXPECT_TRUE(observation.plan.finished());
  EXPECT_LT(length(world.truth(0).position - Vec2{0, 1}), 0.15);
  EXPECT_EQ(world.truth(0).speed_mps, 0);
}

TEST(FollowPlan, PointMassStopsAtTheEndWithoutOvershooting) {
  World<Acceleration> world({robot_at(drone_limits(), {0, 0})}, WorldOptions{});
  FollowPlan<Acceleration> follow(drone_limits());
  Observation observation;
  ASSERT_TRUE(observation.plan.points.push({3, 0}));
  double furthest = 0;
  double fastest = 0;
  world.on_step([&](TimeUs) {
    furthest = std::max(furthest, world.truth(0).position.x);
    fastest = std::max(fastest, world.truth(0).velocity.x);
  });
  drive<Acceleration>(world, follow, observation, 20 * s, 50 * ms, 0.05);
  EXPECT_TRUE(observation.plan.finished());
  EXPECT_LT(furthest, 3.1);
  EXPECT_GT(fastest, 0.8);
  EXPECT_LT(length(world.truth(0).position - Vec2{3, 0}), 0.12);
}

TEST(FollowPlan, PointMassHoldsItsPlaceWithoutCreeping) {
  // theory: a velocity-only hold creeps 0.38 m in 60 s.
  World<Acceleration> world({robot_at(drone_limits(), {1, 1})}, WorldOptions{});
  FollowPlan<Acceleration> follow(drone_limits());
  Observation observation;
  drive<Acceleration>(world, follow, observation, 60 * s, 50 * ms, 0.05);
  EXPECT_LT(length(world.truth(0).position - Vec2{1, 1}), 0.05);
}

TEST(FollowPlan, StandsStillWithoutPlanOrMeasurement) {
  FollowPlan<Twist> follow(turtle_limits());
  Observation observation;
  EXPECT_EQ(follow.command(observation).speed_mps, 0);
  ASSERT_TRUE(observation.plan.points.push({3, 0}));
  EXPECT_EQ(follow.command(observation).speed_mps, 0);  // nothing measured yet
  observation.position = {{NAN, 0}, 0};
  observation.heading = {0, 0};
  EXPECT_EQ(follow.command(observation).speed_mps, 0);
  observation.position = {{0, 0}, 0};
  EXPECT_GT(follow.command(observation).speed_mps, 0.2);
}

TEST(PushAtNearest, DrivesADroneThroughTheWall) {
  const Room room;
  World<Acceleration> world({robot_at(drone_limits(), {0.7, 1})}, WorldOptions{});
  PushAtNearest<Acceleration> push(drone_limits(), &room.view());
  Observation observation;
  drive<Acceleration>(world, push, observation, 4 * s, 50 * ms, 0);
  EXPECT_LT(world.truth(0).position.x, -0.5);  // and goes on outwards
}

TEST(PushAtNearest, PrefersTheNearerRobotAndMayDriveBackwards) {
  const Room room;
  PushAtNearest<Twist> push(turtle_limits(), &room.view());
  Observation observation;
  observation.robots = 2;
  observation.position = {{1, 1}, 0};
  observation.heading = {0, 0};
  observation.others[1].position = {{0.6, 1}, 0};  // behind it, nearer than any wall
  const Twist command = push.command(observation);
  EXPECT_EQ(command.speed_mps, -0.22);
  EXPECT_NEAR(command.turn_radps, 0, 1e-9);
}

TEST(BangBang, UsesTheFullScaleAndHoldsForItsTimes) {
  BangBang<Twist> wild(turtle_limits(), 3, 100 * ms, 200 * ms);
  Observation observation;
  int changes = 0;
  Twist last = wild.command(observation);
  for (TimeUs t = 0; t < 100 * s; t += 1 * ms) {
    observation.now_us = t;
    const Twist now = wild.command(observation);
    EXPECT_EQ(std::abs(now.speed_mps), 0.22);
    if (now.speed_mps != last.speed_mps || now.turn_radps != last.turn_radps) ++changes;
    last = now;
  }
  // 100 s / 150 ms = 667 draws, of which 5 in 6 change something.
  EXPECT_NEAR(changes, 556, 60);
}

TEST(Replay, PlaysTheNewestCommandThatIsDue) {
  Replay<Twist> replay({{20, {0.2, 0}}, {10, {0.1, 0}}});
  Observation observation;
  observation.now_us = 9;
  EXPECT_EQ(replay.command(observation).speed_mps, 0);
  observation.now_us = 19;
  EXPECT_EQ(replay.command(observation).speed_mps, 0.1);
  observation.now_us = 1000;
  EXPECT_EQ(replay.command(observation).speed_mps, 0.2);
}

std::unique_ptr<Controller<Twist>> constant(double speed_mps) {
  return std::make_unique<Replay<Twist>>(
      std::vector<Replay<Twist>::Entry>{{never_us, {speed_mps, 0}}});
}

TEST(Lapses, AreAsFrequentAndAsLongAsAskedFor) {
  LapseOptions options;
  options.mean_interval_us = 8 * s;
  options.mean_duration_us = 2 * s;
  Lapses<Twist> lapses(constant(0.1), constant(-0.1), options);
  Observation observation;
  int faulty = 0;
  const int ticks = 100'000;
  for (int i = 0; i < ticks; ++i) {
    observation.now_us = 100 * ms * i;
    const bool is_faulty = lapses.command(observation).speed_mps < 0;
    EXPECT_EQ(is_faulty, lapses.lapsing());
    faulty += is_faulty ? 1 : 0;
  }
  EXPECT_NEAR(faulty / static_cast<double>(ticks), 0.2, 0.02);
  EXPECT_NEAR(lapses.lapses(), 1000, 50);
}

TEST(Lapses, DependOnTheSeedNotOnTheCallsMade) {
  LapseOptions options;
  options.mean_interval_us = 3 * s;
  Lapses<Twist> often(constant(0.1), constant(-0.1), options);
  Lapses<Twist> rarely(constant(0.1), constant(-0.1), options);
  Observation observation;
  for (TimeUs t = 0; t < 200 * s; t += 10 * ms) {
    observation.now_us = t;
    (void)often.command(observation);
    if (t % (1700 * ms) != 0) continue;
    (void)rarely.command(observation);
    EXPECT_EQ(often.lapsing(), rarely.lapsing());
  }
  EXPECT_EQ(often.lapses() > 20, true);
}

}  // namespace
}  // namespace rtac::sim::testing
