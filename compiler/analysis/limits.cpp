#include "compiler/analysis/limits.h"

#include <algorithm>

#include "compiler/analysis/reach.h"
#include "compiler/analysis/travel.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::analysis {
namespace {

// A hold keeps within twice the position error and this, in mm (latched position, see the pilots).
constexpr std::int64_t hold_slack_mm = 10;

std::int64_t up(const Rational& si, int per_unit) {
  return ceil_to_int(Rational(si * per_unit));
}
std::int64_t down(const Rational& si, int per_unit) {
  return floor_to_int(Rational(si * per_unit));
}
std::int64_t micros(const Rational& seconds) {
  return up(seconds, 1'000'000);
}
// Ceiling of the square root of a non-negative integer.
std::int64_t root_up(std::int64_t value) {
  mpz_class root = sqrt(mpz_class(static_cast<long>(value)));
  while (root * root < static_cast<long>(value)) ++root;
  return root.get_si();
}
std::int64_t div_up(std::int64_t a, std::int64_t b) {
  return (a + b - 1) / b;
}

// Of a recovery: beside its leg, and corners are cut by as much as counts for being there.
std::int64_t tracking_of_recovery_mm(const ir::Body& b, const ir::Motion& motion) {
  return b.in_space ? motion.beside_mm : std::max(motion.beside_mm, b.end_reach_mm);
}
// Acceleration of the reference point when the speed is at most `speed`: driving and turning, or,
// of a point mass, what any controller commands and what pushes it. A point mass that slows down as
// hard as its brake may do so sideways, too; wheels brake along the way.
std::int64_t planar_accel(const sema::RobotKind& kind, const Rational& along,
                          std::int64_t speed_mmps) {
  if (!kind.motion.turn) {
    return up(std::max(along, kind.motion.brake.value) + disturbance_of(kind), 1000);
  }
  const std::int64_t accel = up(along, 1000);
  const std::int64_t lateral = div_up(speed_mmps * up(kind.motion.turn->value, 1000), 1000);
  return root_up(accel * accel + lateral * lateral);
}
std::int64_t planar_accel(const sema::RobotKind& kind) {
  return planar_accel(kind, kind.motion.accel.value, up(kind.motion.speed.value, 1000));
}
// By which a velocity may have changed between two stamps, braking included.
std::int64_t planar_change(const sema::RobotKind& kind) {
  return planar_accel(kind, std::max(kind.motion.accel.value, kind.motion.brake.value),
                      up(kind.motion.speed.value, 1000));
}

// The frequency at which a position error takes its share of the brake, rounded down, rad/s.
Rational quiet_spring(const ir::Body& b, std::int64_t left_mmps2) {
  constexpr long per_radps = 1'000'000;
  const Rational square(left_mmps2, pace::hold_brake_shares * b.position_error_mm);
  const mpz_class scaled = square.get_num() * per_radps * per_radps / square.get_den();
  return Rational(mpz_class(sqrt(scaled)), mpz_class(per_radps));
}

// How the latched hold of a point mass moves: a spring and a critical damper, from measurements
// that err, against what pushes. Its response to a push is never negative, with the delay that its
// frequency leaves room for too, so that errors that stay do most: a position error moves it by
// itself, a velocity error by 2 / omega of it, a push by 1 / omega^2 of it. It is latched at
// eta b / (b - d) as measured (see the pilots) and so at the velocity error more, at most; from
// such a speed it goes on by 1 / (e omega), a little less with the target ahead of it, and by half
// of the delay.
struct Hold {
  std::int64_t sways_mm, strays_mm;  // about its place, at rest; and from where it latches
  // From one end of what it sways to the other: who promises to stay may be at the one when it is
  // measured, and at the other ever after.
  std::int64_t spans_mm;
};
Hold hold_of(const ir::Body& b, std::int64_t delay_us) {
  const Rational delay_s(delay_us, 1'000'000);
  const std::int64_t left_mmps2 = b.brake_mmps2 - b.disturbance_mmps2;
  const Rational omega = hold_frequency(b, delay_us);
  const Rational eta = b.velocity_error_mmps + (b.brake_mmps2 + b.disturbance_mmps2) * delay_s;
  const Rational latched = b.velocity_error_mmps + eta * b.brake_mmps2 / left_mmps2;
  const Rational sways = 2 * b.velocity_error_mmps / omega + b.disturbance_mmps2 / (omega * omega);
  const Rational moved = latched * (Rational(7, 25) / omega + delay_s / 2) + sways;
  const std::int64_t errs_mm = 2 * b.position_error_mm + hold_slack_mm;
  return {ceil_to_int(sways) + errs_mm, ceil_to_int(moved) + errs_mm,
          ceil_to_int(Rational(2 * sways)) + errs_mm};
}

// Who turns aside by eta where nothing pushes bends by half of what is lost of the speed, and by
// more of eta^2 / b (lemma sampled_brake): less, all in all, for who is much faster than eta.
constexpr int calm_eta_shares = 11, calm_eta_parts = 5;
bool bends_by_half(const sema::RobotKind& kind, std::int64_t period_us) {
  // A first command may go by a velocity from before the take-over. With more than the brake, that
  // is wrong by more than eta, and what half of the bound leaves no room for.
  if (disturbance_of(kind) != 0 || kind.motion.accel.value > kind.motion.brake.value) return false;
  Rational delay_s = Rational(period_us, 1'000'000) + kind.latency.value;
  Rational eta = 0;
  if (kind.velocity) {
    eta = kind.velocity->error.value;
    delay_s += kind.velocity->max_age.value;
  }
  eta += kind.motion.brake.value * delay_s;
  // eta s / 2 + 11/5 eta^2 <= eta s + eta^2 at the greatest speed s
  return kind.motion.speed.value * calm_eta_parts >= 2 * (calm_eta_shares - calm_eta_parts) * eta;
}

// Lemma sampled_brake, eta = e_v + b (h + l): rho_sc = eta s / b + eta^2 / b + rho_h, or with half
// of eta s. The lag runs from the measurement on, so that the age of the sample is part of it. What
// pushes the robot at d changes its speed in the meantime, and leaves b - d to brake with.
void add_sampled_brake(const sema::RobotKind& kind, std::int64_t period_us, ir::Body& b) {
  const std::int64_t d_mmps2 = b.disturbance_mmps2, left_mmps2 = b.brake_mmps2 - d_mmps2;
  if (left_mmps2 <= 0) return;  // reported
  const std::int64_t delay_us = b.velocity_age_us + period_us + b.jitter_us + b.latency_us;
  const std::int64_t eta =
      b.velocity_error_mmps + div_up((b.brake_mmps2 + d_mmps2) * delay_us, 1'000'000);
  const bool half = bends_by_half(kind, period_us);
  b.brake_late_ms = div_up(1000 * eta, left_mmps2);
  b.brake_lag_ms = half ? div_up(1000 * eta, 2 * left_mmps2) : b.brake_late_ms;
  const Hold hold = hold_of(b, delay_us);
  b.hold_mm = (half ? div_up(calm_eta_shares * eta * eta, calm_eta_parts * left_mmps2)
                    : div_up(eta * eta, left_mmps2)) +
              hold.strays_mm;
  if (kind.hears_max_age) b.hold_mm = std::max(b.hold_mm, hold.spans_mm);
  b.sway_mm = hold.sways_mm;
  if (b.in_space) b.end_reach_mm = b.sway_mm;
  // latched at eta b / (b - d) as measured, and then as errors and pushes move it
  b.stands_mmps = std::max(div_up(b.brake_late_ms * b.brake_mmps2, 1000) + b.velocity_error_mmps,
                           hold_speed_mmps(b, period_us));
}

}  // namespace

