// Properties with `or`: a recovery keeps one where a side of it always holds, and gives control
// back where one holds at rest. What is proved is found once more, and what is not true is denied.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

// A cart in a hall, which holds one property and recovers with `back` or `stop`.
std::string hall_with(const std::string& monitor, const std::string& zones = "",
                      const std::string& back = "retreat within hall speed 0.2 m/s") {
  return "spec hall;\nzone hall = rectangle (0 m, 0 m) to (16 m, 10 m);\n" + zones + R"(
robot Cart {
  body radius 0.3 m;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 100 ms;
  sense velocity : vector error 2 cm/s max_age 100 ms;
  hears other robots max_age 100 ms;
  output push : acceleration;
  latency 20 ms;
}
fleet a, b : Cart;
controller pilot : advanced for Cart extern;
controller stop  : safe for Cart = brake_and_hold;
controller back  : safe for Cart = )" +
         back + ";\nmonitor m for r : Cart { \"R1: m\" " + monitor +
         " }\ndecision go for Cart { advanced pilot; period 100 ms; priority m; }\n";
}
const std::string west = "zone west = rectangle (0 m, 0 m) to (8 m, 10 m);\n";
std::string east_from(const std::string& x) {
  return west + "zone east = rectangle (" + x + ", 0 m) to (16 m, 10 m);\n";
}
const char* const on_a_side = "always r inside west or r inside east; recover back;";
const std::string kids = "zone kids = rectangle (7 m, 4 m) to (9 m, 6 m);\n";

class Sides : public Verify {
 protected:
  // Proved, and found once more.
  static void expect_proved(const std::string& text) {
    const Outcome o = verified(text, {"-o", "certificates"});
    EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
    const Outcome again = recheck_sealed_anew();
    EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
  }
  static std::string status(const std::string& text, const std::string& kind) {
    const Outcome o = verified(text, {"--format", "json", "-o", "certificates"});
    const Statuses all = statuses(o.out, kind, "m");
    return all.size() == 1 ? all.front() : "";
  }
  // What `verify` has written, with the obligation of another status and these claims.
  static Outcome rechecked_as_proved(const std::string& kind, const Json& claims) {
    Json report = Json::parse(read("certificates/verification.json"));
    for (Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] != kind || o.value("monitor", "") != "m") continue;
      o["status"] = "proved";
      o["claims"] = claims;
    }
    write("certificates/verification.json", report.dump());
    return recheck_sealed_anew();
  }
  static Json claims_of(const std::string& kind) {
    const Json report = Json::parse(read("certificates/verification.json"));
    for (const Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] == kind && o.value("monitor", "") == "m") return o["claims"];
    }
    return {};
  }
};

