// A condition for handing back that can never hold is refused, with the largest value that works;
// the recovery takes the robot where a condition that can hold does hold.
#include <cmath>

#include "compiler/analysis/limits.h"
#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

using diag::Code;

std::string probe() {
  return spec_text("tests/kernel/probe.rta");
}
std::string fence_returns(const std::string& condition) {
  return edited(probe(), "return  when clearance(r, floor) >= 30 cm for 1 s;",
                "return  when " + condition + ";");
}
std::string charge_returns(const std::string& condition) {
  return edited(probe(), "return  when r.battery >= 90 %;", "return  when " + condition + ";");
}
// "(x m, y m)" of the site that would do.
std::string place_offered(const driver::Compilation& c, Code code = Code::return_set_empty) {
  for (const auto& d : c.diagnostics.all()) {
    const std::size_t from = d.help.find('('), to = d.help.find(") works");
    if (d.code != code || to == std::string::npos) continue;
    return d.help.substr(from, to - from + 1);
  }
  return "";
}
bool is_refused(const std::string& text) {
  const auto c = compiled(text);
  EXPECT_EQ(has(*c, Code::return_set_empty), c->diagnostics.has_errors()) << reports(*c);
  return has(*c, Code::return_set_empty);
}

// The hall is 10 m wide with a pool in its middle: nowhere are 6 m of clearance.
TEST(ReturnCondition, AClearanceThatTheZoneDoesNotHaveIsRefusedWithTheLargestOne) {
  const auto c = compiled(fence_returns("clearance(r, floor) >= 6 m"));
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  const std::string most = number_in_help(*c, Code::return_set_empty, "a clearance of ", "m works");
  EXPECT_FALSE(is_refused(fence_returns("clearance(r, floor) >= " + most + " m")));
  const std::string more = std::to_string(std::lround(1000 * std::stod(most)) + 1);
  EXPECT_TRUE(is_refused(fence_returns("clearance(r, floor) >= " + more + " mm")));
  EXPECT_TRUE(is_refused(fence_returns("clearance(r, floor) > " + most + " m")));
}

// So is one that has to have held: for a while, once, or a tick ago.
TEST(ReturnCondition, WhatNeverHoldsHasNeverHeldEither) {
  const std::vector<std::string> looks = {"historically[0 s, 1 s] ", "once[0 s, 1 s] ",
                                          "previously "};
  for (const std::string& look : looks) {
    const auto back = [&](const std::string& asked) {
      return fence_returns("(" + look + "clearance(r, floor) >= " + asked + " m)");
    };
    const auto c = compiled(back("6"));
    ASSERT_TRUE(has(*c, Code::return_set_empty)) << look << reports(*c);
    const std::string most =
        number_in_help(*c, Code::return_set_empty, "a clearance of ", "m works");
    EXPECT_FALSE(is_refused(back(most))) << look << most;
    EXPECT_TRUE(is_refused(back(std::to_string(std::stod(most) + 0.002)))) << look << most;
    EXPECT_TRUE(is_refused(fence_returns("(" + look + "r.speed <= 1 mm/s)"))) << look;
  }
  // once it has been near, or slow and fast
  for (const char* const may :
       {"once[1 s, 2 s] clearance(r, floor) <= 10 cm",
        "once[0 s, 9 s] r.speed >= 0.4 m/s and once[0 s, 9 s] r.speed <= 0.2 m/s"}) {
    EXPECT_FALSE(is_refused(fence_returns(may))) << may;
  }
  // what a window makes one number of is not looked into
  EXPECT_FALSE(is_refused(fence_returns("mean[0 s, 1 s](clearance(r, floor)) >= 30 cm")));
}

// A recovery leads as deep as the condition asks for, whichever way it is asked to last.
TEST(ReturnCondition, WhatHasToHaveLastedIsLedToLikeWhatLasts) {
  const auto deep_mm = [](const std::string& condition) {
    const auto c = compiled(fence_returns(condition));
    EXPECT_TRUE(c->module) << condition << reports(*c);
    if (!c->module) return std::int64_t{0};
    const auto& monitors = c->module->decisions[0].monitors;
    const auto fence = std::ranges::find(monitors, "fence", &ir::Monitor::name);
    return fence == monitors.end() ? 0 : fence->recovery.return_clearance_mm;
  };
  const std::int64_t lasts_mm = deep_mm("clearance(r, floor) >= 2 m for 1 s");
  EXPECT_GT(lasts_mm, deep_mm("clearance(r, floor) >= 30 cm for 1 s"));
  EXPECT_EQ(deep_mm("historically[0 s, 1 s] clearance(r, floor) >= 2 m"), lasts_mm);
}

