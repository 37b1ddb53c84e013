// By how much distances from two boundaries of one zone may disagree: against places everywhere
// around them.
#include "compiler/geometry/spread.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/compiler/geometry/testing.h"

namespace rtac::geometry {
namespace {

struct Sides {
  Region within, around;
};
std::vector<EdgeRow> rows_within(const Sides& sides) {
  return edge_rows(*snap_inside(sides.within));
}
std::vector<EdgeRow> rows_around(const Sides& sides) {
  return edge_rows(*snap_around(sides.around));
}

double distance_mm(double x, double y, const EdgeRow& e) {
  const double ax = e.a.x_mm, ay = e.a.y_mm, dx = e.b.x_mm - ax, dy = e.b.y_mm - ay;
  const double share = std::clamp(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(x - ax - share * dx, y - ay - share * dy);
}
// Negative outside.
double signed_mm(double x, double y, const std::vector<EdgeRow>& rows) {
  double least = 1e18;
  bool inside = false;
  for (const EdgeRow& e : rows) {
    least = std::min(least, distance_mm(x, y, e));
    const double ay = e.a.y_mm, by = e.b.y_mm;
    if ((ay > y) == (by > y)) continue;
    if (x < e.a.x_mm + (y - ay) / (by - ay) * (e.b.x_mm - e.a.x_mm)) inside = !inside;
  }
  return inside ? least : -least;
}

// The most that they disagree at, of places near edges and everywhere.
double found_mm(const std::vector<EdgeRow>& within, const std::vector<EdgeRow>& around) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1), near(-30, 30), far(-9000, 9000);
  double most = 0;
  const auto judge = [&](double x, double y) {
    const double more = signed_mm(x, y, around) - signed_mm(x, y, within);
    EXPECT_GE(more, -1e-6) << "what contains the zone is wider";
    most = std::max(most, more);
  };
  for (const auto* rows : {&within, &around}) {
    for (const EdgeRow& e : *rows) {
      for (int k = 0; k < 24; ++k) {
        const double t = k == 0 ? 0 : share(random);
        judge(e.a.x_mm + t * (e.b.x_mm - e.a.x_mm) + (k % 3 == 0 ? 0.01 : near(random)),
              e.a.y_mm + t * (e.b.y_mm - e.a.y_mm) + (k % 3 == 0 ? 0.01 : near(random)));
      }
    }
  }
  for (int k = 0; k < 500; ++k) judge(far(random), far(random));
  return most;
}

// At least what is found, and no more than `most_mm`.
void expect_spread(const Sides& sides, double most_mm) {
  const auto within = rows_within(sides), around = rows_around(sides);
  const auto spread = spread_mm(within, around);
  ASSERT_TRUE(spread.has_value());
  const double found = found_mm(within, around);
  EXPECT_LE(found, static_cast<double>(*spread));
  EXPECT_GT(found, 0);
  EXPECT_LE(static_cast<double>(*spread), most_mm);
}

Sides circle(const Point& centre, const Rational& radius) {
  return {Region::circle(centre, radius, true), Region::circle(centre, radius, false)};
}

TEST(Spread, OfCirclesIsTwiceTheirError) {
  expect_spread(circle(mm(1000, 1000), 1), 30);
  expect_spread(circle(pt(0, 0), q(1, 3)), 30);
  expect_spread(circle(pt(0, 0), 100), 60);
}
TEST(Spread, OfWhatCirclesAreTakenFromIsAsLarge) {
  const Sides pond = circle(mm(2500, 2500), 1);
  const Region room = box(0, 0, 5000, 5000);
  expect_spread({room.subtract(pond.around), room.subtract(pond.within)}, 30);
  const Sides other = circle(mm(3200, 2500), 1);
  expect_spread({room.subtract(pond.around).subtract(other.around),
                 room.subtract(pond.within).subtract(other.within)},
                80);
}
TEST(Spread, OfOffsetsIsAFewMillimetres) {
  const Region room = box(0, 0, 5000, 5000).subtract(box(2000, 2000, 3000, 3000));
  const Rational by = q(1, 10), less = by - offset_excess_m();
  expect_spread({room.shrink(by), room.shrink(less)}, 12);
  expect_spread({room.grow(less), room.grow(by)}, 12);
}
// Of a needle the tip within retreats far.
TEST(Spread, OfTipsOffTheGridIsHowFarTheyRetreat) {
  const Region needle = polygon({pt(0, 0), {q(30'004, 10'000), q(1, 100)}, {0, q(2, 100)}});
  expect_spread({needle, needle}, 600);
}
TEST(Spread, OfRandomZonesIsNeverTooSmall) {
  std::mt19937 random(9);
  const auto number = [&](int most) {
    return static_cast<long>(random() % static_cast<unsigned>(most));
  };
  for (int round = 0; round < 25; ++round) {
    Region within = box(0, 0, 6000, 6000), around = within;
    for (int k = 0; k < 3; ++k) {
      const Point centre{q(number(60'000), 10'000), q(number(60'000), 10'000)};
      const Sides disc = circle(centre, q(300 + number(1500), 1000));
      const bool is_added = number(2) == 0;
      within = is_added ? within.unite(disc.within) : within.subtract(disc.around);
      around = is_added ? around.unite(disc.around) : around.subtract(disc.within);
    }
    const auto rows = rows_within({within, around}), wider = rows_around({within, around});
    const auto spread = spread_mm(rows, wider);
    if (!spread) continue;
    ASSERT_LE(found_mm(rows, wider), static_cast<double>(*spread)) << "round " << round;
  }
}
// A hole that one has alone: nothing is said of it.
TEST(Spread, OfRingsThatDoNotCorrespondIsNotKnown) {
  const Region room = box(0, 0, 5000, 5000);
  EXPECT_EQ(spread_mm(rows_within({room.subtract(box(10, 10, 4990, 4990)), room}),
                      rows_around({room, room})),
            std::nullopt);
}
// As many rings, of which one is somewhere else.
TEST(Spread, OfRingsThatAreElsewhereIsHowFarTheyAre) {
  const Region within = box(0, 0, 1000, 1000);
  const Region around = box(-9000, -9000, 9000, 9000);
  expect_spread({within, around}, 2 * std::hypot(10'000, 10'000) + 2);
}

}  // namespace
}  // namespace rtac::geometry
