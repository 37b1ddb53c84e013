// Many regions at once: equal ones count once, and what would cross too often is refused before it
// is computed.
#include "compiler/geometry/united.h"

#include <gtest/gtest.h>

#include "testing.h"

namespace rtac::geometry {
namespace {

// `count` strips of 1 m, 2 m apart, across a square; `upright` or not.
std::vector<Region> strips(long count, bool upright) {
  std::vector<Region> all;
  for (long i = 0; i < count; ++i) {
    const long from = 1000 + 2000 * i, to = from + 1000, end = 2000 * count + 1000;
    all.push_back(upright ? box(from, 0, to, end) : box(0, from, end, to));
  }
  return all;
}
// `count` thin triangles around a corner that they share: every two of them touch there alone, with
// 2 edges each.
std::vector<Region> fan(long count) {
  std::vector<Region> all;
  for (long i = 0; i < count; ++i) {
    all.push_back(polygon({mm(0, 0), mm(1'000'000, 2000 * i), mm(1'000'000, 2000 * i + 1000)}));
  }
  return all;
}
std::vector<Region> operator+(std::vector<Region> a, const std::vector<Region>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(United, IsWhatTheUnionOneByOneIs) {
  const std::vector<Region> all = strips(5, false) + strips(5, true) + strips(3, true);
  Region one_by_one;
  for (const Region& region : all) one_by_one = one_by_one.unite(region);
  const auto at_once = united(all);
  ASSERT_TRUE(at_once.has_value());
  EXPECT_EQ(text(*at_once), text(one_by_one));
}

TEST(United, EqualRegionsCountOnce) {
  // 4,000 times the same: every two of them would lie on one another.
  const std::vector<Region> same(4000, box(0, 0, 1000, 1000));
  EXPECT_FALSE(cross_too_often(same));
  const auto one = united(same);
  ASSERT_TRUE(one.has_value());
  EXPECT_EQ(text(*one), text(same.front()));
  EXPECT_EQ(text(*united({box(0, 0, 1000, 1000)})), text(same.front()));
}

TEST(United, CrossingsAreCounted) {
  // Every two strips cross at 4 places: 86 and 87 do at 29,928, 87 and 87 at 30,276.
  EXPECT_FALSE(cross_too_often(strips(86, false) + strips(87, true)));
  EXPECT_TRUE(cross_too_often(strips(87, false) + strips(87, true)));
  EXPECT_FALSE(united(strips(87, false) + strips(87, true)).has_value());
  // Of two regions of many parts as well, and of what is nested nothing is.
  const auto across = united(strips(200, false)), upright = united(strips(200, true));
  ASSERT_TRUE(across && upright);
  EXPECT_TRUE(cross_too_often({*across, *upright}));
  std::vector<Region> nested;
  for (long i = 0; i < 400; ++i) nested.push_back(box(i, i, 1000 - i, 1000 - i));
  EXPECT_FALSE(cross_too_often(nested));
}

TEST(United, TouchesAreCounted) {
  // Two triangles touch 4 times: 671 of them do 899,140 times, 672 do 901,824 times.
  EXPECT_FALSE(cross_too_often(fan(671)));
  EXPECT_TRUE(cross_too_often(fan(672)));
}

// `count` slivers of a slope, side by side: the boxes of any two of them overlap.
std::vector<Region> slope(long count) {
  std::vector<Region> all;
  for (long i = 0; i < count; ++i) {
    all.push_back(polygon({mm(10 * i, 0), mm(10 * i + 4, 0), mm(10 * i + 1'000'000, 1'000'000)}));
  }
  return all;
}
TEST(United, RegionsSideBySideAreNotLookedAtForEver) {
  std::vector<Region> apart = slope(15'000);
  EXPECT_EQ(meeting_cost(apart), 0U);  // one sweep tells
  // Once some meet, 450 million pairs of edges would have to be looked at.
  EXPECT_TRUE(cross_too_often(apart + std::vector<Region>{box(-10, -10, 0, 0)}));
  EXPECT_EQ(meeting_cost(slope(300) + std::vector<Region>{box(-10, -10, 0, 0)}), 4U);
}

TEST(United, MeetingsCostOneAndCrossingsThirty) {
  const Region square = box(0, 0, 100, 100);
  EXPECT_EQ(meeting_cost({square, box(200, 0, 300, 100)}), 0U);
  EXPECT_EQ(meeting_cost({square, box(10, 10, 90, 90)}), 0U);
  EXPECT_EQ(meeting_cost({square, box(50, 50, 150, 150)}), 60U);   // crosses twice
  EXPECT_EQ(meeting_cost({square, box(100, 100, 150, 150)}), 4U);  // every two edges at the corner
  EXPECT_EQ(meeting_cost({square, box(100, 40, 150, 60)}), 3U);    // two ends on an edge, and along
  EXPECT_EQ(meeting_cost({square, square}), 0U);
  EXPECT_EQ(meeting_cost({Region(), square, Region()}), 0U);
  // the same, turned by a quarter
  EXPECT_EQ(meeting_cost({square, box(40, 100, 60, 1000)}), 3U);
}

TEST(United, RegionsSideBySideCostLittle) {
  // 100 by 100 squares that share their edges and corners.
  std::vector<Region> tiles;
  for (long i = 0; i < 10'000; ++i) {
    const long x = i % 100 * 10, y = i / 100 * 10;
    tiles.push_back(box(x, y, x + 10, y + 10));
  }
  const auto all = united(std::move(tiles));
  ASSERT_TRUE(all.has_value());
  EXPECT_EQ(text(*all), text(box(0, 0, 1000, 1000)));
}

}  // namespace
}  // namespace rtac::geometry