// A little more than there is: the number is that of the comparison, in whatever stands around it.
TEST(ReturnCondition, TheLargestClearanceIsToldOfAConditionThatHasToLast) {
  const auto plain = compiled(fence_returns("clearance(r, floor) >= 6 m"));
  const std::string most =
      number_in_help(*plain, Code::return_set_empty, "a clearance of ", "m works");
  const std::string more = std::to_string(std::lround(1000 * std::stod(most)) + 9) + " mm";
  for (const std::string& condition :
       {"clearance(r, floor) >= " + more + " for 1 s",
        "r.speed <= 1 m/s and clearance(r, floor) >= " + more + " for 1 s"}) {
    const auto c = compiled(fence_returns(condition));
    EXPECT_EQ(number_in_help(*c, Code::return_set_empty, "a clearance of ", "m works"), most)
        << condition << reports(*c);
  }
}

// Where the look-ahead lets control go back the condition is false: of a limit from above, and of a
// property that is asked to fail.
TEST(ReturnCondition, NothingIsGivenBackNearerThanTheLookAheadAllows) {
  for (const char* const never : {"clearance(r, floor) <= 10 cm", "not (r inside floor)",
                                  "clearance(r, floor) <= 10 cm and r.speed <= 1 m/s"}) {
    EXPECT_TRUE(is_refused(fence_returns(never))) << never;
  }
  for (const char* const may :
       {"clearance(r, floor) <= 2 m", "clearance(r, floor) <= 10 cm or r.speed <= 1 m/s"}) {
    EXPECT_FALSE(is_refused(fence_returns(may))) << may;
  }
}

// A room deep in another zone, which the condition is about: how deep it lies counts.
TEST(ReturnCondition, AClearanceOfAZoneAroundTheRoomOfTheRecoveryIsHadThere) {
  const auto hall = [](const std::string& room, const std::string& metres) {
    return R"(spec deep;
zone hall = rectangle (0 m, 0 m) to (20 m, 12 m);
zone room = )" +
           room + R"(;
robot Cart {
  body radius 20 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  output push : acceleration;
  latency 30 ms;
}
fleet c : Cart;
controller policy : advanced for Cart extern;
controller back : safe for Cart = retreat within room speed 0.3 m/s;
monitor fence for x : Cart { "SR-1: in" always x inside hall; recover back; return when clearance(x, hall) >= )" +
           metres + R"( m; }
decision go for Cart { advanced policy; period 50 ms; priority fence; }
)";
  };
  // all of it is deep enough, and nothing is asked of its middle
  const std::string narrow = "rectangle (6 m, 5 m) to (14 m, 7 m)";
  EXPECT_FALSE(is_refused(hall(narrow, "3")));
  const auto all = compiled(hall(narrow, "3"));
  const auto own = compiled(hall(narrow, "0"));
  EXPECT_EQ(all->module->decisions[0].monitors[0].recovery.return_clearance_mm,
            own->module->decisions[0].monitors[0].recovery.return_clearance_mm);
  // 4 m deep, and 2 m wide: from the hall its middle is 5 m off, less body and errors
  const std::string wide = "rectangle (6 m, 4 m) to (14 m, 8 m)";
  EXPECT_FALSE(is_refused(hall(wide, "5")));
  const auto c = compiled(hall(wide, "5.9"));
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  const std::string off = "rectangle (1 m, 3 m) to (7 m, 5 m)";
  const auto d = compiled(hall(off, "2.5"));
  ASSERT_TRUE(has(*d, Code::return_set_empty)) << reports(*d);
  const std::string most = number_in_help(*d, Code::return_set_empty, "a clearance of ", "m works");
  EXPECT_GT(std::stod(most), 1.6);
  EXPECT_FALSE(is_refused(hall(off, most)));
  EXPECT_TRUE(is_refused(hall(off, std::to_string(std::stod(most) + 0.02))));
}

TEST(ReturnCondition, AChargeThatABatteryNeverShowsIsRefusedWithTheLargestOne) {
  const auto c = compiled(charge_returns("r.battery >= 120 %"));
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  const std::string most = number_in_help(*c, Code::return_set_empty, "`", "%` works");
  EXPECT_LT(std::stod(most), 100);
  EXPECT_FALSE(is_refused(charge_returns("r.battery >= " + most + " %")));
  EXPECT_TRUE(is_refused(charge_returns("r.battery > " + most + " %")));
}

