#include "rtac/safe/pilot.h"

#include <algorithm>
#include <cmath>

#include "angles.h"

namespace rtac::safe {
namespace {

// A corner sharper than this is taken from rest.
constexpr double sharp_corner_rad = 0.35;
// Slow enough to stop within millimetres, fast enough to arrive.
constexpr double creep_mps = 0.03;
// Part of the declared braking that the set-point plans with; the rest is for following it late.
constexpr double planned_braking = 0.4;

}  // namespace

bool LegTracker::advance(Path& way, Vec2 at, double reach_m) {
  while (!way.finished()) {
    const Vec2 to = way.points[way.index];
    const Leg here = leg(way, at);
    // Passing the end counts too: a leg is not driven backwards because of a small offset.
    const bool last = way.index + 1 == way.points.size();
    const bool passed = here.remaining_m <= (last ? 0.25 * reach_m : 0.0);
    if (norm(to - at) > reach_m && !passed) return true;
    from_ = to;
    ++way.index;
  }
  return false;
}

LegTracker::Leg LegTracker::leg(const Path& way, Vec2 at) const {
  const Vec2 to = way.points[way.index], along = to - from_;
  const double length = norm(along);
  Leg leg;
  leg.direction = length > 1e-6 ? (1 / length) * along : Vec2{1, 0};
  leg.remaining_m = length > 1e-6 ? dot(to - at, leg.direction) : 0.0;
  leg.lateral_m = leg.direction.x * (at.y - from_.y) - leg.direction.y * (at.x - from_.x);
  leg.corner_rad = detail::pi;
  if (way.index + 1 < way.points.size()) {
    const Vec2 next = way.points[way.index + 1] - to;
    if (norm(next) > 1e-6) {
      leg.corner_rad = std::fabs(detail::wrapped(detail::angle(next) - detail::angle(along)));
    }
  }
  return leg;
}

double approach_speed(const LegTracker::Leg& leg, double speed_mps, double brake_mps2,
                      double reaction_s) {
  const double corner_mps = speed_mps * std::max(0.0, 1 - leg.corner_rad / sharp_corner_rad);
  const double room_m = std::max(0.0, leg.remaining_m - speed_mps * reaction_s);
  const double allowed_mps =
      std::sqrt(corner_mps * corner_mps + 2 * planned_braking * brake_mps2 * room_m);
  return std::min(speed_mps, std::max(allowed_mps, creep_mps));
}

}  // namespace rtac::safe
