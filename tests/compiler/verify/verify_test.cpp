// `rtac verify`: what is proved, acknowledged, unknown and refuted, and its exit codes.
#include <chrono>
#include <fstream>
#include <thread>

#include "tests/compiler/verify/testing.h"
#include "tests/slow.h"

namespace rtac::driver::test {
namespace {

TEST_F(Verify, TheDroneIsProved) {
  const Outcome o = verified(drone_spec());
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_NE(o.out.find(" 0 acknowledged, 0 unknown, 0 refuted"), std::string::npos) << o.out;
}

// Both case studies: everything is proved, or acknowledged in the specification.
TEST_F(Verify, TheCaseStudiesAreProvedOrAcknowledged) {
  for (const char* study : {"robot_delivery", "drone_surveillance"}) {
    const std::string path =
        std::string(RTAC_SOURCE_DIR) + "/specs/" + study + "/" + study + ".rta";
    const Outcome o = rtac({"verify", path});
    EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  }
}

TEST_F(Verify, WithoutItsAcknowledgementTheDeliveryIsRefuted) {
  const std::string text = edited(
      spec_text("specs/robot_delivery/robot_delivery.rta"),
      "  acknowledge give_way may break battery \"held at most 60 s; the reserve covers it\";\n",
      "");
  ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  const Outcome o = verified(text, {"--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "C", "battery"), (Statuses{"refuted", "acknowledged"})) << o.out;
}

// What moves among others waits for them: that this is within what is declared nothing proves.
TEST_F(Verify, WhatWaitsForOthersKeepsItsChargeWithinHeld) {
  const std::string waits = "as long as others keep it waiting within `held`, 60 s in all";
  const std::string study = spec_text("specs/robot_delivery/robot_delivery.rta");
  const Json report = Json::parse(verified(study, {"--format", "json"}).out);
  int told = 0;
  for (const Json& o : report["decisions"][0]["obligations"]) {
    if (o["method"] != "declared") continue;
    EXPECT_EQ(o["status"], "acknowledged") << o;
    EXPECT_EQ(o["monitor"], "battery") << o;
    EXPECT_NE(o["because"].get<std::string>().find(waits), std::string::npos) << o;
    ++told;
  }
  EXPECT_EQ(told, 2) << report;
}

// Who is alone waits for nobody.
TEST_F(Verify, WhoIsAloneKeepsItsChargeWhateverHeldSays) {
  const std::string route = spec_text("tests/campaign/specs/templates/route_point.rta");
  write("point.rta", spec_text("tests/campaign/specs/templates/point.rta"));
  const Outcome o = verified(route, {"--format", "json"});
  EXPECT_EQ(statuses(o.out, "P2a", "battery"), Statuses{"proved"}) << o.out << o.err;
}

// A push carries a hold off by d / w^2 at least, w being 2 rad/s at most.
TEST_F(Verify, TheStartTellsWithinWhatARobotIsHeld) {
  const auto held_m = [this](const std::string& text) {
    const Outcome o = verified(text);
    const std::string before = "one that stands is held within ";
    const std::size_t at = o.out.find(before);
    EXPECT_NE(at, std::string::npos) << o.out << o.err;
    return at == std::string::npos ? 0 : std::stod(o.out.substr(at + before.size()));
  };
  const double calm_m = held_m(drone_spec());
  EXPECT_GT(calm_m, 0);
  const std::string limit = "speed <= ";
  EXPECT_GE(held_m(edited(drone_spec(), limit, "disturbance <= 0.1 m/s^2; " + limit)),
            calm_m + 0.1 / 4);
}

// In a wind that holds it off by more than 15 cm it may never be charged.
TEST_F(Verify, WhoMayRestBesideItsDockIsNotShownToKeepItsCharge) {
  const std::string calm = spec_text("tests/campaign/specs/templates/point.rta");
  const std::string limit = "brake >= 1 m/s^2;";
  write("point.rta", calm);
  const std::string route = spec_text("tests/campaign/specs/templates/route_point.rta");
  EXPECT_EQ(statuses(verified(route, {"--format", "json"}).out, "P2b", "battery"),
            Statuses{"proved"});
  write("point.rta", edited(calm, limit, limit + " disturbance <= 0.06 m/s^2;"));
  const Outcome o = verified(route, {"--format", "json"});
  EXPECT_NE(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "P2a", "battery"), Statuses{"unknown"}) << o.out;
  EXPECT_NE(statuses(o.out, "P2b", "battery"), Statuses{"proved"}) << o.out;
  EXPECT_NE(o.out.find("from `dock`, where lasting errors"), std::string::npos) << o.out;
  EXPECT_NE(o.err.find("\"code\": 5009"), std::string::npos) << o.err;
}

// A dock behind a corridor, in a hall of ordinary size: how much wider it has to be is told, works,
// and with 5 % less does not.
TEST_F(Verify, ACorridorThatIsTooNarrowIsToldHowWideItHasToBe) {
  const auto behind = [](const std::string& corridor) {
    return R"(spec narrow_dock;
zone hall = rectangle (0 m, 0 m) to (14 m, 10 m);
zone bay  = rectangle (18 m, 2 m) to (22 m, 8 m);
zone free = )" +
           corridor + R"(;
site dock = (20 m, 5 m);
robot Bot {
  body radius 30 cm;
  motion unicycle { speed <= 1 m/s; turn <= 2 rad/s; accel <= 0.8 m/s^2; brake >= 1 m/s^2; turn_accel <= 6 rad/s^2; }
  sense position : point error 2 cm max_age 100 ms;
  sense heading : angle error 1 deg max_age 100 ms;
  sense velocity : vector error 2 cm/s max_age 100 ms;
  sense battery : ratio error 1 % max_age 5 s;
  output drive : twist;
  latency 40 ms;
  energy { drive <= 0.2 %/m; idle <= 0.005 %/s; drain <= 0.3 %/s; charge >= 0.5 %/s at dock; held <= 600 s; detour <= 40 m; }
}
fleet b : Bot;
controller scan : advanced for Bot extern;
controller back : safe for Bot = retreat within hall speed 0.4 m/s;
controller home : safe for Bot = route to dock within free speed 0.4 m/s;
monitor charge for r : Bot { "R2" always r.battery >= energy_to(dock) + 10 %; recover home; return when r.battery >= 90 %; }
decision drive for Bot { advanced scan; period 100 ms; priority charge; }
)";
  };
  const std::string narrow = "hall | rectangle (14 m, 4.5 m) to (18 m, 5.5 m) | bay";
  const auto grown_by = [](const std::string& by) {
    return "grow(hall | rectangle (14 m, 4.5 m) to (18 m, 5.5 m) | bay, " + by + " m)";
  };
  const Outcome o = verified(behind(narrow), {"--format", "json"});
  const Json report = Json::parse(o.out);
  std::string repair;
  for (const Json& each : report["decisions"][0]["obligations"]) {
    if (each["obligation"] == "P2b") repair = each.value("repair", "");
  }
  const std::string before = "`grow(free, ";
  ASSERT_TRUE(repair.starts_with(before)) << o.out;
  const double by = std::stod(repair.substr(before.size()));
  const auto returns = [&](double growth) {
    const std::string text = behind(grown_by(std::to_string(growth).substr(0, 5)));
    return statuses(verified(text, {"--format", "json"}).out, "P2b", "charge");
  };
  EXPECT_EQ(returns(by), Statuses{"proved"}) << by;
  EXPECT_NE(returns(0.95 * by - 0.001), Statuses{"proved"}) << by;
}

// What no choice avoids, and no run shows, is unknown: these retreats end long before the hole in
// the other zone. The report names the recoveries.
TEST_F(Verify, CoordinatedRecoveriesThatAreNotShownToKeepEachOtherAreUnknown) {
  std::string text = edited(drone_spec(), "decision fly", R"(
zone hole = rectangle (1 m, 1 m) to (1.4 m, 1.4 m);
zone north = rectangle (0 m, 0 m) to (5 m, 9 m) - hole;
controller go_north : safe for Drone = retreat within north speed 0.3 m/s;
monitor up for d : Drone { "SR-2: in the north" always d inside north; recover go_north; }
decision fly)");
  text = edited(text, "priority walls;", "coordinate walls > up;");
  ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  // at a corner that it has in common with the room, a retreat is off its way by more than it has
  const Outcome corner = verified(edited(text, "rectangle (0 m, 0 m) to (5 m, 9 m) - hole",
                                         "rectangle (0 m, 1 m) to (5 m, 9 m)"),
                                  {"--format", "json"});
  EXPECT_EQ(corner.status, exit_violation) << corner.out << corner.err;
  EXPECT_EQ(statuses(corner.out, "C", "up"), Statuses{"refuted"}) << corner.out;
  const Outcome o = verified(text, {"--format", "json"});
  EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "C", "up"), Statuses{"unknown"}) << o.out;
  EXPECT_NE(o.out.find("no run under attack has shown it"), std::string::npos) << o.out;
  EXPECT_EQ(statuses(o.out, "C", "walls"), Statuses{"proved"}) << o.out;
  EXPECT_NE(o.out.find("`go_north` is not shown to keep `walls`"), std::string::npos) << o.out;
}

