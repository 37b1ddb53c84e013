// A system with everything scripted: decision, planners, recoveries, tasks and a point-mass fleet.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "rtac/stack/system.h"

namespace rtac::test {

inline constexpr TimeUs period_us = 100'000;
inline constexpr MonitorInfo monitor_infos[] = {
    {"collision", "SR-3", "apart", "s.rta", 1, "give_way", "", "m"},
    {"battery", "SR-2", "enough", "s.rta", 2, "go_charge", "", "%"}};
inline constexpr DecisionInfo decision_info{"plan_executor", "Cart", "follow", "",
                                            monitor_infos,   2,      period_us};
inline constexpr DecisionInfo plan_info{"motion_planner", "Cart", "rrt", "certified",
                                        monitor_infos,    1,      0};

// Surrenders when told to; otherwise the script changes what it likes.
class ScriptedDecision : public DecisionModule {
 public:
  using Script = std::function<void(const Observation&, DecisionRecord&)>;
  Script script = [](const Observation&, DecisionRecord&) {};
  bool last_holding = false, last_surrender = false;
  std::size_t last_plan_size = 0;
  std::vector<TimeUs> steps_us;

  [[nodiscard]] const DecisionInfo& info() const override { return decision_info; }
  const DecisionRecord& step(const Observation& seen, bool holding, bool surrender) override {
    last_holding = holding, last_surrender = surrender, last_plan_size = seen.plan.points.size();
    if (steps_us.size() < steps_us.capacity()) steps_us.push_back(seen.now_us);
    const int before = record_.mode;
    record_ = {};
    record_.info = &decision_info;
    record_.time_us = seen.now_us, record_.previous_mode = before;
    record_.mode = surrender ? 1 : 0;
    record_.reason = surrender ? Reason::surrendered : Reason::none;
    record_.lease_end_us = holding ? seen.now_us + 500'000 : never_us;
    script(seen, record_);
    return record_;
  }
  void reset() override { record_ = {}; }
  ScriptedDecision() { steps_us.reserve(4096); }

 private:
  DecisionRecord record_;
};

class ScriptedJudge : public PlanDecision {
 public:
  std::function<bool(const Path&)> admits = [](const Path&) { return true; };
  [[nodiscard]] const DecisionInfo& info() const override { return plan_info; }
  const DecisionRecord& judge(const Path& plan, TimeUs now_us) override {
    record_.info = &plan_info, record_.time_us = now_us;
    record_.mode = admits(plan) ? 0 : 1;
    return record_;
  }

 private:
  DecisionRecord record_;
};

// One way-point at the goal; refuses when a disc lies within its radius of the straight way.
class StraightPlanner : public Planner {
 public:
  int calls = 0;
  bool able = true;
  double detour_m = 0;  // a way-point off the line marks the plans of this planner
  double around_m = 0;  // the same, only while there are obstacles
  bool plan(const PlanRequest& request, Path& plan) override {
    ++calls;
    plan.points.clear();
    if (!able) return false;
    for (const Disc& disc : request.obstacles) {
      const Vec2 d = request.goal - request.start;
      const double t = dot(disc.centre - request.start, d) / dot(d, d);
      const Vec2 closest = request.start + std::clamp(t, 0.0, 1.0) * d;
      if (norm(closest - disc.centre) < disc.radius_m) return false;
    }
    const double aside_m = request.obstacles.empty() ? detour_m : std::max(detour_m, around_m);
    if (aside_m > 0) {
      (void)plan.points.push(0.5 * (request.start + request.goal) + Vec2{0, aside_m});
    }
    return plan.points.push(request.goal);
  }
};

class Chase : public Controller<Acceleration> {
 public:
  double speed_mps = 0.5;
  int calls = 0;
  Acceleration command(const Observation& seen) override {
    ++calls;
    Vec2 wanted{};
    if (!seen.plan.finished()) {
      const Vec2 way = seen.plan.points[seen.plan.index] - seen.position.value;
      wanted = std::min(speed_mps, norm(way)) / std::max(norm(way), 1e-9) * way;
    }
    return {4 * (wanted - seen.velocity.value)};
  }
};

class Brake : public SafeController<Acceleration> {
 public:
  int engaged = 0, commands = 0;
  Gate last_gate = Gate::free;
  Sample<Vec2> velocity_at_engagement, last_velocity;
  bool is_blocked = false, is_parked = false, on_errand = false, is_holding = true;
  Path way;
  std::optional<Halt> halts;
  [[nodiscard]] std::optional<Halt> halt() const override { return halts; }
  void engage(const Observation& seen) override {
    ++engaged;
    velocity_at_engagement = seen.velocity;
  }
  Acceleration command(const Observation& seen, Gate gate) override {
    ++commands;
    last_gate = gate;
    last_velocity = seen.velocity;
    return {-4 * seen.velocity.value};
  }
  [[nodiscard]] bool holding() const override { return is_holding; }
  [[nodiscard]] bool blocked() const override { return is_blocked; }
  [[nodiscard]] bool parked() const override { return is_parked; }
  [[nodiscard]] bool errand() const override { return on_errand; }
  [[nodiscard]] const Path* path() const override { return way.finished() ? nullptr : &way; }
};

class ListTasks : public TaskSource {
 public:
  std::array<std::vector<Vec2>, 2> waiting;
  std::array<std::vector<Vec2>, 2> completed_, skipped_;
  ListTasks() {
    for (auto* list : {&completed_, &skipped_}) {
      for (auto& of_robot : *list) of_robot.reserve(100);
    }
  }
  bool next(int robot, Vec2& destination) override {
    auto& list = waiting[static_cast<std::size_t>(robot)];
    if (list.empty()) return false;
    destination = list.front();
    list.erase(list.begin());
    return true;
  }
  void completed(int robot, Vec2 d, TimeUs) override {
    completed_[static_cast<std::size_t>(robot)].push_back(d);
  }
  void skipped(int robot, Vec2 d, TimeUs) override {
    skipped_[static_cast<std::size_t>(robot)].push_back(d);
  }
};

class PointFleet : public FleetSdk<Acceleration> {
 public:
  struct Point : RobotSdk<Acceleration> {
    Vec2 p, v, a;
    TimeUs* now_us = nullptr;
    std::array<Point, 2>* all = nullptr;
    Announcement said;
    bool seen = true;
    TimeUs no_velocity_from_us = INT64_MAX;  // it is not a number any more
    void sense(Observation& out) override {
      if (seen) out.position = {p, *now_us};
      out.velocity = {v, *now_us};
      if (*now_us >= no_velocity_from_us) out.velocity.value.x = std::nan("");
      for (std::size_t j = 0; j < 2; ++j) {
        if (&(*all)[j] != this) out.others[j] = (*all)[j].said;
      }
    }
    void actuate(const Acceleration& out) override { a = out.value_mps2; }
    void announce(const Announcement& out) override { said = out; }
  };
  std::array<Point, 2> points;
  TimeUs clock_us = 0;
  TimeUs jump_at_us = never_us, jump_us = 0;  // the platform freezes once

