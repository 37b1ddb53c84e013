// The price of a way home, as the templates of safe controllers drive it.
#pragma once

#include <optional>

#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// How the templates pace a way; the runtime states the same numbers (rtac/safe/pace.h), and a test
// compares the two.
namespace pace {
inline constexpr int creep_mmps = 30;
inline constexpr int planned_braking_permille = 400;
inline constexpr int velocity_time_ms = 300;
inline constexpr int velocity_time_delays = 2;
inline constexpr int lateral_gain_milli_per_s = 1000;
inline constexpr int lateral_mrad_per_delay = 500;
inline constexpr int arrival_margin_permille = 1250;
inline constexpr int hold_max_mradps = 2000;
inline constexpr int hold_mrad_per_delay = 250;
inline constexpr int hold_delay_least_us = 10'000;
inline constexpr int hold_brake_shares = 4;
inline constexpr int sway_slack_mm = 10;
inline constexpr int turn_gain_milli_per_s = 1500;
inline constexpr int turn_max_mradps = 1500;
inline constexpr int turn_end_mrad = 100;
inline constexpr int turn_end_errors_permille = 2500;
inline constexpr int turn_begin_mrad = 350;
inline constexpr int turn_begin_errors = 5;
inline constexpr int turn_mrad_per_delay = 500;
inline constexpr int aim_ahead_mm = 200;
inline constexpr int aim_ahead_turns_permille = 1400;
inline constexpr int aim_ahead_delays = 2;
inline constexpr int rest_samples = 3, still_mmps = 10;
inline constexpr int look_every_ms = 1000;
inline constexpr int near_mm = 5;     // of the end of a leg, errors and pushes apart
inline constexpr int waypoints = 64;  // of one piece of a way
}  // namespace pace

// By how much what pushes it makes a recovery of a point mass faster or slower than it means to be,
// in m/s.
Rational pushed_speed(const sema::RobotKind& kind, std::int64_t period_us);
// Upper bound of what takes speed from it for good, its velocity error included, in m/s; 0 of
// wheels.
Rational lasting_speed(const sema::RobotKind& kind, std::int64_t period_us);
// By how much errors turn the direction in which wheels that drive at `speed` in m/s are seen to be
// off their way, in rad; 0 of a point mass.
Rational heading_errors(const sema::RobotKind& kind, const Rational& speed, std::int64_t period_us);
// The most with which they keep to it: beyond, they would drive off at more than 1 rad to it.
inline const Rational heading_errors_most(1, pace::turn_begin_errors);
// The slowest recovery of a point mass that makes half of its speed good, whatever its velocity
// errs and whatever pushes it back, in m/s. Wheels drive at the speed that they are told; in space
// the place of a hold moves, whatever the velocity errs.
Rational slowest_led(const sema::RobotKind& kind, std::int64_t period_us);
// From `wanted` on about the slowest speed at which a recovery may be led, in m/s; none: up to that
// of the robot it is too slow, cannot be steered well enough, or is not followed.
std::optional<Rational> led_at(const sema::RobotKind& kind, const Rational& wanted,
                               std::int64_t period_us);
// The tests of the pilots hold it, whatever is declared.
inline constexpr std::int64_t beside_least_mm = 50;
// How far beside its leg a recovery of the declared `speed` in m/s comes at most, in mm, what
// pushes it included.
std::int64_t beside_mm(const sema::RobotKind& kind, const Rational& speed, std::int64_t period_us);
// How near to the end of a way over cells a recovery comes, in mm (end_reach_m of the pilots).
std::int64_t end_reach_mm(const sema::RobotKind& kind, std::int64_t period_us);
// Upper bound of the time from taking over at full speed until a way of `distance_mm` along the
// cells is driven at the recovery's `speed`, in s. `period_us`: of the decision.
Rational travel_seconds(const sema::RobotKind& kind, const Rational& speed, std::int64_t period_us,
                        std::int32_t cell_mm, std::int64_t distance_mm);
// The same of so many legs, each of which may begin with half a circle, and rests: what comes
// before it sets out is one, and the end another.
Rational few_legs_seconds(const sema::RobotKind& kind, const Rational& speed,
                          std::int64_t period_us, int legs, int rests, std::int64_t distance_mm);
// From full speed until a brake has it at rest, which it knows, and whose hold has settled: upper
// bounds of how long that takes, in s, and how far it drives, in m.
struct Stop {
  Rational seconds, metres;
};
Stop stop_of(const sema::RobotKind& kind, std::int64_t period_us);
// At most how fast a hold may be carried, in m/s, for a robot in space to follow it: what its
// spring asks for beside errors stays within what pushes leave of the brake. Beyond, it falls
// behind, and drives past the ends of its legs, faster than its hold.
Rational follows_up_to(const sema::RobotKind& kind, std::int64_t period_us);
// What one leg takes on top of its length, from rest to rest and until it looks for the next one,
// of a robot in space, which is carried along it by its hold. none: it does not follow that.
std::optional<Rational> carried_leg_seconds(const sema::RobotKind& kind, const Rational& speed,
                                            std::int64_t period_us);
// What so many legs take, from where the robot was moving on until it rests at the end of the last.
std::optional<Rational> legs_seconds(const sema::RobotKind& kind, const Rational& speed,
                                     std::int64_t period_us, int legs, std::int64_t way_mm);
// As `travel_seconds`, of a way that has such legs.
std::optional<Rational> carried_seconds(const sema::RobotKind& kind, const Rational& speed,
                                        std::int64_t period_us, std::int32_t cell_mm,
                                        std::int64_t distance_mm);
// How much longer than to where control is given back a retreat drives at most, in mm: it passes
// that place at its full speed (run_out_m of the pilots).
std::int64_t run_out_mm(const sema::RobotKind& kind, const Rational& speed, std::int64_t period_us);
// Charge that such ways take, which is affine in how long they are.
class TravelCost {
 public:
  TravelCost(const sema::RobotKind& kind, const Rational& speed, std::int64_t period_us,
             std::int32_t cell_mm);
  [[nodiscard]] std::int64_t ppm(std::int64_t distance_mm) const;

 private:
  mpz_class first_, per_mm_, in_ppm_;  // over one denominator: of each cell of a zone it is asked
};

}  // namespace rtac::analysis
