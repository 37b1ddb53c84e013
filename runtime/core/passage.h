// Places out of the way of other robots, for recoveries that make room.
#pragma once

#include "rtac/safe/manoeuvre.h"
#include "rtac/safe/pilot.h"

namespace rtac::safe {

// Far enough from given robots and from the way of one of them.
class Aside : public PlaceTest {
 public:
  explicit Aside(const Setting& setting)
      : gap_m_(setting.pass_gap_m),
        error_m_(setting.limits.position_error_m),
        reach_m_(end_reach_m(setting)) {}
  void keep_from(Vec2 robot) { (void)robots_.push(robot); }
  void keep_from_way(Vec2 from, const Path& plan) {
    keep_from(from);
    for (std::size_t i = plan.index; i < plan.points.size(); ++i) {
      (void)way_.push({from, plan.points[i]});
      from = plan.points[i];
    }
  }
  // A place to go to has room for how near to its end a leg ends, as measured, and for errors of
  // that and of the place where it comes to rest; a place to stay at, for the other's view of this
  // one, so that the passing robot sees the gap too.
  [[nodiscard]] bool accepts(Vec2 place, double) const override {
    return clear(place, gap_m_ + 3 * error_m_ + reach_m_);
  }
  [[nodiscard]] bool good_enough(Vec2 place) const { return clear(place, gap_m_ + error_m_); }

 private:
  struct Leg {
    Vec2 a, b;
  };
  [[nodiscard]] bool clear(Vec2 place, double gap_m) const {
    for (const Vec2 robot : robots_) {
      if (norm(place - robot) < gap_m) return false;
    }
    for (const Leg& leg : way_) {
      if (distance_to_segment(place, leg.a, leg.b) < gap_m) return false;
    }
    return true;
  }

  double gap_m_, error_m_, reach_m_;
  FixedList<Vec2, max_robots> robots_;
  FixedList<Leg, max_waypoints> way_;
};

// No leg of the query may come nearer to a HELD robot than where it begins.
void recede_from_held(const Observation& observation, RouteQuery& query);

}  // namespace rtac::safe
