// The price of a way covers what the templates of safe controllers take to drive it.
#include "compiler/analysis/travel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <vector>

#include "compiler/support/rational.h"
#include "rtac/safe/pace.h"
#include "rtac/safe/pilot.h"
#include "tests/runtime/core/test_plants.h"

namespace rtac::analysis::test {
namespace {

constexpr std::int64_t period_us = 100'000;
constexpr std::int32_t cell_mm = 100;

Rational milli(double value) {
  return Rational(std::lround(1000 * value), 1000);
}
sema::Sense sense(double error, TimeUs age_us) {
  return {{milli(error), {}}, {Rational(static_cast<long>(age_us), 1'000'000), {}}};
}
// What a specification would declare of the plants.
sema::RobotKind kind_of(const RobotLimits& l) {
  sema::RobotKind k;
  k.motion.model = l.unicycle ? sema::MotionModel::unicycle : sema::MotionModel::point;
  k.motion.speed = {milli(l.speed_mps), {}};
  k.motion.accel = {milli(l.accel_mps2), {}};
  k.motion.brake = {milli(l.brake_mps2), {}};
  k.motion.disturbance = sema::Quantity{milli(l.disturbance_mps2), {}};
  if (l.unicycle) {
    k.motion.turn = sema::Quantity{milli(l.turn_radps), {}};
    k.motion.turn_accel = sema::Quantity{milli(l.turn_accel_radps2), {}};
    k.heading = sense(l.heading_error_rad, l.heading_age_us);
  }
  k.position = sense(l.position_error_m, l.position_age_us);
  k.velocity = sense(l.velocity_error_mps, l.velocity_age_us);
  k.latency = {Rational(static_cast<long>(l.latency_us), 1'000'000), {}};
  k.energy = sema::Energy{};
  k.energy->drive = {Rational(1, 333), {}};
  k.energy->idle = {Rational(1, 7777), {}};
  return k;
}
// A way with as many legs as the price allows for: one a cell, with a corner at each.
std::vector<Vec2> stairs(int cells) {
  std::vector<Vec2> points;
  Vec2 at;
  for (int i = 0; i < cells; ++i) {
    at = at + (i % 2 == 0 ? Vec2{0.1, 0} : Vec2{0.1, 0.1});
    points.push_back(at);
  }
  return points;
}
// What lasts and takes speed from a robot: a push, and a velocity that is measured wrong.
struct Lasting {
  Vec2 push_mps2, velocity_bias;
};
template <class Output>
double driven_s(const RobotLimits& limits, double speed_mps, const std::vector<Vec2>& points,
                const std::optional<Lasting>& lasting = std::nullopt) {
  safe::Setting setting;
  setting.limits = limits, setting.period_us = period_us, setting.speed_mps = speed_mps;
  rtac::test::Plant<Output> plant(limits, {0, 0});
  plant.heading = 3.1;
  if (lasting) {
    plant.noisy = 0;
    plant.push_mps2 = lasting->push_mps2;
    plant.velocity_bias = lasting->velocity_bias;
  }
  safe::Pilot<Output> pilot(setting);
  pilot.engage(plant.observe());
  Path way;
  for (const Vec2 p : points) (void)way.points.push(p);
  std::deque<Sample<double>> headings;  // the oldest that counts first
  while (!way.finished() && plant.now_us < 600'000'000) {
    Observation seen = plant.observe();
    headings.push_back(seen.heading);
    while (headings.front().stamp_us < plant.now_us - limits.heading_age_us) headings.pop_front();
    seen.heading = headings.front();
    plant.apply(pilot.drive(seen, seen.position.value, way), period_us);
  }
  while (!pilot.latched() && plant.now_us < 600'000'000) {
    plant.apply(pilot.halt(plant.observe()), period_us);
  }
  return 1e-6 * static_cast<double>(plant.now_us);
}
// What remains when accelerating, braking and turning take next to no time themselves.
RobotLimits brisk(RobotLimits limits) {
  limits.speed_mps = 0.9, limits.accel_mps2 = limits.brake_mps2 = 10;
  if (limits.unicycle) limits.turn_radps = 8, limits.turn_accel_radps2 = 100;
  return limits;
}
double length_m(const std::vector<Vec2>& points) {
  double sum_m = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum_m += norm(points[i] - points[i - 1]);
  return sum_m + norm(points[0]);
}
double priced_s(const RobotLimits& limits, double speed_mps, double way_m) {
  return travel_seconds(kind_of(limits), milli(speed_mps), period_us, cell_mm,
                        static_cast<std::int64_t>(std::ceil(1e3 * way_m)))
      .get_d();
}

TEST(Pace, IsTheSameOnBothSides) {
  namespace theirs = rtac::safe::pace;
  EXPECT_EQ(pace::creep_mmps, std::lround(1e3 * theirs::creep_mps));
  EXPECT_EQ(pace::planned_braking_permille, std::lround(1e3 * theirs::planned_braking));
  EXPECT_EQ(pace::velocity_time_ms, std::lround(1e3 * theirs::velocity_time_s));
  EXPECT_EQ(pace::velocity_time_delays, theirs::velocity_time_delays);
  EXPECT_EQ(pace::lateral_gain_milli_per_s, std::lround(1e3 * theirs::lateral_gain_per_s));
  EXPECT_EQ(pace::lateral_mrad_per_delay, std::lround(1e3 * theirs::lateral_rad_per_delay));
  EXPECT_EQ(pace::arrival_margin_permille, std::lround(1e3 * theirs::arrival_margin));
  EXPECT_EQ(pace::hold_max_mradps, 1000 * theirs::hold_max_radps);
  EXPECT_EQ(pace::hold_mrad_per_delay, 1000 * theirs::hold_rad_per_delay);
  EXPECT_EQ(pace::hold_delay_least_us, 1e6 * theirs::hold_delay_least_s);
  EXPECT_EQ(pace::hold_brake_shares, theirs::hold_brake_shares);
  EXPECT_EQ(pace::turn_gain_milli_per_s, std::lround(1e3 * theirs::turn_gain_per_s));
  EXPECT_EQ(pace::turn_max_mradps, std::lround(1e3 * theirs::turn_radps_max));
  EXPECT_EQ(pace::turn_end_mrad, std::lround(1e3 * theirs::turn_end_rad));
  EXPECT_EQ(pace::turn_end_errors_permille, 1000 * theirs::turn_end_errors);
  EXPECT_EQ(pace::turn_begin_mrad, std::lround(1e3 * theirs::turn_begin_rad));
  EXPECT_EQ(pace::turn_begin_errors, theirs::turn_begin_errors);
  EXPECT_EQ(pace::turn_mrad_per_delay, std::lround(1e3 * theirs::turn_rad_per_delay));
  EXPECT_EQ(pace::aim_ahead_mm, std::lround(1e3 * theirs::aim_ahead_m));
  EXPECT_EQ(pace::aim_ahead_turns_permille, std::lround(1e3 * theirs::aim_ahead_turns));
  EXPECT_EQ(pace::aim_ahead_delays, theirs::aim_ahead_delays);
  EXPECT_EQ(pace::rest_samples, theirs::rest_samples);
  EXPECT_EQ(pace::still_mmps, std::lround(1e3 * theirs::still_mps));
  EXPECT_EQ(pace::look_every_ms, theirs::look_every_us / 1000);
  EXPECT_EQ(pace::waypoints, static_cast<int>(max_waypoints));
}

// How much longer than its way a retreat drives, as the runtime does it.
TEST(Pace, RunsOutAsFarOnBothSides) {
  for (RobotLimits limits :
       {rtac::test::drone_limits(), rtac::test::cart_limits(), brisk(rtac::test::drone_limits())}) {
    for (const double speed_mps : {0.05, 0.3, 0.8}) {
      rtac::safe::Setting setting;
      setting.limits = limits, setting.period_us = period_us, setting.speed_mps = speed_mps;
      const double out_mm = 1e3 * rtac::safe::run_out_m(setting);
      const auto priced_mm =
          static_cast<double>(run_out_mm(kind_of(limits), milli(speed_mps), period_us));
      EXPECT_GE(priced_mm, out_mm - 1e-6);
      EXPECT_LE(priced_mm, out_mm + 1) << speed_mps;
    }
  }
}

// Errors and pushes that last: none, small ones, and half of the brake.
std::vector<RobotLimits> exposed() {
  std::vector<RobotLimits> all = {rtac::test::drone_limits(), brisk(rtac::test::drone_limits())};
  for (const double error_mps : {0.0, 0.05, 0.15}) {
    for (const double push_mps2 : {0.0, 0.05, 0.2, 0.5}) {
      RobotLimits l = rtac::test::drone_limits();
      l.velocity_error_mps = error_mps, l.disturbance_mps2 = push_mps2;
      all.push_back(l);
    }
  }
  return all;
}

TEST(Pace, EndsAsNearOnBothSides) {
  std::vector<RobotLimits> all = exposed();
  all.push_back(rtac::test::cart_limits());
  for (const RobotLimits& limits : all) {
    rtac::safe::Setting setting;
    setting.limits = limits, setting.period_us = period_us;
    const double reach_mm = 1e3 * rtac::safe::end_reach_m(setting);
    const auto known_mm = static_cast<double>(end_reach_mm(kind_of(limits), period_us));
    EXPECT_GE(known_mm, reach_mm);
    EXPECT_LE(known_mm, reach_mm + 1.1)
        << limits.velocity_error_mps << " m/s, " << limits.disturbance_mps2 << " m/s^2";
  }
}

// Short and long, slow and fast: the plants are never slower than the price says.
template <class Output>
void expect_priced(const RobotLimits& limits, double speed_mps) {
  for (const int cells : {1, 3, 12}) {
    const std::vector<Vec2> straight{{0.1 * cells, 0}};
    const std::vector<Vec2> back{{0.1 * cells, 0}, {0.1 * cells, 0.1}, {0, 0.1}, {0.05 * cells, 0}};
    for (const std::vector<Vec2>& way : {stairs(cells), straight, back}) {
      const auto legs = static_cast<int>(way.size());
      const double driven = driven_s<Output>(limits, speed_mps, way);
      EXPECT_LE(driven, priced_s(limits, speed_mps, length_m(way)))
          << speed_mps << " m/s, " << cells << " cells, " << legs << " legs";
      EXPECT_LE(driven, few_legs_seconds(kind_of(limits), milli(speed_mps), period_us, legs, 2,
                                         std::lround(std::ceil(1000 * length_m(way))))
                            .get_d())
          << speed_mps << " m/s, " << cells << " cells, " << legs << " legs";
    }
    const auto leg =
        few_legs_seconds(kind_of(limits), milli(speed_mps), period_us, 1, 2, 100 * cells);
    EXPECT_LE(driven_s<Output>(limits, speed_mps, straight), leg.get_d())
        << speed_mps << " m/s, one leg of " << cells << " cells";
  }
}
TEST(Travel, APointMassTakesNoLongerThanPriced) {
  for (const double speed_mps : {0.1, 0.3, 0.8}) {
    expect_priced<Acceleration>(rtac::test::drone_limits(), speed_mps);
    expect_priced<Acceleration>(brisk(rtac::test::drone_limits()), speed_mps);
  }
}
// What lasts takes speed from it, wherever it comes from, and never all of it.
TEST(Travel, APointMassArrivesInTimeWhateverLasts) {
  const std::vector<Vec2> straight{{1.2, 0}};
  for (const RobotLimits& limits : exposed()) {
    const double lasting_mps = lasting_speed(kind_of(limits), period_us).get_d();
    for (const double speed_mps : {std::max(0.1, 2 * lasting_mps), 0.8}) {
      for (int k = 0; k < 24; ++k) {
        const double angle = 2 * 3.14159265 * k / 24;
        const Vec2 towards{std::cos(angle), std::sin(angle)};
        const Lasting lasting{limits.disturbance_mps2 * towards,
                              -limits.velocity_error_mps * towards};
        for (const std::vector<Vec2>& way : {stairs(6), straight}) {
          EXPECT_LE(driven_s<Acceleration>(limits, speed_mps, way, lasting),
                    priced_s(limits, speed_mps, length_m(way)))
              << speed_mps << " m/s, " << limits.velocity_error_mps << " m/s, "
              << limits.disturbance_mps2 << " m/s^2, " << angle << " rad, " << way.size()
              << " legs";
        }
      }
    }
  }
}
TEST(Travel, AUnicycleTakesNoLongerThanPriced) {
  RobotLimits slow = rtac::test::cart_limits();
  slow.turn_radps = 0.7;
  RobotLimits late = rtac::test::cart_limits();  // it turns slowly, so as not to swing
  late.heading_age_us = 2'000'000;
  for (const double speed_mps : {0.05, 0.15, 0.22}) {
    expect_priced<Twist>(rtac::test::cart_limits(), speed_mps);
    expect_priced<Twist>(slow, speed_mps);
    expect_priced<Twist>(brisk(slow), speed_mps);
    expect_priced<Twist>(late, speed_mps);
  }
}

// Who knows where it truly heads shows it off its way by least while it turns and by most while it
// drives, so as to keep it turning.
double shown_off(double truly_rad, double errors_rad, double end_rad, bool turning) {
  const double side = truly_rad < 0 ? -1 : 1, off = side * truly_rad;
  if (!turning) return side * (off + errors_rad);
  if (off - errors_rad <= -end_rad) return side * (off - errors_rad);
  return side * std::min(std::max(off - errors_rad, end_rad), off + errors_rad);
}

// Drives `points`, each after a turn, and says how long that takes. The errors of the heading and
// of the place add up.
double misled_s(const RobotLimits& limits, double speed_mps, const std::vector<Vec2>& points) {
  safe::Setting setting;
  setting.limits = limits, setting.period_us = period_us, setting.speed_mps = speed_mps;
  const safe::Steering steering = safe::steering_of(setting);
  const double errors_rad =
      limits.heading_error_rad + std::atan(limits.position_error_m / steering.aim_ahead_m);
  rtac::test::Plant<Twist> plant(limits, {0, 0});
  plant.noisy = 0;
  plant.heading = 3.1;
  safe::Pilot<Twist> pilot(setting);
  pilot.engage(plant.observe());
  Path way;
  for (const Vec2 p : points) (void)way.points.push(p);
  safe::LegTracker truth;
  truth.begin(plant.p);
  bool turning = true;
  while (!way.finished() && plant.now_us < 600'000'000) {
    Observation seen = plant.observe();
    const std::size_t leg = way.index;
    const safe::LegTracker::Bearing b = truth.bearing(way, plant.p);
    const double along = std::atan2(b.direction.y, b.direction.x);
    const double truly =
        std::remainder(along - std::atan(b.lateral_m / steering.aim_ahead_m) - plant.heading,
                       2 * 3.14159265358979);
    const double kept_rad = 1.02 * steering.turn_end_rad;  // so that nothing rounds below
    const double n = shown_off(truly, errors_rad, kept_rad, turning) - truly;
    const double share = n / errors_rad;
    seen.heading.value -= share * limits.heading_error_rad;
    if (plant.now_us > 0) {  // where the first leg begins is seen as it is
      const Vec2 right{b.direction.y, -b.direction.x};
      seen.position.value = plant.p + share * limits.position_error_m * right;
    }
    const Twist out = pilot.drive(seen, seen.position.value, way);
    turning = out.speed_mps == 0;
    if (way.index != leg) {
      truth.begin(points[way.index - 1]);
      turning = true;
    }
    plant.apply(out, period_us);
  }
  return 1e-6 * static_cast<double>(plant.now_us);
}
TEST(Travel, TurnsEndWhateverErrorsShow) {
  for (const double heading_rad : {0.0, 0.035, 0.1, 0.15}) {
    for (const double speed_mps : {0.05, 0.22}) {
      RobotLimits limits = rtac::test::cart_limits();
      limits.heading_error_rad = heading_rad;
      for (const int cells : {1, 3, 12}) {
        const std::vector<Vec2> straight{{0.1 * cells, 0}};
        for (const std::vector<Vec2>& way : {stairs(cells), straight}) {
          EXPECT_LE(misled_s(limits, speed_mps, way), priced_s(limits, speed_mps, length_m(way)))
              << heading_rad << " rad, " << speed_mps << " m/s, " << way.size() << " legs of "
              << cells << " cells";
        }
        EXPECT_LE(misled_s(limits, speed_mps, straight),
                  few_legs_seconds(kind_of(limits), milli(speed_mps), period_us, 1, 2, 100 * cells)
                      .get_d())
            << heading_rad << " rad, " << speed_mps << " m/s, one leg of " << cells << " cells";
      }
    }
  }
}

// theory, battery: every leg speeds up and brakes; a way over m cells has up to m + 1 of them.
TEST(Travel, EveryLegSpeedsUpAndBrakes) {
  const sema::RobotKind fast = kind_of(rtac::test::cart_limits());
  sema::RobotKind slow = fast, soft = fast;
  slow.motion.accel = {Rational(1, 100), {}};
  soft.motion.brake = {Rational(1, 10), {}};
  const Rational w(1, 9), now = travel_seconds(fast, w, period_us, cell_mm, 4000);
  EXPECT_GE(Rational(travel_seconds(slow, w, period_us, cell_mm, 4000) - now),
            Rational(41 * 99 * w));
  EXPECT_GE(Rational(travel_seconds(soft, w, period_us, cell_mm, 4000) - now),
            Rational(41 * 9 * w));
}

// A way of more points than a path holds is driven in pieces, with a stop at the end of each.
TEST(Travel, PiecesOfAWayEndAtRest) {
  const sema::RobotKind k = kind_of(rtac::test::cart_limits());
  const auto seconds = [&](int cells) {
    return travel_seconds(k, Rational(1, 9), period_us, cell_mm, cells * cell_mm);
  };
  const Rational stop(1 + 22, 100);  // a second until it looks, and 0.22 m/s of braking at 1 m/s^2
  // ten pieces of 64 cells, with as many legs either way
  const Rational ten = seconds(640) - seconds(0), one = seconds(64) - seconds(0);
  EXPECT_EQ(Rational(ten - 10 * one), 0);
  EXPECT_GE(one, stop);
}

// theory, battery: c d + P_idle t, and the drive until it has stopped.
TEST(Travel, ThePriceIsThatOfDrivingAndOfTime) {
  const sema::RobotKind k = kind_of(rtac::test::cart_limits());
  const Rational w(1, 9);
  for (const std::int64_t mm : {std::int64_t{1}, std::int64_t{999}, std::int64_t{123'457}}) {
    const Rational least = k.energy->drive.value * Rational(static_cast<long>(mm), 1000) +
                           k.energy->idle.value * travel_seconds(k, w, period_us, cell_mm, mm);
    const Rational stop = k.energy->drive.value * Rational(22 * 22, 20'000);
    const Rational price(static_cast<long>(TravelCost(k, w, period_us, cell_mm).ppm(mm)),
                         1'000'000);
    EXPECT_GE(price, Rational(least + stop));
    EXPECT_LE(price, Rational(least + stop + Rational(1, 1'000'000)));
  }
  EXPECT_LT(TravelCost(k, w, period_us, cell_mm).ppm(1000),
            TravelCost(k, w, period_us, cell_mm).ppm(2000));
}

}  // namespace
}  // namespace rtac::analysis::test
