#include "rtac/sim/referee.h"

#include <algorithm>

#include "rtac/sim/math.h"

namespace rtac::sim {

Referee::Referee(const Surroundings& surroundings, const std::vector<Property>& properties,
                 int robots, int about)
    : surroundings_(surroundings),
      properties_(properties),
      least_(properties.size()),
      anchors_(properties.size() * static_cast<std::size_t>(robots)),
      way_m_(static_cast<std::size_t>(robots), 0),
      about_(about) {
  for (const Property& p : properties) steepness_per_m_.push_back(steepness_per_m(p));
}

void Referee::count_ways(const std::vector<TruthState>& truths) {
  if (before_.size() != way_m_.size()) {
    for (const TruthState& truth : truths) before_.push_back(position_of(truth));
    before_.resize(way_m_.size());
  }
  double fastest_m = 0;
  for (std::size_t i = 0; i < way_m_.size(); ++i) {
    const double moved_m = length(position_of(truths[i]) - before_[i]);
    before_[i] = position_of(truths[i]);
    way_m_[i] += moved_m;
    fastest_m = std::max(fastest_m, moved_m);
  }
  fastest_way_m_ += fastest_m;
}

void Referee::judge(std::size_t monitor, std::size_t robot, TimeUs now_us,
                    const std::vector<TruthState>& truths) {
  Anchor& anchor = anchors_[monitor * way_m_.size() + robot];
  LeastMargin& least = least_[monitor];
  const double way_m = way_m_[robot] + fastest_way_m_;
  if (steepness_per_m_[monitor] > 0) {
    const double moved_m = way_m - anchor.way_m + referee_rounding;
    const double at_least = anchor.margin - steepness_per_m_[monitor] * moved_m;
    if (at_least > std::max(least.value, 0.0)) return;
  }
  Scene scene = scene_of(surroundings_, truths, static_cast<int>(robot));
  scene.passive = true;
  anchor = {margin_of(properties_[monitor], scene), way_m};
  if (anchor.margin < least.value) least = {anchor.margin, now_us, static_cast<int>(robot)};
  if (about_ >= 0 && static_cast<std::size_t>(about_) != monitor) return;
  // Written so that a value that is not a number counts as a violation.
  if (!(anchor.margin >= -referee_rounding) && !violated()) {
    violation_ = {now_us, static_cast<int>(monitor), static_cast<int>(robot)};
  }
}

void Referee::observe(TimeUs now_us, const std::vector<TruthState>& truths) {
  if (truths.size() < way_m_.size()) return;
  count_ways(truths);
  for (std::size_t m = 0; m < properties_.size(); ++m) {
    for (std::size_t r = 0; r < way_m_.size(); ++r) judge(m, r, now_us, truths);
  }
}

}  // namespace rtac::sim
