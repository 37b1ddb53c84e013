// What a scenario may ask for besides violations: whether control is given back in time, and what
// one monitor alone comes to.
#include <cstdlib>

#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {
namespace {

class Findings : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  }
  // The drone of the golden cases, whose recovery is `recovery`.
  static Outcome simulated(const std::string& recovery, const std::string& scenario) {
    std::string text = drone_spec();
    if (!recovery.empty()) {
      text = edited(text, "controller back_off",
                    "controller stay : safe for Drone = brake_and_hold;\ncontroller back_off");
      text = edited(text, "recover back_off;", "recover " + recovery + ";");
    }
    write("spec.rta", text);
    write("s.json", scenario);
    return rtac({"sim", "spec.rta", "--scenario", "s.json", "--trace", "found.trace"});
  }
};
constexpr const char* ten_seconds =
    R"({"runs": 4, "duration_s": 40, "return_within_s": 10, "about": "walls"})";

TEST_F(Findings, WhatOnlyStandsIsNotGivenBack) {
  const Outcome o = simulated("stay; hold when violated \"a test\"", ten_seconds);
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_NE(o.out.find("not given back: "), std::string::npos) << o.out;
  const Outcome again = rtac({"sim", "spec.rta", "--replay", "found.trace"});
  EXPECT_EQ(again.status, exit_violation) << again.out << again.err;
  EXPECT_NE(again.out.find("not given back: "), std::string::npos) << again.out;
}

