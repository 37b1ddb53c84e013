// Straight ways against the boundary of a zone, on exact numbers: what legs of plans are judged by.
#include <gtest/gtest.h>

#include "compiler/interp/outline.h"

namespace rtac::interp {
namespace {

// 10 m wide, with a hole in the middle from (4, 4) to (6, 6).
Outline frame() {
  const auto square = [](int low, int high) {
    return geometry::Ring{{low, low}, {high, low}, {high, high}, {low, high}};
  };
  const auto made = geometry::Region::polygon(square(0, 10), {square(4, 6)});
  return Outline(std::get<geometry::Region>(made));
}

// A way between two good places may leave through a hole, or by the smallest part of a corner.
TEST(Ways, ThatCrossTheBoundaryLeave) {
  const Outline zone = frame();
  EXPECT_FALSE(zone.contains({1, 5}, {9, 5}));
  EXPECT_FALSE(zone.contains({1, 5}, {11, 5}));
  EXPECT_FALSE(zone.contains({3, 5}, {5, 3 + Rational(1, 1000000)}));
  EXPECT_EQ(zone.distance({1, 5}, {9, 5}).above, 0);
}

// The boundary belongs to the zone: ways along it and through its corners stay inside.
TEST(Ways, ThatTouchTheBoundaryStay) {
  const Outline zone = frame();
  EXPECT_TRUE(zone.contains({0, 0}, {10, 0}));
  EXPECT_TRUE(zone.contains({4, 1}, {4, 9}));
  EXPECT_TRUE(zone.contains({3, 5}, {5, 3}));
  EXPECT_TRUE(zone.contains({1, 1}, {4, 4}));
  EXPECT_EQ(zone.distance({3, 5}, {5, 3}).above, 0);
  EXPECT_FALSE(zone.contains({4, 4}, {6, 6}));
  EXPECT_FALSE(zone.contains({-1, 0}, {11, 0}));
}

TEST(Ways, AreAsFarFromTheBoundaryAsTheirNearestPlace) {
  const Outline zone = frame();
  EXPECT_EQ(zone.distance({1, 2}, {9, 3}).below, 1);
  EXPECT_EQ(zone.distance({-3, -2}, {12, -2}).below, 2);
  const Root corner = zone.distance({3, 3}, {2, 2});  // to (4, 4)
  EXPECT_LE(corner.below * corner.below, 2);
  EXPECT_GE(corner.above * corner.above, 2);
}

// A single way-point is a way of no length.
TEST(Ways, MayHaveNoLength) {
  const Outline zone = frame();
  EXPECT_TRUE(zone.contains({2, 2}, {2, 2}));
  EXPECT_TRUE(zone.contains({4, 5}, {4, 5}));
  EXPECT_FALSE(zone.contains({5, 5}, {5, 5}));
  EXPECT_EQ(zone.distance({5, 5}, {5, 5}).below, 1);
}

}  // namespace
}  // namespace rtac::interp
