// Points in zones with height on exact numbers (rule 7.7).
#include "tests/compiler/interp/testing.h"

namespace rtac::interp::test {
namespace {

using Lines = std::vector<std::string>;

// A base of 10 m with a tower of 2 m on it.
constexpr const char* stack =
    "zone stack = rectangle (0 m, 0 m, 0 m) to (10 m, 10 m, 4 m) | prism (rectangle (4 m, 4 m) to "
    "(6 m, 6 m)) from 4 m to 9 m;\n";

Lines found(const std::string& declarations, const std::string& condition,
            const std::string& points) {
  const auto c = monitor(declarations + "input p : point3 in -20 .. 20 m;", condition);
  std::istringstream lines(points);
  std::string text = "time,p.x,p.y,p.z\n", line;
  for (int tick = 0; std::getline(lines, line); ++tick) {
    text += std::to_string(tick) + "," + line + "\n";
  }
  return judge(*c, text);
}

// Walls, floors and ceilings belong to the zone.
TEST(PointsInSpace, OnTheBoundaryAreInside) {
  EXPECT_EQ(found(stack, "p inside stack", "0,5,2\n5,5,9\n5,5,0\n1,1,4\n4,4,4\n10,10,0\n"),
            Lines(6, "true [0, 0] m"));
}
TEST(PointsInSpace, JustOutsideAreNot) {
  EXPECT_EQ(found(stack, "p inside stack", "5,5,9.000000000001\n1,1,4.000000000001\n"),
            Lines(2, "false [-0.000000000001, -0.000000000001] m"));
}
// What slabs share is no boundary.
TEST(PointsInSpace, BetweenTwoSlabsAreDeepInside) {
  EXPECT_EQ(
      found(stack, "clearance(p, stack) >= 0 m", "5,5,4\n5,5,3\n5,5,8.5\n2,2,3\n"),
      (Lines{"true [1, 1] m", "true [1.41421, 1.41421] m", "true [0.5, 0.5] m", "true [1, 1] m"}));
}
// To a wall, to an edge, to a corner, to a ceiling below.
TEST(PointsInSpace, HaveTheDistanceToTheNearestPlaceOfTheBoundary) {
  EXPECT_EQ(
      found(stack, "distance(p, stack) >= 0 m", "-3,5,2\n-3,5,8\n-2,-3,10\n2,2,7\n7,5,6\n5,5,-2\n"),
      (Lines{"true [3, 3] m", "true [5, 5] m", "true [7, 7] m", "true [2.82843, 2.82843] m",
             "true [1, 1] m", "true [2, 2] m"}));
}
// A gap in height is one as well.
TEST(PointsInSpace, HaveTheDistanceToSlabsBelowAndAbove) {
  const char* const apart =
      "zone apart = rectangle (0 m, 0 m, 0 m) to (9 m, 9 m, 2 m) | rectangle (0 m, 0 m, 5 m) to "
      "(9 m, 9 m, 9 m);\n";
  EXPECT_EQ(found(apart, "clearance(p, apart) >= 0 m", "4,4,3\n4,4,4.5\n4,4,1\n4,4,6\n4,4,2\n"),
            (Lines{"false [-1, -1] m", "false [-0.5, -0.5] m", "true [1, 1] m", "true [1, 1] m",
                   "true [0, 0] m"}));
}
TEST(PointsInSpace, AreUnknownBetweenRoundWalls) {
  const Lines lines = found("zone tank = prism (circle (0 m, 0 m) radius 10 m) from 0 m to 4 m;\n",
                            "not p inside tank", "9.995,0.3,2\n11,0,2\n0,0,5\n0,0,2\n");
  EXPECT_EQ(lines[0].substr(0, 7), "unknown");
  EXPECT_EQ(Lines(lines.begin() + 1, lines.end()),
            (Lines{"true [1, 1] m", "true [1, 1] m", "false [-2, -2] m"}));
}
// The complement is open; shrink takes its distance away above and below as well.
TEST(PointsInSpace, KnowComplementsAndOffsets) {
  EXPECT_EQ(found(stack, "p inside complement(stack)", "5,5,9\n5,5,9.5\n5,5,2\n"),
            (Lines{"false [0, 0] m", "true [0.5, 0.5] m", "false [-2, -2] m"}));
  EXPECT_EQ(found(stack, "p inside shrink(stack, 1 m)", "5,1.5,2.5\n5,1.5,3.5\n5,0.9,2\n")[0],
            "true [0.5, 0.5] m");
  EXPECT_EQ(found(stack, "p inside grow(stack, 1 m)", "5,5,9.75\n5,5,10.5\n"),
            (Lines{"true [0.25, 0.25] m", "false [-0.5, -0.5] m"}));
}
// e sqrt(3) from the measured one: 0.1733 m.
TEST(PointsInSpace, AreNearTheMeasuredOne) {
  const auto c = monitor(std::string(stack) + "input p : point3 in -20 .. 20 m error 10 cm;",
                         "p inside stack");
  const Lines lines = judge(*c, "time,p.x,p.y,p.z\n0,2,2,3.82\n1,2,2,3.9\n2,2,2,4.1\n3,2,2,4.18\n");
  EXPECT_EQ(lines[0].substr(0, 4), "true");
  EXPECT_EQ(lines[1].substr(0, 7), "unknown");
  EXPECT_EQ(lines[2].substr(0, 7), "unknown");
  EXPECT_EQ(lines[3].substr(0, 5), "false");
}
TEST(PointsInSpace, AreUnknownWithoutTheirHeight) {
  EXPECT_EQ(found(stack, "p inside stack", "5,5,nan\n"), (Lines{"unknown [-inf, inf]"}));
}
// Of a corner (0, 0, 0) no place of the range is farther than 20 sqrt(3); none deeper than 4.5 m.
TEST(PointsInSpace, HaveARangeOfClearances) {
  const Lines lines = found(stack, "max[0 s, 1 s](clearance(p, stack)) <= 1 m", "2,2,3\nnan,1,1\n");
  EXPECT_EQ(lines[1], "unknown [-3.5, 0] m");
}

}  // namespace
}  // namespace rtac::interp::test
