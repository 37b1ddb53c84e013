#include "rtac/sim/judge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rtac/sim/adversary.h"
#include "rtac/sim/math.h"
#include "tests/runtime/sim/scene.h"

namespace rtac::sim::testing {
namespace {

std::vector<TruthState> at(std::initializer_list<Vec2> places) {
  std::vector<TruthState> truths;
  for (const Vec2 place : places) {
    truths.emplace_back();
    truths.back().position = place;
  }
  return truths;
}

TEST(Judge, FindsTheSmallestClearanceWithTimeAndPlace) {
  const Room room;
  SafetyJudge judge({0.1}, {});
  judge.watch_zone(room.view());
  judge.observe(1, at({{1, 1}}));
  judge.observe(2, at({{1.7, 2.5}}));  // 0.3 m from the pillar
  judge.observe(3, at({{1, 1}}));
  EXPECT_NEAR(judge.clearance(0).smallest, 0.2, 1e-12);
  EXPECT_EQ(judge.clearance(0).time_us, 2);
  EXPECT_EQ(judge.clearance(0).place.x, 1.7);
  EXPECT_FALSE(judge.violated());
}

TEST(Judge, ABodyThatOverlapsTheBoundaryViolates) {
  // The centre is still inside: the body counts.
  const Room room;
  SafetyJudge judge({0.1}, {});
  judge.watch_zone(room.view());
  judge.observe(5, at({{0.09, 1}}));
  EXPECT_NEAR(judge.clearance(0).smallest, -0.01, 1e-12);
  EXPECT_EQ(judge.clearance(0).first_violation_us, 5);
}

TEST(Judge, InsideAHoleIsOutsideTheZone) {
  const Room room;
  SafetyJudge judge({0.1}, {});
  judge.watch_zone(room.view());
  judge.observe(1, at({{2.5, 2.5}}));
  EXPECT_NEAR(judge.clearance(0).smallest, -0.6, 1e-12);
}

TEST(Judge, TouchingTheThresholdIsNotYetAViolation) {
  const Room room;
  Requirements requirements;
  requirements.clearance_m = 0.25;
  SafetyJudge judge({0.25}, requirements);
  judge.watch_zone(room.view());
  judge.observe(1, at({{0.5, 1}}));  // clearance exactly 0.25 m, exact in binary
  EXPECT_FALSE(judge.clearance(0).violated());
  judge.observe(2, at({{0.4999, 1}}));
  EXPECT_EQ(judge.clearance(0).first_violation_us, 2);
}

TEST(Judge, CountsSeparateEpisodes) {
  const Room room;
  SafetyJudge judge({0.1}, {});
  judge.watch_zone(room.view());
  TimeUs t = 0;
  for (const double x : {1.0, 0.05, 0.04, 1.0, 0.05, 1.0}) judge.observe(++t, at({{x, 1}}));
  EXPECT_EQ(judge.clearance(0).episodes, 2);
  EXPECT_EQ(judge.clearance(0).first_violation_us, 2);
}

TEST(Judge, GapsAreBetweenBodiesAndSymmetric) {
  Requirements requirements;
  requirements.gap_m = 0.08;
  SafetyJudge judge({0.11, 0.11, 0.11}, requirements);
  judge.observe(1, at({{0, 0}, {1, 0}, {0, 2}}));
  judge.observe(2, at({{0, 0}, {0.3, 0.4}, {0, 2}}));
  judge.observe(3, at({{0, 0}, {0.29, 0}, {0, 2}}));
  EXPECT_NEAR(judge.gap(1, 0).smallest, 0.07, 1e-12);
  EXPECT_EQ(judge.gap(0, 1).first_violation_us, 3);
  EXPECT_FALSE(judge.gap(0, 2).violated());
  EXPECT_NEAR(judge.gap(0, 2).smallest, 1.78, 1e-12);
}

TEST(Judge, AsksForTheBatteryMarginOfEveryRobot) {
  SafetyJudge judge({0.1, 0.1}, {});
  judge.watch_battery(
      [](int robot, const TruthState& truth) { return truth.battery - (robot == 0 ? 0.2 : 0.6); });
  std::vector<TruthState> truths = at({{0, 0}, {1, 0}});
  truths[0].battery = truths[1].battery = 0.5;
  judge.observe(7, truths);
  EXPECT_NEAR(judge.battery(0).smallest, 0.3, 1e-12);
  EXPECT_EQ(judge.battery(1).first_violation_us, 7);
  EXPECT_EQ(judge.first_violation_us(), 7);
}

TEST(Judge, AValueThatIsNotANumberViolates) {
  SafetyJudge judge({0.1}, {});
  judge.watch_battery([](int, const TruthState&) { return NAN; });
  judge.observe(1, at({{0, 0}}));
  EXPECT_TRUE(judge.violated());
}

TEST(Judge, SkippedStepsNeverHideAMinimum) {
  // The judge leaves out steps that cannot matter; the result must be the one of looking at all.
  const Room room;
  World<Acceleration> world({robot_at(drone_limits(), {1, 1})}, WorldOptions{});
  BangBang<Acceleration> wild(drone_limits(), 21);
  SafetyJudge judge({0.08}, {});
  judge.watch_zone(room.view());
  double smallest = HUGE_VAL;
  TimeUs first = never_us;
  world.on_step([&](TimeUs now_us) {
    judge.observe(now_us, world.truths());
    const double value = signed_clearance(room.view(), world.truth(0).position) - 0.08;
    smallest = std::min(smallest, value);
    if (value < 0 && first == never_us) first = now_us;
  });
  Observation observation;
  for (TimeUs t = 0; t < 30 * s; t += 50 * ms) {
    world.wait_until(t);
    world.robot(0).sense(observation);
    world.robot(0).actuate(wild.command(observation));
  }
  ASSERT_NE(first, never_us);
  EXPECT_EQ(judge.clearance(0).smallest, smallest);
  EXPECT_EQ(judge.clearance(0).first_violation_us, first);
}

}  // namespace
}  // namespace rtac::sim::testing
