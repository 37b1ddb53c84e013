// How much of what a monitor keeps free the worst admissible motion needs.
#pragma once

#include <string>
#include <vector>

#include "kernel.h"

namespace rtac::simulate {

// The states that just pass the look-ahead of a monitor, and the worst that was found from there
// for any control, disturbance and measurement error over its horizon, followed by the brake.
struct Tightness {
  struct State {
    double speed_mps = 0;  // as measured
    double angle_rad = 0;  // between the velocity and the shortest way to where it fails
    double bound_m = 0;    // the margin that the decision wants there
    double found_m = 0;    // how much of it is used up; more than all of it: unsound
    const char* by = "";   // see WorstPath
    [[nodiscard]] double share() const { return found_m / bound_m; }
  };
  std::string monitor;
  std::string why_not;        // it was not measured; empty: it was
  std::vector<State> states;  // in the order in which they were looked at
  int searches = 0;           // local ones, by Ipopt
  int failures = 0;           // of these, without a result
  double ahead_s = 0;         // from the sample until the brake acts
  bool complete = true;       // false: the time was up
};

// `core_s`: when to stop, in seconds of this process; what is found until then counts.
std::vector<Tightness> measure_tightness(const DecisionCase& decision,
                                         const Kernel::Functions& kernel, double core_s);

std::string tightness_json(const DecisionCase& decision, const std::vector<Tightness>& all);

}  // namespace rtac::simulate
