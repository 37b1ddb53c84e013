// The properties and return conditions of robots' monitors in a replay, by the reference
// interpreter.
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/driver/decision_engine.h"
#include "compiler/interp/interpreter.h"

namespace rtac::driver {
namespace {

using interp::Reading;
using interp::Sample;

// A decision that robots take.
bool is_judged(const sema::Spec& spec, const sema::Decision& d) {
  for (const sema::Robot& robot : spec.robots) {
    if (robot.kind == d.kind) return true;
  }
  return false;
}

// A new plan starts at its first way-point, unless its index says otherwise.
void take_plan(const interp::PlanReading& reading, const Reading& index,
               std::optional<interp::Plan>& to) {
  if (reading.kind == Reading::Kind::unknown) to.reset();
  if (reading.kind == Reading::Kind::number) {
    to.emplace();
    const auto metres = [](std::int64_t mm) {
      Rational m(static_cast<long>(mm), 1000);
      m.canonicalize();
      return m;
    };
    for (const auto& p : reading.points) to->points.push_back({metres(p.x_mm), metres(p.y_mm)});
  }
  if (index.kind == Reading::Kind::unknown) to.reset();
  if (to && index.kind == Reading::Kind::number) to->index = index.number.on_grid(1).lo;
}

// Components that arrive together; one that a row leaves out while it has another has no value.
// Without any of them the sample stays as it is.
void take_sample(const interp::TraceRow& row, std::size_t at, std::size_t count,
                 std::optional<Sample>& to) {
  Sample sample;
  sample.stamp_us = row.time_us;
  bool arrived = false;
  for (std::size_t k = at; k < at + count; ++k) {
    const Reading& reading = row.readings[k];
    arrived = arrived || reading.kind != Reading::Kind::none;
    const bool known = reading.kind == Reading::Kind::number;
    sample.values.push_back(known ? std::optional(reading.number.value()) : std::nullopt);
    if (reading.zone != nullptr) sample.zone = reading.zone;
    if (reading.path != nullptr) sample.path = reading.path;
  }
  if (arrived) to = std::move(sample);
}

class InterpDecisions : public DecisionEngine {
 public:
  explicit InterpDecisions(const sema::Spec& spec)
      : spec_(spec), inputs_(spec.inputs.size()), robots_(spec.robots.size()) {
    const auto zones = std::make_shared<interp::Zones>(spec);
    for (const sema::Decision& d : spec.decisions) {
      if (!is_judged(spec, d)) continue;
      judges_.emplace_back();
      for (std::uint32_t r = 0; r < spec.robots.size(); ++r) {
        if (spec.robots[r].kind != d.kind) continue;
        judges_.back().push_back(
            {r, d.on_plan,
             std::make_unique<interp::Interpreter>(spec, d, sema::RobotId{r}, zones)});
      }
    }
  }
  [[nodiscard]] bool decides() const override { return false; }

  void take(const interp::TraceRow& row, const std::vector<interp::RobotColumns>& robots) override {
    std::size_t at = 0;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      const std::size_t count = spec_.inputs[i].components.size();
      take_sample(row, at, count, inputs_[i]);
      at += count;
    }
    for (std::size_t r = 0; r < robots.size(); ++r) {
      if (!robots[r].given && !robots[r].proposes) continue;
      take_robot(row, robots[r], robots_[r]);
      if (robots[r].plan_index) {
        take_plan(row.plans[r], row.readings[*robots[r].plan_index], robots_[r].plan);
      }
    }
  }

  void step(std::size_t decision, std::size_t member, std::int64_t now_us,
            DecisionFinding& finding) override {
    const Judge& judge = judges_[decision][member];
    const auto& found = judge.on_plan ? judge.interpreter->judge_plan(robots_[judge.robot].plan)
                                      : judge.interpreter->step(now_us, inputs_, robots_);
    finding.monitors.resize(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      finding.monitors[k].now = judgement_of(found[k]);
      finding.monitors[k].returns = judge.interpreter->returns()[k];
    }
  }

 private:
  static void take_robot(const interp::TraceRow& row, const interp::RobotColumns& at,
                         interp::RobotSamples& to) {
    const std::size_t axes = at.in_space ? 3 : 2;
    if (at.position) take_sample(row, *at.position, axes, to.position);
    if (at.velocity) take_sample(row, *at.velocity, axes, to.velocity);
    if (at.battery) take_sample(row, *at.battery, 1, to.battery);
    // a message that says neither is none
    const bool says = at.present && row.readings[*at.present].kind == Reading::Kind::number;
    if (says) take_sample(row, *at.present, 1, to.presence);
  }

  const sema::Spec& spec_;
  // The newest ones. Stamps tell what has arrived since a tick.
  interp::Inputs inputs_;
  interp::FleetSamples robots_;
  struct Judge {
    std::size_t robot;
    bool on_plan;
    std::unique_ptr<interp::Interpreter> interpreter;
  };
  std::vector<std::vector<Judge>> judges_;  // by decision and member
};

}  // namespace

std::vector<DecisionInterface> judged_decisions(const sema::Spec& spec) {
  std::vector<DecisionInterface> all;
  for (const sema::Decision& d : spec.decisions) {
    if (!is_judged(spec, d)) continue;
    DecisionInterface to;
    to.name = d.name;
    to.on_plan = d.on_plan;
    if (d.period) to.period_s = d.period->value;
    for (const sema::MonitorId id : d.priority) {
      to.monitors.push_back(spec[id].name);
      to.returns.push_back(spec[id].return_when != nullptr);
    }
    for (std::size_t r = 0; r < spec.robots.size(); ++r) {
      if (spec.robots[r].kind == d.kind) to.robots.push_back(r);
    }
    all.push_back(std::move(to));
  }
  return all;
}

std::unique_ptr<DecisionEngine> make_decision_interpreter(const sema::Spec& spec) {
  return std::make_unique<InterpDecisions>(spec);
}

}  // namespace rtac::driver
