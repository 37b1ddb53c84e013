// Large outlines are moved at once: never nearer to the old boundary than asked, hardly farther,
// and left to the thorough way where that does not work out.
#include "compiler/geometry/moved.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rtac::geometry {
namespace {

using Parts = std::vector<PolygonWithHoles>;

Point at(double x_m, double y_m) {
  Rational x(std::lround(x_m * 1e6), 1'000'000UL), y(std::lround(y_m * 1e6), 1'000'000UL);
  x.canonicalize(), y.canonicalize();
  return {x, y};
}
// A ring about a place whose radius goes up and down, with some noise.
Ring star(double x_m, double y_m, double radius_m, int count, unsigned seed, bool hole = false) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-1, 1);
  Ring ring;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * 3.14159265358979 * i / count * (hole ? -1 : 1);
    const double r = radius_m * (1 + 0.2 * std::sin(5 * angle) + 0.3 * noise(random) / count);
    ring.push_back(at(x_m + r * std::cos(angle), y_m + r * std::sin(angle)));
  }
  return ring;
}
Region region_of(const Parts& parts) {
  std::vector<Ring> rings;
  for (const PolygonWithHoles& part : parts) {
    rings.push_back(part.outer);
    rings.insert(rings.end(), part.holes.begin(), part.holes.end());
  }
  return Region::of_rings(rings);
}
double distance(const Point& p, const Ring& ring) {
  double least = 1e300;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double dx = Rational(b.x - a.x).get_d(), dy = Rational(b.y - a.y).get_d();
    const double qx = Rational(p.x - a.x).get_d(), qy = Rational(p.y - a.y).get_d();
    const double t = std::clamp((qx * dx + qy * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    least = std::min(least, std::hypot(qx - t * dx, qy - t * dy));
  }
  return least;
}
double distance(const Point& p, const Parts& parts) {
  double least = 1e300;
  for (const PolygonWithHoles& part : parts) {
    least = std::min(least, distance(p, part.outer));
    for (const Ring& hole : part.holes) least = std::min(least, distance(p, hole));
  }
  return least;
}

const Parts& island() {
  static const Parts parts = {
      {star(0, 0, 500, 900, 1), {star(100, 0, 50, 120, 2, true), star(-120, 30, 40, 80, 3, true)}},
      {star(2000, 100, 300, 400, 4), {}}};
  return parts;
}

// Vertices of either boundary are at that distance from the other one, at least, and at most 1 mm
// more; and the result lies on the right side, exactly.
void expect_moved(const Rational& by, BandSide side) {
  const auto moved = moved_at_once(island(), by, offset_excess_m(), side);
  ASSERT_TRUE(moved);
  const Region before = region_of(island()), after = region_of(*moved);
  EXPECT_TRUE(side == BandSide::interior ? before.contains(after) : after.contains(before));
  EXPECT_EQ(after.polygons().size(), island().size());
  for (const auto& [from, to] : {std::pair{&island(), &*moved}, std::pair{&*moved, &island()}}) {
    for (const PolygonWithHoles& part : *from) {
      std::vector<Ring> rings = part.holes;
      rings.push_back(part.outer);
      for (const Ring& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); i += 7) {
          const double gap = distance(ring[i], *to);
          EXPECT_GE(gap, by.get_d());
          EXPECT_LE(gap, by.get_d() + 0.001);
        }
      }
    }
  }
}

