// A robot that has come to an end, in a recorded run.
#pragma once

#include <string>

namespace rtac::driver {

// Whether the robot that a run is about, the first one, is kept in it and stays where it begins to
// the end, without a turn. Where it is measured so, and nothing else changes, it does the same ever
// after.
bool stands(const std::string& trace, const std::string& robot);

}  // namespace rtac::driver
