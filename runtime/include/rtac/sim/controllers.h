// Honest but fallible advanced controllers: they follow Observation.plan and know nothing of
// zones, other robots or batteries.
#pragma once

#include <memory>

#include "rtac/controller.h"
#include "rtac/sim/random.h"

namespace rtac::sim {

struct FollowOptions {
  double speed_mps = 0;            // 0: the robot's limit
  double turn_radps = 0;           // unicycle; 0: the robot's limit
  double gain_per_s = 1.0;         // speed per metre to the end of the plan
  double heading_gain_per_s = 2;   // unicycle: turn rate per radian of heading error
  double turn_in_place_rad = 0.7;  // unicycle: heading error from which it only turns
  double response_s = 0.25;        // point mass: time to reach the velocity set-point
  double brake_share = 0.5;        // share of the brake that the approach counts on
};

// Goes to plan.points[plan.index]; whoever owns the plan advances the index. Unicycle:
// v = gain x distance and w = heading_gain x heading error, both clipped, v falling to zero with
// the heading error. Point mass: a velocity set-point that can be braked away before the end and
// passes way-points the slower the sharper the bend. Without a plan, or with a finished one: it
// stands (unicycle: zero twist; point mass: holds the place where it could stop). Without a usable
// measurement: zero output.
template <class Output>
class FollowPlan final : public Controller<Output> {
 public:
  explicit FollowPlan(const RobotLimits& limits, const FollowOptions& options = {});
  Output command(const Observation& observation) override;

 private:
  RobotLimits limits_;
  FollowOptions options_;
  bool holding_ = false;
  Vec2 hold_;
};

struct LapseOptions {
  std::uint64_t seed = 1;
  TimeUs mean_interval_us = 60'000'000;  // from the end of one lapse to the start of the next
  TimeUs mean_duration_us = 2'000'000;
};

// The "bug" of an advanced controller: at random times the wrapped one is replaced by another.
// Interval and duration are uniform between half and one and a half times their means and depend
// on the seed alone, not on when the controller is called. Both controllers see every
// observation, so that neither wakes up with an old state.
template <class Output>
class Lapses final : public Controller<Output> {
 public:
  Lapses(std::unique_ptr<Controller<Output>> honest, std::unique_ptr<Controller<Output>> faulty,
         const LapseOptions& options);
  Output command(const Observation& observation) override;
  // Whether the last command was the faulty one's, and how many lapses there were.
  [[nodiscard]] bool lapsing() const { return lapsing_; }
  [[nodiscard]] int lapses() const { return lapses_; }

 private:
  [[nodiscard]] TimeUs draw(TimeUs mean_us);
  std::unique_ptr<Controller<Output>> honest_, faulty_;
  LapseOptions options_;
  Random random_;
  bool lapsing_ = false;
  int lapses_ = 0;
  TimeUs change_us_;
};

extern template class FollowPlan<Acceleration>;
extern template class FollowPlan<Twist>;
extern template class Lapses<Acceleration>;
extern template class Lapses<Twist>;

}  // namespace rtac::sim
