// The tables that a kernel trusts, against brute force on exact numbers: every bound holds at
// every point tried, on vertices, on edges and one grid unit beside them, and is as tight as said.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

#include "testing.h"

namespace rtac::geometry {
namespace {

constexpr int kQ30 = 1 << 30;

std::vector<Segment> edges_of(const SnappedZone& zone) {
  std::vector<Segment> edges;
  for (const auto& ring : zone.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const GridPoint a = ring[i], b = ring[(i + 1) % ring.size()];
      edges.push_back({pt(a.x_mm, a.y_mm), pt(b.x_mm, b.y_mm)});
    }
  }
  return edges;
}

// In mm throughout.
Region in_mm(const SnappedZone& zone) {
  std::vector<Ring> rings;
  for (const auto& ring : zone.rings) {
    Ring& out = rings.emplace_back();
    for (const GridPoint& p : ring) out.push_back(pt(p.x_mm, p.y_mm));
  }
  return Region::of_rings(rings);
}

std::size_t index(const CellGrid& grid, long column, long row) {
  return static_cast<std::size_t>(row * grid.columns + column);
}

void check_point(const BakedZone& baked, const Region& region, const std::vector<Segment>& edges,
                 const Point& p) {
  const CellGrid& grid = baked.cells;
  const Rational squared = squared_distance(p, edges);
  const bool inside = region.contains(p);
  const Rational most = q(baked.widest_mm) + 2;
  EXPECT_TRUE(!inside || squared <= most * most);
  // All closed cells that contain the point.
  const Rational column = (p.x - grid.origin.x_mm) / grid.cell_mm;
  const Rational row = (p.y - grid.origin.y_mm) / grid.cell_mm;
  const long c0 = mpz_class(column).get_si(), r0 = mpz_class(row).get_si();
  for (long r = r0 - 1; r <= r0; ++r) {
    for (long c = c0 - 1; c <= c0; ++c) {
      if (c < 0 || r < 0 || c >= grid.columns || r >= grid.rows) continue;
      if (column > c + 1 || row > r + 1) continue;
      const long lo = grid.clearance_mm_lo[index(grid, c, r)];
      const long hi = grid.clearance_mm_hi[index(grid, c, r)];
      ASSERT_LE(lo, hi);
      if (!inside) {
        ASSERT_LE(lo, 0);
      } else {
        ASSERT_GE(lo, 0);
        ASSERT_LE(Rational(lo * lo), squared);
        ASSERT_GE(Rational(hi * hi), squared);
      }
    }
  }
}

void check_zone(const SnappedZone& zone, std::int32_t cell_mm, Random& random, int points) {
  const BakedZone baked = bake(zone, cell_mm);
  const std::vector<Segment> edges = edges_of(zone);
  const Region region = in_mm(zone);
  const CellGrid& grid = baked.cells;
  const long width = long{grid.columns} * grid.cell_mm, height = long{grid.rows} * grid.cell_mm;
  for (int i = 0; i < points; ++i) {
    check_point(baked, region, edges,
                {q(pick(random, 0, 3 * width), 3) + grid.origin.x_mm,
                 q(pick(random, 0, 3 * height), 3) + grid.origin.y_mm});
    // On an edge, on a vertex, and a little beside: one unit and a thousandth of one.
    const Segment& e = edges[random() % edges.size()];
    const Rational t = q(pick(random, 0, 4), 4);
    const Point on{e.a.x + t * (e.b.x - e.a.x), e.a.y + t * (e.b.y - e.a.y)};
    const Rational step = q(1, random() % 2 == 0 ? 1 : 1000);
    const Point beside{on.x + step * pick(random, -1, 1), on.y + step * pick(random, -1, 1)};
    if (beside.x >= grid.origin.x_mm && beside.y >= grid.origin.y_mm) {
      check_point(baked, region, edges, beside);
    }
  }
  const Point widest = pt(baked.widest_at.x_mm, baked.widest_at.y_mm);
  EXPECT_TRUE(region.contains(widest));
  const Rational squared = squared_distance(widest, edges);
  EXPECT_LE(Rational(baked.widest_mm) * baked.widest_mm, squared);
  EXPECT_GT((Rational(baked.widest_mm) + 1) * (baked.widest_mm + 1), squared);
}

TEST(Bake, EdgesOfASquare) {
  const BakedZone baked = bake(*snap_inside(box(0, 0, 1000, 1000)), 100);
  ASSERT_EQ(baked.edges.size(), 4U);
  const EdgeRow& south = baked.edges[0];
  EXPECT_EQ(south.a, (GridPoint{0, 0}));
  EXPECT_EQ(south.b, (GridPoint{1000, 0}));
  EXPECT_EQ(south.ux_q30, kQ30);
  EXPECT_EQ(south.uy_q30, 0);
  EXPECT_EQ(south.nx_q30, 0);
  EXPECT_EQ(south.ny_q30, kQ30);
  EXPECT_EQ(south.length_mm_up, 1000);
  EXPECT_EQ(baked.edges[1].nx_q30, -kQ30);
  EXPECT_EQ(baked.widest_at, (GridPoint{500, 500}));
  EXPECT_EQ(baked.widest_mm, 500);
}

TEST(Bake, UnitVectorsAreTheNearestAndLengthsTheCeiling) {
  Random random(8);
  for (int i = 0; i < 2000; ++i) {
    const long most = i % 2 == 0 ? 1000 : 1L << 29;
    const GridPoint a{static_cast<std::int32_t>(pick(random, -most, most)),
                      static_cast<std::int32_t>(pick(random, -most, most))};
    const GridPoint b{static_cast<std::int32_t>(pick(random, -most, most)),
                      static_cast<std::int32_t>(pick(random, -most, most))};
    if (a == b) continue;
    // A huge cell: only the edge matters here.
    const EdgeRow row = bake(SnappedZone{{{a, b, {a.x_mm, b.y_mm}}}}, 1 << 30).edges[0];
    const mpz_class dx = b.x_mm - mpz_class(a.x_mm), dy = b.y_mm - mpz_class(a.y_mm);
    const mpz_class squared = dx * dx + dy * dy;
    // |u / 2^30 - d / L| <= 2^-31  <=>  (2|u| - 1)^2 L^2 <= (2^31 d)^2 <= (2|u| + 1)^2 L^2
    const auto check = [&](std::int32_t u, const mpz_class& d) {
      const mpz_class target = (d << 31) * (d << 31);
      const mpz_class size = abs(mpz_class(u));
      EXPECT_GE((2 * size + 1) * (2 * size + 1) * squared, target);
      EXPECT_TRUE(u == 0 || (2 * size - 1) * (2 * size - 1) * squared <= target);
      EXPECT_TRUE(u == 0 || sgn(mpz_class(u)) == sgn(d));
    };
    check(row.ux_q30, dx);
    check(row.uy_q30, dy);
    EXPECT_EQ(row.nx_q30, -row.uy_q30);
    EXPECT_EQ(row.ny_q30, row.ux_q30);
    const mpz_class up = row.length_mm_up;
    EXPECT_GE(up * up, squared);
    EXPECT_LT((up - 1) * (up - 1), squared);
  }
}

TEST(Bake, CellsOfASquareByHand) {
  const CellGrid grid = bake(*snap_inside(box(0, 0, 500, 500)), 100).cells;
  EXPECT_EQ(grid.columns, 5);
  EXPECT_EQ(grid.rows, 5);
  const std::vector<std::int32_t> lo{0,   0, 0, 0,   0,   0,   100, 100, 100, 0, 0, 100, 200,
                                     100, 0, 0, 100, 100, 100, 0,   0,   0,   0, 0, 0};
  EXPECT_EQ(grid.clearance_mm_lo, lo);
  EXPECT_EQ(grid.clearance_mm_hi[index(grid, 0, 0)], 100);
  EXPECT_EQ(grid.clearance_mm_hi[index(grid, 2, 2)], 300);
}

TEST(Bake, CellsOutsideAndTouchingFromOutside) {
  // A frame 300 wide with a hole of 300: the middle cell is all hole, its border is boundary.
  const CellGrid grid =
      bake(*snap_inside(polygon(box_ring(0, 0, 700, 700), {box_ring(200, 200, 500, 500)})), 100)
          .cells;
  EXPECT_EQ(grid.clearance_mm_lo[index(grid, 3, 3)], -1);
  EXPECT_EQ(grid.clearance_mm_hi[index(grid, 3, 3)], -1);
  EXPECT_EQ(grid.clearance_mm_lo[index(grid, 2, 2)], 0);
  EXPECT_EQ(grid.clearance_mm_hi[index(grid, 2, 2)], 0);
  EXPECT_EQ(grid.clearance_mm_hi[index(grid, 1, 3)], 100);
}

TEST(Bake, CellsAreExactlyTheSmallestDistance) {
  // Brute force over all edges and cells: the distance between square and edge, rounded down.
  Random random(9);
  for (int i = 0; i < 12; ++i) {
    const auto zone = snap_inside(random_region(random, 5, 3));
    ASSERT_TRUE(zone);
    const CellGrid grid = bake(*zone, static_cast<std::int32_t>(pick(random, 150, 400))).cells;
    const std::vector<Segment> edges = edges_of(*zone);
    const Region region = in_mm(*zone);
    const long size = grid.cell_mm;
    for (long r = 0; r < grid.rows; ++r) {
      for (long c = 0; c < grid.columns; ++c) {
        const long x = grid.origin.x_mm + c * size, y = grid.origin.y_mm + r * size;
        const Region cell =
            polygon({pt(x, y), pt(x + size, y), pt(x + size, y + size), pt(x, y + size)});
        const Rational least = squared_distance(boundary(cell), edges);
        const long lo = grid.clearance_mm_lo[index(grid, c, r)];
        // The upper bound: the least over edges of the largest distance of a corner, rounded up.
        const long hi = grid.clearance_mm_hi[index(grid, c, r)];
        if (hi > 0) {
          std::optional<Rational> bound;
          for (const Segment& e : edges) {
            Rational most = 0;
            for (const Segment& side : boundary(cell)) {
              most = std::max(most, squared_distance(side.a, e));
            }
            if (!bound || most < *bound) bound = most;
          }
          EXPECT_GE(Rational(hi * hi), *bound);
          EXPECT_LT(Rational((hi - 1) * (hi - 1)), *bound);
        }
        if (lo > 0) {
          EXPECT_LE(Rational(lo * lo), least);
          EXPECT_GT(Rational((lo + 1) * (lo + 1)), least);
          EXPECT_TRUE(region.contains(cell));
        } else if (lo < 0) {
          EXPECT_TRUE(region.intersect(cell).empty());
          EXPECT_GT(least, 0);
        } else if (least >= 1) {
          // Neither end of an edge nor its crossing of the border is near: it must lie inside.
          EXPECT_FALSE(region.contains(cell));
          EXPECT_FALSE(region.intersect(cell).empty());
        }
      }
    }
  }
}

TEST(Bake, BoundsHoldAtRandomAndAdversarialPoints) {
  Random random(10);
  for (int i = 0; i < 30; ++i) {
    const auto zone = snap_inside(random_region(random, 5, i % 3 == 0 ? 1 : 17));
    ASSERT_TRUE(zone);
    check_zone(*zone, static_cast<std::int32_t>(pick(random, 1, 5) * 50), random, 150);
  }
}

TEST(Bake, BoundsHoldFarFromTheOriginAndForHugeZones) {
  Random random(11);
  const long far = (1L << 29) - 6000;
  check_zone(*snap_inside(
                 polygon({mm(far, -far), mm(far + 5900, -far + 100), mm(far + 3000, -far + 5000)})),
             100, random, 300);
  const long edge = 1L << 29;
  const auto huge = snap_inside(polygon(
      {mm(-edge, -edge), mm(edge, -edge + 7), mm(edge - 1, edge), mm(3, -5), mm(-edge, edge)}));
  ASSERT_TRUE(huge);
  const BakedZone baked = bake(*huge, 100);
  EXPECT_LE(std::int64_t{baked.cells.columns} * baked.cells.rows, 1000000);
  EXPECT_EQ(baked.cells.cell_mm % 100, 0);
  check_zone(*huge, 100, random, 300);
}

TEST(Bake, LargerCellsWhenThereWouldBeTooMany) {
  const CellGrid grid = bake(*snap_inside(box(0, 0, 200000, 200000)), 10).cells;
  // 1000 cells a side are allowed: 200 mm.
  EXPECT_EQ(grid.cell_mm, 200);
  EXPECT_EQ(grid.columns, 1000);
  const CellGrid fits = bake(*snap_inside(box(0, 0, 100000, 100000)), 100).cells;
  EXPECT_EQ(fits.cell_mm, 100);
  const CellGrid long_one = bake(*snap_inside(box(0, 0, 1 << 29, 10)), 100).cells;
  EXPECT_EQ(long_one.rows, 1);
  EXPECT_EQ(long_one.cell_mm, 600);
}

TEST(Bake, WidestPlaceAgainstAllGridPoints) {
  Random random(12);
  for (int i = 0; i < 30; ++i) {
    const auto corner = [&] { return mm(pick(random, 0, 60), pick(random, 0, 60)); };
    const auto result = Region::polygon({corner(), corner(), corner(), corner(), corner()}, {});
    const auto* region = std::get_if<Region>(&result);
    if (region == nullptr) continue;
    const auto zone = snap_inside(*region);
    const std::vector<Segment> edges = edges_of(*zone);
    const Region in = in_mm(*zone);
    Rational most = 0;
    for (long y = 0; y <= 60; ++y) {
      for (long x = 0; x <= 60; ++x) {
        if (in.contains(pt(x, y))) most = std::max(most, squared_distance(pt(x, y), edges));
      }
    }
    const long widest = bake(*zone, 20).widest_mm;
    EXPECT_LE(Rational(widest * widest), most);
    EXPECT_GT(Rational((widest + 2) * (widest + 2)), most);
  }
}

TEST(Bake, WidestPlaceOfALongCorridorEndsInTime) {
  // Equally wide everywhere, not along the axes: no square is better than the others.
  const BakedZone baked = bake(
      *snap_inside(polygon({mm(0, 0), mm(800000, 600000), mm(798800, 601600), mm(-1200, 1600)})),
      1000);
  EXPECT_GE(baked.widest_mm, 990);
  EXPECT_LE(baked.widest_mm, 1000);
}

TEST(Bake, EmptyZoneGivesEmptyTables) {
  const BakedZone baked = bake({}, 100);
  EXPECT_TRUE(baked.edges.empty());
  EXPECT_TRUE(baked.cells.clearance_mm_lo.empty());
  EXPECT_EQ(baked.widest_mm, 0);
}

// A star of many thousand corners, by sines that need not be exact: they are rounded anyway.
SnappedZone star(int corners, double radius_mm) {
  std::vector<GridPoint> ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.141592653589793 * i / corners;
    const double radius = radius_mm * (i % 2 == 0 ? 1.0 : 0.7);
    ring.push_back({static_cast<std::int32_t>(radius * std::cos(angle)),
                    static_cast<std::int32_t>(radius * std::sin(angle))});
  }
  return {{ring}};
}

