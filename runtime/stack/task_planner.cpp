#include "rtac/stack/machines.h"

namespace rtac {

const char* skip_text(SkipReason reason) {
  switch (reason) {
    case SkipReason::rejected:
      return "plans rejected";
    case SkipReason::unreachable:
      return "unreachable";
    case SkipReason::blocked:
      return "blocked by robots";
    case SkipReason::stalled:
      return "no progress";
  }
  return "?";
}

}  // namespace rtac

namespace rtac::stack {

void TaskPlanner::handle(const TaskEvent& event) {
  std::visit([this](const auto& e) { on(e); }, event);
}

void TaskPlanner::on(const TaskWanted& event) {
  assign_next(event.robot, event.now_us);
}

void TaskPlanner::on(const TaskCompleted& event) {
  source_.completed(event.robot, event.destination, event.now_us);
  assign_next(event.robot, event.now_us);
}

void TaskPlanner::on(const TaskSkipped& event) {
  source_.skipped(event.robot, event.destination, event.now_us);
  assign_next(event.robot, event.now_us);
}

void TaskPlanner::assign_next(int robot, TimeUs now_us) {
  RobotMachine& machine = *robots_[static_cast<std::size_t>(robot)];
  Vec2 destination;
  if (!source_.next(robot, destination)) {
    machine.post(NoTask{});
    return;
  }
  observer_.on_task(robot, destination, now_us);
  machine.post(TaskAssigned{destination, now_us});
}

}  // namespace rtac::stack
