// What is printed as a repair has the obligation proved that it is printed for, and five per cent
// beyond it does not.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

class Repaired : public Verify {
 protected:
  // The repair of an obligation; "": it has none.
  static std::string repair_of(const std::string& text, const std::string& kind,
                               const std::string& monitor) {
    const Json report = Json::parse(verified(text, {"--format", "json"}).out);
    for (const Json& d : report["decisions"]) {
      for (const Json& o : d["obligations"]) {
        if (o["obligation"] == kind && o.value("monitor", "") == monitor &&
            o["status"] != "proved") {
          return o.value("repair", "");
        }
      }
    }
    return "";
  }
  static bool proved(const std::string& text, const std::string& kind, const std::string& monitor) {
    return statuses(verified(text, {"--format", "json"}).out, kind, monitor) ==
           std::vector<std::string>{"proved"};
  }
  // "0.077" of "an `error` of the position of at most 0.077 m works"
  static double number_after(const std::string& repair, const std::string& what) {
    const std::size_t at = repair.find(what);
    if (at == std::string::npos) {
      ADD_FAILURE() << "no `" << what << "` in " << repair;
      return 0;
    }
    return std::stod(repair.substr(at + what.size()));
  }
};

std::string cage(const std::string& error) {
  return R"(spec noisy;
zone cage = prism (rectangle (0 m, 0 m) to (4 m, 4 m)) from 0 m to 3 m;
robot Quad {
  body    radius 30 cm;
  motion  point { speed <= 2 m/s; accel <= 3 m/s^2; brake >= 3 m/s^2; }
  sense   position : point3  error )" +
         error + R"( m max_age 50 ms;
  sense   velocity : vector3 error 5 cm/s max_age 50 ms;
  output  thrust : acceleration;
  latency 30 ms;
}
fleet q : Quad;
controller scan : advanced for Quad extern;
controller back : safe for Quad = retreat within cage speed 0.4 m/s;
monitor fence for r : Quad { "R1" always r inside cage; recover back; }
decision fly for Quad { advanced scan; period 50 ms; priority fence; }
)";
}

// With less error there is a place to return to, and with still less it is led to.
TEST_F(Repaired, AnErrorIsSoSmallThatWaysBackAreShown) {
  const double most =
      number_after(repair_of(cage("0.25"), "P2b", "fence"), "`error` of the position of at most ");
  EXPECT_TRUE(proved(cage(std::to_string(most)), "P2b", "fence")) << most;
  EXPECT_FALSE(proved(cage(std::to_string(1.05 * most)), "P2b", "fence")) << most;
}

std::string around(const std::string& off) {
  return R"(spec around;
zone hall = rectangle (0 m, 0 m) to (6 m, 6 m);
zone pit  = circle (3 m, 3 m) radius 1 m;
zone ring = hall - pit;
robot Bot {
  body    radius 15 cm;
  motion  point { speed <= 0.4 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 1 cm   max_age 50 ms;
  sense   velocity : vector error 1 cm/s max_age 50 ms;
  output  thrust : acceleration;
  latency 30 ms;
}
fleet b : Bot;
controller go : advanced for Bot extern;
controller back : safe for Bot = retreat within ring speed 0.2 m/s;
monitor off for r : Bot { "R1" always clearance(r, ring) >= )" +
         off + R"( mm; recover back; }
decision drive for Bot { advanced go; period 50 ms; priority off; }
)";
}

// Where a ring is too narrow to be driven round, less distance that is kept works.
TEST_F(Repaired, AClearanceIsSoSmallThatWaysLeadRound) {
  const double most =
      number_after(repair_of(around("850"), "P2b", "off"), "a clearance of at most ");
  const auto asked = [](double m) { return around(std::to_string(std::lround(1000 * m))); };
  EXPECT_TRUE(proved(asked(most), "P2b", "off")) << most;
  EXPECT_FALSE(proved(asked(1.05 * most), "P2b", "off")) << most;
}

std::string two_rooms(const std::string& grown) {
  return R"(spec rooms;
zone plan = rectangle (0 m, 0 m) to (4 m, 4 m) | rectangle (4 m, 1.5 m) to (10 m, 2.6 m) | rectangle (10 m, 0 m) to (14 m, 4 m);
zone rooms = )" +
         grown + R"(;
