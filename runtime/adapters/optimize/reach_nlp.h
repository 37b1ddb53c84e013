// The search of rtac/optimize/worst_case.h as a nonlinear programme.
//
// Variables (x and y each): true start position, velocities at the ends of all intervals, controls
// as fractions of the limit. Velocities are variables, tied to the controls by linear equations,
// because Jacobian and Hessian stay sparse that way, and because every other constraint is a ball
// around a constant. (Without controls as variables, their limit is a ball around a difference,
// whose gradient vanishes at rest: that took twice the iterations.)
#pragma once

#include <vector>

#include "rtac/optimize/worst_case.h"
#include "solve_status.h"

namespace rtac::optimize {

// A point of the search space.
struct Candidate {
  Vec2 start;                    // true position at time 0, m
  std::vector<Vec2> velocities;  // intervals + 1 of them, m/s
};

// One local search. `candidate` holds the starting point, and the result unless `failed`; the
// result keeps the constraints only up to Ipopt's tolerance.
SolveStatus solve(const ReachProblem& problem, Candidate& candidate);

}  // namespace rtac::optimize
