// What is declared to push a robot does push it, at its bound and no more, and only where declared.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/runtime/sim/scene.h"

namespace rtac::sim::testing {
namespace {

struct Drift {
  double fastest_mps = 0, most_gained_mps2 = 0, moved_m = 0;
};
Drift drift(double disturbance_mps2, std::uint64_t seed) {
  RobotLimits limits = drone_limits();
  limits.disturbance_mps2 = disturbance_mps2;
  WorldOptions options;
  options.seed = seed;
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

TEST(Gusts, LeaveEverybodyElseAlone) {
  EXPECT_EQ(drift(0, 1).moved_m, 0);
}

}  // namespace
}  // namespace rtac::sim::testing