Rational hold_frequency(const ir::Body& b, std::int64_t delay_us) {
  const Rational loop_s(
      std::max<std::int64_t>(delay_us + b.position_age_us, pace::hold_delay_least_us), 1'000'000);
  const std::int64_t left_mmps2 = b.brake_mmps2 - b.disturbance_mmps2;
  Rational omega = std::min(Rational(pace::hold_max_mradps, 1000),
                            Rational(Rational(pace::hold_mrad_per_delay, 1000) / loop_s));
  const Rational quiet(left_mmps2,
                       pace::hold_brake_shares * std::max<std::int64_t>(b.velocity_error_mmps, 1));
  omega = std::min(omega, quiet);
  if (b.position_error_mm > 0) omega = std::min(omega, quiet_spring(b, left_mmps2));
  return omega;
}

ir::Body body_of(const sema::RobotKind& kind, std::int64_t period_us, std::int64_t jitter_us) {
  ir::Body b;
  b.jitter_us = jitter_us;
  b.in_space = kind.in_space;
  b.radius_mm = up(kind.radius.value, 1000);
  // What the body gets larger by on the grid, it may also be nearer: an upper end of a distance
  // takes the radius off, too.
  const Rational larger = Rational(b.radius_mm, 1000) - kind.radius.value;
  b.position_error_mm = kind.position ? up(Rational(kind.position->error.value + larger), 1000) : 0;
  b.velocity_error_mmps = kind.velocity ? up(kind.velocity->error.value, 1000) : 0;
  b.accel_mmps2 = planar_change(kind);
  b.brake_mmps2 = down(kind.motion.brake.value, 1000);
  b.disturbance_mmps2 = up(disturbance_of(kind), 1000);
  b.latency_us = micros(kind.latency.value);
  if (kind.output_error) {
    b.command_mmps2 = up(kind.motion.accel.value, 1000);
    // 2: a command off the grid
    b.command_error_mmps2 = up(disturbance_of(kind), 1000) + 2;
  }
  if (kind.position) b.position_age_us = micros(kind.position->max_age.value);
  if (kind.heading) b.heading_age_us = micros(kind.heading->max_age.value);
  if (kind.velocity) b.velocity_age_us = micros(kind.velocity->max_age.value);
  if (kind.hears_max_age) b.hears_age_us = micros(kind.hears_max_age->value);
  if (kind.plan) b.tracking_mm = up(kind.plan->tracking.value, 1000);
  if (kind.battery) {
    b.battery_error_ppm = up(kind.battery->error.value, 1'000'000);
    b.battery_age_us = micros(kind.battery->max_age.value);
  }
  if (kind.energy) {
    b.drain_ppm_per_s = up(kind.energy->drain.value, 1'000'000);
  }
  if (kind.motion.model == sema::MotionModel::unicycle) {
    // theory, unicycle: the base obeys speed 0 and turn 0 at once, limited by its own brake; while
    // the turn rate runs down, the path bends away from the straight stop.
    const Rational lag = kind.motion.turn_accel
                             ? Rational(kind.motion.turn->value * kind.motion.turn->value /
                                        kind.motion.turn_accel->value)
                             : Rational(2);  // undeclared: the most that the bound can be
    b.brake_lag_permille = std::min<std::int64_t>(2000, up(lag, 1000));
    b.hold_mm = hold_slack_mm;
  } else {
    add_sampled_brake(kind, period_us, b);
  }
  if (!b.in_space) b.end_reach_mm = end_reach_mm(kind, period_us);
  return b;
}

