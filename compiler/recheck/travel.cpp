#include "compiler/recheck/travel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "compiler/interp/number.h"
#include "compiler/recheck/numbers.h"
#include "compiler/sema/templates.h"

namespace rtac::recheck {
namespace {

// What the pilots of the runtime pace their ways with.
const Rational creep(3, 100);          // m/s, at the end of a leg
const Rational planned_braking(2, 5);  // share of the brake
const Rational arrival(5, 4);          // how much more than what is against it the set-point is
const Rational settles(3, 10);         // s, or two delays
const Rational turn_gain(3, 2);        // 1/s, or half a radian per delay
const Rational turn_most(3, 2);        // rad/s
const Rational turn_end(1, 10);        // rad, or 2.5 of what errors turn what it heads for
const Rational turn_begin(7, 20);      // rad, or five times as much
const Rational aims_ahead(1, 5);       // m, or 1.4 of its speed over the gain, or 2 of its delay
const Rational looks_every(1);         // s
const Rational eighth(7854, 10000);    // of a circle, from above
const Rational near(1, 200);           // m, of what it follows, at the end of a leg
const Rational still(1, 100);          // m/s, and the error: wheels that are measured to stand
constexpr int samples_at_rest = 3;
constexpr int waypoints = 64;  // of one piece of a way

Rational declared(const std::optional<sema::Quantity>& q) {
  return q ? q->value : Rational(0);
}
Rational oldest(const std::optional<sema::Sense>& sense) {
  return sense ? sense->max_age.value : Rational(0);
}

// At least log(ratio), not below 0: 0.6932 a doubling.
Rational log_above(const Rational& ratio) {
  Rational log = 0;
  for (Rational reached = 1; reached < ratio; reached *= 2) log += Rational(6932, 10000);
  return log;
}

class Travel {
 public:
  Travel(const sema::RobotKind& kind, const sema::Decision& decision, Rational speed)
      : kind_(kind),
        wheels_(kind.motion.model == sema::MotionModel::unicycle),
        speed_(std::move(speed)),
        period_(decision.period->value),
        acts_(kind.latency.value + period_) {
    const Rational pushes = declared(kind.motion.disturbance) + declared(kind.output_error);
    delay_ = wheels_ ? acts_ : Rational(acts_ + oldest(kind.velocity));
    settling_ = std::max(settles, Rational(2 * delay_));
    taken_ = pushes * settling_;
    if (!wheels_ && kind.velocity) taken_ += kind.velocity->error.value;
    steers_ = std::min(kind.motion.accel.value, kind.motion.brake.value) - pushes;
    brakes_ = kind.motion.brake.value - pushes;
  }
  // In space the place of a hold moves, whatever its velocity errs.
  [[nodiscard]] bool gets_on() const {
    const Rational errs = kind_.velocity ? kind_.velocity->error.value : Rational(0);
    const bool makes_way = kind_.in_space ? speed_ >= taken_ - errs : speed_ > taken_;
    return makes_way && steers_ > 0 && brakes_ > 0;
  }
  // A leg begins at each cell at most, and turns by an eighth of a circle there, by half a circle
  // at the start. It rests and looks before it sets out, once at its end, and where a piece of the
  // way ends.
  [[nodiscard]] Rational seconds(const Rational& way, const Rational& cell) const {
    const Rational cells = way / cell;
    return way / slowest() + (cells + 1) * leg() + (cells + 4) * eighth * turn_per_rad() +
           (2 + cells / waypoints) * rest() + (1 + cells / waypoints) * hold_settles();
  }
  // Of few legs, each of which may begin with half a circle.
  [[nodiscard]] Rational seconds_of_legs(const Rational& way, int legs, int looks = 1) const {
    return way / slowest() + legs * (leg() + 4 * eighth * turn_per_rad()) + (looks + 1) * rest() +
           looks * hold_settles();
  }
  // It passes the place where control comes back at full speed, and stops behind it.
  [[nodiscard]] Rational run_out() const {
    const Rational late = acts_ + oldest(kind_.velocity);
    return speed_ * late + speed_ * speed_ / (2 * planned());
  }
  [[nodiscard]] Rational stop_seconds() const { return rest() + hold_settles(); }
  [[nodiscard]] Rational stop() const {
    const Rational speed = kind_.motion.speed.value;
    return speed * (delay_ + oldest(kind_.velocity)) + speed * speed / (2 * brakes_);
  }
  [[nodiscard]] Rational run_out_seconds() const { return run_out() / slowest(); }
  [[nodiscard]] Rational fastest() const { return speed_ + taken_; }
  // Where its correction makes up for the errors of its place and velocity, of which a part r of
  // its speed takes 1 / sqrt(1 - r^2) of itself, 1 + 0.62 r^2 at most; and what pushes it, half as
  // far again until then.
  [[nodiscard]] Rational beside() const {
    const Rational gain = std::min(
        Rational(1), Rational(Rational(1, 2) / (settling_ + acts_ + oldest(kind_.position))));
    const Rational errs = kind_.velocity ? kind_.velocity->error.value : Rational(0);
    const Rational part = std::min(Rational(1, 2), Rational(errs / speed_));
    const Rational place = kind_.position ? kind_.position->error.value : Rational(0);
    const Rational pushes = declared(kind_.motion.disturbance) + declared(kind_.output_error);
    const Rational settled = place + errs * (1 + Rational(62, 100) * part * part) / gain;
    const Rational pushed =
        Rational(3, 2) * pushes * std::max(settling_, Rational(speed_ / steers_));
    return std::max(beside_least, settled) + pushed / gain;
  }
  // Wheels set out with what is left of their turn; an error of the heading that lasts leads them
  // aside by itself and a fifth more until it has settled; and errors of the place that change by
  // half of what they are.
  [[nodiscard]] Rational wheels_beside() const {
    const Rational sees = kind_.heading ? kind_.heading->error.value : Rational(0);
    const Rational place = kind_.position ? kind_.position->error.value : Rational(0);
    const Rational pushes = declared(kind_.motion.disturbance) + declared(kind_.output_error);
    const Rational settled = Rational(91, 100) * turn_ends() * speed_ / gain() +
                             Rational(6, 5) * sees * ahead(gain()) + place / 2;
    return std::max(beside_least, settled) + Rational(3, 2) * pushes * settling_;
  }
  [[nodiscard]] bool steers() const { return steers_ > 0 && speed_ > 0; }
  [[nodiscard]] bool has_wheels() const { return wheels_; }
  // In space it follows a hold that is carried so fast, with what errors and pushes leave of the
  // brake.
  [[nodiscard]] bool follows() const {
    const Rational omega = hold_frequency();
    const Rational place = kind_.position ? kind_.position->error.value : Rational(0);
    const Rational errs = kind_.velocity ? kind_.velocity->error.value : Rational(0);
    return omega * (speed_ / 2 + omega * place + 2 * errs) <= brakes_;
  }
  // How near to the end of its leg one counts as having come there: within 2 cm, or the error of
  // its place, or where what lasts stops it. That takes from the set-point, along the leg and
  // beside it, in all directions.
  [[nodiscard]] double ends_within() const {
    const double place = kind_.position ? kind_.position->error.value.get_d() : 0;
    const double least = std::max(0.02, place);
    if (wheels_ || steers_ <= 0) return least;
    const double brake = planned().get_d(), late = brake * delay_.get_d(), taken = taken_.get_d();
    const double gain =
        std::min(1.0, 0.5 / Rational(settling_ + acts_ + oldest(kind_.position)).get_d());
    constexpr int directions = 90;
    double most = least;
    for (int k = 0; k < directions; ++k) {
      const double from = std::numbers::pi / 2 * k / directions;
      const double to = std::numbers::pi / 2 * (k + 1) / directions;
      const double set = arrival.get_d() * taken * std::cos(from);
      if (set <= creep.get_d()) break;
      const double along = set * (set + 2 * late) / (2 * brake);
      most = std::max(most, std::hypot(along, taken * std::sin(to) / gain));
    }
    return most;
  }
  // In space its hold is carried along a way over cells, from rest to rest at each; the robot
  // trails it, and what is left of that at its end shrinks by 0.7 of its frequency, from 2.3 of the
  // pace over that. What has been latched first settles likewise. nullopt: its brake is too weak to
  // follow.
  [[nodiscard]] std::optional<Rational> carried_seconds(const Rational& way,
                                                        const Rational& cell) const {
    const Rational omega = hold_frequency();
    if (!follows()) return std::nullopt;
    const Rational cells = way / cell, rests = 2 + cells / waypoints;
    const Rational settled =
        log_above(Rational(Rational(23, 10) * speed_ / (omega * near))) / (Rational(7, 10) * omega);
    const Rational leg = period_ + delay_ + oldest(kind_.position) + settled + looks_every;
    return way / speed_ + (cells + 1 + rests) * leg + rests * rest();
  }