robot Bot {
  body    radius 40 cm;
  motion  point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1.2 m/s^2; }
  sense   position : point  error 2 cm   max_age 100 ms;
  sense   velocity : vector error 2 cm/s max_age 100 ms;
  output  push : acceleration;
  latency 50 ms;
}
fleet bot : Bot;
controller run  : advanced for Bot extern;
controller back : safe for Bot = retreat within rooms speed 0.3 m/s;
monitor walls for r : Bot { "R1" always r inside rooms; recover back; }
decision drive for Bot { advanced run; period 100 ms; priority walls; }
)";
}

// Between two rooms there is a corridor that a retreat finds no way out of: it is told how wide it
// would have to be, though a few cells of it are all that is not led back from.
TEST_F(Repaired, ACorridorIsSoWideThatControlIsGivenBackAllAlong) {
  const std::string repair = repair_of(two_rooms("plan"), "P2b", "walls");
  const double by = number_after(repair, "`grow(rooms, ");
  const auto grown = [](double m) { return two_rooms("grow(plan, " + std::to_string(m) + " m)"); };
  EXPECT_TRUE(proved(grown(by), "P2b", "walls")) << by;
  const auto narrow = [&](double m) {
    return verified(grown(m), {}).err.find("control is never given back") != std::string::npos;
  };
  EXPECT_FALSE(narrow(by)) << by;
  EXPECT_TRUE(narrow(0.95 * by)) << by;
}

// A passage that is wide enough, of which cells show too little: nothing is refuted, and there is a
// number all the same.
std::string round_a_gate(const std::string& hall, const std::string& velocity) {
  return R"(spec gate;
zone plan = rectangle (0 m, 0 m) to (12 m, 12 m) - rectangle (5 m, 0 m) to (7 m, 10.2 m);
zone hall = )" +
         hall + R"(;
robot Bot {
  body    radius 25 cm;
  motion  point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 2 cm max_age 80 ms;
  sense   velocity : vector error 2 cm/s max_age )" +
         velocity + R"( ms;
  output  push : acceleration;
  latency 30 ms;
}
fleet b : Bot;
controller run  : advanced for Bot extern;
controller back : safe for Bot = retreat within hall speed 0.3 m/s;
monitor walls for r : Bot { "R1" always r inside hall; recover back; }
decision drive for Bot { advanced run; period 100 ms; priority walls; }
)";
}
TEST_F(Repaired, APassageOfWhichCellsShowTooLittleIsTold) {
  const std::string repair = repair_of(round_a_gate("plan", "80"), "P2b", "walls");
  const double by = number_after(repair, "`grow(hall, ");
  const auto grown = [](double m) {
    return round_a_gate("grow(plan, " + std::to_string(m) + " m)", "80");
  };
  EXPECT_TRUE(proved(grown(by), "P2b", "walls")) << by;
  EXPECT_FALSE(proved(grown(0.95 * by), "P2b", "walls")) << by;
  const double age = number_after(repair, "`max_age` of the velocity of at most ");
  EXPECT_TRUE(proved(round_a_gate("plan", std::to_string(age)), "P2b", "walls")) << age;
  EXPECT_FALSE(proved(round_a_gate("plan", std::to_string(1.05 * age)), "P2b", "walls")) << age;
}
// Numbers that mend an error, after which the same passage is too narrow.
TEST_F(Repaired, ANumberThatLeavesSomethingOpenSaysSo) {
  std::string slow = round_a_gate("plan", "200");
  for (const auto& [was, is] : std::vector<std::pair<std::string, std::string>>{
           {"radius 25 cm", "radius 35 cm"},
           {"speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2",
            "speed <= 1.5 m/s; accel <= 0.7 m/s^2; brake >= 0.7 m/s^2"},
           {"error 2 cm max_age 80 ms", "error 5 cm max_age 200 ms"},
           {"error 2 cm/s", "error 8 cm/s"},
           {"latency 30 ms", "latency 100 ms"}}) {
    slow = edited(slow, was, is);
  }
  const std::string repair = repair_of(slow, "P2b", "walls");
  EXPECT_NE(repair.find(" (which leaves P2b open)"), std::string::npos) << repair;
}

