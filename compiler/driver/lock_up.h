// Robots that wait for each other, in a recorded run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace rtac::driver {

// Whether none of the first `waiting` robots of a run is ever driven by its advanced controller,
// and no robot that is comes within `within_mm` of one of them: who drives to and fro beside a
// robot keeps it there, whatever that does.
bool locks_up(const std::string& trace, std::size_t waiting, std::int64_t within_mm);

}  // namespace rtac::driver
