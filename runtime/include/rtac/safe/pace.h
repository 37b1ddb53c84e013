// How the pilots of the safe-controller templates pace a way. The compiler prices ways by the same
// numbers (analysis: travel); a test compares the two and another drives ways against their prices.
#pragma once

#include "rtac/types.h"

namespace rtac::safe::pace {

// Slow enough to stop within millimetres, fast enough to arrive.
inline constexpr double creep_mps = 0.03;
// Part of the declared braking that the set-point plans with; the rest is for following it late.
inline constexpr double planned_braking = 0.4;
// Point mass: the velocity set-point is approached with this time constant at least; twice the
// delay keeps the loop well damped when the delay is longer.
inline constexpr double velocity_time_s = 0.3;
inline constexpr double velocity_time_delays = 2;
// Point mass: the correction to its leg, at most; half a radian for what its velocity takes to
// settle and for the delay of its position, without which it would weave about its leg.
inline constexpr double lateral_gain_per_s = 1, lateral_rad_per_delay = 0.5;
// How much faster its set-point is than what lasting errors and pushes take from it, until it is as
// near to the end of its leg as counts for being there.
inline constexpr double arrival_margin = 1.25;
// Point mass: the frequency of its hold, which is critically damped: at most the first; a quarter
// of a radian per delay, for a phase margin above 60 degrees; of a delay of at least the last.
inline constexpr double hold_max_radps = 2, hold_rad_per_delay = 0.25, hold_delay_least_s = 0.01;
// And at most so fast that a velocity error of its bound takes no more than half of what a push
// leaves of the brake, and a position error no more than a quarter: the damper asks for twice the
// frequency times the velocity, the spring for its square times the place. Without, errors of
// decimetres saturate the brake, and the robot is carried off.
inline constexpr double hold_brake_shares = 4;
// A corner sharper than this is taken from rest, and wheels turn there in place.
inline constexpr double sharp_corner_rad = 0.35;
// Unicycle: turning is proportional to the heading error, within a limit. By a heading that is seen
// late it turns more slowly, half a radian per delay.
inline constexpr double turn_gain_per_s = 1.5, turn_radps_max = 1.5, turn_rad_per_delay = 0.5;
// Unicycle: a turn in place ends at this heading error, or at 2.5 times what errors turn the
// direction that it is seen to head for: they cannot keep it turning. It would begin again at 0.35
// rad, or at five times those errors: while it drives they show it off by up to 4.7 times as much.
inline constexpr double turn_end_rad = 0.1, turn_end_errors = 2.5;
inline constexpr double turn_begin_rad = 0.35, turn_begin_errors = 5;
// Unicycle: it steers for a point of the leg's line that is so far ahead, or as far as it comes in
// 1.4 over that gain (a damping ratio of 0.59), or in twice the delay of its position.
inline constexpr double aim_ahead_m = 0.2, aim_ahead_turns = 1.4, aim_ahead_delays = 2;
// Unicycle: as many new measurements within the error of the speed and this show that it rests.
inline constexpr int rest_samples = 3;
inline constexpr double still_mps = 0.01;
// A recovery at rest looks for a way this often.
inline constexpr TimeUs look_every_us = 1'000'000;

}  // namespace rtac::safe::pace
