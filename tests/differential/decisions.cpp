#include "tests/differential/decisions.h"

#include <algorithm>

#include "tests/differential/fleet_trace.h"

namespace rtac::differential {
namespace {

using List = std::vector<std::string>;

// Robots as FleetTracer makes them, and its inputs.
const std::string fleet = R"(spec flock;
zone field = rectangle (-4 m, -4 m) to (4 m, 4 m) - circle (5.0004 m, 5 m) radius 3 m;  // no way to the nest leads across
zone core = circle (-1 m, -1 m) radius 2 m;
enum Mode { idle, busy }
input permit : bool max_age 100 ms;
input load : real in 0 .. 10 error 0.5 max_age 50 ms;
input mode : Mode;
)" + std::string(quads);

}  // namespace

DecisionPage decision_page(const List& monitors) {
  DecisionPage page{fleet, 0};
  page.first_line =
      1 + static_cast<std::size_t>(std::count(page.text.begin(), page.text.end(), '\n'));
  std::string priority, acknowledged;
  for (const std::string& line : monitors) {
    page.text += line;
    const std::string name = line.substr(8, line.find(' ', 8) - 8);  // behind `monitor `
    priority += (priority.empty() ? "" : " > ") + name;
    // what others may break is judged, too
    acknowledged += " acknowledge inwards may break " + name + " \"a test\";";
  }
  page.text += "decision fly for Quad { advanced policy; period 50 ms; priority " + priority + ";" +
               acknowledged + " }\n";
  return page;
}

std::string DecisionGenerator::monitor(std::size_t k) {
  const Place place = k % 2 == 0 ? Place::fact : Place::ahead;
  const std::string name = std::to_string(k);
  const std::string always = condition(static_cast<int>(below(3)) + 1, place);
  const std::string when = condition(static_cast<int>(below(3)) + 1, Place::now);
  return "monitor m" + name + " for r : Quad { \"D-" + name + ": random\" always " + always +
         "; recover inwards; return when " + when + "; }\n";
}

std::string DecisionGenerator::window(bool may_be_endless) {
  const std::size_t from = below(3), more = below(5);
  const std::string to =
      may_be_endless && below(4) == 0 ? "inf" : std::to_string(50 * (from + more)) + " ms";
  return "[" + std::to_string(50 * from) + " ms, " + to + "]";
}
std::string DecisionGenerator::duration() {
  return std::to_string(50 * (1 + below(4))) + " ms";
}
std::string DecisionGenerator::less_or_more() {
  return one_of(List{" < ", " <= ", " > ", " >= "});
}

std::string DecisionGenerator::number(int depth) {
  const auto sub = [&] { return number(depth - 1); };
  if (depth <= 0) return "load";
  switch (below(8)) {
    case 0:
      return "mean" + window(false) + "(" + sub() + ")";
    case 1:
      return one_of(List{"min", "max"}) + window(true) + "(" + sub() + ")";
    case 2:
      return "(rate[50 ms, 150 ms](" + sub() + ") * 50 ms)";
    case 3:
      return "(sum" + window(false) + "(" + sub() + ") / 4)";
    case 4:
      return "abs(" + sub() + " - 4)";
    case 5:
      return "(if " + input_atom() + " then " + sub() + " else 3)";
    default:
      return "load";
  }
}

std::string DecisionGenerator::input_atom() {
  switch (below(8)) {
    case 0:
    case 1:
      return "permit";
    case 2:
      return one_of(List{"mode == idle", "mode != idle"});
    case 3:
      return "count" + window(false) + "(permit)" + less_or_more() + "2";
    case 4:
      return one_of(List{"age(permit) <= 50 ms", "age(r.position) <= 50 ms",
                         "age(r.battery) <= 100 ms", "age(r.velocity) <= 0 s"});
    default:
      return number(2) + less_or_more() + one_of(List{"2", "4", "5.5", "7"});
  }
}

std::string DecisionGenerator::robot_atom() {
  return one_of(List{"r inside field", "clearance(r, field) >= 10 cm",
                     "2 * clearance(r, core) > 10 cm",
                     "(forall q : Quad, q != r : distance(r, q) >= 50 cm)",
                     "(exists q : Quad, q != r : distance(r, q) >= 1 m)",
                     "count(q : Quad, q != r : distance(r, q) <= 2 m) <= 1"});
}

