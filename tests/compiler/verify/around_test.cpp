// A retreat within a yard without its pond keeps off the pond what its property asks for, though
// the zone leaves out no more than the pond (templates.md, retreat).
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/compiler/verify/forged.h"

namespace rtac::driver::test {
namespace {

class Around : public Forged {
 protected:
  static std::string yard_with(const std::string& pond,
                               const std::string& recovery = "retreat within dry speed 0.4 m/s") {
    return "spec yard;\nzone yard = rectangle (0 m, 0 m) to (30 m, 30 m);\nzone pond = " + pond +
           ";\n" + a_rover + R"(zone dry = yard - pond;
site home = (15 m, 3 m);
controller in_yard : safe for Rover = retreat within yard speed 0.4 m/s;
controller off_pond : safe for Rover = )" +
           recovery + R"(;
monitor fence for r : Rover { "R1: in the yard" always r inside yard; recover in_yard; }
monitor pond_edge for r : Rover { "R2: off the pond" always distance(r, pond) >= 0.3 m; recover off_pond; }
decision d for Rover { advanced drive; period 50 ms; priority fence > pond_edge; }
)";
  }
  static std::string keeps(const std::string& text) {
    const Outcome o = verified(text, {"--format", "json"});
    return statuses(o.out, "P2a", "pond_edge").front();
  }
  static constexpr const char* deep = "rectangle (12 m, 12 m) to (18 m, 18 m)";
  static constexpr const char* round = "circle (15 m, 15 m) radius 3 m";

  Json& claim() { return claim_of("P2a", "pond_edge", "around"); }
  void expect_noticed_with(const std::string& key, const Json& value,
                           const std::string& why = "around") {
    expect_changed(claim(), key, value, why);
  }
};

TEST_F(Around, APondInTheMiddleOfItsZone) {
  ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  for (const char* const pond : {deep, round}) {
    prove(yard_with(pond));
    Outcome o = rtac({"verify", "--recheck", "certificates"});
    EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
    o = rtac({"sim", "spec.rta", "--runs", "200"});
    EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  }
}
TEST_F(Around, AlsoWhatAnotherMonitorAsksForAsFarOff) {
  prove(edited(edited(yard_with(deep), "decision d",
                      "controller calm : safe for Rover = retreat within far speed 0.3 m/s;\n"
                      "zone far = yard - grow(pond, 1 m);\n"
                      "monitor shore for r : Rover { \"R3: off the shore\" always distance(r, "
                      "pond) >= 0.2 m; recover calm; }\n"
                      "decision d"),
               "> pond_edge;", "> pond_edge > shore;"));
  const Outcome o = rtac({"verify", "--recheck", "certificates"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}
TEST_F(Around, NotAPondBesideAWall) {
  EXPECT_NE(keeps(yard_with("rectangle (1 m, 12 m) to (6 m, 18 m)")), "proved");
  EXPECT_NE(keeps(yard_with("rectangle (0 m, 12 m) to (6 m, 18 m)")), "proved");
  // of two ponds one is a wall to the other
  EXPECT_NE(keeps(edited(yard_with(deep), "zone dry = yard - pond",
                         "zone dry = yard - pond - rectangle (19 m, 12 m) to (20 m, 18 m)")),
            "proved");
}
TEST_F(Around, NotWhereOthersStandInItsWay) {
  EXPECT_NE(keeps(edited(yard_with(deep), "fleet r1 :", "fleet r1, r2 :")), "proved");
}
TEST_F(Around, NotARouteOrLaps) {
  EXPECT_NE(keeps(yard_with(deep, "route to home within dry speed 0.4 m/s")), "proved");
  EXPECT_NE(keeps(yard_with(deep, "loiter within dry speed 0.4 m/s")), "proved");
}
TEST_F(Around, AForgedClaimIsNoticed) {
  prove(yard_with(deep));
  for (const char* const key : {"return_mm", "aim_mm", "route_mm"}) {
    const std::string text = claim()[key];
    expect_noticed_with(key, std::to_string(std::stoll(text) * 95 / 100));
  }
  expect_noticed_with("starts_mm", "400");
  expect_noticed_with("standoff_mm", "301", "its property does not ask for so much");
  expect_noticed_with("exact_mm", "600", "farther from the boundary than the tables are exact");
  const char* const missing = "nothing says that `off_pond` keeps so far";
  expect_noticed_with("standoff_mm", "299", missing);
  expect_noticed_with("monitor", "fence", missing);
  expect_noticed_with("outer", "yard", missing);
  expect_noticed_with("zone", "yard", missing);
}
TEST_F(Around, AnotherPageIsNoticed) {
  prove(yard_with(deep));
  expect_noticed_in("spec.rta", "rectangle (12 m, 12 m)", "rectangle (2.1 m, 12 m)",
                    "from beside another wall its way may lead nearer");
}

}  // namespace
}  // namespace rtac::driver::test
