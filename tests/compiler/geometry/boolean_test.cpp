// Union, intersection and difference against hand results and exact identities of areas; the
// canonical form that makes everything built on it repeatable.
#include <gtest/gtest.h>

#include "testing.h"

namespace rtac::geometry {
namespace {

TEST(Boolean, DeliveryZoneByHand) {
  const Region free = delivery_free();
  EXPECT_EQ(free.area(), q(25) - 1 - 1 - q(6, 10));
  const auto parts = free.polygons();
  ASSERT_EQ(parts.size(), 1U);
  // The southern shelf stands at the wall and notches the outer ring; the others are holes.
  EXPECT_EQ(parts[0].outer.size(), 8U);
  ASSERT_EQ(parts[0].holes.size(), 2U);
  EXPECT_EQ(parts[0].holes[0].front().x, 1);
  EXPECT_EQ(parts[0].holes[1].front().x, 2);
}

TEST(Boolean, SquaresThatTouchAtACornerStayTwoParts) {
  const Region both = box(0, 0, 1000, 1000).unite(box(1000, 1000, 2000, 2000));
  EXPECT_EQ(text(both), "part\n(0 0)(1 0)(1 1)(0 1)\npart\n(1 1)(2 1)(2 2)(1 2)\n");
}

TEST(Boolean, SquaresThatShareAnEdgeBecomeOneWithoutCollinearVertices) {
  EXPECT_EQ(text(box(0, 0, 1000, 1000).unite(box(1000, 0, 2000, 1000))),
            "part\n(0 0)(2 0)(2 1)(0 1)\n");
}

TEST(Boolean, HoleThatTouchesTheOuterRingIsAHoleOfItsOwn) {
  const Region region = box(0, 0, 4000, 4000).subtract(polygon({pt(0, 2), pt(2, 1), pt(2, 3)}));
  EXPECT_EQ(text(region), "part\n(0 0)(4 0)(4 4)(0 4)\n(2 1)(0 2)(2 3)\n");
  EXPECT_TRUE(region.contains(pt(0, 2)));
  EXPECT_FALSE(region.contains(pt(1, 2)));
}

TEST(Boolean, ChainOfTouchingHolesThatCutsTheRegionMakesTwoParts) {
  const Region cut = box(0, 0, 4000, 4000)
                         .subtract(polygon({pt(0, 2), pt(1, 1), pt(2, 2), pt(1, 3)}))
                         .subtract(polygon({pt(2, 2), pt(3, 1), pt(4, 2), pt(3, 3)}));
  EXPECT_EQ(cut.polygons().size(), 2U);
  EXPECT_EQ(cut.area(), 12);
}

TEST(Boolean, RegularisationDropsCommonBoundary) {
  EXPECT_TRUE(box(0, 0, 1000, 1000).intersect(box(1000, 0, 2000, 1000)).empty());
  EXPECT_TRUE(box(0, 0, 1000, 1000).subtract(box(0, 0, 1000, 1000)).empty());
}

TEST(Boolean, EmptyIsNeutral) {
  const Region none;
  const Region one = box(0, 0, 1000, 1000);
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.area(), 0);
  EXPECT_FALSE(none.contains(pt(0, 0)));
  EXPECT_TRUE(one.contains(none));
  EXPECT_FALSE(none.contains(one));
  EXPECT_EQ(text(none.unite(one)), text(one));
  EXPECT_TRUE(none.intersect(one).empty());
  EXPECT_TRUE(none.shrink(q(1)).empty());
  EXPECT_TRUE(none.grow(q(1)).empty());
}

TEST(Boolean, ContainsIsClosed) {
  const Region ring = polygon(box_ring(0, 0, 3000, 3000), {box_ring(1000, 1000, 2000, 2000)});
  EXPECT_TRUE(ring.contains(pt(0, 0)));
  EXPECT_TRUE(ring.contains(Point{q(3, 2), q(0)}));
  EXPECT_TRUE(ring.contains(pt(1, 1)));
  EXPECT_TRUE(ring.contains(Point{q(3, 2), q(1)}));
  EXPECT_FALSE(ring.contains(Point{q(3, 2), q(3, 2)}));
  EXPECT_FALSE(ring.contains(Point{q(3, 2), q(-1, 1000000)}));
  EXPECT_FALSE(ring.contains(Point{q(3, 2), q(1000001, 1000000)}));
}

TEST(Boolean, ContainsARegionExactly) {
  const Region big = box(0, 0, 3000, 3000);
  EXPECT_TRUE(big.contains(big));
  EXPECT_TRUE(big.contains(box(0, 0, 3000, 1000)));
  const Region over = polygon({pt(0, 0), pt(1, 0), {q(3000000001, 1000000000), q(1)}});
  EXPECT_FALSE(big.contains(over));
}

TEST(Boolean, CircleIsOneSided) {
  const Point centre{q(1, 3), q(-2, 7)};
  const Rational radius = q(11, 100);
  const Region inner = Region::circle(centre, radius, true);
  const Region outer = Region::circle(centre, radius, false);
  const Ring corners = inner.polygons()[0].outer;
  ASSERT_EQ(corners.size(), 32U);
  ASSERT_EQ(boundary(outer).size(), 32U);
  for (const Point& p : corners) {
    const Rational x = p.x - centre.x, y = p.y - centre.y;
    EXPECT_EQ(Rational(x * x + y * y), radius * radius);
  }
  // Tangents: at exactly one radius from the centre.
  EXPECT_EQ(squared_distance(centre, boundary(outer)), radius * radius);
  EXPECT_TRUE(outer.contains(inner));
  EXPECT_LT(outer.area() - inner.area(), radius * radius * q(6, 100));
  EXPECT_TRUE(Region::circle(centre, q(0), true).empty());
}

TEST(Boolean, WindingOfHeapsOfRings) {
  // Overlapping pieces count once, and a clockwise ring removes one layer only.
  Ring clockwise = box_ring(0, 0, 1000, 1000);
  std::reverse(clockwise.begin(), clockwise.end());
  const Ring piece = box_ring(0, 0, 2000, 1000);
  EXPECT_EQ(text(Region::of_rings({piece, piece})), text(polygon(piece)));
  EXPECT_EQ(text(Region::of_rings({piece, piece, clockwise})), text(polygon(piece)));
  EXPECT_EQ(text(Region::of_rings({piece, clockwise})), text(box(1000, 0, 2000, 1000)));
}

TEST(Boolean, AreaIdentitiesOnRandomRegions) {
  Random random(1);
  for (int i = 0; i < 60; ++i) {
    const Region a = random_region(random, 4, 1);
    const Region b = random_region(random, 4, 7);
    const Region both = a.intersect(b);
    const Region either = a.unite(b);
    const Region rest = a.subtract(b);
    EXPECT_EQ(either.area() + both.area(), a.area() + b.area());
    EXPECT_EQ(rest.area() + both.area(), a.area());
    EXPECT_TRUE(either.contains(a));
    EXPECT_TRUE(a.contains(both));
    EXPECT_TRUE(a.contains(rest));
    // The canonical form does not remember how a region came about.
    EXPECT_EQ(text(rest.unite(both)), text(a));
    EXPECT_EQ(text(either), text(b.unite(a)));
    EXPECT_EQ(text(both), text(b.intersect(a)));
    EXPECT_EQ(text(either.subtract(b)), text(rest));
  }
}

TEST(Boolean, GridAlignedPiecesGiveTheSameCanonicalForm) {
  // Unit squares on a 6 x 6 board: shared edges, touching corners and holes everywhere. The area
  // and every square's membership are known, and the order of the operations does not matter.
  Random random(2);
  for (int i = 0; i < 60; ++i) {
    std::vector<int> board(36);
    for (int& cell : board) cell = static_cast<int>(random() % 2);
    Region forward, backward = box(0, 0, 6000, 6000);
    for (long k = 0; k < 36; ++k) {
      const long x = k % 6 * 1000, y = k / 6 * 1000;
      if (board[static_cast<std::size_t>(k)] != 0) {
        forward = forward.unite(box(x, y, x + 1000, y + 1000));
      } else {
        backward = backward.subtract(box(x, y, x + 1000, y + 1000));
      }
    }
    EXPECT_EQ(text(forward), text(backward));
    EXPECT_EQ(forward.area(), std::count(board.begin(), board.end(), 1));
    for (long k = 0; k < 36; ++k) {
      EXPECT_EQ(forward.contains(mm(k % 6 * 1000 + 500, k / 6 * 1000 + 500)),
                board[static_cast<std::size_t>(k)] != 0);
    }
  }
}

}  // namespace
}  // namespace rtac::geometry
