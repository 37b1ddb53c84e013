// The motion of a safe controller: brake, hold a position, follow way-points slowly. One class per
// kind of output, the same interface, so that the manoeuvres are written once.
#pragma once

#include <algorithm>
#include <optional>

#include "rtac/controller.h"
#include "rtac/safe/setting.h"
#include "rtac/types.h"

namespace rtac::safe {

// A pilot ends a leg where it measures itself within this of its end: 2 cm, or the error of the
// position. A point mass comes no nearer than errors of its velocity and pushes let it that last:
// beside its leg to where its correction makes up for them, and along it to where its set-point
// does.
double end_reach_m(const Setting& setting);

// From a measurement of the age `age_us` until a command by it acts.
double delay_s(const Setting& setting, TimeUs age_us);

// The time constant with which the velocity of a point mass follows what is wanted, and the gain of
// the correction to its leg.
double settling_s(const Setting& setting);
double lateral_gain_per_s(const Setting& setting);

// A leg that is no longer is a point.
constexpr double point_m = 1e-6;
// Of the places of a leg.
Vec2 nearest_on(const Leg& leg, Vec2 at);

// How much longer a leg has to be for its pilot to pass what was its end at the full speed of the
// recovery: what it comes on until its brake acts, and what it plans to slow down over.
double run_out_m(const Setting& setting);

// Keeps track of the leg that is driven and of when its end is reached.
class LegTracker {
 public:
  // The present leg, seen from a measured position.
  struct Bearing {
    Vec2 direction;          // unit vector
    double remaining_m = 0;  // to the end of the leg, along it
    double lateral_m = 0;    // offset from the leg, positive to its left
    double corner_rad = 0;   // turn at its end; a stop counts as pi
  };

  void begin(Vec2 at) { from_ = at; }
  // Moves way.index past the points that `at` has reached or passed. false: nothing is left.
  bool advance(Path& way, Vec2 at, double reach_m);
  [[nodiscard]] Bearing bearing(const Path& way, Vec2 at) const;
  [[nodiscard]] Vec2 from() const { return from_; }

 private:
  Vec2 from_;
};

// Speed with which a leg may be driven `remaining_m` before its end, so that braking with
// `brake_mps2` meets the corner; never below a creep that still arrives.
double approach_speed(const LegTracker::Bearing& leg, double speed_mps, double brake_mps2,
                      double reaction_s);

// Which measurements may show that a halt has come to rest: those taken after its first command
// acted, each once. An older one may still show the robot before it was driven off. Where it rests,
// a position tells that was measured no earlier than a velocity which showed it: one from before
// may be as far off as the robot came on since, and whoever is promised that it stays there relies
// on it.
class RestWitness {
 public:
  void reset() { since_us_ = still_since_us_ = never_us; }
  void go_on(const Halt& halt) {
    since_us_ = halt.since_us;
    last_us_ = halt.seen_us;
    still_since_us_ = never_us;
  }
  [[nodiscard]] TimeUs since_us() const { return since_us_; }
  [[nodiscard]] TimeUs seen_us() const { return last_us_; }
  // True for a new measurement of the halt that goes on since the last reset.
  bool admits(const Observation& observation, TimeUs latency_us) {
    if (since_us_ == never_us) {
      since_us_ = observation.now_us + latency_us;
      last_us_ = since_us_ - 1;
    }
    if (observation.velocity.stamp_us <= last_us_) return false;
    last_us_ = observation.velocity.stamp_us;
    return true;
  }
  // What a measurement that was admitted shows.
  void sees(bool still) {
    if (!still) {
      still_since_us_ = never_us;
    } else if (still_since_us_ == never_us) {
      still_since_us_ = last_us_;
    }
  }
  // The newest position is one of the robot at rest: as long after that velocity as it may still
  // take to stop.
  [[nodiscard]] bool tells_where(const Observation& observation, TimeUs stops_us = 0) const {
    return still_since_us_ != never_us &&
           observation.position.stamp_us >= still_since_us_ + stops_us;
  }

