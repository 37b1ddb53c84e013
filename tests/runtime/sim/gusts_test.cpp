// What is declared to push a robot does push it, at its bound and no more, and only where declared.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/runtime/sim/scene.h"

namespace rtac::sim::testing {
namespace {

struct Drift {
  double fastest_mps = 0, most_gained_mps2 = 0, moved_m = 0;
};
Drift drift(double disturbance_mps2, std::uint64_t seed, bool lasting = false) {
  RobotLimits limits = drone_limits();
  limits.disturbance_mps2 = disturbance_mps2;
  WorldOptions options;
  options.seed = seed;
  options.lasting_gusts = lasting;
  World<Acceleration> world({robot_at(limits, {0, 0})}, options);
  Drift found;
  Vec2 before{};
  TimeUs before_us = 0;
  world.on_step([&](TimeUs now_us) {
    const TruthState& truth = world.truth(0);
    const double dt_s = 1e-6 * static_cast<double>(now_us - before_us);
    found.fastest_mps = std::max(found.fastest_mps, norm(truth.velocity));
    if (dt_s > 0) {
      found.most_gained_mps2 =
          std::max(found.most_gained_mps2, norm(truth.velocity - before) / dt_s);
    }
    before = truth.velocity;
    before_us = now_us;
  });
  EXPECT_TRUE(world.wait_until(20 * s));
  found.moved_m = norm(world.truth(0).position);
  return found;
}

TEST(Gusts, PushARobotThatDeclaresThem) {
  for (std::uint64_t seed = 1; seed < 9; ++seed) {
    const Drift found = drift(0.3, seed);
    EXPECT_GT(found.moved_m, 0.1) << seed;
    EXPECT_LE(found.most_gained_mps2, 0.3 + 1e-9) << seed;
    EXPECT_GT(found.most_gained_mps2, 0.29) << seed;
    EXPECT_LE(found.fastest_mps, drone_limits().speed_mps + 1e-9) << seed;
  }
}

// Straight on for all of the time: d t² / 2, until the speed is at its limit.
TEST(Gusts, LastForTheWholeRunWhereTheyAreAskedTo) {
  const double speed_mps = drone_limits().speed_mps, push_mps2 = 0.3, time_s = 20;
  const double faster_s = speed_mps / push_mps2;
  ASSERT_LT(faster_s, time_s);
  const double far_m = speed_mps * faster_s / 2 + speed_mps * (time_s - faster_s);
  EXPECT_NEAR(drift(push_mps2, 3, true).moved_m, far_m, 0.01 * far_m);
  EXPECT_LT(drift(push_mps2, 3).moved_m, 0.9 * far_m);
}

// The same way, as long as that is where they are aimed.
TEST(Gusts, BlowToWhereTheyAreAimed) {
  RobotLimits limits = drone_limits();
  limits.disturbance_mps2 = 0.3;
  Vec3 aim{0, -1, 0};
  WorldOptions options;
  options.wind = [&](int) { return aim; };
  World<Acceleration> world({robot_at(limits, {0, 0})}, options);
  EXPECT_TRUE(world.wait_until(2 * s));
  EXPECT_NEAR(world.truth(0).velocity.y, -0.6, 1e-9);
  EXPECT_EQ(world.truth(0).velocity.x, 0);
  aim = {0, 1, 0};
  EXPECT_TRUE(world.wait_until(4 * s));
  EXPECT_NEAR(world.truth(0).velocity.y, 0, 0.3 * 0.02 + 1e-9);  // turned within 20 ms
}

TEST(Gusts, LeaveEverybodyElseAlone) {
  EXPECT_EQ(drift(0, 1).moved_m, 0);
}

}  // namespace
}  // namespace rtac::sim::testing
