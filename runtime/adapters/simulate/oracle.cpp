#include "oracle.h"

#include <algorithm>

namespace rtac::simulate {
namespace {

// Longer than any dwell: control returns after so many ticks, or not at all.
constexpr int ticks_max = 400;
constexpr TimeUs begin_us = 1'000'000'000;  // no sample is older than the clock

Sample<Vec2> measured(Vec3 v, TimeUs stamp_us) {
  return {{v.x, v.y}, stamp_us};
}

}  // namespace

// The position is never older than the velocity: what has happened to a robot between the two is
// then bounded by its acceleration alone.
Oracle::Oracle(const DecisionCase& decision, const Kernel::Functions& kernel, int self)
    : decision_(decision),
      self_(self),
      position_age_us_(std::min(decision.limits.position_age_us, decision.limits.velocity_age_us)),
      velocity_age_us_(decision.limits.velocity_age_us),
      agents_(decision.agents.size(), far_away),
      kernel_(kernel, decision, self, [this](int, int agent, TimeUs now_us) {
        const auto k = static_cast<std::size_t>(agent);
        return Sample<Vec3>{agents_[k], now_us - decision_.agents[k].age_us};
      }) {}

Observation Oracle::seen(const std::vector<Moving>& robots, TimeUs now_us, Vec3 proposed) const {
  const RobotLimits& l = decision_.limits;
  Observation o;
  o.now_us = now_us;
  o.robots = static_cast<int>(robots.size());
  o.self = self_;
  const Moving& self = robots[static_cast<std::size_t>(self_)];
  o.position = measured(self.position, now_us - position_age_us_);
  o.velocity = measured(self.velocity, now_us - velocity_age_us_);
  o.height_m = self.position.z;
  o.climb_mps = self.velocity.z;
  o.heading = {self.heading_rad, now_us - std::min(l.heading_age_us, position_age_us_)};
  o.battery = {self.battery, now_us};
  o.sent = measured({}, now_us - decision_.period_us);
  o.proposed = measured(proposed, now_us);
  o.proposed_up_mps2 = proposed.z;
  o.plan.stamp_us = now_us;  // none to follow: the duration alone decides
  for (std::size_t j = 0; j < robots.size(); ++j) {
    if (static_cast<int>(j) == self_) continue;
    Announcement& heard = o.others[j];
    heard.position = measured(robots[j].position, now_us - l.hears_age_us);
    heard.velocity = measured(robots[j].velocity, now_us - l.hears_age_us);
    heard.height_m = robots[j].position.z;
    heard.climb_mps = robots[j].velocity.z;
    heard.present = {true, now_us};
    heard.plan.stamp_us = now_us;
  }
  return o;
}

int Oracle::ticks_until_advanced(const std::vector<Moving>& robots) {
  kernel_.reset();
  for (int k = 1; k <= ticks_max; ++k) {
    if (kernel_.step(seen(robots, begin_us + k * decision_.period_us, {}), false, false).mode == 0)
      return k;
  }
  return 0;
}

bool Oracle::settle(const std::vector<Moving>& robots) {
  const int ticks = ticks_until_advanced(robots);
  if (ticks == 0) return false;
  settled_ = robots;
  ticks_ = ticks;
  return true;
}

bool Oracle::holds(const std::vector<Moving>& robots, std::size_t monitor) {
  kernel_.reset();
  const TimeUs now_us = begin_us + decision_.period_us;
  return kernel_.step(seen(robots, now_us, {}), false, false).monitors[monitor].now ==
         Verdict::is_true;
}

bool Oracle::passes(const std::vector<Moving>& robots, std::size_t monitor) {
  kernel_.reset();
  for (int k = 1; k <= ticks_; ++k) {
    kernel_.step(seen(settled_, begin_us + k * decision_.period_us, {}), false, false);
  }
  const DecisionRecord& record = kernel_.step(
      seen(robots, begin_us + (ticks_ + 1) * decision_.period_us, proposed_), false, false);
  return record.monitors[monitor].ahead == Verdict::is_true;
}

}  // namespace rtac::simulate
