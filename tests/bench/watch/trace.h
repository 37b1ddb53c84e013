// Inputs of the benchmarked monitors: the same ticks for the generated code, the hand-written one
// and the peer, each in the form that it takes.
#pragma once

#include <cstdint>
#include <vector>

#include "patrol_kernel.h"
#include "tests/bench/watch/hand/patrol.h"

namespace rtac::bench {

// What a trace has that is not as it should be.
struct Faults {
  bool samples = true;  // late, missing, invalid, out of range, from the future
  bool ticks = false;   // missed and repeated
};

struct PatrolTrace {
  std::int64_t length_us = 0;  // after which the next round may start
  std::vector<std::int64_t> now_us;
  std::vector<patrol_monitors_in> kernel;
  std::vector<hand_patrol_in> hand;
  std::vector<naive_patrol_in> naive;
};
PatrolTrace patrol_trace(std::uint64_t seed, int ticks, const Faults& faults);
// Moves all stamps to the next round of the trace.
void next_round(PatrolTrace& trace);

// A condition is 0, 1 or missing.
inline constexpr int missing = 2;
struct WindowTick {
  std::int64_t now_us;
  int calm, alarm;
};
std::vector<WindowTick> window_trace(std::uint64_t seed, int ticks, const Faults& faults);

template <class Sample>
void put_condition(Sample& to, int condition, std::int64_t now_us) {
  to.stamp_us = now_us;
  to.valid = condition != missing ? 1 : 0;
  to.between = 0;
  to.value = condition == 1 ? 1 : 0;
}

}  // namespace rtac::bench
