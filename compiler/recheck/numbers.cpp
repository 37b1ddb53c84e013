#include "compiler/recheck/numbers.h"

#include <algorithm>

#include "compiler/interp/number.h"
#include "compiler/recheck/travel.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

Rational value(const std::optional<sema::Quantity>& q) {
  return q ? q->value : Rational(0);
}

// Of the latched hold of a point mass (docs/templates.md, the brake that all of them begin with):
// how far it may rest from its place, and from where it was latched.
// And how fast it may be.
struct Hold {
  Rational sways, strays, speed, latched;
};
constexpr long hold_most_radps = 2;
Hold hold_of(const Numbers& n, const Rational& delay) {
  const Rational left = n.brake - n.disturbance;
  const Rational loop = std::max(Rational(delay + n.position_age), Rational(1, 100));
  Rational omega = std::min(Rational(hold_most_radps), Rational(Rational(1, 4) / loop));
  if (n.velocity_error > 0) omega = std::min(omega, Rational(left / (4 * n.velocity_error)));
  // and its square: a root from above, so that what is asked for is not more than it takes
  if (n.position_error > 0) {
    const Rational square = left / (4 * n.position_error);
    if (omega * omega > square) omega = interp::square_root(square).above;
  }
  const Rational eta = n.velocity_error + (n.brake + n.disturbance) * delay;
  const Rational latched = n.velocity_error + eta * n.brake / left;
  const Rational sways =
      2 * n.position_error + 2 * n.velocity_error / omega + n.disturbance / (omega * omega);
  // as a velocity follows what acts on it
  const Rational follows =
      Rational(98, 100) * (omega * n.position_error + 2 * n.velocity_error + n.disturbance / omega);
  return {sways, sways + latched * (Rational(7, 25) / omega + delay / 2), follows, latched};
}

// What grids, rounding and offsets known from inside only may add to a hold (docs/templates.md).
const Rational slack(1, 100);

// Off its leg, in space, where a hold that is carried is stopped: the stop bends, errors of the
// hold lead it aside meanwhile, and then it sways.
Rational stopped_beside(const Numbers& n, const Rational& speed) {
  const Rational s = speed + n.velocity_error;
  const Rational eta =
      n.velocity_error + (n.brake + n.disturbance) * (n.velocity_age + n.period + n.latency);
  const Rational bend =
      (eta * (s + eta) + n.disturbance * s * s / (2 * n.brake)) / (n.brake - n.disturbance);
  const Rational errs = 2 * (hold_most_radps * n.position_error + n.velocity_error);
  return bend + errs * s / (2 * n.brake) + n.sway;
}

// A recovery may be led along a wall as near as it has come to rest there. What steering leaves
// beside its leg, beyond what the tube of the brake has to spare, is room of the hold.
Rational led_beside(const sema::Spec& spec, const sema::Decision& decision, const Numbers& n) {
  const sema::RobotKind& kind = spec[decision.kind];
  Rational most = 0;
  if (decision.on_plan) return most;
  const bool limits_height = std::ranges::any_of(decision.priority, [&](sema::MonitorId id) {
    return sema::speaks_of_height(*spec[id].always);
  });
  for (const sema::MonitorId id : decision.priority) {
    if (!spec[id].recover) continue;
    for (const sema::Template& what : sema::templates_of(spec[*spec[id].recover])) {
      const auto speed = sema::speed_of(what);
      const auto moves = sema::moves_of(what);
      if (!speed) continue;
      if (!kind.in_space) {
        most = std::max(most, Rational(beside_way(kind, decision, *speed) - beside_least));
      } else if (moves && (!spec[moves->zone].has_height || limits_height)) {
        most = std::max(most, stopped_beside(n, *speed));
      }
    }
  }
  return most;
}

}  // namespace

Rational least_ahead(const sema::Spec& spec, const sema::Decision& decision,
                     const sema::Monitor& monitor) {
  const bool external = monitor.recover && sema::templates_of(spec[*monitor.recover]).empty();
  return value(decision.period) * (external ? 2 : 1);
}

Rational jitter_of(const sema::Spec& spec, const sema::Decision& decision) {
  if (decision.jitter || !decision.period) return value(decision.jitter);
  constexpr long us_per_s = 1'000'000;
  Rational share(floor_to_int(Rational(decision.period->value * us_per_s / 10)), us_per_s);
  share.canonicalize();
  Rational jitter = 0;
  for (const sema::MonitorId id : decision.priority) {
    const sema::Monitor& m = spec[id];
    if (!m.ahead.duration) return share;
    const Rational room = m.ahead.duration->value - least_ahead(spec, decision, m);
    if (room >= 0) jitter = std::max(jitter, Rational(share - room));
  }
  return jitter;
}

