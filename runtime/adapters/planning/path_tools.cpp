#include "path_tools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rtac::planning {
namespace {

// Candidates for corners lie this far apart, or further on a long path, to bound the work: it
// grows with the square of their number.
constexpr double candidate_step_m = 0.05;
constexpr int candidates_max = 128;
// Prefers one leg to several on the same line.
constexpr double cost_per_leg_m = 1e-6;
// A leg of exactly leg_m must not be split because of rounding.
constexpr double parts_tolerance = 1e-9;

int parts_of(double length_m, double step_m) {
  if (step_m <= 0) return 1;
  return std::max(1, static_cast<int>(std::ceil(length_m / step_m - parts_tolerance)));
}

std::vector<Vec2> candidates_of(const std::vector<Vec2>& points) {
  const double step_m = std::max(candidate_step_m, path_length(points) / candidates_max);
  std::vector<Vec2> result{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 a = points[i - 1], d = points[i] - a;
    const int parts = parts_of(norm(d), step_m);
    for (int k = 1; k < parts; ++k) result.push_back(a + (double(k) / parts) * d);
    result.push_back(points[i]);
  }
  return result;
}

}  // namespace

double path_length(const std::vector<Vec2>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += norm(points[i] - points[i - 1]);
  return length;
}

std::vector<Vec2> pull_taut(const FreeSpace& space, const std::vector<Vec2>& points) {
  if (points.size() < 2) return points;
  const std::vector<Vec2> p = candidates_of(points);
  std::vector<double> cost(p.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> previous(p.size(), 0);
  cost[0] = 0;
  for (std::size_t j = 1; j < p.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      const double c = cost[i] + norm(p[j] - p[i]) + cost_per_leg_m;
      // Neighbours are parts of a leg that the search has judged as a whole.
      if (c >= cost[j] || (i + 1 != j && !space.leg_free(p[i], p[j]))) continue;
      cost[j] = c;
      previous[j] = i;
    }
  }
  std::vector<Vec2> result;
  for (std::size_t j = p.size() - 1; j != 0; j = previous[j]) result.push_back(p[j]);
  result.push_back(p[0]);
  std::reverse(result.begin(), result.end());
  return result;
}

bool write_path(const std::vector<Vec2>& points, double leg_m, Path& path) {
  path = Path{};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 a = points[i - 1], d = points[i] - a;
    if (leg_m > 0 && norm(d) / leg_m > double(max_waypoints) + 1) return false;
    const int parts = parts_of(norm(d), leg_m);
    for (int k = 1; k < parts; ++k) {
      if (!path.points.push(a + (double(k) / parts) * d)) return false;
    }
    if (!path.points.push(points[i])) return false;
  }
  return !path.points.empty();
}

}  // namespace rtac::planning
