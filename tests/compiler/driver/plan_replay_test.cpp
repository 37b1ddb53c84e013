// `rtac replay` of decisions on plans: a row with a new plan is a proposal.
#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {
namespace {

const char* const columns =
    ",d1.position.x,d1.position.y,d1.velocity.x,d1.velocity.y,d1.plan,d1.plan.index\n";

// The drone of the golden cases, with nothing but a judge of plans.
std::string planner_spec() {
  return "spec planner_study;\n" + spec_text("tests/golden/parts/drone.rta") + R"(
controller dreamer : advanced for Drone extern;
controller careful : safe for Drone extern;
monitor margin for d : Drone { "SR-1: plans keep 40 cm" always d.plan inside shrink(room, 40 cm); }
monitor pillar for d : Drone {
  "SR-2: plans go around the pillar"
  always  d.plan inside room - rectangle (2 m, 2 m) to (3 m, 3 m);
}
decision choose for Drone { advanced dreamer; safe careful; on plan; priority margin > pillar; }
)";
}

class ReplayPlans : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    write("plans.rta", planner_spec());
  }
  static Outcome replay(const std::string& trace, std::vector<std::string> more = {}) {
    write("trace.csv", trace);
    more.insert(more.begin(), {"replay", "plans.rta", "trace.csv"});
    return rtac(more);
  }
  // Findings without the line of names.
  static std::string found(const std::string& rows, const std::vector<std::string>& more = {}) {
    const Outcome o = replay("time,d1.plan,d1.plan.index\n" + rows, more);
    EXPECT_EQ(o.err, "");
    return o.out.substr(o.out.find('\n') + 1);
  }
};

// Verdict and margin of each monitor, who plans, and the first monitor that objects, with the leg.
// Rows without a new plan are not judged; `tick` counts proposals.
TEST_F(ReplayPlans, EveryNewPlanIsAProposal) {
  const Outcome o = replay(
      "time,d1.plan\n"
      "0,\n"
      "0.1,1 1; 1 4\n"
      "0.2,\n"
      "0.25,1 1; 4 1; 4.7 1\n"
      "0.7,1 1; 4 3.9\n"
      "9,none\n");
  EXPECT_EQ(o.status, 3) << o.err;
  EXPECT_EQ(o.out,
            "tick,time,margin.verdict,margin.margin,margin.unit,"
            "pillar.verdict,pillar.margin,pillar.unit,mode,monitor,reason\n"
            "0,0.1,true,0.598,m,true,0.998,m,dreamer,,\n"
            "1,0.25,false,-0.002,m,true,0.298,m,careful,margin,leg 2\n"
            "2,0.7,true,0.598,m,false,-0.002,m,careful,pillar,leg 1\n"
            "3,9,true,inf,,true,inf,,dreamer,,\n");
}

// The reference finds the same verdicts, and exact margins.
TEST_F(ReplayPlans, TheInterpreterJudgesPlans) {
  const Outcome o = replay(
      "time,d1.plan\n"
      "0.1,1 1; 1 4\n"
      "0.25,1 1; 4 1; 4.7 1\n"
      "0.7,1 1; 4 3.9\n"
      "0.8,-1 1\n"
      "9,none\n",
      {"--engine", "interp"});
  EXPECT_EQ(o.status, 3) << o.err;
  EXPECT_EQ(o.out,
            "tick,time,margin.verdict,margin.margin,margin.unit,"
            "pillar.verdict,pillar.margin,pillar.unit\n"
            "0,0.1,true,0.6,m,true,1,m\n"
            "1,0.25,false,0,m,true,0.3,m\n"
            "2,0.7,true,0.6,m,false,0,m\n"
            "3,0.8,false,-1.4,m,false,-1,m\n"
            "4,9,true,inf,,true,inf,\n");
}

// A plan that cannot be read is proposed all the same, and is not admissible.
TEST_F(ReplayPlans, WhatIsNoPlanIsUnknown) {
  std::string long_plan = "1 1";
  for (int i = 0; i < 16; ++i) long_plan += "; 1 1";
  const std::vector<std::pair<std::string, std::string>> cases = {{"nan,", "input: plan"},
                                                                  {"1 1; 1 2,3", "input: plan"},
                                                                  {"1 1,-1", "input: plan"},
                                                                  {"1 1,nan", "input: plan"},
                                                                  {long_plan + ",", "capacity"}};
  for (const auto& [cells, reason] : cases) {
    const std::string kernel = found("0," + cells + "\n");
    EXPECT_EQ(kernel.find("0,0,unknown,-inf,,unknown,-inf,,careful,margin,"), 0) << kernel;
    EXPECT_NE(kernel.find(reason), std::string::npos) << kernel;
    EXPECT_EQ(found("0," + cells + "\n", {"--engine", "interp"}),
              "0,0,unknown,-inf,,unknown,-inf,\n");
  }
}

// An index that moves on proposes nothing; a new plan starts at its first way-point, which matters
// only where the index is none of its own.
TEST_F(ReplayPlans, TheIndexIsThatOfThePlanInItsRow) {
  for (const std::string engine : {"kernel", "interp"}) {
    const std::string text = found("0,1 1; 1 2,\n0.1,,2\n0.2,1 1,\n", {"--engine", engine});
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
    EXPECT_NE(text.find("\n1,0.2,true,"), std::string::npos) << text;
  }
}

