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

void MotionPlanner::deliver(bool safe, TimeUs now_us) {
  found_.safe = safe;
  executor_->post(found_);
  robot_->post(PlanReady{now_us});
}

void MotionPlanner::handle(const PlanJob& job) {
  request_.robot = parts_.robot;
  request_.start = job.start;
  request_.goal = job.destination;
  request_.obstacles = job.standing;
  Planner* const safe = parts_.protect ? parts_.safe : nullptr;
  const bool try_advanced = safe == nullptr || !job.prefer_safe;
  if (try_advanced && attempt(parts_.advanced, job.now_us)) return deliver(false, job.now_us);
  if (attempt(safe, job.now_us)) return deliver(true, job.now_us);
  if (!request_.obstacles.empty()) {
    // Is it the robots that stand? Then waiting for them makes sense, and asking them for passage.
    request_.obstacles.clear();
    if (attempt(safe, job.now_us) || attempt(parts_.advanced, job.now_us)) {
      robot_->post(PlanBlocked{job.now_us, found_.path});
      return;
    }
  }
  robot_->post(Unreachable{job.now_us});
}

}  // namespace rtac::stack
