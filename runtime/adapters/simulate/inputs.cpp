#include "inputs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <variant>

#include "rtac/sim/random.h"

namespace rtac::simulate {
namespace {

constexpr std::uint64_t input_stream = 3005;

std::string number(double value) {
  constexpr std::size_t widest = 32;
  char text[widest];
  std::snprintf(text, widest, "%.6g", value);
  return text;
}

const Scenario::Given* given(const Scenario& scenario, const std::string& input) {
  for (const auto& [name, values] : scenario.inputs) {
    if (name == input) return &values;
  }
  return nullptr;
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
  const Input::Component& c = input.components[component];
  const auto* const real = std::get_if<double>(&value);
  if (real == nullptr || *real < c.least || *real > c.most) return std::nullopt;
  return *real;
}

double drawn(const Input& input, const Input::Component& c, sim::Random& random) {
  switch (input.kind) {
    case Input::Kind::truth:
      return random.uniform() < 0.5 ? 0 : 1;
    case Input::Kind::choice:
      return static_cast<double>(random.below(static_cast<std::int64_t>(input.values.size())));
    case Input::Kind::number:
      break;
  }
  return random.uniform(c.least, c.most);
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
  return "a number from " + number(c.least) + " to " + number(c.most) + " works, in SI units";
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

}  // namespace

Told draw_inputs(const DecisionCase& decision, const Scenario& scenario, std::uint64_t seed) {
  Told told;
  sim::Random random = sim::Random::stream(seed, input_stream, 0);
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

DecisionCase with_inputs(const DecisionCase& decision, const Told& told) {
  DecisionCase d = decision;
  d.measured = told.measured;
  for (const Mention& m : d.mentions) {
    const double is = told.is[m.component];
    at(d.properties[m.monitor], m.path).value = m.wanted ? (is == *m.wanted ? 1 : 0) : is;
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
