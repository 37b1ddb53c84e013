#include "trajectory.h"

#include <algorithm>
#include <cmath>

namespace rtac::optimize {
namespace {

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

}  // namespace

bool valid(const ReachProblem& q) {
  return finite(q.position) && finite(q.velocity) && finite(q.normal) &&
         std::abs(norm(q.normal) - 1) <= unit_tolerance && std::isfinite(q.offset_m) &&
         not_negative(q.position_error_m) && not_negative(q.velocity_error_mps) &&
         positive(q.accel_mps2) && positive(q.brake_mps2) && positive(q.horizon_s) &&
         q.speed_mps > 0 && q.intervals > 0 && q.starts > 0 &&
         norm(q.velocity) - q.velocity_error_mps <= q.speed_mps;
}

Vec2 clip(Vec2 p, Vec2 centre, double radius) {
  const double distance = norm(p - centre);
  return distance <= radius ? p : centre + (radius / distance) * (p - centre);
}

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

double draw_share(std::mt19937_64& random) {
  return double(random() >> 11) * 0x1p-53;  // 53 random bits
}

Vec2 draw_direction(std::mt19937_64& random) {
  const double angle = 2 * pi * draw_share(random);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace rtac::optimize
