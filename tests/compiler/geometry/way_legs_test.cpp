// The legs that are counted bound those of the ways that a retreat finds: from every place,
// whatever clearance it has there, and to whichever goal.
#include "compiler/geometry/way_legs.h"

#include <gtest/gtest.h>

#include <random>

#include "rooms.h"
#include "rtac/safe/grid_route.h"
#include "testing.h"
#include "zone_view.h"

namespace rtac::geometry {
namespace {

constexpr std::int32_t kBody = 90, kRoute = 263;

class ClearAs : public safe::PlaceTest {
 public:
  explicit ClearAs(double clearance_m) : clearance_m_(clearance_m) {}
  [[nodiscard]] bool accepts(Vec2, double clearance_m) const override {
    return clearance_m >= clearance_m_;
  }

 private:
  double clearance_m_;
};

struct Study {
  int bound = 0, ways = 0;
  std::size_t most = 0;
};

Study compare(const Region& region, std::int32_t goal_mm, std::int32_t cell_mm, int places) {
  const BakedZone zone = bake(*snap_inside(region), cell_mm);
  const auto bound = most_legs(zone.cells, {kBody, kRoute, {goal_mm, goal_mm + 70}});
  if (!bound) {
    ADD_FAILURE() << "no bound";
    return {};
  }
  const View view(zone);
  safe::GridRoute route(*view);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(0, 1);
  Study study{*bound};
  const auto upto = [&](std::int32_t cells) { return anywhere(random) * cells * cell_mm; };
  for (int i = 0; i < places; ++i) {
    const Vec2 p{(zone.cells.origin.x_mm + upto(zone.cells.columns)) * 1e-3,
                 (zone.cells.origin.y_mm + upto(zone.cells.rows)) * 1e-3};
    const double here_m = signed_clearance(*view, p);
    if (here_m < kBody * 1e-3) continue;
    for (const double goal_m : {goal_mm * 1e-3, (goal_mm + 70) * 1e-3}) {
      Path way;
      const double asks_m = std::min(here_m, kRoute * 1e-3);
      if (!route.to_place({asks_m, p, {}, {}}, ClearAs(goal_m), way)) continue;
      ++study.ways;
      EXPECT_FALSE(route.cut());
      // that to the first cell is one more
      EXPECT_LE(way.points.size(), static_cast<std::size_t>(*bound) + 1) << p.x << ", " << p.y;
      study.most = std::max(study.most, way.points.size());
    }
  }
  return study;
}

// The same of ways to a site, which the search draws near to, unlike to the nearest place: it finds
// others of those that are as short.
Study compare_to(const Region& region, Vec2 site, std::int32_t cell_mm, int places) {
  const BakedZone zone = bake(*snap_inside(region), cell_mm);
  const auto in_mm = [](double m) { return static_cast<std::int32_t>(std::lround(1000 * m)); };
  const auto bound = most_legs_to(zone.cells, kRoute, {in_mm(site.x), in_mm(site.y)});
  if (!bound) return {};
  const View view(zone);
  safe::GridRoute route(*view);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(0, 1);
  Study study{*bound};
  const auto upto = [&](std::int32_t cells) { return anywhere(random) * cells * cell_mm; };
  for (int i = 0; i < places; ++i) {
    const Vec2 p{(zone.cells.origin.x_mm + upto(zone.cells.columns)) * 1e-3,
                 (zone.cells.origin.y_mm + upto(zone.cells.rows)) * 1e-3};
    Path way;
    if (signed_clearance(*view, p) < kBody * 1e-3) continue;
    if (!route.to_point({kRoute * 1e-3, p, {}, {}}, site, way)) continue;
    ++study.ways;
    EXPECT_FALSE(route.cut());
    EXPECT_LE(way.points.size(), static_cast<std::size_t>(*bound) + 1) << p.x << ", " << p.y;
    study.most = std::max(study.most, way.points.size());
  }
  return study;
}

Region hall_with_racks() {
  Region hall = box(0, 0, 12000, 8000);
  for (const long y : {1500, 3700, 5900}) hall = hall.subtract(box(2000, y, 8000, y + 500));
  return hall;
}

// Aisles of 1.7 m: a metre of clearance is where they end.
TEST(WayLegs, AreFewAlongAisles) {
  const Study study = compare(hall_with_racks(), 1000, 100, 4000);
  EXPECT_GT(study.ways, 2000);
  EXPECT_GE(study.most, 2U);
  EXPECT_LE(study.bound, 4);
}

TEST(WayLegs, AroundCornersOffTheCells) {
  Region maze = box(0, 0, 7013, 5027);
  maze = maze.subtract(box(1003, 900, 1311, 5100)).subtract(box(2209, -10, 2507, 4133));
  maze = maze.subtract(box(3301, 911, 3607, 5100));
  for (const std::int32_t cell_mm : {100, 130}) {
    const Study study = compare(maze, 800, cell_mm, 3000);
    EXPECT_GT(study.ways, 500) << cell_mm;
    EXPECT_GE(study.most, 5U) << cell_mm;  // through the first two gaps
    EXPECT_LE(study.bound, 30) << cell_mm;
  }
}

TEST(WayLegs, AmongPillars) {
  Region region = box(0, 0, 6000, 6000);
  for (const long x : {1000, 2700, 4400}) {
    for (const long y : {1100, 2800, 4500}) region = region.subtract(box(x, y, x + 333, y + 271));
  }
  const Study study = compare(region, 700, 100, 3000);
  EXPECT_GT(study.ways, 1000);
  EXPECT_GE(study.most, 2U);
}

// With slanting walls, too, along which cells are stairs.
TEST(WayLegs, OfRandomRooms) {
  std::mt19937 random(3);
  int ways = 0;
  for (int i = 0; i < rooms_count(); ++i) {
    const Region room = random_room(random);
    SCOPED_TRACE(i);
    ways += compare(room, 400 + 100 * (i % 6), 100, 200).ways;
  }
  EXPECT_GT(ways, 20 * rooms_count());
}

TEST(WayLegs, ToASite) {
  const Study study = compare_to(hall_with_racks(), {11.013, 4.1}, 100, 4000);
  EXPECT_GT(study.ways, 2000);
  EXPECT_GE(study.most, 3U);
  EXPECT_LE(study.bound, 8);
  std::mt19937 random(4);
  int ways = 0;
  for (int i = 0; i < rooms_count(); ++i) {
    const Region room = random_room(random);
    SCOPED_TRACE(i);
    for (const double x : {0.6, 1.2, 2.5})
      ways += compare_to(room, {x, 1.9 - x / 2}, 100, 200).ways;
  }
  EXPECT_GT(ways, 20 * rooms_count());
}
// In its own cell the site itself is one leg away, and in one that is too near to the boundary for
// ways to end there is none.
TEST(WayLegs, OfASiteInANarrowPlaceAreNotCounted) {
  const CellGrid cells = bake(*snap_inside(box(0, 0, 4000, 4000)), 100).cells;
  EXPECT_EQ(most_legs_to(cells, kRoute, {2000, 2000}), 1);
  for (const GridPoint site :
       {GridPoint{250, 2000}, GridPoint{-100, 2000}, GridPoint{2000, 9000}}) {
    EXPECT_EQ(most_legs_to(cells, kRoute, site), std::nullopt);
  }
}

// Between a cell that is clear and one beside the wall a site is seen from the middle of its own
// cell alone: that is one leg more.
TEST(WayLegs, ToASiteBesideACellThatIsNotClearOneMoreIsCounted) {
  const CellGrid cells = bake(*snap_inside(box(0, 0, 4000, 4000)), 100).cells;
  const std::int32_t first = (kRoute + 99) / 100 * 100;  // the western edge of the first clear cell
  EXPECT_EQ(most_legs_to(cells, kRoute, {first, 2050}), 2);
  EXPECT_EQ(most_legs_to(cells, kRoute, {first + 1, 2050}), 1);
  EXPECT_EQ(most_legs_to(cells, kRoute, {first + 100, 2050}), 1);
}

// Who has room enough at once needs none, and from a chamber without a way none is counted.
TEST(WayLegs, CountWhatLeadsSomewhere) {
  const auto legs = [](const Region& region, std::int32_t goal_mm) {
    return most_legs(bake(*snap_inside(region), 100).cells, {kBody, kRoute, {goal_mm}});
  };
  EXPECT_EQ(legs(box(0, 0, 1000, 1000), kBody), 0);
  EXPECT_EQ(legs(box(0, 0, 1000, 1000), 5000), 0);
  EXPECT_EQ(legs(box(0, 0, 4000, 4000), 1500), 1);
}

// A corridor of 300 m: floats may prefer a way that is longer.
TEST(WayLegs, AreNotCountedOfVeryLongWays) {
  const Region corridor = box(0, 0, 300'000, 700).unite(box(-2000, -2000, 10, 2000));
  EXPECT_EQ(most_legs(bake(*snap_inside(corridor), 100).cells, {kBody, kRoute, {800}}),
            std::nullopt);
}
// Nor where the recheck is not sure of them: it counts legs up to 0.45 of the side of a cell by
// which floats may be off, and those of 136 m may be by 0.456 of it.
TEST(WayLegs, AreNotCountedWhereTheRecheckDoesNot) {
  const auto legs = [](std::int32_t length_mm) {
    const Region corridor = box(0, 0, length_mm, 700).unite(box(-2000, -2000, 10, 2000));
    return most_legs(bake(*snap_inside(corridor), 100).cells, {kBody, kRoute, {800}});
  };
  EXPECT_NE(legs(131'000), std::nullopt);
  EXPECT_EQ(legs(136'200), std::nullopt);
}

}  // namespace
}  // namespace rtac::geometry
