// Agents in the world: as fast, as old and as wrong as declared, and no more; and what counts of
// them.
#include "rtac/sim/crowd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "rtac/sim/math.h"
#include "rtac/sim/referee.h"

namespace rtac::sim {
namespace {

constexpr TimeUs step_us = 1000;

Property gap_of_agent(double least_m) {
  Property gap;
  gap.op = PropertyOp::agent_distance;
  Property least;
  least.op = PropertyOp::constant;
  least.value = least_m;
  Property p;
  p.op = PropertyOp::at_least;
  p.of = {gap, least};
  return p;
}

class Crowds : public ::testing::Test {
 protected:
  Crowds() {
    truths_.resize(2);
    truths_[1].position = {3, 0};
    surroundings_.radius_m = 0.2;
    hostility_.noise = Noise::aimed;
  }
  std::vector<AgentSetup> agents_{{"a", 0.25, 1.5, 0.05, 200'000}, {"b", 0.5, 3, 0, 50'000}};
  std::vector<Property> properties_{gap_of_agent(0.3)};
  Surroundings surroundings_;
  std::vector<TruthState> truths_;
  Hostility hostility_;
  Tape tape_;
};

TEST_F(Crowds, StartWherePropertiesHold) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    properties_ = {gap_of_agent(seed % 2 == 0 ? 0.3 : 500)};
    const Crowd crowd(agents_, properties_, surroundings_, truths_, hostility_, seed, tape_);
    for (int r = 0; r < 2; ++r) {
      const Vec2 at = truths_[static_cast<std::size_t>(r)].position;
      EXPECT_GT(margin_of(properties_[0], {surroundings_, truths_, r, at}), 0);
    }
  }
}

TEST_F(Crowds, AreNoFasterThanDeclaredAndReachTheRobot) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Crowd crowd(agents_, properties_, surroundings_, truths_, hostility_, seed, tape_);
    crowd.move(0);
    std::vector<Vec3> before = *surroundings_.agents;
    double fastest = 0;
    for (TimeUs now = step_us; now < 20'000'000; now += step_us) {
      crowd.move(now);
      const std::vector<Vec3>& after = *surroundings_.agents;
      fastest = std::max(fastest, length(after[0] - before[0]) / 1e-3);
      nearest_m = std::min(nearest_m, length(after[0] - position_of(truths_[0])));
      before = after;
    }
    EXPECT_LE(fastest, 1.5 + 1e-9);
    EXPECT_GT(fastest, 1.4);
  }
  EXPECT_LT(nearest_m, 0.3);
}

TEST_F(Crowds, AreSeenWithinTheirErrorAndAge) {
  for (const Ages ages : {Ages::fresh, Ages::oldest, Ages::wandering}) {
    hostility_.ages = ages;
    Crowd crowd(agents_, properties_, surroundings_, truths_, hostility_, 7, tape_);
    std::vector<Vec3> places;
    TimeUs last_us = never_us, oldest_us = 0;
    for (TimeUs now = 0; now < 2'000'000; now += step_us) {
      crowd.move(now);
      places.push_back((*surroundings_.agents)[0]);
      if (now % 20'000 != 0) continue;
      const Sample<Vec3> seen = crowd.see(0, 0, now);
      ASSERT_LE(seen.stamp_us, now);
      ASSERT_GE(seen.stamp_us, std::max<TimeUs>(0, now - 200'000));
      ASSERT_GE(seen.stamp_us, last_us);
      last_us = seen.stamp_us;
      oldest_us = std::max(oldest_us, now - seen.stamp_us);
      const Vec3 was = places[static_cast<std::size_t>(seen.stamp_us / step_us)];
      ASSERT_LE(length(seen.value - was), 0.05);
    }
    EXPECT_EQ(oldest_us == 0, ages == Ages::fresh);
  }
}

// One in space goes up and down as well, no faster, and is seen within its error to all sides; the
// other one stays at its height.
TEST_F(Crowds, InSpaceComeFromAboveToo) {
  agents_[0].in_space = true;
  hostility_.ages = Ages::fresh;
  truths_[0].height_m = 40;
  truths_[1].height_m = -40;
  double highest_m = 0, fastest = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Crowd crowd(agents_, properties_, surroundings_, truths_, hostility_, seed, tape_);
    crowd.move(0);
    std::vector<Vec3> before = *surroundings_.agents;
    for (TimeUs now = step_us; now < 4'000'000; now += step_us) {
      crowd.move(now);
      const std::vector<Vec3>& after = *surroundings_.agents;
      fastest = std::max(fastest, length(after[0] - before[0]) / 1e-3);
      highest_m = std::max(highest_m, std::abs(after[0].z));
      ASSERT_EQ(after[1].z, 0);
      before = after;
    }
    const Sample<Vec3> seen = crowd.see(0, 0, 4'000'000);
    EXPECT_LE(length(seen.value - (*surroundings_.agents)[0]), 0.05);
    EXPECT_NE(seen.value.z, (*surroundings_.agents)[0].z);
    EXPECT_EQ(crowd.see(0, 1, 4'000'000).value.z, 0);
  }
  EXPECT_LE(fastest, 1.5 + 1e-9);
  EXPECT_GT(fastest, 1.4);
  EXPECT_GT(highest_m, 20);
}

// Only a robot that is told to stand, and does, is not to blame.
TEST_F(Crowds, CountWhileTheRobotMoves) {
  std::vector<Vec3> places{{0.5, 0, 0}};
  surroundings_.agents = &places;
  surroundings_.agent_radius_m = {0.25};
  surroundings_.agent_in_space = {false};
  surroundings_.rest_mps = 0.1;
  std::vector<bool> told(2, false);
  surroundings_.told_to_stand = &told;
  const auto blamed = [&](bool stop, double speed_mps) {
    told[0] = stop;
    truths_[0].velocity = {speed_mps, 0};
    Referee referee(surroundings_, properties_, 1);
    referee.observe(0, truths_);
    return referee.violated();
  };
  EXPECT_FALSE(blamed(true, 0));
  EXPECT_FALSE(blamed(true, 0.1));
  EXPECT_TRUE(blamed(true, 0.11));
  EXPECT_TRUE(blamed(false, 0));
}

}  // namespace
}  // namespace rtac::sim
