// Who stands in for the safe controller of an application attacks, and is no faster than that one
// is claimed to be: more than that nobody has to survive.
#include "unverified.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <vector>

#include "rtac/sim/math.h"

namespace rtac::simulate {
namespace {

constexpr TimeUs period_us = 50'000, latency_us = 80'000, step_us = 5'000;
constexpr double step_s = 5e-3, claimed_mps = 0.4;

// A square of 8 m, and a property that says to stay in it.
class UnverifiedRecovery : public ::testing::Test {
 protected:
  UnverifiedRecovery() {
    zone_.edges_mm = square_.data();
    zone_.edge_count = 4;
    around_.zones.push_back(zone_);
    around_.radius_m = 0.1;
    properties_.resize(1);
    properties_[0].op = sim::PropertyOp::inside;
    limits_.speed_mps = limits_.brake_mps2 = 1;
    limits_.accel_mps2 = 2;
  }
  // The greatest speed of a minute, and how near it comes to the boundary; it is pushed all the
  // time where it moves to.
  struct Ran {
    double fastest_mps = 0, nearest_m = 4;
  };
  Ran run(std::uint64_t seed) {
    sim::Arena arena(around_, properties_, limits_, 1);
    arena.watch(truths_);
    Unverified<Acceleration> attack(arena, 0, sim::Aim::anything, claimed_mps,
                                    period_us + latency_us, seed);
    std::deque<std::pair<TimeUs, Acceleration>> coming;
    Acceleration acts{};
    Ran ran;
    sim::TruthState& truth = truths_[0];
    truth = {};
    truth.position = {4, 4};
    for (TimeUs now_us = 0; now_us < 60'000'000; now_us += step_us) {
      Observation seen;
      seen.now_us = now_us;
      if (now_us % period_us == 0) coming.push_back({now_us + latency_us, attack.command(seen)});
      while (!coming.empty() && coming.front().first <= now_us) {
        acts = coming.front().second;
        coming.pop_front();
      }
      const double speed = norm(truth.velocity);
      const Vec2 push = speed > 0 ? (limits_.disturbance_mps2 / speed) * truth.velocity : Vec2{};
      truth.velocity = truth.velocity + step_s * (acts.value_mps2 + push);
      truth.position = truth.position + step_s * truth.velocity;
      keep_inside(truth);
      ran.fastest_mps = std::max(ran.fastest_mps, norm(truth.velocity));
      ran.nearest_m = std::min(ran.nearest_m, 4 - std::max(std::abs(truth.position.x - 4),
                                                           std::abs(truth.position.y - 4)));
    }
    return ran;
  }
  // Set back to the middle, as it drives.
  static void keep_inside(sim::TruthState& truth) {
    if (std::abs(truth.position.x - 4) > 3.9 || std::abs(truth.position.y - 4) > 3.9) {
      truth.position = {4, 4};
    }
  }

  std::vector<std::int32_t> square_ = {0,    0,    8000, 0,    8000, 0,    8000, 8000,
                                       8000, 8000, 0,    8000, 0,    8000, 0,    0};
  ZoneView zone_;
  sim::Surroundings around_;
  std::vector<sim::Property> properties_;
  RobotLimits limits_;
  std::vector<sim::TruthState> truths_ = std::vector<sim::TruthState>(1);
};

TEST_F(UnverifiedRecovery, GoesForTheBoundaryAtTheSpeedThatIsClaimed) {
  const Ran ran = run(1);
  EXPECT_LT(ran.nearest_m, 0.2);
  EXPECT_GT(ran.fastest_mps, 0.95 * claimed_mps);
}

TEST_F(UnverifiedRecovery, IsNeverFasterThanClaimed) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_LE(run(seed).fastest_mps, claimed_mps * (1 + 1e-9)) << seed;
  }
  limits_.disturbance_mps2 = 0.3;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_LE(run(seed).fastest_mps, claimed_mps * (1 + 1e-9)) << seed;
  }
}

}  // namespace
}  // namespace rtac::simulate
