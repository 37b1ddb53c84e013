// A delivery shift in simulation: two robots with fallible controllers and planners, all decision
// modules and recoveries of the specification. Unlike the study of the example nobody judges or
// draws it, so that its running time is that of simulator and runtime alone.
#pragma once

#include <cstdint>

#include "robot_delivery.h"
#include "tests/bench/inputs.h"

namespace rtac::bench {

// One decision, before it is taken.
struct Decision {
  const Observation& observation;
  bool holding, surrender;
  const KernelIn& in;
  const KernelState& state;
  const robot_delivery::PlanExecutor& module;
};

class Listener {
 public:
  virtual ~Listener() = default;
  virtual void on_decision(const Decision& decision) = 0;
};

inline constexpr int robot_count = 2;

// `listener` may be null. False: the shift did not run to its end, or the kernel of the listener
// and the module disagreed.
bool run_shift(std::uint64_t seed, double minutes, Listener* listener);

// The same robots, controllers and planners, and nobody who decides.
bool run_undecided(std::uint64_t seed, double minutes);

// The same world, driven in circles: sensing, radio and motion, no decisions and no planners.
bool run_bare(std::uint64_t seed, double minutes);

}  // namespace rtac::bench