// A recovery may be led along a wall as near as it has come to rest there: its legs lose none of
// that clearance, which what steering leaves beside them would take. By its least they come nowhere
// near a wall with what the tube of the brake has to spare.
//
// A hold that is carried comes to rest beside its leg only where it is stopped, and is led back
// from there. Zones with heights are looked at by the clearance that is left, piece by piece; of a
// limit of height that says nothing.
void keep_off_walls(const sema::Spec& spec, const sema::Decision& from, const sema::RobotKind& kind,
                    ir::Decision& d) {
  if (from.on_plan) return;
  const bool limits_height = std::ranges::any_of(
      from.priority, [&](sema::MonitorId id) { return sema::speaks_of_height(*spec[id].always); });
  for (const sema::MonitorId id : from.priority) {
    if (!spec[id].recover) continue;
    for (const sema::Template& what : sema::templates_of(spec[*spec[id].recover])) {
      const auto speed = sema::speed_of(what);
      if (!speed) continue;
      if (kind.in_space) {
        const auto moves = sema::moves_of(what);
        if (!moves || (spec[moves->zone].has_height && !limits_height)) continue;
        d.body.hold_mm = std::max(d.body.hold_mm, stray_mm(d.body, *speed, d.period_us));
        continue;
      }
      const std::int64_t more_mm = beside_mm(kind, *speed, d.period_us) - beside_least_mm;
      d.body.hold_mm = std::max(d.body.hold_mm, more_mm + hold_slack_mm);
    }
  }
}

