// shrink and grow never err on the unsafe side: proved edge against edge in exact numbers, and
// they stay within the promised 1 mm of the true result.
#include <gtest/gtest.h>

#include "testing.h"

namespace rtac::geometry {
namespace {

TEST(Shrink, ConvexAxisParallelIsExact) {
  EXPECT_EQ(text(box(0, 0, 5000, 5000).shrink(q(26, 100))), text(box(260, 260, 4740, 4740)));
  EXPECT_TRUE(box(0, 0, 5000, 5000).shrink(q(5, 2)).empty());
  EXPECT_EQ(box(0, 0, 5000, 5000).shrink(q(2499, 1000)).area(), q(4, 1000000));
}

// A comb.
TEST(Shrink, ManyCornersOfWallsParallelToAnAxisAreExact) {
  Region comb = box(0, 0, 41'000, 2000);
  for (int tooth = 0; tooth < 20; ++tooth) {
    comb = comb.unite(box(1000 + 2000 * tooth, 2000, 2000 + 2000 * tooth, 4000));
  }
  ASSERT_GT(comb.vertices(), 80U);
  const Region shrunk = comb.shrink(q(2, 10));
  const Region within[] = {box(200, 200, 40'800, 1800), box(1200, 200, 1800, 3800)};
  for (const Region& each : within) {
    EXPECT_TRUE(shrunk.contains(each));
    EXPECT_FALSE(shrunk.contains(each.grow(q(1, 1'000'000))));
  }
}

// However a number is written, as `by_m` of some callers: 150/1000 is 3/20.
TEST(Shrink, TakesDistancesThatAreNotInLowestTerms) {
  const Region around = Region::everywhere().subtract(box(0, 0, 12000, 5000));
  for (const long mm : {150L, 160L, 300L, 1150L}) {
    Rational lowest(mm, 1000);
    lowest.canonicalize();
    const Rational as_written(mm, 1000);
    EXPECT_EQ(text(around.shrink(as_written)), text(around.shrink(lowest))) << mm;
    EXPECT_EQ(text(around.grow(as_written)), text(around.grow(lowest))) << mm;
  }
}

TEST(Shrink, ZeroOrNegativeChangesNothing) {
  const Region region = delivery_free();
  EXPECT_EQ(text(region.shrink(q(0))), text(region));
  EXPECT_EQ(text(region.grow(q(-1))), text(region));
}

TEST(Shrink, HoleGetsStraightSidesAndRoundCorners) {
  const Region region =
      polygon(box_ring(0, 0, 5000, 5000), {box_ring(2000, 2000, 3000, 3000)}).shrink(q(1, 2));
  EXPECT_TRUE(region.contains(Point{q(5, 2), q(3, 2)}));
  EXPECT_FALSE(region.contains(Point{q(5, 2), q(3, 2) + q(1, 1000000)}));
  EXPECT_TRUE(region.contains(Point{q(2), q(3, 2)}));
  // At 45 degrees from the corner (2, 2): 0.5 m is at 0.353553 in x and y, plus at most 1 mm.
  EXPECT_FALSE(region.contains(Point{q(2) - q(353553, 1000000), q(2) - q(353553, 1000000)}));
  EXPECT_TRUE(region.contains(Point{q(2) - q(3545, 10000), q(2) - q(3545, 10000)}));
}

TEST(Shrink, RegionCutAtANarrowPassage) {
  // Two rooms with a door of 0.4 m: 0.2 m closes it, 0.19 m does not.
  const Region rooms = polygon(box_ring(0, 0, 4000, 2000))
                           .subtract(box(1900, 0, 2100, 800))
                           .subtract(box(1900, 1200, 2100, 2000));
  EXPECT_EQ(rooms.shrink(q(19, 100)).polygons().size(), 1U);
  EXPECT_EQ(rooms.shrink(q(2, 10)).polygons().size(), 2U);
}

TEST(Shrink, TouchingPartsAndHolesAreBoundaryToo) {
  // Nothing near the corner where two squares touch survives.
  const Region touching = box(0, 0, 1000, 1000).unite(box(1000, 1000, 2000, 2000));
  EXPECT_EQ(text(touching.shrink(q(1, 10))),
            text(box(100, 100, 900, 900).unite(box(1100, 1100, 1900, 1900))));
}

// Exactly: inside the region, and no edge of one closer than `distance` to an edge of the other.
void expect_shrunk(const Region& region, const Region& result, const Rational& distance) {
  EXPECT_TRUE(region.contains(result));
  if (result.empty()) return;
  EXPECT_GE(squared_distance(boundary(result), boundary(region)), distance * distance);
}

void expect_grown(const Region& region, const Region& result, const Rational& distance) {
  EXPECT_TRUE(result.contains(region));
  EXPECT_GE(squared_distance(boundary(result), boundary(region)), distance * distance);
}

Point random_point(Random& random) {
  return {q(pick(random, -1000000, 6000000), 1000003), q(pick(random, -1000000, 6000000), 1000003)};
}

// A rough ring about the origin: 240 vertices about 4 cm apart, on radii of 1 m to 1.2 m.
Region rough_ring(Random& random) {
  Ring ring;
  for (long i = 0; i < 240; ++i) {
    // Directions of four quarters by equal steps of a tangent, close enough to a circle.
    const Rational t = q(i % 60, 60), square = t * t;
    Point u{(1 - square) / (1 + square), 2 * t / (1 + square)};
    for (long k = 0; k < i / 60; ++k) u = {-u.y, u.x};
    const Rational radius = q(pick(random, 1000, 1200), 1000);
    ring.push_back({radius * u.x, radius * u.y});
  }
  return polygon(ring);
}

TEST(Shrink, DistancesOfManyEdgesAreOneSidedAndTight) {
  // Every piece of the band overlaps dozens of others, which are united in groups.
  Random random(5);
  const Region region = rough_ring(random);
  const std::vector<Segment> edges = boundary(region);
  for (const Rational& distance : {q(3, 10), q(7, 10)}) {
    const Region smaller = region.shrink(distance), larger = region.grow(distance);
    expect_shrunk(region, smaller, distance);
    expect_grown(region, larger, distance);
    const Rational enough = distance + offset_excess_m();
    for (int k = 0; k < 300; ++k) {
      const Point p{q(pick(random, -2000000, 2000000), 1000003),
                    q(pick(random, -2000000, 2000000), 1000003)};
      if (squared_distance(p, edges) < enough * enough) continue;
      EXPECT_EQ(smaller.contains(p), region.contains(p));
      EXPECT_EQ(larger.contains(p), region.contains(p));
    }
  }
}

TEST(Shrink, RandomRegionsAreOneSidedAndTight) {
  Random random(3);
  int kept = 0;
  for (int i = 0; i < 25; ++i) {
    const Region region = random_region(random, 4, i % 2 == 0 ? 1 : 13);
    const Rational distance = q(pick(random, 1, 400), 1000);
    const Region result = region.shrink(distance);
    expect_shrunk(region, result, distance);
    const std::vector<Segment> edges = boundary(region);
    const Rational enough = distance + offset_excess_m();
    for (int k = 0; k < 150; ++k) {
      const Point p = random_point(random);
      const Rational squared = squared_distance(p, edges);
      const bool inside = region.contains(p);
      if (inside && squared >= enough * enough) {
        EXPECT_TRUE(result.contains(p)) << i;
        ++kept;
      } else if (!inside || squared < distance * distance) {
        EXPECT_FALSE(result.contains(p)) << i;
      }
    }
  }
  EXPECT_GT(kept, 200);
}

TEST(Grow, RandomRegionsAreOneSidedAndTight) {
  Random random(4);
  int gained = 0;
  for (int i = 0; i < 25; ++i) {
    const Region region = random_region(random, 4, i % 2 == 0 ? 1 : 13);
    const Rational distance = q(pick(random, 1, 400), 1000);
    const Region result = region.grow(distance);
    expect_grown(region, result, distance);
    const std::vector<Segment> edges = boundary(region);
    const Rational most = distance + offset_excess_m();
    for (int k = 0; k < 150; ++k) {
      const Point p = random_point(random);
      const Rational squared = squared_distance(p, edges);
      if (region.contains(p) || squared <= distance * distance) {
        EXPECT_TRUE(result.contains(p)) << i;
        gained += region.contains(p) ? 0 : 1;
      } else if (squared > most * most) {
        EXPECT_FALSE(result.contains(p)) << i;
      }
    }
  }
  EXPECT_GT(gained, 100);
}

TEST(Shrink, ChainsDoNotExplode) {
  // Ten steps of 1 cm against one of 10 cm: more is lost, never less, in bounded time.
  Region region = delivery_free();
  for (int i = 0; i < 10; ++i) region = region.shrink(q(1, 100));
  EXPECT_TRUE(delivery_free().shrink(q(98, 1000)).contains(region));
  expect_shrunk(delivery_free(), region, q(98, 1000));
}

TEST(Shrink, LargeDistancesAndCoordinates) {
  const long km = 1000000;
  const Region region = polygon({mm(-500 * km, -500 * km), mm(500 * km, -400 * km),
                                 mm(450 * km, 500 * km), mm(0, 0), mm(-400 * km, 450 * km)});
  const Region result = region.shrink(q(30000));
  EXPECT_FALSE(result.empty());
  expect_shrunk(region, result, q(30000));
  expect_grown(region, region.grow(q(1, 1000)), q(1, 1000));
}

TEST(Shrink, WhatCannotBeWideEnoughIsEmptyAtOnce) {
  EXPECT_TRUE(box(0, 0, 5000, 5000).shrink(q(1'000'000'000'000)).empty());
  EXPECT_TRUE(box(0, 0, 5000, 9000).unite(box(6000, 0, 9000, 9000)).shrink(q(5, 2)).empty());
  EXPECT_EQ(box(0, 0, 5000, 9000).unite(box(6000, 0, 9000, 9000)).shrink(q(2)).vertices(), 4U);
}

// The unit vector at the angle 2 atan t, in (0, 90) degrees.
Point direction(const Rational& t) {
  const Rational square = t * t;
  return {(1 - square) / (1 + square), 2 * t / (1 + square)};
}

// A place whose distance from a square of 10 m about the origin is exact: that of its corner.
Point off_corner(const Point& u, const Rational& distance) {
  return {5 + distance * u.x, 5 + distance * u.y};
}
std::vector<Point> angles(Random& random) {
  std::vector<Point> all;
  // corners of polygons of few directions, where they stick out most
  for (const long k : {0L, 1L, 17L, 200L, 511L, 900L, 1023L})
    all.push_back(direction(q(2 * k + 1, 2048)));
  for (int i = 0; i < 15; ++i) all.push_back(direction(q(pick(random, 1, 999'999), 1'000'000)));
  return all;
}
const Rational hair = q(1, 1'000'000'000);

TEST(Grow, ReachesNoFartherThanPromisedAtAnyDistance) {
  Random random(11);
  for (const long distance : {3'400L, 9'260L, 40'000L, 100'000L}) {
    const Region grown = box(-5000, -5000, 5000, 5000).grow(q(distance));
    for (const Point& u : angles(random)) {
      EXPECT_TRUE(grown.contains(off_corner(u, q(distance)))) << distance;
      EXPECT_FALSE(grown.contains(off_corner(u, q(distance) + offset_excess_m() + hair)))
          << distance;
    }
    EXPECT_TRUE(grown.contains(Point{q(5 + distance), q(4)}));
    EXPECT_FALSE(grown.contains(Point{q(5 + distance) + hair, q(4)}));
  }
}

TEST(Shrink, ReachesNoFartherThanPromisedAtAnyDistance) {
  Random random(12);
  const long km = 1'000'000;
  const Region around = polygon(box_ring(-300 * km, -300 * km, 300 * km, 300 * km),
                                {box_ring(-5000, -5000, 5000, 5000)});
  for (const long distance : {9'260L, 100'000L}) {
    const Region shrunk = around.shrink(q(distance));
    for (const Point& u : angles(random)) {
      EXPECT_FALSE(shrunk.contains(off_corner(u, q(distance) - hair))) << distance;
      EXPECT_TRUE(shrunk.contains(off_corner(u, q(distance) + offset_excess_m()))) << distance;
    }
  }
}

// Each takes its share: as many as there are, one within another, stay within the promise together.
TEST(Grow, OffsetsWithinOneAnotherShareWhatIsGivenAway) {
  Random random(13);
  const Region square = box(-5000, -5000, 5000, 5000);
  const Region twice = square.grow(q(12'000), 2).grow(q(5'000), 2);
  const Region back = square.grow(q(12'000), 2).shrink(q(5'000) - offset_excess_m(2), 2);
  for (const Point& u : angles(random)) {
    EXPECT_TRUE(twice.contains(off_corner(u, q(17'000))));
    EXPECT_FALSE(twice.contains(off_corner(u, q(17'000) + offset_excess_m() + hair)));
    EXPECT_TRUE(back.contains(off_corner(u, q(7'000))));
    EXPECT_FALSE(back.contains(off_corner(u, q(7'000) + offset_excess_m() + hair)));
  }
}

// As the language reference says of circles of files, which move by the error of the map: a corner
// of them becomes two, with an edge between; few become three.
TEST(Widened, ACircleHasAboutThreeEdgesForEachAtMost) {
  for (const auto& [radius_m, error] : {std::pair{1L, q(1, 100'000)},
                                        {300L, q(1, 50'000)},
                                        {3'000L, q(53, 100'000)},
                                        {10'000L, q(11, 1000)},
                                        {30'000L, q(1, 4)}}) {
    const std::size_t edges = circle_edges(q(radius_m));
    for (const bool grows : {false, true}) {
      const Region circle = Region::circle({q(7), q(9)}, q(radius_m), !grows);
      for (const auto& moved : {circle.widened(grows ? error : Rational(-error)),
                                circle.offset(grows ? error : Rational(-error))}) {
        ASSERT_TRUE(moved);
        EXPECT_LE(moved->vertices(), 3 * edges + edges / 4) << radius_m;
      }
    }
  }
}

}  // namespace
}  // namespace rtac::geometry
