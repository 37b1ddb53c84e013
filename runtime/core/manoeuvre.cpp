#include "rtac/safe/manoeuvre.h"

#include "rtac/sample.h"

namespace rtac::safe {

bool is_held(const Announcement& other, TimeUs now_us) {
  return other.lease_end_us != never_us && other.lease_end_us >= now_us &&
         other.position.stamp_us != never_us && is_finite(other.position.value);
}

RouteQuery Manoeuvre::query(const Observation& observation, bool around_held) const {
  RouteQuery query;
  query.clearance_m = setting_.route_clearance_m;
  query.start = observation.position.value;
  for (int j = 0; around_held && j < observation.robots; ++j) {
    const Announcement& other = observation.others[static_cast<std::size_t>(j)];
    if (j == observation.self || !is_held(other, observation.now_us)) continue;
    (void)query.avoid.push({other.position.value, setting_.pass_gap_m});  // never more than robots
  }
  return query;
}

}  // namespace rtac::safe
