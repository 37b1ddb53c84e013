// The search of rtac/optimize/worst_case.h as a nonlinear programme, and the only door to Ipopt.
//
// Variables: true start position, then the velocities at the ends of all intervals (x and y each).
// Controls are differences of velocities, so that every constraint is a ball around a constant or
// around the preceding velocity, and Jacobian and Hessian stay sparse.
#pragma once

#include <vector>

#include "rtac/optimize/worst_case.h"

namespace rtac::optimize {

// A point of the search space.
struct Candidate {
  Vec2 start;                    // true position at time 0, m
  std::vector<Vec2> velocities;  // intervals + 1 of them, m/s
};

enum class SolveStatus { converged, stopped_early, failed };

// One local search. `candidate` holds the starting point, and the result unless `failed`; the
// result keeps the constraints only up to Ipopt's tolerance.
SolveStatus solve(const ReachProblem& problem, Candidate& candidate);

}  // namespace rtac::optimize
