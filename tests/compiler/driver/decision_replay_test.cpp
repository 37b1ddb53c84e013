// `rtac replay` of decisions: the generated kernel judges what robots are recorded to have sensed.
#include <cstdlib>
#include <sstream>

#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {
namespace {

const char* const header =
    "time,d1.position.x,d1.position.y,d1.velocity.x,d1.velocity.y,d1.plan,d1.plan.index\n";

class ReplayDecision : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    write("fence.rta", drone_spec());
  }
  static Outcome replay(const std::string& rows, std::vector<std::string> more = {}) {
    write("trace.csv", header + rows);
    more.insert(more.begin(), {"replay", "fence.rta", "trace.csv"});
    return rtac(more);
  }
  // `tick`, `time` and the verdicts of a table of findings.
  static std::string shared_columns(const std::string& table) {
    std::istringstream in(table);
    std::string line, shared;
    std::vector<bool> wanted;
    while (std::getline(in, line)) {
      std::istringstream cells(line);
      std::string cell;
      const bool names = wanted.empty();
      for (std::size_t i = 0; std::getline(cells, cell, ','); ++i) {
        if (names) {
          wanted.push_back(i < 2 ||
                           (cell.size() > 8 && cell.substr(cell.size() - 8) == ".verdict"));
        }
        if (wanted[i]) shared += cell + ",";
      }
      shared += "\n";
    }
    return shared;
  }
  // Findings without the line of names.
  static std::string found(const std::string& rows) {
    const Outcome o = replay(rows);
    EXPECT_EQ(o.err, "");
    return o.out.substr(o.out.find('\n') + 1);
  }
};

// What the robot is, what is within reach, who drives and why; a false property is exit code 3.
TEST_F(ReplayDecision, FindingsOfEveryTick) {
  const Outcome o = replay(
      "0,2.5,2.5,0,0,none,\n"
      "0.05,2.5,2.5,0.5,0,3 2.5; 9 2.5,0\n"
      "0.10,4.98,2.5,0,0,none,\n");
  EXPECT_EQ(o.status, 3) << o.err;
  EXPECT_EQ(o.out,
            "tick,time,walls.verdict,walls.margin,walls.unit,walls.ahead,walls.ahead.margin,"
            "walls.ahead.unit,mode,monitor,reason\n"
            "0,0,true,2.299,m,true,2.106,m,pilot,,\n"
            "1,0.05,true,2.299,m,false,-0.302,m,back_off,walls,leg 1\n"
            "2,0.10,false,-0.181,m,false,-0.374,m,back_off,walls,violated\n");
}

TEST_F(ReplayDecision, WithoutAViolationTheExitCodeIs0) {
  EXPECT_EQ(replay("0,2.5,2.5,0,0,none,\n").status, 0);
}

// A sample counts from the time of its row on: at 100 ms it is older than the 50 ms it may be.
TEST_F(ReplayDecision, SamplesAgeFromTheirRowOn) {
  const std::string text = found("0,2.5,2.5,0,0,none,\n0.05,,,,,,\n0.1,,,,,,\n");
  EXPECT_NE(text.find("1,0.05,true,"), std::string::npos) << text;
  EXPECT_NE(text.find("2,0.1,unknown,-inf,,unknown,-inf,,back_off,walls,input: position"),
            std::string::npos)
      << text;
}

TEST_F(ReplayDecision, WhatIsNoNumberOrNeverArrivedIsUnknown) {
  EXPECT_NE(found("0,nan,2.5,0,0,none,\n").find("input: position"), std::string::npos);
  EXPECT_NE(found("0,,,,,,\n").find("0,0,unknown,-inf,,unknown,-inf,"), std::string::npos);
  EXPECT_NE(found("0,2.5,2.5,0,0,,\n").find("back_off,walls,input: plan"), std::string::npos);
}

TEST_F(ReplayDecision, APlanIsNamedByItsNextWayPoint) {
  const std::string start = "0,2.5,2.5,0,0,none,\n";
  EXPECT_NE(found(start + "0.05,2.5,2.5,0,0,3 2.5; 9 2.5; 3 2.5,\n").find("leg 1"),
            std::string::npos);
  EXPECT_EQ(found(start + "0.05,2.5,2.5,0,0,9 2.5; 3 2.5,2\n").find("back_off"), std::string::npos);
  EXPECT_NE(found(start + "0.05,2.5,2.5,0,0,3 2.5,7\n").find("input: plan"), std::string::npos);
  std::string long_plan = "3 2.5";
  for (int i = 0; i < 16; ++i) long_plan += "; 3 2.5";
  EXPECT_NE(found(start + "0.05,2.5,2.5,0,0," + long_plan + ",0\n").find("plan over capacity"),
            std::string::npos);
}