ir::Motion any_control(const sema::RobotKind& kind) {
  const std::int64_t speed = up(kind.motion.speed.value, 1000);
  return {"any", speed, planar_accel(kind), false, kind.motion.range};
}

ir::Motion recovery_motion(const sema::RobotKind& kind, const ir::Body& body,
                           const std::string& name, const Rational& speed, std::int64_t period_us) {
  const std::int64_t pushed_mmps = up(pushed_speed(kind, period_us), 1000);
  // what stands is held, which the hold accounts for
  const std::int64_t most_mmps =
      speed == 0 ? 2 * pushed_mmps : fastest_mmps(body, pushed_mmps, period_us, up(speed, 1000));
  // while it brakes, the recovery may still turn at the speed that it found
  return {name,
          std::min(up(kind.motion.speed.value, 1000), most_mmps),
          planar_accel(kind),
          true,
          kind.motion.range,
          beside_mm(kind, speed, period_us)};
}

// What the stop bends from the straight one, what errors of the hold lead it aside by while it
// stops, and its sway (Carried::stray_m).
std::int64_t stray_mm(const ir::Body& b, const Rational& speed, std::int64_t period_us) {
  const Rational brake(static_cast<long>(b.brake_mmps2)),
      pushed(static_cast<long>(b.disturbance_mmps2));
  if (brake <= pushed) return 0;  // reported
  const Rational error(static_cast<long>(b.velocity_error_mmps));
  const Rational late(static_cast<long>(b.velocity_age_us + period_us + b.latency_us), 1'000'000);
  const Rational s = speed * 1000 + error;
  const Rational eta = error + (brake + pushed) * late;
  const Rational bend = (eta * (s + eta) + pushed * s * s / (2 * brake)) / (brake - pushed);
  const Rational hold(pace::hold_max_mradps, 1000);
  const Rational aside = 2 * (hold * static_cast<long>(b.position_error_mm) + error);
  return ceil_to_int(Rational(bend + aside * s / (2 * brake))) + b.sway_mm;
}

// What errs and pushes moves the hold as the velocity of a critically damped spring follows a
// force: by its bound over the frequency, times the integral of the magnitude of the response to an
// impulse. That is 2 / e without a delay, and 0.982 with the most that the frequency leaves room
// for.
std::int64_t hold_speed_mmps(const ir::Body& b, std::int64_t period_us) {
  if (b.brake_mmps2 <= b.disturbance_mmps2) return 0;  // reported
  const Rational omega = hold_frequency(b, b.velocity_age_us + period_us + b.latency_us);
  const Rational least = hold_frequency(b, b.velocity_age_us + period_us + b.jitter_us +
                                               b.latency_us);  // of one that knows its jitter
  return ceil_to_int(Rational(99, 100) * (omega * b.position_error_mm + 2 * b.velocity_error_mmps +
                                          b.disturbance_mmps2 / least));
}

namespace {

// How far the velocity of a point mass overshoots, in ppm of a step of what it follows. It settles
// with a delay, half as long as it takes at most: x' = -k x(t - 1), of which k up to 1 / e passes
// nothing, and k = 1/2 by 4.24 %. The parabola is above what lies between.
std::int64_t overshoot_ppm(const ir::Body& b, std::int64_t period_us) {
  constexpr std::int64_t most_ppm = 45'000, none_ppm = 370'000, half_ppm = 500'000;
  const std::int64_t delay_us = b.velocity_age_us + period_us + b.latency_us;
  const std::int64_t settling_us =
      std::max<std::int64_t>(1000 * pace::velocity_time_ms, pace::velocity_time_delays * delay_us);
  const Rational beyond =
      Rational(delay_us * 1'000'000, settling_us) - Rational(static_cast<long>(none_ppm));
  if (beyond <= 0) return 0;
  const Rational share = beyond / static_cast<long>(half_ppm - none_ppm);
  return ceil_to_int(Rational(share * share * static_cast<long>(most_ppm)));
}

}  // namespace