// Cells are coarse: from within the bent corridor none of them leads on, and the recovery gets out.
TEST_F(Verify, NoWayOverCellsTakesARunToRefute) {
  write("bend.rta", "spec bend;\n" + edited(a_rover, "speed <= 1.5", "speed <= 1") + R"(
zone room = rectangle (0 m, 0 m) to (3 m, 3 m) | rectangle (3 m, 1.2 m) to (6 m, 1.7 m)
          | rectangle (5.5 m, 1.2 m) to (6 m, 4 m) | rectangle (5.5 m, 3.5 m) to (9 m, 4 m)
          | rectangle (9 m, 2 m) to (12 m, 5 m);
controller back : safe for Rover = retreat within room speed 0.3 m/s;
monitor fence for r : Rover { "R1: in the room" always r inside room; recover back; }
decision go for Rover { advanced drive; period 50 ms; priority fence; }
)");
  const Outcome unsought = rtac({"verify", "bend.rta"});
  ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  const Outcome sought = rtac({"verify", "bend.rta"});
  ::unsetenv("RTAC_SIM");
  EXPECT_EQ(sought.status, exit_violation) << sought.out << sought.err;
  EXPECT_NE(sought.out.find("shown by bend.trace"), std::string::npos) << sought.out;
  EXPECT_EQ(unsought.status, exit_inconclusive) << unsought.out << unsought.err;
  EXPECT_NE(unsought.out.find("no way over its cells leads"), std::string::npos) << unsought.out;
}