TEST_F(ReplayDecision, FaultsOfTheTraceNameLineAndColumn) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"0,2.5,2.5,0,0,3,\n", "`3` is no value of `d1.plan`\n --> trace.csv:2:15\n"},
      {"0,2.5,2.5,0,0,3 4 5,\n", "`3 4 5` is no value of `d1.plan`"},
      {"0,2.5,2.5,0,0,none,1.5\n", "`1.5` is no value of `d1.plan.index`"},
      {"0,far,2.5,0,0,none,\n", "`far` is no value of `d1.position.x`\n --> trace.csv:2:3\n"}};
  for (const auto& [rows, message] : cases) {
    const Outcome o = replay(rows);
    EXPECT_EQ(o.status, 2) << rows;
    EXPECT_EQ(o.out, "");
    EXPECT_NE(o.err.find(message), std::string::npos) << o.err;
  }
  write("short.csv", "time,d1.position.x\n0,1\n");
  const Outcome o = rtac({"replay", "fence.rta", "short.csv"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("`d1.position.y`"), std::string::npos) << o.err;
}

// The reference finds what the property is now, from the samples alone, in the same columns; it has
// no look-ahead and drives nobody.
TEST_F(ReplayDecision, TheInterpreterJudgesWhatIsNow) {
  const Outcome o = replay(
      "0,2.5,2.5,0,0,none,\n"
      "0.05,4.98,2.5,0,0,none,\n"
      "0.10,nan,2.5,0,0,none,\n"
      "0.15,4.705,2.5,0,0,none,\n"
      "0.20,,,,,,\n"
      "0.25,,,,,,\n",
      {"--engine", "interp"});
  EXPECT_EQ(o.status, 3) << o.err;
  EXPECT_EQ(o.out,
            "tick,time,walls.verdict,walls.margin,walls.unit\n"
            "0,0,true,2.3,m\n"
            "1,0.05,false,-0.18,m\n"
            "2,0.10,unknown,-inf,\n"
            "3,0.15,true,0.095,m\n"
            "4,0.20,true,0.095,m\n"
            "5,0.25,unknown,-inf,\n");
  EXPECT_EQ(replay("0,2.5,2.5,0,0,none,\n", {"--engine", "interp", "--monitor", "wall"}).status, 2);
}

// Columns carry the name of the robot, and each hears where the others are.
TEST_F(ReplayDecision, SeveralRobots) {
  write("fleet.rta",
        edited(edited(drone_spec(), "fleet d1 : Drone", "fleet d1, d2 : Drone"),
               "sense    velocity", "hears other robots max_age 50 ms;\n  sense velocity"));
  const std::string columns =
      "time,d1.position.x,d1.position.y,d1.velocity.x,d1.velocity.y,d1.plan,d1.plan.index,"
      "d2.position.x,d2.position.y,d2.velocity.x,d2.velocity.y,d2.plan,d2.plan.index\n";
  write("two.csv", columns + "0,2.5,2.5,0,0,none,,4.98,2.5,0,0,none,\n");
  const Outcome o = rtac({"replay", "fleet.rta", "two.csv"});
  EXPECT_EQ(o.status, 3) << o.err;
  EXPECT_EQ(o.out,
            "tick,time,d1.walls.verdict,d1.walls.margin,d1.walls.unit,d1.walls.ahead,"
            "d1.walls.ahead.margin,d1.walls.ahead.unit,d1.mode,d1.monitor,d1.reason,"
            "d2.walls.verdict,d2.walls.margin,d2.walls.unit,d2.walls.ahead,"
            "d2.walls.ahead.margin,d2.walls.ahead.unit,d2.mode,d2.monitor,d2.reason\n"
            "0,0,true,2.299,m,true,2.106,m,pilot,,,"
            "false,-0.181,m,false,-0.374,m,back_off,walls,violated\n");
  EXPECT_EQ(rtac({"replay", "fleet.rta", "two.csv", "--engine", "interp"}).out,
            "tick,time,d1.walls.verdict,d1.walls.margin,d1.walls.unit,"
            "d2.walls.verdict,d2.walls.margin,d2.walls.unit\n"
            "0,0,true,2.3,m,false,-0.18,m\n");
}