TEST(ReturnCondition, AChargeBeyondTheWayCountsTheWayAtTheSite) {
  const auto c = compiled(charge_returns("r.battery >= energy_to(dock(r)) + 99 %"));
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  const std::string most = number_in_help(*c, Code::return_set_empty, "`", "%` works");
  EXPECT_FALSE(is_refused(charge_returns("r.battery >= energy_to(dock(r)) + " + most + " %")));
}

// Even a full battery at the dock would not pass the look-ahead again.
TEST(ReturnCondition, APropertyThatAFullBatteryAtTheSiteFailsIsRefusedWithTheLargestReserve) {
  const std::string reserve = "energy_to(dock(r)) + 5 %";
  const auto c = compiled(edited(probe(), reserve, "energy_to(dock(r)) + 95 %"));
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  const std::string most = number_in_help(*c, Code::return_set_empty, "`", "%` works");
  EXPECT_FALSE(is_refused(edited(probe(), reserve, "energy_to(dock(r)) + " + most + " %")));
  EXPECT_TRUE(is_refused(edited(probe(), reserve, "energy_to(dock(r)) + 95 %")));
}

// `and` needs both, `or` one; a time does not change what can hold.
TEST(ReturnCondition, ConnectivesCountAsTheyAreMeant) {
  const std::string never = "clearance(r, floor) >= 6 m", fine = "clearance(r, floor) >= 30 cm";
  EXPECT_TRUE(is_refused(fence_returns(never + " for 1 s")));
  EXPECT_TRUE(is_refused(fence_returns(fine + " and " + never)));
  EXPECT_TRUE(is_refused(fence_returns(never + " or r.battery >= 120 %")));
  EXPECT_FALSE(is_refused(fence_returns(never + " or " + fine)));
}

TEST(ReturnCondition, ComparisonsThatExcludeEachOtherAreRefused) {
  const std::string near = "clearance(r, floor) <= 1 m", far = "clearance(r, floor) >= 1.5 m";
  EXPECT_TRUE(is_refused(fence_returns(near + " and " + far)));
  EXPECT_TRUE(is_refused(fence_returns(far + " for 1 s and (r.battery >= 20 % and " + near + ")")));
  EXPECT_FALSE(is_refused(fence_returns(near + " or " + far)));
  // a step apart, of the same and of different signals
  EXPECT_FALSE(is_refused(fence_returns(far + " and clearance(r, floor) <= 1.5 m")));
  EXPECT_TRUE(is_refused(fence_returns(far + " and clearance(r, floor) < 1.5 m")));
  EXPECT_FALSE(is_refused(fence_returns(far + " and clearance(r, hall) <= 1.4 m")));
}

TEST(ReturnCondition, ASpeedThatNoRobotHasIsRefused) {
  EXPECT_TRUE(is_refused(fence_returns("r.speed >= 1.001 m/s")));
  EXPECT_FALSE(is_refused(fence_returns("r.speed >= 1 m/s")));
}

// The corners of a box in space are farther apart than those of its floor; a zone of the plane has
// no corners above each other.
TEST(ReturnCondition, ADistanceInSpaceMayBeAsLongAsTheBoxAroundItsFence) {
  const std::string flock = spec_text("tests/golden/space_flock/spec.rta");
  const auto apart = [&](const std::string& distance) {
    return edited(flock, "hold    when violated",
                  "return  when forall q : Drone, q != d : distance(d, q) " + distance +
                      ";\n  hold    when violated");
  };
  const auto c = compiled(apart(">= 100 m"));
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  const std::string most =
      number_in_help(*c, Code::return_set_empty, "a distance of at most ", "m can be had");
  EXPECT_NEAR(std::stod(most), std::hypot(60, 40, 50) - 0.5, 0.0011);
  EXPECT_FALSE(is_refused(apart(">= " + most + " m")));
  EXPECT_TRUE(is_refused(apart("> " + most + " m")));
  EXPECT_FALSE(is_refused(edited(apart(">= 100 m"),
                                 "prism (rectangle (0 m, 0 m) to (60 m, 40 m)) from 0 m to 50 m",
                                 "rectangle (0 m, 0 m) to (60 m, 40 m)")));
}