// Before another order, after which recoveries may take turns.
TEST_F(Repaired, ARecoveryStaysWithinTheHeightsThatAreAllowed) {
  const auto orchard = [](const std::string& limit, const std::string& order) {
    return R"(spec orchard;
zone orchard = prism (rectangle (0 m, 0 m) to (60 m, 40 m)) from 0 m to 40 m;
robot Quad {
  body    radius 30 cm;
  motion  point { speed <= 3 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense   position : point3  error 5 cm   max_age 50 ms;
  sense   velocity : vector3 error 5 cm/s max_age 50 ms;
  output  thrust : acceleration;
  latency 20 ms;
}
fleet q : Quad;
controller go   : advanced for Quad extern;
controller back : safe for Quad = retreat within orchard speed 0.6 m/s;
controller down : safe for Quad = land to 8 m speed 0.5 m/s;
monitor walls for r : Quad { "R1" always r inside orchard; recover back; }
monitor roof  for r : Quad { "R2" always )" +
           limit + R"(; recover down; return when r.position.z <= 19 m; }
decision fly for Quad { advanced go; period 50 ms; priority )" +
           order + "; }\n";
  };
  const std::string limit = "r.position.z <= 20.5 m";
  const std::string as_declared = orchard(limit, "walls > roof");
  const std::string repair = repair_of(as_declared, "C", "roof");
  const std::string zone =
      "orchard & prism (rectangle (0 m, 0 m) to (60 m, 40 m)) from 0 m to 20.5 m";
  EXPECT_EQ(repair.find("a recovery within a zone that is `" + zone + "` works"), 0U) << repair;
  std::string mended = edited(as_declared, "retreat within orchard", "retreat within low");
  mended = edited(mended, "robot Quad", "zone low = " + zone + ";\nrobot Quad");
  EXPECT_EQ(verified(mended, {}).status, exit_clean);
  // higher than that it is open, as what is asked for before control returns may lead higher
  const std::string higher = edited(mended, "to 20.5 m;\nrobot", "to 21.5 m;\nrobot");
  EXPECT_EQ(repair_of(higher, "C", "roof").find("a recovery within a zone that is `"), 0U);
}

// Two overlapping zones of a cart.
std::string overlapping(const std::string& back, const std::string& rest) {
  return R"(spec overlapping;
zone hall = rectangle (0 m, 0 m) to (24 m, 14 m);
zone lane = rectangle (2 m, 1 m) to (22 m, 5 m);
robot Cart {
  body    radius 30 cm;
  motion  point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 2 cm   max_age 80 ms;
  sense   velocity : vector error 2 cm/s max_age 80 ms;
  output  push : acceleration;
  latency 30 ms;
}
fleet c : Cart;
controller go   : advanced for Cart extern;
controller back : safe for Cart = retreat within )" +
         back + R"( speed 0.3 m/s;
controller in_lane : safe for Cart = retreat within lane speed 0.3 m/s;
)" + rest;
}
TEST_F(Repaired, TurnsEndWithTheRecoveryOfAnotherMonitor) {
  const auto page = [](const std::string& recovery) {
    return overlapping("hall", R"(
monitor walls for r : Cart { "R1" always r inside hall; recover )" +
                                   recovery + R"(; return when clearance(r, hall) >= 1.5 m; }
monitor keep  for r : Cart { "R2" always r inside lane; recover in_lane; }
decision drive for Cart { advanced go; period 100 ms; priority keep > walls; }
)");
  };
  EXPECT_EQ(repair_of(page("back"), "switching", ""), "`recover in_lane;` in `walls` works");
  EXPECT_EQ(verified(page("in_lane"), {}).status, exit_clean);
}
TEST_F(Repaired, AReturnAsksForSoMuchClearanceThatThereIsAPlaceForAll) {
  const auto page = [](const std::string& clearance) {
    return overlapping("hall", R"(
monitor walls for r : Cart { "R1" always r inside hall; recover back; return when clearance(r, hall) >= )" +
                                   clearance + R"( mm; }
monitor keep  for r : Cart { "R2" always r inside lane; recover in_lane; }
decision drive for Cart { advanced go; period 100 ms; priority keep > walls; }
)");
  };
  const double most =
      number_after(repair_of(page("6000"), "joint return", ""), "`clearance(r, hall) >= ");
  EXPECT_GT(most, 3);
  EXPECT_TRUE(proved(page(std::to_string(std::lround(1000 * most))), "joint return", ""));
  EXPECT_FALSE(proved(page(std::to_string(std::lround(1050 * most))), "joint return", ""));
}

