// Zones with height: what operations do to slabs, which places belong to them, and the grid.
#include "compiler/geometry/solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/compiler/geometry/testing.h"

namespace rtac::geometry {
namespace {

Region square(const Rational& low, const Rational& high) {
  return std::get<Region>(
      Region::polygon({{low, low}, {high, low}, {high, high}, {low, high}}, {}));
}
Solid cube(int low, int high) {
  return Solid::prism(square(low, high), low, high);
}
// "0..2: 4, 2..5: 1": heights and areas.
std::string shown(const Solid& solid) {
  std::string text;
  for (const Slab& slab : solid.slabs()) {
    text += (text.empty() ? "" : ", ") + slab.floor.get_str() + ".." + slab.ceiling.get_str() +
            ": " + slab.region.area().get_str();
  }
  return text;
}

TEST(Solid, OfNoHeightOrNoBaseIsEmpty) {
  EXPECT_TRUE(Solid::prism(square(0, 1), 2, 2).empty());
  EXPECT_TRUE(Solid::prism(square(0, 1), 2, 1).empty());
  EXPECT_TRUE(Solid::prism({}, 1, 2).empty());
}

// A stack that is the same all the way up is one slab.
TEST(Solid, HasOneSlabForNeighboursThatAreEqual) {
  const Region base = square(0, 2);
  EXPECT_EQ(shown(Solid::prism(base, 0, 2).unite(Solid::prism(base, 2, 5))), "0..5: 4");
  EXPECT_EQ(shown(Solid::prism(base, 0, 2).unite(Solid::prism(base, 3, 5))), "0..2: 4, 3..5: 4");
  EXPECT_EQ(shown(Solid::prism(base, 0, 2).unite(Solid::prism(square(0, 1), 2, 5))),
            "0..2: 4, 2..5: 1");
}

TEST(Solid, IsCombinedSlabBySlab) {
  const Solid a = cube(0, 3), b = cube(1, 5);
  EXPECT_EQ(shown(a.unite(b)), "0..1: 9, 1..3: 21, 3..5: 16");
  EXPECT_EQ(shown(a.intersect(b)), "1..3: 4");
  EXPECT_EQ(shown(a.subtract(b)), "0..1: 9, 1..3: 5");
  EXPECT_TRUE(a.subtract(a).empty());
  EXPECT_TRUE(a.intersect(Solid::prism(square(0, 3), 3, 4)).empty());
}

// Of random cubes: a place on no boundary is in what its operands say.
TEST(Solid, ContainsWhatItsOperandsSay) {
  std::mt19937 random(5);
  const auto number = [&](int most) {
    return static_cast<int>(random() % static_cast<unsigned>(most));
  };
  const auto any = [&] {
    Solid solid;
    for (int i = 0; i < 3; ++i) {
      const int low = number(8), z = number(8);
      solid = solid.unite(Solid::prism(square(low, low + 1 + number(4)), z, z + 1 + number(4)));
    }
    return solid;
  };
  for (int round = 0; round < 40; ++round) {
    const Solid a = any(), b = any();
    const Solid sum = a.unite(b), both = a.intersect(b), rest = a.subtract(b);
    for (int i = 0; i < 50; ++i) {
      const Rational half(1, 2);
      const Point p{number(12) + half, number(12) + half};
      const Rational z = number(12) + half;
      const bool in_a = a.contains(p, z), in_b = b.contains(p, z);
      EXPECT_EQ(sum.contains(p, z), in_a || in_b);
      EXPECT_EQ(both.contains(p, z), in_a && in_b);
      EXPECT_EQ(rest.contains(p, z), in_a && !in_b);
    }
  }
}

TEST(Solid, ContainsItsBoundary) {
  const Solid solid = cube(0, 3).subtract(cube(1, 2));
  EXPECT_TRUE(solid.contains({0, 0}, 0));
  EXPECT_TRUE(solid.contains({3, 3}, 3));
  EXPECT_TRUE(solid.contains({Rational(3, 2), Rational(3, 2)}, 1));
  EXPECT_FALSE(solid.contains({Rational(3, 2), Rational(3, 2)}, Rational(3, 2)));
  EXPECT_FALSE(solid.contains({1, 1}, Rational(3001, 1000)));
}

// Offsets: sideways as in the plane, and exactly so far up and down.
TEST(Solid, GrowsUpAndDownAsWell) {
  const Solid grown = cube(0, 2).grow(1, Rational(1, 2));
  ASSERT_EQ(grown.slabs().size(), 1U);
  EXPECT_EQ(grown.slabs()[0].floor, Rational(-1, 2));
  EXPECT_EQ(grown.slabs()[0].ceiling, Rational(5, 2));
  EXPECT_TRUE(grown.contains({-1, 1}, 1));
  EXPECT_FALSE(grown.contains({Rational(-1003, 1000), 1}, 1));
}
// A step of a stack leaves room for what has to fit above and below it.
TEST(Solid, ShrinksBelowAndAboveEveryStep) {
  const Solid stack = Solid::prism(square(0, 10), 0, 4).unite(Solid::prism(square(2, 8), 4, 8));
  EXPECT_EQ(shown(stack.shrink(0, 1)), "1..3: 100, 3..7: 36");
  EXPECT_EQ(shown(stack.shrink(1, 1)), "1..3: 64, 3..7: 16");
  EXPECT_TRUE(stack.shrink(1, 4).empty());
  // a gap in height is a boundary, too
  const Solid gap = Solid::prism(square(0, 4), 0, 3).unite(Solid::prism(square(0, 4), 4, 9));
  EXPECT_EQ(shown(gap.shrink(0, 1)), "1..2: 16, 5..8: 16");
}
// What is left has room for what was taken away, and what has grown has it inside.
TEST(Solid, ShrinksAndGrowsToTheSafeSide) {
  const Solid stack = cube(0, 6).subtract(Solid::prism(square(2, 4), 3, 9));
  const Solid shrunk = stack.shrink(1, 1);
  EXPECT_FALSE(shrunk.empty());
  EXPECT_TRUE(shrunk.grow(Rational(999, 1000), 1).subtract(stack).empty());
  EXPECT_TRUE(stack.subtract(stack.grow(1, 1).shrink(Rational(99, 100), 1)).empty());
}

// ---- the grid

TEST(SnappedSolid, OnTheGridIsTheSame) {
  const Solid solid = cube(0, 3).subtract(cube(1, 2));
  for (const auto& snapped : {snap_inside(solid), snap_around(solid)}) {
    ASSERT_TRUE(snapped);
    ASSERT_EQ(snapped->size(), 3U);
    EXPECT_EQ((*snapped)[1].floor_mm, 1000);
    EXPECT_EQ((*snapped)[1].ceiling_mm, 2000);
    EXPECT_EQ(to_region((*snapped)[1].zone).area(), 8);
  }
}
// Between two steps of the grid lies what both slabs have, or what either has.
TEST(SnappedSolid, OffTheGridLiesWithinOrAround) {
  const Rational seam(20004, 10000), top(40006, 10000);
  const Solid solid = Solid::prism(square(0, 4), Rational(3, 10000), seam)
                          .unite(Solid::prism(square(1, 3), seam, top));
  const auto within = snap_inside(solid), around = snap_around(solid);
  ASSERT_TRUE(within && around);
  const auto shown = [](const SnappedSolid& snapped) {
    std::string text;
    for (const SnappedSlab& slab : snapped) {
      text += std::to_string(slab.floor_mm) + ".." + std::to_string(slab.ceiling_mm) + ": " +
              to_region(slab.zone).area().get_str() + " ";
    }
    return text;
  };
  EXPECT_EQ(shown(*within), "1..2000: 16 2000..2001: 4 2001..4000: 4 ");
  EXPECT_EQ(shown(*around), "0..1: 16 1..2000: 16 2000..2001: 16 2001..4000: 4 4000..4001: 4 ");
}
TEST(SnappedSolid, ThinnerThanTheGridIsEmpty) {
  const auto within =
      snap_inside(Solid::prism(square(0, 1), Rational(1, 10000), Rational(9, 10000)));
  ASSERT_TRUE(within);
  EXPECT_TRUE(within->empty());
}
TEST(SnappedSolid, BeyondTheGridIsNone) {
  EXPECT_FALSE(snap_inside(Solid::prism(square(0, 1), 0, 600000)));
  EXPECT_FALSE(snap_around(Solid::prism(square(0, 1), -600000, 0)));
  EXPECT_TRUE(snap_around(Solid::everywhere()));
}

// Beside an edge a ball comes nearer than what is as high and as wide: no place where it fits is
// left out, and at walls and over roofs none is there where it does not.
TEST(Solid, ShrinkByABallLeavesOutNoPlaceWhereItFits) {
  const Solid around = cube(-20, 20).subtract(cube(0, 4));
  const Solid balls = around.shrink_by_ball(2), cylinders = around.shrink(2, 2);
  EXPECT_TRUE(cylinders.subtract(balls).empty());
  std::mt19937 random(5);
  int at_edges = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto tenth = [&] { return static_cast<int>(random() % 80U) - 20; };
    const int x = tenth(), y = tenth(), z = tenth();
    const auto off = [](int at) { return std::max({-at, at - 40, 0}); };
    const int square = off(x) * off(x) + off(y) * off(y) + off(z) * off(z);
    const Point p{q(x, 10), q(y, 10)};
    if (square >= 20 * 20) {
      EXPECT_TRUE(balls.contains(p, q(z, 10))) << x << ", " << y << ", " << z;
      at_edges += cylinders.contains(p, q(z, 10)) ? 0 : 1;
    }
    const auto beside = [](int at) { return at > 0 && at < 40; };
    const bool straight = beside(x) + beside(y) + beside(z) >= 2;
    if (straight && square < 19 * 19) {
      EXPECT_FALSE(balls.contains(p, q(z, 10))) << x << ", " << y << ", " << z;
    }
  }
  EXPECT_GT(at_edges, 20);
}

}  // namespace
}  // namespace rtac::geometry
