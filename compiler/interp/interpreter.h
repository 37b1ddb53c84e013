// The reference: what every monitor finds at every tick, on exact numbers, straight from the
// semantic rules; of robots the property and the return condition now, without look-ahead (rules 5
// and 10). Generated code is held against it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "compiler/interp/clock.h"
#include "compiler/interp/evaluator.h"
#include "compiler/interp/margin.h"
#include "compiler/interp/robots.h"
#include "compiler/interp/signals.h"
#include "compiler/sema/spec.h"

namespace rtac::interp {

enum class Reason {
  none,          // true
  margin,        // false
  within_error,  // the declared errors leave it open
  input          // something is missing
};

struct Finding {
  Verdict verdict = Verdict::unknown;
  // The margin of the atom that decides the lower end, in `unit`; +-inf of atoms without a
  // quantity, and then the other end is in scales.
  Extended lo = Extended::infinity(-1), hi = Extended::infinity(1);
  std::string unit;  // SI, "%" of ratios; empty: a bare number, or lo is infinite
  Reason reason = Reason::input;
  std::optional<sema::InputId> input;  // the one that is missing, when it is one
};

class Interpreter {
 public:
  // The specification outlives the interpreter and has a period, as sema asks of one with watches.
  explicit Interpreter(const sema::Spec& spec);
  // Of the monitors of a decision, for one robot of its kind. Interpreters of one specification may
  // share its zones.
  Interpreter(const sema::Spec& spec, const sema::Decision& decision, sema::RobotId self,
              std::shared_ptr<Zones> zones);
  // Findings by the order of spec.watches, or of the priorities of the decision. A second step
  // within one tick, or a clock that goes backwards, judges nothing and returns what was found
  // before.
  const std::vector<Finding>& step(std::int64_t now_us, const Inputs& inputs,
                                   const FleetSamples& robots = {});
  // Of the same monitors: whether the newest tick finds that control may return; `yes` where the
  // author does not say when.
  [[nodiscard]] const std::vector<Verdict>& returns() const { return returns_; }
  // Of a decision on plans: what it finds of a proposed plan; none: of one that cannot be read.
  const std::vector<Finding>& judge_plan(const std::optional<Plan>& plan);
  // A parameter moves within its range, and only in the direction that tightens; other values are
  // ignored. Between two steps of its resolution it takes the tighter one. The value counts from
  // the tick of the next step on, not at ticks that were missed before it.
  void set_param(sema::ParamId param, const Rational& value);
  [[nodiscard]] Tick tick() const { return tick_; }

 private:
  // What a monitor says.
  struct Conditions {
    const sema::Expr* always;
    const sema::Expr* return_when;  // null: nothing
  };
  static std::vector<Conditions> conditions(const sema::Spec& spec);
  static std::vector<Conditions> conditions(const sema::Spec& spec, const sema::Decision& decision);
  Interpreter(const sema::Spec& spec, const Rational& period, std::vector<Conditions> monitors,
              std::unique_ptr<Robots> robots, std::shared_ptr<Zones> zones);
  void miss();
  void receive_zones();
  void judge();
  [[nodiscard]] std::int64_t one_period_before(std::int64_t now_us) const;
  Finding report(const Margin& margin);
  struct Shown {
    std::string unit;
    Rational factor;  // from units of the scale
  };
  const Shown& shown(const sema::Dimension& dimension);

  const sema::Spec& spec_;
  Rational period_;  // s
  std::vector<Conditions> monitors_;
  std::vector<Rational> params_, wanted_params_;  // at the present tick, and from the next one on
  Signals signals_;
  std::unique_ptr<Robots> robots_;  // null: of monitors without a robot
  std::shared_ptr<Zones> zones_;
  Evaluator evaluator_;
  std::vector<Finding> findings_;
  std::vector<Verdict> returns_;
  std::unordered_map<const sema::Dimension*, Shown> shown_;
  Tick tick_ = -1;              // before the first step
  std::int64_t before_us_ = 0;  // time of that tick
  Clock clock_;
};

}  // namespace rtac::interp
