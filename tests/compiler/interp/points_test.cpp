// Points in zones on exact numbers (rule 7.2).
#include "tests/compiler/interp/testing.h"

namespace rtac::interp::test {
namespace {

using Lines = std::vector<std::string>;

constexpr const char* room =
    "zone room = rectangle (0 m, 0 m) to (5 m, 5 m) - rectangle (2 m, 2 m) to (3 m, 3 m);\n";

// One point a tick.
std::string trace(const std::string& points) {
  std::istringstream lines(points);
  std::string text = "time,p.x,p.y\n", line;
  for (int tick = 0; std::getline(lines, line); ++tick) {
    text += std::to_string(tick) + "," + line + "\n";
  }
  return text;
}
Lines found(const std::string& declarations, const std::string& condition,
            const std::string& points) {
  const auto c = monitor(declarations + "input p : point in -20 .. 20 m;", condition);
  return judge(*c, trace(points));
}

// Edges and vertices belong to the zone, of holes as well.
TEST(Points, OnTheBoundaryAreInside) {
  EXPECT_EQ(found(room, "p inside room", "0,2.5\n5,5\n2.5,2\n3,3\n"),
            (Lines{"true [0, 0] m", "true [0, 0] m", "true [0, 0] m", "true [0, 0] m"}));
}
// However little a point is beyond it.
TEST(Points, JustOutsideAreNot) {
  EXPECT_EQ(found(room, "p inside room", "5.000000000001,1\n2.5,2.5\n"),
            (Lines{"false [-0.000000000001, -0.000000000001] m", "false [-0.5, -0.5] m"}));
}
TEST(Points, HaveTheDistanceToTheNearestEdgeOrVertex) {
  EXPECT_EQ(found(room, "clearance(p, room) >= 0 m", "1,2.5\n8,9\n1,1.5\n"),
            (Lines{"true [1, 1] m", "false [-5, -5] m", "true [1, 1] m"}));
}
// Nothing inside; the clearance turned round outside.
TEST(Points, HaveNoDistanceToAZoneThatTheyAreIn) {
  EXPECT_EQ(found(room, "distance(p, room) <= 1 m", "1,1\n2.5,2.75\n8,9\n"),
            (Lines{"true [1, 1] m", "true [0.75, 0.75] m", "false [-4, -4] m"}));
}
// A slanted edge: the distance of (0, 0) to 3x + 4y = 10 is 2.
TEST(Points, HaveTheirDistanceToSlantedEdges) {
  EXPECT_EQ(found("zone z = polygon [(10 m, -5 m), (10 m, 9 m), (-6 m, 7 m)];\n",
                  "clearance(p, z) >= 0 m", "0,0\n"),
            (Lines{"false [-2, -2] m"}));
}

// The true place lies anywhere in a box.
Lines uncertain(const std::string& condition, const std::string& points) {
  const auto c =
      monitor(std::string(room) + "input p : point in -20 .. 20 m error 10 cm;", condition);
  return judge(*c, trace(points));
}
// It is at most e sqrt(2) from the measured one: 0.1415 m.
TEST(UncertainPoints, AreNearTheMeasuredOne) {
  const Lines lines = uncertain("p inside room", "4.85,1\n4.95,1\n5.1,1\n5.15,1\n");
  EXPECT_EQ(lines[0].substr(0, 4), "true");
  EXPECT_EQ(lines[1].substr(0, 7), "unknown");
  EXPECT_EQ(lines[2].substr(0, 7), "unknown");
  EXPECT_EQ(lines[3].substr(0, 5), "false");
}
TEST(UncertainPoints, HaveTheirClearanceLessAndMoreTheError) {
  EXPECT_EQ(uncertain("clearance(p, room) >= 1 m", "1,4\n"),
            (Lines{"unknown [-0.141421, 0.141421] m"}));
}

// Between the polygons within and around a circle nobody knows.
TEST(Points, NearACircleAreUnknown) {
  EXPECT_EQ(
      found("zone pond = circle (0 m, 0 m) radius 10 m;\n", "not p inside pond",
            "6,8\n11,0\n9,0\n"),
      (Lines{"unknown [-0.000149127, 0.00119667] m", "true [1, 1] m", "false [-1, -0.999696] m"}));
}
TEST(Points, AreUnknownWithoutAllComponents) {
  EXPECT_EQ(found(room, "p inside room", "nan,1\n"), (Lines{"unknown [-inf, inf]"}));
}

// At a tick without a value a clearance may be anything that the zone allows.
TEST(Points, HaveARangeOfClearances) {
  EXPECT_EQ(found("zone z = rectangle (0 m, 0 m) to (3 m, 4 m);\n",
                  "max[0 s, 1 s](clearance(p, z)) <= 1 m", "1,1\nnan,1\n"),
            (Lines{"true [0, 0] m", "unknown [-0.5, 0] m"}));
}

}  // namespace
}  // namespace rtac::interp::test
