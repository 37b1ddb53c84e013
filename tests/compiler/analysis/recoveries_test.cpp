// What is said of a recovery that cannot do what its monitor needs it for; the numbers of the help
// work, and a little beyond them nothing does.
#include "compiler/analysis/recoveries.h"

#include <cmath>

#include "compiler/analysis/liveness.h"
#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis {
namespace {

using diag::Code;
using test::compiled;
using test::edited;
using test::has;
using test::number_in_help;
using test::reports;
using test::without_offers;

struct Text {
  std::string recovery = "retreat within room speed 0.3 m/s", zones{}, latency = "20 ms",
              property = "d inside room", clauses{};
};
std::string text_of(const Text& t) {
  return R"(spec test;
zone room = rectangle (0 m, 0 m) to (5 m, 5 m);
)" + t.zones +
         R"(
robot Drone {
  body     radius 8 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 2 cm    max_age 50 ms;
  sense    velocity : vector  error 2 cm/s  max_age 50 ms;
  output   thrust : acceleration;
  latency  )" +
         t.latency + R"(;
}
fleet d1 : Drone;
)" + (t.recovery.find("to home") != std::string::npos ? "site  home = (2.5 m, 2.5 m);\n" : "") +
         R"(controller pilot : advanced for Drone extern;
controller rec   : safe for Drone )" +
         (t.recovery.starts_with("extern") ? "" : "= ") + t.recovery + R"(;
monitor walls for d : Drone {
  "SR-1: in" always )" +
         t.property + "; recover rec; " + t.clauses + R"(
}
decision fly for Drone { advanced pilot; period 50 ms; priority walls; }
)";
}
// The codes of all reports, in order.
std::vector<int> codes(const Text& t) {
  std::vector<int> all;
  const auto c = compiled(text_of(t));
  for (const auto& d : c->diagnostics.all()) all.push_back(static_cast<int>(d.code));
  return all;
}
using Codes = std::vector<int>;

TEST(Recoveries, MoveWhereTheirPropertyHolds) {
  const std::string other = "zone other = rectangle (4 m, 4 m) to (6 m, 6 m);";
  const std::string inner = "zone inner = shrink(room, 30 cm);";
  for (const std::string moves : {"retreat", "loiter", "route to home"}) {
    EXPECT_EQ(codes({moves + " within inner speed 0.3 m/s", inner}), Codes{});
    Text beyond{moves + " within other speed 0.3 m/s", other};
    beyond.zones += "site elsewhere = (5 m, 5 m);";
    if (moves == "route to home") beyond.recovery = "route to elsewhere within other speed 0.3 m/s";
    EXPECT_TRUE(has(*without_offers(text_of(beyond)), Code::recovery_elsewhere)) << moves;
  }
  // 3 of its 4 m^2, and a place that is one of them
  const auto c = compiled(text_of({"retreat within other speed 0.3 m/s", other}));
  ASSERT_FALSE(c->diagnostics.all().empty());
  EXPECT_NE(c->diagnostics.all().front().notes.front().text.find("3 m^2 of `other`"),
            std::string::npos);
}

// A pillar in the middle of a room: the room is where the recovery may go, and the pillar is not.
// What inputs say may be either: the recovery has to lead to where both of it hold.
TEST(Recoveries, MoveWhereTheirPropertyHoldsWhateverInputsSay) {
  const std::string zones =
      "input rain : bool max_age 1 s;\nzone shelter = rectangle (0 m, 0 m) to (2.4 m, 2.4 m);\n"
      "zone corner = rectangle (3 m, 3 m) to (5 m, 5 m);\n";
  Text t{.zones = zones, .property = "if rain then d inside shelter else d inside room"};
  t.recovery = "retreat within room speed 0.3 m/s";
  EXPECT_EQ(codes(t), Codes{5016});
  t.recovery = "extern keeps inside room speed <= 1 m/s";
  t.clauses = "hold when violated \"a test\";";
  EXPECT_EQ(codes(t), Codes{5016});
  t.clauses = "";
  t.recovery = "retreat within shelter speed 0.3 m/s";
  EXPECT_EQ(codes(t), Codes{});
  t.property = "(rain implies d inside shelter) and (not rain implies d inside room)";
  EXPECT_EQ(codes(t), Codes{});
  t.recovery = "retreat within room speed 0.3 m/s";
  EXPECT_EQ(codes(t), Codes{5016});
  // two zones that have nothing in common: none leads to both
  t.property = "if rain then d inside shelter else d inside corner";
  t.recovery = "retreat within shelter speed 0.3 m/s";
  const auto c = compiled(text_of(t));
  ASSERT_TRUE(has(*c, Code::recovery_elsewhere)) << reports(*c);
  EXPECT_NE(reports(*c).find("zones that overlap work, or `brake_and_hold`"), std::string::npos)
      << reports(*c);
  t.recovery = "brake_and_hold";
  t.clauses = "hold when violated \"a test\";";
  EXPECT_EQ(codes(t), Codes{});
}

