// A planner whose `true` means checked: the safe side of a decision on plans.
#pragma once

#include <cstdint>

#include "rtac/controller.h"
#include "rtac/types.h"
#include "rtac/zone.h"

namespace rtac {

struct CertifiedOptions {
  Vec2 lower, upper;               // m; the rectangle that is sampled
  const ZoneView* zone = nullptr;  // must outlive the planner; null: every request is refused
  double clearance_m = 0;          // body, tracking, sensing and every other margin included
  std::uint64_t seed = 1;
  int iterations = 1000;  // of the first attempt; each restart gets twice as many
  int restarts = 3;
  // Successful searches to choose the shortest plan from: one search may pass an obstacle on the
  // wrong side, and pulling its plan taut does not change sides.
  int choices = 1;
  double leg_m = 0.5;  // longest leg of the result; <= 0: legs are left as they are
};

// Plans with OMPL (RRTConnect, then pulled taut) and re-checks the result leg by leg, apart from
// the search: a plan that fails the check is thrown away. A narrow passage can exhaust one search,
// so that the search is restarted with another seed and twice the effort.
//
// The rules for the result, for a start that is too close, and for `false` are those of
// OmplPlanner. Effort is bounded by choices * iterations * (2^(restarts + 1) - 1) steps of
// RRTConnect.
class CertifiedPlanner : public Planner {
 public:
  explicit CertifiedPlanner(const CertifiedOptions& options) : options_(options) {}
  bool plan(const PlanRequest& request, Path& plan) override;

 private:
  bool search(const PlanRequest& request, std::uint64_t seed, Path& plan) const;

  CertifiedOptions options_;
  std::uint64_t calls_ = 0;
};

// The check by itself: whether the way from the request's start through all points of `plan` to
// its goal keeps `clearance_m` from the boundary and stays out of the discs, a first leg out of the
// forbidden band excepted, on which no distance may fall below that of the start.
bool certify(const ZoneView& zone, double clearance_m, const PlanRequest& request,
             const Path& plan);

}  // namespace rtac
