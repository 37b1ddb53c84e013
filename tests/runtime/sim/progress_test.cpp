#include "rtac/sim/progress.h"

#include <gtest/gtest.h>

#include "tests/runtime/sim/scene.h"

namespace rtac::sim::testing {
namespace {

std::vector<TruthState> one_at(double x, bool charging = false) {
  std::vector<TruthState> truths(1);
  truths[0].position = {x, 0};
  truths[0].charging = charging;
  return truths;
}

TEST(Progress, TenCentimetresNearerCountsAndLessDoesNot) {
  ProgressMeter meter(1);
  meter.set_goal(0, {2, 0});
  meter.observe(0, one_at(0));
  meter.observe(10 * s, one_at(0.09));
  EXPECT_EQ(meter.longest_us(0), 10 * s);
  meter.observe(12 * s, one_at(0.11));
  EXPECT_EQ(meter.longest_us(0), 12 * s);
  meter.observe(15 * s, one_at(0.11));
  EXPECT_EQ(meter.longest_us(0), 12 * s);  // 3 s since the last step
  EXPECT_EQ(meter.longest_from_us(0), 0);
}

TEST(Progress, GoingBackAndForthIsNone) {
  // Only distances smaller than ever before count.
  ProgressMeter meter(1);
  meter.set_goal(0, {2, 0});
  meter.observe(0, one_at(0));
  meter.observe(1 * s, one_at(0.5));
  for (int i = 0; i < 20; ++i) meter.observe((2 + i) * s, one_at(i % 2 == 0 ? 0.1 : 0.5));
  EXPECT_EQ(meter.longest_us(0), 20 * s);
  EXPECT_EQ(meter.longest_from_us(0), 1 * s);
}

TEST(Progress, ANewGoalIsNoProgressByItself) {
  ProgressMeter meter(1);
  for (int i = 0; i < 30; ++i) {
    meter.set_goal(0, {i % 2 == 0 ? 5.0 : 1.0, 0});
    meter.observe(i * s, one_at(0));
  }
  EXPECT_EQ(meter.longest_us(0), 29 * s);
}

TEST(Progress, DeliveriesAndChargingCount) {
  ProgressMeter meter(1);
  meter.set_goal(0, {1, 0});
  meter.delivered(0, 5 * s);
  for (int i = 6; i < 100; ++i) meter.observe(i * s, one_at(0, true));
  EXPECT_EQ(meter.deliveries(0), 1);
  EXPECT_EQ(meter.longest_us(0), 5 * s);
}

TEST(Progress, NothingLeftToDoIsNotHeldAgainstIt) {
  ProgressMeter meter(1);
  meter.finished(0, 3 * s);
  meter.observe(1000 * s, one_at(0));
  EXPECT_EQ(meter.longest_us(0), 3 * s);
  meter.set_goal(0, {1, 0});
  meter.observe(1001 * s, one_at(0));
  meter.observe(1010 * s, one_at(0));
  EXPECT_EQ(meter.longest_us(0), 10 * s);
}

TEST(Progress, UsesTheGivenDistance) {
  // Around a box, the straight line may grow while the way gets shorter.
  ProgressMeter meter(1);
  meter.measure_by([](int, Vec2 from, Vec2) { return 10 + from.x; });
  meter.set_goal(0, {9, 0});
  meter.observe(0, one_at(3));
  meter.observe(4 * s, one_at(2));
  meter.observe(5 * s, one_at(2));
  EXPECT_EQ(meter.longest_us(0), 4 * s);
}

}  // namespace
}  // namespace rtac::sim::testing
