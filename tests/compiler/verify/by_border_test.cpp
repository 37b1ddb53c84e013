// A retreat within a yard drives beside the border of that alone: what lies deep inside of the yard
// is kept, though the zone of the retreat does not leave it out (templates.md, retreat).
#include <gtest/gtest.h>

#include <cstdlib>
#include <utility>

#include "tests/compiler/verify/forged.h"

namespace rtac::driver::test {
namespace {

class ByBorder : public Forged {
 protected:
  // A pond somewhere in a yard, which ranks lower.
  static std::string yard_with(const std::string& pond,
                               const std::string& yard = "rectangle (0 m, 0 m) to (30 m, 30 m)") {
    return "spec yard;\nzone yard = " + yard + ";\nzone pond = " + pond + ";\n" + a_rover +
           R"(zone dry = yard - grow(pond, 0.3 m);
site home = (15 m, 3 m);
controller in_yard : safe for Rover = retreat within yard speed 0.4 m/s;
controller off_pond : safe for Rover = retreat within dry speed 0.4 m/s;
monitor fence for r : Rover { "R1: in the yard" always r inside yard; recover in_yard; }
monitor pond_edge for r : Rover { "R2: off the pond" always distance(r, pond) >= 0.3 m; recover off_pond; }
decision d for Rover { advanced drive; period 50 ms; priority fence > pond_edge; }
)";
  }
  static std::string keeps(const std::string& text) {
    const Outcome o = verified(text, {"--format", "json", "-o", "certificates"});
    return statuses(o.out, "C", "pond_edge").front();
  }
  static constexpr const char* deep = "rectangle (12 m, 12 m) to (18 m, 18 m)";
  static constexpr const char* round = "circle (15 m, 15 m) radius 3 m";

