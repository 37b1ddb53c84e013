// How far zones are apart, on exact numbers.
#include "compiler/geometry/apart.h"

#include <gtest/gtest.h>

#include "tests/compiler/geometry/testing.h"

namespace rtac::geometry {
namespace {

Rational mm2(long square) {
  return q(square, 1'000'000);
}
// Both ways round.
Rational apart(const Region& a, const Region& b) {
  EXPECT_EQ(square_apart(a, b), square_apart(b, a));
  return square_apart(a, b);
}

TEST(Apart, IsFromCornerToCornerAndFromCornerToEdge) {
  EXPECT_EQ(apart(box(0, 0, 2000, 2000), box(5000, 6000, 7000, 8000)), 25);
  EXPECT_EQ(apart(box(0, 0, 2000, 2000), box(2003, 500, 7000, 700)), mm2(9));
  // of (2, 2) and x + y = 6
  EXPECT_EQ(apart(box(0, 0, 2000, 2000), polygon({pt(6, 0), pt(6, 6), pt(0, 6)})), 2);
}
TEST(Apart, IsNothingWhereTheyMeet) {
  const Region room = box(0, 0, 2000, 2000);
  EXPECT_EQ(apart(room, box(2000, 2000, 3000, 3000)), 0) << "in a vertex";
  EXPECT_EQ(apart(room, box(2000, 500, 3000, 700)), 0) << "in a part of an edge";
  EXPECT_EQ(apart(room, polygon({pt(2, 1), pt(4, 0), pt(4, 2)})), 0) << "a vertex on an edge";
  EXPECT_EQ(apart(room, box(500, 500, 700, 700)), 0) << "one lies within the other";
  // no vertex of one is in the other
  EXPECT_EQ(apart(room, box(-1000, 500, 3000, 700)), 0) << "a cross";
  EXPECT_EQ(apart(room, room), 0);
}
// What is left within a hole, or beside one of several parts.
TEST(Apart, IsToTheNearestRing) {
  const Region ring = polygon(box_ring(0, 0, 9000, 9000), {box_ring(3000, 3000, 6000, 6000)});
  EXPECT_EQ(apart(ring, box(4000, 4100, 5000, 5000)), 1);
  const Region parts = box(0, 0, 1000, 1000).unite(box(20'000, 0, 21'000, 1000));
  EXPECT_EQ(apart(parts, box(24'000, 0, 25'000, 1000)), 9);
}
// A tenth of a micrometre, at the end of the grid.
TEST(Apart, IsExactFarAway) {
  const Rational far = 536'000, gap = q(1, 10'000'000);
  const Region a = polygon({{far, 0}, {Rational(far + 1), 0}, {far, 1}});
  const Rational x = far - gap;
  EXPECT_EQ(apart(a, polygon({{x, 0}, {x, 1}, {Rational(x - 1), 0}})), gap * gap);
}
// Against places on both boundaries, 32 on each edge: none are nearer, and some nearly as near.
TEST(Apart, IsTheLeastOfAllPlaces) {
  std::mt19937 random(11);
  const auto number = [&](int most) {
    return static_cast<long>(random() % static_cast<unsigned>(most));
  };
  const auto triangle = [&](long x, long y) {
    return polygon({mm(x, y), mm(x + 500 + number(3000), y + number(400)),
                    mm(x + number(900), y + 500 + number(3000))});
  };
  const auto places = [](const Region& region) {
    std::vector<std::pair<double, double>> all;
    for (const Ring& ring : region.rings()) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &p = ring[i], &next = ring[(i + 1) % ring.size()];
        for (int k = 0; k < 32; ++k) {
          const double share = k / 32.0;
          all.emplace_back(p.x.get_d() + share * (next.x.get_d() - p.x.get_d()),
                           p.y.get_d() + share * (next.y.get_d() - p.y.get_d()));
        }
      }
    }
    return all;
  };
  int apart_count = 0;
  for (int round = 0; round < 100; ++round) {
    const Region a = triangle(0, 0), b = triangle(number(5000) - 2500, number(5000) - 2500);
    const double found = std::sqrt(apart(a, b).get_d());
    double least = 1e9;
    for (const auto& [x, y] : places(a)) {
      for (const auto& [u, v] : places(b)) least = std::min(least, std::hypot(x - u, y - v));
    }
    ASSERT_LE(found, least + 1e-9);
    if (found == 0) continue;
    ASSERT_GE(found, least - 0.07) << "half of a step on either side";
    ++apart_count;
  }
  EXPECT_GT(apart_count, 20);
}

TEST(Apart, OfZonesWithHeightCountsTheHeightBetween) {
  const Solid hall = Solid::prism(box(0, 0, 2000, 2000), 0, 3);
  EXPECT_EQ(square_apart(hall, Solid::prism(box(0, 0, 1000, 1000), 7, 9)), 16) << "above";
  EXPECT_EQ(square_apart(hall, Solid::prism(box(5000, 0, 6000, 1000), 1, 2)), 9) << "beside";
  EXPECT_EQ(square_apart(hall, Solid::prism(box(5000, 0, 6000, 1000), 7, 9)), 25) << "both";
  EXPECT_EQ(square_apart(Solid::prism(box(5000, 0, 6000, 1000), 7, 9), hall), 25) << "turned round";
  EXPECT_EQ(square_apart(hall, Solid::prism(box(0, 0, 1000, 1000), 3, 4)), 0) << "on top";
  const Solid stack = hall.unite(Solid::prism(box(4000, 0, 5000, 1000), 3, 5));
  EXPECT_EQ(square_apart(stack, Solid::prism(box(6000, 0, 7000, 1000), 4, 5)), 1) << "upper slab";
}

}  // namespace
}  // namespace rtac::geometry
