#include "compiler/codegen/decision_bytes.h"

#include <cstdint>

#include "compiler/codegen/watch.h"

namespace rtac::codegen {

std::size_t decision_state_bytes(const ir::Decision& decision) {
  constexpr std::size_t wide = sizeof(std::int64_t), narrow = sizeof(std::int32_t);
  constexpr std::size_t clock = 4 * wide;                   // a flag, three times
  constexpr std::size_t monitor = 2 * narrow + 4 * narrow;  // engaged, dwell; what was found
  constexpr std::size_t mode = wide;                        // padded
  constexpr std::size_t takeover = 2 * wide;                // a time, the driver before
  constexpr std::size_t lease = wide;
  constexpr std::size_t own_stamps = 3 * wide;  // position, velocity, battery
  // of each robot: position, velocity, lease; in an open fleet, whether it is present
  const std::size_t other_stamps = (decision.open_fleet ? 4 : 3) * wide;
  constexpr std::size_t run = 2 * narrow;    // of `for`: lower and upper end
  constexpr std::size_t command = 4 * wide;  // a time, an acceleration, a flag
  return clock + monitor * decision.monitors.size() + mode + takeover + lease + own_stamps +
         other_stamps * decision.robots + (decision.body.heading_age_us ? wide : 0) +
         run * decision.held_slots + command * static_cast<std::size_t>(decision.commands) +
         static_cast<std::size_t>(facts_state_bytes(decision.facts));
}

}  // namespace rtac::codegen
