// A generated system of one robot in the simulator, with an adversary for its advanced controller.
#pragma once

#include <memory>

#include "rtac/sim/adversary.h"
#include "rtac/sim/judge.h"
#include "rtac/sim/world.h"
#include "rtac/stack/system.h"

namespace rtac::test {

// Somewhere to go, so that the advanced controller does not give control up by itself; the
// adversaries go where they like.
class EndlessTasks final : public TaskSource {
 public:
  bool next(int, Vec2& destination) override {
    destination = {100, 100};
    return true;
  }
  void completed(int, Vec2, TimeUs) override {}
  void skipped(int, Vec2, TimeUs) override {}
};
class StraightPlans final : public Planner {
 public:
  bool plan(const PlanRequest& request, Path& plan) override {
    plan.points.clear();
    plan.index = 0;
    return plan.points.push(request.goal);
  }
};

// Counts who drives, and how long a recovery keeps control at a time.
class Shares final : public SystemObserver {
 public:
  void on_decision(const DecisionRecord& record) override {
    ++ticks_;
    if (record.mode == 0) {
      ++advanced_;
      since_us_ = never_us;
      return;
    }
    if (since_us_ == never_us) {
      since_us_ = record.time_us;
      ++engagements_;
    }
    longest_us_ = std::max(longest_us_, record.time_us - since_us_);
  }
  [[nodiscard]] double advanced() const { return double(advanced_) / double(ticks_); }
  [[nodiscard]] int engagements() const { return engagements_; }
  [[nodiscard]] TimeUs longest_us() const { return longest_us_; }

 private:
  std::int64_t ticks_ = 0, advanced_ = 0;
  int engagements_ = 0;
  TimeUs since_us_ = never_us, longest_us_ = 0;
};

template <class Output>
using Adversary = std::unique_ptr<Controller<Output>>;

// One robot from its start until `end_us`, in noise on its bounds and with samples as old as they
// may be. `on_step` sees the truth of every millisecond.
template <class System, class Output, class Slots>
Shares run(const RobotLimits& limits, const sim::RobotSetup& setup, std::uint64_t seed,
           TimeUs end_us, Controller<Output>& advanced,
           const std::function<void(TimeUs, const sim::TruthState&)>& on_step, Slots&& slots) {
  sim::RobotSetup robot = setup;
  robot.limits = limits;
  sim::WorldOptions options;
  options.seed = seed;
  options.noise = sim::NoiseModel::extreme;
  options.end_us = end_us;
  sim::World<Output> world({robot}, options);
  world.on_step([&](TimeUs now_us) { on_step(now_us, world.truth(0)); });
  EndlessTasks tasks;
  StraightPlans plans;
  Shares shares;
  System system(slots(advanced, plans, tasks), System::default_options(), &shares);
  (void)system.run(world, end_us);
  return shares;
}

}  // namespace rtac::test
