// Rule 4, verdicts "now": true means exactly true and false means exactly false, for every true
// state that explains the measurement; and a margin beyond the declared errors is decided.
#include <gtest/gtest.h>

#include "tests/kernel/plants.h"

namespace rtac::kernel_test {
namespace {

// Signed clearance of a centre.
double clearance(const probe_zone& z, Real p) {
  double gap = 1e12;
  bool in = false;
  for (std::int32_t i = 0; i < z.count; ++i) {
    const Real a = real(begin_of(z.edges[i])), b = real(end_of(z.edges[i]));
    gap = std::min(gap, distance(p, a, b));
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y)) in = !in;
  }
  return in ? gap : -gap;
}

// A robot somewhere, seen some time ago while it moved on under any control.
struct Scene {
  probe_robot robot;
  Real now;
  double moved_most;  // mm since the sample
};
Scene scene(Random& random, probe_robot robot, Real at) {
  PointPlant plant{at,
                   {},
                   static_cast<double>(robot.motion.accel_mmps2),
                   1'000,
                   static_cast<double>(robot.motion.speed_mmps)};
  plant.v = random.real(0, 1) * plant.cap * heading(random.real(-3.2, 3.2));
  const std::int64_t age_us =
      2'000 *
      random.in(0, std::min(robot.body.position_age_us, robot.body.velocity_age_us) / 2'000);
  robot.position =
      measured(plant.p + noise(random, static_cast<double>(robot.body.position_error_mm)), -age_us);
  robot.velocity = measured(
      plant.v + noise(random, static_cast<double>(robot.body.velocity_error_mmps)), -age_us);
  const double most =
      (norm(plant.v) + 2.0 * static_cast<double>(robot.body.velocity_error_mmps) + 3) * 1e-6 *
          static_cast<double>(age_us) +
      0.5 * plant.accel * 1e-12 * static_cast<double>(age_us * age_us) + 3;
  Whim whim(random);
  if (random.one_in(2)) whim.settle(1, std::atan2(plant.v.y, plant.v.x));
  for (std::int64_t us = 0; us < age_us; us += 2'000)
    plant.free(whim, 1e-6 * static_cast<double>(us));
  return {robot, plant.p, most};
}

TEST(Clearance, ContainsTheTruthAndIsNoWiderThanItsErrors) {
  Random random(51);
  probe_zone z{};
  probe_floor(&z);
  int positive = 0, negative = 0;
  for (int i = 0; i < 40'000; ++i) {
    const Real at = {random.real(-500, 20'500), random.real(-500, 10'500)};
    const Scene s = scene(random, probe_drone(), at);
    const probe_span span = probe_clearance(&z, &s.robot, 0);
    const double truth = clearance(z, s.now) - static_cast<double>(s.robot.body.radius_mm);
    ASSERT_LE(static_cast<double>(span.lo), truth + 0.01);
    ASSERT_GE(static_cast<double>(span.hi), truth - 0.01);
    const double error = static_cast<double>(s.robot.body.position_error_mm) + s.moved_most;
    ASSERT_LE(static_cast<double>(span.hi - span.lo), 2 * error + 12);
    positive += span.lo > 0;
    negative += span.hi < 0;
  }
  EXPECT_GT(positive, 10'000);
  EXPECT_GT(negative, 1'000);
}

TEST(Distance, ContainsTheTruthAndIsNoWiderThanItsErrors) {
  Random random(52);
  for (int i = 0; i < 40'000; ++i) {
    const Scene a = scene(random, probe_drone(), {});
    const Scene b =
        scene(random, probe_drone(), random.real(0, 3'000) * heading(random.real(-3, 3)));
    const probe_span span = probe_distance(&a.robot, &b.robot, 0);
    const double truth = norm(a.now - b.now) - 2.0 * static_cast<double>(a.robot.body.radius_mm);
    ASSERT_LE(static_cast<double>(span.lo), truth + 0.01);
    ASSERT_GE(static_cast<double>(span.hi), truth - 0.01);
    const double error =
        2.0 * static_cast<double>(a.robot.body.position_error_mm) + a.moved_most + b.moved_most;
    ASSERT_LE(static_cast<double>(span.hi - span.lo), 2 * error + 16);
  }
}

TEST(Charge, ContainsTheTruthOfADischargingBattery) {
  // What charges may have more than the upper end; see the comment in the library.
  Random random(53);
  for (int i = 0; i < 40'000; ++i) {
    const double then = random.real(0, 1e6);
    const std::int64_t age_us = random.in(0, 5'000'000), drain = random.in(0, 10'000);
    const double seen = then + random.real(-5'000, 5'000);
    const probe_scalar battery = {static_cast<std::int64_t>(std::floor(seen)),
                                  static_cast<std::int64_t>(std::ceil(seen)), -age_us, 1};
    const probe_span span = probe_charge(&battery, 0, 5'000'000, 5'000, drain);
    const double now = then - random.real(0, 1) * 1e-6 * static_cast<double>(age_us * drain);
    ASSERT_LE(static_cast<double>(span.lo), now);
    ASSERT_GE(static_cast<double>(span.hi), now);
  }
}

TEST(Comparison, IsDecidedByBothEndsStrictOrNot) {
  // true iff lo >= 0 (strict: > 0), false iff hi < 0 (strict: <= 0), else unknown.
  for (std::int64_t lo = -3; lo <= 3; ++lo) {
    for (std::int64_t hi = lo; hi <= 3; ++hi) {
      const probe_span x = {lo, hi, 0}, zero = {0, 0, 0};
      const probe_span loose = probe_at_least(x, zero, 0), strict = probe_at_least(x, zero, 1);
      EXPECT_EQ(loose.lo >= 0, lo >= 0);
      EXPECT_EQ(loose.hi < 0, hi < 0);
      EXPECT_EQ(strict.lo >= 0, lo > 0);
      EXPECT_EQ(strict.hi < 0, hi <= 0);
    }
  }
}

TEST(Connectives, FollowKleene) {
  // False dominates unknown in "and", true dominates it in "or".
  const probe_span truth = {5, 9, 0}, falsity = {-9, -5, 0};
  const probe_span unknown = {-1'000'000'000'000'000'000, 1'000'000'000'000'000'000, 1};
  EXPECT_LT(probe_both(falsity, unknown).hi, 0);
  EXPECT_LT(probe_both(unknown, falsity).hi, 0);
  EXPECT_LT(probe_both(truth, unknown).lo, 0);
  EXPECT_GE(probe_both(truth, unknown).hi, 0);
  EXPECT_GE(probe_one(truth, unknown).lo, 0);
  EXPECT_LT(probe_one(falsity, unknown).lo, 0);
  EXPECT_GE(probe_one(falsity, unknown).hi, 0);
}

// Rule 2: historically[0, n], and n ticks have passed since the start; an unknown tick makes the
// result unknown unless a false one decides.
TEST(HeldFor, AgreesWithItsDefinitionInThreeValues) {
  Random random(54);
  for (int run = 0; run < 2'000; ++run) {
    const auto n = static_cast<std::int32_t>(random.in(0, 6));
    std::int32_t runs[2] = {0, 0};
    std::vector<int> seen;  // -1, 0, 1
    for (int tick = 0; tick < 40; ++tick) {
      const int value = random.one_in(9) ? -1 : (random.one_in(9) ? 0 : 1);
      seen.push_back(value);
      int expected = tick < n ? -1 : 1;
      for (int j = 0; j <= n && j <= tick; ++j) {
        expected = std::min(expected, seen[static_cast<std::size_t>(tick - j)]);
      }
      const probe_span operand = {value > 0 ? 7 : -7, value < 0 ? -3 : 7, 0};
      const probe_span m = probe_held_for(operand, runs, n, 1);
      ASSERT_EQ(m.lo >= 0 ? 1 : (m.hi < 0 ? -1 : 0), expected);
    }
  }
}

}  // namespace
}  // namespace rtac::kernel_test
