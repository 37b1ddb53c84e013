#include "compiler/analysis/travel.h"

#include <algorithm>

#include "compiler/support/rational.h"

namespace rtac::analysis {
namespace {

// What one leg takes on top of its length at full speed, from rest to rest.
struct Leg {
  Rational seconds;
  Rational turn_s_per_rad;  // 0: it need not turn
};

Rational seconds_of(const std::optional<sema::Sense>& sense) {
  return sense ? sense->max_age.value : Rational(0);
}

// The delay that a pilot reckons with: a unicycle brakes whatever its speed was measured to be.
Rational delay(const sema::RobotKind& kind, const Rational& period) {
  const Rational acts = kind.latency.value + period;
  return kind.motion.turn ? acts : Rational(acts + seconds_of(kind.velocity));
}

// The velocity of a point mass follows its set-point with this time constant.
Rational settling(const sema::RobotKind& kind, const Rational& period) {
  return std::max(Rational(pace::velocity_time_ms, 1000),
                  Rational(pace::velocity_time_delays * delay(kind, period)));
}

// The pilot turns at a rate proportional to the error (gain g), limited, until the error is e. From
// an error x that is log(x / e) / g, or longer where the limit binds, and never above the tangent
// at an eighth of a circle, log(pi / 4 / e) - 1 + x / (pi / 4), over g; or than x at the limit on
// top of the same constant. 1.0611: above log(7.8540) - 1. And a turn rate takes time to act.
void add_turn(const sema::RobotKind& kind, const Rational& period, Leg& leg) {
  if (!kind.motion.turn) return;
  static_assert(pace::turn_end_mrad == 100, "the logarithm below");
  const Rational gain(pace::turn_gain_milli_per_s, 1000);
  const Rational limit = std::min(kind.motion.turn->value, Rational(pace::turn_max_mradps, 1000));
  const Rational tangent = Rational(10'000, 7853) / gain;
  leg.turn_s_per_rad = std::max(tangent, Rational(1 / limit));
  leg.seconds +=
      Rational(10'611, 10'000) / gain + kind.latency.value + period + seconds_of(kind.heading);
  if (kind.motion.turn_accel) leg.seconds += limit / kind.motion.turn_accel->value;
}

// At least log(speed / creep), not below 0: 0.6932 a doubling.
Rational log_of_creep(const Rational& speed) {
  int doublings = 0;
  for (Rational reached(pace::creep_mmps, 1000); reached < speed; reached *= 2) ++doublings;
  return Rational(6932, 10000) * doublings;
}

// Speeding up: the acceleration, and the time constant of a point mass (the mean of both would do).
// Slowing down from w to the creep c, with r for the delay and d for the planned braking: the
// set-point v leaves v r + v^2 / (2 d) to go, so that dt = dv / d + r dv / v. That is w / (2 d) + r
// log(w / c) more than at full speed, at most; then the creep, over what c leaves to go.
Leg leg_of(const sema::RobotKind& kind, const Rational& speed, const Rational& period) {
  const Rational up =
      std::min(kind.motion.accel.value, kind.motion.brake.value) - disturbance_of(kind);
  const Rational planned = up * Rational(pace::planned_braking_permille, 1000);
  const Rational creep(pace::creep_mmps, 1000), reaction = delay(kind, period);
  Leg leg;
  leg.seconds = speed / up + speed / (2 * planned) + creep / (2 * planned) +
                reaction * (log_of_creep(speed) + 1);
  if (kind.motion.model == sema::MotionModel::point) {
    leg.seconds += settling(kind, period);
  }
  add_turn(kind, period, leg);
  return leg;
}

// A stop against whatever pushes.
Rational braking(const sema::RobotKind& kind) {
  return kind.motion.brake.value - disturbance_of(kind);
}

}  // namespace

Rational pushed_speed(const sema::RobotKind& kind, std::int64_t period_us) {
  const Rational period(static_cast<long>(period_us), 1'000'000);
  return disturbance_of(kind) * settling(kind, period);
}

Rational travel_seconds(const sema::RobotKind& kind, const Rational& speed, std::int64_t period_us,
                        std::int32_t cell_mm, std::int64_t distance_mm) {
  const Rational period(static_cast<long>(period_us), 1'000'000);
  const Rational metres(distance_mm, 1000), cells(distance_mm, cell_mm);
  const Rational slowest = speed - pushed_speed(kind, period_us);  // above 0, see `derive`
  const Leg leg = leg_of(kind, speed, period);
  // at most a leg begins at each cell, the place that the way starts from included
  const Rational legs = cells + 1;
  // and turns by at most an eighth of a circle there, and half a circle at the start
  const Rational turning = (cells + 4) * Rational(7854, 10000) * leg.turn_s_per_rad;
  // It brakes first, rests, and looks for its way; at the end of each piece of a way that has more
  // points than fit, and more points than cells it has not, again.
  const Rational rest = kind.motion.speed.value / braking(kind) +
                        pace::rest_samples * (delay(kind, period) + seconds_of(kind.velocity)) +
                        Rational(pace::look_every_ms, 1000);
  const Rational stops = 2 + cells / pace::waypoints;
  return metres / slowest + legs * leg.seconds + turning + stops * rest;
}

std::int64_t run_out_mm(const sema::RobotKind& kind, const Rational& speed,
                        std::int64_t period_us) {
  const Rational steers =
      std::min(kind.motion.accel.value, kind.motion.brake.value) - disturbance_of(kind);
  const Rational planned = steers * Rational(pace::planned_braking_permille, 1000);
  const Rational acts = kind.latency.value + Rational(static_cast<long>(period_us), 1'000'000) +
                        seconds_of(kind.velocity);
  return ceil_to_int(Rational((speed * acts + speed * speed / (2 * planned)) * 1000));
}

std::int64_t travel_cost_ppm(const sema::RobotKind& kind, const Rational& speed,
                             std::int64_t period_us, std::int32_t cell_mm,
                             std::int64_t distance_mm) {
  const sema::Energy& energy = *kind.energy;
  const Rational& v = kind.motion.speed.value;
  const Rational metres(distance_mm, 1000);
  const Rational stop = v * v / (2 * braking(kind));  // the way starts where it has stopped
  const Rational seconds = travel_seconds(kind, speed, period_us, cell_mm, distance_mm);
  return ceil_to_int(
      Rational((energy.drive.value * (metres + stop) + energy.idle.value * seconds) * 1'000'000));
}

}  // namespace rtac::analysis
