// The limits of a decision once more, exactly, from what the specification declares (theory: the
// look-ahead against any control; docs/templates.md: the brake and the hold). SI units.
#pragma once

#include <optional>

#include "compiler/sema/spec.h"

namespace rtac::recheck {

struct Numbers {
  Rational period, radius, position_error, velocity_error, position_age, velocity_age, latency,
      jitter;
  Rational speed, accel, brake, disturbance;
  Rational accel_square;  // of unicycles, whose planar acceleration is a root
  Rational change;        // of the velocity, braking included; a root from below
  bool unicycle = false;
  // How far the sampled brake bends away, by a time at the speed that it begins with; and what is
  // left free for who holds a place, which of wheels is what grids and steering lead beside it.
  Rational aside, hold;
  Rational sway;      // how far from the place that it holds it may rest, as it measures itself
  Rational stands;    // how fast it may be there; 0 of wheels
  Rational latched;   // how fast it may be where its brake turns into that; 0 of wheels
  Rational bend;      // of unicycles: share of the stopping distance
  bool half = false;  // of the sampled brake: which of two tubes
};
Numbers numbers_of(const sema::Spec& spec, const sema::Decision& decision, const Rational& jitter);

// The same of what is declared in whole millimetres, and all of it to the safe side: no bound that
// is derived from such numbers is wider. nullopt: there is none, as such a brake stops nothing.
std::optional<Numbers> rounded_numbers_of(const sema::Spec& spec, const sema::Decision& decision,
                                          const Numbers& exact);

// The least that a monitor may look ahead: a period, two where its recovery is external (rule 9.1).
Rational least_ahead(const sema::Spec& spec, const sema::Decision& decision,
                     const sema::Monitor& monitor);
// How late a step may be: as declared, or else what a tenth of the period has beyond what the
// look-aheads have room for.
Rational jitter_of(const sema::Spec& spec, const sema::Decision& decision);

// How much further ahead than the check the test looks that gives control back: a period, and where
// commands are judged four of them, 200 ms at most and a period at least (language, ahead command).
Rational return_extra(const sema::Spec& spec, const sema::Decision& decision);
// Ticks that a return condition has to hold before control is given back, 50 ms (language rule 10);
// 0 where nothing is decided by the clock.
std::int64_t dwell_ticks(const sema::Decision& decision);

// By how much a robot is faster than its recovery means to be where something pushes it: its
// velocity follows with a time constant of two delays, 0.3 s at least (docs/templates.md).
Rational pushed(const Numbers& n);

// How fast a robot may be whose recovery means to drive at `speed`, above 0 (docs/lemmas.md,
// speed).
Rational fastest_driven(const Numbers& n, bool in_space, const Rational& speed);

// How much clearance of the measured centre lets a robot at rest be given back, when the test looks
// `ahead` s ahead from a sample as old as it may be: the disc, stop and hold included.
// `accel`: planar, at least.
Rational resting_clearance(const Numbers& n, const Rational& accel, const Rational& ahead);
// The same of one that drives at `speed`, which a look-ahead by the limits of its recovery passes,
// without what steering leaves beside its leg.
Rational cruising_clearance(const Numbers& n, const Rational& speed, const Rational& ahead);
// Of the reference point, without braking; a root from below: what is claimed rounds it up.
Rational planar_accel(const Numbers& n);
// How fast its recovery may drive, and how much faster it may get.
Rational driven_at_most(const Numbers& n, const sema::Controller& recovery);
// How fast a robot at rest may have been as its position was measured, as its velocity shows it.
Rational seen_at_rest(const Numbers& n);
// How far it may have driven since then, at `drives` at most or as fast as it seemed.
Rational moved_at_rest(const Numbers& n, const Rational& drives);

}  // namespace rtac::recheck
