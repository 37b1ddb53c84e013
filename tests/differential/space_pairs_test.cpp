// Robots in space that hear each other, on random traces: what the kernel finds of distances now
// against what they are on exact numbers. Samples are missing, late, no numbers, off the grid and
// beyond their ranges, and one axis of them alone.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <random>

#include "tests/compiler/driver/testing.h"
#include "tests/differential/fleet_trace.h"

namespace rtac::differential {
namespace {

using driver::test::Outcome;
using driver::test::rtac;

const char* const flock = R"(spec flock;
zone field = prism (rectangle (-4 m, -4 m) to (4 m, 4 m)) from -4 m to 4 m;
param h : length in 0 m .. 0.3 m = 0.1 m;
robot Quad {
  body   radius 10 cm;
  motion point { speed <= 0.5 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense  position : point3  error 1 cm   max_age 100 ms;
  sense  velocity : vector3 error 1 cm/s max_age 100 ms;
  hears  other robots max_age 150 ms, present;
  output thrust : acceleration;
  latency 20 ms;
}
fleet q1, q2, q3 : Quad;
controller policy : advanced for Quad extern;
controller stop   : safe for Quad = brake_and_hold;
monitor apart for r : Quad { "R1: apart" always forall q : Quad, q != r : distance(r, q) > 50 cm; recover stop; hold when violated "a test"; }
monitor gap for r : Quad { "R2: least" always min(q : Quad, q != r : distance(r, q)) >= 20 cm + h; recover stop; hold when violated "a test"; }
monitor alone for r : Quad { "R3: few" always count(q : Quad, q != r : distance(r, q) <= 2 m) <= 1; recover stop; }
monitor near for r : Quad { "R4: far" always exists q : Quad, q != r : distance(r, q) >= 1 m; recover stop; hold when violated "a test"; }
monitor walls for r : Quad { "R5: in" always r inside field and r.position.z <= 3.5 m; recover stop; hold when violated "a test"; }
decision fly for Quad { advanced policy; period 50 ms; priority apart > gap > alone > near > walls;
  acknowledge stop may break alone "a test"; acknowledge stop may break near "a test"; }
)";

class Tracer {
 public:
  explicit Tracer(std::uint32_t seed) : random_(seed) {}
  FleetTrace trace(int rows) {
    FleetTrace trace{"time", {}};
    for (const char* const robot : {",q1.", ",q2.", ",q3."}) {
      for (const char* const signal : {"position.x", "position.y", "position.z", "velocity.x",
                                       "velocity.y", "velocity.z", "present"}) {
        trace.text += std::string(robot) + signal;
      }
    }
    trace.text += "\n";
    int tick = 0;
    for (int row = 0; row < rows; ++row, tick += chance(12) ? 1 + int(random_() % 8) : 1) {
      const bool whole = chance(2);
      trace.text += number(0.05 * tick);
      // now and then all in a column, or close together
      const double most = chance(2) ? 4.2 : 0.8, level = chance(4) ? 0.01 : most;
      for (int robot = 0; robot < 3; ++robot) {
        trace.text += whole ? cells(level, most) + ",0,0,0,1" : any(level, most);
      }
      trace.text += "\n";
      trace.whole.push_back(whole);
    }
    return trace;
  }

 private:
  bool chance(unsigned one_in) { return random_() % one_in == 0; }
  double uniform(double most) {
    return std::uniform_real_distribution<double>(-most, most)(random_);
  }
  // To the micrometre or to the millimetre.
  std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, chance(2) ? "%.6f" : "%.3f", value);
    return text;
  }
  std::string cells(double level, double most) {
    return "," + number(uniform(level)) + "," + number(uniform(level)) + "," +
           number(chance(20) ? uniform(9) : uniform(most));
  }
  std::string any(double level, double most) {
    std::string place = chance(4) ? ",,," : cells(level, most);
    if (chance(20)) place = place.substr(0, place.rfind(',')) + ",nan";
    const std::string speed = chance(4) ? ",,," : cells(0.28, 0.28);
    return place + speed + "," + (chance(8) ? "0" : chance(2) ? "1" : "");
  }

  std::mt19937 random_;
};

class SpacePairsNow : public driver::test::InFolder {
 protected:
  void compare(const std::string& column, FindingRow& exact, FindingRow& found, bool whole) {
    SCOPED_TRACE(column + ": exact " + exact[column + ".margin"] + ", found " +
                 found[column + ".margin"]);
    const std::string verdict = found[column + ".verdict"];
    ++of_exact_[column + " " + exact[column + ".verdict"]];
    if (verdict != "unknown") {
      ++decided_[column + " " + verdict];
      EXPECT_EQ(exact[column + ".verdict"], verdict);
    }
    const std::string unit = exact[column + ".unit"];
    if (unit != found[column + ".unit"]) return;
    const double below =
        std::stod(exact[column + ".margin"]) - std::stod(found[column + ".margin"]);
    if (std::isnan(below)) return;  // both infinite
    EXPECT_GT(below, -1e-9);
    // in whole rows: 4 mm of the gap, 6 mm of positions off the grid
    if (whole && !unit.empty()) {
      EXPECT_LT(below, 0.014);
    }
  }
  std::map<std::string, int> of_exact_, decided_;
};

TEST_F(SpacePairsNow, AreJudgedConservativelyAndTightly) {
  const FleetTrace trace = Tracer(1).trace(2000);
  driver::test::write("flock.rta", flock);
  driver::test::write("trace.csv", trace.text);
  const Outcome kernel = rtac({"replay", "flock.rta", "trace.csv"});
  const Outcome reference = rtac({"replay", "flock.rta", "trace.csv", "--engine", "interp"});
  ASSERT_EQ(kernel.err + reference.err, "");
  FindingTable found = finding_table(kernel.out), exact = finding_table(reference.out);
  ASSERT_EQ(found.size(), trace.whole.size());
  ASSERT_EQ(exact.size(), trace.whole.size());
  const auto monitors = {"apart", "gap", "alone", "near", "walls"};
  for (std::size_t row = 0; row < exact.size(); ++row) {
    SCOPED_TRACE("row " + std::to_string(row));
    for (const char* const robot : {"q1.", "q2.", "q3."}) {
      for (const char* const monitor : monitors) {
        compare(std::string(robot) + monitor, exact[row], found[row], trace.whole[row]);
        if (HasFailure()) return;
      }
    }
  }
  for (const char* const verdict : {" true", " false"}) {
    for (const char* const monitor : monitors) {
      const std::string key = std::string("q1.") + monitor + verdict;
      EXPECT_GT(of_exact_[key], 40) << key;
      EXPECT_GT(decided_[key] * 4, of_exact_[key] * 3) << key;
    }
  }
}

}  // namespace
}  // namespace rtac::differential
