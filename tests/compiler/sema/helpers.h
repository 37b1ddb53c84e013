// Checks a specification from its text, and edits the one that most tests start from.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "compiler/sema/check.h"
#include "compiler/sema/spec_printer.h"
#include "compiler/syntax/parse.h"
#include "tests/compiler/diagnostics/helpful.h"

namespace rtac::sema::test {

struct Checked {
  SourceManager sources;
  diag::Engine engine;
  std::optional<Spec> spec;
  FileId root{};

  // "error 3001 at `0.2`: ..." for each report: what a failing test prints.
  [[nodiscard]] std::string reports() const {
    std::string all;
    for (const diag::Diagnostic& each : engine.all()) {
      all += std::to_string(static_cast<int>(each.code)) + " " + diag::info(each.code).name +
             " at `" + (each.range ? std::string(sources.text(*each.range)) : "") +
             "`: " + each.message + "\n    help: " + each.help + "\n";
    }
    return all;
  }
};

inline std::unique_ptr<Checked> check_file(Checked&& start, FileId root) {
  auto result = std::make_unique<Checked>(std::move(start));
  result->root = root;
  std::vector<std::string> dependencies;
  const auto program = syntax::parse_program(root, result->sources, result->engine, dependencies);
  result->spec = check(program, result->engine);
  diag::expect_help(result->engine);
  return result;
}

inline std::unique_ptr<Checked> check_text(const std::string& text) {
  Checked start;
  const FileId root = start.sources.add("test.rta", text);
  return check_file(std::move(start), root);
}

using Change = std::pair<std::string, std::string>;

// Replaces the first place of each text; a test whose text is not there must fail.
inline std::string edited(std::string text, const std::vector<Change>& changes) {
  for (const auto& [from, to] : changes) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) {
      ADD_FAILURE() << "not in the text: " << from;
      return text;
    }
    text.replace(at, from.size(), to);
  }
  return text;
}

// The text with every fix-it of `diagnostic` applied, the last place first.
inline std::string fixed(std::string text, const diag::Diagnostic& diagnostic) {
  for (auto fix = diagnostic.fixits.rbegin(); fix != diagnostic.fixits.rend(); ++fix) {
    text.replace(fix->range.begin, fix->range.end - fix->range.begin, fix->replacement);
  }
  return text;
}

// Two carts with all that the language knows, and a drone.
inline const char* const yard_text = R"(spec yard;

zone arena = rectangle (0 m, 0 m) to (5 m, 5 m);
zone box   = rectangle (2 m, 2 m) to (3 m, 3 m);
zone free  = arena - box;

robot Cart {
  body    radius 11 cm;
  motion  unicycle { speed <= 0.5 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 2 m/s^2; turn_accel <= 10 rad/s^2; }
  sense   position : point error 2 cm max_age 200 ms;
  sense   heading : angle error 2 deg max_age 150 ms;
  sense   velocity : vector error 1 cm/s max_age 200 ms;
  sense   battery : ratio error 0.5 % max_age 5 s;
  hears   other robots max_age 250 ms;
  input   plan : path[64] tracking <= 10 cm;
  output  drive : twist;
  latency 40 ms;
  energy  { drive <= 0.4 %/m; idle <= 0.01 %/s; drain <= 0.2 %/s; charge >= 1 %/s at dock; held <= 60 s; detour <= 3 m; }
}

robot Drone {
  body    radius 8 cm;
  motion  point { speed <= 1 m/s; accel <= 3 m/s^2; brake >= 3 m/s^2; }
  sense   position : point error 3 cm max_age 50 ms;
  sense   velocity : vector error 3 cm/s max_age 50 ms;
  output  thrust : acceleration;
  latency 20 ms;
}

fleet c1, c2 : Cart;
fleet d1 : Drone;
site  dock(c1) = (1 m, 1 m);
site  dock(c2) = (4 m, 4 m);
site  home = (1 m, 4 m);

controller policy    : advanced for Cart extern;
controller planner   : advanced for Cart extern;
controller careful   : safe for Cart extern;
controller give_way  : safe for Cart = yield within free speed 0.1 m/s order id;
controller turn_back : safe for Cart = retreat within free speed 0.1 m/s;
controller go_charge : safe for Cart = route to dock within free speed 0.2 m/s;
controller pilot     : advanced for Drone extern;
controller back_off  : safe for Drone = retreat within arena speed 0.3 m/s;

monitor apart for r : Cart {
  "R1: carts keep apart"
  always  forall q : Cart, q != r : distance(r, q) >= 8 cm;
  ahead   200 ms, 2 waypoints;
  recover give_way;
}
monitor fence for r : Cart {
  "R2: carts stay in the free area"
  always  r inside free;
  ahead   300 ms, 3 waypoints;
  recover turn_back;
  return  when clearance(r, free) >= 5 cm for 1 s;
}
monitor charge for r : Cart {
  "R3: carts reach their dock"
  always  r.battery >= energy_to(dock(r)) + 5 %;
  ahead   200 ms;
  recover go_charge;
  return  when r.battery >= 90 %;
}
monitor plan_ok for r : Cart {
  "R4: plans keep 15 cm"
  always  r.plan inside shrink(free, 26 cm);
}
monitor ceiling for d : Drone {
  "R5: the drone stays 20 cm inside"
  always  clearance(d, arena) >= 20 cm;
  ahead   100 ms;
  recover back_off;
}

decision drive for Cart {
  advanced policy;
  period   100 ms;
  priority apart > fence > charge;
  acknowledge give_way may break charge "the reserve covers it";
}
decision planning for Cart {
  advanced planner;
  safe     careful;
  on       plan;
  priority plan_ok;
}
decision fly for Drone {
  advanced pilot;
  period   50 ms;
  priority ceiling;
}
)";
inline const std::string& yard() {
  static const std::string text = yard_text;
  return text;
}

// One rule: what happens after `changes` to the yard, or to another base.
struct Rule {
  std::string name;
  std::vector<Change> changes;
  diag::Code code;
  std::string at;       // the source text that is marked
  std::string message;  // a part of it
  std::string help;     // a part of it
  bool fix = false;     // its fix-it gives a specification without errors
  const std::string& (*base)() = yard;
};

inline std::ostream& operator<<(std::ostream& out, const Rule& rule) {
  return out << rule.name;
}

}  // namespace rtac::sema::test