// The floor is 20 m x 10 m, a cart 20 cm wide: no two are 22.2 m apart.
TEST(ReturnCondition, ADistanceThatNoTwoRobotsInTheFenceHaveIsRefusedWithTheLargestOne) {
  const auto carts_return = [](const std::string& condition) {
    return edited(
        probe(), "  recover give_way;",
        "  recover give_way;\n  return  when forall q : Cart, q != r : " + condition + ";");
  };
  const auto c = compiled(carts_return("distance(r, q) >= 30 m"));
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  const std::string most =
      number_in_help(*c, Code::return_set_empty, "a distance of at most ", "m can be had");
  EXPECT_NEAR(std::stod(most), std::hypot(20, 10) - 0.2, 0.0011);
  EXPECT_FALSE(is_refused(carts_return("distance(r, q) >= " + most + " m")));
  EXPECT_TRUE(is_refused(carts_return("distance(r, q) > " + most + " m")));
  EXPECT_TRUE(is_refused(carts_return("distance(r, q) >= 30 m or distance(r, q) > 25 m")));
  // less than the derived condition asks for adds nothing, and is no mistake
  EXPECT_FALSE(is_refused(carts_return("distance(r, q) >= 1 cm")));
}

// Robots that no monitor keeps in a zone may be anywhere.
TEST(ReturnCondition, WithoutAFenceAnyDistanceCanBeHad) {
  std::string text = edited(probe(), "  recover give_way;",
                            "  recover give_way;\n  return  when forall q : Cart, q != r : "
                            "distance(r, q) >= 30 m;");
  text = edited(text, "separation > fence > charge", "separation > charge");
  text = edited(text,
                "  acknowledge turn_back may break charge \"a test: the cart turns back and is "
                "done\";\n",
                "");
  EXPECT_FALSE(is_refused(text));
}

TEST(ReturnCondition, TheRecoveryHeadsForPlacesWhereItHolds) {
  const auto near = compiled(fence_returns("clearance(r, floor) >= 5 cm"));
  const auto far = compiled(fence_returns("clearance(r, floor) >= 1.5 m for 1 s"));
  ASSERT_TRUE(near->module && far->module) << reports(*near) << reports(*far);
  const auto heads_for = [](const driver::Compilation& c) {
    return c.module->decisions[0].monitors[1].recovery.return_clearance_mm;
  };
  EXPECT_LT(heads_for(*near), 1400);
  EXPECT_GT(heads_for(*far), 1500 + 100);  // and the body
  EXPECT_LT(heads_for(*far), 1500 + 100 + 200);
}

// theory, unequal stamps: the return condition counts the time between the stamps of position and
// velocity, so the place to head for has to as well, or control never returns.
TEST(ReturnCondition, TheRecoveryHeadsFurtherWhenStampsMayLieFurtherApart) {
  const std::string text = fence_returns("clearance(r, floor) >= 5 cm");
  const auto close = compiled(text);
  const auto apart =
      compiled(edited(text, "error 1 cm/s   max_age 150 ms;", "error 1 cm/s   max_age 400 ms;"));
  ASSERT_TRUE(close->module && apart->module) << reports(*close) << reports(*apart);
  const auto heads_for = [](const driver::Compilation& c) {
    return c.module->decisions[0].monitors[1].recovery.return_clearance_mm;
  };
  EXPECT_GT(heads_for(*apart), heads_for(*close));
}

// What it asks for itself is judged with both, too: at 1 m/s^2, 250 ms more between their stamps
// make 0.25 m/s more, for the 200 ms that the position may be old. The recovery drives at 0.2 m/s;
// who seems faster counts as such, up to 1.02 m/s.
TEST(ReturnCondition, WhatAConditionAsksForIsSeenWithUnequalStamps) {
  const std::string text = fence_returns("clearance(r, floor) >= 1.5 m");
  const auto heads_for = [&](const char* age) {
    const auto c = compiled(edited(text, "max_age 150 ms;", std::string("max_age ") + age + ";"));
    EXPECT_TRUE(c->module) << reports(*c);
    return c->module ? c->module->decisions[0].monitors[1].recovery.return_clearance_mm : 0;
  };
  const auto near_mm = heads_for("200 ms"), far_mm = heads_for("450 ms");
  // turning included, it is sqrt(1 m/s^2 ^2 + (1 m/s * 2 rad/s)^2)
  const double change_mmps = std::sqrt(5.0) * 250;
  EXPECT_NEAR(static_cast<double>(far_mm - near_mm), change_mmps * 0.2, 2);
  EXPECT_EQ(heads_for("100 ms"), near_mm);  // the position may be older
}
// Off the grid, too: the width of a sample in the plane, the corner that stands for it, what the
// kernel's gap is short of, and what the speed of that corner makes of its age.
TEST(ReturnCondition, WhatAConditionAsksForIsSeenOffTheGrid) {
  ir::Decision d;
  ir::Motion still{"", 0, 0, false, {}};
  EXPECT_EQ(shown_clearance_mm(d, still, 0), 6);
  d.body.in_space = true;
  EXPECT_EQ(shown_clearance_mm(d, still, 0), 7);
}

