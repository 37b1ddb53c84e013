// Clearance is what safe controllers steer by and what runs are judged by.
#include "rtac/zone.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/runtime/core/test_zone.h"

namespace rtac {
namespace {

// 5 m square with a 1 m x 1 m hole in (2, 2)-(3, 3).
const test::TestZone& room() {
  static const test::TestZone zone({{{0, 0}, {5000, 0}, {5000, 5000}, {0, 5000}},
                                    {{2000, 2000}, {2000, 3000}, {3000, 3000}, {3000, 2000}}});
  return zone;
}

// A point inside is positive, a point outside or in a hole negative, by its distance.
TEST(Zone, SignsAndMeasuresPoints) {
  EXPECT_NEAR(signed_clearance(room().view(), {1, 1}), 1.0, 1e-12);
  EXPECT_NEAR(signed_clearance(room().view(), {1.5, 2.5}), 0.5, 1e-12);
  EXPECT_NEAR(signed_clearance(room().view(), {2.5, 2.2}), -0.2, 1e-12);
  EXPECT_NEAR(signed_clearance(room().view(), {-3, -4}), -5.0, 1e-12);
}

// A segment inside is as clear as its closest approach, which may be a corner of a hole.
TEST(Zone, MeasuresSegmentsInside) {
  EXPECT_NEAR(signed_clearance(room().view(), {1, 0.5}, {4, 0.5}), 0.5, 1e-12);
  EXPECT_NEAR(signed_clearance(room().view(), {3, 1.5}, {3.5, 2}), std::sqrt(0.125), 1e-12);
}

// A segment between two good points that crosses a hole is as bad as its deepest point.
TEST(Zone, MeasuresSegmentsAcrossAHole) {
  EXPECT_NEAR(signed_clearance(room().view(), {1, 2.5}, {4, 2.5}), -0.5, 1e-3);
  EXPECT_NEAR(signed_clearance(room().view(), {1, 2.1}, {4, 2.1}), -0.1, 1e-3);
  EXPECT_LE(signed_clearance(room().view(), {1, 2}, {4, 2}), 0.0);
  EXPECT_NEAR(signed_clearance(room().view(), {2.4, 2.5}, {2.5, 2.5}), -0.5, 1e-3);
}

// The nearest point of the boundary may belong to a hole.
TEST(Zone, ALegKeepsAClearanceThatItHas) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(-1, 6);
  for (int i = 0; i < 20'000; ++i) {
    const Vec2 a{at(random), at(random)}, b{at(random), at(random)};
    const double least_m = signed_clearance(room().view(), a, b);
    EXPECT_TRUE(keeps_clearance(room().view(), a, b, least_m - 2e-3)) << i;
    EXPECT_FALSE(keeps_clearance(room().view(), a, b, least_m + 2e-3)) << i;
  }
}

TEST(Zone, FindsTheNearestBoundary) {
  const Vec2 q = nearest_boundary(room().view(), {1.8, 2.4});
  EXPECT_NEAR(q.x, 2.0, 1e-12);
  EXPECT_NEAR(q.y, 2.4, 1e-12);
}

// A zone without edges contains nothing.
TEST(Zone, EmptyZoneIsAllOutside) {
  EXPECT_LT(signed_clearance(ZoneView{}, {0, 0}), -1e9);
}

}  // namespace
}  // namespace rtac
