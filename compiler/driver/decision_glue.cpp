#include "compiler/driver/decision_glue.h"

#include <algorithm>

#include "compiler/driver/glue_readers.h"

namespace rtac::driver {
namespace {

std::string num(std::size_t value) {
  return std::to_string(value);
}

// Structs of the kernel from words.
std::string readers(const std::string& p, std::size_t capacity, bool in_space) {
  constexpr std::size_t at = RobotWords::points - RobotWords::plan;
  return glue_readers(p, in_space) + "static void rtac_plan(" + p +
         "_plan *to, const int64_t *from, int64_t capacity) {\n"
         "  int32_t k;\n"
         "  to->valid = from[0] != 0 && from[1] <= capacity;\n"
         "  to->count = (int32_t)from[1];\n  to->index = (int32_t)from[2];\n"
         "  for (k = 0; k < from[1] && k < " +
         num(capacity) + "; ++k) {\n    to->x[k] = from[" + num(at) +
         " + k];\n    to->y[k] = from[" + num(at + capacity) + " + k];\n  }\n}\n";
}

// Nobody promises to stay, since nobody is known to hold; the order of the way is that of the
// fleet.
std::string others(const DecisionInterface& d, const std::string& capacity) {
  const std::string at = "from[" + num(RobotWords::presence);
  const std::string presence = "    in.others[j].presence_us = " + at + " + 2] != 0 ? " + at +
                               "] : INT64_MIN;\n    in.others[j].present = (int32_t)" + at +
                               " + 1];\n";
  return "  for (j = 0; j < " + num(d.robots.size()) +
         "; ++j) {\n"
         "    const int64_t *from = robots + j * stride;\n"
         "    rtac_point(&in.others[j].position, from + " +
         num(RobotWords::position) + ");\n    rtac_point(&in.others[j].velocity, from + " +
         num(RobotWords::velocity) + ");\n    rtac_plan(&in.others[j].plan, from + " +
         num(RobotWords::plan) + ", " + capacity +
         ");\n"
         "    in.others[j].lease_end_us = INT64_MIN;\n"
         "    in.others[j].goes_first = j < self;\n" +
         (d.open_fleet ? presence : "") + "  }\n";
}

// What its monitors say of plain inputs and parameters.
std::string facts(const DecisionInterface& d, std::size_t capacity) {
  std::string out;
  for (const DecisionInterface::Input& input : d.inputs) {
    const auto own = [&](std::size_t k, std::size_t word) {
      return "own[" +
             num(RobotWords::inputs(capacity) + RobotWords::per_input * (input.component + k) +
                 word) +
             "]";
    };
    out += take_input(input, own(0, 2), own(0, 3), own);
    if (input.zone.empty()) continue;
    // the address of its tables
    out += "  if (" + own(0, 0) + " != 0) in.facts." + input.zone + " = *(const " + d.library +
           "_zone *)(intptr_t)" + own(0, 0) + ";\n";
  }
  for (const auto& [member, value] : d.params) {
    out += "  in.facts." + member + " = " + std::to_string(value) + ";\n";
  }
  return out;
}

// What a step tells, out of the kernel's struct `out`.
std::string findings(const DecisionInterface& d) {
  std::string out;
  const char* const words[] = {"mode",        "monitor",     "found.reason",
                               "found.index", "found.input", "found.other"};
  for (std::size_t w = 0; w < FindingWords::monitors; ++w) {
    out += "  found[" + num(w) + "] = out." + words[w] + ";\n";
  }
  const bool tells = !d.told_units.empty();
  const bool returns = std::find(d.returns.begin(), d.returns.end(), true) != d.returns.end();
  const char* const of_monitor[] = {"now",
                                    "now_margin",
                                    tells ? "now_unit" : nullptr,
                                    "ahead",
                                    "margin",
                                    tells ? "unit" : nullptr,
                                    returns ? "returns" : nullptr};
  out += "  for (j = 0; j < " + num(d.monitors.size()) + "; ++j) {\n";
  for (std::size_t w = 0; w < FindingWords::per_monitor; ++w) {
    const std::string from = of_monitor[w] ? std::string("out.monitors[j].") + of_monitor[w] : "0";
    out += "    found[" + num(FindingWords::monitors + w) + " + " + num(FindingWords::per_monitor) +
           " * j] = " + from + ";\n";
  }
  return out + "  }\n}\n";
}

std::string step_head(std::size_t k, std::size_t stride) {
  return "void rtac_decision_step_" + num(k) +
         "(int32_t self, const int64_t *robots, int64_t now_us, int64_t *found) {\n"
         "  const int64_t stride = " +
         num(stride) + ";\n  const int64_t *own = robots + self * stride;\n  int32_t j;\n";
}

std::string read_plan(const std::string& to, const std::string& from, const std::string& capacity) {
  return "rtac_plan(&" + to + ", " + from + " + " + num(RobotWords::plan) + ", " + capacity +
         ");\n";
}

// Nothing lasts from one plan to the next.
std::string judge(const DecisionInterface& d, std::size_t k, std::size_t stride) {
  return "void rtac_decision_init_" + num(k) + "(void) {\n}\n" + step_head(k, stride) +
         "  static " + d.library + "_plan plan;\n  static " + d.prefix +
         "_out out;\n  (void)now_us;\n  " +
         read_plan("plan", "own", std::to_string(d.plan_capacity)) + "  " + d.prefix +
         "_judge(&plan, &out);\n" + findings(d);
}

std::string step(const DecisionInterface& d, std::size_t k, std::size_t most_capacity,
                 std::size_t stride) {
  const std::string state = "rtac_decision_states_" + num(k), count = num(d.robots.size());
  const std::string capacity = std::to_string(d.plan_capacity);
  std::string out = "static " + d.prefix + "_state " + state + "[" + count +
                    "];\n"
                    "void rtac_decision_init_" +
                    num(k) + "(void) {\n  int32_t j;\n  for (j = 0; j < " + count +
                    "; ++j) {\n    " + d.prefix + "_init(&" + state + "[j]);\n  }\n}\n";
  out += step_head(k, stride) + "  static " + d.prefix + "_in in;\n  static " + d.prefix +
         "_out out;\n  in.self = self;\n"
         "  rtac_point(&in.position, own + " +
         num(RobotWords::position) + ");\n  rtac_point(&in.velocity, own + " +
         num(RobotWords::velocity) + ");\n  rtac_scalar(&in.battery, own + " +
         num(RobotWords::battery) + ");\n";
  if (d.has_heading) {
    out += "  rtac_scalar(&in.heading, own + " + num(RobotWords::heading) + ");\n";
  }
  out += "  " + read_plan("in.plan", "own", capacity);
  out += others(d, capacity);
  out += facts(d, most_capacity);
  out += "  " + d.prefix + "_step(&" + state + "[self], &in, now_us, &out);\n";
  return out + findings(d);
}

}  // namespace

std::size_t plan_capacity(const std::vector<DecisionInterface>& decisions) {
  std::int64_t most = 1;
  for (const DecisionInterface& d : decisions) most = std::max(most, d.plan_capacity);
  return static_cast<std::size_t>(most);
}

std::string decision_glue(const std::vector<DecisionInterface>& decisions,
                          const std::string& source) {
  const std::size_t capacity = plan_capacity(decisions);
  std::string out = "#include \"" + source + "\"\n";
  out += readers(decisions.front().library, capacity, decisions.front().in_space);
  for (std::size_t k = 0; k < decisions.size(); ++k) {
    const std::size_t stride = RobotWords::size(capacity, decisions[k].components);
    const DecisionInterface& d = decisions[k];
    out += d.on_plan ? judge(d, k, stride) : step(d, k, capacity, stride);
  }
  return out;
}

}  // namespace rtac::driver
