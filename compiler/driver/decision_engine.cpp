#include "compiler/driver/decision_engine.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>
#include <map>
#include <utility>

#include "compiler/codegen/names.h"
#include "compiler/codegen/watch.h"
#include "compiler/driver/decision_glue.h"
#include "compiler/driver/held_zone.h"
#include "compiler/driver/shared_object.h"
#include "compiler/ir/margin_unit.h"
#include "compiler/sema/dimension.h"
#include "compiler/sema/limits.h"

namespace rtac::driver {
namespace {

using Init = void (*)();
using Step = void (*)(std::int32_t, const std::int64_t*, std::int64_t, std::int64_t*);
using interp::Reading;

// As by the generated wrapper, coordinates that are too far are cut off, which the kernel knows as
// outside; a charge or an angle beyond it is none.
constexpr std::int64_t grid_limit = sema::grid_steps_max;

std::string margin(std::int64_t millionths, const Rational& factor) {
  if (millionths >= margin_limit) return "inf";
  if (millionths <= -margin_limit) return "-inf";
  Rational value(static_cast<long>(millionths), 1'000'000);
  value.canonicalize();
  return text_of_margin(Rational(value * factor));
}

interp::Verdict verdict(std::int64_t word) {
  constexpr std::int64_t verdict_false = 0, verdict_true = 2;
  if (word == verdict_false) return interp::Verdict::no;
  return word == verdict_true ? interp::Verdict::yes : interp::Verdict::unknown;
}

// `words`: verdict, margin, unit.
Judgement judgement(const DecisionInterface& d, std::size_t monitor, const std::int64_t* words) {
  Judgement judged;
  judged.verdict = verdict(words[0]);
  const auto told = static_cast<std::size_t>(words[2]);
  const bool tells = d.units[monitor].empty() && told < d.told_units.size();
  judged.margin = margin(words[1], tells ? d.told_units[told].factor : Rational(1));
  judged.unit = tells ? d.told_units[told].text : d.units[monitor];
  if (std::abs(words[1]) >= margin_limit) judged.unit.clear();  // rule 4.4
  return judged;
}

class KernelDecisions : public DecisionEngine {
 public:
  KernelDecisions(SharedObject object, const std::vector<DecisionInterface>& decisions,
                  std::size_t robot_count)
      : object_(std::move(object)),
        capacity_(plan_capacity(decisions)),
        stride_(RobotWords::size(capacity_, decisions.front().components)),
        seen_(robot_count * stride_, 0),
        decisions_(decisions) {
    for (std::size_t k = 0; k < decisions.size(); ++k) {
      object_.function<Init>(("rtac_decision_init_" + std::to_string(k)).c_str())();
      steps_.push_back(object_.function<Step>(("rtac_decision_step_" + std::to_string(k)).c_str()));
    }
  }

  [[nodiscard]] bool decides() const override { return true; }

  void take(const interp::TraceRow& row, const std::vector<interp::RobotColumns>& robots) override {
    for (std::size_t r = 0; r < robots.size(); ++r) {
      std::int64_t* const to = seen_.data() + r * stride_;
      const interp::RobotColumns& at = robots[r];
      if (!at.given && !at.proposes) continue;
      if (at.position) vector(row, *at.position, at.in_space, to + RobotWords::position);
      if (at.velocity) vector(row, *at.velocity, at.in_space, to + RobotWords::velocity);
      if (at.battery) scalar(row, *at.battery, Rational(1, 1'000'000), to + RobotWords::battery);
      if (at.heading) scalar(row, *at.heading, Rational(1, 1000), to + RobotWords::heading);
      if (at.present) presence(row, *at.present, to + RobotWords::presence);
      if (at.plan_index) plan(row.plans[r], row.readings[*at.plan_index], to + RobotWords::plan);
    }
    for (const DecisionInterface& d : decisions_) {
      for (const std::size_t robot : d.robots) {
        if (robots[robot].given) plain_inputs(row, d, robot);
      }
    }
  }

  void step(std::size_t decision, std::size_t member, std::int64_t now_us,
            DecisionFinding& finding) override {
    const DecisionInterface& d = decisions_[decision];
    fleet_.clear();
    for (const std::size_t robot : d.robots) {
      const auto from = seen_.begin() + static_cast<std::ptrdiff_t>(robot * stride_);
      fleet_.insert(fleet_.end(), from, from + static_cast<std::ptrdiff_t>(stride_));
    }
    found_.resize(FindingWords::monitors + FindingWords::per_monitor * d.monitors.size());
    steps_[decision](static_cast<std::int32_t>(member), fleet_.data(), now_us, found_.data());
    finding = {found_[0], found_[1], found_[2], found_[3], found_[4], found_[5], {}};
    for (std::size_t k = 0; k < d.monitors.size(); ++k) {
      const auto* const monitor =
          found_.data() + FindingWords::monitors + FindingWords::per_monitor * k;
      finding.monitors.push_back({judgement(d, k, monitor),
                                  judgement(d, k, monitor + FindingWords::ahead),
                                  verdict(monitor[FindingWords::returns])});
    }
  }

