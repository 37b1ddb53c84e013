// The words of 64 bits between `rtac-sim` and a compiled kernel: what the glue of the compiler
// (driver/sim_glue) reads and writes.
#pragma once

#include <cstddef>

namespace rtac::simulate::words {

inline constexpr int version = 6;

// In: { self, holding, surrender }, position and velocity { x_lo, x_hi, y_lo, y_hi, stamp_us,
// valid, z_lo, z_hi }, battery and heading { lo, hi, stamp_us, valid }, the commands sent and
// proposed as points, then the plan { valid, count, index, x[], y[] } and the others: { position,
// velocity, lease end, goes first, presence stamp, present, plan } each; the agents, { x,
// y, between, valid, stamp_us, present, valid, stamp_us, z } each, in steps of 1 mm; at last the
// components of plain inputs, { lo, hi, valid } each, in steps of their grids.
inline constexpr std::size_t self = 0, holding = 1, surrender = 2;
inline constexpr std::size_t position = 3, velocity = 11, battery = 19, heading = 23;
inline constexpr std::size_t sent = 27, proposed = 35, plan = 43;
constexpr std::size_t plan_size(std::size_t capacity) {
  return 3 + 2 * capacity;
}
inline constexpr std::size_t other_position = 0, other_velocity = 8, lease_end = 16;
inline constexpr std::size_t goes_first = 17, presence = 18, present = 19, other_plan = 20;
constexpr std::size_t other_size(std::size_t capacity) {
  return other_plan + plan_size(capacity);
}
inline constexpr std::size_t agent_size = 9, agent_present = 5, agent_z = 8;
inline constexpr std::size_t input_size = 3;

// Out, and of each monitor { now, ahead, safer, engaged, margin, now_margin, unit }.
inline constexpr std::size_t mode = 0, previous_mode = 1, deciding = 2, reason = 3;
inline constexpr std::size_t reason_index = 4, reason_input = 5, reason_other = 6, gate = 7;
inline constexpr std::size_t out_lease_end = 8, violation = 9, tick = 10, time = 11;
inline constexpr std::size_t monitors = 12, per_monitor = 7;
inline constexpr std::size_t now = 0, ahead = 1, safer = 2, engaged = 3, margin = 4, unit = 6;

}  // namespace rtac::simulate::words
