// The search of rtac/optimize/worst_unicycle.h as a nonlinear programme.
//
// Variables: the speeds at the ends of all intervals, then the headings there. Limits on controls
// and turn rates are linear in them; the only other constraint is the error of the velocity, on the
// first speed and heading. The true start is known beforehand: as far along the normal as may be.
#pragma once

#include <vector>

#include "rtac/optimize/worst_unicycle.h"
#include "solve_status.h"

namespace rtac::optimize {

// A point of the search space: intervals + 1 of each.
struct UnicycleCandidate {
  std::vector<double> speeds_mps, headings_rad;
};

// One local search. `candidate` holds the starting point, and the result unless `failed`; the
// result keeps the constraints only up to Ipopt's tolerance.
SolveStatus solve(const UnicycleProblem& problem, UnicycleCandidate& candidate);

}  // namespace rtac::optimize