TEST(ReturnCondition, ABatteryWithoutADrainIsOfNoUse) {
  const std::string text = probe();
  const std::size_t at = text.find("  energy   { drive <= 0.1 %/m;");
  ASSERT_NE(at, std::string::npos);
  const std::string dry = text.substr(0, at) + text.substr(text.find('\n', at) + 1);
  EXPECT_TRUE(has(*without_offers(dry), Code::limit_missing));
}

// theory, battery: the recovery's own way is part of what a constant charge needs.
TEST(ReturnCondition, AConstantChargeIsPricedForTheRoute) {
  const auto c =
      compiled(edited(probe(), "r.battery >= energy_to(dock(r)) + 5 %;", "r.battery >= 20 %;"));
  ASSERT_TRUE(c->module) << reports(*c);
  const ir::Block& ahead = *c->module->decisions[0].monitors[2].ahead;
  ASSERT_EQ(ahead.values.size(), 1u);
  const auto* reach = std::get_if<ir::EnergyReach>(&ahead.values[0].op);
  ASSERT_TRUE(reach);
  EXPECT_EQ(reach->reserve_ppm, 200'000 + c->module->decisions[0].hold_reserve_ppm);
  EXPECT_FALSE(c->module->sites[0].places[0].cost_ppm.empty());
}

// What is false whatever the robot does gives nothing back: of a condition, and of a property.
TEST(ReturnCondition, WhatIsNeverTrueIsRefused) {
  for (const char* never : {"false", "clearance(r, floor) >= 5 cm and false", "1 m >= 2 m",
                            "false or 2 m > 2 m", "r.speed <= 0.009 m/s"}) {
    const auto c = compiled(fence_returns(never));
    EXPECT_TRUE(has(*c, Code::return_set_empty)) << never << "\n" << reports(*c);
  }
  for (const char* at_times :
       {"true", "false or clearance(r, floor) >= 5 cm", "2 m >= 2 m", "r.speed <= 0.01 m/s"}) {
    const auto c = compiled(fence_returns(at_times));
    EXPECT_TRUE(c->module) << at_times << "\n" << reports(*c);
  }
  for (const char* never : {"false", "d inside room and false", "2 cm >= 3 cm"}) {
    const std::string text = edited(edited(driver::test::drone_spec(), ", 2 waypoints", ""),
                                    "clearance(d, room) >= 10 cm", never);
    const auto c = compiled(text);
    EXPECT_TRUE(has(*c, Code::return_set_empty)) << never << "\n" << reports(*c);
  }
}

// In a hall so narrow that no site has a way from all around it, a wider one does; a little less
// does not.
TEST(ReturnCondition, AHallThatIsTooNarrowForASiteIsOfferedWider) {
  const auto text = [](const std::string& hall) {
    return "spec narrow;\nzone plain = rectangle (0 m, 0 m) to (14 m, 2.4 m);\nzone hall = " +
           hall +
           R"(;
robot Bot {
  body    radius 25 cm;
  motion  unicycle { speed <= 0.7 m/s; turn <= 2 rad/s; accel <= 0.8 m/s^2; brake >= 1 m/s^2; turn_accel <= 6 rad/s^2; }
  sense   position : point  error 2 cm     max_age 80 ms;
  sense   heading  : angle  error 1.5 deg  max_age 80 ms;
  sense   velocity : vector error 2 cm/s   max_age 80 ms;
  sense   battery  : ratio  error 1 %      max_age 1 s;
  output  drive : twist;
  latency 40 ms;
  energy  { drive <= 0.2 %/m; idle <= 0.01 %/s; drain <= 0.3 %/s; charge >= 1 %/s at plug; held <= 300 s; detour <= 60 m; }
}
fleet one : Bot;
site plug = (12 m, 1.2 m);
controller job  : advanced for Bot extern;
controller home : safe for Bot = route to plug within hall speed 0.5 m/s;
monitor charge for r : Bot { "R1" always r.battery >= energy_to(plug) + 5 %; ahead 160 ms; recover home; return when r.battery >= 85 %; }
decision go for Bot { advanced job; period 80 ms; priority charge; }
)";
  };
  const auto c = compiled(text("rectangle (0 m, 0 m) to (14 m, 2.4 m)"));
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  const long mm = std::lround(
      1000 * std::stod(number_in_help(*c, Code::return_set_empty, "`grow(hall, ", "m)`")));
  const auto grown = [&](long by_mm) {
    return text("grow(plain, " + std::to_string(by_mm) + " mm)");
  };
  EXPECT_FALSE(is_refused(grown(mm))) << mm;
  EXPECT_TRUE(is_refused(grown(mm * 95 / 100))) << mm;
}