std::int64_t dwell_ticks(const sema::Decision& decision) {
  if (!decision.period) return 0;
  return ceil_to_int(Rational(Rational(1, 20) / decision.period->value));
}

Rational return_extra(const sema::Spec& spec, const sema::Decision& decision) {
  const Rational period = value(decision.period);
  const bool commands = std::ranges::any_of(
      decision.priority, [&](sema::MonitorId id) { return spec[id].ahead.command; });
  if (!commands) return period;
  return std::max(period, std::min(Rational(4 * period), Rational(1, 5)));
}

namespace {

// Where nothing changes a velocity more than the brake does, a tube takes half of eta for more of
// its square, if that is less at the greatest speed; as on time, so that how late a step may be
// makes no difference to which of them it is.
bool bends_by_half(const Numbers& n, const Rational& delay) {
  const Rational on_time = n.velocity_error + n.brake * (delay - n.jitter);
  return n.accel == n.brake && on_time / 2 * n.speed >= on_time * on_time * 6 / 5;
}

// `half_of`: as another one does, whose numbers are not rounded.
Numbers limits_of(const sema::RobotKind& kind, const sema::Decision& decision,
                  const Rational& jitter, std::optional<bool> half_of = {}) {
  Numbers n;
  n.period = value(decision.period);
  n.jitter = jitter;
  n.radius = kind.radius.value;
  n.latency = kind.latency.value;
  if (kind.position) {
    n.position_error = kind.position->error.value;
    n.position_age = kind.position->max_age.value;
  }
  if (kind.velocity) {
    n.velocity_error = kind.velocity->error.value;
    n.velocity_age = kind.velocity->max_age.value;
  }
  n.speed = kind.motion.speed.value;
  n.brake = kind.motion.brake.value;
  n.disturbance = value(kind.motion.disturbance) + value(kind.output_error);
  n.unicycle = kind.motion.model == sema::MotionModel::unicycle;
  if (n.unicycle) {
    // theory, unicycle: A_eff^2 = A^2 + (V W)^2, and W / turn_accel is the time of the turn
    const Rational lateral = n.speed * value(kind.motion.turn);
    n.accel_square = kind.motion.accel.value * kind.motion.accel.value + lateral * lateral;
    // they slow down as hard as their brake, too
    const Rational along = std::max(kind.motion.accel.value, n.brake);
    n.change = interp::square_root(Rational(along * along + lateral * lateral)).below;
    n.bend = 2;
    if (kind.motion.turn_accel) {
      const Rational turn = value(kind.motion.turn);
      n.bend = std::min(n.bend, Rational(turn * turn / kind.motion.turn_accel->value));
    }
    return n;
  }
  n.accel = std::max(kind.motion.accel.value, n.brake) + n.disturbance;
  n.accel_square = n.accel * n.accel;
  n.change = n.accel;
  const Rational left = n.brake - n.disturbance;
  if (left <= 0) return n;
  const Rational delay = n.velocity_age + n.period + n.jitter + n.latency;
  const Rational eta = n.velocity_error + (n.brake + n.disturbance) * delay;
  n.half = half_of.value_or(bends_by_half(n, delay));
  const Hold hold = hold_of(n, delay);
  n.aside = n.half ? Rational(eta / (2 * left)) : Rational(eta / left);
  n.hold = (n.half ? Rational(11, 5) : Rational(1)) * eta * eta / left + hold.strays;
  n.sway = hold.sways;
  // who promises to stay is measured at one end of its sway and may be at the other ever after
  if (kind.hears_max_age) n.hold = std::max(n.hold, Rational(2 * (hold.sways - n.position_error)));
  n.stands = std::min(n.speed, hold.speed);
  n.latched = std::min(n.speed, hold.latched);
  return n;
}

}  // namespace

namespace {

Numbers with_hold(const sema::Spec& spec, const sema::Decision& decision, Numbers n) {
  if (n.brake > n.disturbance) {  // else no brake stops it
    n.hold = std::max(n.hold, led_beside(spec, decision, n)) + slack;
  }
  return n;
}
Rational rounded_up(const Rational& value, long steps) {
  Rational up(ceil_to_int(Rational(value * steps)), steps);
  up.canonicalize();
  return up;
}

}  // namespace

Numbers numbers_of(const sema::Spec& spec, const sema::Decision& decision, const Rational& jitter) {
  return with_hold(spec, decision, limits_of(spec[decision.kind], decision, jitter));
}

