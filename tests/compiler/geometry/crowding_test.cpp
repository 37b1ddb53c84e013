// Whether so many places fit into a region: what is known to fit is never too many, and a little
// more than the densest that is known is.
#include "compiler/geometry/crowding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/compiler/geometry/testing.h"

namespace rtac::geometry {
namespace {

Region rectangle_m(long width, long height) {
  return std::get<Region>(Region::polygon({{0, 0}, {width, 0}, {width, height}, {0, height}}, {}));
}

// The densest of so many points in a square of 1 m: M. Goldberg, "The packing of equal circles in a
// square", Mathematics Magazine 43, 1970.
TEST(Crowding, DensestOfASquareAreNotTooMany) {
  const Region square = rectangle_m(1, 1);
  const std::pair<std::size_t, Rational> densest[] = {{2, Rational(1414213, 1000000)},
                                                      {3, Rational(1035276, 1000000)},
                                                      {4, 1},
                                                      {5, Rational(707106, 1000000)},
                                                      {9, Rational(1, 2)},
                                                      {16, Rational(1, 3)}};
  for (const auto& [places, apart] : densest) {
    EXPECT_FALSE(too_many_for(square, places, apart)) << places;
  }
}
// Of a long strip Oler's inequality is tight.
TEST(Crowding, OneMoreThanFitInAStripIsTooMany) {
  const Region strip = rectangle_m(1000, 1);
  EXPECT_FALSE(too_many_for(strip, 101, 10));
  EXPECT_TRUE(too_many_for(strip, 114, 10));
}
TEST(Crowding, FiveThatWouldNeedAWiderSquareAreTooMany) {
  const Region square = rectangle_m(1, 1);
  EXPECT_TRUE(too_many_for(square, 5, Rational(95, 100)));
  EXPECT_TRUE(too_many_for(square, 200, Rational(1, 10)));
  EXPECT_TRUE(too_many_for(Region(), 2, 1));
  EXPECT_FALSE(too_many_for(square, 1, 100));
}
// Two of four share one of three boxes side by side, of 8/3 m by 2.6 m: 3.73 m from corner to
// corner.
TEST(Crowding, PlacesThatShareABoxAreNoFartherApartThanItsCorners) {
  const Region hall = std::get<Region>(
      Region::polygon({{0, 0}, {8, 0}, {8, Rational(26, 10)}, {0, Rational(26, 10)}}, {}));
  EXPECT_TRUE(too_many_for(hall, 4, Rational(373, 100)));
  EXPECT_FALSE(too_many_for(hall, 4, 3));
}
// A ring leaves most of its hull out.
TEST(Crowding, DiscsHaveToFitBesideAHole) {
  const Ring outer{{0, 0}, {40, 0}, {40, 40}, {0, 40}};
  const Ring hole{{1, 1}, {1, 39}, {39, 39}, {39, 1}};
  const Region ring = std::get<Region>(Region::polygon(outer, {hole}));
  EXPECT_TRUE(too_many_for(ring, 300, 3));
  EXPECT_FALSE(too_many_for(rectangle_m(40, 40), 150, 3));
}
TEST(Crowding, WhatIsThereFits) {
  std::mt19937 random(17);
  for (int i = 0; i < 200; ++i) {
    const long width = 1 + static_cast<long>(random() % 20);
    const long height = 1 + static_cast<long>(random() % 20);
    const Region room = rectangle_m(width, height);
    // knots of a net with a mesh that need not divide the sides
    const double mesh = 0.3 + static_cast<double>(random() % 1000) / 400;
    const auto knots = static_cast<std::size_t>(std::floor(static_cast<double>(width) / mesh) + 1) *
                       static_cast<std::size_t>(std::floor(static_cast<double>(height) / mesh) + 1);
    EXPECT_FALSE(too_many_for(room, knots, Rational(mesh)))
        << width << " " << height << " " << mesh;
  }
}

}  // namespace
}  // namespace rtac::geometry
