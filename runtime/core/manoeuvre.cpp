#include "rtac/safe/manoeuvre.h"

#include <algorithm>

#include "rtac/sample.h"

namespace rtac::safe {

bool is_held(const Announcement& other, TimeUs now_us) {
  return other.lease_end_us != never_us && other.lease_end_us >= now_us &&
         other.position.stamp_us != never_us && is_finite(other.position.value) &&
         is_finite(other.height_m);
}

Vec3 place_of_held(const Announcement& other) {
  return other.hold && is_finite(*other.hold) ? *other.hold : position_of(other);
}

Vec2 seen_at(const Announcement& other, TimeUs now_us) {
  if (!is_held(other, now_us)) return other.position.value;
  const Vec3 there = place_of_held(other);
  return {there.x, there.y};
}

int asks_for_passage(const Observation& observation) {
  for (int j = 0; j < observation.robots; ++j) {
    const Announcement& other = observation.others[static_cast<std::size_t>(j)];
    if (j == observation.self || !other.blocked || !is_held(other, observation.now_us)) continue;
    if (goes_first(observation, j)) return j;
  }
  return -1;
}

double distance_to_way(Vec2 place, const Announcement& other, TimeUs now_us) {
  Vec2 from = seen_at(other, now_us);
  double nearest_m = norm(place - from);
  for (std::size_t i = other.plan.index; i < other.plan.points.size(); ++i) {
    nearest_m = std::min(nearest_m, distance_to_segment(place, from, other.plan.points[i]));
    from = other.plan.points[i];
  }
  return nearest_m;
}

RouteQuery Manoeuvre::query(const Observation& observation, bool around_held) const {
  RouteQuery query;
  query.clearance_m = setting_.route_clearance_m;
  query.start = at_;
  for (int j = 0; around_held && j < observation.robots; ++j) {
    const Announcement& other = observation.others[static_cast<std::size_t>(j)];
    if (j == observation.self || !is_held(other, observation.now_us)) continue;
    // never more than robots
    (void)query.avoid.push({seen_at(other, observation.now_us), setting_.pass_gap_m});
  }
  return query;
}

}  // namespace rtac::safe
