#include "inputs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "rtac/sim/random.h"

namespace rtac::simulate {
namespace {

constexpr std::uint64_t input_stream = 3005;

std::string number(double value) {
  constexpr std::size_t widest = 32;
  char text[widest];
  std::snprintf(text, widest, value == std::floor(value) ? "%.15g" : "%.6g", value);
  return text;
}

const Scenario::Given* given(const Scenario& scenario, const std::string& input) {
  for (const auto& [name, values] : scenario.inputs) {
    if (name == input) return &values;
  }
  return nullptr;
}

bool is_real(const Input& input) {
  return input.kind == Input::Kind::number;
}
bool can_be(const Input& input, std::size_t component, double value) {
  const Input::Component& c = input.components[component];
  return value >= c.least && value <= c.most && (is_real(input) || value == std::floor(value));
}

// What one component is; nothing: no such thing can be.
std::optional<double> value_of(const Input& input, std::size_t component,
                               const Scenario::Value& value) {
  if (input.kind == Input::Kind::truth) {
    const bool* const truth = std::get_if<bool>(&value);
    return truth != nullptr ? std::optional<double>(*truth ? 1 : 0) : std::nullopt;
  }
  if (input.kind == Input::Kind::choice) {
    const auto* const name = std::get_if<std::string>(&value);
    const auto found = name == nullptr ? input.values.end()
                                       : std::find(input.values.begin(), input.values.end(), *name);
    if (found == input.values.end()) return std::nullopt;
    return static_cast<double>(found - input.values.begin());
  }
  const auto* const real = std::get_if<double>(&value);
  if (real == nullptr || !can_be(input, component, *real)) return std::nullopt;
  return *real;
}

double drawn(const Input& input, const Input::Component& c, sim::Random& random) {
  if (is_real(input)) return random.uniform(c.drawn_least, c.drawn_most);
  const double count = std::floor(c.drawn_most) - std::ceil(c.drawn_least) + 1;
  return std::ceil(c.drawn_least) +
         static_cast<double>(random.below(static_cast<std::int64_t>(count)));
}

std::string what_works(const Input& input, std::size_t component) {
  if (input.kind == Input::Kind::truth) return "`true` and `false` work";
  if (input.kind == Input::Kind::choice) {
    std::string names;
    for (const std::string& name : input.values) {
      names += (names.empty() ? "\"" : ", \"") + name + "\"";
    }
    return "there are " + names;
  }
  const Input::Component& c = input.components[component];
  return (is_real(input) ? "a number from " : "a whole number from ") + number(c.least) + " to " +
         number(c.most) + " works, in SI units";
}

Problem unfit(const Input& input, const Scenario::Given& values) {
  if (values.size() != input.components.size()) {
    return {"the scenario gives " + std::to_string(values.size()) + " values of `" + input.name +
                "`, which has " + std::to_string(input.components.size()),
            "a list of as many works"};
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (value_of(input, k, values[k])) continue;
    return {"the input `" + input.name + "` of the specification cannot be what the scenario says",
            what_works(input, k)};
  }
  return {};
}

sim::Property& at(sim::Property& root, const std::vector<std::size_t>& path) {
  sim::Property* p = &root;
  for (const std::size_t k : path) p = &p->of[k];
  return *p;
}

bool may_be(const sim::Property& p, bool so);

// Of constants alone; nothing: something else decides, too.
std::optional<double> constant(const sim::Property& p) {
  if (p.op == sim::PropertyOp::constant) return p.value;
  if (p.of.empty()) return std::nullopt;
  if (p.op == sim::PropertyOp::choice) {
    const bool holds = may_be(p.of[0], true);
    return holds && may_be(p.of[0], false) ? std::nullopt : constant(p.of[holds ? 1 : 2]);
  }
  std::vector<double> of;
  for (const sim::Property& each : p.of) {
    const std::optional<double> value = constant(each);
    if (!value) return std::nullopt;
    of.push_back(*value);
  }
  const double value = sim::combined(p.op, of.size(), [&](std::size_t k) { return of[k]; });
  return std::isnan(value) ? std::nullopt : std::optional<double>(value);
}

// Whether it may be so, wherever robots are.
bool may_be(const sim::Property& p, bool so) {
  const auto each_may = [&](const sim::Property& operand) { return may_be(operand, so); };
  switch (p.op) {
    case sim::PropertyOp::truth:
      return (p.value != 0) == so;
    case sim::PropertyOp::at_least: {
      const auto a = constant(p.of[0]), b = constant(p.of[1]);
      return !a || !b || (p.flag ? *a > *b : *a >= *b) == so;
    }
    case sim::PropertyOp::logical_not:
      return may_be(p.of[0], !so);
    case sim::PropertyOp::logical_and:
      return so ? std::all_of(p.of.begin(), p.of.end(), each_may)
                : std::any_of(p.of.begin(), p.of.end(), each_may);
    case sim::PropertyOp::logical_or:
      return so ? std::any_of(p.of.begin(), p.of.end(), each_may)
                : std::all_of(p.of.begin(), p.of.end(), each_may);
    default:
      return true;
  }
}

bool is_condition(sim::PropertyOp op) {
  switch (op) {
    case sim::PropertyOp::truth:
    case sim::PropertyOp::open:
    case sim::PropertyOp::inside:
    case sim::PropertyOp::at_least:
    case sim::PropertyOp::logical_not:
    case sim::PropertyOp::logical_and:
    case sim::PropertyOp::logical_or:
    case sim::PropertyOp::forall:
    case sim::PropertyOp::exists:
      return true;
    default:
      return false;
  }
}

// Nothing but inputs decides whether it holds.
bool of_inputs_alone(const sim::Property& p) {
  if (p.op == sim::PropertyOp::constant || p.op == sim::PropertyOp::truth) return true;
  return !p.of.empty() && std::all_of(p.of.begin(), p.of.end(), of_inputs_alone);
}

// The properties where the inputs are so.
DecisionCase told_of(const DecisionCase& decision, const Told& told) {
  DecisionCase d = decision;
  d.measured = told.measured;
  for (const Mention& m : d.mentions) {
    const double is = told.is[m.component];
    at(d.properties[m.monitor], m.path).value = m.wanted ? (is == *m.wanted ? 1 : 0) : is;
  }
  return d;
}

// What inputs alone decide is true or false, by no margin that would hide what robots do, and what
// they alone make is a number.
void settle(sim::Property& p) {
  for (sim::Property& each : p.of) settle(each);
  sim::Property decided;
  if (p.op == sim::PropertyOp::choice && p.of[0].op == sim::PropertyOp::truth) {
    decided = std::move(p.of[p.of[0].value != 0 ? 1 : 2]);
  } else if (is_condition(p.op)) {
    // whoever is alone has no others of whom it could be false
    const bool of_others = p.op == sim::PropertyOp::forall || p.op == sim::PropertyOp::exists;
    if (of_others || !of_inputs_alone(p)) return;
    decided.op = sim::PropertyOp::truth;
    decided.value = may_be(p, true) ? 1 : 0;
  } else {
    const std::optional<double> number = constant(p);
    if (!number) return;
    decided.op = sim::PropertyOp::constant;
    decided.value = *number;
  }
  p = std::move(decided);
}

Told draw(const DecisionCase& decision, const Scenario& scenario, sim::Random& random) {
  Told told;
  for (const Input& input : decision.inputs) {
    const Scenario::Given* const values = given(scenario, input.name);
    for (std::size_t k = 0; k < input.components.size(); ++k) {
      const Input::Component& c = input.components[k];
      const double any = drawn(input, c, random);
      const double is = values != nullptr ? value_of(input, k, (*values)[k]).value_or(any) : any;
      // on the bound of its error; what is out of range would be unknown
      const double measured = is + random.sign() * c.error;
      told.is.push_back(is);
      told.measured.push_back(std::clamp(measured, c.least, c.most));
    }
  }
  return told;
}

// How many parts of a property would have to be another way, so that it may be `so`.
int parts_amiss(const sim::Property& p, bool so) {
  const auto of_all = [&](bool all) {
    int most = all ? 0 : std::numeric_limits<int>::max();
    for (const sim::Property& each : p.of) {
      const int amiss = parts_amiss(each, so);
      most = all ? most + amiss : std::min(most, amiss);
    }
    return most;
  };
  switch (p.op) {
    case sim::PropertyOp::logical_not:
      return parts_amiss(p.of[0], !so);
    case sim::PropertyOp::logical_and:
      return of_all(so);
    case sim::PropertyOp::logical_or:
      return of_all(!so);
    default:
      return may_be(p, so) ? 0 : 1;
  }
}
int parts_amiss(const DecisionCase& decision, const Scenario& scenario, const Told& told) {
  const DecisionCase d = told_of(decision, told);
  int amiss = 0;
  for (std::size_t k = 0; k < d.properties.size(); ++k) {
    amiss += parts_amiss(d.properties[k], d.monitors[k].name != scenario.unmet);
  }
  return amiss;
}

// Of a number its ends, and another draw; of the others everything that they can be.
std::vector<double> choices(const Input& input, const Input::Component& c, sim::Random& random) {
  constexpr double values_most = 16;
  std::vector<double> all{drawn(input, c, random), c.drawn_least, c.drawn_most};
  if (is_real(input) || c.drawn_most - c.drawn_least > values_most) return all;
  for (double value = std::ceil(c.drawn_least); value <= c.drawn_most; ++value) {
    all.push_back(value);
  }
  return all;
}

// One after the other becomes what leaves fewer parts amiss, as long as that helps: of many inputs
// hardly any draw is right in all of them.
void better(const DecisionCase& decision, const Scenario& scenario, sim::Random& random,
            Told& told) {
  int amiss = parts_amiss(decision, scenario, told);
  for (int before = amiss + 1; amiss > 0 && amiss < before;) {
    before = amiss;
    std::size_t component = 0;
    for (const Input& input : decision.inputs) {
      for (const Input::Component& c : input.components) {
        const std::size_t k = component++;
        if (given(scenario, input.name) != nullptr) continue;
        for (const double value : choices(input, c, random)) {
          const double was = std::exchange(told.is[k], value);
          const int now = parts_amiss(decision, scenario, told);
          if (now >= amiss) told.is[k] = was;
          amiss = std::min(amiss, now);
        }
        const double measured = told.is[k] + random.sign() * c.error;
        told.measured[k] = std::clamp(measured, c.least, c.most);
      }
    }
  }
}

// The decision with the inputs that a scenario gives; the others may be anything.
DecisionCase with_given(const DecisionCase& decision, const Scenario& scenario, const Told& told) {
  DecisionCase d = told_of(decision, told);
  for (const Mention& m : d.mentions) {
    std::size_t first = 0;
    for (const Input& input : d.inputs) {
      const std::size_t next = first + input.components.size();
      const bool own = m.component >= first && m.component < next;
      if (own && given(scenario, input.name) == nullptr) {
        at(d.properties[m.monitor], m.path).op = sim::PropertyOp::battery;  // may be either
      }
      first = next;
    }
  }
  return d;
}

// Whether each property can hold somewhere, or is one of inputs alone which the scenario wants to
// be false, by its name or by what it says of inputs.
bool fits(const DecisionCase& decision, const Scenario& scenario, const Told& told) {
  const DecisionCase d = told_of(decision, told), given = with_given(decision, scenario, told);
  for (std::size_t k = 0; k < d.properties.size(); ++k) {
    const bool can_hold = may_be(d.properties[k], true);
    const bool unmet = d.monitors[k].name == scenario.unmet;
    if (unmet && (can_hold || !of_inputs_alone(d.properties[k]))) return false;
    if (can_hold || unmet) continue;
    if (!of_inputs_alone(d.properties[k]) || may_be(given.properties[k], true)) return false;
  }
  return true;
}

// What was drawn last leaves no place where every property holds.
Problem never_hold(const DecisionCase& decision, const Scenario& scenario, const Told& told) {
  const DecisionCase d = with_given(decision, scenario, told);
  std::string hopeless;
  for (std::size_t k = 0; k < d.properties.size(); ++k) {
    if (may_be(d.properties[k], true) || of_inputs_alone(d.properties[k])) continue;
    hopeless += (hopeless.empty() ? "`" : ", `") + d.monitors[k].name + "`";
  }
  if (!hopeless.empty()) {
    return {"with the inputs of the scenario no place is left where " + hopeless + " of `" +
                decision.name + "` can hold: " + text_of(decision, told),
            "an input that the scenario leaves out is drawn so that properties can hold", true};
  }
  if (!scenario.unmet.empty()) {
    return {"no inputs were found with which `" + scenario.unmet + "` of `" + decision.name +
                "` is false wherever robots are",
            "a monitor of inputs alone works", true};
  }
  const auto open =
      std::find_if(decision.inputs.begin(), decision.inputs.end(),
                   [&](const Input& input) { return given(scenario, input.name) == nullptr; });
  const std::string name = (open == decision.inputs.end() ? decision.inputs.begin() : open)->name;
  return {
      "no inputs were found with which every property of `" + decision.name +
          "` holds anywhere; the last ones were " + text_of(decision, told),
      R"(a scenario says what they are, so that it can hold: `"inputs": {")" + name + R"(": ...}`)",
      true};
}

}  // namespace

Problem draw_inputs(const DecisionCase& decision, const Scenario& scenario, std::uint64_t seed,
                    std::uint64_t draw_number, Told& told) {
  constexpr int draws = 1000, draws_apart = 40;  // between two that are made better
  sim::Random random = sim::Random::stream(seed, input_stream, draw_number);
  for (int n = 0; n < draws; ++n) {
    told = draw(decision, scenario, random);
    // no property depends on them
    if (decision.mentions.empty() && scenario.unmet.empty()) return {};
    if (fits(decision, scenario, told)) return {};
    if (n % draws_apart != 0) continue;
    better(decision, scenario, random, told);
    if (fits(decision, scenario, told)) return {};
  }
  return never_hold(decision, scenario, told);
}

bool can_be(const DecisionCase& decision, const Told& told) {
  std::size_t k = 0;
  for (const Input& input : decision.inputs) {
    for (std::size_t c = 0; c < input.components.size(); ++c, ++k) {
      if (k >= told.is.size() || k >= told.measured.size()) return false;
      constexpr double rounding = 1e-9;  // of what was clamped, and of the sum
      const double most = input.components[c].error * (1 + rounding) + rounding;
      if (!can_be(input, c, told.is[k]) || !can_be(input, c, told.measured[k]) ||
          std::abs(told.measured[k] - told.is[k]) > (is_real(input) ? most : 0)) {
        return false;
      }
    }
  }
  return k == told.is.size() && k == told.measured.size();
}

DecisionCase with_inputs(const DecisionCase& decision, const Told& told) {
  DecisionCase d = told_of(decision, told);
  for (sim::Property& p : d.properties) settle(p);
  for (const Mention& m : d.mentions) {
    sim::Property& p = d.properties[m.monitor];
    if (!of_inputs_alone(p) || may_be(p, true)) continue;
    p = {};
    p.op = sim::PropertyOp::truth;
    p.value = 1;
  }
  return d;
}

std::string text_of(const DecisionCase& decision, const Told& told) {
  std::string text;
  std::size_t k = 0;
  for (const Input& input : decision.inputs) {
    text += (text.empty() ? "" : ", ") + input.name + " =";
    for (std::size_t c = 0; c < input.components.size(); ++c, ++k) {
      text += " ";
      if (input.kind == Input::Kind::truth) {
        text += told.is[k] != 0 ? "true" : "false";
      } else if (input.kind == Input::Kind::choice) {
        text += input.values[static_cast<std::size_t>(told.is[k])];
      } else {
        text += number(told.is[k]);
      }
    }
  }
  return text;
}

Problem check_inputs(const Scenario& scenario, const Case& all) {
  for (const auto& [name, values] : scenario.inputs) {
    bool there = false;
    for (const DecisionCase& d : all.decisions) {
      for (const Input& input : d.inputs) {
        if (input.name != name) continue;
        there = true;
        if (Problem problem = unfit(input, values)) return problem;
      }
    }
    if (!there) {
      return {"the scenario says what the input `" + name + "` is, of which no decision speaks",
              ""};
    }
  }
  return {};
}

}  // namespace rtac::simulate