// Rows in which nobody proposes anything are no run in which nothing went wrong.
TEST_F(ReplayPlans, WithoutAProposalThereAreNoFindings) {
  for (const std::string engine : {"kernel", "interp"}) {
    const Outcome o = replay("time,d1.plan\n0,\n0.1,\n", {"--engine", engine});
    EXPECT_EQ(o.status, 2) << o.err;
    EXPECT_EQ(o.out, "");
    EXPECT_NE(o.err.find("no row of the trace has a plan to judge"), std::string::npos) << o.err;
    EXPECT_EQ(replay("time,d1.plan\n0,\n0.1,none\n", {"--engine", engine}).status, 0);
  }
}

TEST_F(ReplayPlans, OneMonitorCanBeAskedFor) {
  const Outcome o = replay("time,d1.plan\n0,1 1\n", {"--monitor", "pillar"});
  EXPECT_EQ(o.out,
            "tick,time,pillar.verdict,pillar.margin,pillar.unit,mode,monitor,reason\n"
            "0,0,true,0.998,m,dreamer,,\n")
      << o.err;
  EXPECT_EQ(o.status, 0);
}

// Who drives and who plans, in one table: both at their own time. Before the first plan there is
// nothing to say of plans, and later what was found last.
TEST_F(ReplayPlans, BesideADecisionWithAPeriod) {
  write("plans.rta", planner_spec() + R"(
monitor walls for d : Drone {
  "SR-3: clear of the walls"
  always  clearance(d, room) >= 10 cm;
  recover back_off;
}
decision fly for Drone { advanced pilot; period 50 ms; priority walls; }
)");
  const std::string rows =
      "0,2.5,2.5,0,0,,\n"
      "0.02,,,,,1 1; 4 1,\n"
      "0.05,2.5,2.5,0,0,,1\n";
  const Outcome o = replay(std::string("time") + columns + rows, {"--monitor", "margin"});
  EXPECT_EQ(o.out,
            "tick,time,margin.verdict,margin.margin,margin.unit,plan.mode,plan.monitor,"
            "plan.reason\n"
            "0,0.02,true,0.598,m,dreamer,,\n")
      << o.err;
  EXPECT_EQ(replay(std::string("time") + columns + rows, {"--engine", "interp"}).out,
            "tick,time,margin.verdict,margin.margin,margin.unit,pillar.verdict,pillar.margin,"
            "pillar.unit,walls.verdict,walls.margin,walls.unit\n"
            "0,0,,,,,,,true,2.3,m\n"
            "0,0.02,true,0.6,m,true,1,m,true,2.3,m\n"
            "1,0.05,true,0.6,m,true,1,m,true,2.3,m\n");
  const std::string both = replay(std::string("time") + columns + rows).out;
  EXPECT_NE(both.find("walls.ahead.unit,mode,monitor,reason\n"), std::string::npos) << both;
  EXPECT_NE(both.find("\n0,0,,,,,,,,,,true,2.299,m,true,"), std::string::npos) << both;
  // the column of the plan is enough for the judge of plans
  EXPECT_EQ(replay("time,d1.plan\n0,1 1\n").out.find("walls"), std::string::npos);
}

// Each robot proposes for itself.
TEST_F(ReplayPlans, SeveralRobots) {
  write("plans.rta", edited(planner_spec(), "fleet d1 : Drone", "fleet d1, d2 : Drone"));
  const Outcome o = replay("time,d1.plan,d2.plan\n0,1 1,\n1,,0 0\n", {"--monitor", "pillar"});
  EXPECT_EQ(o.out,
            "tick,time,d1.pillar.verdict,d1.pillar.margin,d1.pillar.unit,d1.mode,d1.monitor,"
            "d1.reason,d2.pillar.verdict,d2.pillar.margin,d2.pillar.unit,d2.mode,d2.monitor,"
            "d2.reason\n"
            "0,0,true,0.998,m,dreamer,,,,,,,,\n"
            "1,1,true,0.998,m,dreamer,,,unknown,-0.002,m,careful,margin,leg 0\n")
      << o.err;
}

TEST_F(ReplayPlans, FaultsOfTheTraceNameLineAndColumn) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"time,d1.plan\n0,3\n", "`3` is no value of `d1.plan`\n --> trace.csv:2:3\n"},
      {"time,d1.plan.index\n0,1\n", "the column `d1.plan` is missing\n --> trace.csv:1:6\n"},
      {"time\n0\n", "the column `d1.plan` is missing\n --> trace.csv:1:1\n"},
      {"time,d1.plan,d1.plan\n0,,\n", "the column `d1.plan` is there twice\n --> trace.csv:1:14\n"},
      {"time,d1.plans\n0,\n", "no input is called `d1.plans`\n --> trace.csv:1:6\n"},
      {"time,d1.plan,d1.position.x\n0,,\n", "`d1.position.y`"},
      {"time,d1.plan,d1.plan.index\n0,1 1,first\n",
       "`first` is no value of `d1.plan.index`\n --> trace.csv:2:7\n"}};
  for (const auto& [trace, message] : cases) {
    const Outcome o = replay(trace);
    EXPECT_EQ(o.status, 2) << trace;
    EXPECT_EQ(o.out, "");
    EXPECT_NE(o.err.find(message), std::string::npos) << o.err;
  }
}

}  // namespace
}  // namespace rtac::driver::test
