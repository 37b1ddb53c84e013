// Zones that come and go: that a recovery leads out in time is proved, found once more, and denied
// where a certificate says something else; what is not shown stays unknown.
#include <cmath>

#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

const char* const point = R"(
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 2 cm    max_age 50 ms;
  sense    velocity : vector  error 2 cm/s  max_age 50 ms;
  output   thrust   : acceleration;
  latency  20 ms;
)";
const char* const wheels = R"(
  motion   unicycle { speed <= 0.5 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 1 m/s^2; turn_accel <= 10 rad/s^2; }
  sense    position : point   error 1 cm     max_age 20 ms;
  sense    heading  : angle   error 0.01 rad max_age 20 ms;
  sense    velocity : vector  error 1 cm/s   max_age 20 ms;
  output   drive    : twist;
  latency  10 ms;
)";

struct Hall {
  std::string robot = point, room = "rectangle (0 m, 0 m) to (8 m, 4 m)";
  std::string lessons = "rectangle (5 m, 0 m) to (8 m, 4 m)", home = "(1.6 m, 2 m)";
  std::string quiet = "distance(r, lessons) >= 30 cm", walls = "r inside room";
  std::string back = "go_home", priority = "quiet > walls", fleet = "fleet rover : Rover;";
  std::string period = "50 ms";
};
std::string text_of(const Hall& h) {
  const std::string times = " during monday, friday 07:30 .. 16:00;\n";
  return "spec hall;\nclock utc;\nzone room = " + h.room + ";\nzone lessons = " + h.lessons +
         times + R"(zone west = rectangle (0 m, 0 m) to (5 m, 4 m);
zone gate = rectangle (4 m, 0 m) to (8 m, 4 m))" +
         times + "robot Rover {\n  body radius 8 cm;" + h.robot + "}\n" + h.fleet + R"(
controller pilot    : advanced for Rover extern;
controller back_off : safe for Rover = retreat within room speed 0.3 m/s;
controller stop     : safe for Rover = brake_and_hold;
site home = )" +
         h.home + R"(;
controller go_home  : safe for Rover = route to home within room speed 0.3 m/s;
monitor quiet for r : Rover { "SR-1: as the clock says" always )" +
         h.quiet + R"(; recover go_home; }
monitor walls for r : Rover { "SR-2: in" always )" +
         h.walls + "; recover " + h.back + "; }\ndecision fly for Rover { advanced pilot; period " +
         h.period + "; priority " + h.priority + "; }\n";
}
Hall of_wheels() {
  Hall h;
  h.robot = wheels, h.period = "20 ms";
  h.walls = "clearance(r, room) >= 20 cm";
  return h;
}
Hall of_gate() {
  Hall h;
  h.quiet = "r inside west or r inside gate";
  return h;
}

class Leaving : public Verify {
 protected:
  // Everything is, and found once more.
  void prove(const Hall& hall) {
    const Outcome o = verified(text_of(hall), {"-o", "certificates"});
    ASSERT_EQ(o.status, exit_clean) << o.out << o.err;
    report_ = Json::parse(read("certificates/verification.json"));
    source_ = read("certificates/sources/spec.rta");
    const Outcome again = rechecked();
    ASSERT_EQ(again.status, exit_clean) << again.out << again.err;
  }
  static Outcome rechecked() { return recheck_sealed_anew(); }
  static void expect_denied(const std::string& why) {
    const Outcome o = rechecked();
    EXPECT_EQ(o.status, exit_violation) << why << "\n" << o.out << o.err;
    EXPECT_NE((o.out + o.err).find(why), std::string::npos) << why << "\n" << o.out << o.err;
  }
  void deny_source(const std::string& from, const std::string& to, const std::string& why) {
    write("certificates/sources/spec.rta", edited(source_, from, to));
    expect_denied(why);
    write("certificates/sources/spec.rta", source_);
  }
  // In all claims that a recovery leads out.
  void deny_number(const std::string& key, std::int64_t by, const std::string& why) {
    Json report = report_;
    for (Json& o : report["decisions"][0]["obligations"]) {
      for (Json& c : o["claims"]) {
        if (c["claim"] != "leaves") continue;
        c[key] = std::to_string(std::stoll(c[key].get<std::string>()) + by);
      }
    }
    write("certificates/verification.json", report.dump());
    expect_denied(why);
    write("certificates/verification.json", report_.dump());
  }
  // Why P2a of `quiet` is unknown.
  static void expect_unknown(const Hall& hall, const std::string& why) {
    const Outcome o = verified(text_of(hall), {"--format", "json"});
    const Json report = Json::parse(o.out);
    for (const Json& each : report["decisions"][0]["obligations"]) {
      if (each["obligation"] != "P2a" || each["monitor"] != "quiet") continue;
      EXPECT_EQ(each["status"], "unknown") << each << "\n" << o.err;
      EXPECT_NE(each["because"].get<std::string>().find(why), std::string::npos) << each;
    }
  }
  Json report_;
  std::string source_;
};