// Both sorts in one file: each at its own period, to the nearest tick, and what is not due keeps
// what it found. Robots without columns are left out.
TEST_F(ReplayDecision, BesideMonitorsWithoutARobot) {
  write("both.rta", drone_spec() +
                        "period 20 ms; input wind : real [m/s] max_age inf;\n"
                        "monitor calm { \"W: calm\" always wind <= 12 m/s; }\n");
  const std::string rows = "0,2.5,2.5,0,0,none,,3\n0.02,,,,,,,\n0.03,,,,,,,\n0.05,,,,,,,13\n";
  std::string names = header;
  names.insert(names.size() - 1, ",wind");
  write("both.csv", names + rows);
  const Outcome o = rtac({"replay", "both.rta", "both.csv"});
  EXPECT_EQ(o.out,
            "tick,time,calm.verdict,calm.margin,calm.unit,walls.verdict,walls.margin,walls.unit,"
            "walls.ahead,walls.ahead.margin,walls.ahead.unit,mode,monitor,reason\n"
            "0,0,true,9,m/s,true,2.299,m,true,2.106,m,pilot,,\n"
            "1,0.02,true,9,m/s,true,2.299,m,true,2.106,m,pilot,,\n"
            "1,0.03,true,9,m/s,true,2.297,m,true,2.095,m,pilot,,\n"
            "2,0.05,false,-1,m/s,true,2.297,m,true,2.095,m,pilot,,\n")
      << o.err;
  EXPECT_EQ(rtac({"replay", "both.rta", "both.csv", "--monitor", "walls"}).out.substr(0, 23),
            "tick,time,walls.verdict");
  write("wind.csv", "time,wind\n0,3\n");
  for (const std::string engine : {"kernel", "interp"}) {
    EXPECT_EQ(rtac({"replay", "both.rta", "wind.csv", "--engine", engine}).out,
              "tick,time,calm.verdict,calm.margin,calm.unit\n0,0,true,9,m/s\n");
  }
}

// ---- exit codes ---------------------------------------------------------------------------------

// 70: a compiler that lays structs out in another way shows a kernel that is not what was meant.
// What both engines can find stands in the same rows and columns, and gives the same exit code.
TEST_F(ReplayDecision, BothEnginesPrintTheSameRowsAndExitAlike) {
  write("both.rta", drone_spec() +
                        "period 30 ms; input wind : real [m/s] max_age inf;\n"
                        "monitor calm { \"W: calm\" always wind <= 12 m/s; }\n");
  std::string names = header;
  names.insert(names.size() - 1, ",wind");
  const std::string start = names + "0,2.5,2.5,0,0,none,,3\n0.02,,,,,,,\n0.04,,,,,,,\n";
  for (const auto& [row, status] :
       std::vector<std::pair<std::string, int>>{{"0.06,2.5,2.5,0,0,none,,13\n", 3},
                                                {"0.1,4.98,2.5,0,0,none,,3\n", 3},
                                                {"0.06,2.5,2.5,0,0,none,,3\n", 0}}) {
    write("both.csv", start + row);
    const Outcome kernel = rtac({"replay", "both.rta", "both.csv"});
    const Outcome interp = rtac({"replay", "both.rta", "both.csv", "--engine", "interp"});
    EXPECT_EQ(kernel.status, status) << kernel.out;
    EXPECT_EQ(interp.status, status) << interp.out;
    EXPECT_EQ(shared_columns(kernel.out), shared_columns(interp.out));
  }
}

// The sample of an array of 33 has three words of 32 bits before its numbers, which are aligned.
TEST_F(ReplayDecision, AnInternalErrorExitsWith70) {
  write(
      "door.rta",
      "spec door; period 10 ms; input open : bool[33];\nmonitor m { \"R: r\" always open[0]; }\n");
  std::string columns = "time", row = "0";
  for (int k = 0; k < 33; ++k) {
    columns += ",open." + std::to_string(k);
    row += ",1";
  }
  write("door.csv", columns + "\n" + row + "\n");
  setenv("CC", "cc -fpack-struct=1", 1);
  const Outcome o = rtac({"replay", "door.rta", "door.csv"});
  unsetenv("CC");
  EXPECT_EQ(o.status, 70);
  EXPECT_EQ(o.out, "");
  EXPECT_NE(o.err.find("internal error: the generated kernel has another layout"),
            std::string::npos)
      << o.err;
}

}  // namespace
}  // namespace rtac::driver::test