// A limit of speed stops a recovery again and again, and it lets go too soon besides.
TEST_F(Repaired, ASlowerRecoveryAndALaterReturnEndTurnsTogether) {
  const auto page = [](const std::string& speed, const std::string& called) {
    return R"(spec recall;
zone yard   = rectangle (0 m, 0 m) to (24 m, 12 m);
zone kids   = rectangle (10 m, 3 m) to (14 m, 9 m);
zone garage = rectangle (0 m, 0 m) to (5 m, 12 m);
input recall : bool max_age 500 ms;
robot Bot {
  body    radius 25 cm;
  motion  point { speed <= 1.5 m/s; accel <= 1.5 m/s^2; brake >= 1.5 m/s^2; }
  sense   position : point  error 2 cm   max_age 80 ms;
  sense   velocity : vector error 2 cm/s max_age 80 ms;
  output  push : acceleration;
  latency 30 ms;
}
fleet b : Bot;
controller go   : advanced for Bot extern;
controller home : safe for Bot = retreat within garage speed )" +
           speed + R"(m/s;
controller stop : safe for Bot = brake_and_hold;
controller back : safe for Bot = retreat within yard speed 0.3 m/s;
monitor called for r : Bot { "R1" always recall implies r inside garage; recover home; )" +
           called + R"( }
monitor gentle for r : Bot { "R2" always distance(r, kids) <= 1 m implies r.speed <= 0.6 m/s; recover stop; }
monitor fence  for r : Bot { "R3" always r inside yard; recover back; }
decision drive for Bot { advanced go; period 50 ms; priority gentle > called > fence; }
)";
  };
  const std::string repair = repair_of(page("0.8 ", ""), "switching", "");
  const double speed = number_after(repair, "a speed of `home` of ");
  const double gap = number_after(repair, "`return when clearance(r, yard) >= ");
  EXPECT_NE(repair.find(" work, together"), std::string::npos) << repair;
  const auto works = [&](double by_speed, double by_gap) {
    const auto milli = [](double m) { return std::to_string(std::lround(1000 * m)) + " m"; };
    return proved(page(milli(by_speed * speed),
                       "return when clearance(r, yard) >= " + milli(by_gap * gap) + "m;"),
                  "switching", "");
  };
  EXPECT_TRUE(works(1, 1)) << repair;
  EXPECT_FALSE(works(1.05, 1)) << repair;
  EXPECT_FALSE(works(1, 0.95)) << repair;
}

// What leads up again while a storm asks to be low stays below that.
TEST_F(Repaired, ARecoveryThatTakesTurnsIsOfferedALayer) {
  const auto page = [](const std::string& zone) {
    return R"(spec storm;
zone air = prism (rectangle (0 m, 0 m) to (40 m, 40 m)) from 0 m to 30 m;
zone low = air & prism (rectangle (0 m, 0 m) to (40 m, 40 m)) from 0 m to 8 m;
input storm : bool max_age 500 ms;
robot Quad {
  body    radius 30 cm;
  motion  point { speed <= 3 m/s; accel <= 2.5 m/s^2; brake >= 2.5 m/s^2; }
  sense   position : point3  error 5 cm   max_age 50 ms;
  sense   velocity : vector3 error 5 cm/s max_age 50 ms;
  output  thrust : acceleration;
  latency 30 ms;
}
fleet q : Quad;
controller go   : advanced for Quad extern;
controller down : safe for Quad = land to 2 m speed 0.5 m/s;
controller back : safe for Quad = retreat within )" +
           zone + R"( speed 0.6 m/s;
monitor gale  for r : Quad { "R1" always storm implies r.position.z <= 8 m; recover down; }
monitor walls for r : Quad { "R2" always r inside air; recover back; }
decision fly for Quad { advanced go; period 50 ms; priority gale > walls; }
)";
  };
  const std::string repair = repair_of(page("air"), "switching", "");
  EXPECT_EQ(repair,
            "`back` within a zone that is `air & prism (rectangle (0 m, 0 m) to (40 m, 40 m)) from "
            "0 m to 8 m` works");
  EXPECT_TRUE(proved(page("low"), "switching", ""));
}

