// Over a tower there is too little air for control to be given back, and nothing leads straight
// down from there: a run shows it, and how much air would do is said.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

std::string plot_up_to(const std::string& top) {
  return "spec inspection;\n"
         "zone plot  = prism (rectangle (0 m, 0 m) to (80 m, 60 m)) from 2 m to " +
         top + R"(;
zone tower = prism (rectangle (36 m, 26 m) to (44 m, 34 m)) from 0 m to 35 m;
zone free  = plot - tower;
robot Quad {
  body radius 40 cm;
  motion point { speed <= 5 m/s; accel <= 3 m/s^2; brake >= 3 m/s^2; }
  sense position : point3 error 10 cm max_age 50 ms;
  sense velocity : vector3 error 10 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 30 ms;
}
fleet q : Quad;
controller policy : advanced for Quad extern;
controller back   : safe for Quad = retreat within free speed 1 m/s;
monitor fence for r : Quad { "SR-1: off the tower" always r inside free; ahead 200 ms; recover back; }
decision fly for Quad { advanced policy; period 50 ms; priority fence; }
)";
}

class LowSlab : public Verify {
 protected:
  void SetUp() override {
    Verify::SetUp();
    ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  }
};

TEST_F(LowSlab, OverATowerNothingLeadsBack) {
  const Outcome o = verified(plot_up_to("38 m"), {"--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "P2b", "fence"), Statuses{"refuted"}) << o.out;
  EXPECT_NE(o.out.find("between 35 m and 38 m `free` is 3 m high"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("4.679 m between the two would be high enough there"), std::string::npos);
  EXPECT_EQ(rtac({"sim", "spec.rta", "--replay", "spec.trace"}).status, exit_violation);
}
TEST_F(LowSlab, WithAsMuchAirAsIsAskedForTheyDo) {
  const Outcome high = verified(plot_up_to("39.679 m"), {"-o", "shown"});
  EXPECT_EQ(high.status, exit_clean) << high.out << high.err;
  EXPECT_EQ(rtac({"verify", "--recheck", "shown"}).status, exit_clean);
  const Outcome low = verified(plot_up_to("39.678 m"), {"--format", "json"});
  EXPECT_NE(statuses(low.out, "P2b", "fence"), Statuses{"proved"}) << low.out;
}

}  // namespace
}  // namespace rtac::driver::test
