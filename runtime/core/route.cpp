#include "rtac/safe/manoeuvre.h"

namespace rtac::safe {
namespace {

constexpr TimeUs look_every_us = 1'000'000;
// Parked within the first distance; no longer beyond the second (noise must not unpark it).
constexpr double parked_m = 0.05, left_m = 0.10;

}  // namespace

void RouteManoeuvre::engage(const Observation&) {
  stay();
  blocked_ = parked_ = false;
  next_look_us_ = never_us;
}

void RouteManoeuvre::update(const Observation& observation, Gate, bool at_rest) {
  const double distance_m = norm(observation.position.value - site_);
  if (parked_ && distance_m > left_m) parked_ = false;
  if (!at_rest) {
    if (wants_motion() && meets_held(observation)) stay();  // brake, then look for another way
    return;
  }
  if (!wants_motion() && distance_m <= parked_m) parked_ = true;
  if (parked_) {
    blocked_ = false;
    stay();
    return;
  }
  if (observation.now_us < next_look_us_) return;
  next_look_us_ = observation.now_us + look_every_us;
  look(observation);
}

// A robot that came to its hold after the way was found stands too close to what is left of it.
bool RouteManoeuvre::meets_held(const Observation& observation) const {
  RouteQuery around = query(observation, true);
  for (Circle& circle : around.avoid) {
    // Position errors alone must not stop a robot that passes at the gap.
    circle.radius_m -= 3 * setting_.limits.position_error_m;
  }
  Vec2 from = around.start;
  for (std::size_t i = way_.index; i < way_.points.size(); ++i) {
    if (!route_.leg_allowed(around, from, way_.points[i])) return true;
    from = way_.points[i];
  }
  return false;
}

void RouteManoeuvre::look(const Observation& observation) {
  const RouteQuery around = query(observation, true);
  blocked_ = false;
  if (route_.to_point(around, site_, way_)) return;
  stay();
  if (around.avoid.empty()) return;  // nobody to ask: the zone itself has no way
  blocked_ = route_.to_point(query(observation, false), site_, blocked_way_);
}

}  // namespace rtac::safe
