// A limit of speed: an adversary at full effort never breaks it, by the true state, and the verdict
// turns where the bound of the theory says: speed, its error, and what the acceleration adds in T.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "calm_system.h"
#include "rtac/sim/world.h"

namespace {

using rtac::TimeUs;
using rtac::Vec2;

constexpr double limit_mps = 1.5, accel_mps2 = 2, error_mps = 0.05, cap_mps = 3;
// ahead and latency
constexpr TimeUs horizon_us = 120'000;

struct Asked {
  double speed_mps;
  TimeUs position_age_us, velocity_age_us;
};
const rtac::DecisionRecord& step(calm::Drive& decision, const Asked& asked) {
  rtac::Observation seen;
  seen.now_us = 10'000'000;
  seen.robots = 1;
  seen.position = {{30, 30}, seen.now_us - asked.position_age_us};
  seen.velocity = {{0.6 * asked.speed_mps, -0.8 * asked.speed_mps},
                   seen.now_us - asked.velocity_age_us};
  return decision.step(seen, false, false);
}
rtac::MonitorRecord found(const Asked& asked) {
  calm::Drive decision(0);
  return step(decision, asked).monitors[0];
}

TEST(Speed, IsLookedAheadWithItsErrorAgeAndAcceleration) {
  for (const TimeUs position_age_us : {0, 20'000, 100'000}) {
    for (const TimeUs velocity_age_us : {0, 50'000, 100'000}) {
      const double apart_s = 1e-6 * std::abs(double(position_age_us - velocity_age_us));
      const double ahead_s = 1e-6 * double(position_age_us + horizon_us);
      const double gains_mps = error_mps + accel_mps2 * (apart_s + ahead_s);
      const double most_mps = limit_mps - gains_mps;
      EXPECT_EQ(found({most_mps - 0.012, position_age_us, velocity_age_us}).ahead,
                rtac::Verdict::is_true)
          << position_age_us << " " << velocity_age_us;
      EXPECT_NE(found({most_mps + 0.002, position_age_us, velocity_age_us}).ahead,
                rtac::Verdict::is_true)
          << position_age_us << " " << velocity_age_us;
    }
  }
}

// Now it may have gained or lost speed since the sample.
TEST(Speed, IsJudgedNowWithWhatItMayHaveGained) {
  const TimeUs age_us = 60'000;
  const double since_mps = error_mps + accel_mps2 * 1e-6 * double(age_us);
  EXPECT_EQ(found({limit_mps - since_mps - 0.012, age_us, age_us}).now, rtac::Verdict::is_true);
  EXPECT_EQ(found({limit_mps - since_mps + 0.002, age_us, age_us}).now, rtac::Verdict::is_unknown);
  EXPECT_EQ(found({limit_mps + since_mps - 0.002, age_us, age_us}).now, rtac::Verdict::is_unknown);
  EXPECT_EQ(found({limit_mps + since_mps + 0.012, age_us, age_us}).now, rtac::Verdict::is_false);
}

// The margin tells how far the limit is, and no further than the declared speed allows.
TEST(Speed, HasAMarginInMetresPerSecond) {
  const double gains_mps = error_mps + accel_mps2 * 1e-6 * double(horizon_us);
  EXPECT_NEAR(found({0.5, 0, 0}).margin, limit_mps - 0.5 - gains_mps, 0.01);
  EXPECT_NEAR(found({2.9, 0, 0}).margin, limit_mps - cap_mps, 0.01);
}

// Nothing is known of the speed without the velocity, or with one that is too old.
TEST(Speed, IsUnknownWithoutAVelocity) {
  const rtac::MonitorRecord late = found({0.1, 0, 150'000});
  EXPECT_EQ(late.now, rtac::Verdict::is_unknown);
  EXPECT_EQ(late.ahead, rtac::Verdict::is_unknown);
}

class FullEffort final : public rtac::Controller<rtac::Acceleration> {
 public:
  explicit FullEffort(int kind) : kind_(kind) {}
  rtac::Acceleration command(const rtac::Observation& seen) override {
    const Vec2 v = seen.velocity.value;
    if (kind_ == 0 && norm(v) > 0.01) return {(accel_mps2 / norm(v)) * v};
    const double turn = kind_ == 1 ? 1e-6 * double(seen.now_us) : 0.7;
    return {accel_mps2 * Vec2{std::cos(turn), std::sin(turn)}};
  }

 private:
  int kind_;
};
class Straight final : public rtac::Planner {
 public:
  bool plan(const rtac::PlanRequest& request, rtac::Path& plan) override {
    plan.points.clear();
    return plan.points.push(request.goal);
  }
};
class Again final : public rtac::TaskSource {
 public:
  bool next(int, Vec2& destination) override {
    destination = {30, 30};
    return true;
  }
  void completed(int, Vec2, TimeUs) override {}
  void skipped(int, Vec2, TimeUs) override {}
};

TEST(Speed, IsNeverExceededByAnAdversary) {
  for (int kind = 0; kind < 3; ++kind) {
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
      rtac::sim::RobotSetup setup;
      setup.limits = calm::Rover_limits();
      setup.start = {30, 30};
      rtac::sim::WorldOptions options;
      options.seed = seed;
      options.noise = rtac::sim::NoiseModel::extreme;
      rtac::sim::World<rtac::Acceleration> world({setup}, options);
      double fastest_mps = 0;
      world.on_step(
          [&](TimeUs) { fastest_mps = std::max(fastest_mps, norm(world.truth(0).velocity)); });
      FullEffort pilot(kind);
      Straight planner;
      Again tasks;
      auto system =
          std::make_unique<calm::System>(calm::System::Controllers{{pilot, planner}, tasks});
      EXPECT_EQ(system->run(world, 60'000'000), rtac::Status::ok);
      EXPECT_LE(fastest_mps, limit_mps) << kind << " " << seed;
      // what is given away is the error, twice, and the acceleration over the ages
      EXPECT_GT(fastest_mps, 1.0) << kind << " " << seed;
    }
  }
}

}  // namespace
