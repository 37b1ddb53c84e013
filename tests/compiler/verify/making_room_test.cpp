// P2b of robots that make room for each other: of two that hold, one finds a way, where no other
// recovery may drive instead.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

std::string halls_with(const std::string& zone, const std::string& fleet = "a, b",
                       const std::string& property = "distance(r, q) >= 20 cm",
                       const std::string& speed = "0.4 m/s") {
  return "spec halls;\nzone floor = " + zone + R"(;
robot Cart {
  body radius 0.2 m;
  motion point { speed <= )" +
         speed + R"(; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 1 cm max_age 100 ms;
  sense velocity : vector error 1 cm/s max_age 100 ms;
  hears other robots max_age 200 ms;
  output drive : acceleration;
  latency 20 ms;
}
fleet )" +
         fleet +
         R"( : Cart;
controller pilot : advanced for Cart extern;
controller give_way : safe for Cart = yield within floor speed 0.3 m/s order id;
controller back : safe for Cart = retreat within floor speed 0.3 m/s;
monitor apart for r : Cart { "R1: apart" always forall q : Cart, q != r : )" +
         property + R"(; recover give_way; }
monitor fence for r : Cart { "R2: on the floor" always r inside floor; recover back; }
decision go for Cart { advanced pilot; period 100 ms; priority apart > fence; }
)";
}

class MakingRoom : public Verify {
 protected:
  // Of P2b of two robots that keep apart.
  Json room(const std::string& text) {
    const Outcome o = verified(text, {"--format", "json", "-o", "certificates"});
    const Json report = Json::parse(o.out);
    for (const Json& each : report["decisions"][0]["obligations"]) {
      if (each["obligation"] == "P2b" && each["monitor"] == "apart") return each;
    }
    return {};
  }
  std::string because(const std::string& text) {
    const Json found = room(text);
    EXPECT_EQ(found["status"], "unknown") << found;
    return found["because"];
  }
  void expect_noticed();
};

// In a hall one of two robots finds a way out of the other's, which the recheck finds, too. In an
// aisle, and around the corners of a gate, it may not, and that is named.
TEST_F(MakingRoom, OfTwoRobotsOneFindsAWay) {
  const std::string hall = "rectangle (0 m, 0 m) to (6 m, 4 m)";
  for (const char* property : {"distance(r, q) >= 20 cm", "2 * distance(r, q) - 10 cm >= 30 cm"}) {
    const Json found = room(halls_with(hall, "a, b", property));
    EXPECT_EQ(found["status"], "proved") << found;
    const Outcome again = recheck_sealed_anew();
    EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
  }
  const std::string aisle = because(halls_with("rectangle (0 m, 0 m) to (20 m, 2.5 m)"));
  EXPECT_NE(aisle.find("may both find no way to a distance of 1.492 m"), std::string::npos)
      << aisle;
  const std::string gate =
      because(halls_with("rectangle (0 m, 0 m) to (8 m, 8 m) | rectangle (12 m, 0 m) to (20 m, 8 m)"
                         " | rectangle (8 m, 3 m) to (12 m, 5 m)"));
  EXPECT_NE(gate.find("robots that hold near (8."), std::string::npos) << gate;
}
// On a bench that is too small for the distance it says which one is not.
TEST_F(MakingRoom, TheLargestDistanceThatLeavesAWayIsOffered) {
  const auto bench = [](double apart_m) {
    return halls_with("rectangle (0 m, 0 m) to (6 m, 4 m)", "a, b",
                      "distance(r, q) >= " + std::to_string(std::lround(apart_m * 1000)) + " mm");
  };
  const std::string repair = room(bench(3))["repair"];
  const std::string before = "or a distance of at most ", after = " m in `apart` works";
  const std::size_t at = repair.find(before), end = repair.find(after);
  ASSERT_NE(at, std::string::npos) << repair;
  ASSERT_NE(end, std::string::npos) << repair;
  const double most = std::stod(repair.substr(at + before.size()));
  EXPECT_EQ(room(bench(most))["status"], "proved") << repair;
  EXPECT_NE(room(bench(1.05 * most))["status"], "proved") << repair;
}
// Of a rectangle both of its long sides give way.
TEST_F(MakingRoom, TheLeastWidthThatLeavesAWayIsOffered) {
  const auto lane = [](double by_m) {
    const long by_mm = std::lround(by_m * 1000);
    return halls_with("rectangle (0 m, " + std::to_string(-by_mm) + " mm) to (9 m, " +
                      std::to_string(1800 + by_mm) + " mm)");
  };
  const std::string repair = room(lane(0))["repair"];
  const std::string before = "`floor` wider by ", after = " m on both of its long sides, ";
  const std::size_t at = repair.find(before), end = repair.find(after);
  ASSERT_NE(at, std::string::npos) << repair;
  ASSERT_NE(end, std::string::npos) << repair;
  const double least = std::stod(repair.substr(at + before.size()));
  EXPECT_EQ(room(lane(least))["status"], "proved") << repair;
  EXPECT_NE(room(lane(0.95 * least))["status"], "proved") << repair;
  const std::string of_another = room(halls_with(
      "polygon [(0 m, 0 m), (9 m, 0 m), (9 m, 1.8 m), (5 m, 1.9 m), (0 m, 1.8 m)]"))["repair"];
  EXPECT_EQ(of_another.find("wider by"), std::string::npos) << of_another;
}
// Between a wall and a pillar they may stand square to the lane, where neither can come any nearer
// to its side of it: then one of the two leaves along it, whichever way it is off the other.
TEST_F(MakingRoom, OfTwoRobotsBesideAPillarOneFindsAWay) {
  const Json found =
      room(halls_with("rectangle (0 m, 0 m) to (7.4 m, 7.4 m)"
                      " - rectangle (3.2 m, 3.2 m) to (4.2 m, 4.2 m)"));
  EXPECT_EQ(found["status"], "proved") << found;
  const Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}