// Every body in the hall lies in the west or in the east, and where it has come to rest one of them
// is as wide as control returns at.
TEST_F(Sides, ZonesThatOverlapEnoughAreKept) {
  expect_proved(hall_with(on_a_side, east_from("6 m")));
  expect_proved(hall_with("always not (r inside west) implies r inside east; recover back;",
                          east_from("6 m")));
}
// A side without a zone, wherever it is written, leaves the others as they are: a robot at rest
// needs no place.
TEST_F(Sides, ASideWithoutAZoneStandsForAllOfAnOr) {
  const std::string east = east_from("6 m");
  for (const char* const sides : {"r.speed <= 0.75 m/s or r inside east or r inside west",
                                  "r inside east or r.speed <= 0.75 m/s or r inside west",
                                  "r inside east or (r inside west or r.speed <= 0.75 m/s)"}) {
    expect_proved(hall_with("always " + std::string(sides) + "; recover back;", east));
  }
  // of zones alone one has to be named, however they are grouped
  for (const char* const sides : {"(r inside hall or r inside east) or r inside west",
                                  "r inside hall or (r inside east or r inside west)"}) {
    const std::string text = hall_with("always " + std::string(sides) + "; recover back;", east);
    ASSERT_EQ(status(text, "satisfiable"), "proved");
    const Outcome o = rechecked_as_proved("satisfiable", Json::array());
    EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
    EXPECT_NE(o.out.find("nothing is said of any side"), std::string::npos) << o.out;
  }
}
// From the east straight into the west: the places of bodies in one of both are convex. Beside a
// corner of them a way might lead out of both.
TEST_F(Sides, AWayFromOneZoneIntoAnotherStaysInOneOfThem) {
  const std::string home = "retreat within west speed 0.2 m/s";
  expect_proved(hall_with(on_a_side, east_from("6 m"), home));
  const Json claims = claims_of("P2a");
  const std::string lower = edited(east_from("6 m"), "(6 m, 0 m)", "(6 m, 1 m)");
  EXPECT_NE(status(hall_with(on_a_side, lower, home), "P2a"), "proved");
  const Outcome kept = rechecked_as_proved("P2a", claims);
  EXPECT_EQ(kept.status, exit_violation) << kept.out << kept.err;
  EXPECT_NE((kept.out + kept.err).find("may lead out of each side"), std::string::npos);
  // the zones are, but no body is in both of them
  EXPECT_NE(status(hall_with(on_a_side, east_from("7.6 m"), home), "P2a"), "proved");
  EXPECT_EQ(rechecked_as_proved("P2a", claims).status, exit_violation);
}
// Who is engaged on the other side has a way to go before the one that is timed begins.
TEST_F(Sides, HowLongAWayTakesIsSaidOfItsOwnZone) {
  const std::string east = east_from("6 m");
  const auto said = [&](const std::string& controller) {
    return verified(hall_with(on_a_side, east, controller)).out;
  };
  EXPECT_NE(said("retreat within west speed 0.2 m/s").find(" s from there"), std::string::npos);
}
// The side of a height is not kept, and need not be by who is slow.
TEST_F(Sides, AHeightOrALimitOfSpeedIsFoundOnceMore) {
  const auto arena = [](const std::string& most) {
    return R"(spec arena;
zone box = prism (rectangle (0 m, 0 m) to (30 m, 20 m)) from 1 m to 15 m;
robot Quad {
  body radius 30 cm;
  motion point { speed <= 3 m/s; accel <= 3 m/s^2; brake >= 3 m/s^2; }
  sense position : point3 error 5 cm max_age 50 ms;
  sense velocity : vector3 error 5 cm/s max_age 50 ms;
  output push : acceleration;
  latency 20 ms;
}
fleet q : Quad;
controller show : advanced for Quad extern;
controller stop : safe for Quad = brake_and_hold;
controller back : safe for Quad = retreat within box speed 0.5 m/s;
monitor cage for r : Quad { "R1" always r inside box; recover back; }
monitor m for r : Quad { "R2" always r.position.z >= 4 m or r.speed <= )" +
           most + R"(; recover stop; }
decision fly for Quad { advanced show; period 50 ms; priority cage > m; }
)";
  };
  expect_proved(arena("1 m/s"));
  write("certificates/sources/spec.rta", arena("0.4 m/s"));
  const Outcome forged = recheck_sealed_anew();
  EXPECT_EQ(forged.status, exit_violation) << forged.out << forged.err;
}
// Two rooms apart, of which nobody leaves one for the other.
TEST_F(Sides, ZonesThatAreApartAreKept) {
  expect_proved(hall_with(on_a_side, east_from("9 m") + "zone rooms = west | east;\n",
                          "retreat within rooms speed 0.2 m/s"));
}
// The middle of the seam is as clear of the walls as can be, and control is never given back there.
// 1.988 m of overlap work; 5 % less do not, and where errors do not help out that is refuted.
TEST_F(Sides, WhereNoZoneIsDeepEnoughControlIsNotGivenBack) {
  EXPECT_EQ(status(hall_with(on_a_side, east_from("6.5 m")), "P2a"), "proved");
  EXPECT_EQ(status(hall_with(on_a_side, east_from("6.5 m")), "P2b"), "refuted");
  EXPECT_EQ(status(hall_with(on_a_side, east_from("6.012 m")), "P2b"), "proved");
  EXPECT_EQ(status(hall_with(on_a_side, east_from("6.111 m")), "P2b"), "unknown");
  EXPECT_EQ(status(hall_with(on_a_side, east_from("8 m")), "P2a"), "unknown");
}
TEST_F(Sides, AnOverlapThatIsTooNarrowIsDenied) {
  expect_proved(hall_with(on_a_side, east_from("6 m")));
  const Json ways = claims_of("P2b"), keeps = claims_of("P2a");
  EXPECT_EQ(status(hall_with(on_a_side, east_from("6.5 m")), "P2b"), "refuted");
  const Outcome returns = rechecked_as_proved("P2b", ways);
  EXPECT_EQ(returns.status, exit_violation) << returns.out << returns.err;
  EXPECT_NE((returns.out + returns.err).find("nothing gives control back"), std::string::npos);
  EXPECT_EQ(status(hall_with(on_a_side, east_from("8 m")), "P2a"), "unknown");
  const Outcome kept = rechecked_as_proved("P2a", keeps);
  EXPECT_EQ(kept.status, exit_violation) << kept.out << kept.err;
  EXPECT_NE((kept.out + kept.err).find("no side of it holds"), std::string::npos) << kept.out;
}

