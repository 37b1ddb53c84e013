// A recovery that drives faster than the property of another monitor allows: nobody may take it for
// one that keeps that, also where it is acknowledged that it does not.
#include <cstdlib>
#include <map>
#include <string>

#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

// A cart that drives back for metres, at such a speed.
std::string speedy(const std::string& speed, const std::string& priority, const std::string& more) {
  return R"(spec hall;
zone hall = rectangle (0 m, 0 m) to (12 m, 8 m);
robot Cart {
  body radius 0.2 m;
  motion point { speed <= 1.5 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  output push : acceleration;
  latency 30 ms;
}
fleet c : Cart;
controller pilot : advanced for Cart extern;
controller back  : safe for Cart = retreat within hall speed )" +
         speed + R"(;
controller stop  : safe for Cart = brake_and_hold;
monitor fence for r : Cart {
  "R1: in" always r inside hall; recover back; return when clearance(r, hall) >= 3 m;
}
monitor calm for r : Cart { "R2: at most 60 cm/s" always r.speed <= 0.6 m/s; recover stop; }
decision go for Cart { advanced pilot; period 50 ms; priority )" +
         priority + "; " + more + " }\n";
}
const char* const accepted_fast = "acknowledge back may break calm \"it has to clear the way\";";

using FastRecovery = Verify;