// A fence that ranks higher leads back from a wall, towards the other robot, and tells nobody that
// it cannot pass.
TEST_F(MakingRoom, WhereAnotherRecoveryMayDriveNothingIsShown) {
  const std::string hall = halls_with("rectangle (0 m, 0 m) to (6 m, 4 m)");
  for (const char* const order : {"priority fence > apart;", "coordinate apart > fence;"}) {
    const std::string other = edited(hall, "priority apart > fence;", order);
    const std::string why = because(other);
    EXPECT_NE(why.find("where `fence` is engaged as well, `back` may drive"), std::string::npos)
        << why;
    // nor is a certificate of the first order believed of the other one
    ASSERT_EQ(room(hall)["status"], "proved");
    write("certificates/sources/spec.rta", other);
    const Outcome again = recheck_sealed_anew();
    EXPECT_NE((again.out + again.err).find("another recovery may drive instead"), std::string::npos)
        << again.out << again.err;
  }
}
// What stands because inputs or agents say so lets both go on when they do, whatever its rank: that
// is no other recovery in the way, of those that coordinate neither. One that stands at a wall is.
class BesideWhoStands : public MakingRoom {
 protected:
  // `alone`: no recovery leads back from the walls, which robots keep by what makes room as well.
  static std::string beside(const std::string& says, const std::string& order = "priority",
                            bool alone = false) {
    std::string hall = halls_with("rectangle (0 m, 0 m) to (6 m, 4 m)");
    if (alone) {
      hall = edited(hall, "recover back;", "recover give_way; hold when violated \"a test\";");
    }
    const bool stands = says.find("inside") != std::string::npos;
    const std::string told =
        "input stop : bool max_age 1 s;\n"
        "agent person : radius 30 cm, speed <= 1 m/s error 2 cm max_age 300 ms;\n"
        "controller halt : safe for Cart = brake_and_hold;\n"
        "monitor told for r : Cart { \"R3: told\" always " +
        says + "; recover halt; " + (stands ? "hold when violated \"a test\"; " : "") + "}\n";
    return edited(edited(hall, "monitor apart", told + "monitor apart"), "priority apart",
                  order + " told > apart");
  }
  void expect_proved(const std::string& text) {
    const Json found = room(text);
    EXPECT_EQ(found["status"], "proved") << found;
    EXPECT_NE(found.value("because", "").find("let them go on: `told`"), std::string::npos)
        << found;
    const Outcome again = recheck_sealed_anew();
    EXPECT_NE(again.out.find(" 0 not proved"), std::string::npos) << again.out << again.err;
  }
  // Nor is a certificate of one that is proved believed of it.
  void expect_in_the_way(const std::string& text, const std::string& monitor,
                         const std::string& recovery) {
    const std::string why = because(text);
    EXPECT_NE(why.find("where `" + monitor + "` is engaged as well, `" + recovery + "` may drive"),
              std::string::npos)
        << why;
    ASSERT_EQ(room(beside("not stop"))["status"], "proved");
    write("certificates/sources/spec.rta", text);
    const Outcome again = recheck_sealed_anew();
    EXPECT_NE((again.out + again.err).find("another recovery may drive instead"), std::string::npos)
        << again.out << again.err;
  }
};
TEST_F(BesideWhoStands, ItIsInTheWayUntilItIsToldOtherwise) {
  expect_proved(beside("not stop"));
  expect_proved(
      edited(beside("distance(r, person) >= 50 cm"), "period 100 ms;",
             "period 100 ms; acknowledge halt may break told \"who walks up to it sees it\";"));
}
TEST_F(BesideWhoStands, ThoseThatCoordinateGoOnAsWell) {
  expect_proved(beside("not stop", "coordinate", true));
}
// It has stopped a robot that others drove too fast, or that may not drive until it is told so.
TEST_F(BesideWhoStands, WhoIsToldToBeSlowIsToldToStand) {
  for (const char* const order : {"priority", "coordinate"}) {
    expect_proved(beside("stop implies r.speed <= 5 cm/s", order, true));
  }
}
// Whatever it is told: nothing lets it go on.
TEST_F(BesideWhoStands, WhoMayNeverDriveIsInTheWay) {
  expect_in_the_way(beside("r.speed <= 5 cm/s", "coordinate", true), "told", "halt");
}
TEST_F(BesideWhoStands, WhoStandsAtAWallIsInTheWay) {
  for (const char* const says : {"r inside floor", "stop or r inside floor"}) {
    expect_in_the_way(beside(says), "told", "halt");
  }
}
// Of two that keep as much the one that drives goes on, wherever it ranks.
TEST_F(BesideWhoStands, WhatLeadsBackFromAWallIsInTheWayOfThoseThatCoordinate) {
  expect_in_the_way(beside("not stop", "coordinate"), "fence", "back");
}
// That another order would do is said where it does, and not where nothing would be shown either.
TEST_F(MakingRoom, TheOrderThatWorksIsOffered) {
  const auto repair = [&](const std::string& zone, const char* order) {
    return room(edited(halls_with(zone), "priority apart > fence;", order))["repair"]
        .get<std::string>();
  };
  const std::string offered = "`apart` ranked above `fence`";
  const std::string hall = "rectangle (0 m, 0 m) to (6 m, 4 m)";
  EXPECT_EQ(repair(hall, "priority fence > apart;").find(offered), 0U);
  EXPECT_EQ(repair(hall, "coordinate fence > apart;").find(offered), std::string::npos);
  const std::string aisle = "rectangle (0 m, 0 m) to (20 m, 2.5 m)";
  EXPECT_EQ(repair(aisle, "priority fence > apart;").find(offered), std::string::npos);
}
// Corner to corner a hall of 12 m by 8 m is 14.4 m; where both are given back, they are nearer.
TEST_F(MakingRoom, RobotsThatAreNeverSoFarApartAreNotGivenBackTogether) {
  const auto joint = [](const std::string& distance) {
    const Outcome o = verified(
        halls_with("rectangle (0 m, 0 m) to (12 m, 8 m)", "a, b", "distance(r, q) >= " + distance),
        {"--format", "json"});
    return statuses(o.out, "joint return", "");
  };
  EXPECT_EQ(joint("1 m"), Statuses{"proved"});
  EXPECT_EQ(joint("13 m"), Statuses{"refuted"});
}
// Fast robots make way to more than a lane is wide. But long before they are as far apart as that
// each of two that hold is given back: before both walls nobody has to make way.
TEST_F(MakingRoom, WhoIsGivenBackNeedNoWay) {
  const std::string lane =
      halls_with("rectangle (0 m, 0 m) to (20 m, 6 m)", "a, b", "distance(r, q) >= 50 cm", "2 m/s");
  EXPECT_EQ(room(lane)["status"], "proved");
  const Outcome again = rtac({"verify", "--recheck", "certificates"});
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}
// That something is not so near is no less than that it is so far.
TEST_F(MakingRoom, ADistanceIsReadInOtherWords) {
  EXPECT_EQ(room(halls_with("rectangle (0 m, 0 m) to (6 m, 4 m)", "a, b",
                            "not (distance(r, q) < 20 cm or distance(r, q) <= 10 cm)"))["status"],
            "proved");
  const Outcome again = rtac({"verify", "--recheck", "certificates"});
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}
// What a certificate says of it is held against the specification.
void MakingRoom::expect_noticed() {
  const Json report = Json::parse(read("certificates/verification.json"));
  const std::pair<const char*, int> changes[] = {
      {"gap_mm", -900},       {"gap_mm", 8'000},       {"route_mm", -600}, {"cell_mm", 100},
      {"extra_us", -100'000}, {"extra_us", 9'000'000}, {"apart_mm", -300}};
  for (const auto& [key, by] : changes) {
    Json changed = report;
    int found = 0;
    for (Json& o : changed["decisions"][0]["obligations"]) {
      for (Json& c : o["claims"]) {
        if (c["claim"] != "parting") continue;
        c[key] = std::to_string(std::stoll(c[key].get<std::string>()) + by);
        ++found;
      }
    }
    EXPECT_EQ(found, 1);
    write("certificates/verification.json", changed.dump(2));
    EXPECT_EQ(recheck_sealed_anew().status, exit_violation) << key << by;
  }
}
TEST_F(MakingRoom, AMutatedCertificateIsNoticed) {
  ASSERT_EQ(room(halls_with("rectangle (0 m, 0 m) to (6 m, 4 m)"))["status"], "proved");
  expect_noticed();
}
// Of more robots nothing is shown but by a run: the gate is named, with its width and what is
// needed, and the corner that a run starts in.
TEST_F(MakingRoom, OfThreeRobotsThePassageIsNamed) {
  const auto of_three = [this](const std::string& zone) {
    return because(halls_with(zone, "a, b, c", "distance(r, q) >= 20 cm", "1 m/s"));
  };
  const std::string gated = of_three(
      "rectangle (0 m, 0 m) to (20 m, 20 m) | rectangle (30 m, 0 m) to (50 m, 20 m)"
      " | rectangle (19 m, 8 m) to (31 m, 12 m)");
  EXPECT_NE(gated.find("robots that meet near (30 m, 10 m) in `floor`"), std::string::npos)
      << gated;
  EXPECT_NE(gated.find("it is about 3.84 m wide there"), std::string::npos) << gated;
  const std::string open = of_three("rectangle (0 m, 0 m) to (40 m, 40 m)");
  EXPECT_NE(open.find("may wait for each other for ever"), std::string::npos) << open;
  EXPECT_EQ(open.find("passage"), std::string::npos) << open;
  const std::string round = of_three("circle (20 m, 20 m) radius 20 m");
  EXPECT_NE(round.find("may wait for each other for ever"), std::string::npos) << round;
  const std::string aisle = of_three("rectangle (0 m, 0 m) to (40 m, 5 m)");
  EXPECT_NE(aisle.find("it is 5 m wide at most"), std::string::npos) << aisle;
}
TEST_F(MakingRoom, OfAnythingButADistanceNothingIsShown) {
  const std::string either = "(distance(r, q) >= 20 cm or distance(r, q) >= 1 m)";
  const std::string hall = "rectangle (0 m, 0 m) to (6 m, 4 m)";
  EXPECT_EQ(because(halls_with(hall, "a, b", either)).find("`apart` asks for more"), 0U);
}

// In space one may hold straight over the other one, in a corner, too.
TEST_F(MakingRoom, InSpaceOneFindsAWayOverTheOther) {
  const std::string tall = spec_text("tests/compiler/verify/parting/stacked.rta");
  for (const char* const zone :
       {"rectangle (0 m, 0 m) to (9 m, 9 m)",
        "rectangle (0 m, 0 m) to (9 m, 5 m) | rectangle (0 m, 0 m) to (5 m, 9 m)"}) {
    const Json found = room(edited(tall, "rectangle (0 m, 0 m) to (9 m, 9 m)", zone));
    EXPECT_EQ(found["status"], "proved") << found;
    const Outcome again = recheck_sealed_anew();
    EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
  }
  expect_noticed();
}
// In an aisle it may not, as the recheck has it, too; nor is one of three more than in the plane.
TEST_F(MakingRoom, InSpaceAnAisleIsAsNarrow) {
  const std::string tall = spec_text("tests/compiler/verify/parting/stacked.rta");
  ASSERT_EQ(room(tall)["status"], "proved");
  const std::string narrow =
      edited(tall, "rectangle (0 m, 0 m) to (9 m, 9 m)", "rectangle (0 m, 0 m) to (9 m, 2 m)");
  write("certificates/sources/spec.rta", narrow);
  EXPECT_EQ(recheck_sealed_anew().status, exit_violation);
  EXPECT_NE(because(narrow).find("may both find no way"), std::string::npos);
  const std::string three = because(edited(tall, "fleet m1, m2", "fleet m1, m2, m3"));
  EXPECT_EQ(three.find("of 3 robots"), 0U) << three;
}
// Who passes others slowly needs less room for that than two take that hold and are measured nearer
// to each other than they do: they make as much as these need.
TEST_F(MakingRoom, InSpaceASwayThatIsWiderThanTheWayTakesMoreRoom) {
  const std::string slow = edited(spec_text("tests/compiler/verify/parting/stacked.rta"),
                                  "speed <= 1 m/s", "speed <= 0.3 m/s");
  const Json found = room(slow);
  EXPECT_EQ(found["status"], "proved") << found;
  const Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}

// In a lane that is too narrow for its ways over cells nobody ever moves, wherever robots stop.
TEST_F(MakingRoom, WhereNoWayLeadsAnywhereItSaysHowWideItHasToBe) {
  const std::string lane = spec_text("tests/compiler/verify/refuted/in_lane.rta");
  const Outcome o = verified(lane, {});
  EXPECT_NE(o.out.find("of which there are none"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("none in a zone less than about 1.244 m wide"), std::string::npos) << o.out;
  const Outcome wider = verified(edited(lane, "1.2 m);", "1.25 m);"), {});
  EXPECT_EQ(wider.out.find("of which there are none"), std::string::npos) << wider.out;
}

}  // namespace
}  // namespace rtac::driver::test