// Near the children it is slow, and so is its recovery, wherever that drives.
TEST_F(Sides, ASlowRecoveryKeepsALimitOfSpeed) {
  const std::string near = "distance(r, kids) >= 50 cm or r.speed <= 0.6 m/s";
  expect_proved(hall_with("always " + near + "; recover back;", kids));
  expect_proved(hall_with("always r inside hall and (" + near + "); recover back;", kids));
  expect_proved(hall_with(
      "always distance(r, kids) <= 50 cm implies r.speed <= 0.6 m/s; recover back;", kids));
  // its own speed with what it overshoots and the error that it is measured with, and no less
  const std::string fast = "retreat within hall speed 0.553 m/s";
  expect_proved(hall_with("always " + near + "; recover back;", kids, fast));
  const Json claims = claims_of("P2a");
  const std::string faster = "retreat within hall speed 0.61 m/s";
  EXPECT_EQ(status(hall_with("always " + near + "; recover back;", kids, faster), "P2a"),
            "unknown");  // it takes a run to refute it
  EXPECT_EQ(rechecked_as_proved("P2a", claims).status, exit_violation);
}
// How slow may depend on inputs, as long as each of their answers is kept; what only some of them
// allow is not.
TEST_F(Sides, ALimitOfSpeedMayDependOnInputs) {
  const std::string inputs = kids +
                             "input guests : int in 0 .. 20 max_age 2 s;\n"
                             "input night : bool max_age 2 s;\n"
                             "fun busy(n : int) : bool = n >= 3;\n";
  const auto near = [&](const std::string& limit) {
    return hall_with("always distance(r, kids) >= 50 cm or (" + limit + "); recover back;", inputs);
  };
  expect_proved(near("if busy(guests) then r.speed <= 0.6 m/s else r.speed <= 0.8 m/s"));
  const Json claims = claims_of("P2a");
  expect_proved(
      near("if night then r.speed <= 0.6 m/s else "
           "if busy(guests) then r.speed <= 0.7 m/s else r.speed <= 0.8 m/s"));
  expect_proved(
      near("(guests <= 5 and r.speed <= 0.6 m/s) or (guests > 5 and r.speed <= 0.8 m/s)"));
  for (const char* const some : {"if busy(guests) then r.speed <= 0.1 m/s else r.speed <= 0.8 m/s",
                                 "(guests >= 3 and r.speed <= 0.6 m/s) or "
                                 "(guests < 2 and r.speed <= 0.8 m/s)"}) {
    EXPECT_NE(status(near(some), "P2a"), "proved") << some;
    EXPECT_EQ(rechecked_as_proved("P2a", claims).status, exit_violation) << some;
  }
}
// From where it is slow enough it would be led faster than that allows.
TEST_F(Sides, WhoIsSlowEnoughElsewhereIsNotLedFaster) {
  const auto page = [&](const std::string& limit) {
    return hall_with("always r inside west or r.speed <= " + limit + " m/s; recover back;", west,
                     "retreat within west speed 0.2 m/s");
  };
  expect_proved(page("0.6"));
  const Json claims = claims_of("P2a");
  EXPECT_EQ(status(page("0.1"), "P2a"), "unknown");  // it takes a run to refute it
  EXPECT_EQ(rechecked_as_proved("P2a", claims).status, exit_violation);
}
// Nor does the recovery of another monitor break it (6005), and the robot is given back by both.
TEST_F(Sides, AnotherRecoveryThatIsSlowKeepsIt) {
  const std::string fence =
      "monitor fence for r : Cart { \"R2: in\" always r inside hall; recover back; }\n";
  std::string text =
      hall_with("always distance(r, kids) >= 50 cm or r.speed <= 0.6 m/s; recover stop;", kids);
  text = edited(text, "decision go", fence + "decision go");
  text = edited(text, "priority m;", "priority fence > m;");
  expect_proved(text);
  const Outcome fast = verified(edited(text, "hall speed 0.2 m/s", "hall speed 0.7 m/s"));
  EXPECT_EQ(fast.status, exit_inconclusive) << fast.out;  // without a run that shows it
  EXPECT_NE(fast.err.find("error[5033]"), std::string::npos) << fast.err;
}
// Who is slow enough at rest is given back wherever the other monitor lets go, nearer to the
// boundary than its own distance.
TEST_F(Sides, WhatIsSlowEnoughAtRestAsksForNoPlaceBesides) {
  std::string text =
      hall_with("always clearance(r, hall) >= 80 cm or r.speed <= 0.6 m/s; recover back;");
  text = edited(text, "decision go",
                "monitor fence for r : Cart { \"R2: in\" always r inside hall; recover back; }\n"
                "decision go");
  expect_proved(edited(text, "priority m;", "priority fence > m;"));
}
// Beside zones, a limit that the recovery keeps everywhere refutes nothing: where it may move is
// what is not shown.
TEST_F(Sides, ALimitThatIsKeptBesideAZoneIsNoMatterOfSpeed) {
  const std::string either =
      "always (r inside west and r.speed <= 0.9 m/s) or (r inside east and r.speed <= 0.8 m/s); "
      "recover back;";
  const std::string text = hall_with(either, east_from("6 m"));
  const Outcome o = verified(text, {"--format", "json"});
  EXPECT_EQ(statuses(o.out, "P2a", "m"), Statuses{"unknown"}) << o.out;
  EXPECT_EQ(o.err.find("5033"), std::string::npos) << o.err;
  const Outcome fast = verified(edited(text, "speed 0.2 m/s", "speed 0.78 m/s"));
  EXPECT_NE(fast.err.find("allows 0.8 m/s"), std::string::npos) << fast.err;
}
TEST_F(Sides, AProofThatLeavesOutTheSidesIsDenied) {
  expect_proved(hall_with(on_a_side, east_from("6 m")));
  Json claims = claims_of("P2a");
  for (std::size_t i = claims.size(); i-- > 0;) {
    if (claims[i]["claim"] == "sides") claims.erase(i);
  }
  EXPECT_EQ(rechecked_as_proved("P2a", claims).status, exit_violation);
}

