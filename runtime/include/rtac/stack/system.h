// A whole system: the machines of all robots, wired, and run against the robots' SDK.
#pragma once

#include <array>
#include <memory>

#include "rtac/stack/plan_executor.h"

namespace rtac {

template <class Output>
class System {
 public:
  // The parts stay the property of the caller and outlive the system; `observer` may be null.
  System(TaskSource& tasks, const RobotParts<Output>* robots, int robot_count,
         const SystemOptions& options = {}, SystemObserver* observer = nullptr);
  ~System();
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  // Ticks every robot once per period, the first time at the clock's present reading, in the order
  // of the fleet, as long as tick times lie before `until_us`. May be called again to go on.
  // bad_argument: parts are missing; stopped: the platform said so; full: a queue overflowed.
  Status run(FleetSdk<Output>& fleet, TimeUs until_us);

 private:
  struct Stack;

  [[nodiscard]] bool complete(const RobotParts<Output>& parts) const;
  [[nodiscard]] TimeUs next_tick_us() const;
  Status tick_due(TimeUs now_us);

  SystemObserver silent_;
  stack::TaskPlanner task_planner_;
  std::array<std::unique_ptr<Stack>, max_robots> robots_;
  int robot_count_ = 0;
  Executive executive_;
  bool complete_ = false, started_ = false;
};

extern template class System<Twist>;
extern template class System<Acceleration>;

}  // namespace rtac