// Two carts at one plug, where a charge takes far longer than one is said to wait for the other.
TEST_F(Repaired, WhoWaitsForOthersToChargeIsToldHowLongThatMayTake) {
  ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  const auto page = [](const std::string& held) {
    return R"(spec plug;
zone hall = rectangle (0 m, 0 m) to (16 m, 10 m);
site plug = (4 m, 5 m);
robot Bot {
  body    radius 25 cm;
  motion  point { speed <= 0.8 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 2 cm   max_age 80 ms;
  sense   velocity : vector error 2 cm/s max_age 80 ms;
  sense   battery  : ratio  error 1 %    max_age 2 s;
  hears   other robots max_age 150 ms;
  output  push : acceleration;
  latency 30 ms;
  energy  { drive <= 0.2 %/m; idle <= 0.01 %/s; drain <= 0.1 %/s; charge >= 0.05 %/s at plug; held <= )" +
           held + R"( s; detour <= 20 m; }
}
fleet one, two : Bot;
controller go   : advanced for Bot extern;
controller way  : safe for Bot = yield within hall speed 0.3 m/s order id;
controller home : safe for Bot = route to plug within hall speed 0.4 m/s;
monitor apart  for r : Bot { "R1" always forall q : Bot, q != r : distance(r, q) >= 20 cm; recover way; hold when violated "staff"; }
monitor charge for r : Bot { "R2" always r.battery >= energy_to(plug) + 8 %; recover home; return when r.battery >= 60 %; }
monitor fence  for r : Bot { "R3" always r inside hall; recover home; }
decision drive for Bot { advanced go; period 100 ms; priority charge > apart > fence; }
)";
  };
  const std::string repair = repair_of(page("120"), "P2a", "charge");
  // from nothing to 60 %, of the other one
  EXPECT_EQ(repair, "`held <= 1200 s` in `Bot` works: no run under attack has made `charge` fail");
  EXPECT_EQ(statuses(verified(page("1200"), {"--format", "json"}).out, "P2a", "charge"),
            Statuses{"acknowledged"});
}

// Where each recovery ends its own condition holds; no place is in both zones.
TEST_F(Repaired, ARecoveryIsOfferedTheZoneThatItsReturnAsksFor) {
  const auto page = [](const std::string& west) {
    return R"(spec lines;
zone plant = rectangle (0 m, 0 m) to (16 m, 8 m);
zone west  = rectangle (0 m, 0 m) to (7 m, 8 m);
zone east  = rectangle (8 m, 0 m) to (16 m, 8 m);
robot Bot {
  body    radius 30 cm;
  motion  point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 2 cm   max_age 80 ms;
  sense   velocity : vector error 2 cm/s max_age 80 ms;
  output  push : acceleration;
  latency 30 ms;
}
fleet b : Bot;
controller go   : advanced for Bot extern;
controller back : safe for Bot = retreat within )" +
           west + R"( speed 0.3 m/s;
controller slow : safe for Bot = retreat within plant speed 0.3 m/s;
monitor fence for r : Bot { "R1" always r inside plant; recover back; return when clearance(r, west) >= 50 cm; }
monitor calm  for r : Bot { "R2" always r.speed <= 0.8 m/s; recover slow; return when clearance(r, east) >= 50 cm; }
decision drive for Bot { advanced go; period 100 ms; priority fence > calm; }
)";
  };
  EXPECT_EQ(repair_of(page("plant"), "P2b", "fence"), "`within west` in `back` works");
  EXPECT_TRUE(proved(page("west"), "P2b", "fence"));
  EXPECT_EQ(repair_of(page("plant"), "joint return", ""),
            "`west` and `east` have nothing in common: conditions that can be so at one place are "
            "needed");
}

