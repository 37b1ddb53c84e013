// What a return condition asks for longer than a moment comes about where the recovery goes on as
// it asks for, and not by the past of inputs that never ends.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

std::string driving(const std::string& recovery, const std::string& when) {
  return "spec laps;\nzone room = rectangle (0 m, 0 m) to (9 m, 9 m);\n" + a_rover +
         "input permit : bool max_age 1 s;\ninput other : bool max_age 1 s;\n"
         "controller round : safe for Rover = " +
         recovery + R"( within room speed 0.3 m/s;
monitor walls for r : Rover { "R1: in" always r inside room; recover round; return when )" +
         when + R"(; }
decision go for Rover { advanced drive; period 50 ms; priority walls; }
)";
}

class Loiter : public Verify {
 protected:
  static std::string returns(const std::string& text) {
    const Outcome o = verified(text, {"--attack", "1", "-o", "certificates"});
    const Json report = Json::parse(read("certificates/verification.json"));
    for (const Json& of : report["decisions"][0]["obligations"]) {
      if (of["obligation"] == "P2b") return of["status"];
    }
    return o.out + o.err;
  }
  // What is proved of one page is denied of the other one.
  static void expect_denied(const std::string& good, const std::string& bad) {
    EXPECT_EQ(returns(good), "proved") << good;
    EXPECT_EQ(recheck_sealed_anew().status, exit_clean) << good;
    write("certificates/sources/spec.rta", bad);
    const Outcome forged = recheck_sealed_anew();
    EXPECT_EQ(forged.status, exit_violation) << bad << forged.out;
    EXPECT_NE(forged.out.find("its `return when` may not hold where the recovery has led to"),
              std::string::npos)
        << forged.out;
  }
};

// It rests between laps, and not for as long.
TEST_F(Loiter, IsSlowForAMomentAndNotForLong) {
  EXPECT_EQ(returns(driving("loiter", "r.speed <= 0.26 m/s")), "proved");
  for (const char* const when :
       {"r.speed <= 0.26 m/s for 10 min", "historically[0 s, 5 s] r.speed <= 0.26 m/s",
        "once[3 s, 3 s] r.speed <= 0.26 m/s", "(permit or r.speed <= 0.26 m/s) for 10 min"}) {
    EXPECT_EQ(returns(driving("loiter", when)), "unknown") << when;
  }
  const std::string for_long = "r.speed <= 0.26 m/s for 10 min";
  EXPECT_EQ(returns(driving("retreat", for_long)), "proved");
  expect_denied(driving("loiter", "r.speed <= 0.26 m/s"), driving("loiter", for_long));
  expect_denied(driving("retreat", for_long), driving("loiter", for_long));
}

// As fast as it drives, errors included, and for as long as is asked.
TEST_F(Loiter, IsNeverFasterThanItDrives) {
  const auto limit = [](const std::string& mps) {
    return driving("loiter", "r.speed <= " + mps + " m/s for 10 min");
  };
  EXPECT_EQ(returns(limit("0.9")), "proved");
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
  EXPECT_EQ(returns(limit("0.3")), "unknown");
}

TEST_F(Loiter, IsAsClearInEachLap) {
  const std::string page = driving("loiter", "r inside room for 10 min");
  EXPECT_EQ(returns(page), "proved");
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
}

// Once it was false, it stays so for ever.
TEST_F(Loiter, WhatAnEndlessPastDecidesDoesNotComeAgain) {
  const std::string lately = driving("retreat", "historically[0 s, 5 s] permit");
  EXPECT_EQ(returns(lately), "proved");
  for (const char* const when :
       {"historically[0 s, inf] permit", "not once[0 s, inf] permit",
        "other and historically[0 s, inf] permit", "not (once[0 s, inf] permit or other)"}) {
    EXPECT_EQ(returns(driving("retreat", when)), "unknown") << when;
  }
  for (const char* const when : {"once[0 s, inf] permit", "other or historically[0 s, inf] permit",
                                 "not (permit for 5 s)"}) {
    EXPECT_EQ(returns(driving("retreat", when)), "proved") << when;
    EXPECT_EQ(recheck_sealed_anew().status, exit_clean) << when;
  }
  expect_denied(lately, driving("retreat", "historically[0 s, inf] permit"));
}

}  // namespace
}  // namespace rtac::driver::test
