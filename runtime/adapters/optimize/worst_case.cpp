#include "rtac/optimize/worst_case.h"

#include <algorithm>
#include <random>
#include <utility>

#include "reach_nlp.h"
#include "trajectory.h"

namespace rtac {
namespace {

using optimize::Candidate;
using optimize::clip;
using optimize::SolveStatus;

// A control direction for the n-th local search: straight across the line, onward, none, random.
Vec2 start_direction(const ReachProblem& problem, int n, std::mt19937_64& random) {
  const double speed = norm(problem.velocity);
  if (n == 0) return problem.normal;
  if (n == 1 && speed > 0) return (1 / speed) * problem.velocity;
  if (n == 2) return {};
  return optimize::draw_direction(random);
}

Candidate starting_point(const ReachProblem& problem, Vec2 direction) {
  constexpr double inside = 0.9;  // an interior point method starts inside the limits
  const double step = inside * problem.accel_mps2 * problem.horizon_s / problem.intervals;
  Candidate result;
  result.start = problem.position + (problem.position_error_m / 2) * direction;
  Vec2 v = problem.velocity;
  for (int k = 0; k <= problem.intervals; ++k) {
    result.velocities.push_back(v);
    v = clip(v + step * direction, {}, inside * problem.speed_mps);
  }
  return result;
}

}  // namespace

WorstCase worst_case(const ReachProblem& problem) {
  WorstCase worst;
  if (!optimize::valid(problem)) return worst;
  bool converged = false;
  std::mt19937_64 random(problem.seed);
  for (int n = 0; n < problem.starts; ++n) {
    Candidate candidate = starting_point(problem, start_direction(problem, n, random));
    // A failed search leaves the starting point, which is as good a trajectory as any.
    converged = optimize::solve(problem, candidate) == SolveStatus::converged || converged;
    WorstCase found;
    optimize::simulate(problem, candidate, found);
    optimize::judge(problem, found);
    if (found.excursion_m > worst.excursion_m) worst = std::move(found);
  }
  worst.status = converged ? SearchStatus::converged : SearchStatus::stopped_early;
  return worst;
}

}  // namespace rtac
