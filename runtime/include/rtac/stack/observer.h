// What the software stack tells about itself: for logs, pictures and tests. Called from the ticks,
// so an observer that must not disturb them does not block or allocate.
#pragma once

#include "rtac/decision.h"
#include "rtac/types.h"

namespace rtac {

enum class SkipReason : std::int8_t {
  rejected,     // plans to it were rejected by the decision module
  unreachable,  // no admissible plan, not even without the other robots
  blocked,      // other robots stood in the way for too long
  stalled       // no progress towards it for too long
};
const char* skip_text(SkipReason reason);

class SystemObserver {
 public:
  virtual ~SystemObserver() = default;
  // Every step of a decision module and every judged plan.
  virtual void on_decision(const DecisionRecord&) {}
  virtual void on_task(int /*robot*/, Vec2 /*destination*/, TimeUs /*now_us*/) {}
  // A plan that is driven from now on; `safe`: of the safe planner.
  virtual void on_plan(int /*robot*/, const Path&, bool /*safe*/) {}
  // The way exists, but robots stand on it.
  virtual void on_blocked(int /*robot*/, const Path& /*way*/, TimeUs /*now_us*/) {}
  virtual void on_delivered(int /*robot*/, Vec2 /*destination*/, TimeUs /*now_us*/) {}
  virtual void on_skipped(int /*robot*/, Vec2 /*destination*/, TimeUs /*now_us*/, SkipReason) {}
  // The watchdog found the decision late: this tick brakes.
  virtual void on_late(int /*robot*/, TimeUs /*now_us*/) {}
};

}  // namespace rtac