// An order that works is in the report; one that only breaks another pair is nowhere.
TEST_F(Repaired, AnOrderIsOfferedThatMovesNothing) {
  const auto high = [](const std::string& order) {
    return R"(spec ceiling;
zone volume = prism (rectangle (0 m, 0 m) to (40 m, 30 m)) from 0 m to 30 m |
              prism (rectangle (0 m, 0 m) to (40 m, 28 m)) from 30 m to 50 m;
robot Quad {
  body    radius 30 cm;
  motion  point { speed <= 4 m/s; accel <= 3 m/s^2; brake >= 3 m/s^2; }
  sense   position : point3  error 8 cm   max_age 50 ms;
  sense   velocity : vector3 error 5 cm/s max_age 50 ms;
  output  thrust : acceleration;
  latency 30 ms;
}
fleet q : Quad;
controller go   : advanced for Quad extern;
controller stop : safe for Quad = brake_and_hold;
controller back : safe for Quad = retreat within volume speed 0.6 m/s;
monitor fence for r : Quad { "R1" always r inside volume; recover back; }
monitor low   for r : Quad { "R2" always r.position.z >= 3 m; recover stop; hold when violated "the pilot climbs"; }
decision fly for Quad { advanced go; period 50 ms; priority )" +
           order + "; }\n";
  };
  EXPECT_NE(repair_of(high("fence > low"), "C", "low").find("`priority low > fence;` works"),
            std::string::npos);
  EXPECT_TRUE(proved(high("low > fence"), "C", "low"));
}
TEST_F(Repaired, AnOrderThatBreaksAnotherPairIsNotOffered) {
  const std::string starves = R"(spec starves;
zone hall = rectangle (0 m, 0 m) to (20 m, 12 m);
site dock = (3 m, 6 m);
robot Cart {
  body    radius 30 cm;
  motion  point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 2 cm   max_age 50 ms;
  sense   velocity : vector error 2 cm/s max_age 50 ms;
  sense   battery  : ratio  error 1 %    max_age 5 s;
  output  thrust : acceleration;
  latency 30 ms;
  energy  { drive <= 0.3 %/m; idle <= 0.02 %/s; drain <= 0.4 %/s; charge >= 0.5 %/s at dock; held <= 60 s; detour <= 5 m; }
}
fleet c : Cart;
agent people[2] : radius 30 cm, speed <= 1.6 m/s error 10 cm max_age 200 ms, present;
controller go   : advanced for Cart extern;
controller stop : safe for Cart = brake_and_hold;
controller home : safe for Cart = route to dock within hall speed 0.4 m/s;
monitor people_off for r : Cart { "R1" always forall p : people : distance(r, p) >= 40 cm; recover stop; }
monitor walls  for r : Cart { "R2" always r inside hall; recover home; }
monitor charge for r : Cart { "R3" always r.battery >= energy_to(dock) + 10 %; recover home; return when r.battery >= 85 %; }
decision drive for Cart { advanced go; period 100 ms; priority people_off > walls > charge;
  acknowledge stop may break people_off "who walks up to it sees it"; }
)";
  const std::string repair = repair_of(starves, "C", "charge");
  EXPECT_EQ(repair.find("priority"), std::string::npos) << repair;
}

// Where one error leaves nothing of which anything could be shown, the numbers of the others are
// offered as their reports have them, and with all of them it is proved.
TEST_F(Repaired, OfErrorsThatLeaveNothingToShowEachGetsItsNumber) {
  const std::string text = R"(spec lift;
zone yard = rectangle (0 m, 0 m) to (30 m, 12 m);
robot Lift {
  body     radius 1.2 m;
  motion   unicycle { speed <= 2 m/s; turn <= 1 rad/s; accel <= 1 m/s^2; brake >= 1.5 m/s^2; turn_accel <= 2 rad/s^2; }
  sense    position : point   error 5 cm   max_age 100 ms;
  sense    heading  : angle   error 1 deg  max_age 100 ms;
  sense    velocity : vector  error 3 cm/s max_age 100 ms;
  output   drive : twist;
  latency  60 ms;
}
fleet lift : Lift;
controller auto : advanced for Lift extern;
controller back : safe for Lift = retreat within yard speed 0.25 m/s;
monitor walls for l : Lift { "SR-1: in" always l inside yard; recover back; }
decision guard for Lift { advanced auto; period 50 ms; priority walls; }
)";
  const std::string steered = repair_of(text, "P2a", "walls"),
                    timely = repair_of(text, "P1a", "walls");
  const double error = number_after(steered, "an `error` of the position of at most ");
  EXPECT_NE(timely.find("`ahead 60 ms` works"), std::string::npos) << timely;
  const auto with = [&](double m) {
    return edited(edited(text, "error 5 cm ", "error " + std::to_string(m) + " m "),
                  "always l inside yard;", "always l inside yard; ahead 60 ms;");
  };
  EXPECT_TRUE(proved(with(error), "P2a", "walls")) << steered;
  EXPECT_TRUE(proved(with(error), "P1a", "walls")) << timely;
  EXPECT_FALSE(proved(with(1.05 * error), "P2a", "walls")) << steered;
}

}  // namespace
}  // namespace rtac::driver::test