// A zone that lies in the hall keeps half a metre from its walls where all of it is so far off.
TEST_F(Sides, HowFarAZoneIsOffIsAskedForAndFoundOnceMore) {
  const std::string free = "zone bin = rectangle (8 m, 3 m) to (9 m, 4 m);\nzone free = hall - bin";
  const std::string walls = "always clearance(r, hall) >= 50 cm; recover back;";
  const std::string within = "retreat within free speed 0.2 m/s";
  expect_proved(hall_with(walls, free + " & shrink(hall, 50 cm);\n", within));
  Json claims = claims_of("P2a");
  EXPECT_EQ(rechecked_as_proved("P2a", claims).status, exit_clean);
  for (Json& claim : claims) {
    if (claim.contains("standoff_mm")) claim["standoff_mm"] = "499";
  }
  EXPECT_EQ(rechecked_as_proved("P2a", claims).status, exit_violation);
  // what is claimed of another zone than it is true of
  claims = claims_of("P2a");
  for (Json& claim : claims) {
    if (claim.contains("standoff_mm")) claim["standoff_mm"] = "500";
  }
  const std::string near = hall_with(walls, free + " & shrink(hall, 45 cm);\n", within);
  EXPECT_EQ(status(near, "P2a"), "unknown");
  EXPECT_EQ(rechecked_as_proved("P2a", claims).status, exit_violation);
}