TEST(Recoveries, DoNotCrossWhatThePropertyTakesOut) {
  Text pillar;
  pillar.zones = "zone pillar = rectangle (2 m, 2 m) to (3 m, 3 m);";
  pillar.property = "d inside room - pillar";
  EXPECT_EQ(codes(pillar), Codes{5016});
  pillar.zones += " zone ring = room - pillar;";
  pillar.recovery = "retreat within ring speed 0.3 m/s";
  EXPECT_EQ(codes(pillar), Codes{});
}

// From where the property holds the recovery makes straight for its zone, which knows nothing of
// what lies between: no wall may.
TEST(Recoveries, DoNotCrossAWallOnTheirWayToTheirZone) {
  const std::string hall =
      "zone wall = rectangle (2 m, 0 m) to (2.2 m, 4 m); zone hall = room - wall; "
      "zone left = rectangle (0 m, 0 m) to (2 m, 5 m); ";
  Text part{"retreat within left speed 0.3 m/s", hall};
  part.property = "d inside hall";
  for (const std::string moves : {"retreat", "loiter", "yield", "route to west"}) {
    part.recovery = moves + " within left speed 0.3 m/s" + (moves == "yield" ? " order id" : "");
    part.zones = hall + "site west = (1 m, 2 m);";
    part.clauses = moves == "yield" ? "hold when violated \"why\";" : "";
    EXPECT_EQ(codes(part), Codes{5016}) << moves;
  }
  // what the help names
  const auto c = compiled(text_of(part));
  EXPECT_NE(reports(*c).find("a recovery within `hall` works"), std::string::npos) << reports(*c);
  part = {"retreat within hall speed 0.3 m/s", hall};
  part.property = "d inside hall";
  EXPECT_EQ(codes(part), Codes{});
  // nothing stands in a room without corners that point inwards
  Text convex{"retreat within left speed 0.3 m/s", hall};
  EXPECT_EQ(codes(convex), Codes{});
  // and a robot that the other zone of its property keeps there has no way to go
  Text kept{"retreat within left speed 0.3 m/s", hall};
  kept.property = "d inside hall and d inside left";
  EXPECT_EQ(codes(kept), Codes{});
}

// A part that lies so deep in what the property allows that no wall is near, whatever its shape:
// the way into it stays where the property holds.
TEST(Recoveries, MayMoveDeepInsideOfWhatIsNotConvex) {
  const std::string zones =
      "zone pillar = rectangle (2 m, 2 m) to (2.6 m, 2.6 m); zone hall = room - pillar; "
      "site west = (1.15 m, 1.15 m); ";
  for (const std::string deep : {"shrink(hall, 1 mm)", "shrink(hall, 30 cm)", "shrink(hall, 40 cm)",
                                 "room - grow(pillar, 50 cm)", "shrink(room, 20 cm) - pillar"}) {
    for (const std::string moves : {"retreat", "loiter", "yield", "route to west"}) {
      Text t{moves + " within deep speed 0.3 m/s" + (moves == "yield" ? " order id" : ""),
             zones + "zone deep = " + deep + ";"};
      t.property = "d inside hall";
      if (moves == "yield") t.clauses = "hold when violated \"why\";";
      EXPECT_EQ(codes(t), Codes{}) << moves << " within " << deep;
    }
  }
}

// The place that is named, and the way from there: it leads out of what the property allows.
TEST(Recoveries, NameWhereTheirWayLeadsAcrossAWall) {
  const auto hall = [](const std::string& wall, const std::string& property) {
    Text t{"retreat within left speed 0.3 m/s",
           "zone wall = " + wall +
               "; zone hall = room - wall; zone left = rectangle (0 m, 0 m) to (2 m, 5 m);"};
    t.property = property;
    return compiled(text_of(t));
  };
  // from the far side of a wall that leaves a passage
  const auto c = hall("rectangle (2 m, 0 m) to (2.2 m, 4 m)", "d inside hall");
  EXPECT_NE(reports(*c).find("on its way into `left` from (2.28"), std::string::npos)
      << reports(*c);
}

// The nearest place of its zone is too narrow for the body: it stays where it is (5020).
TEST(Recoveries, NameWhereNoWayLeadsIntoTheirZone) {
  Text t{"retreat within parts speed 0.3 m/s",
         "zone pillar = rectangle (2 m, 2 m) to (2.6 m, 2.6 m); zone hall = room - pillar; "
         "zone north = shrink(hall, 30 cm) & rectangle (0 m, 0.8 m) to (5 m, 5 m); "
         "zone parts = north | rectangle (4 m, 0.2 m) to (4.2 m, 0.4 m);"};
  t.property = "d inside hall";
  const auto c = compiled(text_of(t));
  EXPECT_EQ(codes(t), Codes{5020}) << reports(*c);
  EXPECT_NE(reports(*c).find("finds no way into `parts`"), std::string::npos) << reports(*c);
  t.recovery = "retreat within north speed 0.3 m/s";
  EXPECT_EQ(codes(t), Codes{});
}

