#include "rtac/sim/judge.h"

#include <algorithm>
#include <utility>

#include "rtac/sim/math.h"

namespace rtac::sim {
namespace {

// Rounding of two distances, generously: positions are below 1e5 m.
constexpr double rounding_m = 1e-9;

}  // namespace

SafetyJudge::SafetyJudge(const std::vector<double>& radius_m, const Requirements& requirements)
    : radius_m_(radius_m),
      requirements_(requirements),
      clearance_(radius_m.size()),
      battery_(radius_m.size()),
      gap_(radius_m.size() * radius_m.size()),
      anchors_(radius_m.size()) {}

void SafetyJudge::watch_zone(const ZoneView& zone) {
  zone_ = zone;
  zone_.tree = nullptr;  // looks at every edge: a mistake in the tables must not judge itself
  has_zone_ = true;
  anchors_.assign(radius_m_.size(), Anchor{});
}

void SafetyJudge::watch_battery(std::function<double(int, const TruthState&)> margin) {
  battery_margin_ = std::move(margin);
}

void SafetyJudge::record(Watch& watch, double value, double requirement, TimeUs now_us,
                         Vec2 place) {
  Finding& finding = watch.finding;
  if (value < finding.smallest) {
    finding.smallest = value;
    finding.time_us = now_us;
    finding.place = place;
  }
  // Written so that a value that is not a number counts as a violation.
  const bool below = !(value >= requirement);
  if (below && !watch.below) ++finding.episodes;
  if (below && finding.first_violation_us == never_us) finding.first_violation_us = now_us;
  watch.below = below;
}

void SafetyJudge::judge_clearance(std::size_t robot, TimeUs now_us, Vec2 place) {
  Anchor& anchor = anchors_[robot];
  Watch& watch = clearance_[robot];
  if (anchor.valid && !watch.below) {
    const double moved = length(place - anchor.place);
    const double at_least = anchor.centre_clearance_m - moved - rounding_m - radius_m_[robot];
    if (at_least > std::max(watch.finding.smallest, requirements_.clearance_m)) return;
  }
  anchor = {true, place, signed_clearance(zone_, place)};
  record(watch, anchor.centre_clearance_m - radius_m_[robot], requirements_.clearance_m, now_us,
         place);
}

void SafetyJudge::judge_gaps(std::size_t robot, TimeUs now_us,
                             const std::vector<TruthState>& truths) {
  const Vec2 place = truths[robot].position;
  for (std::size_t other = robot + 1; other < radius_m_.size(); ++other) {
    const double distance = length(truths[other].position - place);
    record(gap_[robot * radius_m_.size() + other], distance - radius_m_[robot] - radius_m_[other],
           requirements_.gap_m, now_us, place);
  }
}

void SafetyJudge::observe(TimeUs now_us, const std::vector<TruthState>& truths) {
  if (truths.size() < radius_m_.size()) return;
  for (std::size_t i = 0; i < radius_m_.size(); ++i) {
    if (has_zone_) judge_clearance(i, now_us, truths[i].position);
    judge_gaps(i, now_us, truths);
    if (battery_margin_) {
      const double margin = battery_margin_(static_cast<int>(i), truths[i]);
      record(battery_[i], margin, requirements_.battery_margin, now_us, truths[i].position);
    }
  }
}

const Finding& SafetyJudge::clearance(int robot) const {
  return clearance_[static_cast<std::size_t>(robot)].finding;
}

const Finding& SafetyJudge::gap(int robot, int other) const {
  const auto row = static_cast<std::size_t>(std::min(robot, other));
  const auto column = static_cast<std::size_t>(std::max(robot, other));
  return gap_[row * radius_m_.size() + column].finding;
}

const Finding& SafetyJudge::battery(int robot) const {
  return battery_[static_cast<std::size_t>(robot)].finding;
}

TimeUs SafetyJudge::first_violation_us() const {
  TimeUs first = never_us;
  for (const std::vector<Watch>* watches : {&clearance_, &gap_, &battery_}) {
    for (const Watch& watch : *watches) {
      const TimeUs time_us = watch.finding.first_violation_us;
      if (time_us != never_us && (first == never_us || time_us < first)) first = time_us;
    }
  }
  return first;
}

bool SafetyJudge::violated() const {
  return first_violation_us() != never_us;
}

}  // namespace rtac::sim
