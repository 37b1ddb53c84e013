#include "oracle.h"

#include <algorithm>
#include <utility>

namespace rtac::simulate {
namespace {

// Longer than any dwell: control returns after so many ticks, or not at all.
constexpr int ticks_max = 400;

Sample<Vec2> measured(Vec3 v, TimeUs stamp_us) {
  return {{v.x, v.y}, stamp_us};
}

TimeUs position_age(const DecisionCase& decision) {
  return std::min(decision.limits.position_age_us, decision.limits.velocity_age_us);
}

}  // namespace

Observation observed(const DecisionCase& decision, int self, const std::vector<Moving>& robots,
                     TimeUs now_us, Vec3 proposed) {
  const RobotLimits& l = decision.limits;
  Observation o;
  o.now_us = now_us;
  o.robots = static_cast<int>(robots.size());
  o.self = self;
  const Moving& own = robots[static_cast<std::size_t>(self)];
  o.position = measured(own.position, now_us - position_age(decision));
  o.velocity = measured(own.velocity, now_us - l.velocity_age_us);
  o.height_m = own.position.z;
  o.climb_mps = own.velocity.z;
  o.heading = {own.heading_rad, now_us - std::min(l.heading_age_us, position_age(decision))};
  o.battery = {own.battery, now_us};
  o.sent = measured({}, now_us - decision.period_us);
  o.proposed = measured(proposed, now_us);
  o.proposed_up_mps2 = proposed.z;
  o.plan.stamp_us = now_us;  // none to follow: the duration alone decides
  for (std::size_t j = 0; j < robots.size(); ++j) {
    if (static_cast<int>(j) == self) continue;
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

void remember(KernelDecision& kernel, const DecisionCase& decision, int self,
              const std::vector<Moving>& standing, TimeUs begin_us) {
  const TimeUs period_us = decision.period_us;
  for (TimeUs tick = (decision.memory_us + period_us - 1) / period_us; tick > 0; --tick) {
    (void)kernel.step(observed(decision, self, standing, begin_us - tick * period_us, {}), false,
                      false);
  }
}

Oracle::Oracle(const DecisionCase& decision, const Kernel::Functions& kernel, int self,
               std::optional<TimeUs> begins_us)
    : decision_(decision),
      self_(self),
      agents_(decision.agents.size(), far_away),
      kernel_(
          kernel, decision, self,
          [this](int, int agent, TimeUs now_us) {
            const auto k = static_cast<std::size_t>(agent);
            return Sample<Vec3>{agents_[k], now_us - decision_.agents[k].age_us};
          },
          begins_us.value_or(early_us + decision.memory_us)) {}

TimeUs Oracle::position_age_us() const {
  return position_age(decision_);
}
TimeUs Oracle::velocity_age_us() const {
  return decision_.limits.velocity_age_us;
}

void Oracle::start(const std::vector<Moving>& robots) {
  kernel_.reset();
  now_us_ = 0;
  remember(kernel_, decision_, self_, robots, now_us_);
}

const DecisionRecord& Oracle::step(const std::vector<Moving>& robots, Vec3 proposed) {
  const TimeUs now_us = std::exchange(now_us_, now_us_ + decision_.period_us);
  return kernel_.step(observed(decision_, self_, robots, now_us, proposed), false, false);
}

int Oracle::ticks_until_advanced(const std::vector<Moving>& robots) {
  start(robots);
  for (int k = 1; k <= ticks_max; ++k) {
    if (step(robots, {}).mode == 0) return k;
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
  start(robots);
  return step(robots, {}).monitors[monitor].now == Verdict::is_true;
}

bool Oracle::passes(const std::vector<Moving>& robots, std::size_t monitor) {
  start(robots);
  for (int k = 1; k <= ticks_; ++k) (void)step(settled_, {});
  return step(robots, proposed_).monitors[monitor].ahead == Verdict::is_true;
}

}  // namespace rtac::simulate
