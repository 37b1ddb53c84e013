#include "rtac/stack/system.h"

#include <algorithm>

namespace rtac {

template <class Output>
struct System<Output>::Stack {
  Stack(int index, int robots, const RobotParts<Output>& parts, const SystemOptions& options,
        SystemObserver& observer)
      : robot(index, parts.safe_planner != nullptr, options, observer),
        planner({index, parts.advanced_planner, parts.safe_planner, parts.plan_decision,
                 options.protect, options.detour_m},
                observer),
        executor(index, robots, parts, options, observer),
        period_us(parts.period_us) {}

  stack::Robot robot;
  stack::MotionPlanner planner;
  stack::PlanExecutor<Output> executor;
  TimeUs period_us;
  TimeUs next_us = 0;
};

template <class Output>
System<Output>::System(TaskSource& tasks, const RobotParts<Output>* robots, int robot_count,
                       const SystemOptions& options, SystemObserver* observer)
    : task_planner_(tasks, observer != nullptr ? *observer : silent_), robot_count_(robot_count) {
  if (robots == nullptr || robot_count < 1 || robot_count > static_cast<int>(max_robots)) return;
  SystemObserver& told = observer != nullptr ? *observer : silent_;
  bool wired = executive_.add(task_planner_) == Status::ok;
  for (int i = 0; i < robot_count; ++i) {
    if (!complete(robots[i])) return;
    auto& own = robots_[static_cast<std::size_t>(i)];
    own = std::make_unique<Stack>(i, robot_count, robots[i], options, told);
    own->robot.connect(task_planner_, own->planner, own->executor);
    own->planner.connect(own->robot, own->executor);
    own->executor.connect(own->robot);
    wired = wired && task_planner_.add(own->robot) == Status::ok;
    for (MachineBase* machine :
         {static_cast<MachineBase*>(&own->robot), static_cast<MachineBase*>(&own->planner),
          static_cast<MachineBase*>(&own->executor)}) {
      wired = wired && executive_.add(*machine) == Status::ok;
    }
  }
  complete_ = wired;
}

template <class Output>
System<Output>::~System() = default;

template <class Output>
bool System<Output>::complete(const RobotParts<Output>& parts) const {
  if (parts.decision == nullptr || parts.advanced == nullptr) return false;
  if (parts.advanced_planner == nullptr || parts.period_us <= 0) return false;
  const auto monitors = static_cast<std::size_t>(parts.decision->info().monitor_count);
  if (parts.recoveries.empty() || parts.recoveries.size() != monitors) return false;
  return std::all_of(parts.recoveries.begin(), parts.recoveries.end(),
                     [](const SafeController<Output>* recovery) { return recovery != nullptr; });
}

template <class Output>
TimeUs System<Output>::next_tick_us() const {
  TimeUs next_us = robots_[0]->next_us;
  for (int i = 1; i < robot_count_; ++i) {
    next_us = std::min(next_us, robots_[static_cast<std::size_t>(i)]->next_us);
  }
  return next_us;
}

template <class Output>
Status System<Output>::tick_due(TimeUs now_us) {
  for (int i = 0; i < robot_count_; ++i) {
    Stack& own = *robots_[static_cast<std::size_t>(i)];
    if (own.next_us > now_us) continue;
    own.executor.post(stack::Tick{now_us});
    // Ticks that were missed are not made up for: the decision module counts them as unknown.
    own.next_us += own.period_us * ((now_us - own.next_us) / own.period_us + 1);
  }
  if (const Status status = executive_.run_until_quiescent(); status != Status::ok) return status;
  std::uint64_t dropped = task_planner_.dropped();
  for (int i = 0; i < robot_count_; ++i) {
    const Stack& own = *robots_[static_cast<std::size_t>(i)];
    dropped += own.robot.dropped() + own.planner.dropped() + own.executor.dropped();
  }
  return dropped == 0 ? Status::ok : Status::full;
}

template <class Output>
Status System<Output>::run(FleetSdk<Output>& fleet, TimeUs until_us) {
  if (!complete_) return Status::bad_argument;
  for (int i = 0; i < robot_count_; ++i) {
    Stack& own = *robots_[static_cast<std::size_t>(i)];
    own.executor.attach(fleet.robot(i));
    if (!started_) own.next_us = fleet.now_us();
  }
  started_ = true;
  for (TimeUs due_us = next_tick_us(); due_us < until_us; due_us = next_tick_us()) {
    if (!fleet.wait_until(due_us)) return Status::stopped;
    if (const Status status = tick_due(fleet.now_us()); status != Status::ok) return status;
  }
  return fleet.wait_until(until_us) ? Status::ok : Status::stopped;
}

template class System<Twist>;
template class System<Acceleration>;

}  // namespace rtac