std::string DecisionGenerator::length(int depth) {
  const auto sub = [&] { return length(depth - 1); };
  if (depth <= 0) return one_of(List{"clearance(r, field)", "clearance(r, core)"});
  switch (below(6)) {
    case 0:
      return "min(" + sub() + ", " + sub() + ")";
    case 1:
      return "mean" + window(false) + "(" + sub() + ")";
    case 2:
      return one_of(List{"min", "max"}) + window(true) + "(" + sub() + ")";
    case 3:
      return "abs(" + sub() + " - 40 cm)";
    case 4:
      return "(" + sub() + " + " + sub() + ")";
    default:
      return length(0);
  }
}

std::string DecisionGenerator::robot_claim() {
  switch (below(6)) {
    case 0:
      return length(2) + less_or_more() + one_of(List{"0 m", "20 cm", "50 cm", "load * 10 cm"});
    case 1:
      return "r.battery" + less_or_more() + one_of(List{"15 %", "20 %", "22.5 %"});
    case 2:
      return one_of(List{"r.battery - 20 %", "min(r.battery, 30 %)"}) + less_or_more() + "1 %";
    case 3:
      return one_of(List{"r.speed", "max" + window(true) + "(r.speed)",
                         "mean" + window(false) + "(r.speed)", "abs(r.speed - 20 cm/s)"}) +
             less_or_more() + one_of(List{"10 cm/s", "40 cm/s", "load * 10 cm/s"});
    case 4:
      return one_of(List{"count(q : Quad, q != r : distance(r, q) <= 2 m) <= 1",
                         "mean[0 ms, 100 ms](count(q : Quad, q != r : distance(r, q) < 2 m)) < 1",
                         "min(q : Quad, q != r : distance(r, q)) >= 1 m",
                         "(forall q : Quad, q != r : distance(r, q) >= 50 cm)",
                         "(exists q : Quad, q != r : distance(r, q) < 1 m)"});
    default:
      return one_of(List{"r inside field", "r inside core"});
  }
}

std::string DecisionGenerator::past(int depth, Place place) {
  const auto sub = [&] { return "(" + condition(depth - 1, place) + ")"; };
  switch (below(6)) {
    case 0:
      return "previously " + sub();
    case 1:
      return "once" + window(true) + " " + sub();
    case 2:
      return "historically" + window(true) + " " + sub();
    case 3:
      return sub() + " since" + window(true) + " " + sub();
    case 4:
      return sub() + " for " + duration();
    default:
      return sub() + " within " + duration() + " of " + sub();
  }
}

// Of what is looked ahead nothing is negated, and the past is of facts alone.
std::string DecisionGenerator::condition(int depth, Place place) {
  if (depth <= 0) {
    if (place == Place::fact || below(3) == 0) return input_atom();
    return place == Place::now ? robot_claim() : robot_atom();
  }
  const auto sub = [&] { return "(" + condition(depth - 1, place) + ")"; };
  switch (below(10)) {
    case 0:
      return sub() + " and " + sub();
    case 1:
      return sub() + " or " + sub();
    case 2:
      return (place == Place::ahead ? input_atom() : "not " + sub()) + " or " + sub();
    case 3:
      return "(" + condition(depth - 1, place == Place::ahead ? Place::fact : place) +
             ") implies " + sub();
    case 4:
    case 5: {
      const std::string op = one_of(List{" iff ", " xor "});
      const Place of = place == Place::ahead ? Place::fact : place;
      const std::string both =
          "(" + condition(depth - 1, of) + ")" + op + "(" + condition(depth - 1, of) + ")";
      return place == Place::ahead ? "(" + both + ") and " + sub() : both;
    }
    default: {
      const std::string was = past(depth, place == Place::ahead ? Place::fact : place);
      return place == Place::ahead ? "(" + was + ")" + one_of(List{" and ", " or "}) + sub() : was;
    }
  }
}

}  // namespace rtac::differential