// What the run is about is one thing, and a property that is violated another: both are findings.
TEST_F(Findings, AViolationIsOneWhateverElseIsLookedFor) {
  write("spec.rta", drone_spec());
  write("s.json", R"({"runs": 20, "duration_s": 30, "return_within_s": 29})");
  const Outcome o = rtac({"sim", "spec.rta", "--scenario", "s.json", "--mutate",
                          "no-stopping-distance", "--trace", "found.trace"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_NE(o.out.find("violated: walls"), std::string::npos) << o.out;
}

TEST_F(Findings, WhatRetreatsIsGivenBack) {
  const Outcome o = simulated("", ten_seconds);
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_FALSE(fs::exists("found.trace"));
}

// Where legs lead straight to room, `verify` says how long they take at most; a run at bounds takes
// less, and no recovery is done at once.
TEST_F(Findings, InSpaceControlComesBackWithinWhatIsSaid) {
  const std::string folder = std::string(RTAC_SOURCE_DIR) + "/tests/campaign/specs/templates/";
  for (const char* const name : {"retreat_space", "loiter_space"}) {
    const std::string spec = folder + name + ".rta";
    const Outcome proved = rtac({"verify", spec});
    const std::string before = " m, within ";
    const std::size_t at = proved.out.find(before);
    ASSERT_NE(at, std::string::npos) << proved.out;
    const double within_s = std::stod(proved.out.substr(at + before.size()));
    const auto given_back = [&](double s) {
      write("s.json", R"({"runs": 8, "duration_s": )" + std::to_string(s + 10) +
                          R"(, "return_within_s": )" + std::to_string(s) + "}");
      return rtac({"sim", spec, "--scenario", "s.json"}).status;
    };
    EXPECT_EQ(given_back(within_s), exit_clean) << name;
    EXPECT_EQ(given_back(0.5), exit_violation) << name;
  }
}

// In the plane the hold of a stop has to settle before it sets out, slowly where positions come
// late.
TEST_F(Findings, AHoldThatSettlesSlowlyIsInWhatIsSaid) {
  write("late.rta", R"(spec late;
zone z = rectangle (0 m, 0 m) to (100 m, 100 m);
robot R {
  body radius 20 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 0 m max_age 500 ms;
  sense velocity : vector error 0 m/s max_age 20 ms;
  output o : acceleration;
  latency 400 ms;
}
fleet x : R;
controller a : advanced for R extern;
controller c : safe for R = retreat within z speed 0.4 m/s;
monitor m for r : R { "T-1: in" always r inside z; ahead 400 ms; recover c; }
decision d for R { advanced a; period 50 ms; priority m; }
)");
  const Outcome proved = rtac({"verify", "late.rta"});
  const std::size_t at = proved.out.find(" m, within ");
  ASSERT_NE(at, std::string::npos) << proved.out;
  const auto given_back = [&](double s) {
    write("s.json", R"({"runs": 60, "adversary": "lasting-errors", "duration_s": 100,
                        "return_within_s": )" +
                        std::to_string(s) + "}");
    return rtac({"sim", "late.rta", "--scenario", "s.json"}).status;
  };
  EXPECT_EQ(given_back(std::stod(proved.out.substr(at + 11))), exit_clean);
  EXPECT_EQ(given_back(24.7), exit_violation);
}

// A first tick may be late: nobody drives before, and an agent may walk up to who stands.
TEST_F(Findings, NobodyIsToBlameBeforeEverybodyHasDecided) {
  write("met.rta", R"(spec met;
zone z = rectangle (0 m, 0 m) to (20 m, 20 m);
robot R {
  body radius 20 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  output o : acceleration;
  latency 20 ms;
}
fleet x : R;
agent p[2] : radius 30 cm, speed <= 2 m/s error 10 cm max_age 100 ms;
controller a : advanced for R extern;
controller c : safe for R = brake_and_hold;
monitor m for r : R { "T-1: off" always forall u : p : distance(r, u) >= 50 cm; recover c; }
decision d for R {
  advanced a; period 200 ms; jitter 150 ms; priority m;
  acknowledge c may break m "stands";
}
)");
  write("s.json", R"({"runs": 200, "duration_s": 1, "jitter_ms": 150})");
  const Outcome o = rtac({"sim", "met.rta", "--scenario", "s.json"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}

// One monitor has no order to be turned round.
TEST_F(Findings, AMutantThatMakesNoDifferenceIsNone) {
  write("spec.rta", drone_spec());
  const Outcome o = rtac({"sim", "spec.rta", "--runs", "1", "--mutate", "lowest-priority-drives"});
  EXPECT_EQ(o.status, exit_usage) << o.out;
  EXPECT_NE(o.err.find("makes no difference to any decision here"), std::string::npos) << o.err;
}

// Decided in every period, which its look-ahead covers.
TEST_F(Findings, ASoundLookAheadLeavesNothingUndecided) {
  const Outcome o =
      simulated("", R"({"runs": 2, "duration_s": 2, "undecided": true, "about": "walls"})");
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}

// From where little is left, and without hearing anybody, a sound decision keeps what it says.
TEST_F(Findings, TightStartsOfASoundSpecificationAreSurvived) {
  const Outcome o =
      simulated("", R"({"runs": 6, "duration_s": 10, "starts": "tight", "deaf_from_s": 1})");
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}

// Whose drone is pushed out by what its look-ahead leaves out counts for the recovery that drives
// it then, and for no other one.
TEST_F(Findings, AViolationCountsForWhoDrivesIntoIt) {
  const auto driven = [](const std::string& by) {
    write("spec.rta", drone_spec());
    write("s.json", R"({"runs": 20, "duration_s": 30, "about": "walls")" + by + "}");
    return rtac({"sim", "spec.rta", "--scenario", "s.json", "--mutate", "no-stopping-distance",
                 "--trace", "found.trace"});
  };
  const Outcome own = driven(R"(, "driven_by": "back_off")");
  EXPECT_EQ(own.status, exit_violation) << own.out << own.err;
  const Outcome accepted = driven(R"(, "not_driven_by": ["back_off"])");
  EXPECT_EQ(accepted.status, exit_clean) << accepted.out << accepted.err;
  const Outcome nobody = driven(R"(, "driven_by": "nobody")");
  EXPECT_EQ(nobody.status, exit_usage) << nobody.out << nobody.err;
  EXPECT_NE(nobody.err.find("there are `back_off`"), std::string::npos) << nobody.err;
}

TEST_F(Findings, ScenariosNameMonitorsThatExist) {
  EXPECT_EQ(simulated("", R"({"about": "ceiling"})").status, exit_usage);
  EXPECT_EQ(simulated("", R"({"return_within_s": 0})").status, exit_usage);
  EXPECT_EQ(simulated("", R"({"undecided": 1})").status, exit_usage);
}

}  // namespace
}  // namespace rtac::driver::test
