// Recoveries that take over from each other, in a recorded run.
#pragma once

#include <string>
#include <vector>

namespace rtac::driver {

// How often one of these modes takes over from another one, of the robot that they drive to the end
// of a run in which control is not given back, since the last time that anybody else has driven it;
// of several robots the most. 0: control is given back.
int turns_taken(const std::string& trace, const std::vector<int>& modes);

}  // namespace rtac::driver
