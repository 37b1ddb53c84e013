// Measures whether robots get on with their work. Progress is: a delivery, charging at the dock,
// or a remaining distance to the present goal that is at least 10 cm smaller than ever before
// since that goal was set (or since the last such step).
#pragma once

#include <functional>
#include <vector>

#include "rtac/sim/world.h"

namespace rtac::sim {

inline constexpr double progress_step_m = 0.10;

class ProgressMeter {
 public:
  // All robots start at `start_us`, without a goal.
  explicit ProgressMeter(int robots, TimeUs start_us = 0);

  // Remaining distance; straight line unless set. Called at every step of a robot with a goal.
  void measure_by(std::function<double(int robot, Vec2 from, Vec2 goal)> distance);

  // A new goal is no progress by itself: skipping from goal to goal must not count.
  void set_goal(int robot, Vec2 goal);
  void delivered(int robot, TimeUs now_us);
  // Nothing left to do from now on: waiting is no longer held against it. Ends with set_goal().
  void finished(int robot, TimeUs now_us);

  void observe(TimeUs now_us, const std::vector<TruthState>& truths);

  [[nodiscard]] int deliveries(int robot) const;
  // Longest period without progress up to the last observation, and when it began.
  [[nodiscard]] TimeUs longest_us(int robot) const;
  [[nodiscard]] TimeUs longest_from_us(int robot) const;

 private:
  struct Robot {
    bool has_goal = false, is_new_goal = false, is_finished = false;
    Vec2 goal;
    double best_m = 0;
    int deliveries = 0;
    TimeUs last_us = 0, longest_us = 0, longest_from_us = 0;
  };
  static void progress(Robot& robot, TimeUs now_us);
  static void extend(Robot& robot, TimeUs now_us);
  Robot& at(int robot) { return robots_[static_cast<std::size_t>(robot)]; }
  [[nodiscard]] const Robot& at(int robot) const {
    return robots_[static_cast<std::size_t>(robot)];
  }

  std::vector<Robot> robots_;
  std::function<double(int, Vec2, Vec2)> distance_;
};

}  // namespace rtac::sim
