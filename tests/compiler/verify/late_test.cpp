// Commands that act later than their decision has looked ahead: whatever else is wrong, that is no
// proof of P1a, and a certificate that says so is noticed.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

class Late : public Verify {
 protected:
  static std::string page(const std::string& side, const std::string& latency) {
    return R"(spec late;
zone yard = rectangle (0 m, 0 m) to ()" +
           side + ", " + side + R"();
robot Cart {
  body     radius 20 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 2 cm    max_age 100 ms;
  sense    velocity : vector  error 2 cm/s  max_age 100 ms;
  output   push : acceleration;
  latency  )" +
           latency + R"(;
}
fleet c : Cart;
controller any  : advanced for Cart extern;
controller back : safe for Cart = retreat within yard speed 0.4 m/s;
monitor fence for r : Cart { "R1: in" always r inside yard; ahead 100 ms; recover back; }
decision go for Cart { advanced any; period 100 ms; priority fence; }
)";
  }
};

// Also where no look-ahead that covers the latency leaves a place to return to, which is another
// fault.
TEST_F(Late, CommandsAreNoProof) {
  for (const char* side : {"20 m", "2.6 m"}) {
    const Outcome o = verified(page(side, "300 ms"), {"--format", "json"});
    EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
    EXPECT_EQ(statuses(o.out, "P1a", "fence"), Statuses{"refuted"}) << side << o.out;
  }
  const Outcome o = verified(page("20 m", "100 ms"), {"--format", "json"});
  EXPECT_EQ(statuses(o.out, "P1a", "fence"), Statuses{"proved"}) << o.out;
}

TEST_F(Late, CommandsAreNoticedInACertificate) {
  const Outcome proved = verified(page("20 m", "100 ms"), {"-o", "certificates"});
  ASSERT_EQ(proved.status, exit_clean) << proved.out << proved.err;
  write("certificates/sources/spec.rta", page("20 m", "300 ms"));
  Json report = Json::parse(read("certificates/verification.json"));
  for (Json& o : report["decisions"][0]["obligations"]) {
    for (Json& claim : o["claims"]) {
      if (claim["claim"] == "horizon") claim["horizon_us"] = "410000";
    }
  }
  write("certificates/verification.json", report.dump());
  const Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_violation) << again.out;
  EXPECT_NE(again.out.find("a command acts later than the look-ahead lasts"), std::string::npos)
      << again.out;
}

}  // namespace
}  // namespace rtac::driver::test
