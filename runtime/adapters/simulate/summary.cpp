#include "summary.h"

#include <cmath>

#include "rtac/sim/table.h"

namespace rtac::simulate {
namespace {

using sim::fixed;

constexpr double us_per_minute = 60e6, us_per_hour = 3600e6, us_per_s = 1e6;

std::string share(std::int64_t part, std::int64_t all) {
  constexpr double percent = 100;
  if (all == 0) return "-";
  return fixed(percent * static_cast<double>(part) / static_cast<double>(all), 1) + " %";
}

std::string a_minute(std::int64_t count, TimeUs robot_time_us) {
  if (robot_time_us == 0) return "-";
  return fixed(static_cast<double>(count) * us_per_minute / static_cast<double>(robot_time_us), 1);
}

}  // namespace

std::string margin_text(const MonitorCase& monitor, double scales) {
  if (!std::isfinite(scales)) return scales > 0 ? "-" : "false";
  constexpr int decimals = 4;
  return fixed(scales, decimals) + (monitor.unit.empty() ? "" : " " + monitor.unit);
}

Summary::Summary(const DecisionCase& decision, std::optional<int> predicted_percent)
    : decision_(decision),
      predicted_percent_(predicted_percent),
      ticks_(decision.monitors.size() + 1, 0),
      least_(decision.monitors.size()) {}

void Summary::tally(Tally& to, const Outcome& outcome) const {
  ++to.runs;
  if (outcome.violation.time_us != never_us) ++to.violations;
  for (const std::int64_t ticks : outcome.ticks) to.ticks += ticks;
  to.advanced += outcome.ticks.front();
  to.engagements += outcome.engagements;
  to.robot_time_us += outcome.duration_us * static_cast<TimeUs>(decision_.robots.size());
}

void Summary::add(const Setup& setup, const Outcome& outcome) {
  tally(all_, outcome);
  tally(by_adversary_[setup.adversary->name], outcome);
  violations_ = all_.violations;
  for (std::size_t k = 0; k < ticks_.size(); ++k) ticks_[k] += outcome.ticks[k];
  for (std::size_t m = 0; m < least_.size(); ++m) {
    if (!(outcome.least[m].value < least_[m].margin.value)) continue;
    least_[m] = {outcome.least[m], setup.seed, setup.adversary->name};
  }
}

double Summary::robot_hours() const {
  return static_cast<double>(all_.robot_time_us) / us_per_hour;
}

std::string Summary::advanced() const {
  if (all_.ticks == 0) return "advanced controller: no time was simulated";
  constexpr double percent = 100, as_good_as_none = 0.05;
  const double had = percent * static_cast<double>(all_.advanced) / static_cast<double>(all_.ticks);
  std::string text = "advanced controller: " + share(all_.advanced, all_.ticks) + " of the time";
  if (!predicted_percent_) return text + ", without a prediction";
  const double more = had - *predicted_percent_;
  const std::string predicted = " predicted " + std::to_string(*predicted_percent_) + " %";
  if (std::abs(more) < as_good_as_none) return text + ", the" + predicted;
  return text + ", " + fixed(std::abs(more), 1) + " points " + (more < 0 ? "below" : "above") +
         " the" + predicted;
}

std::string Summary::attacks() const {
  sim::Table table({"adversary", "runs", "violations", "advanced", "engagements/min"});
  const auto row = [&](const std::string& name, const Tally& t) {
    table.row({name, std::to_string(t.runs), std::to_string(t.violations),
               share(t.advanced, t.ticks), a_minute(t.engagements, t.robot_time_us)});
  };
  for (const Adversary& adversary : adversaries()) {
    const auto found = by_adversary_.find(adversary.name);
    if (found != by_adversary_.end()) row(found->first, found->second);
  }
  table.rule();
  row("all", all_);
  return table.text();
}

std::string Summary::monitors() const {
  sim::Table table({"monitor", "recovery", "drives", "least margin", "seed", "adversary", "at"});
  for (std::size_t m = 0; m < least_.size(); ++m) {
    const MonitorCase& monitor = decision_.monitors[m];
    const Least& least = least_[m];
    const bool known = least.margin.robot >= 0;
    table.row({monitor.name, monitor.recovery.name, share(ticks_[m + 1], all_.ticks),
               margin_text(monitor, least.margin.value), known ? std::to_string(least.seed) : "",
               least.adversary,
               known ? fixed(static_cast<double>(least.margin.time_us) / us_per_s, 3) + " s" : ""});
  }
  return table.text();
}

std::string Summary::text(double core_s) const {
  constexpr int digits = 2;
  std::string text = "decision " + decision_.name + ": " + std::to_string(decision_.robots.size()) +
                     " of " + decision_.kind + ", " + fixed(robot_hours(), digits) + " robot-hours";
  if (core_s > 0) {
    text += ", " + fixed(robot_hours() / core_s, digits) + " a core-second";
  }
  return text + "\n" + advanced() + "\n\n" + attacks() + "\n" + monitors();
}

}  // namespace rtac::simulate