std::optional<Numbers> rounded_numbers_of(const sema::Spec& spec, const sema::Decision& decision,
                                          const Numbers& exact) {
  constexpr long milli = 1000, micro = 1'000'000;
  sema::RobotKind kind = spec[decision.kind];
  // a step more for what is rounded once it has been multiplied
  const Rational step(1, milli);
  if (kind.position) kind.position->error.value = rounded_up(exact.position_error, milli) + step;
  if (kind.velocity) kind.velocity->error.value = rounded_up(exact.velocity_error, milli) + step;
  Rational& brake = kind.motion.brake.value;
  brake = -rounded_up(Rational(-exact.brake), milli);
  if (exact.disturbance > 0) {
    kind.motion.disturbance = sema::Quantity{rounded_up(exact.disturbance, milli), {}};
    kind.output_error.reset();
  }
  const Rational jitter = rounded_up(exact.jitter, micro);
  const Numbers n = with_hold(spec, decision, limits_of(kind, decision, jitter, exact.half));
  if (n.brake <= n.disturbance) return std::nullopt;
  return n;
}

Rational pushed(const Numbers& n) {
  const Rational delay = n.latency + n.period + n.velocity_age;
  return 2 * n.disturbance * std::max(Rational(3, 10), Rational(2 * delay));
}

namespace {

// What a velocity that settles with a delay passes its end by, as a share of its step: nothing as
// long as the delay is 1/e of the time that it settles in, at most 4.24 % where it is half of that,
// and less in between than a parabola that ends at 4.5 %.
Rational passed_by(const Numbers& n) {
  const Rational delay = n.latency + n.period + n.velocity_age;
  const Rational beyond =
      delay / std::max(Rational(3, 10), Rational(2 * delay)) - Rational(37, 100);
  const Rational share = std::max(Rational(0), beyond) / Rational(13, 100);
  return Rational(45, 1000) * share * share;
}

}  // namespace

Rational fastest_driven(const Numbers& n, bool in_space, const Rational& speed) {
  if (n.unicycle) return speed + pushed(n);
  const Rational follows = speed + pushed(n) + n.velocity_error;
  // in space it follows a hold that is carried, which errs as one that stays does
  if (in_space) return std::max(follows, Rational(speed + n.stands));
  const Rational lasts = n.velocity_error + pushed(n) / 2;
  return std::max(follows, Rational(speed + lasts + passed_by(n) * (speed + 2 * lasts)));
}

namespace {

// Of the measured centre, when a way and a stop from the speed `last` are ahead.
Rational disc(const Numbers& n, const Rational& way, const Rational& last) {
  const Rational stop = last * last / (2 * (n.brake - n.disturbance));
  return n.position_error + way + stop * (1 + n.bend) + n.aside * last + n.hold + n.radius;
}
Rational horizon_of(const Numbers& n, const Rational& ahead) {
  return ahead + n.position_age + n.latency + n.jitter;
}

}  // namespace

Rational resting_clearance(const Numbers& n, const Rational& accel, const Rational& ahead) {
  const Rational horizon = horizon_of(n, ahead);
  const Rational apart = n.change * std::max(n.position_age, n.velocity_age);
  const Rational s0 = std::min(n.speed, Rational(2 * n.velocity_error + apart));
  const Rational unbounded = s0 + accel * horizon;
  Rational way = s0 * horizon + accel * horizon * horizon / 2;
  if (unbounded > n.speed) {
    way = n.speed * horizon - (n.speed - s0) * (n.speed - s0) / (2 * accel);
  }
  return disc(n, way, std::min(n.speed, unbounded)) + n.position_error;  // and is measured there
}

Rational cruising_clearance(const Numbers& n, const Rational& speed, const Rational& ahead) {
  const Rational seen = std::min(speed, n.speed) + 2 * n.velocity_error;
  return disc(n, seen * horizon_of(n, ahead), seen) + n.position_error;
}

Rational planar_accel(const Numbers& n) {
  return n.unicycle ? interp::square_root(n.accel_square).below : n.accel;
}

Rational driven_at_most(const Numbers& n, const sema::Controller& recovery) {
  Rational speed = 0;
  for (const sema::Template& what : sema::templates_of(recovery)) {
    if (const auto own = sema::speed_of(what)) speed = std::max(speed, *own);
  }
  if (sema::templates_of(recovery).empty()) {
    const auto claim = sema::claim_of(recovery);
    speed = claim ? claim->speed.value : n.speed;
  }
  return std::min(n.speed, Rational(speed + pushed(n)));
}

// Its velocity is measured to have its error, which counts once more. The stamps of both samples
// may lie apart, as far as either may be old.
Rational seen_at_rest(const Numbers& n) {
  return 2 * n.velocity_error + n.change * std::max(n.position_age, n.velocity_age);
}

Rational moved_at_rest(const Numbers& n, const Rational& drives) {
  const Rational first = seen_at_rest(n), accel = planar_accel(n), age = n.position_age;
  const Rational cap = std::max(drives, first), spare = cap - first;
  if (accel * age <= spare) return first * age + accel * age * age / 2;
  return cap * age - spare * spare / (2 * accel);
}

}  // namespace rtac::recheck
