// Monitors of robots on random traces: what the kernel finds of a property now against what it is
// on exact numbers. Samples are missing, late, no numbers, off the grid and beyond their ranges.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "tests/compiler/driver/testing.h"

namespace rtac::differential {
namespace {

using driver::test::Outcome;
using driver::test::rtac;

constexpr const char* flock = R"(spec flock;
zone field = rectangle (-4 m, -4 m) to (4 m, 4 m) - circle (1.0004 m, 1 m) radius 1 m;
zone core = circle (-1 m, -1 m) radius 2 m;
enum Mode { idle, busy }
input permit : bool max_age 100 ms;
input load : real in 0 .. 10 error 0.5;
input mode : Mode;
param h : length in 0 m .. 0.3 m = 0.1 m;
robot Quad {
  body   radius 10.05 cm;
  motion point { speed <= 0.5 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense  position : point  error 1 cm   max_age 100 ms;
  sense  velocity : vector error 1 cm/s max_age 100 ms;
  sense  battery  : ratio  error 1 %    max_age 200 ms;
  hears  other robots max_age 150 ms, present;
  output thrust : acceleration;
  latency 20 ms;
  energy { drive <= 0.5 %/m; idle <= 0.01 %/s; drain <= 0.2 %/s; charge >= 1 %/s at home; held <= 30 s; detour <= 1 m; }
}
fleet q1, q2, q3 : Quad;
site home = (-1 m, -1 m);
controller policy  : advanced for Quad extern;
controller inwards : safe for Quad = retreat within field speed 0.2 m/s;
controller go_home : safe for Quad = route to home within field speed 0.2 m/s;
monitor walls for r : Quad { "R1: in" always r inside field; recover inwards; }
monitor clear for r : Quad { "R2: clear" always 2 * clearance(r, shrink(field, 20 cm)) - h >= 0 m; recover inwards; }
monitor apart for r : Quad { "R3: apart" always forall q : Quad, q != r : distance(r, q) > 50 cm; recover inwards; }
monitor alone for r : Quad { "R4: few" always count(q : Quad, q != r : distance(r, q) <= 2 m) <= 1; recover inwards; }
monitor near for r : Quad { "R5: far" always exists q : Quad, q != r : distance(r, q) >= 1 m; recover inwards; }
monitor low for r : Quad { "R6: charge" always r.battery >= 20 % or r inside core; recover go_home; }
monitor way for r : Quad { "R7: home" always r.battery >= energy_to(home) + 5 %; recover go_home; }
monitor permitted for r : Quad { "R8: facts" always r inside field and once[0 s, 200 ms] permit and (mean[0 s, 150 ms](load) <= 6 or mode == idle); recover inwards; }
monitor gap for r : Quad { "R9: least" always min(q : Quad, q != r : distance(r, q)) >= 20 cm + h; recover inwards; }
monitor fresh for r : Quad { "R10: fresh" always age(r.position) <= 50 ms and once[0 s, 100 ms] age(r.battery) <= 0 s; recover inwards; }
period 50 ms;
monitor member { "R11: a member is in" always q1 inside field; }
monitor spare { "R12: who is in has some room" always forall q : Quad : q inside core implies clearance(q, field) >= 40 cm; }
monitor beside { "R13: not near the core" always distance(q2, core) > 10 cm; }
monitor out { "R14: none is out" always not exists q : Quad : not q inside field; }
decision fly for Quad { advanced policy; period 50 ms; priority walls > clear > apart > alone > near > low > way > permitted > gap > fresh;
  acknowledge inwards may break low "a test"; acknowledge go_home may break low "test"; acknowledge inwards may break way "a test"; acknowledge go_home may break way "a test"; }
)";

// A trace of three robots. A row is whole when every robot has sensed all that it can, at rest.
struct Trace {
  std::string text;
  std::vector<bool> whole;  // by row
};

class Tracer {
 public:
  explicit Tracer(unsigned seed) : random_(seed) {}
  Trace trace(int rows) {
    Trace trace{"time,permit,load,mode", {}};
    for (const char* const robot : {",q1.", ",q2.", ",q3."}) {
      for (const char* const signal :
           {"position.x", "position.y", "velocity.x", "velocity.y", "battery", "present"}) {
        trace.text += std::string(robot) + signal;
      }
    }
    trace.text += "\n";
    int tick = 0;
    for (int row = 0; row < rows;
         ++row, tick += chance(12) ? 1 + static_cast<int>(random_() % 8) : 1) {
      const bool whole = chance(2);
      trace.text += number(0.05 * tick) + ",";
      trace.text += (chance(3) ? "" : chance(2) ? "1" : "0") + std::string(",");
      trace.text += (chance(4) ? "" : number(uniform(0, 11))) + "," + (chance(2) ? "idle" : "busy");
      for (int robot = 0; robot < 3; ++robot) trace.text += whole ? at_rest() : any();
      trace.text += "\n";
      trace.whole.push_back(whole);
    }
    return trace;
  }

