#include "oracle.h"

#include <algorithm>

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

Oracle::Oracle(const DecisionCase& decision, const Kernel::Functions& kernel, int self,
               TimeUs begins_us)
    : decision_(decision),
      self_(self),
      agents_(decision.agents.size(), far_away),
      kernel_(
          kernel, decision, self,
          [this](int, int agent, TimeUs now_us) {
            const auto k = static_cast<std::size_t>(agent);
            return Sample<Vec3>{agents_[k], now_us - decision_.agents[k].age_us};
          },
          begins_us == 0 ? 0 : begins_us - oracle_begins_us) {}

TimeUs Oracle::position_age_us() const {
  return position_age(decision_);
}
TimeUs Oracle::velocity_age_us() const {
  return decision_.limits.velocity_age_us;
}

const DecisionRecord& Oracle::step(const std::vector<Moving>& robots, int tick, Vec3 proposed) {
  const TimeUs now_us = oracle_begins_us + tick * decision_.period_us;
  return kernel_.step(observed(decision_, self_, robots, now_us, proposed), false, false);
}

int Oracle::ticks_until_advanced(const std::vector<Moving>& robots) {
  kernel_.reset();
  for (int k = 1; k <= ticks_max; ++k) {
    if (step(robots, k, {}).mode == 0) return k;
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
  return step(robots, 1, {}).monitors[monitor].now == Verdict::is_true;
}

bool Oracle::passes(const std::vector<Moving>& robots, std::size_t monitor) {
  kernel_.reset();
  for (int k = 1; k <= ticks_; ++k) (void)step(settled_, k, {});
  return step(robots, ticks_ + 1, proposed_).monitors[monitor].ahead == Verdict::is_true;
}

}  // namespace rtac::simulate