TEST_F(Leaving, OfWhatIsKeptOffIsProved) {
  prove({});
  Hall corner;
  corner.lessons = "rectangle (5 m, 2.4 m) to (9 m, 5 m)";
  corner.home = "(1.6 m, 1.2 m)";
  prove(corner);
  Hall beyond;  // a wall
  beyond.lessons = "rectangle (0 m, 4 m) to (8 m, 6 m)";
  prove(beyond);
  Hall far;
  far.lessons = "circle (20 m, 2 m) radius 2 m";
  prove(far);
}
TEST_F(Leaving, OfWhatIsStayedInIsProved) {
  prove(of_gate());
  Hall both = of_gate();
  both.quiet =
      "(r inside west or r inside gate) and distance(r, lessons) >= 10 cm and r inside room";
  prove(both);
}
TEST_F(Leaving, OnWheelsIsProved) {
  prove(of_wheels());
  Hall gate = of_wheels();
  gate.quiet = of_gate().quiet;
  prove(gate);
  Hall at_walls = of_wheels();
  at_walls.walls = "r inside room";
  prove(at_walls);
  Hall beside = of_wheels();
  beside.home = "(3.2 m, 2 m)";
  prove(beside);
}

// Who is let go on its way is led on to the site, where it does not matter what comes or goes.
TEST_F(Leaving, OneWayForSeveralMonitorsIsProved) {
  Hall hall;
  hall.back = "go_home";
  hall.robot += R"(
  sense    battery  : ratio error 1 % max_age 2 s;
  energy   { drive <= 0.15 %/m; idle <= 0.01 %/s; drain <= 0.3 %/s; charge >= 0.4 %/s at home; held <= 60 s; detour <= 5 m; }
)";
  hall.walls += R"(; recover go_home; }
monitor charge for r : Rover { "SR-3: home" always r.battery >= energy_to(home) + 5 %)";
  hall.priority = "quiet > walls > charge";
  const Outcome o = verified(text_of(hall), {"-o", "certificates"});
  ASSERT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(rechecked().status, exit_clean);
  // another recovery may end where it matters
  const Outcome other = verified(edited(text_of(hall), "in\" always r inside room; recover go_home",
                                        "in\" always r inside room; recover back_off"),
                                 {"--attack", "1", "--format", "json"});
  EXPECT_EQ(statuses(other.out, "switching", ""), Statuses{"unknown"}) << other.out;
}

// Whose recovery is another one is taken over from.
TEST_F(Leaving, OfOthersIsAMatterOfPriority) {
  for (const std::string back : {"back_off", "stop"}) {
    Hall hall;
    hall.back = back;
    if (back == "stop") hall.back += R"(; hold when violated "somebody looks")";
    const Outcome o = verified(text_of(hall), {"--format", "json", "-o", "certificates"});
    bool found = false;
    const Json report = Json::parse(o.out);
    for (const Json& each : report["decisions"][0]["obligations"]) {
      if (each["obligation"] != "C" || each["recovery"] != back) continue;
      found = true;
      EXPECT_EQ(each["status"], "proved") << each;
      EXPECT_EQ(each["claims"].back()["claim"], "outranks") << each;
    }
    EXPECT_TRUE(found) << o.out;
    EXPECT_EQ(statuses(o.out, "P2a", "quiet"), Statuses{"proved"});
    // it may let go where the other one does not, and the two may take over from each other
    EXPECT_EQ(statuses(o.out, "switching", ""), Statuses{"unknown"}) << o.out;
    const Outcome again = rechecked();
    EXPECT_EQ(again.status, exit_inconclusive) << back << again.out << again.err;
  }
}

