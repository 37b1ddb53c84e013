// Reports in which somebody has written what is not so, sealed anew: each is noticed, and why.
#include <algorithm>

#include "tests/compiler/verify/forged.h"

namespace rtac::driver::test {
namespace {

const std::string delivery = "specs/robot_delivery/robot_delivery.rta";

// A charge names no zone, and is led home all the same.
TEST_F(Forged, AChargeIsGivenBackByAWay) {
  prove(spec_text(delivery));
  Json& claims = entry("P2b", "battery")["claims"];
  for (std::size_t k = claims.size(); k-- > 0;) {
    if (claims[k]["claim"] == "ways") claims.erase(k);
  }
  expect_noticed("P2b of `battery`: it rests on no claim `ways`");
}

// What is so of another recovery is no claim about this one.
TEST_F(Forged, AWayIsThatOfTheMonitorItself) {
  prove(spec_text(delivery));
  const auto ways_of = [&](const std::string& monitor) -> Json& {
    Json& claims = entry("P2b", monitor)["claims"];
    const auto found = std::find_if(claims.begin(), claims.end(),
                                    [](const Json& c) { return c["claim"] == "ways"; });
    EXPECT_NE(found, claims.end());
    return *found;
  };
  const Json other = ways_of("geofence");
  EXPECT_NE(ways_of("battery"), other);
  ways_of("battery") = other;
  expect_noticed("P2b of `battery`: it rests on no claim `ways`");
}

TEST_F(Forged, APairIsAboutAMonitorThatTheRecoveryDrivesFor) {
  prove(spec_text(delivery));
  Json empty = entry("C", "geofence");
  empty["status"] = "proved";
  empty["claims"] = Json::array();
  Json& all = report_["decisions"][0]["obligations"];
  all.insert(all.begin(), empty);
  expect_noticed("it is about no monitor that the recovery drives for");
}

// An acknowledgement is about what a recovery keeps and leads to, and about nothing else.
TEST_F(Forged, WhetherAPropertyCanBeSeenNobodyAcknowledges) {
  prove(edited(spec_text(delivery), "acknowledge give_way",
               "acknowledge go_charge may break battery \"staff\"; acknowledge give_way"));
  Json& o = entry("satisfiable", "battery");
  o["status"] = "acknowledged";
  o["claims"] = Json::array();
  expect_noticed("satisfiable of `battery`: nobody acknowledges it");
}

// What is acknowledged of pairs does not make a livelock of anything else acceptable.
TEST_F(Forged, TurnsAreCheckedWithWhatIsAccepted) {
  prove(spec_text(delivery));
  Json& o = entry("switching", "");
  o["status"] = "acknowledged";
  o["claims"] = Json::array();
  expect_noticed("switching: it rests on no claim `protocol`");
}

TEST_F(Forged, AnAgentMayComeNearToWhoIsAlone) {
  prove("spec near;\nzone room = rectangle (0 m, 0 m) to (9 m, 9 m);\n" +
        edited(a_rover, "fleet r1",
               "agent man : radius 25 cm, speed <= 1 m/s error 5 cm max_age 200 ms;\nfleet r1") +
        R"(controller back : safe for Rover = retreat within room speed 0.3 m/s;
monitor off for r : Rover { "R1: off" always distance(r, man) >= 30 cm; recover back; }
decision go for Rover { advanced drive; period 50 ms; priority off;
  acknowledge back may break off "he sees it"; }
)");
  entry("P2a", "off")["status"] = "proved";
  expect_noticed("P2a of `off`: others may break it");
}

TEST_F(Forged, RobotsAreNoFartherApartThanTheirZoneIsWide) {
  write("point.rta", spec_text("tests/campaign/specs/templates/point.rta"));
  prove(spec_text("tests/campaign/specs/templates/yield_point.rta"));
  expect_noticed_in("spec.rta", ">= 10 cm", ">= 13 m",
                    "joint return: no two robots are so far apart as `apart` asks");
}

// That others come near is accepted of a recovery, and not that it leads elsewhere.
TEST_F(Forged, WhereItLeadsNobodyAcknowledges) {
  prove(
      "spec near;\nzone room = rectangle (0 m, 0 m) to (9 m, 9 m);\n"
      "zone hall = rectangle (0 m, 0 m) to (12 m, 9 m);\n" +
      edited(a_rover, "fleet r1",
             "agent man : radius 25 cm, speed <= 1 m/s error 5 cm max_age 200 ms;\nfleet r1") +
      R"(zone inner = rectangle (1 m, 1 m) to (8 m, 8 m);
controller back : safe for Rover = retreat within inner speed 0.3 m/s;
monitor off for r : Rover {
  "R1: off" always distance(r, man) >= 30 cm and clearance(r, room) >= 50 cm; recover back; }
decision go for Rover { advanced drive; period 50 ms; priority off;
  acknowledge back may break off "he sees it"; }
)");
  EXPECT_EQ(entry("P2a", "off")["status"], "acknowledged");
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
  const std::string source = read("certificates/sources/spec.rta");
  const struct {
    std::string from, to, why;
  } cases[] = {{"within inner", "within hall", "nobody can accept that `back` leads out of `room`"},
               {"rectangle (1 m, 1 m)", "rectangle (0.4 m, 1 m)",
                "nobody can accept that `back` leads out of what is 0.5 m inside `room`"},
               {"= retreat within inner speed 0.3 m/s", "extern",
                "nobody can accept what `back` does, as it claims nothing"},
               {"clearance(r, room) >= 50 cm", "(r inside room or r inside bay)",
                "nobody can accept that `back` leads out of all zones of an `or`"}};
  for (const auto& each : cases) {
    std::string text = edited(source, each.from, each.to);
    if (each.to.find("bay") != std::string::npos) {
      text = edited(text, "within inner", "within hall");
      text =
          edited(text, "zone hall", "zone bay = rectangle (9 m, 0 m) to (11 m, 9 m);\nzone hall");
    }
    write("certificates/sources/spec.rta", text);
    expect_noticed("P2a of `off`: " + each.why);
  }
}

// In a wind that holds it off.
TEST_F(Forged, WhoChargesRestsAtItsDock) {
  write("point.rta", spec_text("tests/campaign/specs/templates/point.rta"));
  prove(edited(spec_text("tests/campaign/specs/templates/route_point.rta"), "dock = (2 m, 4.5 m)",
               "dock = (2 m, 2 m)"));
  const std::string limit = "brake >= 1 m/s^2;";
  expect_noticed_in("point.rta", limit, limit + " disturbance <= 0.3 m/s^2;",
                    "P2a of `battery`: it may come to rest too far from its dock to be charged");
}

// Another dock, from beside which no way is known that a robot at rest there might have to take.
TEST_F(Forged, FromAllAroundADockAWayIsKnown) {
  prove(spec_text("tests/compiler/analysis/dock_in_a_corner.rta"));
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
  for (const char* dock : {"(20.075 m, 5.305 m)", "(20 m, 5.33 m)"}) {
    const std::string source = read("certificates/sources/spec.rta");
    expect_noticed_in("spec.rta", "(19.7 m, 5.5 m)", dock,
                      "m) beside `dock` no way is known, and no charge is enough for that");
    write("certificates/sources/spec.rta", source);
  }
}

// To the millimetre: where the next place is refused, the last one that is proved is accepted.
TEST_F(Forged, FromAllAroundTheLastDockThatIsProvedAWayIsKnown) {
  const auto page = [](const std::string& y) {
    return edited(spec_text("tests/compiler/analysis/dock_in_a_corner.rta"), "(19.7 m, 5.5 m)",
                  "(19.5 m, " + y + " m)");
  };
  prove(page("5.261"));
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
  EXPECT_NE(verified(page("5.26")).status, exit_clean);
}

// Where a recovery ends, and whether it gets there, is read from the specification.
TEST_F(Forged, AWayEndsWhereControlIsGivenBack) {
  const auto page = [](const std::string& recovery) {
    return "spec ends;\nzone hall = rectangle (0 m, 0 m) to (12 m, 9 m);\nsite home = (6 m, 4.5 "
           "m);\n" +
           a_rover + "controller go : safe for Rover = " + recovery +
           " within hall speed 0.3 m/s;\n"
           R"(monitor fence for r : Rover { "R1" always clearance(r, hall) >= 10 cm; recover go; }
decision lead for Rover { advanced drive; period 50 ms; priority fence; }
)";
  };
  prove(page("route to home"));
  expect_noticed_in("spec.rta", "(6 m, 4.5 m)", "(0.4 m, 4.5 m)",
                    "nearer to the boundary than control is given back");
  prove(page("retreat"));
  expect_noticed_in("spec.rta", "speed 0.3 m/s", "speed 0.01 m/s", "`go` is too slow to make way");
  prove(page("retreat"));
  expect_noticed_in("spec.rta", "retreat within hall speed 0.3 m/s",
                    "sequence retreat within hall speed 0.3 m/s for 1 s then brake_and_hold",
                    "nothing gives control back");
}

// What a landing is claimed to do it does for limits of height alone.
TEST_F(Forged, ALandingGivesBackAsFarAsHeightsGo) {
  const std::string page =
      "spec land;\n" + a_quad + R"(controller down   : safe for Quad = land to 1 m speed 0.5 m/s;
monitor roof for r : Quad { "R1" always r.position.z <= 10 m; recover down; }
decision fly for Quad { advanced policy; period 50 ms; priority roof; }
)";
  prove(page);
  expect_noticed_in("spec.rta", "recover down;", "recover down; return when r.position.z >= 5 m;",
                    "its `return when` may not hold where it has landed");
  prove(page);
  expect_noticed_in("spec.rta", "z <= 10 m", "z <= 10 m and r.speed <= 1 m/s",
                    "the property asks for more than a height");
}

// Where it ends every limit of height is kept, whatever the wind is.
TEST_F(Forged, ALandingGivesBackWhenInputsLetIt) {
  const std::string page = "spec wind;\n" +
                           edited(a_quad, "fleet q",
                                  "input wind : real [m/s] in 0 m/s .. 30 m/s error 1 m/s max_age "
                                  "2 s;\nfleet q") +
                           R"(controller down : safe for Quad = land to 5 m speed 0.8 m/s;
monitor storm for r : Quad {
  "R1: low in a strong wind"
  always wind >= 12 m/s implies r.position.z <= 15 m;
  recover down;
  return when wind <= 10 m/s;
}
decision fly for Quad { advanced policy; period 50 ms; priority storm; }
)";
  prove(page);
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
  expect_noticed_in("spec.rta", "implies r.position.z", "iff r.position.z",
                    "the landing ends too high, or too low");
}

}  // namespace
}  // namespace rtac::driver::test
