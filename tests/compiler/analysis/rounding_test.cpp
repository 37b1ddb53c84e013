// Every integer that is derived lies on the safe side of the exact number: demands up, supplies
// down. The exact side is computed here, with rationals, from the formulas of the theory.
#include <random>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/reach.h"
#include "compiler/sema/spec.h"
#include "compiler/support/rational.h"
#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

Rational exact(std::int64_t value) {
  return Rational(static_cast<long>(value));
}

// Values off the grid, so that every rounding has something to round.
sema::RobotKind kind_of(sema::MotionModel model) {
  sema::RobotKind k;
  k.name = "Odd";
  k.radius = {Rational(1, 7), {}};
  k.motion.model = model;
  k.motion.speed = {Rational(2, 3), {}};
  k.motion.accel = {Rational(7, 9), {}};
  k.motion.brake = {Rational(8, 9), {}};
  if (model == sema::MotionModel::unicycle) {
    k.motion.turn = sema::Quantity{Rational(22, 7), {}};
    k.motion.turn_accel = sema::Quantity{Rational(31, 3), {}};
  }
  k.position = sema::Sense{{Rational(1, 61), {}}, {Rational(1, 13), {}}};
  k.velocity = sema::Sense{{Rational(1, 71), {}}, {Rational(1, 17), {}}};
  k.battery = sema::Sense{{Rational(1, 300), {}}, {Rational(11, 3), {}}};
  k.hears_max_age = sema::Quantity{Rational(1, 19), {}};
  k.plan = sema::PlanInput{8, {Rational(1, 12), {}}, {}};
  k.latency = {Rational(1, 43), {}};
  k.energy = sema::Energy{};
  k.energy->drive = {Rational(1, 333), {}};
  k.energy->idle = {Rational(1, 7777), {}};
  k.energy->drain = {Rational(1, 777), {}};
  return k;
}