// Nobody knows where an external recovery leads: that robots wait for each other may be accepted of
// it (rule 11), and what else is proved of it stays so.
TEST_F(Verify, WhereAnExternalRecoveryLeadsMayBeAccepted) {
  const auto page = [](const std::string& hold) {
    return "spec two;\n" +
           edited(edited(a_rover, "fleet r1", "fleet a, b"), "  latency",
                  "  hears other robots max_age 150 ms;\n  latency") +
           "zone hall = rectangle (0 m, 0 m) to (9 m, 9 m);\n"
           "controller bought : safe for Rover extern keeps inside hall speed <= 0.3 m/s;\n"
           "monitor apart for r : Rover { \"R1: apart\"\n"
           "  always forall q : Rover, q != r : distance(r, q) >= 5 cm; ahead 100 ms;\n"
           "  recover bought; " +
           hold +
           " }\n"
           "decision go for Rover { advanced drive; period 50 ms; priority apart; }\n";
  };
  const Outcome open = verified(page(""), {"--format", "json"});
  EXPECT_EQ(statuses(open.out, "P2a", "apart"), Statuses{"proved"}) << open.out << open.err;
  EXPECT_EQ(statuses(open.out, "P2b", "apart"), Statuses{"unknown"});
  const Outcome held =
      verified(page("hold when violated \"somebody comes\";"), {"--format", "json"});
  EXPECT_EQ(statuses(held.out, "P2a", "apart"), Statuses{"proved"}) << held.err;
  EXPECT_EQ(statuses(held.out, "P2b", "apart"), Statuses{"acknowledged"});
  EXPECT_EQ(held.status, exit_clean) << held.out << held.err;
}

TEST_F(Verify, UnsoundLookAheadIsAcknowledged) {
  const Outcome o = verified(
      edited(drone_spec(), "ahead   100 ms", "ahead   20 ms unsound \"to see what happens\""),
      {"--format", "json"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "P3", "walls"), Statuses{"acknowledged"});
  EXPECT_EQ(statuses(o.out, "P1a", "walls"), Statuses{"acknowledged"});
}

// The widest place of what lies outside of a pit is hundreds of kilometres off.
TEST_F(Verify, AWitnessLiesWhereTheZonesDo) {
  std::string text = edited(drone_spec(), "monitor walls",
                            "zone pit = rectangle (0.5 m, 0.5 m) to (0.6 m, 0.6 m);\n"
                            "monitor off for d : Drone { \"SR-2: off the pit\" always "
                            "distance(d, pit) >= 0 m; recover back_off; }\nmonitor walls");
  text = edited(text, "priority walls", "priority walls > off");
  const Json report = Json::parse(verified(text, {"--format", "json"}).out);
  for (const Json& each : report["decisions"][0]["obligations"]) {
    if (each["obligation"] != "satisfiable" || each["monitor"] != "off") continue;
    EXPECT_EQ(each["status"], "proved");
    EXPECT_NE(each["because"].get<std::string>().find("at rest at (2.5 m, 2.5 m)"),
              std::string::npos)
        << each["because"];
    return;
  }
  FAIL() << report;
}

// Mistakes that no obligation is about are those of `rtac check`.
TEST_F(Verify, OtherMistakesAreErrors) {
  const Outcome o = verified(edited(drone_spec(), "clearance", "clearence"));
  EXPECT_EQ(o.status, exit_spec_errors);
  EXPECT_EQ(o.out, "");
}

TEST_F(Verify, WarningsCountWhereTheyAreAskedFor) {
  const std::string text = edited(drone_spec(), "decision fly",
                                  "param unused : length in 1 m .. 2 m = 1 m;\ndecision fly");
  EXPECT_EQ(verified(text).status, exit_clean);
  EXPECT_EQ(verified(text, {"-Werror"}).status, exit_spec_errors);
}

