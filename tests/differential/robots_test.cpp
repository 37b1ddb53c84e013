// Monitors of robots on random traces: what the kernel finds of a property now against what it is
// on exact numbers. Samples are missing, late, no numbers, off the grid and beyond their ranges.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/compiler/driver/testing.h"
#include "tests/differential/fleet_trace.h"

namespace rtac::differential {
namespace {

using driver::test::Outcome;
using driver::test::rtac;

const std::string flock =
    R"(spec flock;
zone field = rectangle (-4 m, -4 m) to (4 m, 4 m) - circle (5.0004 m, 5 m) radius 3 m;  // no way to the nest leads across
zone core = circle (-1 m, -1 m) radius 2 m;
enum Mode { idle, busy }
input permit : bool max_age 100 ms;
input load : real in 0 .. 10 error 0.5;
input mode : Mode;
param h : length in 0 m .. 0.3 m = 0.1 m;
)" + std::string(quads) +
    R"(controller go_home : safe for Quad = route to home within field speed 0.2 m/s;
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
monitor spare { "R12: who is in has some room" always forall q : Quad : q inside core implies clearance(q, field) >= 1.5 m; }
monitor beside { "R13: not near the core" always distance(q2, core) > 10 cm; }
monitor out { "R14: none is out" always not exists q : Quad : not q inside field; }
decision fly for Quad { advanced policy; period 50 ms; priority walls > clear > apart > alone > near > low > way > permitted > gap > fresh;
  acknowledge inwards may break alone "a test"; acknowledge inwards may break near "a test";
  acknowledge inwards may break low "a test"; acknowledge go_home may break low "test"; acknowledge inwards may break way "a test"; acknowledge go_home may break way "a test"; }
)";

class RobotsNow : public driver::test::InFolder {
 protected:
  using Row = FindingRow;
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
  const FleetTrace trace = FleetTracer(1).trace(3000);
  driver::test::write("flock.rta", flock);
  driver::test::write("trace.csv", trace.text);
  const Outcome kernel = rtac({"replay", "flock.rta", "trace.csv"});
  const Outcome reference = rtac({"replay", "flock.rta", "trace.csv", "--engine", "interp"});
  ASSERT_EQ(kernel.err + reference.err, "");
  FindingTable found = finding_table(kernel.out), exact = finding_table(reference.out);
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
