// What monitors say of other robots: conditions of each pair are kept by all together, others are
// refused, or acknowledged.
#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

using diag::Code;

std::string text_of(const std::string& always, const std::string& fleet = "quads : Quad[3]",
                    const std::string& more = "", const std::string& hears = "") {
  return R"(spec flock;
zone field = rectangle (-5 m, -5 m) to (5 m, 5 m);
zone bay   = rectangle (-5 m, -5 m) to (-1 m, -1 m);
robot Quad {
  body     radius 15 cm;
  motion   point { speed <= 1 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense    position : point   error 2 cm    max_age 40 ms;
  sense    velocity : vector  error 2 cm/s  max_age 40 ms;
  hears    other robots       max_age 60 ms)" +
         hears + R"(;
  output   thrust : acceleration;
  latency  20 ms;
}
fleet )" +
         fleet + R"(;
input permit : bool max_age 1 s;
controller policy  : advanced for Quad extern;
controller inwards : safe for Quad = retreat within field speed 0.3 m/s;
monitor m for r : Quad { "R1: m" always )" +
         always + R"(; recover inwards; }
decision fly for Quad { advanced policy; period 20 ms; priority m; )" +
         more + "}\n";
}
const std::string others = " q : Quad, q != r : ";

std::size_t refused(const std::string& text) {
  const auto c = compiled(text);
  std::size_t found = 0;
  for (const auto& d : c->diagnostics.all()) {
    if (diag::info(d.code).severity != diag::Severity::error) continue;  // an input may be unused
    EXPECT_EQ(d.code, Code::others_unkept) << reports(*c);
    found += d.code == Code::others_unkept ? 1 : 0;
  }
  return found;
}

// Whoever moves checks the pair, with the same result as the one that stands still.
TEST(Company, ConditionsOfEachPairAreKept) {
  for (const std::string& kept :
       {"forall" + others + "distance(r, q) >= 1 m", "min(" + others + "distance(r, q)) > 1 m",
        "(forall" + others + "distance(r, q) >= 1 m) and (r inside field or r inside bay)",
        "forall" + others + "(distance(r, q) >= 1 m or distance(r, q) >= 2 m) and permit",
        "forall" + others + "distance(r, q) >= 1 m and (permit or r inside bay)"}) {
    EXPECT_EQ(refused(text_of(kept)), 0u) << kept;
  }
}

TEST(Company, WhatAThirdRobotBreaksIsRefused) {
  for (const std::string& broken :
       {"count(" + others + "distance(r, q) <= 1 m) <= 1",
        "count(" + others + "distance(r, q) <= 1 m) < 1",
        "exists" + others + "distance(r, q) >= 1 m", "max(" + others + "distance(r, q)) >= 1 m"}) {
    EXPECT_EQ(refused(text_of(broken)), 1u) << broken;
  }
}

// The other one passes by what it has to itself.
TEST(Company, AnOrWithSomethingOfOneRobotIsRefused) {
  for (const std::string& broken : {"forall" + others + "distance(r, q) >= 1 m or r inside bay",
                                    "forall" + others + "permit implies distance(r, q) >= 1 m",
                                    "(forall" + others + "distance(r, q) >= 1 m) or permit"}) {
    EXPECT_EQ(refused(text_of(broken)), 1u) << broken;
  }
  EXPECT_EQ(refused(text_of("(exists" + others + "distance(r, q) >= 1 m) and (permit or forall" +
                            others + "distance(r, q) >= 1 m)")),
            2u);
}

// One other robot is all of them and some of them; but it may say that it is away.
TEST(Company, APairHasNoThirdRobot) {
  const std::string some = "exists" + others + "distance(r, q) >= 1 m";
  EXPECT_EQ(refused(text_of(some, "a, b : Quad")), 0u);
  EXPECT_EQ(refused(text_of(some, "a, b : Quad", "", ", present")), 1u);
  EXPECT_EQ(refused(text_of("count(" + others + "distance(r, q) <= 1 m) <= 0", "a, b : Quad")), 1u);
}

TEST(Company, AsManyAsThereAreIsNoCondition) {
  EXPECT_EQ(refused(text_of("count(" + others + "distance(r, q) <= 1 m) <= 2")), 0u);
  EXPECT_EQ(refused(text_of("count(" + others + "distance(r, q) <= 1 m) < 3")), 0u);
  EXPECT_EQ(refused(text_of("count(" + others + "distance(r, q) <= 1 m) < 2")), 1u);
}

TEST(Company, IsAcknowledgedWithAReason) {
  EXPECT_EQ(refused(text_of("count(" + others + "distance(r, q) <= 1 m) <= 1", "quads : Quad[3]",
                            "acknowledge inwards may break m \"a test\"; ")),
            0u);
}

}  // namespace
}  // namespace rtac::analysis::test
