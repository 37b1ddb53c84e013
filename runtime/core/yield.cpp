#include "passage.h"
#include "rtac/safe/manoeuvre.h"
#include "rtac/safe/pace.h"

namespace rtac::safe {
namespace {

// Time for the other robots to notice the hold and go on, before this one makes room.
constexpr TimeUs patience_us = 2'000'000;
// Who goes first may be led by another recovery, which tries again and again to pass where this one
// holds: after that time it makes room though it does not go first. Longer than any other wait.
constexpr TimeUs long_patience_us = 20'000'000;
// Longest time without a lease: after it the wish is given up, so that the others may rely on the
// hold again.
constexpr TimeUs wanting_us_max = 10'000'000;

}  // namespace

void YieldManoeuvre::engage(const Observation&) {
  stay();
  cornered_ = false;
  held_since_us_ = wanting_since_us_ = next_look_us_ = never_us;
}

// One after the other: of two that set out at the same time each keeps the gate of the other one
// closed, as neither holds any more.
int YieldManoeuvre::makes_way_for(const Observation& observation) const {
  for (int j = 0; j < observation.robots; ++j) {
    const Announcement& other = observation.others[static_cast<std::size_t>(j)];
    if (j == observation.self || other.position.stamp_us == never_us) continue;
    const double distance_m = norm(seen_at(other, observation.now_us) - at_);
    const bool near = distance_m <= 2 * setting_.pass_gap_m;
    if (near && goes_first(observation, j) && !is_held(other, observation.now_us)) return -1;
  }
  return asks_for_passage(observation);
}

bool YieldManoeuvre::waits_in_vain(const Observation& observation) const {
  return held_since_us_ != never_us && observation.now_us - held_since_us_ >= long_patience_us;
}

bool YieldManoeuvre::must_back_off(const Observation& observation) const {
  bool somebody = false;
  for (int j = 0; j < observation.robots; ++j) {
    const Announcement& other = observation.others[static_cast<std::size_t>(j)];
    if (j == observation.self || other.position.stamp_us == never_us) continue;
    const double distance_m = norm(seen_at(other, observation.now_us) - at_);
    if (distance_m > 2 * setting_.pass_gap_m) continue;
    const bool holds = is_held(other, observation.now_us);
    const bool in_vain = distance_m <= setting_.pass_gap_m && waits_in_vain(observation);
    if (!in_vain && (!holds || goes_first(observation, j))) return false;
    somebody = true;
  }
  return somebody;
}

void YieldManoeuvre::start_waiting(const Observation& observation) {
  stay();
  held_since_us_ = observation.now_us;
  wanting_since_us_ = never_us;
}

void YieldManoeuvre::decide(const Observation& observation, Gate gate, bool at_rest) {
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
  next_look_us_ = now_us + pace::look_every_us;
  cornered_ = false;
  if (const int asker = makes_way_for(observation); asker >= 0) {
    make_passage(observation, gate, asker);
  } else if (now_us - held_since_us_ >= patience_us && must_back_off(observation)) {
    back_off(observation);
  }
  if (wants_motion()) wanting_since_us_ = now_us;
}

// At rest although it wants to move: the lease is still running, or the gate is closed.
void YieldManoeuvre::reconsider(const Observation& observation, Gate gate) {
  const TimeUs now_us = observation.now_us;
  next_look_us_ = now_us + pace::look_every_us;
  const int asker = makes_way_for(observation);
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

void YieldManoeuvre::back_off(const Observation& observation) {
  Aside aside(setting_);
  for (int j = 0; j < observation.robots; ++j) {
    const Announcement& other = observation.others[static_cast<std::size_t>(j)];
    if (j == observation.self || other.position.stamp_us == never_us) continue;
    const double distance_m = norm(seen_at(other, observation.now_us) - at_);
    if (distance_m <= 2 * setting_.pass_gap_m) aside.keep_from(seen_at(other, observation.now_us));
  }
  stay();
  if (aside.good_enough(at_)) return;
  if (get_away(observation, aside)) return;
  stay();
  cornered_ = true;
}

}  // namespace rtac::safe