  Json& claim() { return claim_of("C", "pond_edge", "by_border"); }
  void expect_noticed_with(const std::string& key, const Json& value,
                           const std::string& why = "by_border") {
    expect_changed(claim(), key, value, why);
  }
};

TEST_F(ByBorder, KeepsWhatLiesDeepInItsZone) {
  ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  for (const char* const pond : {deep, round}) {
    prove(yard_with(pond));
    Outcome o = rtac({"verify", "--recheck", "certificates"});
    EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
    o = rtac({"sim", "spec.rta", "--runs", "200"});
    EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  }
}
// Wherever the fence lets its retreat go, the pond is far: they take no turns for ever.
TEST_F(ByBorder, TakesNoTurns) {
  const auto switches = [](const std::string& text) {
    const Outcome o = verified(text, {"--format", "json", "-o", "certificates"});
    EXPECT_EQ(statuses(o.out, "C", "pond_edge").front(), "proved") << o.out;
    return statuses(o.out, "switching", "").front();
  };
  EXPECT_EQ(switches(yard_with(deep)), "proved");
  // where the brake ends it may be near the pond
  EXPECT_EQ(switches(yard_with("rectangle (4 m, 4 m) to (26 m, 26 m)")), "unknown");
  // inputs have it drive from anywhere
  const std::string told = edited(
      edited(yard_with(deep), "monitor fence",
             "input lost : bool max_age 1 s;\n"
             "monitor found for r : Rover { \"R3: heard\" always not lost; recover in_yard; }\n"
             "monitor fence"),
      "priority fence", "priority found > fence");
  EXPECT_EQ(switches(told), "unknown");
}
// An aisle beside the yard, from which no leg leads straight to where control is given back.
TEST_F(ByBorder, AlongAWayOverCells) {
  const std::string yard =
      "rectangle (0 m, 0 m) to (60 m, 60 m) | rectangle (-4 m, 0 m) to (0 m, 2.5 m)";
  prove(yard_with("rectangle (29 m, 29 m) to (31 m, 31 m)", yard));
  const Outcome o = rtac({"verify", "--recheck", "certificates"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}
// A slanting plot with sharp corners, out of which no short leg leads.
TEST_F(ByBorder, OutOfSharpCorners) {
  prove(yard_with(deep,
                  "polygon [(0 m, 0 m), (60 m, 3 m), (38 m, 15 m), (34 m, 40 m), (2 m, 32 m)]"));
  const Outcome o = rtac({"verify", "--recheck", "certificates"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}
TEST_F(ByBorder, AfterABrakeAndForSeveralMonitors) {
  const std::string both =
      edited(edited(yard_with(deep), "= retreat within yard",
                    "= sequence brake_and_hold for 2 s then retreat within yard"),
             "decision d",
             "monitor hedge for r : Rover { \"R3: off the hedge\" always clearance(r, yard) >= 50 "
             "cm; recover in_yard; }\ndecision d");
  prove(edited(both, "priority fence > pond_edge", "priority fence > hedge > pond_edge"));
  const Outcome o = rtac({"verify", "--recheck", "certificates"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}
TEST_F(ByBorder, NotWhatLiesByTheBorder) {
  EXPECT_NE(keeps(yard_with("rectangle (1 m, 1 m) to (9 m, 9 m)")), "proved");
}
TEST_F(ByBorder, NotWhereOthersStandInItsWay) {
  EXPECT_NE(keeps(edited(yard_with(deep), "fleet r1 :", "fleet r1, r2 :")), "proved");
}
TEST_F(ByBorder, NotARouteOrLaps) {
  const std::string retreat = "retreat within yard", text = yard_with(deep);
  EXPECT_NE(keeps(edited(text, retreat, "route to home within yard")), "proved");
  EXPECT_NE(keeps(edited(text, retreat, "loiter within yard")), "proved");
}
// Who may break what keeps the robot in the yard may have it led in from anywhere.
TEST_F(ByBorder, NotWhereItMayBeOutside) {
  const std::string accepts =
      "priority fence > pond_edge; acknowledge off_pond may break fence \"seldom\";";
  EXPECT_NE(keeps(edited(yard_with(deep), "priority fence > pond_edge;", accepts)), "proved");
}
// What is asked for beyond that has the robot led deeper.
TEST_F(ByBorder, NotWhereItIsLedDeeperToReturn) {
  const std::string asks = "recover in_yard; return when clearance(r, yard) >= 9 m;";
  EXPECT_NE(keeps(edited(yard_with(deep), "recover in_yard;", asks)), "proved");
}
TEST_F(ByBorder, AForgedClaimIsNoticed) {
  prove(yard_with(deep));
  for (const char* const key : {"near_mm", "return_mm", "aim_mm", "route_mm"}) {
    const std::string text = claim()[key];
    expect_noticed_with(key, std::to_string(std::stoll(text) * 8 / 10));
  }
  expect_noticed_with("starts_mm", "400");
  expect_noticed_with("near_mm", "12000");
  expect_noticed_with("zone", "dry");
  expect_noticed_with("monitor", "pond_edge");
  const char* const missing = "it rests on no claim `contained`";
  expect_noticed_with("outer", "yard", missing);
  expect_noticed_with("judged", "fence", missing);
  expect_noticed_with("standoff_mm", "299", missing);
  for (const char* const key : {"near_mm", "return_mm", "extra_us"}) {
    const Json before = claim();
    claim().erase(key);
    expect_noticed("by_border");
    claim() = before;
  }
}
// It leads to where all monitors give control back, also those that look farther ahead.
TEST_F(ByBorder, ToLessThanOthersAskForIsNoticed) {
  prove(edited(yard_with("rectangle (14 m, 14 m) to (16 m, 16 m)"), "recover off_pond;",
               "ahead 1200 ms; recover off_pond;"));
  const std::string led = claim()["return_mm"];
  ASSERT_GT(std::stoll(led), 2000);
  claim()["aim_mm"] = "560";
  expect_noticed_with("return_mm", "520", "it leads deeper before control is given back");
}
TEST_F(ByBorder, TablesThatBoundDistancesFromBelowAreNoticed) {
  prove(yard_with(deep));
  expect_noticed_with("exact_mm", "600", "farther from the boundary than the tables are exact");
}
// The page says another thing than what was proved.
TEST_F(ByBorder, AnotherPageIsNoticed) {
  prove(yard_with(deep));
  expect_noticed_in("spec.rta", "fleet r1 :", "fleet r1, r2 :", "others may stand in its way");
}
TEST_F(ByBorder, AnotherPondIsNoticed) {
  prove(yard_with(deep));
  expect_noticed_in("spec.rta", "rectangle (12 m, 12 m)", "rectangle (1 m, 1 m)",
                    "what is as near to the border is not contained");
}

}  // namespace
}  // namespace rtac::driver::test
