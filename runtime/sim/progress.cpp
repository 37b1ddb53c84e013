#include "rtac/sim/progress.h"

#include <utility>

#include "rtac/sim/math.h"

namespace rtac::sim {

ProgressMeter::ProgressMeter(int robots, TimeUs start_us)
    : robots_(static_cast<std::size_t>(robots)) {
  for (Robot& robot : robots_) robot.last_us = robot.longest_from_us = start_us;
}

void ProgressMeter::measure_by(std::function<double(int, Vec2, Vec2)> distance) {
  distance_ = std::move(distance);
}

void ProgressMeter::set_goal(int robot, Vec2 goal) {
  Robot& entry = at(robot);
  entry.has_goal = entry.is_new_goal = true;
  entry.is_finished = false;
  entry.goal = goal;
}

void ProgressMeter::delivered(int robot, TimeUs now_us) {
  Robot& entry = at(robot);
  ++entry.deliveries;
  entry.has_goal = false;
  progress(entry, now_us);
}

void ProgressMeter::finished(int robot, TimeUs now_us) {
  Robot& entry = at(robot);
  extend(entry, now_us);
  entry.has_goal = false;
  entry.is_finished = true;
}

void ProgressMeter::extend(Robot& robot, TimeUs now_us) {
  if (now_us - robot.last_us <= robot.longest_us) return;
  robot.longest_us = now_us - robot.last_us;
  robot.longest_from_us = robot.last_us;
}

void ProgressMeter::progress(Robot& robot, TimeUs now_us) {
  extend(robot, now_us);
  robot.last_us = now_us;
}

void ProgressMeter::observe(TimeUs now_us, const std::vector<TruthState>& truths) {
  for (std::size_t i = 0; i < robots_.size() && i < truths.size(); ++i) {
    Robot& robot = robots_[i];
    if (robot.is_finished) {
      robot.last_us = now_us;
      continue;
    }
    bool advanced = truths[i].charging;
    if (robot.has_goal) {
      const Vec2 from = truths[i].position;
      const double remaining =
          distance_ ? distance_(static_cast<int>(i), from, robot.goal) : length(robot.goal - from);
      // The first look at a goal only sets the mark.
      const bool closer = !robot.is_new_goal && remaining <= robot.best_m - progress_step_m;
      if (robot.is_new_goal || closer) robot.best_m = remaining;
      robot.is_new_goal = false;
      advanced = advanced || closer;
    }
    advanced ? progress(robot, now_us) : extend(robot, now_us);
  }
}

int ProgressMeter::deliveries(int robot) const {
  return at(robot).deliveries;
}
TimeUs ProgressMeter::longest_us(int robot) const {
  return at(robot).longest_us;
}
TimeUs ProgressMeter::longest_from_us(int robot) const {
  return at(robot).longest_from_us;
}

}  // namespace rtac::sim
