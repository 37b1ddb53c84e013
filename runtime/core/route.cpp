#include "rtac/safe/manoeuvre.h"
#include "rtac/safe/pace.h"
#include "rtac/sample.h"

namespace rtac::safe {
namespace {

// Parked within the first distance; no longer beyond the second (noise must not unpark it).
constexpr double parked_m = 0.05, left_m = 0.10;
// Other robots matter within this many pass gaps.
constexpr double near_gaps = 2;

}  // namespace

void RouteManoeuvre::engage(const Observation&) {
  stay();
  blocked_ = parked_ = cut_ = false;
  next_look_us_ = never_us;
  direct_m_ = -1;
  driven_m_ = 0;
  driven_until_us_ = never_us;
}

// By measured speed, for as long as it is not at rest in its hold.
void RouteManoeuvre::count_driven(const Observation& observation, bool at_rest) {
  if (driven_until_us_ != never_us && !at_rest) {
    driven_m_ += norm(observation.velocity.value) *
                 static_cast<double>(observation.now_us - driven_until_us_) * 1e-6;
  }
  driven_until_us_ = observation.now_us;
}

void RouteManoeuvre::decide(const Observation& observation, Gate gate, bool at_rest) {
  count_driven(observation, at_rest);
  const double distance_m = norm(at_ - site_);
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
  next_look_us_ = observation.now_us + pace::look_every_us;
  // Two errands must not wait for each other: the one that comes second makes room first.
  if (const int asker = asks_for_passage(observation);
      asker >= 0 && distance_to_way(at_, observation.others[static_cast<std::size_t>(asker)],
                                    observation.now_us) < 2 * setting_.pass_gap_m) {
    make_passage(observation, gate, asker);
    return;
  }
  look(observation);
}

// A robot that came to its hold after the way was found stands too close to what is left of it.
bool RouteManoeuvre::meets_held(const Observation& observation) const {
  RouteQuery around = around_robots(observation, true);
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

// Robots that are close; one that is far away may be gone when this one gets there. At rest, those
// count that are not HELD too: one that makes room lets its lease lapse first, and must find this
// robot still holding.
RouteQuery RouteManoeuvre::around_robots(const Observation& observation, bool held_only) const {
  RouteQuery around = query(observation, false);
  for (int j = 0; j < observation.robots; ++j) {
    const Announcement& other = observation.others[static_cast<std::size_t>(j)];
    if (j == observation.self || other.position.stamp_us == never_us) continue;
    if (!is_finite(other.position.value)) continue;
    if (held_only && !is_held(other, observation.now_us)) continue;
    const Vec2 there = seen_at(other, observation.now_us);
    if (norm(there - around.start) > near_gaps * setting_.pass_gap_m) continue;
    (void)around.avoid.push({there, setting_.pass_gap_m});  // never more than robots
  }
  return around;
}

// The part of a way that was cut off lies behind it, and it rests at its end. The first distance is
// beyond what the pilots miss an end by; three errors: as it arrived, as it stopped, as it is seen.
bool RouteManoeuvre::goes_on() const {
  return cut_ && !wants_motion() &&
         norm(at_ - joint_) <= left_m + 3 * setting_.limits.position_error_m;
}

// A way that was cut off goes on from its last way-point, the centre of a cell, not from where the
// robot happens to rest beside it. What is left of the chain of cells that was found first leads
// from there to the site, so the search finds nothing longer: in all the way is no longer than the
// chain, which is what the compiler has priced. A search from the place of rest could add the way
// to another cell's centre every time. The stop at the cut is priced like every end of a leg.
void RouteManoeuvre::look(const Observation& observation) {
  RouteQuery direct = query(observation, false), around = around_robots(observation, false);
  if (goes_on()) {
    direct.start = around.start = joint_;
    direct.over_start = around.over_start = true;
  }
  blocked_ = cut_ = false;
  if (!route_.to_point(direct, site_, blocked_way_)) {
    stay();  // nobody to ask: the zone itself has no way
    return;
  }
  if (direct_m_ < 0) direct_m_ = route_.way_length_m();
  const double rest_m = direct_m_ + setting_.detour_m - driven_m_;
  if (route_.to_point(around, site_, way_) &&
      (around.avoid.empty() || route_.way_length_m() <= rest_m)) {
    cut_ = route_.cut();
    joint_ = way_.points.back();
    return;
  }
  stay();
  blocked_ = true;
}

}  // namespace rtac::safe
