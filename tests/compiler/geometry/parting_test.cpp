// What is shown of robots that get out of each other's way holds for the search that drives them:
// from wherever the two stand, it finds a way for the first of them or for the second.
#include "compiler/geometry/parting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "rooms.h"
#include "rtac/safe/grid_route.h"
#include "testing.h"
#include "zone_view.h"

namespace rtac::geometry {
namespace {

constexpr PartingQuery cart{200, 100, 220, 700, 760};

// Far enough from where the other one stands (Aside of the runtime).
struct FarFrom final : safe::PlaceTest {
  Vec2 other;
  double gap_m;
  FarFrom(Vec2 p, double gap) : other(p), gap_m(gap) {}
  [[nodiscard]] bool accepts(Vec2 place, double) const override {
    return norm(place - other) >= gap_m;
  }
};

class Pairs {
 public:
  Pairs(const BakedZone& zone, const PartingQuery& query)
      : zone_(zone), query_(query), view_(zone), route_(*view_) {}

  bool leaves(Vec2 one, Vec2 other) {
    safe::RouteQuery query;
    query.clearance_m = 1e-3 * query_.clearance_mm;
    query.start = one;
    (void)query.recede_from.push(other);
    Path way;
    if (!route_.to_place(query, FarFrom(other, 1e-3 * query_.goal_mm), way)) return false;
    Vec2 from = one;
    for (const Vec2 to : way.points) {
      EXPECT_GE(norm(to - other), norm(from - other) - 1e-9);
      from = to;
    }
    return true;
  }
  // A place where a robot may be.
  Vec2 somewhere() {
    const CellGrid& cells = zone_.cells;
    std::uniform_real_distribution<double> x(0, cells.columns * cells.cell_mm);
    std::uniform_real_distribution<double> y(0, cells.rows * cells.cell_mm);
    for (;;) {
      const Vec2 p{1e-3 * (cells.origin.x_mm + x(random_)),
                   1e-3 * (cells.origin.y_mm + y(random_))};
      if (signed_clearance(*view_, p) >= 1e-3 * query_.body_mm) return p;
    }
  }
  // The same, near enough to another one.
  Vec2 near(Vec2 other) {
    std::uniform_real_distribution<double> off(-query_.apart_mm, query_.apart_mm);
    for (;;) {
      const Vec2 p{other.x + 1e-3 * off(random_), other.y + 1e-3 * off(random_)};
      const double far = 1e3 * norm(p - other);
      if (far < query_.nearest_mm || far >= query_.apart_mm) continue;
      if (signed_clearance(*view_, p) >= 1e-3 * query_.body_mm) return p;
    }
  }