 private:
  bool chance(unsigned one_in) { return random_() % one_in == 0; }
  double uniform(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }
  // To the micrometre or to the millimetre.
  std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, chance(2) ? "%.6f" : "%.3f", value);
    return text;
  }
  // Near an edge, near each other, anywhere.
  std::string coordinate() {
    const double edges[] = {-3.9, -3.8, 3.9, 0.0, 1.0, 2.1};
    if (chance(3)) return number(edges[random_() % 6] + uniform(-0.05, 0.05));
    return number(chance(20) ? uniform(-9, 9) : uniform(-4.2, 4.2));
  }
  std::string charge() { return number(chance(4) ? uniform(-0.02, 1.02) : uniform(0.1, 0.3)); }
  std::string at_rest() {
    return "," + coordinate() + "," + coordinate() + ",0,0," + charge() + ",1";
  }
  std::string sometimes(const std::string& value) {
    if (chance(4)) return ",";
    return "," + (chance(20) ? "nan" : value);
  }
  std::string any() {
    const std::string x = sometimes(coordinate()), y = x == "," ? "," : sometimes(coordinate());
    const std::string v = sometimes(number(uniform(-0.36, 0.36)));
    const std::string presence = chance(8) ? "0" : chance(2) ? "1" : "";
    return x + y + v + (v == "," ? "," : "," + number(uniform(-0.36, 0.36))) + sometimes(charge()) +
           "," + presence;
  }
  std::mt19937 random_;
};

// Cells by row and name of the column.
using Table = std::vector<std::map<std::string, std::string>>;
Table table(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::string> names;
  Table rows;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line + ",");
    std::map<std::string, std::string> row;
    std::size_t at = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++at) {
      if (rows.empty() && line.rfind("tick,", 0) == 0) {
        names.push_back(cell);
      } else {
        row[names[at]] = cell;
      }
    }
    if (!row.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

class RobotsNow : public driver::test::InFolder {
 protected:
  using Row = std::map<std::string, std::string>;
  void compare_verdicts(const std::string& column, Row& exact, Row& found) {
    const std::string verdict = found[column + ".verdict"];
    if (verdict == "unknown" || (prices(column) && verdict == "true")) return;
    ++decided_[column + " " + verdict];
    EXPECT_EQ(exact[column + ".verdict"], verdict);
  }
  // In whole rows, of lengths: 3 mm of the gap and 4 mm of positions off the grid, twice where the
  // property has the gap twice.
  static void compare_margins(const std::string& column, Row& exact, Row& found, bool whole) {
    const std::string unit = exact[column + ".unit"];
    if (unit != found[column + ".unit"] || prices(column)) return;
    const double below =
        std::stod(exact[column + ".margin"]) - std::stod(found[column + ".margin"]);
    if (std::isnan(below)) return;  // both infinite
    EXPECT_GT(below, -1e-9);
    if (whole && !unit.empty()) {
      EXPECT_LT(below, 0.014);
    }
  }
  // The reference has no upper bound of a way.
  static bool prices(const std::string& column) { return column.find("way") != std::string::npos; }
  void compare(const std::string& column, std::size_t row, Row& exact, Row& found, bool whole) {
    SCOPED_TRACE(column + " in row " + std::to_string(row) + ": exact " +
                 exact[column + ".margin"] + ", found " + found[column + ".margin"]);
    compare_verdicts(column, exact, found);
    compare_margins(column, exact, found, whole);
  }
  std::map<std::string, int> decided_;
};

// Of monitors without a robot, which speak of robots by name.
constexpr const char* plain[] = {"member", "spare", "beside", "out"};

// What the kernel has decided is so; in rows without age its margins are near the exact ones.
TEST_F(RobotsNow, AreJudgedConservativelyAndTightly) {
  const Trace trace = Tracer(1).trace(3000);
  driver::test::write("flock.rta", flock);
  driver::test::write("trace.csv", trace.text);
  const Outcome kernel = rtac({"replay", "flock.rta", "trace.csv"});
  const Outcome reference = rtac({"replay", "flock.rta", "trace.csv", "--engine", "interp"});
  ASSERT_EQ(kernel.err + reference.err, "");
  Table found = table(kernel.out), exact = table(reference.out);
  ASSERT_EQ(found.size(), trace.whole.size());
  ASSERT_EQ(exact.size(), trace.whole.size());
  for (std::size_t row = 0; row < exact.size(); ++row) {
    for (const char* const robot : {"q1.", "q2.", "q3."}) {
      for (const char* const monitor : {"walls", "clear", "apart", "alone", "near", "low", "way",
                                        "permitted", "gap", "fresh"}) {
        compare(std::string(robot) + monitor, row, exact[row], found[row], trace.whole[row]);
        if (HasFailure()) return;
      }
    }
    for (const char* const monitor : plain) {
      compare(monitor, row, exact[row], found[row], trace.whole[row]);
      if (HasFailure()) return;
    }
  }
  for (const char* const verdict : {" true", " false"}) {
    for (const char* const monitor :
         {"walls", "clear", "apart", "alone", "near", "low", "permitted", "gap", "fresh"}) {
      EXPECT_GT(decided_[std::string("q1.") + monitor + verdict], 20) << monitor << verdict;
    }
    for (const char* const monitor : plain) {
      EXPECT_GT(decided_[std::string(monitor) + verdict], 20) << monitor << verdict;
    }
  }
}

}  // namespace
}  // namespace rtac::differential