// One whose speed is commanded follows that within its limits, twice what pushes have made it
// faster by when its velocity has settled. A point mass measures it: in the plane it settles where
// errors of its velocity and pushes let it, and overshoots that, by twice where they turn around;
// in space it follows its hold. Before it sets out and at its end it holds its place, which errors
// and pushes move: one that latches at less than that is never faster (docs/lemmas.md, speed).
std::int64_t fastest_mmps(const ir::Body& b, std::int64_t pushed_mmps, std::int64_t period_us,
                          std::int64_t w_mmps) {
  const std::int64_t faster_mmps = w_mmps + 2 * pushed_mmps;
  if (b.brake_late_ms == 0) return faster_mmps;
  const std::int64_t holds_mmps = hold_speed_mmps(b, period_us);
  if (b.in_space) return std::max(faster_mmps + b.velocity_error_mmps, w_mmps + holds_mmps);
  const std::int64_t lasts_mmps = b.velocity_error_mmps + pushed_mmps;
  const Rational over(
      Rational(static_cast<long>(overshoot_ppm(b, period_us) * (w_mmps + 2 * lasts_mmps))) /
      1'000'000);
  return std::max(
      {faster_mmps + b.velocity_error_mmps, w_mmps + lasts_mmps + ceil_to_int(over), holds_mmps});
}

std::int64_t return_clearance_mm(const ir::Decision& decision, std::int64_t lookahead_us) {
  const ir::Body& b = decision.body;
  const std::int64_t t_us = horizon_us_max(b, lookahead_us) + decision.return_extra_us;
  // Who rests there is measured there, and the decision sees a measurement to a millimetre: without
  // an error of its own a recovery would rest where it may never be given back.
  constexpr std::int64_t seen_mm = 2;
  return disc_mm(b, decision.motions[0], b.velocity_error_mmps + apart_mmps(b), t_us) +
         std::max(b.position_error_mm, seen_mm);
}

std::int64_t claim_clearance_mm(const ir::Decision& decision, const ir::Motion& motion,
                                std::int64_t lookahead_us) {
  const ir::Body& b = decision.body;
  return disc_mm(b, motion, b.velocity_error_mmps + apart_mmps(b),
                 horizon_us_max(b, lookahead_us)) +
         b.position_error_mm;
}

std::int64_t cruise_clearance_mm(const ir::Decision& decision, const ir::Motion& motion,
                                 std::int64_t lookahead_us) {
  const std::int64_t t_us = horizon_us_max(decision.body, lookahead_us);
  return disc_mm(decision.body, motion, motion.speed_mmps + decision.body.velocity_error_mmps,
                 t_us) +
         decision.body.position_error_mm +
         (motion.recovery ? tracking_of_recovery_mm(decision.body, motion) : 0);
}

std::int64_t standoff_mm(const ir::Decision& decision, const ir::Recovery& recovery) {
  std::int64_t longest_us = 0;
  for (const ir::Monitor& m : decision.monitors) {
    longest_us = std::max(longest_us, m.lookahead.duration_us);
  }
  const auto own =
      std::find_if(decision.motions.begin(), decision.motions.end(),
                   [&](const ir::Motion& m) { return m.recovery && m.name == recovery.name; });
  return recovery.route_clearance_mm - cruise_clearance_mm(decision, *own, longest_us);
}

std::int64_t beside_leg_mm(const ir::Decision& decision, const ir::Recovery& recovery) {
  std::int64_t most = 0;
  for (const ir::Motion& m : decision.motions) {
    if (!m.recovery || m.name != recovery.name) continue;
    most = std::max(most, tracking_of_recovery_mm(decision.body, m));
  }
  return decision.body.position_error_mm + most;
}

std::int64_t off_hold_mm(const ir::Body& b) {
  return b.sway_mm > 0 ? b.sway_mm : 2 * b.position_error_mm + hold_slack_mm;
}

