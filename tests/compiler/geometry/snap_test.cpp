// Snapping to the grid only ever takes away, keeps what is on the grid already, and loses little.
#include <gtest/gtest.h>

#include "testing.h"

namespace rtac::geometry {
namespace {

std::vector<std::vector<GridPoint>> rings(const Region& region) {
  const auto zone = snap_inside(region);
  return zone ? zone->rings : std::vector<std::vector<GridPoint>>{};
}

// Outer rings turn left, holes right; every ring starts at its lowest-left vertex and has no
// collinear or repeated vertices.
void expect_canonical(const SnappedZone& zone) {
  for (const auto& ring : zone.rings) {
    ASSERT_GE(ring.size(), 3U);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const GridPoint a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
      EXPECT_NE((std::int64_t{b.x_mm} - a.x_mm) * (std::int64_t{c.y_mm} - b.y_mm) -
                    (std::int64_t{b.y_mm} - a.y_mm) * (std::int64_t{c.x_mm} - b.x_mm),
                0);
      EXPECT_TRUE(i == 0 || std::pair(a.y_mm, a.x_mm) > std::pair(ring[0].y_mm, ring[0].x_mm));
    }
  }
}

TEST(Snap, OnTheGridNothingChanges) {
  const Region free = delivery_free();
  const auto zone = snap_inside(free);
  ASSERT_TRUE(zone);
  EXPECT_EQ(text(to_region(*zone)), text(free));
  ASSERT_EQ(zone->rings.size(), 3U);
  const std::vector<GridPoint> outer{{0, 0},    {2000, 0}, {2000, 1000}, {3000, 1000},
                                     {3000, 0}, {5000, 0}, {5000, 5000}, {0, 5000}};
  EXPECT_EQ(zone->rings[0], outer);
  const std::vector<GridPoint> hole{{1000, 2000}, {1000, 3000}, {1600, 3000}, {1600, 2000}};
  EXPECT_EQ(zone->rings[1], hole);
}

TEST(Snap, RoundsInwardsAtConvexAndReflexCorners) {
  const Region square =
      polygon({{q(1, 3), q(1, 3)}, {q(2, 3), q(1, 3)}, {q(2, 3), q(2, 3)}, {q(1, 3), q(2, 3)}});
  const std::vector<GridPoint> inner{{334, 334}, {666, 334}, {666, 666}, {334, 666}};
  EXPECT_EQ(rings(square).at(0), inner);
  const std::vector<GridPoint> hole{{333, 333}, {333, 667}, {667, 667}, {667, 333}};
  EXPECT_EQ(rings(box(0, 0, 1000, 1000).subtract(square)).at(1), hole);
}

TEST(Snap, KeepsVerticesThatAreOnTheGrid) {
  // Only the fourth corner is off the grid.
  const Region region = polygon({pt(0, 0), pt(1, 0), pt(1, 1), {q(1, 3), q(2, 3)}});
  const auto zone = snap_inside(region);
  ASSERT_TRUE(zone);
  ASSERT_EQ(zone->rings[0].size(), 4U);
  EXPECT_EQ(zone->rings[0][0], (GridPoint{0, 0}));
  EXPECT_EQ(zone->rings[0][1], (GridPoint{1000, 0}));
  EXPECT_EQ(zone->rings[0][2], (GridPoint{1000, 1000}));
  EXPECT_TRUE(region.contains(to_region(*zone)));
}

TEST(Snap, NothingLeftOrTooLargeIsRefused) {
  EXPECT_FALSE(snap_inside(Region()));
  // Thinner than the grid, between two of its lines.
  EXPECT_FALSE(snap_inside(polygon(
      {{q(0), q(1, 10000)}, {q(1), q(1, 10000)}, {q(1), q(9, 10000)}, {q(0), q(9, 10000)}})));
  EXPECT_TRUE(snap_inside(box(-(1 << 29), -(1 << 29), 1 << 29, 1 << 29)));
  EXPECT_FALSE(snap_inside(box(0, 0, (1 << 29) + 1, 1000)));
}

TEST(Snap, SliverLosesItsTipOnly) {
  const Region sliver = polygon({{q(1, 7), q(1, 7)}, pt(5, 0), {q(5), q(1, 100)}});
  const auto zone = snap_inside(sliver);
  ASSERT_TRUE(zone);
  expect_canonical(*zone);
  const Region snapped = to_region(*zone);
  EXPECT_TRUE(sliver.contains(snapped));
  EXPECT_GT(snapped.area(), sliver.area() * q(1, 2));
}

TEST(Snap, SharpReflexCornerGetsABluntEndAndTheRestStays) {
  // A thin wedge cut into the square; its tip lies off the grid.
  const Region region =
      box(0, 0, 1000, 1000).subtract(polygon({{q(1, 3), q(1, 3)}, mm(1000, 495), mm(1000, 505)}));
  const auto zone = snap_inside(region);
  ASSERT_TRUE(zone);
  const Region snapped = to_region(*zone);
  EXPECT_TRUE(region.contains(snapped));
  EXPECT_EQ(zone->rings[0][0], (GridPoint{0, 0}));
  EXPECT_TRUE(snapped.contains(mm(1000, 495)));
  // In front of the tip less than 3 mm are lost.
  EXPECT_TRUE(snapped.contains(mm(331, 332)));
}

TEST(Snap, RandomRegionsAreSubsetsAndLoseLittle) {
  Random random(5);
  for (int i = 0; i < 60; ++i) {
    const Region region = random_region(random, 5, pick(random, 2, 1000));
    const auto zone = snap_inside(region);
    ASSERT_TRUE(zone) << i;
    expect_canonical(*zone);
    const Region snapped = to_region(*zone);
    EXPECT_TRUE(region.contains(snapped)) << i;
    // All that is further than 6 mm from the boundary stays.
    EXPECT_TRUE(snapped.contains(region.shrink(q(6, 1000)))) << i;
    EXPECT_EQ(snap_inside(snapped)->rings, zone->rings) << i;
  }
}

TEST(Snap, RegionsOfTheSizeOfTheGridAreSubsetsOrNothing) {
  // Vertices jump across opposite edges here: only the final exact test keeps the result inside.
  Random random(14);
  int found = 0;
  for (int i = 0; i < 400; ++i) {
    const Region region = random_triangle(random, 4, 97).unite(random_triangle(random, 4, 97));
    const auto zone = snap_inside(region);
    if (!zone) continue;
    EXPECT_TRUE(region.contains(to_region(*zone))) << i;
    ++found;
  }
  EXPECT_GT(found, 20);
}

TEST(Snap, ShrunkRegionsWithRoundCornersSnap) {
  const Region shrunk = delivery_free().shrink(q(26, 100));
  const auto zone = snap_inside(shrunk);
  ASSERT_TRUE(zone);
  EXPECT_TRUE(shrunk.contains(to_region(*zone)));
  EXPECT_TRUE(to_region(*zone).contains(shrunk.shrink(q(2, 1000))));
  // The straight walls are on the grid and stay where they are.
  EXPECT_EQ(zone->rings[0][0], (GridPoint{260, 260}));
}

TEST(Snap, SameInputSameBytes) {
  const auto run = [] {
    Random random(6);
    const Region region = random_region(random, 8, 97);
    const auto zone = snap_inside(region.shrink(q(3, 100)));
    return std::pair(text(region), zone->rings);
  };
  EXPECT_EQ(run(), run());
}

}  // namespace
}  // namespace rtac::geometry
