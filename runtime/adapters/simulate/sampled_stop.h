// How a point mass is stopped in fact: by the pilot of the recoveries, each period, on samples that
// are late and wrong.
#pragma once

#include <functional>

#include "rtac/types.h"
#include "worst_path.h"

namespace rtac::simulate {

// Any control until the brake acts. Times are those of who asks, before its begin as well.
struct FreeMotion {
  std::function<Vec3(double time_s)> place, velocity;
  double brake_s = 0;
};

// The stop that leads farthest along the unit vector `normal`, of those that are tried: errors of
// the velocity that make it seem slower that way, straight on or aside; a place that is measured
// at either end of its error, and at the other one once it is held; the oldest samples, or the
// newest. What pushes it pushes along `normal`. The path ends where it is farthest.
WorstPath sampled_stop(const RobotLimits& limits, TimeUs period_us, const FreeMotion& free,
                       Vec3 normal, const char* by);

}  // namespace rtac::simulate
