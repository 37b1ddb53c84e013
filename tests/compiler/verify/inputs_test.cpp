// What inputs can make of a property: whether it can be seen to hold, and whether it can be false.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

class OfInputs : public Verify {
 protected:
  static std::string page(const std::string& property) {
    return R"(spec square;
zone yard = rectangle (0 m, 0 m) to (16 m, 10 m);
input load  : real [kg] in 0 .. 100 kg error 1 kg max_age 1 s;
input tilt  : real in 0 .. 30 max_age 1 s;
input count : int in 0 .. 9 max_age 1 s;
input door  : bool max_age 1 s;
enum Mode { idle, haul, lift }
input mode  : Mode max_age 1 s;
param most  : int in 2 .. 4 = 3;
)" + a_rover +
           R"(controller back : safe for Rover = retreat within yard speed 0.3 m/s;
monitor fence for r : Rover { "SR-1: in" always r inside yard; recover back; }
monitor tip for r : Rover { "SR-2" always )" +
           property + R"(; recover back; }
decision go for Rover { advanced drive; period 100 ms; priority fence > tip; }
)";
  }
};

TEST_F(OfInputs, APropertyThatIsNeverSeenToHoldIsRefused) {
  for (const char* property :
       {"r inside yard and tilt <= 10 and tilt >= 12", "r inside yard and load >= 120 kg",
        "load >= 120 kg", "r inside yard and door and not door",
        "r inside yard and load <= 0.5 kg",  // its error is 1 kg
        "r inside yard and load >= 50 kg and load <= 51 kg", "mode == lift and mode == idle",
        "count >= 5 and count < most", "tilt * tilt < -1",
        "(door iff not door) and r inside yard"}) {
    const Outcome o = verified(page(property), {"--format", "json", "-o", "certificates"});
    EXPECT_EQ(o.status, exit_violation) << property << o.out << o.err;
    EXPECT_EQ(statuses(o.out, "satisfiable", "tip"), Statuses{"refuted"}) << property;
    EXPECT_EQ(statuses(o.out, "P2b", "tip"), Statuses{"refuted"}) << property;
    const Outcome checked = rtac({"check", "spec.rta"});
    EXPECT_EQ(checked.status, exit_spec_errors) << property;
    EXPECT_NE(checked.err.find("5007"), std::string::npos) << property << checked.err;
  }
}

TEST_F(OfInputs, OneThatCanBeSeenIsProvedWithThem) {
  for (const char* property :
       {"r inside yard and load <= 50 kg", "r inside yard and load >= 50 kg and load <= 53 kg",
        "not door or r inside yard", "r inside yard and count <= most", "mode == lift",
        "r inside yard and tilt * tilt + count >= 800", "r inside yard and once[0 s, 2 s] door",
        "r inside yard and max(tilt, 2 * tilt) <= 7"}) {
    const Outcome o = verified(page(property), {"--format", "json", "-o", "certificates"});
    EXPECT_EQ(statuses(o.out, "satisfiable", "tip"), Statuses{"proved"}) << property << o.err;
    EXPECT_EQ(statuses(o.out, "not vacuous", "tip"), Statuses{"proved"}) << property;
    const Outcome again = recheck_sealed_anew();
    EXPECT_EQ(again.out.find("not proved:"), std::string::npos) << property << again.out;
  }
}

TEST_F(OfInputs, WhatIsNeverFalseFindsNothing) {
  for (const char* property : {"r.speed <= 0.5 m/s or tilt * tilt >= 0", "tilt <= 20 or tilt >= 10",
                               "door or not door", "r inside yard or count <= 9"}) {
    const Outcome o = verified(page(property), {"--format", "json"});
    EXPECT_EQ(statuses(o.out, "not vacuous", "tip"), Statuses{"refuted"}) << property << o.out;
  }
  // at the corner of all that they may be
  const Outcome o = verified(page("tilt * tilt + count * count < 970 or r.speed <= 0.5 m/s"),
                             {"--format", "json"});
  EXPECT_EQ(statuses(o.out, "not vacuous", "tip"), Statuses{"proved"}) << o.out;
}

// The past is of what inputs may have been: what they never are has never been so.
TEST_F(OfInputs, ThePastIsOfWhatTheyMayBe) {
  for (const char* property :
       {"historically[0 s, 2 s] (load >= -2 kg)", "historically[1 s, 2 s] (load >= -2 kg)",
        "once[0 s, 2 s] (tilt <= 30)", "not previously (count > 9)"}) {
    const Outcome o = verified(page(property), {"--format", "json"});
    EXPECT_EQ(statuses(o.out, "not vacuous", "tip"), Statuses{"refuted"}) << property;
  }
  for (const char* property :
       {"historically[0 s, 2 s] (mode == idle or load >= 5 kg)",
        "historically[1 s, 2 s] (mode == idle or load >= 5 kg)", "once[1 s, 2 s] (tilt <= 20)",
        "not previously (count > 8)", "door for 2 s"}) {
    const Outcome o = verified(page(property), {"--format", "json", "-o", "certificates"});
    EXPECT_EQ(statuses(o.out, "satisfiable", "tip"), Statuses{"proved"}) << property << o.err;
    EXPECT_EQ(statuses(o.out, "not vacuous", "tip"), Statuses{"proved"}) << property;
    const Outcome again = recheck_sealed_anew();
    EXPECT_EQ(again.out.find("not proved:"), std::string::npos) << property << again.out;
  }
}

TEST_F(OfInputs, OthersInACertificateAreNoticed) {
  const Outcome o = verified(page("r inside yard and load <= 50 kg and (door or mode == lift)"),
                             {"--format", "json", "-o", "certificates"});
  const std::string report = read("certificates/verification.json");
  const auto with = [&](const std::string& value, const std::string& inputs) {
    Json changed = Json::parse(report);
    for (Json& each : changed["decisions"][0]["obligations"]) {
      for (Json& claim : each["claims"]) {
        if (claim["claim"] == "told" && claim["value"] == value) claim["inputs"] = inputs;
      }
    }
    write("certificates/verification.json", changed.dump());
    return recheck_sealed_anew();
  };
  EXPECT_EQ(with("true", "load.0=20;door.0=1;mode.0=0").status, o.status);  // as good
  for (const char* inputs :
       {"load.0=99/2;door.0=1;mode.0=0", "load.0=20;door.0=0;mode.0=1", "load.0=20;door.0=1",
        "load.0=-1;door.0=1;mode.0=0", "load.0=20;door.0=2;mode.0=0", "load.7=20;door.0=1;mode.0=0",
        "load=20;door.0=1;mode.0=0", "load.0=1/0;door.0=1;mode.0=0",
        "weight.0=20;door.0=1;mode.0=0", ""}) {
    const Outcome again = with("true", inputs);
    EXPECT_EQ(again.status, exit_violation) << inputs << again.out;
    EXPECT_NE(again.out.find("satisfiable of `tip`"), std::string::npos) << inputs << again.out;
  }
  write("certificates/verification.json", report);
  EXPECT_EQ(with("false", "load.0=20;door.0=1;mode.0=0").status,
            o.status);  // where the robot is outside
}

}  // namespace
}  // namespace rtac::driver::test
