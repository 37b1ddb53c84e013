// The lowest layer: one RTA module per robot. Every period it senses, lets the decision module
// choose, asks the chosen controller, actuates and announces.
#pragma once

#include "rtac/controller.h"
#include "rtac/decision.h"
#include "rtac/stack/machines.h"
#include "rtac/watchdog.h"

namespace rtac {

// What one robot of a system consists of.
template <class Output>
struct RobotParts {
  const char* name = "";
  DecisionModule* decision = nullptr;
  PlanDecision* plan_decision = nullptr;                        // may be null
  FixedList<SafeController<Output>*, max_monitors> recoveries;  // by index of the monitor
  Controller<Output>* advanced = nullptr;
  Planner* advanced_planner = nullptr;
  Planner* safe_planner = nullptr;  // null without plan_decision
  TimeUs period_us = 0;
  RobotLimits limits;
};

namespace stack {

template <class Output>
class PlanExecutor final : public ExecutorMachine {
 public:
  PlanExecutor(int index, int robots, const RobotParts<Output>& parts, const SystemOptions& options,
               SystemObserver& observer);
  void connect(RobotMachine& robot) { robot_ = &robot; }
  void attach(RobotSdk<Output>& sdk) { sdk_ = &sdk; }

 private:
  void handle(const ExecutorEvent& event) override;
  void on(const Tick& tick);
  void on(const NewPlan& plan);
  void on(const Situation& situation);

  [[nodiscard]] SafeController<Output>* active() const;  // null: the advanced controller
  void sense(TimeUs now_us);
  [[nodiscard]] int surrender_mode() const;
  [[nodiscard]] double passing_m() const;
  void follow_progress();
  bool in_the_way();
  void propose();
  void decide();
  void switch_to(int mode);
  void engage(SafeController<Output>& recovery);
  Output command(bool late);
  void remember(const Output& output);
  void announce();
  void report();
  void drop_plan();
  [[nodiscard]] bool claims() const;
  [[nodiscard]] bool somebody_has_an_errand() const;
  void keep_clear_of_way(const Announcement& other, Report& report) const;

  int index_;
  RobotParts<Output> parts_;
  SystemOptions options_;
  SystemObserver& observer_;
  RobotMachine* robot_ = nullptr;
  RobotSdk<Output>* sdk_ = nullptr;
  TimeUs aside_until_us_ = never_us;
  Watchdog watchdog_;

  Observation observation_;
  Sample<Vec2> last_velocity_;  // the last one that was a number
  double last_climb_mps_ = 0;   // of that
  Path plan_;
  Situation situation_;
  Output proposal_{};  // of the advanced controller, where commands are judged
  DecisionRecord record_;
  Announcement announcement_;
  int mode_ = 0;  // that drives; follows the record only when the system is protected
  bool has_position_ = false;
};

extern template class PlanExecutor<Twist>;
extern template class PlanExecutor<Acceleration>;

}  // namespace stack
}  // namespace rtac
