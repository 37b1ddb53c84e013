#include "compiler/driver/decision_replay.h"

#include <algorithm>
#include <array>

#include "compiler/support/rational.h"

namespace rtac::driver {
namespace {

// As the kernel numbers them.
constexpr std::array<const char*, 12> reasons = {"",
                                                 "margin",
                                                 "waypoint",
                                                 "leg",
                                                 "violated",
                                                 "within error",
                                                 "input",
                                                 "returning",
                                                 "starting",
                                                 "plan over capacity",
                                                 "surrendered",
                                                 "tracking"};
constexpr std::array<const char*, 8> inputs = {"none",    "position", "velocity",    "heading",
                                               "battery", "plan",     "other robot", "clock"};
constexpr std::int64_t reason_waypoint = 2, reason_leg = 3, reason_input = 6;

template <std::size_t Size>
const char* entry(const std::array<const char*, Size>& words, std::int64_t index) {
  return index >= 0 && index < static_cast<std::int64_t>(Size)
             ? words[static_cast<std::size_t>(index)]
             : "?";
}
// Of what was never judged, empty cells.
void print_judgement(bool judged, const Judgement& judgement, std::string& line) {
  if (!judged) {
    line.append(",,,");
    return;
  }
  line.append(",").append(word(judgement.verdict));
  line.append(",").append(judgement.margin).append(",").append(judgement.unit);
}

}  // namespace

DecisionReplay::DecisionReplay(const sema::Spec& spec, std::vector<DecisionInterface> decisions,
                               std::unique_ptr<DecisionEngine> engine, std::string only)
    : spec_(spec),
      decisions_(std::move(decisions)),
      engine_(std::move(engine)),
      only_(std::move(only)) {
  for (const DecisionInterface& d : decisions_) {
    tickers_.emplace_back();
    if (!d.on_plan) tickers_.back().clock.emplace(d.period_s);
  }
}

bool DecisionReplay::is_shown(std::size_t decision, std::size_t robot) const {
  const DecisionInterface& d = decisions_[decision];
  return (d.on_plan ? robots_[robot].proposes : robots_[robot].given) &&
         std::any_of(d.monitors.begin(), d.monitors.end(),
                     [&](const std::string& name) { return wants(name); });
}

void DecisionReplay::choose(const std::vector<interp::RobotColumns>& robots) {
  robots_ = robots;
  std::vector<std::size_t> decisions(robots_.size(), 0);  // by robot
  for (const DecisionInterface& d : decisions_) {
    for (const std::size_t robot : d.robots) ++decisions[robot];
  }
  const auto deciding = std::count_if(decisions.begin(), decisions.end(),
                                      [](std::size_t count) { return count > 0; });
  for (std::size_t k = 0; k < decisions_.size(); ++k) {
    const DecisionInterface& d = decisions_[k];
    for (std::size_t member = 0; member < d.robots.size(); ++member) {
      const std::size_t robot = d.robots[member];
      if (!is_shown(k, robot)) continue;
      const std::string prefix = deciding > 1 ? spec_.robots[robot].name + "." : "";
      const bool both = d.on_plan && decisions[robot] > 1;
      shown_.push_back({k, member, prefix, both ? prefix + "plan." : prefix, {}, false});
      shown_.back().finding.monitors.resize(d.monitors.size());
    }
  }
}

void DecisionReplay::print_header(std::string& line) const {
  for (const Shown& shown : shown_) {
    const DecisionInterface& d = decisions_[shown.decision];
    for (std::size_t k = 0; k < d.monitors.size(); ++k) {
      const std::string& name = d.monitors[k];
      if (!wants(name)) continue;
      for (const char* field : {".verdict", ".margin", ".unit"}) {
        line.append(",").append(shown.prefix).append(name).append(field);
      }
      if (looks_ahead(shown)) {
        for (const char* field : {".ahead", ".ahead.margin", ".ahead.unit"}) {
          line.append(",").append(shown.prefix).append(name).append(field);
        }
      }
      if (d.returns[k]) line.append(",").append(shown.prefix).append(name).append(".return");
    }
    if (!engine_->decides()) continue;
    for (const char* field : {"mode", "monitor", "reason"}) {
      line.append(",").append(shown.chosen).append(field);
    }
  }
}

std::optional<Rational> DecisionReplay::shortest_period_s() const {
  std::optional<Rational> shortest;
  for (const DecisionInterface& d : decisions_) {
    if (!d.on_plan) shortest = shortest ? std::min(*shortest, d.period_s) : d.period_s;
  }
  return shortest;
}

void DecisionReplay::take(const interp::TraceRow& row) {
  proposed_.assign(robots_.size(), false);
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    proposed_[r] = row.plans[r].kind != interp::Reading::Kind::none;
  }
  engine_->take(row, robots_);
}