// The same robot in space.
Codes codes_in_space(const Text& t) {
  std::string text = text_of(t);
  text = test::edited(text, ": point ", ": point3 ");
  text = test::edited(text, ": vector ", ": vector3 ");
  Codes all;
  const auto c = compiled(text);
  for (const auto& d : c->diagnostics.all()) all.push_back(static_cast<int>(d.code));
  return all;
}

// In space the ways into a part are not looked at: it is warned of where a wall may lie between.
TEST(Recoveries, InSpaceAPartOfWhatIsNotConvexIsWarnedOf) {
  const auto within = [](const std::string& hall, const std::string& property) {
    Text t{"retreat within low speed 0.3 m/s",
           "zone hall = " + hall +
               "; zone low = prism (rectangle (0 m, 0 m) to (5 m, 2 m)) from 0 m to 5 m; "};
    t.property = property;
    return codes_in_space(t);
  };
  const std::string box = "prism (rectangle (0 m, 0 m) to (5 m, 5 m)) from 0 m to 5 m";
  EXPECT_EQ(within(box, "d inside hall"), Codes{});
  EXPECT_EQ(within(box + " | prism (rectangle (0 m, 5 m) to (2 m, 9 m)) from 0 m to 5 m",
                   "d inside hall"),
            Codes{5020});
}

// Nor does an external one leave what its monitor says: it is braked within what it claims.
TEST(Recoveries, InSpaceClaimsLieInThePropertyAndAreLargeEnough) {
  const auto claims = [](const std::string& inside, const std::string& property = "d inside hall") {
    Text t{"extern keeps inside " + inside + " speed <= 0.5 m/s",
           "zone hall = prism (rectangle (0 m, 0 m) to (5 m, 5 m)) from 0 m to 5 m; "
           "zone high = prism (rectangle (0 m, 0 m) to (5 m, 5 m)) from 0 m to 6 m; "
           "zone low = prism (rectangle (0 m, 0 m) to (5 m, 2 m)) from 0 m to 5 m; "
           "zone flat = prism (rectangle (0 m, 0 m) to (5 m, 5 m)) from 0 m to 0.5 m; "};
    t.property = property;
    t.clauses = "hold when violated \"why\";";
    return codes_in_space(t);
  };
  EXPECT_EQ(claims("hall"), Codes{});
  EXPECT_EQ(claims("low"), Codes{});
  EXPECT_EQ(claims("high"), Codes{5016});
  EXPECT_EQ(claims("room"), Codes{5016});  // of the plane, it reaches up without an end
  EXPECT_EQ(claims("room", "d inside room"), Codes{});
  EXPECT_EQ(claims("hall", "d inside hall and d.position.z <= 4 m"), Codes{5016});
  EXPECT_EQ(claims("flat"), Codes{5019});  // never seen to hold
}

// A body on the seam of two zones is in neither of them.
TEST(Recoveries, DoNotPassASeamThatNoZoneHoldsABodyOn) {
  Text seam;
  seam.zones =
      "zone west = rectangle (0 m, 0 m) to (2.5 m, 5 m); "
      "zone east = rectangle (2.5 m, 0 m) to (5 m, 5 m);";
  seam.property = "d inside west or d inside east";
  EXPECT_EQ(codes(seam), Codes{5020});  // it may stop in front of it for good
  seam.recovery = "route to home within room speed 0.3 m/s";
  EXPECT_EQ(codes(seam), Codes{5016});  // it leads across
  seam.recovery = Text{}.recovery;
  seam.zones =
      "zone west = rectangle (0 m, 0 m) to (2.6 m, 5 m); "
      "zone east = rectangle (2.4 m, 0 m) to (5 m, 5 m);";
  EXPECT_EQ(codes(seam), Codes{});  // 20 cm for a body of 16 cm
  seam.recovery = "extern keeps inside room speed <= 0.5 m/s";
  seam.clauses = "hold when violated \"why\";";
  EXPECT_EQ(codes(seam), Codes{});
  seam.zones =
      "zone west = rectangle (0 m, 0 m) to (2.6 m, 5 m); "
      "zone east = rectangle (3 m, 0 m) to (5 m, 5 m);";
  EXPECT_EQ(codes(seam), Codes{5016});
}