// Two halves of a room are no room: on their seam a body is in neither.
TEST_F(Verify, TheSeamOfTwoZonesIsNotProved) {
  const std::string halves = R"(
zone west = rectangle (0 m, 0 m) to (2.5 m, 5 m);
zone east = rectangle (2.5 m, 0 m) to (5 m, 5 m);
monitor side for d : Drone { "SR-2: on a side" always d inside west or d inside east; recover back_off; }
decision fly)";
  std::string text = edited(drone_spec(), "decision fly", halves);
  text = edited(text, "priority walls;", "priority side > walls;");
  const Outcome o = verified(text, {"--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "P2a", "side"), Statuses{"unknown"}) << o.out;
  // and whoever stands on it is not given back
  EXPECT_EQ(statuses(o.out, "P2b", "side"), Statuses{"refuted"}) << o.out;
  EXPECT_EQ(statuses(o.out, "C", "side"), Statuses{"unknown"}) << o.out;  // the same recovery
}

// Where it takes no search, `rtac check` says so, too: between zones of an `or` that overlap too
// little, and where a return condition does not hold.
TEST_F(Verify, TheCheckWarnsOfPlacesWhereARobotIsStuck) {
  const auto checked = [](const std::string& text) {
    write("spec.rta", text);
    return rtac({"check", "spec.rta"});
  };
  const auto halves = [](const std::string& end, const std::string& begin) {
    return edited(edited(drone_spec(), "monitor walls",
                         "zone west = rectangle (0 m, 0 m) to (" + end +
                             ", 5 m);\nzone east = rectangle (" + begin +
                             ", 0 m) to (5 m, 5 m);\nmonitor side for d : Drone { \"SR-2: on a "
                             "side\" always d inside west or d inside east; recover back_off; "
                             "}\nmonitor walls"),
                  "priority walls;", "priority side > walls;");
  };
  const Outcome seam = checked(halves("2.7 m", "2.3 m"));
  EXPECT_EQ(seam.status, exit_clean) << seam.err;
  EXPECT_NE(seam.err.find("warning[5020]: at rest at ("), std::string::npos) << seam.err;
  EXPECT_NE(seam.err.find("zones that overlap more there"), std::string::npos) << seam.err;
  const Outcome wide = checked(halves("4 m", "1 m"));
  EXPECT_EQ(wide.status, exit_clean) << wide.err;
  EXPECT_EQ(wide.err.find("5020"), std::string::npos) << wide.err;
  const std::string gate =
      edited(edited(drone_spec(), "monitor walls",
                    "zone gate = rectangle (0 m, 0 m) to (1 m, 1 m);\nmonitor walls"),
             "recover back_off;", "recover back_off; return when d inside gate;");
  const Outcome stuck = checked(gate);
  EXPECT_EQ(stuck.status, exit_clean) << stuck.err;
  EXPECT_NE(stuck.err.find("warning[5020]: at rest at ("), std::string::npos) << stuck.err;
  EXPECT_NE(stuck.err.find("`return when` of `walls` does not hold there"), std::string::npos)
      << stuck.err;
}

// Each of two monitors could be satisfied, and never both.
// `back_off` may leave the inner zone, whose own recovery leads back to where `walls` still waits
// for its `return when`.
TEST_F(Verify, RecoveriesThatTakeOverFromEachOtherAreNotProvedToEnd) {
  const std::string two = edited(
      edited(
          drone_spec(), "decision fly",
          "zone inner = shrink(room, 30 cm);\n"
          "controller inwards : safe for Drone = retreat within inner speed 0.3 m/s;\n"
          "monitor middle for d : Drone { \"SR-9: it stays in the middle\" always d inside inner; "
          "ahead 100 ms; recover inwards; }\ndecision fly"),
      "priority walls", "priority middle > walls");
  const Outcome settled = verified(two, {"--format", "json"});
  EXPECT_EQ(statuses(settled.out, "switching", ""), Statuses{"proved"}) << settled.out;
  const Outcome waits = verified(
      edited(two, "recover back_off;", "recover back_off; return when clearance(d, room) >= 1 m;"),
      {"--format", "json"});
  EXPECT_EQ(waits.status, exit_inconclusive) << waits.out << waits.err;
  EXPECT_EQ(statuses(waits.out, "switching", ""), Statuses{"unknown"}) << waits.out;
  EXPECT_NE(waits.out.find("take over from each other for ever"), std::string::npos) << waits.out;
}
// What drives in pages about how recoveries hand over to each other.
const std::string cart = R"(robot Cart {
  body radius 30 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1.2 m/s^2; }
  sense position : point error 2 cm max_age 60 ms;
  sense velocity : vector error 2 cm/s max_age 60 ms;
  output push : acceleration;
  latency 30 ms;
}
fleet cart : Cart;
controller nav : advanced for Cart extern;
)";