std::vector<bool> DecisionReplay::due_decisions(std::int64_t now_us) {
  std::vector<bool> due(decisions_.size(), false);
  for (std::size_t k = 0; k < decisions_.size(); ++k) {
    Ticker& ticker = tickers_[k];
    if (!ticker.clock) continue;
    const interp::Tick tick = ticker.clock->at(now_us);
    due[k] = tick != ticker.before;
    ticker.before = tick;
  }
  return due;
}

void DecisionReplay::note_violations(const Shown& shown) {
  const auto& monitors = decisions_[shown.decision].monitors;
  for (std::size_t k = 0; k < monitors.size(); ++k) {
    violated_ = violated_ || (wants(monitors[k]) &&
                              shown.finding.monitors[k].now.verdict == interp::Verdict::no);
  }
}

bool DecisionReplay::step(std::int64_t now_us) {
  const std::vector<bool> due = due_decisions(now_us);
  bool any = false;
  for (Shown& shown : shown_) {
    const DecisionInterface& d = decisions_[shown.decision];
    const bool proposed = d.on_plan && proposed_[d.robots[shown.member]];
    if (!due[shown.decision] && !proposed) continue;
    any = shown.judged = true;
    engine_->step(shown.decision, shown.member, now_us, shown.finding);
    note_violations(shown);
  }
  return any;
}

std::string DecisionReplay::reason(const DecisionInterface& d, const DecisionFinding& f) const {
  std::string text = entry(reasons, f.reason);
  if (text.empty()) return text;
  if (f.reason == reason_waypoint || f.reason == reason_leg) text += " " + std::to_string(f.index);
  if (f.reason == reason_input) {
    const auto plain = static_cast<std::size_t>(f.input) - inputs.size();
    text += ": ";
    text += plain < d.inputs.size() ? d.inputs[plain].name : entry(inputs, f.input);
  }
  if (f.other >= 0 && f.other < static_cast<std::int64_t>(d.robots.size())) {
    text += " (robot " + spec_.robots[d.robots[static_cast<std::size_t>(f.other)]].name + ")";
  }
  return text;
}

void DecisionReplay::print(std::string& line) const {
  for (const Shown& shown : shown_) {
    const DecisionInterface& d = decisions_[shown.decision];
    const DecisionFinding& f = shown.finding;
    for (std::size_t k = 0; k < d.monitors.size(); ++k) {
      if (!wants(d.monitors[k])) continue;
      print_judgement(shown.judged, f.monitors[k].now, line);
      if (looks_ahead(shown)) print_judgement(shown.judged, f.monitors[k].ahead, line);
      if (d.returns[k]) line.append(",").append(shown.judged ? word(f.monitors[k].returns) : "");
    }
    if (!engine_->decides()) continue;
    if (!shown.judged) {
      line.append(",,,");
      continue;
    }
    const auto controller = static_cast<std::size_t>(f.mode);
    line.append(",").append(controller == 0 ? d.advanced : d.recoveries[controller - 1]);
    line.append(",");
    if (f.monitor >= 0) line.append(d.monitors[static_cast<std::size_t>(f.monitor)]);
    line.append(",").append(reason(d, f));
  }
}

}  // namespace rtac::driver
