#include "compiler/analysis/travel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/sides.h"
#include "compiler/support/rational.h"

namespace rtac::analysis {
namespace {

// What one leg takes on top of its length at full speed, from rest to rest.
struct Leg {
  Rational seconds;
  Rational turn_s_per_rad;  // 0: it need not turn
};

Rational seconds_of(std::int64_t us) {
  Rational s(static_cast<long>(us), 1'000'000);
  s.canonicalize();
  return s;
}
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

// A gain in 1/s: `most`, or less after a delay that leaves no room for it.
Rational gain_of(int most_milli_per_s, int mrad_per_delay, const Rational& late) {
  Rational gain =
      std::min(Rational(most_milli_per_s, 1000), Rational(Rational(mrad_per_delay, 1000) / late));
  gain.canonicalize();
  return gain;
}

// The gain of its correction to a leg (lateral_gain_per_s of the pilots).
Rational lateral_gain(const sema::RobotKind& kind, const Rational& period) {
  const Rational late =
      settling(kind, period) + kind.latency.value + period + seconds_of(kind.position);
  return gain_of(pace::lateral_gain_milli_per_s, pace::lateral_mrad_per_delay, late);
}

// How wheels are led along a leg (steering_of of the pilots).
struct Steering {
  Rational gain;         // 1/s
  Rational turn_most;    // rad/s
  Rational ahead;        // m
  Rational errors, end;  // rad: of the direction that it is seen to be off, and where a turn ends
};

Steering steering(const sema::RobotKind& kind, const Rational& speed, const Rational& period) {
  const Rational acts = kind.latency.value + period;
  const auto ahead_of = [&](const Rational& gain) {
    const Rational turning = Rational(pace::aim_ahead_turns_permille, 1000) * speed / gain;
    const Rational late = acts + seconds_of(kind.position);
    return std::max({Rational(pace::aim_ahead_mm, 1000), turning,
                     Rational(pace::aim_ahead_delays * speed * late)});
  };
  Steering s;
  s.turn_most = std::min(kind.motion.turn->value, Rational(pace::turn_max_mradps, 1000));
  s.gain = gain_of(pace::turn_gain_milli_per_s, pace::turn_mrad_per_delay,
                   Rational(acts + seconds_of(kind.heading)));
  if (kind.motion.turn_accel) {
    s.gain = std::min(s.gain, Rational(kind.motion.turn_accel->value / s.turn_most));
  }
  if (kind.heading) s.errors = kind.heading->error.value;
  if (kind.position) s.errors += kind.position->error.value / ahead_of(s.gain);
  s.end = std::max(Rational(pace::turn_end_mrad, 1000),
                   Rational(pace::turn_end_errors_permille * s.errors / 1000));
  const Rational begin =
      std::max(Rational(pace::turn_begin_mrad, 1000), Rational(pace::turn_begin_errors * s.errors));
  s.gain = std::min(s.gain, Rational(s.turn_most / begin));
  s.ahead = ahead_of(s.gain);
  return s;
}

// The pilot turns at a rate proportional to what it sees, the error x and what errors add (E), with
// the gain g, limited, until it sees less than e. Down to x = e + E that takes log((x - E) / e) /
// g, or longer where the limit binds, and never above the tangent at an eighth of a circle, log(pi
// / 4 / e) - 1 + (x - E) / (pi / 4), over g; or than x at the limit on top of the same constant.
// From there to e - E, where it sees less than e for certain, it turns by g e at least: 2 E / e
// over g. 1.0611: above log(7.8540) - 1, for e = 0.1; of u = e / 0.1 the logarithm is 3 (u^2 - 1) /
// (u^2 + 4 u + 1) or more. And a turn rate takes time to act.
void add_turn(const sema::RobotKind& kind, const Rational& speed, const Rational& period,
              Leg& leg) {
  if (!kind.motion.turn) return;
  static_assert(pace::turn_end_mrad == 100, "the logarithm below");
  const Steering s = steering(kind, speed, period);
  const Rational u = s.end / Rational(pace::turn_end_mrad, 1000);
  const Rational log = Rational(10'611, 10'000) - 3 * (u * u - 1) / (u * u + 4 * u + 1);
  const Rational errs = (2 / s.end - Rational(10'000, 7855)) * s.errors;
  leg.turn_s_per_rad =
      std::max(Rational(Rational(10'000, 7853) / s.gain), Rational(1 / s.turn_most));
  leg.seconds += (log + errs) / s.gain + kind.latency.value + period + seconds_of(kind.heading);
  if (kind.motion.turn_accel) leg.seconds += s.turn_most / kind.motion.turn_accel->value;
}

// At least log(speed / least), not below 0: 0.6932 a doubling.
Rational log_over(const Rational& speed, const Rational& least) {
  int doublings = 0;
  for (Rational reached = least; reached < speed; reached *= 2) ++doublings;
  return Rational(6932, 10000) * doublings;
}

// Speeding up: the acceleration, and the time constant of a point mass (the mean of both would do).
// Slowing down from w to the creep c, with r for the delay and d for the planned braking: the
// set-point v leaves v r + v^2 / (2 d) to go. What lasts may take W from it, so that dt = (v / d +
// r) dv / (v - W): that is w / (2 d) + (W / d + r) log((w - W) / (u - W)) more than at full speed,
// at most, down to a set-point u that is more than W by the margin of the arrival. Then the creep,
// over what c leaves to go, if it is more than what is against it by as much; else the leg has
// ended (end_reach_m).
Leg leg_of(const sema::RobotKind& kind, const Rational& speed, const Rational& lasting,
           const Rational& period) {
  const Rational up =
      std::min(kind.motion.accel.value, kind.motion.brake.value) - disturbance_of(kind);
  const Rational planned = up * Rational(pace::planned_braking_permille, 1000);
  const Rational creep(pace::creep_mmps, 1000), reaction = delay(kind, period);
  const Rational margin(pace::arrival_margin_permille, 1000);
  const Rational taken = std::min(lasting, Rational(creep / margin));
  const Rational left = creep - taken;
  Leg leg;
  leg.seconds = speed / up + speed / (2 * planned) +
                (lasting / planned + reaction) * log_over(speed, left) +
                creep * (creep / (2 * planned) + reaction) / left;
  if (kind.motion.model == sema::MotionModel::point) {
    leg.seconds += settling(kind, period);
  }
  add_turn(kind, speed, period, leg);
  return leg;
}

// A stop against whatever pushes.
Rational braking(const sema::RobotKind& kind) {
  return kind.motion.brake.value - disturbance_of(kind);
}

Rational frequency_of(const sema::RobotKind& kind, std::int64_t period_us) {
  const Rational late = delay(kind, seconds_of(period_us));
  return hold_frequency(body_of(kind, period_us), ceil_to_int(Rational(late * 1'000'000)));
}

// A hold is latched at v = rest_mps of the pilot and an error, at most, where that comes to rest: x
// = v (t - (1 + omega t) r / 2) exp(-omega t) is below 1.23 v / omega exp(-0.7 omega t), and so
// much more with as much delay as the frequency leaves room for. It has settled when it is seen as
// near as counts, and slow enough to drive off (sway_slack_m, ready_mps of the pilot).
// Wheels rest at once.
Rational hold_seconds(const sema::RobotKind& kind, const Rational& period) {
  if (kind.motion.turn) return 0;
  const Rational omega = frequency_of(kind, ceil_to_int(Rational(period * 1'000'000)));
  const Rational errs = kind.velocity ? kind.velocity->error.value : Rational(0);
  const Rational pushes = disturbance_of(kind), b = kind.motion.brake.value;
  const Rational acts = delay(kind, period);
  const Rational seen = (errs + (b + pushes) * acts) * b / (b - pushes);
  const Rational steers = std::min(kind.motion.accel.value, b);
  const Rational slow = std::min(Rational(pace::creep_mmps, 1000), Rational(steers * acts)) / omega;
  const Rational near = std::min(Rational(pace::sway_slack_mm, 1000), slow);
  const Rational from = Rational(141, 100) * (seen + errs) / omega;
  return log_over(from, near) / (Rational(7, 10) * omega);
}

// It brakes, rests, sees where it does so, and looks for its way; wheels when some measurements
// tell that they stand.
Rational rest_seconds(const sema::RobotKind& kind, const Rational& period) {
  const Rational sample = delay(kind, period) + seconds_of(kind.velocity);
  Rational told = sample;
  if (kind.motion.turn) {
    // seen to be still it may yet come on, and its place is one from after that
    const Rational errs = kind.velocity ? kind.velocity->error.value : Rational(0);
    const Rational stops = (2 * errs + Rational(pace::still_mmps, 1000)) / braking(kind);
    told = std::max(Rational(pace::rest_samples * sample), Rational(sample + stops));
  }
  return kind.motion.speed.value / braking(kind) + told + seconds_of(kind.position) + period +
         Rational(pace::look_every_ms, 1000);
}
// So often; but at its last rest its hold need not settle any more.
Rational rests_seconds(const sema::RobotKind& kind, const Rational& period, const Rational& rests) {
  return rests * rest_seconds(kind, period) + (rests - 1) * hold_seconds(kind, period);
}

}  // namespace

Stop stop_of(const sema::RobotKind& kind, std::int64_t period_us) {
  const Rational period = seconds_of(period_us);
  const Rational speed = kind.motion.speed.value;
  const Rational late = delay(kind, period) + seconds_of(kind.velocity);
  return {rest_seconds(kind, period) + hold_seconds(kind, period),
          speed * late + speed * speed / (2 * braking(kind))};
}

Rational pushed_speed(const sema::RobotKind& kind, std::int64_t period_us) {
  const Rational period = seconds_of(period_us);
  return disturbance_of(kind) * settling(kind, period);
}

Rational lasting_speed(const sema::RobotKind& kind, std::int64_t period_us) {
  const bool steers = kind.motion.model == sema::MotionModel::point;
  const Rational errs = steers && kind.velocity ? kind.velocity->error.value : Rational(0);
  return errs + pushed_speed(kind, period_us);
}

Rational heading_errors(const sema::RobotKind& kind, const Rational& speed,
                        std::int64_t period_us) {
  return kind.motion.turn ? steering(kind, speed, seconds_of(period_us)).errors : Rational(0);
}

Rational slowest_led(const sema::RobotKind& kind, std::int64_t period_us) {
  const Rational pushed = pushed_speed(kind, period_us);
  const bool steers = kind.motion.model == sema::MotionModel::point && !kind.in_space;
  if (!steers || !kind.velocity) return pushed;
  return 2 * (kind.velocity->error.value + pushed);
}

std::optional<Rational> led_at(const sema::RobotKind& kind, const Rational& wanted,
                               std::int64_t period_us) {
  const auto mmps_up = [](const Rational& speed) { return ceil_to_int(Rational(speed * 1000)); };
  const std::int64_t most_mmps = floor_to_int(Rational(kind.motion.speed.value * 1000));
  const std::int64_t least_mmps = std::max<std::int64_t>(mmps_up(slowest_led(kind, period_us)), 1);
  if (least_mmps > most_mmps) return std::nullopt;
  for (std::int64_t mmps = std::clamp(mmps_up(wanted), least_mmps, most_mmps);;) {
    const Rational speed = metres_of(mmps);
    if (kind.in_space && speed > follows_up_to(kind, period_us)) return std::nullopt;
    if (heading_errors(kind, speed, period_us) <= heading_errors_most) return speed;
    if (mmps == most_mmps) return std::nullopt;
    mmps = std::min(mmps + mmps / 20 + 1, most_mmps);
  }
}

// How far beside its leg what pushes a point mass brings it before its correction settles. While it
// speeds up, that is left with a part of what it steers with only.
Rational pushed_beside(const sema::RobotKind& kind, const Rational& speed, const Rational& period) {
  const Rational pushes = disturbance_of(kind);
  const Rational steers = std::min(kind.motion.accel.value, kind.motion.brake.value) - pushes;
  if (pushes <= 0 || steers <= 0) return 0;  // reported
  return Rational(3, 2) * pushes * std::max(settling(kind, period), Rational(speed / steers));
}

// A point mass settles where its correction makes up for the errors of its place and its velocity
// and for the speed that it is pushed with; half of what pushes more until then. A velocity error
// that is a part r of its speed, half at most, takes 1 / sqrt(1 - r^2) of itself to make up for: no
// more than 1 + 0.62 r^2. Wheels set out with what is left of their turn, which leads aside by 0.65
// of it times how far ahead they aim; an error of the heading that lasts by as much as itself, and
// a fifth more until it has settled; and errors of the place that change at the worst rate by half
// of what they are more than those that last.
std::int64_t beside_mm(const sema::RobotKind& kind, const Rational& speed, std::int64_t period_us) {
  const Rational period = seconds_of(period_us);
  const Rational place = kind.position ? kind.position->error.value : Rational(0);
  Rational settled, pushed = Rational(3, 2) * pushed_speed(kind, period_us);
  if (kind.motion.turn) {
    const Rational heading = kind.heading ? kind.heading->error.value : Rational(0);
    const Steering s = steering(kind, speed, period);
    settled =
        Rational(91, 100) * s.end * speed / s.gain + Rational(6, 5) * heading * s.ahead + place / 2;
  } else if (!kind.in_space) {
    const Rational gain = lateral_gain(kind, period);
    const Rational errs = kind.velocity ? kind.velocity->error.value : Rational(0);
    const Rational part = std::min(Rational(1, 2), speed > 0 ? Rational(errs / speed) : errs);
    settled = place + errs * (1 + Rational(62, 100) * part * part) / gain;
    pushed = pushed_beside(kind, speed, period) / gain;
  }
  return std::max(beside_least_mm, ceil_to_int(Rational(settled * 1000))) +
         ceil_to_int(Rational(pushed * 1000));
}

// stand_off_m of the pilots: in their steps, in doubles, and a little more.
std::int64_t end_reach_mm(const sema::RobotKind& kind, std::int64_t period_us) {
  constexpr double least_mm = 20, rounding_mm = 0.01;
  constexpr int directions = 90;
  const double error_mm = kind.position ? 1000 * kind.position->error.value.get_d() : 0;
  double reach_mm = std::max(least_mm, error_mm);
  const Rational steers =
      std::min(kind.motion.accel.value, kind.motion.brake.value) - disturbance_of(kind);
  if (kind.motion.turn || steers <= 0) return std::lround(std::ceil(reach_mm));
  const Rational period = seconds_of(period_us);
  const double planned = 1e-3 * pace::planned_braking_permille * steers.get_d();
  const double late = planned * delay(kind, period).get_d();
  const double lasts = lasting_speed(kind, period_us).get_d();
  const double gain = lateral_gain(kind, period).get_d();
  for (int k = 0; k < directions; ++k) {
    const double from = std::numbers::pi / 2 * k / directions;
    const double to = std::numbers::pi / 2 * (k + 1) / directions;
    const double set = 1e-3 * pace::arrival_margin_permille * lasts * std::cos(from);
    if (set <= 1e-3 * pace::creep_mmps) break;
    const double along = set * (set + 2 * late) / (2 * planned);
    const double aside = lasts * std::sin(to) / gain;
    reach_mm = std::max(reach_mm, 1e3 * std::hypot(along, aside) + rounding_mm);
  }
  return std::lround(std::ceil(reach_mm));
}

Rational travel_seconds(const sema::RobotKind& kind, const Rational& speed, std::int64_t period_us,
                        std::int32_t cell_mm, std::int64_t distance_mm) {
  const Rational period = seconds_of(period_us);
  const Rational metres(distance_mm, 1000), cells(distance_mm, cell_mm);
  const Rational lasting = lasting_speed(kind, period_us);
  const Rational slowest = speed - lasting;  // above 0, see `derive`
  const Leg leg = leg_of(kind, speed, lasting, period);
  // at most a leg begins at each cell, the place that the way starts from included
  const Rational legs = cells + 1;
  // and turns by at most an eighth of a circle there, and half a circle at the start
  const Rational turning = (cells + 4) * Rational(7854, 10000) * leg.turn_s_per_rad;
  // It rests first, and at the end of each piece of a way that has more points than fit, and more
  // points than cells it has not, again.
  const Rational stops = 2 + cells / pace::waypoints;
  return metres / slowest + legs * leg.seconds + turning + rests_seconds(kind, period, stops);
}

Rational few_legs_seconds(const sema::RobotKind& kind, const Rational& speed,
                          std::int64_t period_us, int legs, int rests, std::int64_t distance_mm) {
  const Rational period = seconds_of(period_us);
  const Rational lasting = lasting_speed(kind, period_us);
  const Leg leg = leg_of(kind, speed, lasting, period);
  const Rational turning = 4 * Rational(7854, 10000) * leg.turn_s_per_rad;
  return Rational(distance_mm, 1000) / (speed - lasting) + legs * (leg.seconds + turning) +
         rests_seconds(kind, period, rests);
}

Rational follows_up_to(const sema::RobotKind& kind, std::int64_t period_us) {
  const Rational omega = frequency_of(kind, period_us);
  const Rational place = kind.position ? kind.position->error.value : Rational(0);
  const Rational errs = kind.velocity ? kind.velocity->error.value : Rational(0);
  if (omega <= 0) return 0;
  return 2 * (braking(kind) / omega - omega * place - 2 * errs);
}

// What a leg along which the hold is carried takes on top of its length, from rest to rest. The
// robot trails by 2 w / omega, and what is left of that at the time t after the hold has come to
// the end of the leg is below 2.3 w / omega exp(-0.7 omega t), with as much delay as the frequency
// leaves room for. A leg has ended when that is less than a half of what counts as near beyond what
// errors and pushes do (sway_slack_m of the pilots); the rest is for what earlier legs have left.
// While it follows it asks for w omega / 2 at most beside what errors and pushes take: a brake that
// is not as strong does not follow like that.
std::optional<Rational> carried_leg_seconds(const sema::RobotKind& kind, const Rational& speed,
                                            std::int64_t period_us) {
  if (speed > follows_up_to(kind, period_us)) return std::nullopt;
  const Rational period = seconds_of(period_us), late = delay(kind, period);
  const Rational omega = frequency_of(kind, period_us);
  const Rational settles = log_over(Rational(Rational(23, 10) * speed),
                                    Rational(Rational(pace::near_mm, 1000) * omega)) /
                           (Rational(7, 10) * omega);
  return period + late + seconds_of(kind.position) + settles + Rational(pace::look_every_ms, 1000);
}

// It looks after a stop, and begins each leg at rest.
std::optional<Rational> legs_seconds(const sema::RobotKind& kind, const Rational& speed,
                                     std::int64_t period_us, int legs, std::int64_t way_mm) {
  if (braking(kind) <= 0) return std::nullopt;  // reported
  const auto leg = carried_leg_seconds(kind, speed, period_us);
  if (!leg) return std::nullopt;
  return Rational(Rational(way_mm, 1000) / speed) + (legs + 1) * *leg +
         (legs + 1) * rest_seconds(kind, seconds_of(period_us));
}

// As ways of the plane; but whatever lasts and pushes the robot, its hold is carried at the full
// speed. What has been latched at the beginning settles like a leg.
std::optional<Rational> carried_seconds(const sema::RobotKind& kind, const Rational& speed,
                                        std::int64_t period_us, std::int32_t cell_mm,
                                        std::int64_t distance_mm) {
  if (braking(kind) <= 0) return std::nullopt;  // reported
  const auto leg = carried_leg_seconds(kind, speed, period_us);
  if (!leg) return std::nullopt;
  const Rational metres(distance_mm, 1000), cells(distance_mm, cell_mm);
  const Rational stops = 2 + cells / pace::waypoints;
  return metres / speed + (cells + 1 + stops) * *leg +
         stops * rest_seconds(kind, seconds_of(period_us));
}

std::int64_t run_out_mm(const sema::RobotKind& kind, const Rational& speed,
                        std::int64_t period_us) {
  const Rational steers =
      std::min(kind.motion.accel.value, kind.motion.brake.value) - disturbance_of(kind);
  const Rational planned = steers * Rational(pace::planned_braking_permille, 1000);
  const Rational acts = kind.latency.value + seconds_of(period_us) + seconds_of(kind.velocity);
  return ceil_to_int(Rational((speed * acts + speed * speed / (2 * planned)) * 1000));
}

TravelCost::TravelCost(const sema::RobotKind& kind, const Rational& speed, std::int64_t period_us,
                       std::int32_t cell_mm) {
  const sema::Energy& energy = *kind.energy;
  const Rational& v = kind.motion.speed.value;
  const Rational stop = v * v / (2 * braking(kind));  // the way starts where it has stopped
  const auto ppm = [&](std::int64_t distance_mm) {
    const Rational metres = metres_of(distance_mm) + stop;
    const Rational seconds = travel_seconds(kind, speed, period_us, cell_mm, distance_mm);
    return Rational((energy.drive.value * metres + energy.idle.value * seconds) * 1'000'000);
  };
  const Rational first = ppm(0), per_mm = ppm(1) - first;
  in_ppm_ = lcm(first.get_den(), per_mm.get_den());
  first_ = first.get_num() * (in_ppm_ / first.get_den());
  per_mm_ = per_mm.get_num() * (in_ppm_ / per_mm.get_den());
}
std::int64_t TravelCost::ppm(std::int64_t distance_mm) const {
  mpz_class up;
  const mpz_class over = first_ + per_mm_ * static_cast<long>(distance_mm);
  mpz_cdiv_q(up.get_mpz_t(), over.get_mpz_t(), in_ppm_.get_mpz_t());
  return up.get_si();
}

}  // namespace rtac::analysis
