// What `return when` asks for beside the property: it comes about where the recovery has led, or
// the monitor stays engaged, nothing below it is looked after, and charge is spent without end.
#include <cstdlib>

#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

std::string returning(const std::string& when, const std::string& more = "",
                      const std::string& order = "fence > charge") {
  return R"(spec hall;
zone hall = rectangle (0 m, 0 m) to (14 m, 10 m);
zone east = rectangle (7 m, 0 m) to (14 m, 10 m);
)" + std::string(when == "go" ? "input go : bool max_age 1 s;" : "") +
         R"(
robot Bot {
  body radius 0.2 m;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1.2 m/s^2; }
  sense position : point error 2 cm max_age 100 ms;
  sense velocity : vector error 2 cm/s max_age 100 ms;
  sense battery : ratio error 0.5 % max_age 2 s;
  output push : acceleration;
  latency 20 ms;
  energy { drive <= 0.5 %/m; idle <= 0.01 %/s; drain <= 0.5 %/s; charge >= 1 %/s at dock; held <= 120 s; detour <= 30 m; }
}
fleet a : Bot;
site dock = (2 m, 2 m);
controller policy : advanced for Bot extern;
controller inwards : safe for Bot = retreat within hall speed 0.3 m/s;
controller go_home : safe for Bot = route to dock within hall speed 0.3 m/s;
monitor fence for r : Bot { "R1: in the hall" always r inside hall; recover inwards; return when )" +
         when + "; " + more + R"( }
monitor charge for r : Bot { "R2: home again" always r.battery >= energy_to(dock) + 5 %; recover go_home; return when r.battery >= 90 %; }
decision go_on for Bot { advanced policy; period 50 ms; priority )" +
         order + "; }\n";
}

class ReturnWhen : public Verify {
 protected:
  void SetUp() override {
    Verify::SetUp();
    ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  }
  static std::string status(const std::string& kind, const std::string& monitor) {
    const Json report = Json::parse(read("certificates/verification.json"));
    for (const Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] == kind && o.value("monitor", "") == monitor) return o["status"];
    }
    return "";
  }
  static Outcome rechecked() { return rtac({"verify", "--recheck", "certificates"}); }
};

// The recovery leads away from walls, and nowhere else: a place in the west is clear enough.
TEST_F(ReturnWhen, APlaceWhereTheRecoveryDoesNotLeadIsRefuted) {
  const Outcome o = verified(returning("r inside east for 1 s"), {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_violation) << o.out;
  EXPECT_EQ(status("P2b", "fence"), "refuted");
  EXPECT_EQ(status("C", "charge"), "refuted");
  EXPECT_NE(o.out.find("leads no further, and `return when` of `fence` does not hold there"),
            std::string::npos)
      << o.out;
  EXPECT_NE(o.err.find("`return when` of `fence` may never hold where it leads"), std::string::npos)
      << o.err;
  // and nobody takes it for a proof
  Json report = Json::parse(read("certificates/verification.json"));
  for (Json& entry : report["decisions"][0]["obligations"]) {
    if (entry["obligation"] != "P2b" || entry.value("monitor", "") != "fence") continue;
    entry["status"] = "proved";
  }
  write("certificates/verification.json", report.dump());
  EXPECT_EQ(rechecked().status, exit_violation);
}

// Nothing is charged there, so that what is missing is missing for ever.
TEST_F(ReturnWhen, AChargeThatTheRecoveryDoesNotLeadToIsNotProved) {
  const Outcome o = verified(returning("r.battery >= 50 %"), {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_violation) << o.out;
  EXPECT_EQ(status("P2b", "fence"), "unknown");
  EXPECT_EQ(status("C", "charge"), "refuted");
}

// What others do may be accepted, as it is of the distance to them.
TEST_F(ReturnWhen, ThatItMayNeverHoldIsAccepted) {
  const std::string text = returning("r.battery >= 50 %", "hold when violated \"staff\";",
                                     "fence > charge; acknowledge inwards may break charge "
                                     "\"staff\"");
  const Outcome o = verified(text, {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(status("P2b", "fence"), "acknowledged");
  EXPECT_EQ(rechecked().status, exit_clean);
}

// As clear as the recovery leads, slow, in a zone around its own, for a while; and what inputs say.
TEST_F(ReturnWhen, WhatComesAboutIsProved) {
  for (const std::string when : {"clearance(r, hall) >= 40 cm and r.speed <= 5 cm/s for 2 s",
                                 "historically[0 s, 1 s] r inside hall", "not r.speed > 5 cm/s",
                                 "r inside grow(hall, 1 m) or r.battery >= 50 %"}) {
    const Outcome o = verified(returning(when), {"-o", "certificates"});
    EXPECT_EQ(o.status, exit_clean) << when << o.out << o.err;
    const Outcome again = rechecked();
    EXPECT_EQ(again.status, exit_clean) << when << again.out << again.err;
  }
}
// They may say so for ever: the recovery waits, and takes charge meanwhile.
TEST_F(ReturnWhen, InputsLetGoAndTakeTheirTime) {
  const Outcome o = verified(returning("go"), {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_violation) << o.out;
  EXPECT_EQ(status("P2b", "fence"), "proved");
  EXPECT_EQ(status("C", "charge"), "refuted");
  const std::string order = "fence > charge; acknowledge inwards may break charge \"staff\"";
  const Outcome first = verified(returning("go", "", order), {"-o", "certificates"});
  EXPECT_EQ(first.status, exit_clean) << first.out << first.err;
  EXPECT_EQ(rechecked().status, exit_clean);
}

}  // namespace
}  // namespace rtac::driver::test
