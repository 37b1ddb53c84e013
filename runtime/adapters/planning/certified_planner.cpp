#include "rtac/planning/certified_planner.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "free_space.h"
#include "ompl_search.h"
#include "rtac/planning/ompl_planner.h"

namespace rtac {
namespace {

using planning::FreeSpace;

OmplOptions options_of_attempt(const CertifiedOptions& options, std::uint64_t seed, int attempt) {
  OmplOptions result;
  result.lower = options.lower;
  result.upper = options.upper;
  result.zone = options.zone;
  result.clearance_m = options.clearance_m;
  result.algorithm = Algorithm::rrt_connect;
  result.seed = planning::derive_seed(seed, static_cast<std::uint64_t>(attempt));
  // The cap keeps the sum of all attempts far from overflow; no search of interest is that long.
  constexpr std::int64_t iterations_max = 100'000'000;
  result.iterations = static_cast<int>(
      std::min(std::int64_t{options.iterations} * (std::int64_t{1} << attempt), iterations_max));
  result.leg_m = options.leg_m;
  result.shortcut = true;
  return result;
}

// Restarting cannot help when the goal is not free, or when there is no way out of the band.
bool hopeless(const FreeSpace& space, const PlanRequest& request) {
  Vec2 end;
  return !space.point_free(request.goal) ||
         (!space.point_free(request.start) && !space.escape(request.start, end));
}

// The points up to the first free one must lie on one straight leg out of the band; `next` is the
// index of the point after that leg.
bool leaves_band(const FreeSpace& space, Vec2 start, const Path& plan, std::size_t& next) {
  constexpr double straight_m = 1e-6;  // more than rounding, less than any grid
  next = 0;
  while (next < plan.points.size() && !space.point_free(plan.points[next])) ++next;
  if (next == plan.points.size()) return false;
  const Vec2 end = plan.points[next];
  for (std::size_t i = 0; i < next; ++i) {
    if (planning::segment_distance(start, end, plan.points[i]) > straight_m) return false;
  }
  ++next;
  return space.leg_no_worse_than(start, start, end);
}

}  // namespace

bool certify(const ZoneView& zone, double clearance_m, const PlanRequest& request,
             const Path& plan) {
  if (plan.points.empty() || plan.index != 0) return false;
  if (!(norm(plan.points.back() - request.goal) <= 0)) return false;
  const FreeSpace space(&zone, clearance_m, request.obstacles);
  std::size_t next = 0;
  if (!space.point_free(request.start) && !leaves_band(space, request.start, plan, next)) {
    return false;
  }
  Vec2 from = next == 0 ? request.start : plan.points[next - 1];
  for (; next < plan.points.size(); ++next) {
    if (!space.leg_free(from, plan.points[next])) return false;
    from = plan.points[next];
  }
  return true;
}

// One plan, restarted while the search fails.
bool CertifiedPlanner::search(const PlanRequest& request, std::uint64_t seed, Path& plan) const {
  constexpr int doublings_max = 20;
  for (int attempt = 0; attempt <= options_.restarts && attempt <= doublings_max; ++attempt) {
    OmplPlanner planner(options_of_attempt(options_, seed, attempt));
    if (planner.plan(request, plan) &&
        certify(*options_.zone, options_.clearance_m, request, plan)) {
      return true;
    }
  }
  return false;
}

bool CertifiedPlanner::plan(const PlanRequest& request, Path& plan) {
  const std::uint64_t seed = planning::derive_seed(options_.seed, calls_++);
  if (options_.zone == nullptr) return false;
  const FreeSpace space(options_.zone, options_.clearance_m, request.obstacles);
  if (hopeless(space, request) || !search(request, seed, plan)) return false;
  Path other;
  for (int choice = 1; choice < options_.choices; ++choice) {
    const std::uint64_t other_seed =
        planning::derive_seed(seed, 1000 + static_cast<std::uint64_t>(choice));
    if (search(request, other_seed, other) &&
        length_m(request.start, other) < length_m(request.start, plan)) {
      plan = other;
    }
  }
  return true;
}

}  // namespace rtac