 private:
  // What leaves room for its delay, and a half of what a push leaves of the brake to errors of the
  // velocity, a quarter to those of the place; from below.
  [[nodiscard]] Rational hold_frequency() const {
    const Rational loop = std::max(Rational(delay_ + oldest(kind_.position)), Rational(1, 100));
    Rational omega = std::min(Rational(2), Rational(Rational(1, 4) / loop));
    const auto errs = [](const auto& sense) { return sense ? sense->error.value : Rational(0); };
    if (errs(kind_.velocity) > 0) {
      omega = std::min(omega, Rational(brakes_ / (4 * errs(kind_.velocity))));
    }
    if (errs(kind_.position) > 0) {
      const Rational square = brakes_ / (4 * errs(kind_.position));
      if (omega * omega > square) omega = interp::square_root(square).below;
    }
    return omega;
  }
  // It brakes, sees that it rests and then where, and looks for its way.
  [[nodiscard]] Rational rest() const {
    const Rational sample = delay_ + oldest(kind_.velocity);
    const Rational errs = kind_.velocity ? kind_.velocity->error.value : Rational(0);
    const Rational comes_on = (2 * errs + still) / brakes_;
    const Rational told =
        wheels_ ? std::max(Rational(samples_at_rest * sample), Rational(sample + comes_on))
                : sample;
    return kind_.motion.speed.value / brakes_ + told + oldest(kind_.position) + period_ +
           looks_every;
  }
  // Before a point mass sets out: its hold begins at the speed v at which it is seen to rest, and
  // its error, and swings by less than 1.23 v / omega, with what a delay adds 1.41, which shrinks
  // by 0.7 of the frequency: until that is a centimetre, and it is as slow as who sets out.
  [[nodiscard]] Rational hold_settles() const {
    if (wheels_) return 0;
    const Rational errs = kind_.velocity ? kind_.velocity->error.value : Rational(0);
    const Rational pushes = declared(kind_.motion.disturbance) + declared(kind_.output_error);
    const Rational brake = kind_.motion.brake.value;
    const Rational begins = (errs + (brake + pushes) * delay_) * brake / brakes_ + errs;
    const Rational omega = hold_frequency();
    const Rational drives = std::min(creep, Rational((steers_ + pushes) * delay_));
    const Rational ends = std::min(Rational(1, 100), Rational(drives / omega));
    return log_above(Rational(141, 100) * begins / (omega * ends)) / (Rational(7, 10) * omega);
  }
  [[nodiscard]] Rational slowest() const { return speed_ - taken_; }
  [[nodiscard]] Rational planned() const { return steers_ * planned_braking; }
  // What one leg takes on top of its length at full speed: speeding up, slowing down as planned to
  // the creep, which what lasts slows down further, the creep, and a turn in place to 0.1 rad.
  [[nodiscard]] Rational leg() const {
    const Rational left = creep - std::min(taken_, Rational(creep / arrival));
    Rational sum = speed_ / steers_ + speed_ / (2 * planned()) +
                   (taken_ / planned() + delay_) * log_above(speed_ / left) +
                   creep * (creep / (2 * planned()) + delay_) / left;
    if (!wheels_) return sum + settling_;
    // From an error x by which it is seen off by x - errors at least: log((x - errors) / end) over
    // the gain, below its tangent at an eighth of a circle, the logarithm of end over 0.1 being
    // 3 (u^2 - 1) / (u^2 + 4 u + 1) or more; then what errors hide, at the gain times the end.
    const Rational errs = errors(), ends = turn_ends();
    const Rational u = ends / turn_end;
    sum += (Rational(10'611, 10'000) - 3 * (u * u - 1) / (u * u + 4 * u + 1) + 2 * errs / ends -
            errs * Rational(10'000, 7855)) /
           gain();
    sum += acts_ + oldest(kind_.heading);
    if (kind_.motion.turn_accel) sum += turns() / kind_.motion.turn_accel->value;
    return sum;
  }
  // What leaves room for the delay and for a turn rate that changes slowly.
  [[nodiscard]] Rational free_gain() const {
    Rational most = std::min(turn_gain, Rational(Rational(1, 2) / (acts_ + oldest(kind_.heading))));
    if (!kind_.motion.turn_accel) return most;
    return std::min(most, Rational(kind_.motion.turn_accel->value / turns()));
  }
  [[nodiscard]] Rational errors() const {
    const Rational sees = kind_.heading ? kind_.heading->error.value : Rational(0);
    if (!kind_.position) return sees;
    return sees + kind_.position->error.value / ahead(free_gain());
  }
  [[nodiscard]] Rational ahead(const Rational& gain) const {
    return std::max({aims_ahead, Rational(Rational(7, 5) * speed_ / gain),
                     Rational(2 * speed_ * (acts_ + oldest(kind_.position)))});
  }
  [[nodiscard]] Rational turn_ends() const {
    return std::max(turn_end, Rational(Rational(5, 2) * errors()));
  }
  [[nodiscard]] Rational gain() const {
    return std::min(free_gain(), Rational(turns() / std::max(turn_begin, Rational(5 * errors()))));
  }
  [[nodiscard]] Rational turns() const { return std::min(turn_most, declared(kind_.motion.turn)); }
  [[nodiscard]] Rational turn_per_rad() const {
    if (!wheels_) return 0;
    return std::max(Rational(Rational(12'733, 10'000) / gain()), Rational(1 / turns()));
  }

  const sema::RobotKind& kind_;
  const bool wheels_;
  const Rational speed_, period_, acts_;
  Rational delay_, settling_, taken_, steers_, brakes_;
};

}  // namespace

namespace {

// Of the last step of a recovery, in what the kernel counts with, mm/s.
std::optional<Travel> travel_of(const sema::RobotKind& kind, const sema::Decision& decision,
                                const std::vector<sema::Template>& steps) {
  const auto speed = steps.empty() ? std::nullopt : sema::speed_of(steps.back());
  if (!speed) return std::nullopt;
  const Travel travel(kind, decision, Rational(ceil_to_int(Rational(*speed * 1000))) / 1000);
  return travel.gets_on() ? std::optional(travel) : std::nullopt;
}

}  // namespace

bool makes_way(const sema::RobotKind& kind, const sema::Decision& decision,
               const sema::Controller& recovery) {
  return std::ranges::all_of(sema::templates_of(recovery), [&](const sema::Template& step) {
    return !sema::speed_of(step) || travel_of(kind, decision, {step});
  });
}

bool follows_its_hold(const sema::RobotKind& kind, const sema::Decision& decision,
                      const sema::Controller& recovery) {
  if (!kind.in_space) return true;
  const std::vector<sema::Template> steps = sema::templates_of(recovery);
  return std::all_of(steps.begin(), steps.end(), [&](const sema::Template& step) {
    const auto speed = sema::speed_of(step);
    return !speed || Travel(kind, decision, *speed).follows();
  });
}

std::optional<Rational> leaving_seconds(const sema::RobotKind& kind, const sema::Decision& decision,
                                        const sema::Controller& recovery, const Rational& way) {
  const auto travel = travel_of(kind, decision, sema::templates_of(recovery));
  if (kind.in_space) return std::nullopt;  // its legs are no legs of the plane
  constexpr int legs = 3;
  return travel ? std::optional(travel->seconds_of_legs(way, legs)) : std::nullopt;
}

Rational beside_way(const sema::RobotKind& kind, const sema::Decision& decision,
                    const Rational& speed) {
  const Travel travel(kind, decision, speed);
  if (!travel.steers()) return beside_least;
  return travel.has_wheels() ? travel.wheels_beside() : travel.beside();
}

double ends_within(const sema::RobotKind& kind, const sema::Decision& decision) {
  return Travel(kind, decision, 0).ends_within();
}

std::optional<Rational> beside_leg(const sema::RobotKind& kind, const sema::Decision& decision,
                                   const sema::Controller& recovery) {
  const auto travel = travel_of(kind, decision, sema::templates_of(recovery));
  return travel && !travel->has_wheels() ? std::optional(travel->beside()) : std::nullopt;
}

Rational joined_way(const Rational& way, const Rational& cell) {
  return way + std::max(Rational(2, 5), Rational(2 * cell)) + cell;
}

namespace {

// It is seen for 50 ms, and a period before and after (language rule 10).
Rational seen_for(const sema::Decision& decision) {
  return (Rational(static_cast<long>(dwell_ticks(decision))) + 2) * decision.period->value;
}

// What comes before and after it has driven.
Rational around_seconds(const Travel& travel, const sema::Decision& decision,
                        const sema::Controller& recovery, const sema::Template& last) {
  Rational sum = 0;
  if (!std::holds_alternative<sema::Route>(last)) sum += travel.run_out_seconds();
  if (const auto* sequence = std::get_if<sema::Sequence>(&recovery.implementation)) {
    for (const auto& step : sequence->steps) sum += declared(step.lasts);
  }
  return sum + seen_for(decision);
}

}  // namespace

Stop stop_of(const sema::RobotKind& kind, const sema::Decision& decision) {
  const Travel travel(kind, decision, 0);
  return {travel.stop_seconds() + seen_for(decision), travel.stop()};
}

std::optional<Rational> leg_seconds(const sema::RobotKind& kind, const sema::Decision& decision,
                                    const sema::Controller& recovery, const Rational& leg) {
  const std::vector<sema::Template> steps = sema::templates_of(recovery);
  const auto travel = travel_of(kind, decision, steps);
  if (!travel || kind.in_space) return std::nullopt;
  return travel->seconds_of_legs(leg, 1) +
         around_seconds(*travel, decision, recovery, steps.back());
}

std::optional<Rational> return_seconds(const sema::RobotKind& kind, const sema::Decision& decision,
                                       const sema::Controller& recovery, const Rational& cell,
                                       const Rational& way) {
  const std::vector<sema::Template> steps = sema::templates_of(recovery);
  const auto travel = travel_of(kind, decision, steps);
  if (!travel) return std::nullopt;
  const Rational joined = joined_way(way, cell);
  const auto driven = kind.in_space ? travel->carried_seconds(joined, cell)
                                    : std::optional(travel->seconds(joined, cell));
  if (!driven) return std::nullopt;
  return *driven + around_seconds(*travel, decision, recovery, steps.back());
}

std::optional<Rational> legs_seconds(const sema::RobotKind& kind, const sema::Decision& decision,
                                     const sema::Controller& recovery, const Rational& cell,
                                     const Rational& way, int legs, int looks) {
  const std::vector<sema::Template> steps = sema::templates_of(recovery);
  const auto travel = travel_of(kind, decision, steps);
  if (!travel || kind.in_space || legs > waypoints) return std::nullopt;
  return travel->seconds_of_legs(joined_way(way, cell), legs, looks) +
         around_seconds(*travel, decision, recovery, steps.back());
}

std::optional<Rational> priced_seconds(const sema::RobotKind& kind, const sema::Decision& decision,
                                       const Rational& speed, const Rational& cell,
                                       const Rational& way) {
  const Travel travel(kind, decision, Rational(ceil_to_int(Rational(speed * 1000))) / 1000);
  return travel.gets_on() ? std::optional(travel.seconds(way, cell)) : std::nullopt;
}

std::optional<Rational> driven_metres(const sema::RobotKind& kind, const sema::Decision& decision,
                                      const sema::Controller& recovery,
                                      const std::optional<Rational>& cell, const Rational& way,
                                      const Rational& after) {
  const std::vector<sema::Template> steps = sema::templates_of(recovery);
  const auto travel = travel_of(kind, decision, steps);
  if (!travel) return std::nullopt;
  Rational driven = cell ? joined_way(way, *cell) : way;
  if (!std::holds_alternative<sema::Route>(steps.back())) driven += travel->run_out();
  if (std::holds_alternative<sema::Loiter>(steps.back())) {
    driven += travel->fastest() * (seen_for(decision) + after);
  }
  if (const auto* sequence = std::get_if<sema::Sequence>(&recovery.implementation)) {
    for (const auto& step : sequence->steps) {
      const auto speed = sema::speed_of(step.what);
      if (!step.lasts || !speed || *speed <= 0) continue;
      const Travel before(kind, decision, Rational(ceil_to_int(Rational(*speed * 1000))) / 1000);
      if (!before.gets_on()) return std::nullopt;
      driven += before.fastest() * step.lasts->value + before.run_out();
    }
  }
  return driven;
}

}  // namespace rtac::recheck
