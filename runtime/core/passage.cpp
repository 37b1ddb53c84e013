#include "passage.h"

#include <algorithm>

namespace rtac::safe {
namespace {

// What a leg along a wall may lose of the clearance that the robot has: with what is lost beyond
// it, less than the 10 mm by which a hold may stray.
constexpr double loss_m = 1e-3;

}  // namespace

void recede_from_held(const Observation& observation, RouteQuery& query) {
  for (int j = 0; j < observation.robots; ++j) {
    const Announcement& other = observation.others[static_cast<std::size_t>(j)];
    if (j == observation.self || !is_held(other, observation.now_us)) continue;
    (void)query.recede_from.push(seen_at(other, observation.now_us));  // never more than robots
  }
}

bool Manoeuvre::get_away(const Observation& observation, const PlaceTest& aside) {
  RouteQuery away = query(observation, false);
  recede_from_held(observation, away);
  return route_.to_place(away, aside, way_) || leave_along_wall(away, aside);
}

// Who stands nearer to a wall than ways over cells lead comes nearer to one that stands on the
// other side of the passage, whatever cell it makes for. So it goes along the wall until it has
// passed.
bool Manoeuvre::leave_along_wall(const RouteQuery& away, const PlaceTest& aside) {
  constexpr int lengths = 4;
  const ZoneView& zone = *setting_.zone;
  const Vec2 off = away.start - nearest_boundary(zone, away.start);
  const double now_m = signed_clearance(zone, away.start), off_m = norm(off);
  if (now_m <= 0 || off_m < 1e-6) return false;
  const double least_m = std::min(now_m - loss_m, away.clearance_m);
  const double longest_m = setting_.pass_gap_m + 4 * setting_.limits.position_error_m;
  for (const double side : {1.0, -1.0}) {
    const Vec2 along = (side / off_m) * Vec2{-off.y, off.x};
    for (int i = 1; i <= lengths; ++i) {
      const Vec2 passed = away.start + (longest_m * i / lengths) * along;
      if (!aside.accepts(passed, now_m)) continue;
      RouteQuery beyond = away;
      beyond.start = passed;
      beyond.over_start = true;
      if (route_.leg_allowed(away, away.start, passed) &&
          keeps_clearance(zone, away.start, passed, least_m) &&
          route_.to_place(beyond, aside, way_)) {
        return true;
      }
      break;  // no longer leg does
    }
  }
  return false;
}

void Manoeuvre::make_passage(const Observation& observation, Gate gate, int asker) {
  const Announcement& other = observation.others[static_cast<std::size_t>(asker)];
  Aside aside(setting_);
  aside.keep_from_way(seen_at(other, observation.now_us), other.plan);
  stay();
  if (aside.good_enough(at_)) return;  // already out of the way
  if (get_away(observation, aside)) return;
  // At the pass gap around everybody who holds, the separation test lets it go in any direction.
  if (gate != Gate::away_only && route_.to_place(query(observation, true), aside, way_)) return;
  stay();
}

}  // namespace rtac::safe