// `creep` leads to where both give control back, but its monitor lets it go as soon as the shop is
// far enough, beside a wall that `back` may lead away from to the shop again.
TEST_F(Verify, AMonitorMayLetItsRecoveryGoBeforeThatIsWhereItLeads) {
  const std::string two = R"(spec early;
zone hall = rectangle (0 m, 0 m) to (26 m, 1.7 m) | rectangle (20 m, 0 m) to (24 m, 5 m);
zone shop = rectangle (0 m, -1 m) to (8 m, 6 m);
zone rest = hall - grow(shop, 10 cm);
)" + cart + R"(controller creep : safe for Cart = retreat within rest speed 0.4 m/s;
controller back : safe for Cart = retreat within hall speed 0.4 m/s;
monitor off for c : Cart { "E-1: off the shop" always distance(c, shop) >= 10 cm; recover creep; }
monitor walls for c : Cart { "E-2: in" always c inside hall; recover back; }
decision drive for Cart { advanced nav; period 50 ms; priority off > walls; }
)";
  const Outcome early = verified(two, {"--format", "json"});
  EXPECT_EQ(early.status, exit_inconclusive) << early.out << early.err;
  EXPECT_EQ(statuses(early.out, "switching", ""), Statuses{"unknown"}) << early.out;
  const Outcome there = verified(
      edited(two, "recover creep;", "recover creep; return when clearance(c, rest) >= 40 cm;"),
      {"--format", "json", "-o", "shown"});
  EXPECT_EQ(statuses(there.out, "switching", ""), Statuses{"proved"}) << there.out;
  EXPECT_EQ(rtac({"verify", "--recheck", "shown"}).status, exit_clean);
}
// `back` is slower than `calm` asks for anywhere: where it leads need not be three metres off.
TEST_F(Verify, WhoIsSlowEnoughKeepsNoDistanceBesides) {
  const std::string text = R"(spec slow;
zone field = rectangle (0 m, 0 m) to (30 m, 20 m);
zone well = circle (10 m, 10 m) radius 1 m;
zone open_field = field - circle (10 m, 10 m) radius 2 m - rectangle (22 m, 4 m) to (26 m, 9 m);
)" + cart + R"(controller back : safe for Cart = retreat within open_field speed 0.4 m/s;
monitor keep for r : Cart { "S-1: off the well" always r inside open_field; recover back; }
monitor calm for r : Cart { "S-2: slow near it" always r.speed <= 0.8 m/s or distance(r, well) >= 3 m; recover back; }
decision drive for Cart { advanced nav; period 50 ms; priority keep > calm; }
)";
  const Outcome o = verified(text, {"-o", "shown"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(o.err.find("5020"), std::string::npos) << o.err;
  EXPECT_EQ(rtac({"verify", "--recheck", "shown"}).status, exit_clean);
  // faster than that, it has to
  const Outcome fast = verified(edited(text, "r.speed <= 0.8", "r.speed <= 0.3"), {});
  EXPECT_NE(fast.status, exit_clean) << fast.out;
}
// Who outranks it leads on from where `out` leads no further.
TEST_F(Verify, WhereAnotherRecoveryLeadsOnNobodyIsStuck) {
  const Outcome o = verified(R"(spec on;
zone yard = rectangle (0 m, 0 m) to (20 m, 20 m);
zone east = rectangle (9 m, 0 m) to (20 m, 20 m);
)" + cart + R"(controller out : safe for Cart = retreat within yard speed 0.3 m/s;
controller in : safe for Cart = retreat within east speed 0.3 m/s;
monitor yards for c : Cart { "O-1" always c inside yard; recover out; return when clearance(c, east) >= 10 cm; }
monitor easts for c : Cart { "O-2" always c inside east; recover in; }
decision drive for Cart { advanced nav; period 50 ms; priority easts > yards; }
)",
                             {"--format", "json"});
  EXPECT_EQ(statuses(o.out, "P2b", "yards"), Statuses{"unknown"}) << o.out;
}
// Of two halls that overlap, either recovery leads on along the same way where the other one has
// let go, if both stay where they do.
TEST_F(Verify, RecoveriesThatLeadTheSameWayDoNotTakeOverForEver) {
  const std::string two = R"(spec halls;
zone west = rectangle (0 m, 0 m) to (14 m, 10 m);
zone south = rectangle (0 m, 0 m) to (24 m, 6 m);
zone both = west & south;
)" + cart + R"(controller to_west : safe for Cart = retreat within both speed 0.4 m/s;
controller to_south : safe for Cart = retreat within both speed 0.4 m/s;
monitor in_west for c : Cart { "E-1: in the west" always c inside west; recover to_west; }
monitor in_south for c : Cart { "E-2: in the south" always c inside south; recover to_south; }
decision drive for Cart { advanced nav; period 50 ms; priority in_west > in_south; }
)";
  const Outcome same = verified(two, {"--format", "json", "-o", "shown"});
  EXPECT_EQ(statuses(same.out, "switching", ""), Statuses{"proved"}) << same.out;
  EXPECT_EQ(rtac({"verify", "--recheck", "shown"}).status, exit_clean);
  const Outcome slower =
      verified(edited(two, "to_south : safe for Cart = retreat within both speed 0.4",
                      "to_south : safe for Cart = retreat within both speed 0.3"),
               {"--format", "json"});
  EXPECT_EQ(statuses(slower.out, "switching", ""), Statuses{"unknown"}) << slower.out;
}
// A robot that loiters rests between laps where its zone leaves as much room as a retreat does: a
// monitor that waits for another one's way back is not left for ever.
TEST_F(Verify, WhereARobotLoitersTheOthersGiveBackAsWell) {
  const std::string text = edited(
      edited(spec_text("tests/golden/parts/drone.rta"), "retreat within room",
             "loiter within shrink_of_room"),
      "controller back_off", "zone shrink_of_room = shrink(room, 30 cm);\ncontroller back_off");
  const Outcome o = verified("spec laps;\n" + text + R"(
input link : bool max_age 1 s;
controller rest : safe for Drone = sequence brake_and_hold for 3 s then loiter within shrink_of_room speed 0.3 m/s;
monitor lost for d : Drone { "SR-0: rests without a link" always link; recover rest; }
monitor walls for d : Drone { "SR-1: in" always d inside room; recover back_off; }
monitor inner for d : Drone { "SR-2: well in" always d inside shrink_of_room; recover back_off; }
decision fly for Drone { advanced pilot; period 50 ms; priority lost > walls > inner; }
)",
                             {"--format", "json", "-o", "certificates"});
  EXPECT_EQ(statuses(o.out, "switching", ""), Statuses{"proved"}) << o.out << o.err;
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
}
TEST_F(Verify, WithoutAModelCheckerNothingIsSaidOfSwitching) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  const Outcome o = verified(drone_spec(), {"--format", "json"});
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "switching", ""), Statuses{"unknown"}) << o.out;
  EXPECT_NE(o.out.find("no program is called `timeout`"), std::string::npos) << o.out;
}
// Programs of that name which never end, or are not there, stand before those that do.
class Hanging : public Verify {
 protected:
  void SetUp() override {
    Verify::SetUp();
    path_ = std::getenv("PATH");
  }
  void TearDown() override {
    ::setenv("PATH", path_.c_str(), 1);
    Verify::TearDown();
  }
  // and does not listen to who would end it
  void hangs(const std::string& program) const {
    stands_in(program,
              "trap '' TERM; echo $$ > " + fs::absolute("process").string() + "; sleep 3600");
  }
  // Within ten seconds, since signals take their time; what nobody has waited for yet has ended.
  static bool has_ended() {
    const std::string stat = "/proc/" + std::to_string(std::stoi(read("process"))) + "/stat";
    for (int tries = 0; tries < 1000; ++tries) {
      std::ifstream file(stat);
      std::string line;
      if (!std::getline(file, line) || line.find(") Z ") != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }
  void stands_in(const std::string& program, const std::string& does) const {
    fs::create_directory("bin");
    write("bin/" + program, "#!/bin/sh\n" + does + "\n");
    fs::permissions("bin/" + program, fs::perms::owner_all);
    ::setenv("PATH", (fs::absolute("bin").string() + ":" + path_).c_str(), 1);
  }

 private:
  std::string path_;
};
TEST_F(Hanging, AModelCheckerLeavesItUnknown) {
  hangs("spin");
  const Outcome o = verified(drone_spec(), {"--format", "json"});
  EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "switching", ""), Statuses{"unknown"}) << o.out;
  EXPECT_NE(o.out.find("spin has not ended within 20 s"), std::string::npos) << o.out;
  EXPECT_TRUE(has_ended());
}
TEST_F(Hanging, AMissingModelCheckerIsNamed) {
  stands_in("spin", "exit 127");  // as a shell ends that finds none
  const Outcome o = verified(drone_spec(), {"--format", "json"});
  EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
  EXPECT_NE(o.out.find("`spin` is not installed"), std::string::npos) << o.out;
}
// For want of memory, say: that is no time which was up.
TEST_F(Hanging, AModelCheckerThatIsKilledHasNotTakenTooLong) {
  stands_in("spin", "kill -KILL $$");
  const Outcome o = verified(drone_spec(), {"--format", "json"});
  EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
  EXPECT_EQ(o.out.find("has not ended"), std::string::npos) << o.out;
}
TEST_F(Hanging, ASolverLeavesItUnknownAndIsAskedOnce) {
  ASSERT_EQ(verified(drone_spec(), {"-o", "certificates"}).status, exit_clean);
  hangs("z3");
  const Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_inconclusive) << again.out << again.err;
  EXPECT_NE(again.out.find("z3 has not ended within 20 s"), std::string::npos) << again.out;
  EXPECT_NE(again.out.find("z3 is not asked, since it has not ended before"), std::string::npos)
      << again.out;
  EXPECT_TRUE(has_ended());
}
// Half of an answer is none, nor is that of a solver which was killed.
TEST_F(Hanging, ASolverThatDiesHasProvedNothing) {
  ASSERT_EQ(verified(drone_spec(), {"-o", "certificates"}).status, exit_clean);
  stands_in("z3", "echo unsat; kill -SEGV $$");
  Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_inconclusive) << again.out << again.err;
  EXPECT_NE(again.out.find("z3 has answered 1 of "), std::string::npos) << again.out;
  stands_in("z3", "for k in $(seq $(grep -c '(check-sat)' \"$2\")); do echo unsat; done; exit 137");
  again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_inconclusive) << again.out << again.err;
  EXPECT_NE(again.out.find("z3 has ended with status 137"), std::string::npos) << again.out;
}
// What writes nonsense is told in one short line that controls no terminal, and proves nothing.
TEST_F(Hanging, NonsenseIsToldInOrder) {
  const std::string nonsense =
      "printf '\\033[31mred\\007\\377'; head -c 5000 /dev/zero | tr '\\0' n; echo; yes unsat | "
      "head -99";
  ASSERT_EQ(verified(drone_spec(), {"-o", "certificates"}).status, exit_clean);
  const auto in_order = [](const std::string& out) {
    EXPECT_NE(out.find("\\u{1b}[31mred\\u{7}\\x{ff}nnn"), std::string::npos) << out;
    EXPECT_NE(out.find("nnn..."), std::string::npos) << out;
    EXPECT_LT(out.size(), 6'000U);
    EXPECT_EQ(out.find('\033'), std::string::npos);
  };
  stands_in("z3", nonsense);
  const Outcome solved = recheck_sealed_anew();
  EXPECT_EQ(solved.status, exit_inconclusive);
  in_order(solved.out);
  fs::remove_all("bin");
  const char* const chosen = std::getenv("CC");
  const std::string compiler = chosen != nullptr ? chosen : "";
  for (const char* const program : {"spin", "cc"}) {
    stands_in(program, nonsense);
    ::setenv("CC", "cc", 1);
    const Outcome o = verified(drone_spec());
    compiler.empty() ? ::unsetenv("CC") : ::setenv("CC", compiler.c_str(), 1);
    fs::remove_all("bin");
    EXPECT_EQ(o.status, exit_inconclusive) << program;
    in_order(o.out);
    EXPECT_NE(o.out.find("`one_controller` is not shown"), std::string::npos) << o.out;
  }
}
TEST_F(Verify, ZonesThatShareNoRoomHaveNoJointReturn) {
  std::string text = edited(drone_spec(), "decision fly", R"(
zone far_room = rectangle (4.6 m, 0 m) to (9.6 m, 5 m);
controller go_far : safe for Drone = retreat within far_room speed 0.3 m/s;
monitor far for d : Drone { "SR-2: over there" always d inside far_room; recover go_far; }
decision fly)");
  text = edited(text, "priority walls;",
                "priority far > walls; acknowledge go_far may break walls \"a test\";");
  const Outcome o = verified(text, {"--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "joint return", ""), Statuses{"refuted"}) << o.out;
  EXPECT_EQ(statuses(o.out, "C", "walls"), Statuses{"acknowledged"}) << o.out;
}

// Of a pair, a report offers what the check has tried: no `held` that takes more than a battery
// has.
TEST_F(Verify, WhatIsOfferedOfAPairHasBeenTried) {
  const std::string docks = R"(spec docks;
zone hall = rectangle (0 m, 0 m) to (60 m, 6 m);
robot Cart {
  body radius 20 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  sense battery : ratio error 0.5 % max_age 2 s;
  output push : acceleration;
  latency 30 ms;
  energy { drive <= 1 %/m; idle <= 0.01 %/s; drain <= 0.5 %/s; charge >= 1 %/s at west; held <= 60 s; detour <= 5 m; }
}
fleet c : Cart;
site west = (2 m, 3 m);
site east = (58 m, 3 m);
controller policy : advanced for Cart extern;
controller go_west : safe for Cart = route to west within hall speed 0.5 m/s;
controller go_east : safe for Cart = route to east within hall speed 0.5 m/s;
monitor to_west for r : Cart { "R1: gets west" always r.battery >= energy_to(west) + 5 %; recover go_west; }
monitor to_east for r : Cart { "R2: gets east" always r.battery >= energy_to(east) + 5 %; recover go_east; }
decision go for Cart { advanced policy; period 50 ms; priority to_west > to_east; }
)";
  const Outcome o = verified(docks);
  EXPECT_NE(o.out.find("the charge reckons with `held <= 60 s`"), std::string::npos) << o.out;
  for (const char* const way : {"what works: `held", "what works: `priority"}) {
    EXPECT_EQ(o.out.find(way), std::string::npos) << o.out;
  }
}

// Two monitors that share a recovery, and one that both are to keep: it is said once, of both.
TEST_F(Verify, ARecoveryOfSeveralMonitorsIsSaidToKeepAnotherOneOnce) {
  const std::string text = R"(spec shared;
zone yard = rectangle (0 m, 0 m) to (10 m, 8 m);
robot Cart {
  body radius 25 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1.2 m/s^2; }
  sense position : point error 2 cm max_age 100 ms;
  sense velocity : vector error 2 cm/s max_age 100 ms;
  output push : acceleration;
  latency 30 ms;
}
fleet c : Cart;
input on : bool max_age inf;
controller policy : advanced for Cart extern;
controller stop : safe for Cart = brake_and_hold;
controller back : safe for Cart = retreat within yard speed 0.3 m/s;
monitor slow for r : Cart { "R1: slow" always r.speed <= 0.8 m/s; recover stop; }
monitor told for r : Cart { "R2: on" always on; recover stop; }
monitor fence for r : Cart { "R3: in" always r inside yard; recover back; }
decision gate for Cart { advanced policy; period 50 ms; priority told > slow > fence; }
)";
  const Outcome o = verified(text, {"--format", "json", "-o", "certificates"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "C", "fence"), Statuses{"proved"}) << o.out;
  const Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}

