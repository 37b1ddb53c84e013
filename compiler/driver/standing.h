// A robot that has come to an end, in a recorded run.
#pragma once

#include <string>

namespace rtac::driver {

// Whether the first robot of a run stands where it begins until the end, and is not given back:
// nothing has changed in it since, and nothing will.
bool stands(const std::string& trace);

}  // namespace rtac::driver