// The union alone has seams that the zones are too narrow for, and wider zones alone leave the
// recovery in one of them.
TEST(Recoveries, BothOfWhatAnOrNeedsAreNamedAsNeeded) {
  Text t{"retreat within left speed 0.3 m/s"};
  t.zones =
      "zone left = polygon [(0 m, 2 m), (12 m, 0 m), (14 m, 8 m), (2 m, 10 m)]; "
      "zone right = polygon [(9 m, 3 m), (24 m, 6 m), (22 m, 16 m), (8 m, 12 m)];";
  t.property = "d inside left or d inside right";
  const auto c = compiled(text_of(t));
  ASSERT_EQ(codes(t), Codes{5016});
  EXPECT_EQ(c->diagnostics.all().front().help.find(
                "both are needed: a recovery within their union, and zones that overlap by"),
            0U)
      << reports(*c);
}

TEST(Recoveries, LeadOutOfAViolationOrAreAccepted) {
  const std::string why = "hold when violated \"it is carried back\";";
  for (const std::string stands :
       {"brake_and_hold", "yield within room speed 0.1 m/s order id",
        "sequence retreat within room speed 0.3 m/s for 9 s then brake_and_hold"}) {
    Text t{stands};
    EXPECT_EQ(codes(t), Codes{5017}) << stands;
    t.clauses = why;
    EXPECT_EQ(codes(t), Codes{}) << stands;
  }
  Text moves{"sequence brake_and_hold for 2 s then retreat within room speed 0.3 m/s"};
  EXPECT_EQ(codes(moves), Codes{});
  moves.clauses = why;
  EXPECT_EQ(codes(moves), Codes{2022});
}

// One that moves where its property does not hold is told that, and not that it leads out of that.
TEST(Recoveries, WhatLeadsElsewhereIsNotSaidToLeadOut) {
  Text t{"retreat within room speed 0.3 m/s"};
  t.zones = "zone pond = rectangle (2 m, 2 m) to (3 m, 3 m);";
  t.property = "d inside room and distance(d, pond) >= 20 cm";
  t.clauses = "hold when violated \"why\";";
  EXPECT_EQ(codes(t), Codes{5016});
}

// Nothing to be led out of is another matter, and what cannot be looked ahead is reported alone.
TEST(Recoveries, AReasonToStandIsOfUseWhereThereIsAPlaceToLeave) {
  Text slow{"brake_and_hold"};
  slow.property = "d.speed <= 0.9 m/s";
  slow.clauses = "hold when violated \"why\";";
  const auto c = compiled(text_of(slow));
  EXPECT_NE(reports(*c).find("there is no place to be led out of"), std::string::npos)
      << reports(*c);
  slow.property = "not (d inside room)";
  EXPECT_EQ(codes(slow), Codes{5006});
}

// Where it is enough to be slow, but so slow that nobody at rest is given back: what is told is
// that, and the limit that is offered is the least that works.
TEST(Recoveries, WhoStandsIsSlowEnoughAndNotGivenBack) {
  Text slow{"brake_and_hold"};
  slow.zones = "zone plants = rectangle (1 m, 1 m) to (2 m, 2 m);";
  slow.property = "distance(d, plants) >= 30 cm or d.speed <= 0.2 m/s";
  EXPECT_EQ(codes(slow), Codes{5017});
  const auto c = compiled(text_of(slow));
  const std::string said = reports(*c);
  EXPECT_NE(said.find("asks it to be slow, it may never be given back"), std::string::npos) << said;
  EXPECT_NE(said.find("limits of at least 0.338 m/s work"), std::string::npos) << said;
  slow.property = "distance(d, plants) >= 30 cm or d.speed <= 0.338 m/s";
  EXPECT_EQ(codes(slow), Codes{});
  slow.property = "distance(d, plants) >= 30 cm or d.speed <= 0.337 m/s";
  EXPECT_EQ(codes(slow), Codes{5017});
}

// Who yields brakes first, and is as slow then; a reason stays of use, as robots may wait for each
// other, which nothing shows to end.
TEST(Recoveries, WhoYieldsIsSlowEnough) {
  Text slow{"yield within room speed 0.1 m/s order id"};
  slow.zones = "zone plants = rectangle (1 m, 1 m) to (2 m, 2 m);";
  slow.property = "distance(d, plants) >= 30 cm or d.speed <= 0.338 m/s";
  EXPECT_EQ(codes(slow), Codes{});
  slow.clauses = "hold when violated \"why\";";
  EXPECT_EQ(codes(slow), Codes{});
  slow.clauses = "";
  slow.property = "distance(d, plants) >= 30 cm or d.speed <= 0.337 m/s";
  const std::string said = reports(*compiled(text_of(slow)));
  EXPECT_NE(said.find("`rec` makes way for robots alone: where `walls` asks it to be slow, it "
                      "may never be given back"),
            std::string::npos)
      << said;
  slow.property = "d inside room and d.speed <= 0.338 m/s";
  EXPECT_EQ(codes(slow), Codes{5017});
}

