// `rtac replay` of fleets: numbers of robots, who is absent, and robots by their names.
#include <set>

#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {
namespace {

const char* const quads = R"(spec quads;
zone field = rectangle (-4 m, -4 m) to (4 m, 4 m);
robot Quad {
  body   radius 10 cm;
  motion point { speed <= 0.5 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense  position : point  error 1 cm   max_age 50 ms;
  sense  velocity : vector error 1 cm/s max_age 50 ms;
  hears  other robots max_age 100 ms, present;
  output thrust : acceleration;
  latency 20 ms;
}
fleet bots : Quad[4];
controller policy  : advanced for Quad extern;
controller inwards : safe for Quad = retreat within field speed 0.2 m/s;
monitor m for r : Quad { "R1: m" always PROPERTY; recover inwards; }
decision fly for Quad {
  advanced policy; period 50 ms; priority m;
  acknowledge inwards may break m "a test";
}
)";

// One robot in the middle; the others on the axis to the right. An empty place: no message.
struct Other {
  std::string x, present;
};

class ReplayFleet : public InFolder {
 protected:
  // The verdicts of bots[0], now and ahead, one tick for each row of the other three. Both engines
  // agree on the one now.
  static std::string judged(const std::string& property,
                            const std::vector<std::vector<Other>>& rows) {
    write("spec.rta", edited(quads, "PROPERTY", property));
    std::string trace = "time";
    for (int i = 0; i < 4; ++i) {
      const std::string name = ",bots[" + std::to_string(i) + "].";
      trace += name + "position.x" + name + "position.y" + name + "velocity.x" + name +
               "velocity.y" + name + "present";
    }
    trace += "\n";
    for (std::size_t k = 0; k < rows.size(); ++k) {
      trace += std::to_string(50 * k) + "e-3,0,0,0,0,1";
      for (const Other& other : rows[k]) {
        trace += other.x.empty() ? ",,,," : "," + other.x + ",0,0,0";
        trace += "," + other.present;
      }
      trace += "\n";
    }
    write("trace.csv", trace);
    const Outcome o = rtac({"replay", "spec.rta", "trace.csv"});
    EXPECT_EQ(o.err, "");
    const Outcome exact = rtac({"replay", "spec.rta", "trace.csv", "--engine", "interp"});
    EXPECT_EQ(exact.err, "");
    EXPECT_EQ(verdicts(exact.out, {2}), verdicts(o.out, {2}));
    return verdicts(o.out, {2, 5});
  }

 private:
  // Cells of every row, by number.
  static std::string verdicts(const std::string& out, const std::set<int>& wanted) {
    std::istringstream lines(out);
    std::string all, line;
    for (std::getline(lines, line); std::getline(lines, line);) {
      std::istringstream cells(line);
      std::string cell;
      for (int i = 0; std::getline(cells, cell, ','); ++i) {
        if (wanted.count(i) > 0) all += (all.empty() ? "" : " ") + cell;
      }
    }
    return all;
  }
};

const Other far{"3", "1"}, near{"0.4", "1"}, silent{"", ""}, away{"", "0"};
const char* const at_least = "min(q : Quad, q != r : distance(r, q)) >= 30 cm";
const char* const at_most = "count(q : Quad, q != r : distance(r, q) <= 1 m) <= 1";

// A robot that is too near decides, whatever is unknown of the others; without it nothing is known.
TEST_F(ReplayFleet, AMinimumIsThatOfEveryMember) {
  EXPECT_EQ(judged(at_least, {{far, far, far}}), "true true");
  EXPECT_EQ(judged(at_least, {{far, near, silent}}), "false false");
  EXPECT_EQ(judged(at_least, {{far, far, silent}}), "unknown unknown");
}

// Sums and multiples move the limit, a negative one turns the comparison.
TEST_F(ReplayFleet, AMinimumStandsInASum) {
  const std::string nearest = "min(q : Quad, q != r : distance(r, q))";
  for (const char* const x : {"3", "0.4"}) {
    const std::vector<std::vector<Other>> rows = {{far, {x, "1"}, far}};
    const std::string due = judged(at_least, rows);
    EXPECT_EQ(judged("2 * " + nearest + " - 10 cm >= 50 cm", rows), due);
    EXPECT_EQ(judged("40 cm - " + nearest + " <= 10 cm", rows), due);
    EXPECT_EQ(judged("max(q : Quad, q != r : -distance(r, q)) <= -30 cm", rows), due);
  }
}

// The lower end of a count is who surely is near, the upper end who is not surely away.
TEST_F(ReplayFleet, ACountIsAnInterval) {
  EXPECT_EQ(judged(at_most, {{far, near, far}}), "true true");
  EXPECT_EQ(judged(at_most, {{near, near, far}}), "false false");
  EXPECT_EQ(judged(at_most, {{near, near, silent}}), "false false");
  EXPECT_EQ(judged(at_most, {{near, far, silent}}), "unknown unknown");
  EXPECT_EQ(judged(at_most, {{far, far, silent}}), "true true");
}

// Who could come near within the look-ahead counts ahead, and not now: gap 1.04 m.
TEST_F(ReplayFleet, ACountLooksAhead) {
  const Other soon{"1.24", "1"};
  EXPECT_EQ(judged(at_most, {{near, soon, far}}), "true false");
  EXPECT_EQ(judged(at_most, {{far, soon, far}}), "true true");
}

// Absence is asserted: such a robot neither fails nor counts. Silence, and a word that is too old,
// are unknown.
TEST_F(ReplayFleet, AbsenceIsAssertedNeverInferred) {
  EXPECT_EQ(judged(at_least, {{far, away, away}}), "true true");
  EXPECT_EQ(judged(at_most, {{near, away, away}}), "true true");
  EXPECT_EQ(judged(at_least, {{far, {"", "1"}, far}}), "unknown unknown");
  EXPECT_EQ(judged(at_least,
                   {{far, away, far}, {far, silent, far}, {far, silent, far}, {far, silent, far}}),
            "true true true true true true unknown unknown");
}

// A robot that is back counts again with its next message.
TEST_F(ReplayFleet, WhoIsBackIsJudgedAgain) {
  EXPECT_EQ(judged(at_least, {{far, away, far}, {far, near, far}}), "true true false false");
}

// Both engines judge robots by their names from the columns that decisions read.
TEST_F(ReplayFleet, RobotsByNameAreInputs) {
  write("both.rta", edited(quads, "PROPERTY", at_least) +
                        "period 50 ms;\nmonitor apart { \"R2: apart\" always forall a : Quad : "
                        "forall b : Quad, b != a : distance(a, b) >= 30 cm; }\n");
  write("some.csv", [] {
    std::string text = "time", row = "0";
    for (int i = 0; i < 4; ++i) {
      const std::string name = ",bots[" + std::to_string(i) + "].position.";
      text += name + "x" + name + "y";
      row += "," + std::to_string(i) + ",0";
    }
    return text + "\n" + row + "\n";
  }());
  for (const std::string engine : {"kernel", "interp"}) {
    const Outcome o =
        rtac({"replay", "both.rta", "some.csv", "--engine", engine, "--monitor", "apart"});
    EXPECT_EQ(o.out, "tick,time,apart.verdict,apart.margin,apart.unit\n0,0,true,0.48,m\n")
        << engine << o.err;
  }
}

}  // namespace
}  // namespace rtac::driver::test
