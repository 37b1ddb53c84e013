// A retreat within a zone that another property holds the robot deep inside of has nowhere to go
// (templates.md): it brakes, holds its place, and breaks nothing.
#include <gtest/gtest.h>

#include <cstdlib>

#include "testing.h"

namespace rtac::driver::test {
namespace {

class StaysPut : public Verify {
 protected:
  // A fence around a place of work, which ranks lower.
  static std::string nested(const std::string& work, const std::string& recovery,
                            const std::string& keeps = "r inside work") {
    return "spec nested;\n"
           "zone yard = rectangle (0 m, 0 m) to (30 m, 30 m);\n"
           "zone work = " +
           work + ";\n" + a_rover + R"(site home = (15 m, 15 m);
controller in_yard : safe for Rover = )" +
           recovery + R"(;
controller in_work : safe for Rover = retreat within work speed 0.4 m/s;
monitor fence for r : Rover { "R1: in the yard" always r inside yard; recover in_yard; }
monitor keep for r : Rover { "R2: at work" always )" +
           keeps + R"(; recover in_work; }
decision d for Rover { advanced drive; period 50 ms; priority fence > keep; }
)";
  }
  static std::string breaks(const std::string& text) {
    const Outcome o = verified(text, {"--format", "json", "-o", "certificates"});
    return statuses(o.out, "C", "keep").front();
  }
  static constexpr const char* deep = "rectangle (10 m, 10 m) to (20 m, 20 m)";
  static constexpr const char* retreat = "retreat within yard speed 0.4 m/s";
};

TEST_F(StaysPut, ARetreatThatIsDeepInItsZoneKeepsWhatHoldsItThere) {
  ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  ASSERT_EQ(breaks(nested(deep, retreat)), "proved");
  Outcome o = rtac({"verify", "--recheck", "certificates"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  o = rtac({"sim", "spec.rta", "--runs", "200"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}
// What the property asks for besides is kept as well: it does not move.
TEST_F(StaysPut, WithAPillarInTheMiddle) {
  const std::string around =
      "r inside work and clearance(r, complement(circle (15 m, 12 m) "
      "radius 50 cm)) >= 30 cm";
  EXPECT_EQ(breaks(nested(deep, retreat, around)), "proved");
}
TEST_F(StaysPut, NotWhereItMayBeLedAway) {
  EXPECT_NE(breaks(nested("rectangle (0.5 m, 10 m) to (20 m, 20 m)", retreat)), "proved");
  EXPECT_NE(breaks(nested(deep, "route to home within yard speed 0.4 m/s")), "proved");
  std::string asks = nested(deep, retreat);
  asks =
      edited(asks, "recover in_yard;", "recover in_yard; return when clearance(r, yard) >= 12 m;");
  EXPECT_NE(breaks(asks), "proved");
}
TEST_F(StaysPut, AMutatedCertificateIsNoticed) {
  ASSERT_EQ(breaks(nested(deep, retreat)), "proved");
  Json report = Json::parse(read("certificates/verification.json"));
  int found = 0;
  for (Json& o : report["decisions"][0]["obligations"]) {
    if (!o.contains("claims")) continue;
    for (Json& claim : o["claims"]) {
      if (claim.value("outer", "") != "yard" || !claim.contains("standoff_mm")) continue;
      ++found;
      claim["standoff_mm"] = "400";
    }
  }
  EXPECT_EQ(found, 1);
  write("certificates/verification.json", report.dump());
  EXPECT_EQ(recheck_sealed_anew().status, exit_violation);
}

}  // namespace
}  // namespace rtac::driver::test