TEST(Recoveries, ActBeforeTheLookAheadEnds) {
  Text late;
  late.latency = "100 ms";
  EXPECT_EQ(codes(late), Codes{5018});
  late.clauses = "ahead 99 ms;";
  EXPECT_EQ(codes(late), Codes{5018});
  late.clauses = "ahead 100 ms;";
  EXPECT_EQ(codes(late), Codes{});
  late.clauses = "";
  late.latency = "50 ms";  // what the help says
  EXPECT_EQ(codes(late), Codes{});
}

// Outside of its claim it is braked, in every tick: nothing leads it back (5020), which is
// accepted.
TEST(Recoveries, ExternalOnesClaimSomethingThatLiesInTheProperty) {
  const auto claims = [](const std::string& claim, const std::string& zones = "",
                         const std::string& clauses = "hold when violated \"why\";") {
    Text t{"extern" + claim, zones};
    t.clauses = clauses;
    return codes(t);
  };
  EXPECT_EQ(codes({"extern"}), Codes{5019});
  EXPECT_EQ(claims(" keeps inside room speed <= 1 m/s"), Codes{});
  EXPECT_EQ(claims(" keeps inside room speed <= 1 m/s", "", ""), Codes{5020});
  EXPECT_EQ(claims(" keeps inside wide speed <= 1 m/s", "zone wide = grow(room, 1 m);"),
            Codes{5016});
  EXPECT_EQ(claims(" keeps inside room speed <= 1.1 m/s"), Codes{5005});
}

// A negative bound lets a body stick out, and leaves the recovery no other zone.
TEST(Recoveries, MoveWhereAPropertyWithANegativeBoundHolds) {
  Text t{"retreat within beside speed 0.3 m/s",
         "zone beside = rectangle (5.5 m, 0 m) to (9 m, 5 m);"};
  t.property = "clearance(d, room) >= -30 cm";
  EXPECT_EQ(codes(t), Codes{5016});
  t.recovery = "retreat within room speed 0.3 m/s";
  EXPECT_EQ(codes(t), Codes{});
}

// An external one may be anywhere in its claim, which has to be as far off as is asked.
TEST(Recoveries, ExternalOnesAreWhereTheirClaimIsFarEnoughOff) {
  Text t{"extern keeps inside inner speed <= 0.5 m/s"};
  t.clauses = "hold when violated \"why\";";
  const auto within = [&](const std::string& inner, const std::string& asked) {
    t.zones = "zone inner = " + inner + ";";
    t.property = "clearance(d, room) >= " + asked;
    return codes(t);
  };
  EXPECT_EQ(within("room & room", "50 cm"), Codes{5016});
  EXPECT_EQ(within("shrink(room, 49 cm)", "50 cm"), Codes{5016});
  EXPECT_EQ(within("shrink(room, 50 cm)", "50 cm"), Codes{});
  EXPECT_EQ(within("room & room", "0 m"), Codes{});
  EXPECT_EQ(within("room & room", "0 m and clearance(d, room) >= 50 cm"), Codes{5016});
  EXPECT_EQ(within("grow(room, 1 m)", "-30 cm"), Codes{5016});  // a body may stick out, a claim not
  EXPECT_EQ(within("room & room", "-30 cm"), Codes{});
  t.recovery = "extern keeps inside room speed <= 0.5 m/s";
  EXPECT_EQ(within("room", "50 cm"), Codes{5016});
  EXPECT_NE(reports(*compiled(text_of(t))).find("works, such as `shrink(room, 0.5 m)`"),
            std::string::npos);

  const auto in_space = [](const std::string& inside) {
    Text high{
        "extern keeps inside " + inside + " speed <= 0.5 m/s",
        "zone hall = prism (rectangle (0 m, 0 m) to (5 m, 5 m)) from 0 m to 5 m; "
        "zone deep = prism (rectangle (0.5 m, 0.5 m) to (4.5 m, 4.5 m)) from 0.5 m to 4.5 m; "
        "zone low = prism (rectangle (0.5 m, 0.5 m) to (4.5 m, 4.5 m)) from 0.4 m to 4.5 m; "};
    high.property = "clearance(d, hall) >= 50 cm";
    high.clauses = "hold when violated \"why\";";
    return codes_in_space(high);
  };
  EXPECT_EQ(in_space("hall"), Codes{5016});
  EXPECT_EQ(in_space("low"), Codes{5016});
  EXPECT_EQ(in_space("deep"), Codes{});
}

