// An adversary: searches the control that carries a robot farthest across a line before its brake
// stops it. It refutes and it measures how tight a bound is; it never proves anything.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "rtac/types.h"
#include "rtac/zone.h"

namespace rtac {

// A point mass (theory: notation and timing). The true state lies within the errors around the
// measured one; any acceleration up to the limit acts on [0, horizon]; then the brake acts along
// the velocity, and the robot stops at p + v|v| / (2 brake).
struct ReachProblem {
  Vec2 position, velocity;      // measured, m and m/s
  double position_error_m = 0;  // |true - measured| is at most this; 0: exact
  double velocity_error_mps = 0;
  double accel_mps2 = 0;                                       // > 0; a disturbance counts in
  double brake_mps2 = 0;                                       // > 0
  double speed_mps = std::numeric_limits<double>::infinity();  // > 0; true speed never exceeds it
  double horizon_s = 0;                                        // > 0
  Vec2 normal;             // unit vector across the line, from the free side outward
  double offset_m = 0;     // free where dot(normal, p) <= offset_m
  int intervals = 20;      // piecewise constant control
  int starts = 4;          // local searches from different controls; the worst one counts
  std::uint64_t seed = 1;  // of the starts that are drawn at random
};

enum class SearchStatus {
  converged,        // at least one local search ended at a local optimum
  stopped_early,    // none did; the result is admissible all the same, but may be far from worst
  invalid_problem,  // a value is not finite or out of range, or no true state fits the measurement
  not_convex        // the zone is not a single convex ring (worst_case_in_room only)
};

// An admissible trajectory. Its controls and speeds keep their limits up to 1e-9, relative, and
// `excursion_m` is that of this very trajectory, evaluated without regularisation.
struct WorstCase {
  SearchStatus status = SearchStatus::invalid_problem;
  double excursion_m = -std::numeric_limits<double>::infinity();  // > 0: beyond the line
  std::vector<Vec2> controls_mps2;                                // one per interval
  std::vector<Vec2> positions_m;     // at the ends of the intervals, true start first
  std::vector<Vec2> velocities_mps;  // likewise
  std::size_t brake_at = 0;          // index of the position from which the brake acts
  Vec2 stop_m;                       // where it stops then
  [[nodiscard]] bool violates() const { return excursion_m > 0; }
};

// Maximises dot(normal, stopping point). Silent, reads no option file, deterministic. Calls from
// several threads run one after the other: the linear solver behind Ipopt has global state.
//
// v|v| has no second derivative at rest, so the search uses v sqrt(|v|^2 + d^2) with d = 0.1 mm/s
// instead. That changes the stopping point by at most d^2 / (4 brake), a few nanometres, and only
// the search: the reported excursion comes from v|v|. The worst moment to brake need not be the
// end (a robot that drives away from the line was nearest to it at first): every knot of the
// trajectory is tried, with and without braking.
WorstCase worst_case(const ReachProblem& problem);

// The same without Ipopt: the worst of so many drawn controls, the first of which pushes straight
// across the line. Never `converged`. `starts` is ignored.
WorstCase worst_case_by_restarts(const ReachProblem& problem, int restarts);

struct RoomWorstCase {
  SearchStatus status = SearchStatus::invalid_problem;  // converged: every edge converged
  std::vector<WorstCase> edges;                         // in the order of the zone's edges
  std::size_t worst_edge = 0;                           // the largest excursion
};

// The same for the line through every edge of a convex zone; normal and offset are ignored.
RoomWorstCase worst_case_in_room(const ReachProblem& problem, const ZoneView& room);

}  // namespace rtac