// A point mass latches where the rest of the speed ends that it is measured to have, at most the
// one at which its hold takes over, and half of what it reacts in (halt of its pilot).
std::int64_t latched_off_mm(const ir::Body& b, std::int64_t period_us) {
  if (b.sway_mm == 0) return b.position_error_mm + hold_slack_mm;
  const std::int64_t rests_mmps = div_up(b.brake_late_ms * b.brake_mmps2, 1000);
  const std::int64_t reacts_us = b.velocity_age_us + period_us + b.latency_us;
  return std::min(b.sway_mm, b.position_error_mm + div_up(rests_mmps * reacts_us, 2 * 1'000'000));
}

std::int64_t given_back_mm(const ir::Decision& decision, std::int64_t lookahead_us,
                           std::int64_t apart_mm) {
  const ir::Body& b = decision.body;
  const std::int64_t rounding_mm = b.in_space ? 7 : 4;  // of both samples, and of the distance
  return apart_mm + return_clearance_mm(decision, lookahead_us) + b.radius_mm +
         2 * b.position_error_mm + b.hold_mm + 2 * off_hold_mm(b) + rounding_mm;
}

// Who makes room goes on until both may be given back where they hold.
std::int64_t pass_gap_mm(const ir::Decision& decision, std::int64_t lookahead_us,
                         std::int64_t standoff_mm) {
  const ir::Body& b = decision.body;
  const std::int64_t t_us = horizon_us_max(b, lookahead_us) + decision.return_extra_us;
  const std::int64_t mover =
      disc_mm(b, decision.motions[0], decision.motions[0].speed_mmps, t_us) + b.position_error_mm;
  const std::int64_t held = 2 * b.position_error_mm + 2 + b.hold_mm + b.radius_mm;
  const std::int64_t legs = 2 * b.radius_mm + 4 * b.position_error_mm + b.tracking_mm + b.hold_mm;
  std::int64_t tracking_mm = 0;
  for (const ir::Motion& m : decision.motions) {
    if (m.recovery) tracking_mm = std::max(tracking_mm, tracking_of_recovery_mm(b, m));
  }
  const std::int64_t passing = std::max(mover + held, legs) + standoff_mm + tracking_mm;
  return std::max(passing,
                  given_back_mm(decision, lookahead_us, standoff_mm) - b.position_error_mm);
}

std::int64_t still_mmps(const ir::Body& b) {
  constexpr std::int64_t corner_mmps = 2;  // of a sample off the grid, which lengthens it
  return b.velocity_error_mmps + corner_mmps + apart_mmps(b);
}

std::int64_t shown_clearance_mm(const ir::Decision& decision, const ir::Motion& motion,
                                std::int64_t least_mm) {
  const ir::Body& b = decision.body;
  // twice the position error, as it is measured and as it is judged. Of a sample off the grid the
  // width, 2 mm in the plane and 3 mm in space, and how far its corner is from it, the roots of
  // these; 2: the resolution of the kernel's gap
  return least_mm + b.radius_mm + 2 * b.position_error_mm + (b.in_space ? 7 : 6) +
         way_mm(b, motion, still_mmps(b), b.position_age_us);
}

// As the kernel counts (kernel/motion.c, kernel/speed.c): beside what it is measured to have, the
// error counts once more, with the width of a sample off the grid on each axis; and it may have
// gained speed since the position was measured. Never more than the cap of the recovery, unless it
// is measured to be faster.
std::int64_t shown_speed_mmps(const ir::Decision& decision, const ir::Motion& motion) {
  const ir::Body& b = decision.body;
  const std::int64_t width_mmps = b.in_space ? 3 : 2;
  const auto gained = [](std::int64_t accel_mmps2, std::int64_t us) {
    return div_up(accel_mmps2 * div_up(us, 1000), 1000);
  };
  const std::int64_t seen_mmps = still_mmps(b) + b.velocity_error_mmps + width_mmps;
  return std::min(std::max(motion.speed_mmps, seen_mmps),
                  seen_mmps + gained(motion.accel_mmps2, b.position_age_us));
}

std::int64_t shown_full_ppm(const ir::Body& body) {
  // 1: a sample off the grid
  return 1'000'000 - 2 * body.battery_error_ppm - 1 -
         div_up(body.drain_ppm_per_s * div_up(body.battery_age_us, 1000), 1000);
}

}  // namespace rtac::analysis
