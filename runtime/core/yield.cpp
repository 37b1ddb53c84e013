#include <algorithm>

#include "rtac/safe/manoeuvre.h"

namespace rtac::safe {
namespace {

constexpr TimeUs look_every_us = 1'000'000;
// Time for the other robots to notice the hold and go on, before this one makes room.
constexpr TimeUs patience_us = 2'000'000;
// Longest time without a lease: after it the wish is given up, so that the others may rely on the
// hold again.
constexpr TimeUs wanting_us_max = 10'000'000;

// Far enough from given robots and from the way of one of them.
class Aside : public PlaceTest {
 public:
  explicit Aside(const Setting& setting)
      : gap_m_(setting.pass_gap_m), error_m_(setting.limits.position_error_m) {}
  void keep_from(Vec2 robot) { (void)robots_.push(robot); }
  void keep_from_way(Vec2 from, const Path& plan) {
    keep_from(from);
    for (std::size_t i = plan.index; i < plan.points.size(); ++i) {
      (void)way_.push({from, plan.points[i]});
      from = plan.points[i];
    }
  }
  // A place to go to has room for the position errors of either robot and of the arrival; a place
  // to stay at, for the other's view of this one, so that the passing robot sees the gap too.
  [[nodiscard]] bool accepts(Vec2 place, double) const override {
    return clear(place, gap_m_ + 3 * error_m_);
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

  double gap_m_, error_m_;
  FixedList<Vec2, max_robots> robots_;
  FixedList<Leg, max_waypoints> way_;
};

void recede_from_held(const Observation& observation, RouteQuery& query) {
  for (int j = 0; j < observation.robots; ++j) {
    const Announcement& other = observation.others[static_cast<std::size_t>(j)];
    if (j == observation.self || !is_held(other, observation.now_us)) continue;
    (void)query.recede_from.push(other.position.value);  // never more than robots
  }
}

}  // namespace

void YieldManoeuvre::engage(const Observation&) {
  stay();
  cornered_ = false;
  held_since_us_ = wanting_since_us_ = next_look_us_ = never_us;
}

bool YieldManoeuvre::must_back_off(const Observation& observation) const {
  bool somebody = false;
  for (int j = 0; j < observation.robots; ++j) {
    const Announcement& other = observation.others[static_cast<std::size_t>(j)];
    if (j == observation.self || other.position.stamp_us == never_us) continue;
    const double distance_m = norm(other.position.value - observation.position.value);
    if (distance_m > 2 * setting_.pass_gap_m) continue;
    if (!is_held(other, observation.now_us) || !outranks(observation, j)) return false;
    somebody = true;
  }
  return somebody;
}

void YieldManoeuvre::start_waiting(const Observation& observation) {
  stay();
  held_since_us_ = observation.now_us;
  wanting_since_us_ = never_us;
}

void YieldManoeuvre::update(const Observation& observation, Gate gate, bool at_rest) {
  if (!at_rest) {
    held_since_us_ = wanting_since_us_ = never_us;
    return;
  }
  const TimeUs now_us = observation.now_us;
  if (wants_motion()) {
    if (wanting_since_us_ == never_us) wanting_since_us_ = now_us;
    if (now_us >= next_look_us_) reconsider(observation, gate);
    return;
  }
  if (held_since_us_ == never_us) start_waiting(observation);
  if (now_us < next_look_us_) return;
  next_look_us_ = now_us + look_every_us;
  cornered_ = false;
  if (const int asker = asks_for_passage(observation); asker >= 0) {
    make_passage(observation, gate, asker);
  } else if (now_us - held_since_us_ >= patience_us && must_back_off(observation)) {
    back_off(observation);
  }
  if (wants_motion()) wanting_since_us_ = now_us;
}

// At rest although it wants to move: the lease is still running, or the gate is closed.
void YieldManoeuvre::reconsider(const Observation& observation, Gate gate) {
  const TimeUs now_us = observation.now_us;
  next_look_us_ = now_us + look_every_us;
  const int asker = asks_for_passage(observation);
  const bool reason_left = asker >= 0 || must_back_off(observation);
  if (!reason_left || now_us - wanting_since_us_ > wanting_us_max) {
    start_waiting(observation);
    next_look_us_ = now_us + patience_us;
    return;
  }
  if (gate == Gate::hold) return;
  // The gate is open, yet the way does not lead away from everybody any more: look for another.
  if (asker >= 0) {
    make_passage(observation, gate, asker);
  } else {
    back_off(observation);
  }
  if (!wants_motion()) start_waiting(observation);
}

void YieldManoeuvre::make_passage(const Observation& observation, Gate gate, int asker) {
  const Announcement& other = observation.others[static_cast<std::size_t>(asker)];
  Aside aside(setting_);
  aside.keep_from_way(other.position.value, other.plan);
  stay();
  if (aside.good_enough(observation.position.value)) return;  // already out of the way
  RouteQuery away = query(observation, false);
  recede_from_held(observation, away);
  if (route_.to_place(away, aside, way_)) return;
  // With a free gate the separation test itself watches the way.
  if (gate == Gate::free && route_.to_place(query(observation, false), aside, way_)) return;
  stay();
}

void YieldManoeuvre::back_off(const Observation& observation) {
  Aside aside(setting_);
  for (int j = 0; j < observation.robots; ++j) {
    const Announcement& other = observation.others[static_cast<std::size_t>(j)];
    if (j == observation.self || other.position.stamp_us == never_us) continue;
    const double distance_m = norm(other.position.value - observation.position.value);
    if (distance_m <= 2 * setting_.pass_gap_m) aside.keep_from(other.position.value);
  }
  stay();
  if (aside.good_enough(observation.position.value)) return;
  RouteQuery away = query(observation, false);
  recede_from_held(observation, away);
  if (route_.to_place(away, aside, way_)) return;
  stay();
  cornered_ = true;
}

}  // namespace rtac::safe