// Two zones at once that no body is in.
TEST(ReturnCondition, APropertyThatHoldsNowhereIsNamed) {
  const auto both = [](const std::string& east) {
    return compiled(edited(edited(edited(driver::test::drone_spec(), ", 2 waypoints", ""),
                                  "clearance(d, room) >= 10 cm", "d inside room and d inside east"),
                           "\ndecision fly", "\nzone east = " + east + ";\ndecision fly"));
  };
  const auto c = both("rectangle (4.9 m, 0 m) to (9 m, 5 m)");
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  EXPECT_NE(reports(*c).find("its property holds nowhere"), std::string::npos) << reports(*c);
  EXPECT_TRUE(has(*both("complement(room)"), Code::return_set_empty));
  EXPECT_EQ(reports(*both("rectangle (4 m, 0 m) to (9 m, 5 m)")).find("holds nowhere"),
            std::string::npos);
}

std::string yard_with(const std::string& dock) {
  return edited(spec_text("tests/compiler/analysis/dock_in_a_corner.rta"), "(19.7 m, 5.5 m)", dock);
}

// Where the velocity is measured, and the position is as old as it may be, a robot at rest may have
// driven in between: from all that it may then reach a way has to be known. With equal stamps it is
// less, and control would be given back by luck alone.
TEST(ReturnCondition, ASiteHasAWayFromAllThatUnequalStampsLeaveOpen) {
  for (const char* dock : {"(20.075 m, 5.305 m)", "(20 m, 5.33 m)"}) {
    const auto c = compiled(yard_with(dock));
    ASSERT_TRUE(has(*c, Code::return_set_empty)) << dock << "\n" << reports(*c);
    EXPECT_NE(reports(*c).find("has no way from some places beside `dock`"), std::string::npos);
    const std::string place = place_offered(*c);
    EXPECT_FALSE(is_refused(yard_with(place))) << place;
  }
  EXPECT_FALSE(is_refused(yard_with("(19.7 m, 5.5 m)")));
}

// A place that is clear enough, and no more than that, may have none.
TEST(ReturnCondition, ASiteThatIsOfferedHasAWayFromAllAroundIt) {
  for (const auto& [dock, code] : {std::pair{"(20.182 m, 4.928 m)", Code::site_not_returnable},
                                   {"(19.949 m, 7.333 m)", Code::site_unreachable}}) {
    const auto c = compiled(yard_with(dock));
    ASSERT_TRUE(has(*c, code)) << dock << "\n" << reports(*c);
    const std::string place = place_offered(*c, code);
    const auto there = compiled(yard_with(place));
    EXPECT_FALSE(there->diagnostics.has_errors()) << place << "\n" << reports(*there);
  }
}