// 0.357 m: a body at rest, with its errors, and what it may do until it is braked.
TEST(Recoveries, AClaimIsLargeEnoughToBeSeenToHold) {
  const auto in = [](int mm) {
    const std::string low = std::to_string(2500 - mm), high = std::to_string(2500 + mm);
    Text t{"extern keeps inside hut speed <= 0.5 m/s", "zone hut = rectangle (" + low + " mm, " +
                                                           low + " mm) to (" + high + " mm, " +
                                                           high + " mm);"};
    t.clauses = "hold when violated \"why\";";
    return compiled(text_of(t));
  };
  const auto c = in(50);
  ASSERT_TRUE(has(*c, Code::recovery_unclaimed)) << reports(*c);
  const std::string needs =
      test::number_in_help(*c, Code::recovery_unclaimed, "clearance of ", "m");
  const int mm = static_cast<int>(std::lround(1000 * std::stod(needs)));
  EXPECT_FALSE(has(*in(mm), Code::recovery_unclaimed)) << mm;
  EXPECT_TRUE(has(*in(mm - 1), Code::recovery_unclaimed)) << mm;
}

TEST(Recoveries, AStepLastsADayAtMost) {
  const auto lasting = [](const std::string& time) {
    return codes(
        {"sequence brake_and_hold for " + time + " then retreat within room speed 0.3 m/s"});
  };
  EXPECT_EQ(lasting("1000 h"), Codes{3008});
  EXPECT_EQ(lasting("1000000000000 h"), Codes{3008});
  EXPECT_EQ(lasting("24 h"), Codes{});
  Text when;
  when.clauses = "return when clearance(d, room) >= 50 cm for 25 h;";
  EXPECT_EQ(codes(when), Codes{3008});
}

TEST(Recoveries, InSpaceWhoStandsIsToldToYield) {
  const auto c =
      compiled(driver::test::edited(driver::test::spec_text("tests/golden/space_flock/spec.rta"),
                                    "hold    when violated \"the crew leads them apart\";", ""));
  ASSERT_TRUE(has(*c, Code::recovery_stands)) << reports(*c);
  EXPECT_NE(reports(*c).find("`yield within Z speed "), std::string::npos) << reports(*c);
  EXPECT_NE(reports(*c).find("`hold when violated"), std::string::npos) << reports(*c);
}

// 5007 for every recovery: what can be had by none of them.
TEST(Recoveries, NoneReturnsWhereNoPlaceIsWideEnough) {
  for (const std::string recovery :
       {"brake_and_hold", "extern keeps inside inner speed <= 1 m/s",
        "loiter within room speed 0.3 m/s", "retreat within room speed 0.3 m/s"}) {
    Text t{recovery, "zone inner = shrink(room, 2 m);"};
    const bool stands = recovery == "brake_and_hold" || recovery.starts_with("extern");
    if (stands) t.clauses = "hold when violated \"why\";";
    t.property = "clearance(d, room) >= 2.5 m";
    EXPECT_TRUE(has(*without_offers(text_of(t)), Code::return_set_empty)) << recovery;
    t.property = "clearance(d, room) >= 2 m";
    EXPECT_EQ(codes(t), Codes{}) << recovery;
  }
}

// A room that a body fits in but nobody can be given control in: cut off, or at a corridor's end.
TEST(Recoveries, NameThePlaceWhereControlIsNeverGivenBack) {
  const std::string recovery = "retreat within yard speed 0.3 m/s";
  const auto in = [&](const std::string& more) {
    Text t{recovery, "zone yard = room | " + more + ";"};
    t.property = "d inside yard";
    return codes(t);
  };
  EXPECT_EQ(in("rectangle (8 m, 0 m) to (8.5 m, 0.5 m)"), Codes{5020});
  EXPECT_EQ(in("rectangle (5 m, 2 m) to (9 m, 2.5 m)"), Codes{5021});
  EXPECT_EQ(in("rectangle (5 m, 2 m) to (9 m, 3 m)"), Codes{});
  EXPECT_EQ(in("rectangle (8 m, 0 m) to (9 m, 1 m)"), Codes{});
}

// Cells at a tip that are too few to be told of would leave P2b of what is offered unknown.
TEST(Recoveries, WhatIsOfferedToAPlaceWithoutAWayLeavesNoCellOfIt) {
  const auto page = [](const std::string& zone) {
    Text t{"retreat within yard speed 0.3 m/s",
           "zone shed = polygon [(7 m, 0 m), (8 m, 0.2 m), (7.4 m, 0.7 m)];\n"
           "zone plain = room | shed;\nzone yard = " +
               zone + ";"};
    t.property = "d inside yard";
    return text_of(t);
  };
  const auto c = compiled(page("room | shed"));
  ASSERT_TRUE(has(*c, Code::no_way_back)) << reports(*c);
  const long mm =
      std::lround(1000 * std::stod(number_in_help(*c, Code::no_way_back, "`grow(yard, ", "m)`")));
  const auto grown = [&](long by_mm) {  // which tells of each cell
    return without_offers(page("grow(plain, " + std::to_string(by_mm) + " mm)"));
  };
  EXPECT_FALSE(has(*grown(mm), Code::no_way_back)) << reports(*grown(mm));
  EXPECT_TRUE(has(*grown(mm * 95 / 100), Code::no_way_back)) << mm;
}

