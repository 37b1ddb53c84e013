// Robots that wait for each other, in a recorded run.
#pragma once

#include <cstddef>
#include <string>

#include "compiler/verify/obligation.h"

namespace rtac::driver {

// Whether the first `waiting` robots of a run, which is about their own monitor alone, wait from
// its beginning to its end, and no robot that does not comes near to one of them: who drives to and
// fro beside a robot keeps it there, whatever that does. Nothing is violated, but where they begin.
bool locks_up(const std::string& trace, std::size_t waiting, const verify::LockUp& how);

}  // namespace rtac::driver