// A dock so near the boundary that no way is known from beside it: no charge helps, and no nearer
// site. The place that is offered works.
TEST(ReturnCondition, ASiteWithoutAWayFromAllAroundItIsRefusedWithAPlaceThatHasOne) {
  const auto text = [](const std::string& dock) {
    return "spec cramped;\nzone arena = rectangle (0 m, 0 m) to (12 m, 8 m);\n"
           "zone inner = shrink(arena, 60 cm);\n"
           R"(robot Bot {
  body radius 20 cm;
  motion point { speed <= 0.8 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 100 ms;
  sense velocity : vector error 2 cm/s max_age 100 ms;
  sense battery : ratio error 1 % max_age 2 s;
  output push : acceleration;
  latency 30 ms;
  energy { drive <= 0.2 %/m; idle <= 0.01 %/s; drain <= 0.3 %/s; charge >= 1 %/s at dock; held <= 60 s; detour <= 20 m; }
}
fleet one : Bot;
site dock = )" +
           dock + R"(;
controller job  : advanced for Bot extern;
controller home : safe for Bot = route to dock within inner speed 0.3 m/s;
monitor charge for r : Bot { "R1: home" always r.battery >= energy_to(dock) + 5 %; recover home; return when r.battery >= 90 %; }
decision gate for Bot { advanced job; period 100 ms; priority charge; }
)";
  };
  const auto c = compiled(text("(2 m, 1.9 m)"));
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  EXPECT_NE(reports(*c).find("has no way from some places beside `dock`"), std::string::npos);
  const std::string place = place_offered(*c);
  EXPECT_FALSE(is_refused(text(place))) << place;
  // of two docks each has to be elsewhere, and neither of them alone helps
  const auto docks = [&](const std::string& one, const std::string& two) {
    std::string two_bots =
        edited(text("(2 m, 1.9 m)"), "fleet one : Bot;", "fleet one, two : Bot;");
    return edited(edited(two_bots, "site dock = (2 m, 1.9 m)",
                         "site dock(one) = " + one + ";\nsite dock(two) = " + two),
                  "energy_to(dock)", "energy_to(dock(r))");
  };
  const std::string first = "(2 m, 1.9 m)", second = "(7 m, 1.9 m)";
  const auto both = compiled(docks(first, second));
  ASSERT_TRUE(has(*both, Code::return_set_empty)) << reports(*both);
  const std::string offered = reports(*both);
  const auto place_instead = [&](const std::string& of) {
    const std::size_t end = offered.find(" in place of " + of);
    EXPECT_NE(end, std::string::npos) << offered;
    const std::size_t begin = offered.rfind("(", end);
    return offered.substr(begin, end - begin);
  };
  const std::string one = place_instead(first), two = place_instead(second);
  EXPECT_FALSE(is_refused(docks(one, two))) << one << two;
  EXPECT_TRUE(is_refused(docks(one, second))) << one;
  EXPECT_TRUE(is_refused(docks(first, two))) << two;
  // of a charge that is never shown, nor would a place that has a way help
  const auto charged =
      compiled(edited(text("(2 m, 1.9 m)"), "energy_to(dock) + 5 %", "energy_to(dock) + 99 %"));
  EXPECT_NE(reports(*charged).find("a full battery does not show it"), std::string::npos);
  EXPECT_EQ(reports(*charged).find("has no way from some places"), std::string::npos);
}

// One controller drives for both, and has one clearance that it leads to: a robot that one of them
// has it lead, and the other one not let go, would wait for ever.
TEST(ReturnCondition, OneRecoveryLeadsToWhereAllOfItsMonitorsReturn) {
  for (const std::string what :
       {"retreat within yard speed 0.4 m/s",
        "sequence brake_and_hold for 1 s then retreat within yard speed 0.4 m/s"}) {
    const auto c = compiled(R"(spec yard;
zone yard = rectangle (0 m, 0 m) to (30 m, 30 m);
robot Rover {
  body radius 20 cm;
  motion point { speed <= 1.5 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 10 ms;
}
fleet one : Rover;
controller drive  : advanced for Rover extern;
controller inward : safe for Rover = )" +
                            what +
                            R"(;
monitor fence for r : Rover { "R1: in the yard" always r inside yard; recover inward; }
monitor apart for r : Rover { "R2: well in it" always clearance(r, yard) >= 30 cm; recover inward; return when clearance(r, yard) >= 2 m; }
decision d for Rover { advanced drive; period 50 ms; priority fence > apart; }
)");
    ASSERT_FALSE(c->diagnostics.has_errors()) << reports(*c);
    const auto& monitors = c->module->decisions[0].monitors;
    const ir::Recovery &one = monitors[0].recovery, &other = monitors[1].recovery;
    EXPECT_GT(one.return_clearance_mm, 2200);
    EXPECT_EQ(one.return_clearance_mm, other.return_clearance_mm);
    EXPECT_EQ(ir::last_step(one).return_clearance_mm, ir::last_step(other).return_clearance_mm);
  }
}

}  // namespace
}  // namespace rtac::analysis::test
