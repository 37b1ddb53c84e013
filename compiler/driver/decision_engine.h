// Judges what robots are recorded to have sensed: decisions by the generated kernel, or the
// properties of their monitors by the reference interpreter.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "compiler/driver/engine.h"
#include "compiler/driver/files.h"
#include "compiler/interp/trace.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::driver {

// Margins of decisions, in millionths of their scale: from here on they are infinite, as for the
// generated wrapper.
inline constexpr std::int64_t margin_limit = 1'000'000'000'000'000;

// What has to be known of one decision.
struct DecisionInterface {
  std::string name, prefix;             // of its functions and types in the kernel
  std::string library;                  // prefix of the types that decisions share
  std::string advanced;                 // controller of mode 0
  std::vector<std::string> recoveries;  // controller of mode k + 1; on plans: the safe planner
  std::vector<std::string> monitors;    // highest first
  std::vector<bool> returns;            // whether they say when control may return
  std::vector<std::string> units;       // of their margins; empty: the kernel tells
  struct Unit {
    std::string text;
    Rational factor;  // of a margin of 1
  };
  std::vector<Unit> told_units;     // by number, when some monitor mixes units
  std::vector<std::size_t> robots;  // of the specification, by index in the fleet
  std::int64_t plan_capacity = 0;
  bool has_heading = false, open_fleet = false, judges_commands = false;
  bool on_plan = false;
  Rational period_s;  // of one that is not on plans
  // Plain inputs and parameters that its monitors speak of.
  struct Input {
    std::string name;
    std::size_t component;             // its first one among all of the specification
    std::string sample;                // its member of the kernel's inputs
    std::size_t between_words;         // how many words say what lies between two steps
    std::vector<std::string> members;  // of the kernel's inputs, by component
    Rational step;                     // SI in one step of the grid
    std::string zone{};                // of a zone, which has no components: that of its tables
  };
  std::vector<Input> inputs;
  std::vector<std::pair<std::string, std::int64_t>> params;  // member, first value
  std::size_t components = 0;                                // of all inputs of the specification
  bool in_space = false;       // points of the kernel have heights, whosever they are
  std::int64_t jitter_us = 0;  // a step comes so much later than due at most
  // Members of the kernel's inputs: where each agent of the specification is, and whether it is
  // there; "": the decision does not ask. None where it asks for no agent.
  struct Agent {
    std::string seen, present;
    bool in_space = false;
  };
  std::vector<Agent> agents{};
};
// Those of the module, which is to be generated under the name `prefix`, a C identifier.
std::vector<DecisionInterface> decision_interfaces(ir::Module& module, const sema::Spec& spec,
                                                   const std::string& prefix);

struct DecisionFinding {
  std::int64_t mode = 0, monitor = -1;  // by index; -1: none decides
  std::int64_t reason = 0, index = 0, input = 0, other = -1;
  struct Monitor {
    Judgement now;                                       // the property
    Judgement ahead;                                     // the look-ahead
    interp::Verdict returns = interp::Verdict::unknown;  // the return condition, if it has one
  };
  std::vector<Monitor> monitors;
};

class DecisionEngine {
 public:
  virtual ~DecisionEngine() = default;
  // Whether it looks ahead and chooses who drives, or finds what the properties are now, no more.
  [[nodiscard]] virtual bool decides() const = 0;
  // The newest samples of a row; `robots`: where they are.
  virtual void take(const interp::TraceRow& row,
                    const std::vector<interp::RobotColumns>& robots) = 0;
  // One tick of one robot, or its newest plan, when the decision is on plans; `member`: its index
  // in the fleet of the decision.
  virtual void step(std::size_t decision, std::size_t member, std::int64_t now_us,
                    DecisionFinding& finding) = 0;
};

struct LoadedDecisions {
  std::unique_ptr<DecisionEngine> engine;
  std::string problem;  // why there is none
};
// The reference, which needs to know of monitors, robots and periods alone.
std::vector<DecisionInterface> judged_decisions(const sema::Spec& spec);
std::unique_ptr<DecisionEngine> make_decision_interpreter(const sema::Spec& spec);

LoadedDecisions load_decisions(const std::vector<OutputFile>& files, const std::string& source,
                               const std::vector<DecisionInterface>& decisions,
                               std::size_t robot_count);

}  // namespace rtac::driver
