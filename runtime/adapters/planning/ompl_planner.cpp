#include "rtac/planning/ompl_planner.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "free_space.h"
#include "ompl_search.h"
#include "path_tools.h"

namespace rtac {
namespace {

using planning::FreeSpace;

// Planned with this much more than asked for, so that a point which is rounded onto a leg still
// keeps what was asked for.
constexpr double rounding_m = 1e-9;

bool finite(Vec2 p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

bool usable(const OmplOptions& options, const PlanRequest& request) {
  for (const Disc& disc : request.obstacles) {
    if (!finite(disc.centre) || !std::isfinite(disc.radius_m)) return false;
  }
  const Vec2 goal = request.goal;
  return finite(request.start) && finite(goal) && finite(options.lower) && finite(options.upper) &&
         std::isfinite(options.clearance_m) && options.iterations > 0 &&
         goal.x >= options.lower.x && goal.x <= options.upper.x && goal.y >= options.lower.y &&
         goal.y <= options.upper.y;
}

// Free legs from `from`, which is free, to the goal.
bool find_way(const OmplOptions& options, const FreeSpace& space, std::uint64_t seed, Vec2 from,
              Vec2 goal, std::vector<Vec2>& way) {
  // Pulled taut, any path becomes this leg. Without a distance there is nothing to search.
  if ((options.shortcut || norm(goal - from) <= 0) && space.leg_free(from, goal)) {
    way = {from, goal};
    return true;
  }
  planning::Search search;
  search.start = from;
  search.goal = goal;
  // Noise may put the start outside the rectangle: that must not make it invalid.
  search.lower = {std::min(options.lower.x, from.x), std::min(options.lower.y, from.y)};
  search.upper = {std::max(options.upper.x, from.x), std::max(options.upper.y, from.y)};
  search.algorithm = options.algorithm;
  search.seed = seed;
  search.iterations = options.iterations;
  if (!planning::run_ompl(space, search, way)) return false;
  if (options.shortcut) way = planning::pull_taut(space, way);
  return true;
}

}  // namespace

bool OmplPlanner::plan(const PlanRequest& request, Path& plan) {
  const std::uint64_t seed = planning::derive_seed(options_.seed, calls_++);
  if (!usable(options_, request)) return false;
  const FreeSpace space(options_.zone, options_.clearance_m + rounding_m, request.obstacles);
  if (!space.point_free(request.goal)) return false;
  Vec2 from = request.start;
  const bool too_close = !space.point_free(from);
  if (too_close && !space.escape(request.start, from)) return false;
  std::vector<Vec2> way;
  if (!find_way(options_, space, seed, from, request.goal, way)) return false;
  if (too_close) way.insert(way.begin(), request.start);
  return planning::write_path(way, options_.leg_m, plan);
}

}  // namespace rtac
