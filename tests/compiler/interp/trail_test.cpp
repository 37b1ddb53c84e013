// Legs and paths in exact numbers, against many places along them.
#include "compiler/interp/trail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace rtac::interp {
namespace {

geometry::Region yard() {
  const auto ring = [](std::initializer_list<std::pair<int, int>> corners) {
    geometry::Ring ring;
    for (const auto& [x, y] : corners) ring.push_back({Rational(x), Rational(y)});
    return ring;
  };
  const auto outer = ring({{0, 0}, {10, 0}, {10, 4}, {6, 4}, {6, 6}, {10, 6}, {10, 10}, {0, 10}});
  const auto hole = ring({{2, 2}, {2, 4}, {4, 4}, {4, 2}});
  return geometry::Region::of_rings({outer, hole});
}

class TrailTest : public ::testing::Test {
 protected:
  Place place() {
    // on whole metres, where walls are, or between them
    const auto coordinate = [&] {
      const long at = static_cast<long>(random_() % 1301) - 150;
      Rational metres(random_() % 2 == 0 ? at / 100 * 100 : at, 100);
      metres.canonicalize();
      return metres;
    };
    const Rational x = coordinate();
    return {x, coordinate()};
  }
  Trail trail(std::size_t places) {
    Trail trail;
    for (std::size_t k = 0; k < places; ++k) trail.places.push_back(place());
    return trail;
  }
  // Places along it, no two neighbours of a leg farther apart than a hundredth of it.
  static std::vector<Place> along(const Trail& trail) {
    std::vector<Place> all;
    trail.for_each_leg([&](const Place& a, const Place& b) {
      for (int k = 0; k <= 100; ++k) {
        const Rational share(k, 100);
        all.push_back({a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share});
      }
    });
    return all;
  }
  std::mt19937 random_{5};
};

TEST_F(TrailTest, ClearancesAreThoseOfPlacesAlongIt) {
  const Outline outline(yard());
  int inside = 0, crossing = 0;
  for (int n = 0; n < 400; ++n) {
    const Trail way = trail(1 + random_() % 3);
    const auto [sign, greatest] = n % 2 == 0 ? std::pair(1, false) : std::pair(-1, true);
    double least = 1e9;
    for (const Place& p : along(way)) {
      const double gap = outline.distance(p).below.get_d();
      least = std::min(least, sign * (outline.contains(p) ? gap : -gap));
    }
    const Span found = clearance_of(outline, outline, way, greatest);
    const double lo = (greatest ? -found.hi.value() : found.lo.value()).get_d();
    const double hi = (greatest ? -found.lo.value() : found.hi.value()).get_d();
    // between two of these places it falls by half of what lies between them, 8 cm, at most
    EXPECT_LE(lo, least + 1e-9);
    EXPECT_GE(hi, least - 0.08);
    EXPECT_LE(hi - lo, 0.2);
    (lo > 0 ? inside : crossing) += 1;
    if (!greatest) {
      EXPECT_EQ(surely_leaves(outline, outline, way, false), hi < 0 || (lo < 0 && hi <= 0));
    }
  }
  EXPECT_GT(inside, 30);
  EXPECT_GT(crossing, 100);
}

TEST_F(TrailTest, DistancesAreThoseOfPlacesAlongThem) {
  for (int n = 0; n < 60; ++n) {
    const Trail a = trail(1 + random_() % 2), b = trail(1 + random_() % 3);
    double least = 1e9;
    for (const Place& p : along(a)) {
      for (const Place& q : along(b)) {
        least =
            std::min(least, std::hypot(Rational(p.x - q.x).get_d(), Rational(p.y - q.y).get_d()));
      }
    }
    const Span found = distance_of(a, b);
    EXPECT_LE(found.lo.value().get_d(), least + 1e-9);
    EXPECT_GE(found.hi.value().get_d(), least - 0.2);
    EXPECT_LE(Rational(found.hi.value() - found.lo.value()).get_d(), 1e-9);
  }
}

// A leg along a wall lies inside, one through two corners of a hole does not.
TEST_F(TrailTest, WhatTouchesLiesInside) {
  const Outline outline(yard());
  const auto leaves = [&](int x, int y, int to_x, int to_y) {
    Trail way;
    way.places = {{Rational(x), Rational(y)}, {Rational(to_x), Rational(to_y)}};
    return surely_leaves(outline, outline, way, false);
  };
  EXPECT_FALSE(leaves(0, 0, 10, 0));
  EXPECT_FALSE(leaves(2, 1, 2, 9));
  EXPECT_TRUE(leaves(1, 1, 5, 5));
  EXPECT_TRUE(leaves(10, 1, 10, 9));
}

TEST_F(TrailTest, WhatIsMissingIsUnknown) {
  Trail way;
  EXPECT_TRUE(way.is_unknown());
  lead_on(way, exactly(Rational(1)), unknown(sema::InputId{3}));
  EXPECT_TRUE(way.is_unknown());
  EXPECT_EQ(distance_of(way, way).missing.input, sema::InputId{3});
}

}  // namespace
}  // namespace rtac::interp