TEST(Moved, InwardsKeepsTheDistance) {
  expect_moved(Rational(1, 1000), BandSide::interior);
  expect_moved(Rational(13, 200'000), BandSide::interior);
}
TEST(Moved, OutwardsKeepsTheDistance) {
  expect_moved(Rational(1, 1000), BandSide::exterior);
  expect_moved(Rational(1, 50), BandSide::exterior);
}

// The same to a millimetre or two as the thorough way, which is the reference.
TEST(Moved, IsAsTheThoroughWay) {
  const Rational by(3, 1000), more(3, 500);
  const auto moved = moved_at_once({island()[1]}, by, offset_excess_m(), BandSide::interior);
  ASSERT_TRUE(moved);
  const Region small = region_of({island()[1]});
  EXPECT_TRUE(small.shrink(Rational(1, 1000)).contains(region_of(*moved)));
  EXPECT_TRUE(region_of(*moved).contains(small.shrink(more)));
}

// A turn of 2 mrad to go round at a distance of 2 km is 1 mm farther at a corner that stays
// sharp, 0.5 mm at 1 km.
TEST(Moved, CornersThatGoTooFarBecomeRound) {
  const Parts dented = {{{at(-1e5, 0), at(0, 100), at(1e5, 0), at(1e5, 1e5), at(-1e5, 1e5)}, {}}};
  const auto vertices = [&](long distance_m, std::size_t nested) {
    const auto moved =
        moved_at_once(dented, distance_m, offset_excess_m(nested), BandSide::interior);
    return moved ? moved->front().outer.size() : 0;
  };
  EXPECT_EQ(vertices(1'990, 1), 5U);
  EXPECT_EQ(vertices(2'010, 1), 6U);
  EXPECT_EQ(vertices(990, 2), 5U);
  EXPECT_EQ(vertices(1'010, 2), 6U);
}
// Teeth with corners of 60 to 120 degrees, on either side: as the thorough way, and no farther.
TEST(Moved, SharpCornersAreAsTheThoroughWay) {
  Ring teeth;
  for (int k = 0; k < 40; ++k) {
    const double angle = 2 * 3.14159265358979 * k / 40, r = k % 2 == 0 ? 10 : 9;
    teeth.push_back(at(r * std::cos(angle), r * std::sin(angle)));
  }
  const Parts parts = {{teeth, {}}};
  const Region region = region_of(parts);
  const Rational by(1, 10), excess = offset_excess_m();
  for (const BandSide side : {BandSide::interior, BandSide::exterior}) {
    const auto moved = moved_at_once(parts, by, excess, side);
    ASSERT_TRUE(moved);
    EXPECT_GT(moved->front().outer.size(), 60U);
    const Region result = region_of(*moved);
    if (side == BandSide::interior) {
      EXPECT_TRUE(region.shrink(by - excess).contains(result));
      EXPECT_TRUE(result.contains(region.shrink(by + excess)));
    } else {
      EXPECT_TRUE(result.contains(region.grow(by - excess)));
      EXPECT_TRUE(region.grow(by + excess).contains(result));
    }
  }
}
// What may be off by an error is moved by it, at corners by up to twice as much, and hardly grows.
TEST(Moved, AnErrorTakesFewVertices) {
  const Parts coast = {{star(0, 0, 500, 2000, 5), {}}};
  const Region region = region_of(coast);
  const Rational error(1, 2);
  const auto inner = region.widened(-error), outer = region.widened(error);
  ASSERT_TRUE(inner && outer);
  EXPECT_LT(inner->vertices(), region.vertices() * 11 / 10);
  EXPECT_LT(outer->vertices(), region.vertices() * 11 / 10);
  EXPECT_TRUE(region.shrink(error - offset_excess_m()).contains(*inner));
  EXPECT_TRUE(inner->contains(region.shrink(2 * error)));
  EXPECT_TRUE(outer->contains(region.grow(error - offset_excess_m())));
  EXPECT_TRUE(region.grow(2 * error).contains(*outer));
}

// Arcs of hundreds of edges vanish into the corners that they were grown from, and edges between
// them where they move on.
TEST(Moved, EdgesThatVanishLeaveTheirNeighbours) {
  const Region base =
      region_of({{{at(0, 0), at(50, 10), at(70, 60), at(20, 80), at(-10, 40)}, {}}});
  const Rational excess = offset_excess_m();
  const Parts grown = base.grow(100).polygons();
  ASSERT_GT(grown[0].outer.size(), 600U);
  for (const int by_m : {100, 103, 115, 130}) {
    const auto moved = moved_at_once(grown, by_m, excess, BandSide::interior);
    ASSERT_TRUE(moved) << by_m;
    EXPECT_LT(moved->front().outer.size(), 20U);
    const Region result = region_of(*moved);
    EXPECT_TRUE(base.shrink(by_m - 100 - excess).grow(excess).contains(result));
    EXPECT_TRUE(result.contains(base.shrink(by_m - 100 + 2 * excess)));
  }
}
// Rings with bays and teeth, moved until some of them are gone: whatever is found is right at
// random places. Those that fold over are left to the thorough way.
TEST(Moved, IsRightWhereverItIsFound) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> size(0.05, 40), place(-700, 700);
  int found = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Parts coast = {{star(0, 0, 500, 40 + 7 * int(seed), seed), {}}};
    const Region region = region_of(coast);
    const BandSide side = seed % 2 == 0 ? BandSide::interior : BandSide::exterior;
    const double by_m = size(random);
    const auto moved = moved_at_once(coast, at(by_m, 0).x, offset_excess_m(), side);
    if (!moved) continue;
    ++found;
    const Region result = region_of(*moved);
    for (int i = 0; i < 150; ++i) {
      // half of them where it matters
      const Ring& ring = moved->front().outer;
      const Point& near = ring[random() % ring.size()];
      const double off = place(random) / 7e5;
      const Point p = i % 2 == 0 ? at(place(random), place(random))
                                 : at(near.x.get_d() + off, near.y.get_d() + off);
      const bool before = region.contains(p), after = result.contains(p);
      const double gap = distance(p, coast);
      if (before != after) EXPECT_LE(gap, by_m + 0.001) << seed;
      if (before && side == BandSide::interior && after) EXPECT_GE(gap, by_m) << seed;
      if (!before && side == BandSide::exterior && !after) EXPECT_GE(gap, by_m) << seed;
      EXPECT_TRUE(side == BandSide::interior ? before || !after : after || !before);
    }
  }
  EXPECT_GT(found, 30);
}

// What would vanish, fold over itself or touch is not attempted.
TEST(Moved, LeavesWhatDoesNotWorkOut) {
  const Parts needle = {{{at(0, 0), at(100, 0), at(100, 0.5)}, {}}};
  EXPECT_FALSE(moved_at_once(needle, Rational(1), offset_excess_m(), BandSide::interior))
      << "nothing is left";
  const Parts neck = {{{at(0, 0), at(10, 0), at(10, 4.9), at(20, 4.9), at(20, 0), at(30, 0),
                        at(30, 10), at(20, 10), at(20, 5.1), at(10, 5.1), at(10, 10), at(0, 10)},
                       {}}};
  EXPECT_FALSE(moved_at_once(neck, Rational(1, 5), offset_excess_m(), BandSide::interior))
      << "it falls in two";
  EXPECT_TRUE(moved_at_once(neck, Rational(1, 5), offset_excess_m(), BandSide::exterior));
  const Parts gap = {{{at(0, 0), at(10, 0), at(10, 10), at(0, 10)}, {}},
                     {{at(10.001, 0), at(20, 0), at(20, 10), at(10.001, 10)}, {}}};
  EXPECT_FALSE(moved_at_once(gap, Rational(1, 1000), offset_excess_m(), BandSide::exterior))
      << "two become one";
  EXPECT_TRUE(moved_at_once(gap, Rational(1, 1000), offset_excess_m(), BandSide::interior));
  const Parts filled = {{{at(0, 0), at(10, 0), at(10, 10), at(0, 10)},
                         {{at(5, 5), at(5, 5.001), at(5.001, 5.001), at(5.001, 5)}}}};
  EXPECT_FALSE(moved_at_once(filled, Rational(1, 1000), offset_excess_m(), BandSide::exterior))
      << "the hole is gone";
}

// One that a part lies in: the hole of another one, before and after.
TEST(Moved, KeepsPartsInHolesApart) {
  const Parts nested = {{star(0, 0, 500, 300, 1), {star(0, 0, 200, 200, 2, true)}},
                        {star(0, 0, 100, 200, 3), {}}};
  for (const BandSide side : {BandSide::interior, BandSide::exterior}) {
    const auto moved = moved_at_once(nested, Rational(1, 1000), offset_excess_m(), side);
    ASSERT_TRUE(moved);
    EXPECT_EQ(region_of(*moved).polygons().size(), 2U);
  }
}

}  // namespace
}  // namespace rtac::geometry
