// C code between the replay and the decisions of a kernel, whose names and layouts depend on the
// specification.
#pragma once

#include <string>
#include <vector>

#include "compiler/driver/decision_engine.h"

namespace rtac::driver {

// What one robot is seen to be, as words of 64 bits: position and velocity { x_lo, x_hi, y_lo,
// y_hi, stamp_us, valid, z_lo, z_hi }, battery and heading { lo, hi, stamp_us, valid }, then the
// plan { valid, count, index }, presence { stamp_us, present, heard }, and the plan's coordinates
// x[], y[]; then the plain inputs, by component of the specification { lo, hi, stamp_us, valid },
// at INT64_MIN when there is no number; of a zone the address of its tables instead of `lo`.
struct RobotWords {
  static constexpr std::size_t position = 0, velocity = 8, battery = 16, heading = 20, plan = 24;
  static constexpr std::size_t presence = 27, points = 30;
  static constexpr std::size_t per_input = 4;
  static constexpr std::size_t inputs(std::size_t capacity) { return points + 2 * capacity; }
  static constexpr std::size_t size(std::size_t capacity, std::size_t components) {
    return inputs(capacity) + per_input * components;
  }
};
// What a step tells: mode, monitor, reason, index, input, other, then { now, margin, unit, ahead,
// margin, unit, returns } of each monitor.
struct FindingWords {
  static constexpr std::size_t monitors = 6, per_monitor = 7, ahead = 3, returns = 6;
};

// Most way-points that a plan of the kernel holds.
std::size_t plan_capacity(const std::vector<DecisionInterface>& decisions);

// Defines `rtac_decision_init_K(void)` and `rtac_decision_step_K(self, robots, now_us, finding)` of
// decision K. `source`: name of the kernel's .c file.
std::string decision_glue(const std::vector<DecisionInterface>& decisions,
                          const std::string& source);

}  // namespace rtac::driver