 private:
  // The steps of the grid below and above; false: it has no value.
  static bool ends(const Reading& reading, const Rational& step, std::int64_t* to) {
    if (reading.kind != Reading::Kind::number) return false;
    const auto grid = reading.number.on_grid(step);
    to[0] = grid.lo;
    to[1] = grid.hi;
    return true;
  }
  static bool coordinate(const Reading& reading, std::int64_t* to) {
    if (!ends(reading, Rational(1, 1000), to)) return false;
    for (std::size_t k = 0; k < 2; ++k) to[k] = std::clamp(to[k], -grid_limit, grid_limit);
    return true;
  }
  // Its components arrive together.
  static void vector(const interp::TraceRow& row, std::size_t at, bool in_space, std::int64_t* to) {
    static const std::size_t axis[] = {0, 2, 6};  // of x, y and z, among the words of a point
    bool arrived = false, known = true;
    for (std::size_t k = 0; k < (in_space ? 3 : 2); ++k) {
      arrived = arrived || row.readings[at + k].kind != Reading::Kind::none;
    }
    if (!arrived) return;
    for (std::size_t k = 0; k < (in_space ? 3 : 2); ++k) {
      const bool has = coordinate(row.readings[at + k], to + axis[k]);
      known = known && has;
    }
    to[4] = row.time_us;
    to[5] = known ? 1 : 0;
  }
  static void scalar(const interp::TraceRow& row, std::size_t at, const Rational& step,
                     std::int64_t* to) {
    if (row.readings[at].kind == Reading::Kind::none) return;
    const bool known = ends(row.readings[at], step, to);
    to[3] = known && -grid_limit <= to[0] && to[1] <= grid_limit ? 1 : 0;
    to[2] = row.time_us;
  }
  // A message that says neither is none.
  static void presence(const interp::TraceRow& row, std::size_t at, std::int64_t* to) {
    if (row.readings[at].kind != Reading::Kind::number) return;
    to[0] = row.time_us;
    to[1] = row.readings[at].number.on_grid(1).lo;
    to[2] = 1;
  }
  // Its tables stay where they are while somebody looks at them: one place for all robots.
  void received(const interp::TraceRow& row, const DecisionInterface::Input& input,
                std::int64_t* to) {
    const Reading& reading = row.readings[input.component];
    if (reading.kind == Reading::Kind::none) return;
    to[2] = row.time_us;
    to[3] = reading.zone != nullptr ? 1 : 0;
    if (reading.zone == nullptr) return;
    std::unique_ptr<HeldZone>& held = zones_[input.component];
    if (held == nullptr) held = std::make_unique<HeldZone>();
    held->hold(reading.zone);
    to[0] = std::bit_cast<std::int64_t>(&held->zone());
  }
  // A trace has them once, for all robots.
  void plain_inputs(const interp::TraceRow& row, const DecisionInterface& d, std::size_t robot) {
    std::int64_t* const words = seen_.data() + robot * stride_ + RobotWords::inputs(capacity_);
    for (const DecisionInterface::Input& input : d.inputs) {
      const std::size_t from = input.component;
      if (!input.zone.empty()) {
        received(row, input, words + RobotWords::per_input * from);
        continue;
      }
      bool arrived = false;
      for (std::size_t k = 0; k < input.members.size(); ++k) {
        arrived = arrived || row.readings[from + k].kind != Reading::Kind::none;
      }
      for (std::size_t k = 0; arrived && k < input.members.size(); ++k) {
        std::int64_t* const to = words + RobotWords::per_input * (input.component + k);
        to[0] = to[1] = std::numeric_limits<std::int64_t>::min();  // no number
        if (ends(row.readings[from + k], input.step, to)) {
          to[0] = std::max(to[0], std::numeric_limits<std::int64_t>::min() + 1);  // it is finite
        }
        to[2] = row.time_us;
        to[3] = 1;
      }
    }
  }
  // A new plan starts at its first way-point, unless its index says otherwise.
  void plan(const interp::PlanReading& plan, const Reading& index, std::int64_t* to) const {
    constexpr std::size_t points = RobotWords::points - RobotWords::plan;
    if (plan.kind != Reading::Kind::none) {
      to[0] = plan.kind == Reading::Kind::number ? 1 : 0;
      to[1] = static_cast<std::int64_t>(plan.points.size());
      to[2] = 0;
      for (std::size_t i = 0; i < std::min(plan.points.size(), capacity_); ++i) {
        to[points + i] = plan.points[i].x_mm;
        to[points + capacity_ + i] = plan.points[i].y_mm;
      }
    }
    if (index.kind == Reading::Kind::unknown) to[0] = 0;
    if (index.kind != Reading::Kind::number) return;
    // beyond the end, and below the start, it is unknown to the kernel
    to[2] = std::clamp<std::int64_t>(index.number.on_grid(1).lo, -1, to[1] + 1);
  }