 private:
  TimeUs since_us_ = never_us, last_us_ = never_us;
  TimeUs still_since_us_ = never_us;  // stamp of the first of the velocities that show it at rest
};

// How wheels are led along a leg (pace.h).
struct Steering {
  double gain_per_s = 0, turn_max_radps = 0;
  double aim_ahead_m = 0;
  double turn_end_rad = 0, turn_begin_rad = 0;
};
Steering steering_of(const Setting& setting);

template <class Output>
class Pilot;

template <>
class Pilot<Acceleration> {
 public:
  explicit Pilot(const Setting& setting);
  void engage(const Observation& observation);
  void go_on(const Halt& halt);
  [[nodiscard]] std::optional<Halt> halting() const;
  // Position and velocity are there; otherwise the only command left is `brake_blind`.
  [[nodiscard]] bool can_steer(const Observation& observation) const;
  Acceleration brake_blind(const Observation& observation);
  // Brakes, then holds the position where it came to rest.
  Acceleration halt(const Observation& observation);
  // Follows `way` from way.index on and advances it; halts at its end. Stopped on a leg it sets out
  // again from that leg, at rest, if it has come to rest as near to it as a stop explains.
  // `at`: as `on_way`, or as it is measured.
  Acceleration drive(const Observation& observation, Vec2 at, Path& way);
  [[nodiscard]] bool latched() const { return latched_; }
  // While it holds: the place to hold moves by at most `step_m` towards `to`. True: it is there.
  bool carry(Vec3 to, double step_m);
  // Errors may have put it beside its leg as it is measured: the nearest place of that, while it
  // drives or if it was stopped on it; or else the place that it holds.
  [[nodiscard]] Vec2 on_way(const Observation& observation) const;
  // How far from the place that it holds it may be measured, once it is there.
  [[nodiscard]] double sway_m() const { return sway_m_; }
  // Latched, and slow enough to be driven off.
  [[nodiscard]] bool at_rest(const Observation& observation) const;
  // The motion that `drive` would command leads nowhere nearer to `from`: back to the leg that it
  // was stopped on, as far as that is more than its hold sways, and on from `at` to `target`.
  [[nodiscard]] bool recedes(const Observation& observation, Vec2 at, Vec2 target, Vec2 from) const;

 private:
  [[nodiscard]] Acceleration limited(Vec3 a, double limit_mps2) const;
  // The sampled brake: at full strength, until one reaction would reverse the motion.
  [[nodiscard]] Acceleration against(Vec3 v) const;
  [[nodiscard]] double steering_limit() const;  // m/s^2
  // How far beside its leg it may be measured, once it was stopped on it.
  [[nodiscard]] double stray_m() const;
  void leave_far_leg();
  [[nodiscard]] Vec3 sets_out_from() const;
  bool sets_out(const Observation& observation, Vec2 at);
  bool move_hold(Vec3 to, double step_m);

  RobotLimits limits_;
  TimeUs period_us_;
  double speed_mps_;
  double reaction_s_;   // sample age, period and latency: from a measurement until its command acts
  double rest_mps_;     // measured speed below which the brake gives way to the position hold
  double ready_mps_;    // measured speed below which the hold may be left
  double omega_radps_;  // natural frequency of the position hold
  double settling_s_, lateral_gain_per_s_;
  double sway_m_;
  double end_reach_m_;
  LegTracker tracker_;
  std::optional<Leg> on_leg_;  // that it drives, or was stopped on
  double leg_mps_ = 0;         // of who drove it
  bool latched_ = false, driving_ = false;
  RestWitness rest_;
  Vec3 hold_at_;
  Vec3 last_velocity_;
  TimeUs last_seen_us_ = never_us;
};

template <>
class Pilot<Twist> {
 public:
  explicit Pilot(const Setting& setting);
  void engage(const Observation& observation);
  void go_on(const Halt& halt);
  [[nodiscard]] std::optional<Halt> halting() const;
  [[nodiscard]] bool can_steer(const Observation& observation) const;
  Twist brake_blind(const Observation& observation);
  Twist halt(const Observation& observation);
  Twist drive(const Observation& observation, Vec2 at, Path& way);
  [[nodiscard]] bool latched() const { return latched_; }
  [[nodiscard]] bool at_rest(const Observation&) const { return latched_; }
  [[nodiscard]] Vec2 on_way(const Observation& observation) const;
  [[nodiscard]] bool recedes(const Observation& observation, Vec2 at, Vec2 target, Vec2 from) const;

 private:
  void not_at_rest();
  // It may be measured there, if it is still where it has come to rest.
  [[nodiscard]] bool rests_near(Vec2 measured) const;

  RobotLimits limits_;
  TimeUs period_us_;
  double speed_mps_;
  double end_reach_m_;
  double reaction_s_;
  Steering steering_;
  LegTracker tracker_;
  Leg leg_;  // that it drives
  Vec2 leg_direction_;
  bool latched_ = false, driving_ = false, turning_ = false;
  // Where it has come to rest, as measured then: the base holds that place by itself. It is the
  // same after a gap of samples.
  Vec3 rests_at_;
  bool has_rested_ = false;  // there, and it has not been driven since
  TimeUs stops_us_;          // from when it is seen to be still until it stands
  RestWitness rest_;
  int still_samples_ = 0;
};

}  // namespace rtac::safe