 private:
  const BakedZone& zone_;
  PartingQuery query_;
  View view_;
  safe::GridRoute route_;
  std::mt19937 random_{7};
};

Parting parting_of(const BakedZone& zone, const PartingQuery& query) {
  return parting(zone.edges, zone.cells, query);
}
// Wherever two robots stand in the zone, the search finds a way for one of them.
void expect_ways(const BakedZone& zone, const PartingQuery& query, int count) {
  Pairs pairs(zone, query);
  for (int i = 0; i < count; ++i) {
    const Vec2 other = pairs.somewhere(), one = pairs.near(other);
    ASSERT_TRUE(pairs.leaves(one, other) || pairs.leaves(other, one))
        << one.x << ", " << one.y << " and " << other.x << ", " << other.y;
  }
}
void expect_all_part(const Region& region, std::int32_t cell_mm, const PartingQuery& query) {
  const BakedZone zone = bake(*snap_inside(region), cell_mm);
  const Parting found = parting_of(zone, query);
  ASSERT_EQ(found.how, Parting::How::shown) << found.one.x_mm << ", " << found.one.y_mm << " and "
                                            << found.other.x_mm << ", " << found.other.y_mm;
  expect_ways(zone, query, 3000);
}

TEST(Parting, InAHall) {
  expect_all_part(box(0, 0, 5000, 5000), 100, cart);
}
TEST(Parting, AroundAPillar) {
  expect_all_part(box(0, 0, 6000, 6000).subtract(box(2500, 2500, 3500, 3500)), 100, cart);
}
TEST(Parting, OnBothSidesOfAThinWall) {
  expect_all_part(box(0, 0, 6000, 6000).subtract(box(2990, 0, 3010, 4000)), 100, cart);
}
TEST(Parting, InAHallOfWideCells) {
  PartingQuery large = cart;
  large.clearance_mm = 500, large.apart_mm = 2000, large.goal_mm = 2060;
  expect_all_part(box(0, 0, 20'000, 16'000), 300, large);
}
// In any room: whatever is shown is so.
TEST(Parting, InRandomRooms) {
  std::mt19937 random(17);
  int shown = 0;
  for (int i = 0; i < rooms_count(); ++i) {
    const BakedZone zone = bake(*snap_inside(random_room(random)), 100);
    const auto upto = [&](int most) { return static_cast<int>(random() % unsigned(most)); };
    PartingQuery query{120 + upto(200), 40 + upto(80), 0, 300 + upto(700), 0};
    query.nearest_mm = 2 * query.body_mm;
    query.goal_mm = query.apart_mm + upto(80);
    if (parting_of(zone, query).how != Parting::How::shown) continue;
    ++shown;
    expect_ways(zone, query, 300);
    if (HasFatalFailure()) FAIL() << "room " << i;
  }
  EXPECT_GT(shown, rooms_count() / 8);
}

Parting parting_in(const Region& region, const PartingQuery& query = cart) {
  const BakedZone zone = bake(*snap_inside(region), 100);
  return parting(zone.edges, zone.cells, query);
}

// A room in which no two places are far enough from each other, and a corridor in which one robot
// can stand at either wall: neither gets away without coming nearer.
TEST(Parting, NotWhereThereIsNoRoom) {
  EXPECT_EQ(parting_in(box(0, 0, 900, 900)).how, Parting::How::stuck);
  const Region corridor =
      box(0, 0, 2000, 2000).unite(box(6000, 0, 8000, 2000)).unite(box(2000, 700, 6000, 1300));
  const Parting narrow = parting_in(corridor);
  ASSERT_EQ(narrow.how, Parting::How::stuck);
  for (const GridPoint p : {narrow.one, narrow.other}) {
    EXPECT_GT(p.x_mm, 1500);
    EXPECT_LT(p.x_mm, 6500);
  }
}
// A corridor that is only just wide enough for a robot to stay in its midst: where corners are off
// the grid what is proved must not rest on 2 mm, which are not seen when it is found once more.
TEST(Parting, CountsOnNoMoreClearanceThanIsFoundOnceMore) {
  constexpr PartingQuery lean{198, 200, 400, 700, 760};
  const Region rooms =
      box(0, 0, 3000, 3000).unite(box(6000, 0, 9000, 3000)).unite(box(3000, 1300, 6000, 1800));
  EXPECT_EQ(parting_in(rooms, lean).how, Parting::How::shown);
  const Region notched = rooms.unite(polygon({mm(9000, 2000), mm(9040, 2100), mm(9000, 2200)}));
  EXPECT_EQ(parting_in(notched, lean).how, Parting::How::shown);
  PartingQuery off_grid = lean;
  off_grid.off_grid = true;
  EXPECT_EQ(parting_in(notched, off_grid).how, Parting::How::stuck);
  off_grid.clearance_mm = 190;
  EXPECT_EQ(parting_in(notched, off_grid).how, Parting::How::shown);
}
// In an aisle that is no wider than robots part by one before each wall finds none, beside the
// other one: where a run can begin, and not in the middle of a cell that no body fits into.
TEST(Parting, WhereNeitherLeavesARobotFits) {
  PartingQuery wide{672, 280, 560, 5220, 5260};
  wide.stands_mm = 320;
  const BakedZone lane = bake(*snap_inside(box(0, 3000, 20'000, 9000)), 100);
  const Parting stuck = parting_of(lane, wide);
  ASSERT_EQ(stuck.how, Parting::How::stuck);
  Pairs pairs(lane, wide);
  const auto at = [](const GridPoint& p) { return Vec2{1e-3 * p.x_mm, 1e-3 * p.y_mm}; };
  EXPECT_FALSE(pairs.leaves(at(stuck.one), at(stuck.other)));
  EXPECT_FALSE(pairs.leaves(at(stuck.other), at(stuck.one)));
  for (const GridPoint& p : {stuck.one, stuck.other}) {
    EXPECT_GE(std::min({p.x_mm, p.y_mm - 3000, 9000 - p.y_mm}), 320);
  }
}
// They are there, too, when the search is asked.
TEST(Parting, WhereTheSearchFindsNothingEither) {
  const BakedZone zone = bake(*snap_inside(box(0, 0, 900, 900)), 100);
  Pairs pairs(zone, cart);
  EXPECT_FALSE(pairs.leaves({0.3, 0.3}, {0.6, 0.6}) || pairs.leaves({0.6, 0.6}, {0.3, 0.3}));
}

// That pairs look alike, or leave over what is clear beside them, changes nothing of what is found.
void expect_the_same_alone(const BakedZone& zone, PartingQuery query) {
  const Parting found = parting_of(zone, query);
  query.each_alone = true;
  const Parting alone = parting_of(zone, query);
  EXPECT_EQ(found.how, alone.how);
  EXPECT_EQ(found.one, alone.one);
  EXPECT_EQ(found.other, alone.other);
}
TEST(Parting, IsTheSamePairByPairInRandomRooms) {
  std::mt19937 random(23);
  for (int i = 0; i < rooms_count() / 3; ++i) {
    const BakedZone zone = bake(*snap_inside(random_room(random)), 100);
    const auto upto = [&](int most) { return static_cast<int>(random() % unsigned(most)); };
    PartingQuery query{120 + upto(200), 40 + upto(80), 0, 300 + upto(700), 0};
    query.nearest_mm = 2 * query.body_mm;
    query.goal_mm = query.apart_mm + upto(80);
    expect_the_same_alone(zone, query);
    if (HasFailure()) FAIL() << "room " << i;
  }
}
// Pillars in a hall, a whole number of cells apart and one like the other; beside the last one
// there is a dead end, or a notch that only edges tell of.
Region pillars(const Region& last) {
  Region all = box(0, 0, 15'000, 5000).unite(last);
  for (long x = 2000; x < 14'000; x += 3000) {
    all = all.subtract(box(x, 2000, x + 1000, 3000));
  }
  return all;
}
TEST(Parting, IsTheSamePairByPairAmongPillars) {
  const Region alike = box(0, 0, 100, 100), dead_end = box(12'200, 4900, 12'900, 6500);
  const Region notch = polygon({mm(12'200, 4990), mm(12'300, 4990), mm(12'260, 5070)});
  for (const Region& last : {alike, dead_end, notch}) {
    for (const int corner : {0, 33}) {
      const Region zone = pillars(last).subtract(box(-10, -10, corner, 10));
      expect_the_same_alone(bake(*snap_inside(zone), 100), cart);
    }
  }
  EXPECT_EQ(parting_in(pillars(alike)).how, Parting::How::shown);
  const Parting stuck = parting_in(pillars(dead_end));
  ASSERT_EQ(stuck.how, Parting::How::stuck);
  EXPECT_GT(stuck.one.x_mm, 11'500);
  EXPECT_GT(stuck.one.y_mm, 4000);
}
// Of a large basin most pairs of cells look alike. Vessels in it keep far from its walls and from
// each other: pair by pair that takes too long.
constexpr PartingQuery vessel{2300, 700, 1400, 7000, 7100};
TEST(Parting, InALargeBasin) {
  expect_all_part(box(0, 0, 47'500, 32'500), 250, vessel);
}
TEST(Parting, InADeadEndOfALargeBasin) {
  const Region basin = box(0, 0, 47'500, 32'500).unite(box(47'400, 24'000, 58'000, 28'000));
  const BakedZone zone = bake(*snap_inside(basin), 250);
  const Parting found = parting_of(zone, vessel);
  ASSERT_EQ(found.how, Parting::How::stuck);
  for (const GridPoint p : {found.one, found.other}) {
    EXPECT_GT(p.x_mm, 42'000);
    EXPECT_GT(p.y_mm, 20'000);
  }
}
TEST(Parting, OfTooManyPairsIsNotLookedAt) {
  PartingQuery far = cart;
  far.apart_mm = 9000, far.goal_mm = 9060;
  far.each_alone = true;
  EXPECT_EQ(parting_in(box(0, 0, 19'900, 19'900), far).how, Parting::How::too_large);
}

}  // namespace
}  // namespace rtac::geometry