// A robot that has stopped is slow enough, wherever it stands: no reason has to be given. A limit
// that a robot at rest may be seen to exceed before the next decision lets nobody go.
TEST_F(Sides, ABrakeGivesBackWhereToBeSlowIsEnough) {
  expect_proved(
      hall_with("always distance(r, kids) >= 50 cm or r.speed <= 0.6 m/s; recover stop;", kids));
  const std::string slow = "always distance(r, kids) >= 50 cm or r.speed <= 0.4 m/s; recover stop;";
  const Json claims = claims_of("P2b");
  EXPECT_EQ(status(hall_with(slow, kids), "P2b"), "refuted");
  EXPECT_EQ(rechecked_as_proved("P2b", claims).status, exit_violation);
}

// A retreat leads away from walls: two robots that have stopped near each other stay there.
TEST_F(Sides, WhatLeadsAwayFromWallsLeadsAwayFromNobody) {
  const std::string apart =
      "always forall q : Cart, q != r : distance(r, q) >= 50 cm; recover back;";
  expect_proved(hall_with("always r inside hall; recover back;"));
  const Json ways = claims_of("P2b");
  EXPECT_EQ(status(hall_with(apart), "P2b"), "unknown");
  EXPECT_EQ(rechecked_as_proved("P2b", ways).status, exit_violation);
  // that they may wait for each other may be accepted, and the reason is of use
  const Outcome o = verified(hall_with(apart + " hold when violated \"they may wait\";"),
                             {"--format", "json", "-Werror"});
  EXPECT_EQ(statuses(o.out, "P2b", "m"), Statuses{"acknowledged"}) << o.out << o.err;
}

// Limits of height, each with its own monitor and one recovery for all of them.
class Heights : public Sides {
 protected:
  static std::string flight(const std::string& band) {
    return "spec flight;\nzone plot = rectangle (0 m, 0 m) to (80 m, 80 m);\nzone band = " + band +
           R"(;
robot Quad {
  body radius 0.4 m;
  motion point { speed <= 4 m/s; accel <= 3 m/s^2; brake >= 3 m/s^2; disturbance <= 0.3 m/s^2; }
  sense position : point3 error 10 cm max_age 50 ms;
  sense velocity : vector3 error 10 cm/s max_age 50 ms;
  output push : acceleration;
  latency 20 ms;
}
fleet q : Quad;
controller pilot : advanced for Quad extern;
controller back  : safe for Quad = retreat within band speed 1 m/s;
monitor m    for r : Quad { "R1: below 50 m" always r.position.z <= 50 m; recover back; }
monitor low  for r : Quad { "R2: above 3 m" always r.position.z >= 3 m; recover back; }
monitor over for r : Quad { "R3: over the plot" always r inside plot; recover back; }
decision fly for Quad { advanced pilot; period 50 ms; priority m > low > over; }
)";
  }
};
TEST_F(Heights, ARecoveryBetweenThemGivesBackToAll) {
  expect_proved(flight("prism (plot) from 3 m to 50 m"));
  expect_proved(flight("prism (plot) from 5 m to 45 m"));
}
// What is negated is a limit like the other one.
TEST_F(Heights, ANegatedLimitIsOne) {
  const std::string band = flight("prism (plot) from 3 m to 50 m");
  expect_proved(edited(band, "r.position.z >= 3 m", "not r.position.z < 3 m"));
  expect_proved(edited(band, "r.position.z >= 3 m", "r.position.z < 3 m implies r.speed <= 2 m/s"));
}
// In a zone of the plane it keeps its height, and so leads down from nowhere.
TEST_F(Heights, ARecoveryThatKeepsItsHeightDoesNotLeadDown) {
  expect_proved(flight("prism (plot) from 3 m to 50 m"));
  const Json legs = claims_of("P2b");
  EXPECT_EQ(status(flight("rectangle (0 m, 0 m) to (80 m, 80 m)"), "P2b"), "unknown");
  EXPECT_EQ(rechecked_as_proved("P2b", legs).status, exit_violation);
}

}  // namespace
}  // namespace rtac::driver::test
