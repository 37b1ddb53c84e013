// Points in zones: what a monitor without a robot may say about places.
#include "tests/compiler/sema/helpers.h"

namespace rtac::sema::test {
namespace {

std::unique_ptr<Checked> yard(const std::string& property) {
  return check_text(
      "spec yard;\nperiod 1 s;\nframe base;\nzone room = rectangle (0 m, 0 m) to (4 m, 3 m);\n"
      "zone reach @ base = rectangle (0 m, 0 m) to (1 m, 1 m);\n"
      "input at : pose of base @ map;\ninput hand : point @ base;\ninput s : point3;\n"
      "input p, q : point;\ninput v : vector [m];\ninput w : vector [m/s];\n"
      "fun home(at : point) : bool = at inside shrink(room, 1 m);\n"
      "monitor space { \"R00: all\" always transform(at, hand).x + s.x <= 9 m; }\n"
      "monitor all { \"R0: all\" always p.x + q.x + v.x <= 9 m and w.x <= 1 m/s; }\n"
      "monitor m { \"R1: a rule\" always " +
      property + "; }\n");
}
std::string meaning(const std::string& property) {
  const auto checked = yard(property);
  return checked->spec ? dump(*checked->spec, *checked->spec->watches[2].always)
                       : checked->reports();
}

TEST(Points, LieInsideZones) {
  EXPECT_EQ(meaning("p inside room"), "((p.x, p.y) inside room)");
}
TEST(Points, StandInFrontOfTheirZone) {
  EXPECT_NE(meaning("room inside p").find("write `p inside Z`"), std::string::npos)
      << meaning("room inside p");
}

// Any expression that is a point may: a displaced one, a literal, one that is chosen.
TEST(Points, OfAnyKindLieInside) {
  EXPECT_EQ(meaning("(p + v) inside room"), "(((p.x + v.x), (p.y + v.y)) inside room)");
  EXPECT_EQ(meaning("(1 m, 2 m) inside room"), "((1 m, 2 m) inside room)");
}
TEST(Points, HaveAClearance) {
  EXPECT_EQ(meaning("clearance(p, room) >= 1 m"), "(clearance((p.x, p.y), room) >= 1 m)");
}
// The distance to a zone follows from the clearance, and is 0 inside.
TEST(Points, HaveADistanceToAZone) {
  EXPECT_EQ(meaning("distance(p, room) <= 1 m"),
            "(max(0 m, (-clearance((p.x, p.y), room))) <= 1 m)");
}
TEST(Points, StillHaveADistanceToOneAnother) {
  EXPECT_EQ(meaning("distance(p, q) <= 1 m"), "(norm((p.x - q.x), (p.y - q.y)) <= 1 m)");
}
// A zone of a function is one, however often the function is called.
TEST(Points, ShareTheZoneOfAFunction) {
  const auto checked = yard("home(p) or home(q)");
  ASSERT_TRUE(checked->spec) << checked->reports();
  EXPECT_EQ(checked->spec->zones.size(), 3U);
}

// The name of a robot is its body: the centre, and the radius around it.
std::string of_robots(const std::string& property) {
  const auto checked = check_text(
      "spec yard;\nperiod 1 s;\nzone room = rectangle (0 m, 0 m) to (4 m, 3 m);\n"
      "robot Drone { body radius 10 cm; motion point { speed <= 1 m/s; accel <= 1 m/s^2; "
      "brake >= 1 m/s^2; } sense position : point error 1 cm max_age 1 s; "
      "output thrust : acceleration; latency 20 ms; }\n"
      "fleet one : Drone;\nfleet bots : Drone[3];\n"
      "monitor m { \"R1: a rule\" always " +
      property + "; }\n");
  return checked->spec ? dump(*checked->spec, *checked->spec->watches[0].always)
                       : checked->reports();
}
TEST(Bodies, LieInsideByTheirRadius) {
  EXPECT_EQ(of_robots("one inside room"),
            "((clearance((one.position.x, one.position.y), room) - 0.1 m) >= 0 m)");
}
TEST(Bodies, OfNumberedFleetsLieInside) {
  EXPECT_EQ(of_robots("bots[2] inside room"),
            "((clearance((bots[2].position.x, bots[2].position.y), room) - 0.1 m) >= 0 m)");
}
TEST(Bodies, HaveAClearance) {
  EXPECT_EQ(of_robots("clearance(one, room) >= 1 m"),
            "((clearance((one.position.x, one.position.y), room) - 0.1 m) >= 1 m)");
}
// Negative where the body overlaps the zone.
TEST(Bodies, HaveADistanceToAZone) {
  EXPECT_EQ(of_robots("distance(one, room) >= 1 m"),
            "((max(0 m, (-clearance((one.position.x, one.position.y), room))) - 0.1 m) >= 1 m)");
}
TEST(Bodies, OfAFleetLieInsideOneByOne) {
  EXPECT_EQ(of_robots("forall r : Drone, r != one and r != bots[0] and r != bots[1] : "
                      "r inside room"),
            of_robots("bots[2] inside room"));
}
// A measurement is a point, which has no radius.
TEST(Bodies, AreNotTheirCentres) {
  EXPECT_EQ(of_robots("one.position inside room"),
            "((one.position.x, one.position.y) inside room)");
}
TEST(Bodies, HaveMeasurementsWithAnAge) {
  EXPECT_EQ(of_robots("age(bots[1].position) <= 1 s"), "(age(bots[1].position) <= 1 s)");
}

TEST(Points, AreNoVectors) {
  EXPECT_NE(meaning("v inside room").find("3012 wrong_argument at `v`: `inside` takes points"),
            std::string::npos)
      << meaning("v inside room");
}
TEST(Points, StandBeforeTheirZone) {
  EXPECT_NE(meaning("clearance(room, p) >= 1 m").find("takes the point first"), std::string::npos);
}
// A distance has no direction.
TEST(Points, StandOnEitherSideOfTheirDistance) {
  EXPECT_EQ(meaning("distance(room, p) >= 1 m"), meaning("distance(p, room) >= 1 m"));
  EXPECT_EQ(of_robots("distance(room, bots[1]) >= 1 m"),
            of_robots("distance(bots[1], room) >= 1 m"));
}
TEST(Points, AreHeldAgainstZonesAlone) {
  EXPECT_NE(meaning("p inside q").find("a zone is due"), std::string::npos)
      << meaning("p inside q");
}
TEST(Points, HaveCoordinatesInLength) {
  EXPECT_NE(meaning("(1 s, 2 s) inside room").find("its coordinates are a time"), std::string::npos)
      << meaning("(1 s, 2 s) inside room");
}
TEST(Points, AreNoRobots) {
  EXPECT_NE(meaning("clearance(p) >= 1 m").find("takes 2 arguments"), std::string::npos);
}

// Coordinates of different frames say nothing about each other: a point of the arm is no place in
// the map, in each of the three forms and however the zone is written.
void expect_frames_differ(const std::string& property, const std::string& said) {
  const std::string found = meaning(property);
  EXPECT_NE(found.find("3039 frames_differ"), std::string::npos) << property << ": " << found;
  EXPECT_NE(found.find(said), std::string::npos) << property << ": " << found;
}
TEST(Points, LieInsideZonesOfTheirFrame) {
  EXPECT_EQ(meaning("hand inside reach"), "((hand.x, hand.y) inside reach)");
}
// A complement is open: its boundary belongs to the zone.
TEST(Points, LieInAComplementWhenTheyAreNotInTheZone) {
  EXPECT_EQ(meaning("hand inside complement(reach)"), "(not ((hand.x, hand.y) inside reach))");
  EXPECT_EQ(meaning("hand inside complement(complement(reach))"),
            "(not (not ((hand.x, hand.y) inside reach)))");
  expect_frames_differ("p inside complement(reach)", "the zone `reach` is in the frame `base`");
}
TEST(Points, OfAnotherFrameDoNotLieInside) {
  expect_frames_differ("hand inside room", "the zone `room` is in the frame `map`, `base` is due");
  expect_frames_differ("p inside reach", "the zone `reach` is in the frame `base`, `map` is due");
  expect_frames_differ("transform(at, hand) inside reach", "`map` is due");
}
TEST(Points, OfAnotherFrameHaveNoClearance) {
  expect_frames_differ("clearance(hand, room) >= 1 m", "`base` is due");
  expect_frames_differ("clearance(p, reach) >= 1 m", "`map` is due");
}
TEST(Points, OfAnotherFrameHaveNoDistanceToAZone) {
  expect_frames_differ("distance(hand, room) <= 1 m", "`base` is due");
  expect_frames_differ("distance(p, reach) <= 1 m", "`map` is due");
}
// Zones that are written in place are made of zones in the frame of the point.
TEST(Points, OfAnotherFrameDoNotLieInsidePartsOfZones) {
  expect_frames_differ("hand inside shrink(room, 1 cm)", "`base` is due");
  expect_frames_differ("p inside (room | reach)", "the zone `reach` is in the frame `base`");
}
TEST(Points, OfAFunctionAreHeldAgainstZonesOfItsFrame) {
  expect_frames_differ("home(hand)", "`home` takes `at` in `map`, this is in `base`");
}
// A literal is in the frame of what it meets, which may not be two.
TEST(Points, AsLiteralsAreInTheFrameOfTheZone) {
  EXPECT_EQ(meaning("(1 m, 2 m) inside reach"), "((1 m, 2 m) inside reach)");
  EXPECT_NE(meaning("(1 m, 2 m) inside shrink(reach, 1 cm)").find("inside shrink(reach"),
            std::string::npos)
      << meaning("(1 m, 2 m) inside shrink(reach, 1 cm)");
  expect_frames_differ("(1 m, 2 m) inside (reach | room)", "the zone `room` is in the frame `map`");
}

// Zones lie in the plane: what height a point of space has there is not for them to say.
TEST(Points, OfSpaceAreInNoZoneOfThePlane) {
  for (const char* property : {"s inside room", "clearance(s, room) >= 1 m",
                               "distance(s, room) <= 1 m", "(1 m, 2 m, 3 m) inside room"}) {
    const std::string found = meaning(property);
    EXPECT_NE(found.find("3040 spaces_differ"), std::string::npos) << property << ": " << found;
    EXPECT_NE(found.find("held against a zone of the plane"), std::string::npos) << found;
  }
}
TEST(Points, OfSpaceAreInZonesWithHeight) {
  EXPECT_EQ(meaning("s inside prism (room) from -1 m to 2.5 m"),
            "((s.x, s.y, s.z) inside prism (room) from -1 to 2.5)");
  EXPECT_EQ(meaning("clearance(s, complement(prism (room) from 0 m to 2 m)) <= 1 m"),
            "((-clearance((s.x, s.y, s.z), prism (room) from 0 to 2)) <= 1 m)");
}
TEST(Points, OfSpaceHaveAPartInThePlane) {
  EXPECT_EQ(meaning("s.xy inside room"), "((s.x, s.y) inside room)");
}

}  // namespace
}  // namespace rtac::sema::test
