#include <algorithm>
#include <cmath>

#include "angles.h"
#include "rtac/safe/manoeuvre.h"
#include "rtac/safe/pilot.h"

namespace rtac::safe {
namespace {

constexpr int corners = 4;  // of a lap: a square
// A rest lets the decision give control back: this many periods are more than its dwell.
constexpr TimeUs rest_periods = 12;

}  // namespace

void LoiterManoeuvre::engage(const Observation& observation) {
  RetreatManoeuvre::engage(observation);
  rests_since_us_ = never_us;
}

// The clearance at a point is that at the centre less the distance between them, at least: within
// `radius_m` of where it rests, every place is as clear as control asks for, errors included.
void LoiterManoeuvre::look(const Observation& observation) {
  const double slack_m = end_reach_m(setting_) + 2 * setting_.limits.position_error_m;
  const double least_m = std::max(setting_.return_clearance_m, setting_.route_clearance_m);
  const double clear_m = signed_clearance(*setting_.zone, at_);
  const double radius_m = std::min(radius_m_max, clear_m - least_m - slack_m);
  RetreatManoeuvre::look(observation);  // stays where it is clear enough
  if (wants_motion()) rests_since_us_ = never_us;
  if (wants_motion() || radius_m < radius_m_min) return;
  if (rests_since_us_ == never_us) rests_since_us_ = observation.now_us;
  if (observation.now_us - rests_since_us_ < rest_periods * setting_.period_us) return;
  rests_since_us_ = never_us;
  for (const bool around_held : {true, false}) {
    if (lap(query(observation, around_held), radius_m)) return;
  }
}

// A square whose centre is the place of rest, and back to it.
bool LoiterManoeuvre::lap(const RouteQuery& from_here, double radius_m) {
  stay();
  const Vec2 centre = from_here.start;
  Vec2 at = centre;
  for (int i = 0; i <= corners + 1; ++i) {
    const double angle_rad = 2 * detail::pi * i / corners;
    const Vec2 next =
        i <= corners ? centre + radius_m * Vec2{std::cos(angle_rad), std::sin(angle_rad)} : centre;
    if (!route_.leg_allowed(from_here, at, next)) {
      stay();
      return false;
    }
    (void)way_.points.push(next);  // never more than a path holds
    at = next;
  }
  return true;
}

}  // namespace rtac::safe