// A recovery that leads out of what one of its monitors says keeps that for none of them.
TEST_F(Verify, WhatP2aRefutesIsNotProvedOfTheSameRecoveryOfAnotherMonitor) {
  const Outcome o = verified(R"(spec own;
zone yard = rectangle (0 m, 0 m) to (10 m, 8 m);
zone west = rectangle (0 m, 0 m) to (5 m, 8 m);
robot Cart {
  body radius 25 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1.2 m/s^2; }
  sense position : point error 2 cm max_age 100 ms;
  sense velocity : vector error 2 cm/s max_age 100 ms;
  output push : acceleration;
  latency 30 ms;
}
fleet c : Cart;
controller policy : advanced for Cart extern;
controller back : safe for Cart = retreat within yard speed 0.3 m/s;
monitor fence for r : Cart { "R1: in" always r inside yard; recover back; }
monitor side for r : Cart { "R2: in the west" always r inside west; recover back; }
decision gate for Cart { advanced policy; period 50 ms; priority fence > side; }
)",
                             {"--format", "json"});
  EXPECT_EQ(statuses(o.out, "P2a", "side"), Statuses{"unknown"}) << o.out;  // it takes a run
  EXPECT_EQ(statuses(o.out, "C", "side"), Statuses{"unknown"}) << o.out;
  EXPECT_EQ(statuses(o.out, "C", "fence"), Statuses{"proved"}) << o.out;
}

