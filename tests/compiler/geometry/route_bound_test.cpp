// The table of distances bounds what the controller `route to` really drives: from every place of a
// cell where a body can be, its way is found and is no longer than the value of the cell.
#include <gtest/gtest.h>

#include <cmath>

#include "rtac/safe/grid_route.h"
#include "testing.h"
#include "zone_view.h"

namespace rtac::geometry {
namespace {

constexpr std::int32_t kClearance = 263, kBody = 90;

struct Study {
  int places = 0, connectors = 0, unknown = 0;
  double tightest = 0;  // largest share of a value that was driven
};

Study compare(const Region& region, GridPoint site, std::int32_t cell_mm) {
  const BakedZone zone = bake(*snap_inside(region), cell_mm);
  const std::int32_t connector = std::max(400, 2 * cell_mm);  // as the analysis has it
  const auto table = distances_to(zone, site, kClearance, kBody, connector);
  const View view(zone);
  safe::GridRoute route(*view);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> anywhere(0, 1);
  const Vec2 goal{site.x_mm * 1e-3, site.y_mm * 1e-3};
  Study study;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto columns = static_cast<std::size_t>(zone.cells.columns);
    const double x = zone.cells.origin.x_mm + 1.0 * cell_mm * static_cast<double>(i % columns);
    const double y = zone.cells.origin.y_mm + 1.0 * cell_mm * static_cast<double>(i / columns);
    const bool joins = zone.cells.clearance_mm_lo[i] < kClearance;
    for (int k = 0; k < (joins ? 12 : 2); ++k) {
      const Vec2 p{(x + cell_mm * anywhere(random)) * 1e-3,
                   (y + cell_mm * anywhere(random)) * 1e-3};
      if (signed_clearance(*view, p) < kBody * 1e-3) continue;
      if (table[i] < 0) {
        ++study.unknown;
        continue;
      }
      ++study.places;
      study.connectors += joins ? 1 : 0;
      Path way;
      if (!route.to_point({kClearance * 1e-3, p, {}, {}}, goal, way)) {
        ADD_FAILURE() << "no way from " << p.x << ", " << p.y;
        continue;
      }
      const double driven = 1e3 * std::max(route.length_m(), length_m(p, way));
      EXPECT_LE(driven, table[i] + 1e-3) << "from " << p.x << ", " << p.y;
      study.tightest = std::max(study.tightest, driven / table[i]);
    }
  }
  return study;
}

void expect_bound(const Region& region, GridPoint site) {
  const Study study = compare(region, site, 100);
  EXPECT_GT(study.connectors, 500);
  // hardly any place is without a value, and values are not far off
  EXPECT_LT(study.unknown, study.connectors / 20);
  EXPECT_GT(study.tightest, 0.95);
}

TEST(RouteBound, AmongBoxes) {
  expect_bound(delivery_free(), {800, 800});
  expect_bound(delivery_free(), {2000, 2000});
}

TEST(RouteBound, InAnEmptyRoom) {
  expect_bound(box(0, 0, 4000, 3000), {700, 1500});
}

TEST(RouteBound, AroundAHoleOffTheCells) {
  expect_bound(polygon(box_ring(37, 13, 5111, 4873), {box_ring(1773, 1651, 3337, 2949)}),
               {4300, 2500});
}

// Slanting walls, an acute corner and a thin tip that points into the room.
TEST(RouteBound, BetweenSlantingWalls) {
  expect_bound(polygon({mm(0, 0), mm(6000, 700), mm(5200, 5000), mm(2700, 2300), mm(500, 4700)}),
               {1200, 1300});
}

// A wall of 2 cm: cells on the other side are near and of no use.
TEST(RouteBound, OnBothSidesOfAThinWall) {
  expect_bound(box(0, 0, 4000, 3000).subtract(box(1990, 0, 2010, 2000)), {600, 600});
}

TEST(RouteBound, AroundManyCorners) {
  Region region = box(0, 0, 6000, 6000);
  for (const long x : {1000, 2700, 4400}) {
    for (const long y : {1100, 2800, 4500}) region = region.subtract(box(x, y, x + 333, y + 271));
  }
  expect_bound(region, {500, 500});
}

// Of a large zone the cells are wider, and so is what joins them.
TEST(RouteBound, WithWideCells) {
  const Region hall = box(0, 0, 12000, 9000).subtract(box(4730, 3370, 8110, 5330));
  for (const std::int32_t cell_mm : {310, 620}) {
    const Study study = compare(hall, {3 * cell_mm + 7, 3 * cell_mm + 7}, cell_mm);
    EXPECT_GT(study.connectors, 300) << cell_mm;
    EXPECT_LT(study.unknown, study.connectors / 20) << cell_mm;
    EXPECT_GT(study.tightest, 0.95) << cell_mm;
  }
}

}  // namespace
}  // namespace rtac::geometry
