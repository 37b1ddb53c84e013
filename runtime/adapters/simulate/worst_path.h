// The worst that one robot can do: any control for a while, then its brake, the ideal one as well
// as that of a pilot which is misled.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracle.h"
#include "rtac/types.h"

namespace rtac::simulate {

// As far along `normal` as it comes.
struct Push {
  Moving robot;      // as it was measured
  Vec3 normal;       // unit vector
  double begin_s;    // of its position, on the clock of who asks
  double free_s;     // from then on any control acts, until the brake does
  double apart_s;    // its velocity was measured so much earlier
  TimeUs period_us;  // of its decision
};

// An admissible motion; it stands before it begins, and comes no farther after its end.
struct WorstPath {
  std::function<Vec3(double time_s)> at;
  double end_s = 0;
  double still_s = 0;   // from then on it counts as standing
  const char* by = "";  // "Ipopt", "restarts" or "errors along the normal"
};

struct WorstPaths {
  std::vector<WorstPath> paths;  // of each search that has found one, Ipopt first
  int searches = 0;              // local ones, by Ipopt
  int failures = 0;              // of these, without a result
};

// Why motions of such a robot are not searched; empty: they are.
std::string not_searched(const RobotLimits& limits);

WorstPaths worst_paths(const RobotLimits& limits, const Push& push);

// The same of a point mass that does what it is told: nothing until time 0, and the command from
// then on. Not searched: all errors push it along the normal, as far as they reach.
WorstPaths worst_paths_told(const RobotLimits& limits, const Push& push, Vec3 command_mps2);

}  // namespace rtac::simulate