// Of a fleet with a dock each: the one that is not reached has a name.
TEST(Recoveries, NameTheDockThatNoWayLeadsTo) {
  const auto at = [](const std::string& second) {
    std::string text = text_of({"route to home within yard speed 0.3 m/s",
                                "zone yard = room | rectangle (8 m, 0 m) to (10 m, 2 m);", "20 ms",
                                "d inside yard"});
    text = edited(text, "fleet d1 : Drone;", "fleet d1, d2 : Drone;");
    return compiled(edited(text, "site  home = (2.5 m, 2.5 m);",
                           "site home(d1) = (2.5 m, 2.5 m);\nsite home(d2) = " + second + ";"));
  };
  const auto shared = at("(1 m, 1 m)"), apart = at("(9 m, 1 m)");
  EXPECT_NE(reports(*shared).find("finds no way to `home(d1)`, where"), std::string::npos)
      << reports(*shared);
  EXPECT_NE(reports(*apart).find("finds no way to `home(d2)`, where"), std::string::npos)
      << reports(*apart);
}

// ---- ways

ir::Cells cells_of(const std::vector<std::vector<int>>& rows) {
  ir::Cells cells;
  cells.rows = static_cast<std::int32_t>(rows.size());
  cells.columns = static_cast<std::int32_t>(rows[0].size());
  for (const auto& row : rows) {
    cells.clearance_mm_lo.insert(cells.clearance_mm_lo.end(), row.begin(), row.end());
  }
  return cells;
}
std::vector<bool> at_least(const ir::Cells& cells, int least) {
  std::vector<bool> goals;
  for (const std::int32_t c : cells.clearance_mm_lo) goals.push_back(c >= least);
  return goals;
}

TEST(Ways, TheLongestIsThatOfTheFarthestPlace) {
  const ir::Cells cells = cells_of({{300, 200, 200, 100}, {-1, -1, -1, 100}});
  const Ways ways = ways_to(cells, at_least(cells, 300), 100, 200);
  EXPECT_EQ(ways.longest_mm, 400);
  EXPECT_TRUE(ways.stranded.empty());
}

// What is less clear than where a way starts is not on it, unless that is as clear as ways are.
TEST(Ways, NoneLeadsThroughWhatIsNarrower) {
  const ir::Cells narrow = cells_of({{300, 100, 150}});
  const Ways none = ways_to(narrow, at_least(narrow, 300), 100, 200);
  ASSERT_EQ(none.stranded.size(), 1U);
  EXPECT_EQ(none.stranded[0].x_mm, 250);
  EXPECT_EQ(none.stranded[0].clearance_mm, 150);
  EXPECT_EQ(none.longest_mm, 100);  // of the others
  const ir::Cells wide = cells_of({{300, 200, 250}});
  EXPECT_TRUE(ways_to(wide, at_least(wide, 300), 100, 200).stranded.empty());
}

// Up, down again and up: the search goes there, but no bound is claimed for it.
TEST(Ways, WhatDoesNotClimbHasAWayAndNoBound) {
  const ir::Cells cells = cells_of({{300, 110, 150, 100}});
  const Ways ways = ways_to(cells, at_least(cells, 300), 100, 200);
  ASSERT_EQ(ways.stranded.size(), 1U);  // from 150 nothing leads on
  EXPECT_EQ(ways.stranded[0].cells, 1);
  EXPECT_EQ(ways.longest_mm, std::nullopt);
}

// Of a large zone with round corners not all legs are looked at: nothing is said of those. What is
// seen to be shut off is told.
TEST(Recoveries, FromWhereNobodyHasLookedNothingIsSaidToLeadNowhere) {
  const auto in = [](const std::string& zone, const std::string& brake) {
    return compiled(
        "spec plain;\nzone hall = rectangle (0 m, 0 m) to (8 m, 8 m);\nzone z = " + zone +
        ";\nrobot Bot {\n  body radius 15 cm;\n"
        "  motion point { speed <= 1 m/s; accel <= 1.5 m/s^2; brake >= " +
        brake +
        " m/s^2; }\n"
        "  sense position : point error 2 cm max_age 50 ms;\n"
        "  sense velocity : vector error 2 cm/s max_age 50 ms;\n"
        "  output thrust : acceleration;\n  latency 30 ms;\n}\nfleet b : Bot;\n"
        "controller ac : advanced for Bot extern;\n"
        "controller rec : safe for Bot = retreat within z speed 0.3 m/s;\n"
        "monitor fence for r : Bot { \"R-1: inside\" always r inside z; ahead 50 ms; recover rec; "
        "}\n"
        "decision go for Bot { advanced ac; period 50 ms; priority fence; }\n");
  };
  const auto wide = in("grow(hall, 89.528 m)", "0.001");
  EXPECT_TRUE(wide->module) << reports(*wide);
  EXPECT_FALSE(has(*wide, diag::Code::no_way_back)) << reports(*wide);
  const auto shut = in("hall | rectangle (20 m, 0 m) to (21 m, 1 m)", "1");
  EXPECT_TRUE(has(*shut, diag::Code::no_way_back)) << reports(*shut);
}

