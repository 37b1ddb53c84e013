// Motion planning with OMPL, for the advanced side: unverified, but reproducible.
#pragma once

#include <cstdint>

#include "rtac/controller.h"
#include "rtac/types.h"
#include "rtac/zone.h"

namespace rtac {

// The planners of OMPL that give the same plan bit for bit from a seed and a limit on iterations.
// The road-map planners (PRM, PRM*) do not, and are left out for that reason.
enum class Algorithm { rrt_star, bit_star, rrt_connect };

struct OmplOptions {
  Vec2 lower, upper;               // m; the rectangle that is sampled; goals lie inside it
  const ZoneView* zone = nullptr;  // must outlive the planner; null: ignorant of walls
  double clearance_m = 0;          // least distance of every leg to the zone's boundary
  Algorithm algorithm = Algorithm::rrt_star;
  std::uint64_t seed = 1;
  int iterations = 2000;  // bound on the effort of one call; time plays no part
  double leg_m = 0.5;     // longest leg of the result; <= 0: legs are left as they are
  bool shortcut = true;   // pull the path taut after planning
};

// plan() gives a path without the start and with the goal as its last point, `index` 0, no stamp.
//
// Every leg keeps `clearance_m` from the boundary of the zone and stays out of the discs of the
// request. Legs are judged whole, by segment distances, never by sampling states on them.
//
// A start that is itself too close (to the boundary or to a disc) may be left: along one straight
// leg on which no distance falls below that of the start, to the closest place that is far enough;
// from there on the rule above holds. Without such a leg there is no plan.
//
// plan() is false when the goal is outside the rectangle or too close, when a value is not finite,
// when no path was found within the iterations, or when the path needs more than max_waypoints.
//
// Reproducible: the n-th call of a planner depends on the options, n and the request alone. To get
// that, each call re-seeds OMPL's process-wide seed generator, and calls from several threads run
// one after the other. The first call switches OMPL's console output off for the process.
class OmplPlanner : public Planner {
 public:
  explicit OmplPlanner(const OmplOptions& options) : options_(options) {}
  bool plan(const PlanRequest& request, Path& plan) override;

 private:
  OmplOptions options_;
  std::uint64_t calls_ = 0;
};

}  // namespace rtac