// What no sample has to confirm is taken for granted, and listed.
TEST_F(Verify, AnInputThatHoldsForEverIsAmongTheAssumptions) {
  write("spec.rta", R"(spec held;
zone yard = rectangle (0 m, 0 m) to (10 m, 8 m);
robot Cart {
  body radius 25 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1.2 m/s^2; }
  sense position : point error 2 cm max_age 100 ms;
  sense velocity : vector error 2 cm/s max_age 100 ms;
  output push : acceleration;
  latency 30 ms;
}
fleet c : Cart;
input on : bool max_age inf;
input fresh : bool max_age 1 s;
controller policy : advanced for Cart extern;
controller stop : safe for Cart = brake_and_hold;
monitor told for r : Cart { "R1: on" always on and fresh; recover stop; }
decision gate for Cart { advanced policy; period 50 ms; priority told; }
)");
  const Outcome check = rtac({"check", "spec.rta"});
  EXPECT_EQ(check.status, exit_clean) << check.err;
  EXPECT_NE(check.out.find("  assumed: the last value of on holds for ever\n"), std::string::npos)
      << check.out;
  EXPECT_EQ(check.out.find("fresh holds"), std::string::npos) << check.out;
  ASSERT_EQ(rtac({"build", "spec.rta", "-o", "generated"}).status, exit_clean);
  const Json manifest = Json::parse(read("generated/spec_manifest.json"));
  const auto& all = manifest["assumptions"];
  EXPECT_EQ(std::count_if(all.begin(), all.end(),
                          [](const Json& a) {
                            return a["bound"] == "on max_age" && a["checked_by"] == "UNCHECKED";
                          }),
            1)
      << all;
}