// Of the processor, so that nothing else on the machine counts.
template <class Work>
double processor_s(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double squared_gap(const EdgeRow& e, double x, double y) {
  const double dx = e.b.x_mm - e.a.x_mm, dy = e.b.y_mm - e.a.y_mm, px = x - e.a.x_mm,
               py = y - e.a.y_mm;
  const double t = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  const double rx = px - t * dx, ry = py - t * dy;
  return rx * rx + ry * ry;
}

TEST(Bake, TenThousandCorners) {
  const SnappedZone zone = star(10'000, 45'000);
  BakedZone baked;
  const double taken = processor_s([&] { baked = bake(zone, 100); });
  EXPECT_EQ(baked.edges.size(), 10'000U);
  EXPECT_EQ(baked.cells.columns, 900);
  // All inner corners lie on a circle of 31,500 mm.
  EXPECT_NEAR(baked.widest_mm, 31'500, 30);
  // Each edge seen from each cell, of which there are 810,000: from one in a hundred of them.
  double sum = 0;
  const double of_few = processor_s([&] {
    for (int row = 5; row < 900; row += 10) {
      for (int column = 5; column < 900; column += 10) {
        double least = 1e18;
        for (const EdgeRow& e : baked.edges) {
          least = std::min(least, squared_gap(e, column * 100 - 45'000, row * 100 - 45'000));
        }
        sum += least;
      }
    }
  });
  EXPECT_GT(sum, 0);
  RecordProperty("share_of_all_pairs", std::to_string(taken / (100 * of_few)));
  EXPECT_LT(taken, 0.7 * 100 * of_few) << taken << " s";
}

TEST(Bake, SameInputSameTables) {
  Random random(13);
  const auto zone = snap_inside(random_region(random, 6, 5));
  const BakedZone a = bake(*zone, 50), b = bake(*zone, 50);
  EXPECT_EQ(a.cells.clearance_mm_lo, b.cells.clearance_mm_lo);
  EXPECT_EQ(a.cells.clearance_mm_hi, b.cells.clearance_mm_hi);
  EXPECT_EQ(a.widest_at, b.widest_at);
}

}  // namespace
}  // namespace rtac::geometry