TEST_F(FastRecovery, OneThatIsSlowEnoughIsProved) {
  const Outcome o = verified(speedy("0.5 m/s", "fence > calm", ""), {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  const Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}

TEST_F(FastRecovery, WhatIsAcknowledgedIsNotProved) {
  for (const char* order : {"fence > calm", "calm > fence"}) {
    const Outcome o = verified(speedy("0.9 m/s", order, accepted_fast), {"--format", "json"});
    EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
    EXPECT_EQ(statuses(o.out, "C", "calm"), Statuses{"acknowledged"}) << order << o.out;
  }
}

// One recovery for a call home and for the walls, past a place where the robot has to be slow: that
// it drives too fast there shows when it is called, and is told of that monitor.
class PastASchool : public Verify {
 protected:
  void SetUp() override {
    Verify::SetUp();
    ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  }
  static std::string page(const std::string& more) {
    return R"(spec street;
zone hall   = rectangle (0 m, 0 m) to (14 m, 10 m);
zone school = rectangle (5 m, 3 m) to (8 m, 7 m);
site base   = (2.55 m, 4.95 m);
input recall : bool max_age 1 s;
robot Cart {
  body radius 25 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 100 ms;
  sense velocity : vector error 2 cm/s max_age 100 ms;
  output push : acceleration;
  latency 40 ms;
}
fleet c : Cart;
controller pilot : advanced for Cart extern;
controller home  : safe for Cart = route to base within hall speed 0.8 m/s;
controller stop  : safe for Cart = brake_and_hold;
monitor called for r : Cart { "R1: home when it is called" always not recall; recover home; }
monitor walls for r : Cart { "R2: in" always r inside hall; recover home; }
monitor slow for r : Cart {
  "R3: slow beside the school" always r.speed <= 0.6 m/s or distance(r, school) >= 20 cm;
  recover stop;
}
decision go for Cart { advanced pilot; period 100 ms; priority called > walls > slow; )" +
           more + " }\n";
  }
};
TEST_F(PastASchool, WhoIsCalledHomeTooFastIsShown) {
  const Outcome o = verified(page(""), {"--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  std::map<std::string, std::string> engaged;
  const Json report = Json::parse(o.out);
  for (const Json& each : report["decisions"][0]["obligations"]) {
    if (each["obligation"] != "C" || each["monitor"] != "slow") continue;
    ASSERT_TRUE(each.contains("engaged")) << each.dump();
    ASSERT_EQ(each["engaged"].size(), 1U) << each.dump();
    engaged[each["engaged"][0]] = each["status"];
    if (each["status"] == "refuted") {
      EXPECT_TRUE(each.contains("trace")) << each.dump();
    }
  }
  const std::map<std::string, std::string> expected = {{"called", "refuted"}, {"walls", "unknown"}};
  EXPECT_EQ(engaged, expected) << o.out;
}
// One that is slow enough may lead past it: nothing is refuted for its way alone.
TEST_F(PastASchool, WhoIsSlowEnoughIsNotRefutedForItsWay) {
  std::string slow = edited(page(""), "within hall speed 0.8 m/s", "within yard speed 0.3 m/s");
  slow =
      edited(slow, "site base", "zone yard   = rectangle (0 m, 0 m) to (20 m, 10 m);\nsite base");
  slow = edited(
      slow, "monitor walls for r : Cart { \"R2: in\" always r inside hall; recover home; }\n", "");
  slow = edited(slow, "priority called > walls > slow", "priority called > slow");
  slow = edited(slow, "always r.speed <= 0.6 m/s or distance(r, school) >= 20 cm",
                "always r inside hall and (r.speed <= 0.6 m/s or distance(r, school) >= 20 cm)");
  slow = edited(slow, "safe for Cart = brake_and_hold",
                "safe for Cart = retreat within hall speed 0.4 m/s");
  const Outcome o = verified(slow, {"--format", "json"});
  for (const std::string& status : statuses(o.out, "C", "slow")) {
    EXPECT_NE(status, "refuted") << o.out;
  }
}
TEST_F(PastASchool, WhatIsAcknowledgedIsOneLine) {
  const Outcome o = verified(page("acknowledge home may break slow \"a guard walks ahead\";"),
                             {"--format", "json"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "C", "slow"), Statuses{"acknowledged"}) << o.out;
  EXPECT_EQ(o.out.find("\"engaged\""), std::string::npos) << o.out;
}

// It is stopped for its speed, stands, and drives again, for ever: that is accepted, and not shown
// to end.
TEST_F(FastRecovery, WhoIsStoppedForEverIsNoProofOfAnEnd) {
  const Outcome o = verified(speedy("0.9 m/s", "calm > fence", accepted_fast),
                             {"--format", "json", "-o", "certificates"});
  EXPECT_EQ(statuses(o.out, "switching", ""), Statuses{"acknowledged"}) << o.out << o.err;
  const Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}

// A run refutes it, on the way back from the wall.
TEST_F(FastRecovery, WhatIsRefusedIsNotProvedEither) {
  const std::string fast = speedy("0.9 m/s", "fence > calm", "");
  EXPECT_EQ(statuses(verified(fast, {"--format", "json"}).out, "C", "calm"), Statuses{"unknown"});
  ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  const Outcome o = verified(fast, {"--format", "json"});
  ::unsetenv("RTAC_SIM");
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "C", "calm"), Statuses{"refuted"}) << o.out;
}

TEST_F(FastRecovery, TheRecheckDeniesAProof) {
  ASSERT_EQ(
      verified(speedy("0.9 m/s", "fence > calm", accepted_fast), {"-o", "certificates"}).status,
      exit_clean);
  Json report = Json::parse(read("certificates/verification.json"));
  for (Json& o : report["decisions"][0]["obligations"]) {
    if (o["obligation"] != "C" || o["monitor"] != "calm") continue;
    o["status"] = "proved";
    o["claims"] = Json::array({{{"claim", "recovery"},
                                {"decision", "go"},
                                {"monitor", "fence"},
                                {"controller", "back"},
                                {"template", "retreat"}}});
  }
  write("certificates/verification.json", report.dump());
  const Outcome o = recheck_sealed_anew();
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_NE((o.out + o.err).find("`back` drives faster than `calm` allows"), std::string::npos)
      << o.out << o.err;
}

// In space it follows a hold that is carried, which wind and errors move as much as one that stays:
// by more than its velocity lags behind.
TEST_F(FastRecovery, InWindItIsAsFastAsTheHoldThatItFollows) {
  const auto calm = [](const std::string& limit) {
    return R"(spec gusts;
zone air = box (0 m, 0 m, 0 m) to (20 m, 20 m, 12 m);
robot Quad {
  body radius 30 cm;
  motion point { speed <= 3 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; disturbance <= 0.3 m/s^2; }
  sense position : point3 error 8 cm max_age 60 ms;
  sense velocity : vector3 error 6 cm/s max_age 60 ms;
  output thrust : acceleration;
  latency 30 ms;
}
fleet q : Quad;
controller pilot : advanced for Quad extern;
controller back  : safe for Quad = retreat within air speed 0.5 m/s;
controller stop  : safe for Quad = brake_and_hold;
monitor fence for r : Quad { "R1: in" always r inside air; recover back; }
monitor slow  for r : Quad { "R2: slow" always r.speed <= )" +
           limit + R"( m/s; recover stop; }
decision go for Quad { advanced pilot; period 50 ms; priority fence > slow; }
)";
  };
  ASSERT_EQ(verified(calm("1.4"), {"-o", "certificates"}).status, exit_clean);
  const Outcome agreed = recheck_sealed_anew();
  EXPECT_EQ(agreed.status, exit_clean) << agreed.out << agreed.err;
  const Outcome fast = verified(calm("0.8"), {"--format", "json"});
  EXPECT_EQ(statuses(fast.out, "C", "slow"), Statuses{"unknown"}) << fast.out;
  write("certificates/sources/spec.rta", calm("0.8"));
  const Outcome o = recheck_sealed_anew();
  EXPECT_NE((o.out + o.err).find("`back` drives faster than `slow` allows"), std::string::npos)
      << o.out << o.err;
}

}  // namespace
}  // namespace rtac::driver::test
