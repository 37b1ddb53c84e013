// The columns of decisions in the findings of a replay.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/driver/decision_engine.h"
#include "compiler/interp/clock.h"

namespace rtac::driver {

class DecisionReplay {
 public:
  // `only`: name of the one monitor that is asked for, or empty.
  DecisionReplay(const sema::Spec& spec, std::vector<DecisionInterface> decisions,
                 std::unique_ptr<DecisionEngine> engine, std::string only);
  // Robots without columns in the trace are left out. Columns carry the name of the robot when the
  // specification has more than one that decides, and who plans is told from who drives by `plan.`
  // when a robot decides both.
  void choose(const std::vector<interp::RobotColumns>& robots);
  void print_header(std::string& line) const;
  void take(const interp::TraceRow& row);
  // Steps what is due at this time, and judges the plans that the row proposes; false: there was
  // nothing to do.
  bool step(std::int64_t now_us);
  // None: of decisions on plans alone.
  [[nodiscard]] std::optional<Rational> shortest_period_s() const;
  // The newest findings.
  void print(std::string& line) const;
  [[nodiscard]] bool violated() const { return violated_; }

 private:
  struct Shown {
    std::size_t decision, member;
    std::string prefix;  // of its columns: "r1." or none
    std::string chosen;  // prefix of `mode`, `monitor` and `reason`: the same, or "r1.plan."
    DecisionFinding finding;
    bool judged = false;  // before the first plan nothing is found
  };
  struct Ticker {
    std::optional<interp::Clock> clock;  // none: of a decision on plans
    interp::Tick before = -1;
  };
  [[nodiscard]] bool is_shown(std::size_t decision, std::size_t robot) const;
  [[nodiscard]] bool looks_ahead(const Shown& shown) const {
    return engine_->decides() && !decisions_[shown.decision].on_plan;
  }
  [[nodiscard]] std::vector<bool> due_decisions(std::int64_t now_us);
  void note_violations(const Shown& shown);
  [[nodiscard]] bool wants(const std::string& monitor) const {
    return only_.empty() || only_ == monitor;
  }
  [[nodiscard]] std::string reason(const DecisionInterface& d, const DecisionFinding& f) const;

  const sema::Spec& spec_;
  std::vector<DecisionInterface> decisions_;
  std::unique_ptr<DecisionEngine> engine_;
  std::string only_;
  std::vector<interp::RobotColumns> robots_;
  std::vector<bool> proposed_;  // by robot: in the newest row
  std::vector<Shown> shown_;
  std::vector<Ticker> tickers_;  // by decision
  bool violated_ = false;
};

}  // namespace rtac::driver