TEST_F(Leaving, AMutatedNumberIsNoticed) {
  prove({});
  deny_number("leave_us", -130'000'000, "may take longer to lead out");
  deny_number("starts_mm", -100, "from some places it may know no way");
  deny_number("starts_mm", -1'000, "leaves no room for the body");
  deny_number("route_mm", -800, "keep more clear than it says");
  deny_number("route_mm", 300, "from some places it may know no way");
  deny_number("route_mm", 1'100, "the site is too near");
  deny_number("cell_mm", -10, "cells are not those of the zone");
  deny_number("cells_x_mm", 100, "cells are not those of the zone");
  deny_number("cell_mm", 10, "cells are not those of the zone");
}
TEST_F(Leaving, AMutatedNumberOfWheelsIsNoticed) {
  prove(of_wheels());
  deny_number("leave_us", -250'000'000, "may take longer to lead out");
  deny_number("route_mm", 150, "from some places it may know no way");
}

// Sources beside the certificate in which it is not so.
TEST_F(Leaving, ChangedSourcesAreNoticed) {
  prove({});
  const std::string leads = "route to home within room speed 0.3";
  deny_source(leads, "route to home within west speed 0.3", "no way within that zone");
  deny_source(leads, "route to home within room speed 0.03", "may take longer to lead out");
  deny_source("site home = (1.6 m", "site home = (4.2 m", "the site does not see it");
  deny_source("rectangle (5 m, 0 m) to (8 m, 4 m) during",
              "rectangle (5 m, 0.3 m) to (8 m, 4 m) during", "the site does not see it");
  deny_source("rectangle (5 m, 0 m) to (8 m, 4 m) during", "circle (6 m, 2 m) radius 1 m during",
              "the site does not see it");
  deny_source("always r inside room", "always r.speed <= 1 m/s", "nothing keeps the robot in");
  deny_source("fleet rover : Rover", "fleet rover, other : Rover", "other robots");
  deny_source("r, lessons) >= 30 cm", "r, lessons) >= 30 cm or r.speed <= 0.1 m/s",
              "more than one limit");
}
TEST_F(Leaving, ChangedGatesAreNoticed) {
  prove(of_gate());
  deny_source("zone gate = rectangle (4 m", "zone gate = rectangle (4.95 m",
              "a body may be in none of its zones");
  deny_source("r inside west or", "clearance(r, west) >= 1 m or", "");
}
TEST_F(Leaving, AHigherRecoveryIsNoticed) {
  Hall hall;
  hall.back = "back_off";
  verified(text_of(hall), {"-o", "certificates"});
  source_ = read("certificates/sources/spec.rta");
  // `back_off` does not take over any more, whatever else is said
  deny_source("priority quiet > walls", "priority walls > quiet", "it does not rank higher");
}

TEST_F(Leaving, AProofThatLeavesOutTheClaimIsNoticed) {
  prove({});
  for (const char* const kind : {"P2a", "C"}) {
    Json report = report_;
    for (Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] != kind || o["monitor"] != "quiet") continue;
      Json& claims = o["claims"];
      for (std::size_t k = claims.size(); k-- > 0;) {
        if (claims[k]["claim"] == "leaves") claims.erase(k);
      }
    }
    write("certificates/verification.json", report.dump());
    expect_denied("it rests on no claim `leaves`");
  }
  // of another monitor, it is none of this one
  Json report = report_;
  for (Json& o : report["decisions"][0]["obligations"]) {
    for (Json& c : o["claims"]) {
      if (c["claim"] == "leaves") c["monitor"] = "walls";
    }
  }
  write("certificates/verification.json", report.dump());
  expect_denied("speaks of no zone that comes and goes");
}

TEST_F(Leaving, WhatIsNotShownStaysUnknown) {
  Hall hall;
  hall.room = "polygon [(0 m, 0 m), (8 m, 0 m), (7.5 m, 4 m), (0 m, 4 m)]";
  expect_unknown(hall, "`room` is none");
  hall = {};
  hall.fleet = "fleet a, b : Rover;";
  expect_unknown(hall, "ways lead round other robots that are near");
  hall = {};
  hall.walls = "r.speed <= 1 m/s";
  expect_unknown(hall, "nothing keeps the robot in `room`");
  hall = {};
  hall.quiet = "distance(r, lessons) >= 30 cm or r.speed <= 0.5 m/s";
  expect_unknown(hall, "more than one limit at a time");
  hall = {};
  hall.lessons = "rectangle (5 m, 2.4 m) to (8 m, 4 m)";
  hall.home = "(1.6 m, 1.7 m)";
  expect_unknown(hall, "`home` is not ");
  hall = {};  // from (7.3 m, 3.76 m) a way leads past the corner at (7 m, 4 m), nearer to it
  hall.lessons = "rectangle (2 m, 4 m) to (7 m, 6 m)";
  expect_unknown(hall, "so that ways may lead past it, and nearer");
}

// Control may be given back beside the wall, where the other recovery has to go on: that it is not
// is offered, with the least clearance that is enough, and proved with it.
TEST_F(Leaving, ALaterReturnThatEndsTheTurnsIsOffered) {
  Hall hall;
  hall.back = "back_off";
  const auto repair_of = [](const Outcome& o) {
    const Json report = Json::parse(o.out);
    for (const Json& each : report["decisions"][0]["obligations"]) {
      if (each["obligation"] == "switching") return each.value("repair", "");
    }
    return std::string();
  };
  const Outcome o = verified(text_of(hall), {"--format", "json"});
  EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "switching", ""), Statuses{"unknown"}) << o.out;
  const std::string repair = repair_of(o), before = "`return when clearance(r, room) >= ";
  ASSERT_EQ(repair.substr(0, before.size()), before);
  EXPECT_NE(repair.find(" m;` in `quiet` works"), std::string::npos) << repair;
  const double least_mm = 1000 * std::stod(repair.substr(before.size()));
  const auto returns_at = [&](double mm) {
    return edited(text_of(hall), "recover go_home; }",
                  "recover go_home; return when clearance(r, room) >= " +
                      std::to_string(std::lround(mm)) + " mm; }");
  };
  const Outcome works = verified(returns_at(least_mm), {"-o", "certificates"});
  EXPECT_EQ(works.status, exit_clean) << works.out << works.err;
  EXPECT_EQ(rechecked().status, exit_clean);
  const Outcome less = verified(returns_at(least_mm - 1), {"--format", "json"});
  EXPECT_EQ(statuses(less.out, "switching", ""), Statuses{"unknown"}) << less.out;
}

}  // namespace
}  // namespace rtac::driver::test