  SharedObject object_;
  std::size_t capacity_, stride_;
  std::vector<std::int64_t> seen_;                          // by robot of the specification
  std::map<std::size_t, std::unique_ptr<HeldZone>> zones_;  // by component
  std::vector<DecisionInterface> decisions_;
  std::vector<Step> steps_;
  std::vector<std::int64_t> fleet_, found_;
};

}  // namespace

namespace {

// Units of margins by their number in the kernel.
std::vector<DecisionInterface::Unit> told_units(const ir::Decision& d) {
  std::vector<DecisionInterface::Unit> units{{"", 1}, {"m", 1}, {"%", 1}, {"", 1}};
  for (std::size_t k = units.size(); k < d.facts.units.size(); ++k) {
    const ir::Unit& unit = d.facts.units[k];
    const bool percent = unit.dimension == sema::dims::ratio;
    units.push_back(
        {sema::unit_of(unit.dimension), percent ? Rational(unit.scale * 100) : unit.scale});
  }
  return units;
}

void add_signals(const ir::Decision& d, const sema::Spec& spec, DecisionInterface& to) {
  std::vector<std::size_t> first;  // component of each input
  for (const sema::Input& input : spec.inputs) {
    first.push_back(to.components);
    to.components += input.components.size();
  }
  const codegen::WatchNames members = codegen::watch_names(d.facts);
  for (std::uint32_t c = 0; c < d.facts.inputs.size(); ++c) {
    const ir::Channel& channel = d.facts.inputs[c];
    const bool number = channel.kind == ir::ChannelKind::number;
    const bool zone = channel.kind == ir::ChannelKind::zone;
    DecisionInterface::Input input{channel.name,
                                   first[channel.declared],
                                   members.samples[c],
                                   zone ? 0 : codegen::between_words(channel),
                                   {},
                                   number ? channel.unit.step : Rational(1)};
    if (zone) {
      input.zone = members.signal(c, 0).zone;
      to.inputs.push_back(std::move(input));
      continue;
    }
    for (std::uint32_t k = 0; k < channel.components.size(); ++k) {
      input.members.push_back(members.signal(c, k).name);
    }
    to.inputs.push_back(std::move(input));
  }
  for (const sema::Agent& agent : spec.agents) {
    if (d.agents.empty()) break;
    const auto found = std::find_if(d.agents.begin(), d.agents.end(),
                                    [&](const ir::Agent& each) { return each.name == agent.name; });
    to.agents.emplace_back();
    if (found == d.agents.end()) continue;
    to.agents.back().seen = members.samples[found->seen];
    to.agents.back().in_space = found->in_space;
    if (found->present) to.agents.back().present = members.samples[*found->present];
  }
  for (std::size_t k = 0; k < d.facts.params.size(); ++k) {
    to.params.emplace_back(members.params[k], d.facts.params[k].value);
  }
}

}  // namespace

std::vector<DecisionInterface> decision_interfaces(ir::Module& module, const sema::Spec& spec,
                                                   const std::string& prefix) {
  module.name = prefix;
  const codegen::Names names(module, spec);
  std::vector<DecisionInterface> all;
  for (const ir::Decision& d : module.decisions) {
    DecisionInterface to;
    to.name = d.name;
    to.library = prefix;
    to.prefix = prefix + "_" + names(d.name);
    to.advanced = d.advanced;
    to.plan_capacity = d.plan_capacity;
    to.has_heading = d.body.heading_age_us.has_value();
    to.judges_commands = ir::judges_commands(d);
    to.jitter_us = d.body.jitter_us;
    to.in_space = ir::in_space(module);
    to.open_fleet = d.open_fleet;
    to.on_plan = d.on_plan;
    to.period_s = Rational(static_cast<long>(d.period_us), 1'000'000);
    to.period_s.canonicalize();
    for (const ir::Monitor& m : d.monitors) {
      to.monitors.push_back(m.name);
      to.returns.push_back(m.return_when.has_value());
      if (!d.on_plan) to.recoveries.push_back(m.recovery.name);
      to.units.push_back(ir::mixes_units(m) ? "" : ir::decision_unit_text(m));
    }
    if (d.on_plan) to.recoveries.push_back(d.safe);
    if (ir::mixes_units(module)) to.told_units = told_units(d);
    add_signals(d, spec, to);
    for (std::size_t r = 0; r < spec.robots.size(); ++r) {
      if (spec[spec.robots[r].kind].name == d.kind) to.robots.push_back(r);
    }
    if (!to.robots.empty()) all.push_back(std::move(to));
  }
  return all;
}

LoadedDecisions load_decisions(const std::vector<OutputFile>& files, const std::string& source,
                               const std::vector<DecisionInterface>& decisions,
                               std::size_t robot_count) {
  BuiltObject built = build_object(files, decision_glue(decisions, source));
  if (!built.object) return {nullptr, built.problem};
  return {std::make_unique<KernelDecisions>(std::move(*built.object), decisions, robot_count), ""};
}

}  // namespace rtac::driver
