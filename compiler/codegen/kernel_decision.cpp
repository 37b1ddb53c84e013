#include "compiler/codegen/kernel_decision.h"

#include <algorithm>
#include <type_traits>

#include "compiler/codegen/kernel_blocks.h"
#include "compiler/codegen/watch.h"
#include "compiler/ir/linear.h"

namespace rtac::codegen {

using namespace ir;

std::string requirement(const Monitor& m) {
  return m.requirement_id + (m.requirement_id.empty() ? "" : ": ") + m.requirement_text + " (" +
         m.file + ":" + num(m.line) + ")";
}

namespace {

bool judges_others(const Block& block) {
  return std::any_of(block.values.begin(), block.values.end(),
                     [](const Value& v) { return body_of(v.op) != nullptr; });
}
bool speaks_of_agents(const Monitor& m) {
  return std::any_of(m.property.values.begin(), m.property.values.end(),
                     [](const Value& v) { return std::holds_alternative<AgentDistance>(v.op); });
}
bool judges_others(const Monitor& m) {
  return judges_others(m.property) || (m.ahead && judges_others(*m.ahead)) ||
         (m.return_when && judges_others(*m.return_when));
}

}  // namespace

DecisionPrinter::DecisionPrinter(const Module& module, const Decision& decision, const Names& names,
                                 std::set<std::string>& uses, Code& out)
    : module_(module),
      d_(decision),
      names_(names),
      id_(names(decision.name)),
      p_(module.name),
      name_(p_ + "_" + id_),
      up_(upper(p_)),
      view_(id_ + "_view"),
      uses_(uses),
      out_(out),
      gaps_(agent_gaps(decision)) {
  for (const PlainMonitor& fact : d_.facts.monitors) {
    pairs_ = pairs_ || judges_others(fact.property);
  }
  for (const Monitor& m : d_.monitors) {
    if (m.separation_mm) separation_ = std::max(separation_.value_or(0), *m.separation_mm);
    pairs_ = pairs_ || judges_others(m);
    const std::int64_t us = horizon_us(d_, m);
    if (std::find(horizons_.begin(), horizons_.end(), us) == horizons_.end()) {
      horizons_.push_back(us);
    }
  }
}

namespace {

// Of the zones that the robot's own position is compared with.
void collect_places(const Block& block, std::vector<ZoneIndex>& zones) {
  for (const Value& v : block.values) {
    std::visit(
        [&](const auto& op) {
          using Node = std::decay_t<decltype(op)>;
          if constexpr (std::is_same_v<Node, Clearance> || std::is_same_v<Node, ZoneReach> ||
                        std::is_same_v<Node, ZoneCourse> || std::is_same_v<Node, LegsInZone>) {
            if (std::find(zones.begin(), zones.end(), op.zone) == zones.end()) {
              zones.push_back(op.zone);
            }
          } else if constexpr (std::is_same_v<Node, ForOthers> ||
                               std::is_same_v<Node, CountOthers>) {
            collect_places(*op.body, zones);
          }
        },
        v.op);
  }
}

}  // namespace

std::vector<ZoneIndex> DecisionPrinter::own_places() const {
  std::vector<ZoneIndex> zones;
  for (const Monitor& m : d_.monitors) {
    collect_places(m.property, zones);
    if (m.ahead) collect_places(*m.ahead, zones);
    if (m.return_when) collect_places(*m.return_when, zones);
  }
  for (const PlainMonitor& fact : d_.facts.monitors) collect_places(fact.property, zones);
  return zones;
}

std::size_t DecisionPrinter::horizon_of(const Monitor& m) const {
  const std::int64_t us = horizon_us(d_, m);
  return std::size_t(std::find(horizons_.begin(), horizons_.end(), us) - horizons_.begin());
}

std::size_t DecisionPrinter::separation_horizon() const {
  std::optional<std::size_t> best;
  for (const Monitor& m : d_.monitors) {
    if (!m.separation_mm && !speaks_of_agents(m)) continue;
    const std::size_t h = horizon_of(m);
    if (!best || horizons_[h] > horizons_[*best]) best = h;
  }
  return best.value_or(0);
}

void DecisionPrinter::print_body(const std::string& name, std::int64_t position_age_us,
                                 std::int64_t velocity_age_us) {
  const Body& b = d_.body;
  out_.block(
      "static const body " + name + " =",
      [&](Code& to) {
        // of a robot in space a step of the grid more: three axes are rounded (estimate_of)
        const std::int64_t speed_mmps = d_.motions[0].speed_mmps + (b.in_space ? 1 : 0);
        to.line(num(b.radius_mm) + ", " + num(speed_mmps) + ", " + num(b.position_error_mm) + ", " +
                num(b.velocity_error_mmps) + ", " + num(b.accel_mmps2) + ", " + num(b.brake_mmps2) +
                ", " + num(b.brake_lag_ms) + ", " + num(b.brake_lag_permille) + ", " +
                num(b.hold_mm) + ", " + num(position_age_us) + ", " + num(velocity_age_us) +
                (is_disturbed(module_) ? ", " + num(sway_permille(b)) : "") +
                (has_agents(module_)
                     ? ", " + num(b.brake_mmps2 - b.disturbance_mmps2) + ", " + num(still_lag_ms(b))
                     : ""));
      },
      "};");
}

void DecisionPrinter::print_constants() {
  use({"body_type", "motion_type"});
  if (is_disturbed(module_)) use({"disturbed"});
  if (is_calm(module_)) use({"calm"});
  if (in_space(module_)) use({"in_space"});
  out_.comment("---- decision " + d_.name + " for " + d_.kind + " ----");
  const auto define = [&](const std::string& key, const std::string& value) {
    out_.line("#define " + key + " " + value);
    defined_.push_back(key);
  };
  define("BODY", id_ + "_body");
  define("MOTIONS", id_ + "_motions");
  define("MONITORS", upper(name_) + "_MONITORS");
  define("ROBOTS", upper(name_) + "_ROBOTS");
  out_.blank();
  const Body& b = d_.body;
  out_.comment(
      "radius mm, speed mm/s, position error mm, velocity error mm/s, acceleration and brake "
      "mm/s^2, brake lag ms and permille, hold mm, largest ages us" +
      std::string(is_disturbed(module_) ? ", sway permille" : "") +
      (has_agents(module_) ? ", net brake mm/s^2, lag until it stands ms" : ""));
  print_body("BODY", b.position_age_us, b.velocity_age_us);
  if (pairs()) {
    out_.comment("The same of another robot, whose samples are as old as `hears` allows.");
    print_body(id_ + "_heard_body", b.hears_age_us, b.hears_age_us);
  }
  print_agents();
  if (judges_commands(d_)) {
    use({"order_type"});
    out_.comment("Commands that the robot follows, mm/s^2, with which error, and latency, us.");
    out_.line("static const order " + id_ + "_order = {" + num(b.command_mmps2) + ", " +
              num(b.command_error_mmps2) + ", " + num(b.latency_us) + "};");
  }
  out_.comment("Speed mm/s, acceleration mm/s^2: any control, then the recoveries by priority.");
  out_.block(
      "static const motion MOTIONS[] =",
      [&](Code& to) {
        for (std::size_t i = 0; i < d_.motions.size(); ++i) {
          const Motion& m = d_.motions[i];
          to.line("{" + num(m.speed_mmps) + ", " + num(m.accel_mmps2) + ", " +
                  (m.recovery ? "1" : "0") + "}" +
                  (pairs() || i + 1 < d_.motions.size() ? "," : "") + " /* " + m.name + " */");
        }
        if (pairs()) to.line("{0, 1, 1} /* holding, and bound by its promise to stay */");
      },
      "};");
  if (!d_.keeps.empty()) print_keeps();
  out_.comment(std::string("From the decision until its recovery acts: look-ahead") +
               (b.jitter_us > 0 ? ", jitter" : "") + " and latency, us.");
  std::string list;
  for (const std::int64_t h : horizons_) list += (list.empty() ? "" : ", ") + num(h);
  out_.line("static const int64_t " + id_ + "_horizons_us[] = {" + list + "};").blank();
}

void DecisionPrinter::print_keeps() {
  out_.comment("What is shown to keep what, " +
               std::string(d_.coordinated ? "to coordinate by" : "so that it drives on") +
               ". Row: a recovery, column: a monitor; 0: not shown" +
               (d_.coordinated ? "" : ", or ranking lower") + ", 1: shown, 2: its own recovery.");
  out_.block(
      "static const int32_t " + id_ + "_keeps[] =",
      [&](Code& to) {
        for (std::size_t i = 0; i < d_.keeps.size(); ++i) {
          std::string row;
          for (std::size_t j = 0; j < d_.keeps[i].size(); ++j) {
            const bool last = i + 1 == d_.keeps.size() && j + 1 == d_.keeps[i].size();
            row += (j == 0 ? "" : " ") + num(std::int64_t(d_.keeps[i][j])) + (last ? "" : ",");
          }
          to.line(row + " /* " + d_.monitors[i].recovery.name + " */");
        }
      },
      "};");
}

void DecisionPrinter::print_agents() {
  if (has_agents(module_)) use({"near_agents"});
  if (has_agents_in_space(module_)) use({"agents_in_space"});
  if (d_.agents.empty()) return;
  use({"agent_kind_type"});
  out_.comment("What moves by itself: radius mm, position error mm, speed mm/s, largest age us.");
  out_.block(
      "static const agent_kind " + id_ + "_agents[] =",
      [&](Code& to) {
        for (std::size_t k = 0; k < d_.agents.size(); ++k) {
          const Agent& a = d_.agents[k];
          to.line("{" + num(a.radius_mm) + ", " + num(a.error_mm) + ", " + num(a.speed_mmps) +
                  ", " + num(a.age_us) + "}" + (k + 1 < d_.agents.size() ? "," : "") + " /* " +
                  a.name + " */");
        }
      },
      "};");
}

std::vector<Sensed> DecisionPrinter::aged() const {
  std::vector<Sensed> found;
  for (const Sensed signal : {Sensed::position, Sensed::velocity, Sensed::battery}) {
    const auto reads = [&](const Value& v) {
      const auto* age = std::get_if<SensedAge>(&v.op);
      return age != nullptr && age->signal == signal;
    };
    const auto& facts = d_.facts.monitors;
    if (std::any_of(facts.begin(), facts.end(), [&](const PlainMonitor& fact) {
          const auto& values = fact.property.values;
          return std::any_of(values.begin(), values.end(), reads);
        })) {
      found.push_back(signal);
    }
  }
  return found;
}

void DecisionPrinter::print_view() {
  use({"estimate_type", "reach_type", "span_type"});
  if (pairs()) use({"other_type"});
  if (!d_.facts.monitors.empty()) {
    out_.comment("What is judged now, whatever the look-ahead: by the functions below.");
    out_.block(
        "enum",
        [&](Code& to) {
          for (const std::string& symbol : fact_symbols(d_, names_)) to.line(symbol + ",");
          to.line(fact_count_symbol(d_, names_));
        },
        "};");
    out_.blank();
  }
  out_.comment("What a tick knows, seen with one horizon and the motion of one driver.");
  out_.block(
      "typedef struct " + view_,
      [&](Code& to) {
        to.line("const " + name_ + "_in *in;");
        to.line("const motion *m;");
        to.line("int64_t now_us, horizon_us;");
        to.line("int32_t me;     /* index of this robot, in range */");
        to.line("int32_t driver; /* whose motion bounds what is within reach */");
        to.line("int32_t legs;   /* judge the plan too */");
        to.line("int32_t new_tick; /* not a second step within one */");
        to.line("int32_t *runs; /* of `for`, two each */");
        if (judges_commands(d_)) {
          to.line("const " + p_ + "_command *commands; /* that were sent, the newest first */");
        }
        to.line("estimate self;");
        to.line("reach within;");
        if (judges_commands(d_)) {
          use({"course_type"});
          to.line("course told; /* under the commands that are known */");
        }
        to.line("span charge;");
        for (const ZoneIndex zone : own_places()) {
          use({"place_type"});
          to.line("place " + place_symbol(module_[zone], names_) + "; /* of the robot itself */");
        }
        if (!d_.facts.received.empty()) {
          use({"rim_type"});
          to.line("rim received[" + num(std::int64_t(d_.facts.received.size())) +
                  "]; /* zones that are received, seen from the robot */");
        }
        for (const Sensed signal : aged()) {
          to.line(std::string("span age_of_") + word_of(signal) + "; /* us */");
        }
        if (d_.body.heading_age_us) {
          to.line("int32_t heading; /* input that is missing to steer; " + up_ +
                  "_INPUT_NONE: none */");
        }
        if (pairs()) to.line("other others[ROBOTS];");
        if (!d_.agents.empty()) {
          use({"agent_type"});
          to.line("agent agents[" + num(std::int64_t(d_.agents.size())) + "];");
        }
        if (has_signals(d_)) to.line(id_ + "_facts_view facts;");
        if (!d_.facts.monitors.empty()) {
          use({"margin_type"});
          to.line("margin fact[" + fact_count_symbol(d_, names_) + "];");
        }
      },
      "} " + view_ + ";");
  out_.blank();
}

void DecisionPrinter::close() {
  for (const std::string& key : defined_) out_.line("#undef " + key);
  out_.blank();
}

}  // namespace rtac::codegen
