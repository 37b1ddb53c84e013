// The claim of an external recovery: what is checked, and that it is braked where that fails.
#include "rtac/safe/claim.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/runtime/core/test_plants.h"
#include "tests/runtime/core/test_zone.h"

namespace rtac::safe {
namespace {

using test::Plant;
using test::tick;

const test::TestZone& room() {
  static const test::TestZone zone(test::square_rings(5000));
  return zone;
}
Setting setting() {
  Setting s;
  s.limits = test::drone_limits(), s.period_us = 50'000;
  return s;
}
// The numbers that the compiler derives for such a drone, 100 ms ahead.
Claim claim() {
  return {&room().view(), 0.5, 120'000, 1.0, 0.14, 0, 0.07};
}

// Drives straight on, whatever the gate.
class Runaway final : public SafeController<Acceleration> {
 public:
  explicit Runaway(Vec2 push) : push_(push) {}
  void engage(const Observation&) override { ++engaged; }
  Acceleration command(const Observation&, Gate) override {
    ++asked;
    return {push_};
  }
  bool holding() const override { return false; }
  int engaged = 0, asked = 0;

 private:
  Vec2 push_;
};

bool holds(Vec2 p, Vec2 v, TimeUs age_us = 0) {
  Plant<Acceleration> plant(test::drone_limits(), p);
  plant.v = v, plant.noisy = 0, plant.now_us = 1'000'000;
  Observation seen = plant.observe();
  seen.position.stamp_us -= age_us, seen.velocity.stamp_us -= age_us;
  return claim_holds(claim(), test::drone_limits(), 50'000, seen);
}

TEST(Claim, HoldsAsFarAsTheRobotCanBeStopped) {
  EXPECT_TRUE(holds({2.5, 2.5}, {0.4, 0}));
  EXPECT_FALSE(holds({0.1, 2.5}, {0, 0}));
  EXPECT_FALSE(holds({-1, 2.5}, {0, 0}));
  // at rest: 2 cm, 0.01 m in 0.12 s, 0.01 m to stop, 0.02 m late, 7 cm and the body of 8 cm
  EXPECT_FALSE(holds({0.19, 2.5}, {0, 0}));
  EXPECT_TRUE(holds({0.25, 2.5}, {0, 0}));
}

TEST(Claim, IsOfTheSpeedTooAndOfOldSamples) {
  EXPECT_TRUE(holds({2.5, 2.5}, {0.51, 0}));  // within the error of the measurement
  EXPECT_FALSE(holds({2.5, 2.5}, {0.53, 0}));
  EXPECT_TRUE(holds({0.22, 2.5}, {0, 0}));
  EXPECT_FALSE(holds({0.22, 2.5}, {0, 0}, 50'000));
  EXPECT_FALSE(holds({2.5, 2.5}, {0, 0}, 200'000));  // too old to be used at all
}

// A hall of 5 m by 5 m by 3 m, and a drone of space in its middle as far as the plane tells.
TEST(Claim, IsOfHeightsInSpace) {
  const SlabView slab{&room().view(), 0, 3};
  const SolidView hall{"hall", &slab, 1};
  RobotLimits limits = test::drone_limits();
  limits.in_space = true;
  const auto holds_at = [&](double height_m, double climb_mps, const SolidView* solid) {
    Plant<Acceleration> plant(limits, {2.5, 2.5});
    plant.noisy = 0, plant.now_us = 1'000'000;
    Observation seen = plant.observe();
    seen.height_m = height_m, seen.climb_mps = climb_mps;
    Claim above = claim();
    if (solid != nullptr) above.zone = nullptr, above.solid = solid;
    return claim_holds(above, limits, 50'000, seen);
  };
  EXPECT_TRUE(holds_at(1.5, 0, &hall));
  EXPECT_FALSE(holds_at(0.19, 0, &hall));  // as near to the floor as to a wall
  EXPECT_TRUE(holds_at(0.25, 0, &hall));
  EXPECT_FALSE(holds_at(2.81, 0, &hall));
  EXPECT_FALSE(holds_at(4, 0, &hall));
  EXPECT_TRUE(holds_at(40, 0, nullptr));      // over a zone of the plane
  EXPECT_TRUE(holds_at(1.5, 0.51, &hall));    // within the error of the measurement
  EXPECT_FALSE(holds_at(1.5, -0.53, &hall));  // it falls too fast
  EXPECT_FALSE(holds_at(2.6, 0.5, &hall));
  EXPECT_TRUE(holds_at(2.6, 0.5, nullptr));
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(holds_at(unknown, 0, nullptr));
  EXPECT_FALSE(holds_at(unknown, 0, &hall));
  EXPECT_FALSE(holds_at(1.5, unknown, &hall));
}

// Whatever it commands, it is braked before it leaves its claim, and drives on when it is back.
TEST(Claim, ARunawayIsBraked) {
  for (const Vec2 push : {Vec2{-1, 0}, Vec2{0.7, 0.7}}) {
    Plant<Acceleration> plant(test::drone_limits(), {2.5, 2.5});
    Runaway runaway(push);
    Claimed<Acceleration> claimed(setting(), claim());
    claimed.attach(runaway);
    claimed.engage(plant.observe());
    double least = 9, fastest = 0;
    for (int i = 0; i < 2'000; ++i) {
      tick(claimed, plant, Gate::free, 50'000);
      least = std::min(least, signed_clearance(room().view(), plant.p));
      fastest = std::max(fastest, norm(plant.v));
    }
    EXPECT_GE(least, 0.08);
    EXPECT_LT(least, 0.5);                                // it was let that far
    EXPECT_LT(fastest, 0.5 + 0.02 + 0.02 + 0.07 + 0.05);  // two errors, and what one tick adds
    EXPECT_GT(runaway.asked, 10);
  }
}

// The gate binds it, too: it is not even asked.
TEST(Claim, TheGateBindsWhoeverIgnoresIt) {
  Plant<Acceleration> plant(test::drone_limits(), {2.5, 2.5});
  Runaway runaway({1, 0});
  Claimed<Acceleration> claimed(setting(), claim());
  claimed.attach(runaway);
  claimed.engage(plant.observe());
  for (int i = 0; i < 100; ++i) tick(claimed, plant, Gate::hold, 50'000);
  EXPECT_EQ(runaway.asked, 0);
  EXPECT_TRUE(claimed.holding());
  EXPECT_LT(norm(plant.p - Vec2{2.5, 2.5}), 0.05);
}

}  // namespace
}  // namespace rtac::safe
