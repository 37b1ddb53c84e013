#include "compiler/driver/sim_glue.h"

#include <algorithm>

#include "compiler/driver/glue_readers.h"

namespace rtac::driver {
namespace {

std::string num(std::size_t value) {
  return std::to_string(value);
}

// In words: { valid, count, index, x[], y[] }.
std::size_t plan_words(const DecisionInterface& d) {
  return 3 + 2 * static_cast<std::size_t>(d.plan_capacity);
}
// { position, velocity, lease end, goes first, presence stamp, present, plan }
std::size_t other_words(const DecisionInterface& d) {
  return 20 + plan_words(d);
}
// { self, holding, surrender, position, velocity, battery, heading, sent, proposed, plan, others }
constexpr std::size_t own_words = 43;
// { x, y, between, valid, stamp, present, valid, stamp, z }
constexpr std::size_t agent_words = 9;
// Agents are seen as inputs; their words are their own.
std::vector<const DecisionInterface::Input*> plain_inputs(const DecisionInterface& d) {
  std::vector<const DecisionInterface::Input*> plain;
  for (const DecisionInterface::Input& input : d.inputs) {
    const bool of_agent = std::any_of(d.agents.begin(), d.agents.end(), [&](const auto& agent) {
      return agent.seen == input.sample || agent.present == input.sample;
    });
    if (!of_agent) plain.push_back(&input);
  }
  return plain;
}
// { lo, hi, valid } of each component
constexpr std::size_t component_words = 3;
std::size_t input_words(const DecisionInterface& d) {
  std::size_t words = 0;
  for (const auto* input : plain_inputs(d)) words += component_words * input->members.size();
  return words;
}
std::size_t in_words(const DecisionInterface& d) {
  return own_words + plan_words(d) + d.robots.size() * other_words(d) +
         d.agents.size() * agent_words + input_words(d);
}
constexpr std::size_t out_words = 12, monitor_words = 7;
// Runs are played at once, and these are too large for the stack of a thread with large fleets. C99
// has no word for it; gcc and clang do.
constexpr const char* per_thread = "__thread ";

std::string readers(const std::string& p, bool in_space) {
  return glue_readers(p, in_space) + "static void rtac_plan(" + p +
         "_plan *to, const int64_t *from, int64_t capacity) {\n"
         "  int32_t k;\n"
         "  to->valid = from[0] != 0 && from[1] <= capacity;\n"
         "  to->count = (int32_t)from[1];\n  to->index = (int32_t)from[2];\n"
         "  for (k = 0; k < from[1] && k < capacity; ++k) {\n"
         "    to->x[k] = from[3 + k];\n    to->y[k] = from[3 + capacity + k];\n  }\n}\n";
}

// Called for scalars only where a kind senses them.
std::string sizes(const DecisionInterface& d, const std::string& k) {
  const std::string head = "const int64_t rtac_sim_";
  return head + "state_bytes_" + k + " = (int64_t)sizeof(" + d.prefix + "_state);\n" + head +
         "in_words_" + k + " = " + num(in_words(d)) + ";\n" + head + "jitter_us_" + k + " = " +
         std::to_string(d.jitter_us) + ";\n" + head + "out_words_" + k + " = " +
         num(out_words + monitor_words * d.monitors.size()) + ";\n" + "void rtac_sim_init_" + k +
         "(void *state) {\n  " + d.prefix + "_init((" + d.prefix + "_state *)state);\n}\n";
}

std::string take_agents(const DecisionInterface& d) {
  std::string out;
  const std::size_t first = own_words + plan_words(d) + d.robots.size() * other_words(d);
  for (std::size_t k = 0; k < d.agents.size(); ++k) {
    const auto word = [&](std::size_t at) {
      return "own[" + num(first + k * agent_words + at) + "];\n";
    };
    if (d.agents[k].seen.empty()) continue;
    const std::string seen = "  in.facts." + d.agents[k].seen + ".";
    out += seen + "x = " + word(0) + seen + "y = " + word(1) + seen + "between = (uint32_t)" +
           word(2) + seen + "valid = (int32_t)" + word(3) + seen + "stamp_us = " + word(4);
    if (d.agents[k].in_space) out += seen + "z = " + word(8);
    if (d.agents[k].present.empty()) continue;
    const std::string said = "  in.facts." + d.agents[k].present + ".";
    out += said + "value = " + word(5) + said + "between = 0;\n" + said + "valid = (int32_t)" +
           word(6) + said + "stamp_us = " + word(7);
  }
  return out;
}

// Measured now.
std::string take_inputs(const DecisionInterface& d) {
  std::string out;
  std::size_t at = in_words(d) - input_words(d);
  for (const DecisionInterface::Input* input : plain_inputs(d)) {
    const auto word = [&](std::size_t k, std::size_t which) {
      return "own[" + num(at + component_words * k + which) + "]";
    };
    out += take_input(*input, "now_us", word(0, 2), word);
    at += component_words * input->members.size();
  }
  return out;
}

std::string take_in(const DecisionInterface& d) {
  const std::string capacity = std::to_string(d.plan_capacity);
  std::string out =
      "  in.self = (int32_t)own[0];\n  in.holding = (int32_t)own[1];\n"
      "  in.surrender = (int32_t)own[2];\n  rtac_point(&in.position, own + 3);\n"
      "  rtac_point(&in.velocity, own + 11);\n  rtac_scalar(&in.battery, own + 19);\n";
  if (d.has_heading) out += "  rtac_scalar(&in.heading, own + 23);\n";
  if (d.judges_commands) {
    out += "  rtac_point(&in.sent, own + 27);\n  rtac_point(&in.proposed, own + 35);\n";
  }
  out += "  rtac_plan(&in.plan, own + " + num(own_words) + ", " + capacity + ");\n";
  out += "  for (j = 0; j < " + num(d.robots.size()) +
         "; ++j) {\n    const int64_t *from = own + " + num(own_words + plan_words(d)) + " + j * " +
         num(other_words(d)) +
         ";\n    rtac_point(&in.others[j].position, from);\n"
         "    rtac_point(&in.others[j].velocity, from + 8);\n"
         "    in.others[j].lease_end_us = from[16];\n"
         "    in.others[j].goes_first = (int32_t)from[17];\n";
  if (d.open_fleet) {
    out +=
        "    in.others[j].presence_us = from[18];\n"
        "    in.others[j].present = (int32_t)from[19];\n";
  }
  out += "    rtac_plan(&in.others[j].plan, from + 20, " + capacity + ");\n  }\n";
  out += take_agents(d) + take_inputs(d);
  for (const auto& [member, value] : d.params) {
    out += "  in.facts." + member + " = " + std::to_string(value) + ";\n";
  }
  return out;
}

std::string give_out(const DecisionInterface& d) {
  const char* const words[] = {"mode",         "previous_mode", "monitor",     "found.reason",
                               "found.index",  "found.input",   "found.other", "gate",
                               "lease_end_us", "violation_us",  "tick",        "time_us"};
  std::string out;
  std::size_t at = 0;
  for (const char* word : words) out += "  found[" + num(at++) + "] = out." + word + ";\n";
  const char* const of_monitor[] = {"now",
                                    "ahead",
                                    "safer",
                                    "engaged",
                                    "margin",
                                    "now_margin",
                                    d.told_units.empty() ? nullptr : "unit"};
  out += "  for (j = 0; j < " + num(d.monitors.size()) + "; ++j) {\n";
  for (std::size_t w = 0; w < monitor_words; ++w) {
    const std::string from = of_monitor[w] ? std::string("out.monitors[j].") + of_monitor[w] : "0";
    out +=
        "    found[" + num(out_words + w) + " + " + num(monitor_words) + " * j] = " + from + ";\n";
  }
  return out + "  }\n}\n";
}

}  // namespace

std::string sim_glue(const std::vector<DecisionInterface>& decisions, const std::string& source) {
  std::string out = "#include \"" + source + "\"\n" +
                    "const int64_t rtac_sim_words_version = " + std::to_string(sim_words_version) +
                    ";\n";
  if (!decisions.empty()) out += readers(decisions.front().library, decisions.front().in_space);
  for (std::size_t k = 0; k < decisions.size(); ++k) {
    const DecisionInterface& d = decisions[k];
    if (d.on_plan) continue;
    out += sizes(d, num(k)) + "void rtac_sim_step_" + num(k) +
           "(void *state, const int64_t *own, int64_t now_us, int64_t *found) {\n  static " +
           per_thread + d.prefix + "_in in;\n  static " + per_thread + d.prefix +
           "_out out;\n  int32_t j;\n" + take_in(d) + "  " + d.prefix + "_step((" + d.prefix +
           "_state *)state, &in, now_us, &out);\n" + give_out(d);
  }
  return out;
}

}  // namespace rtac::driver