// All that is outside of a pond: what is offered has an end, and works.
TEST(Recoveries, AZoneWithoutAnEndIsOfferedOne) {
  const auto page = [](const std::string& bank, const std::string& within) {
    return R"(spec lake;
zone pond = polygon [(0 m, 0 m), (3 m, 1 m), (2 m, 4 m)];
zone land = complement(pond);
)" + bank +
           R"(robot Cart {
  body     radius 15 cm;
  motion   unicycle { speed <= 0.8 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 1 m/s^2; turn_accel <= 8 rad/s^2; }
  sense    position : point   error 2 cm    max_age 60 ms;
  sense    heading  : angle   error 2 deg   max_age 60 ms;
  sense    velocity : vector  error 3 cm/s  max_age 40 ms;
  output   drive : twist;
  latency  30 ms;
}
fleet c : Cart;
controller job  : advanced for Cart extern;
controller back : safe for Cart = retreat within )" +
           within + R"( speed 0.3 m/s;
monitor dry for r : Cart { "R1" always r inside land; recover back; }
decision go for Cart { advanced job; period 50 ms; priority dry; }
)";
  };
  const auto endless = compiled(page("", "land"));
  ASSERT_TRUE(has(*endless, Code::no_way_back)) << reports(*endless);
  const std::string text = reports(*endless), such = "such as `";
  const std::size_t from = text.find(such);
  ASSERT_NE(from, std::string::npos) << text;
  const std::string zone =
      text.substr(from + such.size(), text.find('`', from + such.size()) - from - such.size());
  const auto ended = compiled(page("zone bank = " + zone + ";\n", "bank"));
  EXPECT_TRUE(ended->diagnostics.all().empty()) << zone << "\n" << reports(*ended);
}

// To a route, one with its site in it, too.
TEST(Recoveries, AZoneWithAnEndHasTheSiteInIt) {
  const std::string pond =
      "zone pond = rectangle (1 m, 1 m) to (2 m, 2 m);\nzone land = complement(pond);\n";
  const auto page = [&](const std::string& more, const std::string& within) {
    const std::string text = text_of({"route to home within " + within + " speed 0.3 m/s",
                                      pond + more, "20 ms", "d inside land"});
    return edited(text, "home = (2.5 m, 2.5 m)", "home = (40 m, 2.5 m)");
  };
  const std::string said = reports(*compiled(page("", "land"))), such = "works, such as `";
  const std::size_t from = said.find(such), begin = from + such.size();
  ASSERT_NE(from, std::string::npos) << said;
  const std::string zone = said.substr(begin, said.find('`', begin) - begin);
  const auto ended = compiled(page("zone bank = " + zone + ";", "bank"));
  EXPECT_FALSE(ended->diagnostics.has_errors()) << zone << "\n" << reports(*ended);
}

// A zone far from the origin has an end all the same.
TEST(Recoveries, AZoneFarAwayHasAnEnd) {
  const auto c = compiled(edited(text_of({}), "rectangle (0 m, 0 m) to (5 m, 5 m)",
                                 "rectangle (150000 m, 0 m) to (150005 m, 5 m)"));
  EXPECT_TRUE(c->diagnostics.all().empty()) << reports(*c);
}

// A longer look-ahead is offered where it works, and a shorter latency else.
TEST(Recoveries, ALookAheadIsOfferedThatWorks) {
  const std::string page = R"(spec slow;
robot Cart {
  body     radius 20 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 2 cm    max_age 100 ms;
  sense    velocity : vector  error 2 cm/s  max_age 100 ms;
  output   push : acceleration;
  latency  300 ms;
}
fleet c : Cart;
controller any  : advanced for Cart extern;
controller stop : safe for Cart = brake_and_hold;
monitor slow for r : Cart { "R1: slow" always r.speed <= 0.85 m/s; ahead 100 ms; recover stop; }
decision go for Cart { advanced any; period 100 ms; priority slow; }
)";
  const std::string said = reports(*compiled(page));
  EXPECT_EQ(said.find("`ahead 300 ms` works"), std::string::npos) << said;
  EXPECT_NE(said.find("(a latency of at most 100 ms works)"), std::string::npos) << said;
  EXPECT_TRUE(compiled(edited(page, "latency  300 ms", "latency  100 ms"))->module);
  EXPECT_FALSE(compiled(edited(page, "ahead 100 ms", "ahead 300 ms"))->module);
}

}  // namespace
}  // namespace rtac::analysis