// The radius is taken off both ends of a distance: by what it was rounded up, the upper end would
// be too low, if places were not as much less certain.
TEST(Rounding, TheUpperEndOfADistanceIsNeverTooLow) {
  for (const long tenths : {1000, 1001, 1005, 1009}) {
    sema::RobotKind k = kind_of(sema::MotionModel::point);
    k.radius = {Rational(tenths, 10'000), {}};
    k.position->error.value = Rational(1, 100);
    const ir::Body b = body_of(k, 50'000);
    EXPECT_GE(exact(b.position_error_mm - b.radius_mm),
              1000 * Rational(k.position->error.value - k.radius.value))
        << tenths;
  }
}

TEST(Rounding, DemandsAreRoundedUpAndSuppliesDown) {
  const sema::RobotKind k = kind_of(sema::MotionModel::point);
  const ir::Body b = body_of(k, 50'000);
  const auto up = [](std::int64_t integer, const Rational& si, int per_unit) {
    EXPECT_GE(exact(integer), si * per_unit);
    EXPECT_LT(exact(integer - 1), si * per_unit);
  };
  up(b.radius_mm, k.radius.value, 1000);
  up(b.position_error_mm, k.position->error.value, 1000);
  up(b.velocity_error_mmps, k.velocity->error.value, 1000);
  // a point mass slows down as hard as it brakes, in any direction
  up(b.accel_mmps2, std::max(k.motion.accel.value, k.motion.brake.value), 1000);
  up(b.position_age_us, k.position->max_age.value, 1'000'000);
  up(b.velocity_age_us, k.velocity->max_age.value, 1'000'000);
  up(b.battery_age_us, k.battery->max_age.value, 1'000'000);
  up(b.hears_age_us, k.hears_max_age->value, 1'000'000);
  up(b.latency_us, k.latency.value, 1'000'000);
  up(b.tracking_mm, k.plan->tracking.value, 1000);
  up(b.battery_error_ppm, k.battery->error.value, 1'000'000);
  up(b.drain_ppm_per_s, k.energy->drain.value, 1'000'000);
  EXPECT_LE(exact(b.brake_mmps2), k.motion.brake.value * 1000);
  EXPECT_GT(exact(b.brake_mmps2 + 1), k.motion.brake.value * 1000);
  up(any_control(k).speed_mmps, k.motion.speed.value, 1000);
  const sema::RobotKind wheels = kind_of(sema::MotionModel::unicycle);
  up(recovery_motion(wheels, body_of(wheels, 50'000), "slow", Rational(1, 9), 50'000).speed_mmps,
     Rational(1, 9), 1000);
}

// It drives at what it measures, and holds while errors of its place move the hold.
TEST(Rounding, ARecoveryOfAPointMassIsAsMuchFasterAsItsVelocityErrs) {
  const sema::RobotKind k = kind_of(sema::MotionModel::point);
  const ir::Body b = body_of(k, 50'000);
  const Rational v = k.motion.speed.value, w = Rational(1, 9);
  const std::int64_t mmps = recovery_motion(k, b, "slow", w, 50'000).speed_mmps;
  EXPECT_GE(exact(mmps), std::min(v, Rational(w + k.velocity->error.value)) * 1000);
  EXPECT_LE(mmps, any_control(k).speed_mmps);
}

// theory, unicycle: A_eff = sqrt(A^2 + (V W)^2); between two stamps it may slow down as hard as its
// brake
TEST(Rounding, TheAccelerationOfAUnicycleContainsItsTurning) {
  const sema::RobotKind k = kind_of(sema::MotionModel::unicycle);
  const Rational a = k.motion.accel.value * 1000;
  const Rational lateral = k.motion.speed.value * k.motion.turn->value * 1000;
  const Rational least_squared = a * a + lateral * lateral;
  for (const std::int64_t derived :
       {any_control(k).accel_mmps2,
        // a recovery may still turn at the speed that it found
        recovery_motion(k, body_of(k, 50'000), "slow", Rational(1, 100), 50'000).accel_mmps2}) {
    EXPECT_GE(exact(derived) * exact(derived), least_squared);
    EXPECT_LT(exact(derived - 4) * exact(derived - 4), least_squared);
  }
}

// Lemma sampled_brake: rho_sc = eta s / b + eta^2 / b + rho_h with eta = e_v + b (h + l); who is
// fast, is pushed by nothing, and accelerates no more than it brakes, has half of the first and 2.2
// of the second.
TEST(Rounding, TheTubeOfASampledBrakeIsNotTooNarrow) {
  sema::RobotKind k = kind_of(sema::MotionModel::point);
  const Rational brake = k.motion.brake.value * 1000;
  const Rational delay = Rational(50, 1000) + k.latency.value + k.velocity->max_age.value;
  const Rational eta = k.velocity->error.value * 1000 + brake * delay;
  const Rational holds = 2 * k.position->error.value * 1000;
  const auto is_at_least = [&](const Rational& aside, const Rational& hold) {
    const ir::Body b = body_of(k, 50'000);
    EXPECT_GE(exact(b.brake_late_ms), 1000 * eta / brake);
    EXPECT_GE(exact(b.brake_lag_ms), 1000 * aside);
    EXPECT_LT(exact(b.brake_lag_ms), 1000 * aside + 3);
    EXPECT_GE(exact(b.hold_mm), hold + holds);
  };
  is_at_least(eta / (2 * brake), Rational(11, 5) * eta * eta / brake);
  k.motion.accel = {Rational(9, 9), {}};
  is_at_least(eta / brake, eta * eta / brake);
  k.motion.accel = {Rational(7, 9), {}};
  k.motion.speed = {Rational(23, 10'000) * eta, {}};
  is_at_least(eta / brake, eta * eta / brake);
}

// theory, disturbance: A + d, b - d, eta = e_v + (b + d) (h + l)
TEST(Rounding, WhatPushesAPointMassCountsEverywhere) {
  sema::RobotKind k = kind_of(sema::MotionModel::point);
  const ir::Body calm = body_of(k, 50'000);
  k.motion.disturbance = sema::Quantity{Rational(1, 9), {}};
  const ir::Body b = body_of(k, 50'000);
  const Rational d = Rational(1000, 9), brake = exact(b.brake_mmps2), left = brake - d;
  EXPECT_EQ(calm.disturbance_mmps2, 0);
  EXPECT_EQ(ir::sway_permille(calm), 0);
  EXPECT_GE(exact(b.disturbance_mmps2), d);
  EXPECT_GE(exact(b.accel_mmps2), (Rational(8, 9) + Rational(1, 9)) * 1000);
  EXPECT_EQ(any_control(k).accel_mmps2, b.accel_mmps2);
  EXPECT_GE(exact(ir::sway_permille(b)), 1000 * d / left);
  const Rational delay = Rational(50, 1000) + k.latency.value + k.velocity->max_age.value;
  const Rational eta = k.velocity->error.value * 1000 + (brake + d) * delay;
  EXPECT_GE(exact(b.brake_late_ms), 1000 * eta / left);
  EXPECT_EQ(b.brake_lag_ms, b.brake_late_ms);
  EXPECT_GE(exact(b.hold_mm), eta * eta / left + 2 * k.position->error.value * 1000);
  EXPECT_GT(recovery_motion(k, b, "slow", Rational(1, 9), 50'000).speed_mmps, 112);
}

// theory, horizon: the jitter is part of it, and of the lag of the sampled brake
TEST(Rounding, JitterIsPartOfTheHorizonAndOfTheBrake) {
  const sema::RobotKind k = kind_of(sema::MotionModel::point);
  const ir::Body exact_ticks = body_of(k, 50'000), late = body_of(k, 50'000, 7'000);
  EXPECT_EQ(horizon_us_max(late, 100'000), horizon_us_max(exact_ticks, 100'000) + 7'000);
  EXPECT_GT(late.brake_late_ms, exact_ticks.brake_late_ms);
}

// theory, disc: e_p + S + s1^2 / (2 b) + r_eff, exactly.
Rational exact_disc(const ir::Body& b, const ir::Motion& m, std::int64_t measured,
                    std::int64_t t_us) {
  const Rational t = exact(t_us) / 1'000'000;
  const Rational v_error = exact(b.velocity_error_mmps);
  const Rational cap = m.recovery ? exact(std::max(m.speed_mmps, measured + b.velocity_error_mmps))
                                  : exact(m.speed_mmps);
  const Rational a = exact(m.accel_mmps2), brake = exact(b.brake_mmps2);
  const Rational s0 = std::min(cap, Rational(exact(measured) + v_error));
  const bool capped = s0 + a * t > cap;
  const Rational s1 = capped ? cap : Rational(s0 + a * t);
  const Rational way = capped ? Rational(cap * t - (cap - s0) * (cap - s0) / (2 * a))
                              : Rational(s0 * t + a * t * t / 2);
  const Rational stop = s1 * s1 / (2 * brake);
  const Rational tube = exact(b.radius_mm) + s1 * exact(b.brake_lag_ms) / 1000 +
                        stop * exact(b.brake_lag_permille) / 1000 + exact(b.hold_mm) +
                        stop * exact(b.disturbance_mmps2) / (brake - exact(b.disturbance_mmps2));
  return exact(b.position_error_mm) + way + stop + tube;
}

TEST(Rounding, TheDiscIsNeverSmallerThanTheExactOneAndLittleLarger) {
  std::mt19937 random(7);
  const auto within = [&](std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(random()) % (high - low + 1);
  };
  for (int i = 0; i < 5000; ++i) {
    ir::Body b;
    b.radius_mm = within(1, 500);
    b.position_error_mm = within(0, 100);
    b.velocity_error_mmps = within(0, 100);
    b.brake_mmps2 = within(200, 5000);
    b.disturbance_mmps2 = within(0, 1) * within(0, b.brake_mmps2 / 2);
    b.brake_lag_ms = within(0, 300);
    b.brake_lag_permille = within(0, 2000);
    b.hold_mm = within(0, 100);
    const ir::Motion m{"any", within(50, 5000), within(100, 5000), within(0, 1) == 1, {}};
    const std::int64_t measured = within(0, 5500);
    const std::int64_t t_us = within(1, 2'000'000);
    const Rational least = exact_disc(b, m, measured, t_us);
    const Rational derived = exact(disc_mm(b, m, measured, t_us));
    ASSERT_GE(derived, least) << "round " << i;
    // a whole millisecond and 2 mm/s more, at the speeds above
    ASSERT_LT(derived, least + 60 + least / 20) << "round " << i;
  }
}

TEST(Rounding, TheHorizonContainsAgeLookaheadAndLatency) {
  ir::Body b;
  b.position_age_us = 50'001;
  b.latency_us = 20'003;
  EXPECT_EQ(horizon_us_max(b, 100'007), 170'011);
}

}  // namespace
}  // namespace rtac::analysis::test