  PointFleet() {
    for (Point& point : points) point.now_us = &clock_us, point.all = &points;
  }
  RobotSdk<Acceleration>& robot(int i) override { return points[static_cast<std::size_t>(i)]; }
  [[nodiscard]] TimeUs now_us() const override { return clock_us; }
  bool wait_until(TimeUs time_us) override {
    if (jump_at_us != never_us && time_us >= jump_at_us) {
      time_us = jump_at_us + jump_us;
      jump_at_us = never_us;
    }
    for (; clock_us < time_us; clock_us += 10'000) {
      for (Point& point : points) {
        point.v = point.v + 0.01 * point.a;
        point.p = point.p + 0.01 * point.v;
      }
    }
    return true;
  }
};

class Log : public SystemObserver {
 public:
  int plans = 0, safe_plans = 0, blocked = 0, late = 0, judged = 0;
  std::array<SkipReason, 64> skips{};
  std::array<TimeUs, 64> skips_us{};
  std::size_t skip_count = 0;
  int delivered = 0;
  void on_decision(const DecisionRecord& record) override {
    if (record.info == &plan_info) ++judged;
  }
  void on_plan(int, const Path&, bool safe) override { ++(safe ? safe_plans : plans); }
  void on_blocked(int, const Path&, TimeUs) override { ++blocked; }
  void on_delivered(int, Vec2, TimeUs) override { ++delivered; }
  void on_skipped(int, Vec2, TimeUs now_us, SkipReason reason) override {
    if (skip_count == skips.size()) return;
    skips[skip_count] = reason;
    skips_us[skip_count++] = now_us;
  }
  void on_late(int, TimeUs) override { ++late; }
};

// Everything of one or two robots, wired; tests change the pieces and then run.
class Bench {
 public:
  explicit Bench(int robot_count = 1) : robots(robot_count) {}

  Status run(double seconds) {
    if (system == nullptr) {
      for (std::size_t i = 0; i < 2; ++i) {
        parts[i].decision = &decision[i];
        parts[i].advanced = &advanced[i];
        parts[i].advanced_planner = &planner[i];
        (void)parts[i].recoveries.push(&give_way[i]);
        (void)parts[i].recoveries.push(&go_charge[i]);
        parts[i].period_us = parts[i].period_us > 0 ? parts[i].period_us : period_us;
        parts[i].limits.position_age_us = 200'000;
      }
      system = std::make_unique<System<Acceleration>>(tasks, parts.data(), robots, options, &log);
    }
    return system->run(fleet, fleet.clock_us + static_cast<TimeUs>(seconds * 1e6));
  }
  void with_judge() {
    for (std::size_t i = 0; i < 2; ++i) {
      parts[i].plan_decision = &judge[i];
      parts[i].safe_planner = &safe_planner[i];
      safe_planner[i].detour_m = 0.5;
    }
  }

  int robots;
  std::array<ScriptedDecision, 2> decision;
  std::array<ScriptedJudge, 2> judge;
  std::array<StraightPlanner, 2> planner, safe_planner;
  std::array<Chase, 2> advanced;
  std::array<Brake, 2> give_way, go_charge;
  std::array<RobotParts<Acceleration>, 2> parts;
  ListTasks tasks;
  PointFleet fleet;
  SystemOptions options;
  Log log;
  std::unique_ptr<System<Acceleration>> system;
};

}  // namespace rtac::test