// Where one monitor by itself never gives control back, all together are told the same number.
TEST_F(Verify, WhatWorksForOneMonitorIsSaidOfAllTogether) {
  const Outcome o = verified(
      "spec lane;\nzone lane = rectangle (0 m, 0 m) to (20 m, 0.5 m);\n" + a_rover +
          "controller along : safe for Rover = retreat within lane speed 0.3 m/s;\n"
          "monitor fence for r : Rover { \"SR-1: in\" always r inside lane; recover along; }\n"
          "decision go for Rover { advanced drive; period 20 ms; priority fence; }\n",
      {"--format", "json"});
  std::string own, together;
  const Json report = Json::parse(o.out);
  for (const Json& obligation : report["decisions"][0]["obligations"]) {
    if (obligation["obligation"] == "P2b") own = obligation.value("repair", "");
    if (obligation["obligation"] == "joint return") together = obligation.value("repair", "");
  }
  EXPECT_NE(own.find("`grow(lane, "), std::string::npos) << o.out;
  EXPECT_EQ(together, own);
}

// A fence that asks for more of one of its zones asks for that of this one alone: whoever goes home
// within what is left lets nobody take over.
TEST_F(Verify, AFenceAsksOfEachZoneWhatItSaysOfIt) {
  const Outcome o = verified(R"(spec garden;
zone lawn = rectangle (0 m, 0 m) to (20 m, 12 m);
zone pond = circle (10 m, 6 m) radius 2 m;
zone free = lawn - grow(pond, 50 cm);
robot Mower {
  body     radius 30 cm;
  motion   unicycle { speed <= 0.8 m/s; turn <= 1.5 rad/s; accel <= 1 m/s^2; brake >= 1 m/s^2; turn_accel <= 6 rad/s^2; }
  sense    position : point   error 3 cm    max_age 100 ms;
  sense    heading  : angle   error 2 deg   max_age 100 ms;
  sense    velocity : vector  error 3 cm/s  max_age 100 ms;
  sense    battery  : ratio   error 0.5 %   max_age 5 s;
  output   drive : twist;
  latency  50 ms;
  energy   { drive <= 0.4 %/m; idle <= 0.01 %/s; drain <= 0.4 %/s; charge >= 1 %/s at dock; held <= 60 s; detour <= 10 m; }
}
site dock = (2 m, 2 m);
fleet m1 : Mower;
controller mow  : advanced for Mower extern;
controller home : safe for Mower = route to dock within free speed 0.4 m/s;
controller back : safe for Mower = retreat within free speed 0.3 m/s;
monitor fence for r : Mower { "R1: on the lawn, 50 cm off the pond" always r inside lawn and distance(r, pond) >= 50 cm; ahead 200 ms; recover back; }
monitor battery for r : Mower { "R2: home" always r.battery >= energy_to(dock) + 5 %; ahead 200 ms; recover home; return when r.battery >= 90 %; }
decision drive for Mower { advanced mow; period 100 ms; priority fence > battery; }
)",
                             {"-o", "certificates"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  const Outcome again = rtac({"verify", "--recheck", "certificates"});
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}

TEST(SlowTests, OfVerifyAreThere) {
  EXPECT_EQ(rtac::test::slow_tests_gone("compiler_verify"), std::set<std::string>{});
}

}  // namespace
}  // namespace rtac::driver::test
