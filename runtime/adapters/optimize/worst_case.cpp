#include "rtac/optimize/worst_case.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "reach_nlp.h"

namespace rtac {
namespace {

using optimize::Candidate;
using optimize::SolveStatus;

constexpr double pi = 3.14159265358979323846;
constexpr double unit_tolerance = 1e-6;

bool finite(Vec2 p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

bool positive(double x) {
  return std::isfinite(x) && x > 0;
}
bool not_negative(double x) {
  return std::isfinite(x) && x >= 0;
}

bool valid(const ReachProblem& q) {
  return finite(q.position) && finite(q.velocity) && finite(q.normal) &&
         std::abs(norm(q.normal) - 1) <= unit_tolerance && std::isfinite(q.offset_m) &&
         not_negative(q.position_error_m) && not_negative(q.velocity_error_mps) &&
         positive(q.accel_mps2) && positive(q.brake_mps2) && positive(q.horizon_s) &&
         q.speed_mps > 0 && q.intervals > 0 && q.starts > 0 &&
         norm(q.velocity) - q.velocity_error_mps <= q.speed_mps;
}

// The closest point of the ball.
Vec2 clip(Vec2 p, Vec2 centre, double radius) {
  const double distance = norm(p - centre);
  return distance <= radius ? p : centre + (radius / distance) * (p - centre);
}

// A control direction for the n-th local search: straight across the line, onward, none, random.
Vec2 start_direction(const ReachProblem& problem, int n, std::mt19937_64& random) {
  const double speed = norm(problem.velocity);
  if (n == 0) return problem.normal;
  if (n == 1 && speed > 0) return (1 / speed) * problem.velocity;
  if (n == 2) return {};
  // 53 random bits: unlike the distributions of the library, the same everywhere.
  const double angle = 2 * pi * double(random() >> 11) * 0x1p-53;
  return {std::cos(angle), std::sin(angle)};
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

// A true velocity that fits the measurement and the cap on the speed, near `v`.
Vec2 admissible_velocity(const ReachProblem& problem, Vec2 v) {
  // In both sets by construction: `valid` has checked that they meet.
  const Vec2 inner = clip(problem.velocity, {}, problem.speed_mps);
  for (int i = 0; i < 4; ++i) {
    v = clip(clip(v, problem.velocity, problem.velocity_error_mps), {}, problem.speed_mps);
  }
  // Ipopt exceeds constraints by about 1e-8; what the projections leave of that goes here.
  for (double keep = 1; keep > 0; keep = 1 - std::max(2 * (1 - keep), 1e-12)) {
    const Vec2 w = inner + keep * (v - inner);
    if (norm(w - problem.velocity) <= problem.velocity_error_mps && norm(w) <= problem.speed_mps) {
      return w;
    }
  }
  return inner;
}

// The admissible trajectory next to what Ipopt returned. Projecting onto the cap keeps the limit on
// the acceleration: the projection onto a convex set that contains the old velocity does not
// lengthen the step.
void simulate(const ReachProblem& problem, const Candidate& candidate, WorstCase& result) {
  const double h = problem.horizon_s / problem.intervals;
  Vec2 p = clip(candidate.start, problem.position, problem.position_error_m);
  Vec2 v = admissible_velocity(problem, candidate.velocities[0]);
  result.positions_m.push_back(p);
  result.velocities_mps.push_back(v);
  for (std::size_t k = 1; k < candidate.velocities.size(); ++k) {
    Vec2 next = clip(candidate.velocities[k], v, problem.accel_mps2 * h);
    next = clip(next, {}, problem.speed_mps);
    result.controls_mps2.push_back((1 / h) * (next - v));
    p = p + (h / 2) * (v + next);
    v = next;
    result.positions_m.push_back(p);
    result.velocities_mps.push_back(v);
  }
}

// The worst moment for the brake to act, exactly.
void judge(const ReachProblem& problem, WorstCase& result) {
  for (std::size_t k = 0; k < result.positions_m.size(); ++k) {
    const Vec2 p = result.positions_m[k], v = result.velocities_mps[k];
    const Vec2 stop = p + (norm(v) / (2 * problem.brake_mps2)) * v;
    // Braking is straight: the farthest point is one of its ends.
    const double reach = std::max(dot(problem.normal, p), dot(problem.normal, stop));
    if (reach - problem.offset_m < result.excursion_m) continue;
    result.excursion_m = reach - problem.offset_m;
    result.brake_at = k;
    result.stop_m = stop;
  }
}

}  // namespace

WorstCase worst_case(const ReachProblem& problem) {
  WorstCase worst;
  if (!valid(problem)) return worst;
  bool converged = false;
  std::mt19937_64 random(problem.seed);
  for (int n = 0; n < problem.starts; ++n) {
    Candidate candidate = starting_point(problem, start_direction(problem, n, random));
    // A failed search leaves the starting point, which is as good a trajectory as any.
    converged = optimize::solve(problem, candidate) == SolveStatus::converged || converged;
    WorstCase found;
    simulate(problem, candidate, found);
    judge(problem, found);
    if (found.excursion_m > worst.excursion_m) worst = std::move(found);
  }
  worst.status = converged ? SearchStatus::converged : SearchStatus::stopped_early;
  return worst;
}

}  // namespace rtac
