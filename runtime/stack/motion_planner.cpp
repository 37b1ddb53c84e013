#include "rtac/stack/machines.h"

namespace rtac::stack {

// One plan from one planner into found_. false: none, or not admissible.
bool MotionPlanner::attempt(Planner* planner, TimeUs now_us) {
  if (planner == nullptr || !planner->plan(request_, found_.path)) return false;
  found_.path.index = 0;
  found_.path.stamp_us = now_us;
  if (parts_.decision == nullptr) return true;
  record_ = parts_.decision->judge(found_.path, now_us);
  record_.robot = parts_.robot;
  observer_.on_decision(record_);
  return record_.advanced() || !parts_.protect;
}

void MotionPlanner::deliver(TimeUs now_us) {
  executor_->post(found_);
  robot_->post(PlanReady{now_us});
}

// A plan of either planner around what `request_` lists. `found_.safe` tells whose it is.
bool MotionPlanner::find(const PlanJob& job) {
  Planner* const safe = parts_.protect ? parts_.safe : nullptr;
  const bool try_advanced = safe == nullptr || !job.prefer_safe;
  found_.safe = false;
  if (try_advanced && attempt(parts_.advanced, job.now_us)) return true;
  found_.safe = true;
  if (attempt(safe, job.now_us)) return true;
  found_.safe = false;
  return false;
}

void MotionPlanner::handle(const PlanJob& job) {
  request_.robot = parts_.robot;
  request_.start = job.start;
  request_.goal = job.destination;
  request_.obstacles = job.standing;
  const bool found = find(job);
  if (request_.obstacles.empty()) {
    if (found) return deliver(job.now_us);
    robot_->post(Unreachable{job.now_us});
    return;
  }
  // Robots stand or come first: is it worth going around them, or better to wait and ask?
  around_ = found_;
  const double around_m = length_m(request_.start, found_.path);
  request_.obstacles.clear();
  found_.safe = true;
  const bool direct = parts_.safe != nullptr ? attempt(parts_.safe, job.now_us) : find(job);
  if (found && (!direct || around_m <= length_m(request_.start, found_.path) + parts_.detour_m)) {
    found_ = around_;
    return deliver(job.now_us);
  }
  if (direct) {
    robot_->post(PlanBlocked{job.now_us, found_.path});
  } else {
    robot_->post(Unreachable{job.now_us});
  }
}

}  // namespace rtac::stack
