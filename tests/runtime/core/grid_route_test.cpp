// Ways over cells: short, with the clearance asked for, around robots that stand.
#include "rtac/safe/grid_route.h"

#include <gtest/gtest.h>

#include "tests/runtime/core/test_zone.h"

namespace rtac::safe {
namespace {

const test::TestZone& room() {
  static const test::TestZone zone({{{0, 0}, {5000, 0}, {5000, 5000}, {0, 5000}},
                                    {{2000, 2000}, {2000, 3000}, {3000, 3000}, {3000, 2000}}});
  return zone;
}
double length(Vec2 from, const Path& way) {
  double sum = 0;
  for (const Vec2 p : way.points) {
    sum += norm(p - from);
    from = p;
  }
  return sum;
}
double clearance(Vec2 from, const Path& way) {
  double least = 1e9;
  for (const Vec2 p : way.points) {
    least = std::min(least, signed_clearance(room().view(), from, p));
    from = p;
  }
  return least;
}
class Near : public PlaceTest {
 public:
  explicit Near(Vec2 p) : p_(p) {}
  bool accepts(Vec2 place, double) const override { return norm(place - p_) < 0.3; }

 private:
  Vec2 p_;
};

// Nothing in between: one straight leg to the very goal.
TEST(GridRoute, GoesStraight) {
  GridRoute route(room().view());
  Path way;
  ASSERT_TRUE(route.to_point({0.3, {0.5, 0.77}, {}, {}}, {4.4, 1.23}, way));
  ASSERT_EQ(way.points.size(), 1u);
  EXPECT_EQ(way.points[0].x, 4.4);
  EXPECT_EQ(way.points[0].y, 1.23);
}

// Around the hole the way keeps its clearance and is not much longer than the shortest.
TEST(GridRoute, GoesAroundAHole) {
  GridRoute route(room().view());
  Path way;
  const Vec2 start{1, 2.5}, goal{4, 2.5};
  ASSERT_TRUE(route.to_point({0.3, start, {}, {}}, goal, way));
  EXPECT_GE(clearance(start, way), 0.3 - 1e-9);
  EXPECT_LE(length(start, way), route.length_m() + 1e-6);
  EXPECT_LT(length(start, way), 3.9);  // by hand, over the corners of the cells: 3.84
}

// More clearance than the passages have: no way.
TEST(GridRoute, RefusesNarrowPassages) {
  GridRoute route(room().view());
  Path way;
  EXPECT_FALSE(route.to_point({1.1, {1, 2.5}, {}, {}}, {4, 2.5}, way));
}

// A robot that stands on the short side sends the way around the other side.
TEST(GridRoute, AvoidsStandingRobots) {
  GridRoute route(room().view());
  Path free_way, way;
  const Vec2 start{1, 2.4}, goal{4, 2.4}, robot{2.5, 1.2};
  ASSERT_TRUE(route.to_point({0.3, start, {}, {}}, goal, free_way));
  EXPECT_LT(free_way.points[0].y, 2.4);
  RouteQuery query{0.3, start, {}, {}};
  ASSERT_TRUE(query.avoid.push({robot, 1.0}));
  ASSERT_TRUE(route.to_point(query, goal, way));
  Vec2 from = start;
  for (const Vec2 p : way.points) {
    EXPECT_GE(distance_to_segment(robot, from, p), 1.0);
    from = p;
  }
}

// A start inside the circle of a standing robot may leave it, but only outwards.
TEST(GridRoute, LeavesACircleOutwards) {
  GridRoute route(room().view());
  Path way;
  RouteQuery query{0.3, {1.25, 1.25}, {}, {}};
  ASSERT_TRUE(query.avoid.push({{1.0, 1.0}, 0.6}));
  ASSERT_TRUE(route.to_point(query, {4, 1.2}, way));
  EXPECT_GE(dot(way.points[0] - query.start, query.start - Vec2{1.0, 1.0}), 0);
  EXPECT_FALSE(route.to_point(query, {0.7, 0.7}, way));  // the goal lies inside the circle
}

// With a point to recede from, no leg comes nearer to it than where the leg begins.
TEST(GridRoute, RecedesFromHeldRobots) {
  GridRoute route(room().view());
  Path way;
  RouteQuery query{0.3, {1.25, 2.5}, {}, {}};
  ASSERT_TRUE(query.recede_from.push({0.6, 2.5}));
  ASSERT_TRUE(route.to_point(query, {1.5, 4.5}, way));
  Vec2 from = query.start;
  for (const Vec2 p : way.points) {
    EXPECT_TRUE(recedes(from, p, {0.6, 2.5}));
    from = p;
  }
  EXPECT_FALSE(route.to_point(query, {0.5, 1.0}, way));
}

// Where no way leads on from the middle of its own cell, a way to a place begins with another one.
TEST(GridRoute, RecedesFromWhereItIs) {
  class Beyond : public PlaceTest {
    [[nodiscard]] bool accepts(Vec2 place, double) const override {
      return norm(place - Vec2{0.38, 0.38}) > 1;
    }
  };
  GridRoute route(room().view());
  Path way;
  RouteQuery query{0.3, {0.38, 0.38}, {}, {}};
  ASSERT_TRUE(query.recede_from.push({0.38, 0.38}));
  ASSERT_TRUE(route.to_place(query, Beyond(), way));
  EXPECT_GT(norm(way.points[0] - query.start), 0.04);
}

// A start too close to the wall is joined to the grid without getting closer to the wall.
TEST(GridRoute, ConnectsAStartNearTheWall) {
  GridRoute route(room().view());
  Path way;
  const Vec2 start{0.12, 2.5};
  ASSERT_TRUE(route.to_point({0.3, start, {}, {}}, {1.5, 0.6}, way));
  EXPECT_GE(clearance(start, way), 0.12 - 1e-9);
  ASSERT_GE(way.points.size(), 2u);
  EXPECT_LT(norm(way.points[0] - start), 0.48);
}

// Cells of too little clearance cost no tests: a way begins however far from them the start is.
TEST(GridRoute, ConnectsAStartDeepInAWideStandoff) {
  const test::TestZone yard({{{0, 0}, {14000, 0}, {14000, 14000}, {0, 14000}}});
  GridRoute route(yard.view());
  Path way;
  for (const Vec2 start : {Vec2{0.2, 7}, Vec2{0.3, 0.3}}) {
    ASSERT_TRUE(route.to_point({4.0, start, {}, {}}, {9, 9}, way)) << start.x;
    EXPECT_GE(way.points[0].x, 4.0);
  }
  ASSERT_TRUE(route.to_point({4.0, {9, 9}, {}, {}}, {0.2, 7}, way));  // as does a way to a goal
}

// Of the cells that a start near the wall may go to, it takes the one with the shortest way in all,
// not the nearest one, which would lead back.
TEST(GridRoute, JoinsTheGridWhereTheWayIsShortest) {
  GridRoute route(room().view());
  Path way;
  const Vec2 start{0.16, 1.46}, goal{0.45, 4.5};
  ASSERT_TRUE(route.to_point({0.3, start, {}, {}}, goal, way));
  EXPECT_GT(way.points[0].y, start.y + 0.2);
  EXPECT_LT(route.length_m(), 3.3);  // over the nearest cell: 3.38
}

// 0.6 m lies a hair below the sixth line between cells of 0.1 m in doubles. The baked distances
// count it to the cell in the north-east, and so does the way: never longer than they say.
TEST(GridRoute, APlaceBetweenCellsBelongsToTheNorthEasternOne) {
  GridRoute route(room().view());
  Path way;
  for (const int mm : {300, 600, 700, 1100, 1400}) {
    const Vec2 goal{mm * 1e-3, mm * 1e-3};
    ASSERT_TRUE(route.to_point({0.3, {4.55, mm * 1e-3 + 0.05}, {}, {}}, goal, way)) << mm;
    // straight along the row of the goal's cell, and half a diagonal at its end
    EXPECT_LT(route.length_m(), 4.5 - mm * 1e-3 + std::sqrt(0.005) + 1e-6) << mm;
  }
}

// A clearance in millimetres that is no exact double is met by a cell that has just that.
TEST(GridRoute, ACellWithExactlyTheClearanceIsAdmissible) {
  const std::int32_t edges[] = {0, 0, 900, 0, 900, 0, 900, 900, 900, 900, 0, 900, 0, 900, 0, 0};
  for (std::int32_t mm = 1; mm < 2000; ++mm) {
    std::vector<std::int32_t> cells(81, mm);
    ZoneView zone;
    zone.edges_mm = edges, zone.edge_count = 4, zone.columns = zone.rows = 9;
    zone.clearance_mm_lo = cells.data();
    GridRoute route(zone);
    Path way;
    ASSERT_TRUE(route.to_point({mm / 1000.0, {0.45, 0.45}, {}, {}}, {0.55, 0.45}, way)) << mm;
  }
}

// The nearest accepted place is along the way, not as the crow flies.
TEST(GridRoute, FindsTheNearestPlace) {
  GridRoute route(room().view());
  Path way;
  ASSERT_TRUE(route.to_place({0.3, {1, 2.5}, {}, {}}, Near({4, 2.5}), way));
  EXPECT_LT(norm(way.points.back() - Vec2{4, 2.5}), 0.3);
  EXPECT_GE(clearance({1, 2.5}, way), 0.3 - 1e-9);
}

// A diagonal step needs both cells beside it, as in the baked table of distances.
TEST(GridRoute, CutsNoCorners) {
  const std::int32_t edges[] = {0, 0, 200, 0, 200, 0, 200, 200, 200, 200, 0, 200, 0, 200, 0, 0};
  std::int32_t cells[] = {500, 0, 500, 500};
  ZoneView zone;
  zone.edges_mm = edges, zone.edge_count = 4, zone.columns = zone.rows = 2;
  zone.clearance_mm_lo = cells;
  GridRoute route(zone);
  Path way;
  ASSERT_TRUE(route.to_point({0.3, {0.05, 0.05}, {}, {}}, {0.15, 0.15}, way));
  EXPECT_NEAR(route.length_m(), 0.2, 1e-6);
  cells[2] = 0;
  EXPECT_FALSE(route.to_point({0.3, {0.05, 0.05}, {}, {}}, {0.15, 0.15}, way));
}

// More way-points than a path holds: the first ones come back, and the rest from the last of them;
// all together no longer than what was found first, which is what the way was priced at.
TEST(GridRoute, AWayOfManyPointsComesInPieces) {
  const test::Serpentine zone(60);
  GridRoute route(zone.view());
  Path way;
  RouteQuery query{0.3, zone.first(), {}, {}};
  ASSERT_TRUE(route.to_point(query, zone.last(), way));
  const double whole_m = route.length_m();
  EXPECT_TRUE(route.cut());
  EXPECT_EQ(way.points.size(), max_waypoints);
  EXPECT_NEAR(route.way_length_m(), whole_m, 1e-4);
  double driven_m = 0;
  for (int pieces = 1; pieces < 3 && route.cut(); ++pieces) {
    driven_m += length_m(query.start, way);
    query.start = way.points.back();
    query.over_start = true;
    ASSERT_TRUE(route.to_point(query, zone.last(), way));
    EXPECT_EQ(norm(way.points[0] - query.start), 0);
  }
  EXPECT_FALSE(route.cut());
  EXPECT_EQ(norm(way.points.back() - zone.last()), 0);
  EXPECT_LE(driven_m + length_m(query.start, way), whole_m + 1e-4);
}

// A start outside the grid, or not a number, is a refusal and nothing worse.
TEST(GridRoute, SurvivesBadStarts) {
  GridRoute route(room().view());
  Path way;
  EXPECT_FALSE(route.to_point({0.3, {std::nan(""), 1}, {}, {}}, {1, 1}, way));
  GridRoute nothing(ZoneView{});
  EXPECT_FALSE(nothing.to_point({0.3, {1, 1}, {}, {}}, {1, 1}, way));
}

}  // namespace
}  // namespace rtac::safe
