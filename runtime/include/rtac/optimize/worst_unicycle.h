// The same adversary for a robot that drives where it points: it speeds up and turns as it likes,
// and then its brake stops it.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "rtac/optimize/worst_case.h"
#include "rtac/types.h"

namespace rtac {

// The true state lies within the errors around the measured one. On [0, horizon] the speed changes
// by up to accel, or brake when it falls, and the turn rate by up to turn_accel; then the brake
// acts and the turn ends, each at its limit. It drives forward: what it could do backward is not
// searched.
struct UnicycleProblem {
  Vec2 position, velocity;  // measured, m and m/s
  double heading_rad = 0;   // measured; the velocity points there, up to its error
  double position_error_m = 0, velocity_error_mps = 0, heading_error_rad = 0;  // >= 0; 0: exact
  double accel_mps2 = 0, brake_mps2 = 0;                                       // > 0
  double speed_mps = std::numeric_limits<double>::infinity();                  // > 0
  double turn_radps = 0;                                                       // > 0
  double turn_accel_radps2 = 0;  // 0: it turns as fast as it may at once
  double horizon_s = 0;          // > 0
  Vec2 normal;                   // unit vector: how far this way
  int intervals = 20;            // of the controls that are searched
  int starts = 4;                // local searches; the worst one counts
  std::uint64_t seed = 1;
};

// An admissible motion: controls, turn rates and speeds keep their limits up to 1e-9, relative, and
// places are never farther on than the turning robot comes.
struct UnicycleMotion {
  SearchStatus status = SearchStatus::invalid_problem;
  double reach_m = -std::numeric_limits<double>::infinity();  // farthest along the normal, from the
                                                              // measured position
  double step_s = 0;                                          // between places
  std::vector<Vec2> places_m;                                 // from the true start until it rests
  std::vector<double> speeds_mps, headings_rad, turns_radps;  // there
};

// Maximises the reach. Silent, deterministic, reads no option file; calls from several threads run
// one after the other. Speeds and headings are the variables of the search, so that all limits but
// the error of the velocity are linear; gradients and Hessians are exact. What it proposes is then
// driven in small steps, and every moment for the brake is tried.
UnicycleMotion worst_motion(const UnicycleProblem& problem);

// Without Ipopt: the worst of so many drawn motions, the first of which turns to the normal and
// speeds up. Never `converged`. `starts` is ignored.
UnicycleMotion worst_motion_by_restarts(const UnicycleProblem& problem, int restarts);

}  // namespace rtac
