// How far places and discs may move before they leave a zone, and where its boundary is nearest:
// against the first of all edges that a leg touches, as a fraction, and the nearest of all edges.
#include "tests/kernel/zones/first_touch.h"

namespace rtac::kernel_test {
namespace {

constexpr long double unit = 1073741824.0L;  // of Q30

Place along(const Edge& leg, long double mm) {
  const long double part = std::min(1.0L, mm / std::max(1.0L, length(leg)));
  return {leg.a.x + std::llround(part * static_cast<long double>(leg.b.x - leg.a.x)),
          leg.a.y + std::llround(part * static_cast<long double>(leg.b.y - leg.a.y))};
}

TEST(ZoneWays, OfPlacesEndWhereTheyFirstTouchTheBoundaryOrJustBefore) {
  for_each_zone(100, 60, [](const Scene& scene, Random& random) {
    for (int i = 0; i < 200; ++i) {
      const Edge leg = delicate_leg(scene.edges, random);
      ASSERT_NO_FATAL_FAILURE(expect_leave(scene, leg))
          << leg.a.x << " " << leg.a.y << " to " << leg.b.x << " " << leg.b.y;
      const Edge wide{uniform_place(scene.edges, random), uniform_place(scene.edges, random)};
      ASSERT_NO_FATAL_FAILURE(expect_leave(scene, wide))
          << wide.a.x << " " << wide.a.y << " to " << wide.b.x << " " << wide.b.y;
    }
  });
}

// A leg of any direction up to its rounding, or along an axis, where nothing is rounded.
Edge some_leg(const Scene& scene, Random& random) {
  Edge leg{uniform_place(scene.edges, random), delicate_place(scene.edges, random)};
  if (random.one_in(2)) leg.b.y = leg.a.y;
  return leg;
}
void expect_disc(const Scene& scene, const Edge& leg, std::int64_t radius) {
  const std::int64_t found = probe_leave_mm(scene.tables.get(), leg.a, leg.b, radius);
  const bool is_on_axis = leg.a.y == leg.b.y;
  const bool starts_in = where(scene.edges, leg.a) > 0;
  if (found == all_the_way) {
    ASSERT_TRUE(starts_in && !crosses(scene.edges, leg) && keeps(scene.edges, leg, radius));
    return;
  }
  const Edge passed{leg.a, along(leg, static_cast<long double>(found))};
  ASSERT_TRUE(found == 0 || (starts_in && !crosses(scene.edges, passed) &&
                             keeps(scene.edges, passed, is_on_axis ? radius : radius - 1)))
      << found;
  if (!starts_in || radius + 10 > scene.tabled.horizon_mm) return;
  const Edge next{leg.a, along(leg, static_cast<long double>(found + 2))};
  ASSERT_FALSE(!crosses(scene.edges, next) && keeps(scene.edges, next, radius + 6)) << found;
}

TEST(ZoneWays, OfDiscsKeepTheirRadiusAndEndWhereAFewMillimetresMoreAreMissing) {
  for_each_zone(60, 61, [](const Scene& scene, Random& random) {
    for (int i = 0; i < 60; ++i) {
      const Edge leg = some_leg(scene, random);
      const std::int64_t near = distance_floor(scene.edges, {leg.a, leg.a});
      const std::int64_t radius = random.in(1, std::max<std::int64_t>(1, near + near / 8));
      ASSERT_NO_FATAL_FAILURE(expect_disc(scene, leg, radius))
          << leg.a.x << " " << leg.a.y << " to " << leg.b.x << " " << leg.b.y << " with " << radius;
    }
  });
}

long double distance(const std::vector<Edge>& edges, Place p) {
  long double least = std::numeric_limits<long double>::infinity();
  for (const Edge& e : edges) {
    const Square s = place_edge(p, e);
    least = std::min(least, static_cast<long double>(s.num) / static_cast<long double>(s.den));
  }
  return std::sqrt(least);
}
long double length(Place p) {
  return std::sqrt(static_cast<long double>(dot(p, p)));
}
// From p by so many mm in the direction of a border, to the grid.
Place moved(Place p, const probe_border& b, long double mm) {
  return {p.x + std::llround(mm * static_cast<long double>(b.inward_q30.x) / unit),
          p.y + std::llround(mm * static_cast<long double>(b.inward_q30.y) / unit)};
}

void expect_border(const Scene& scene, Place p) {
  const probe_border b = probe_border_of(scene.tables.get(), p);
  const int truth = where(scene.edges, p);
  ASSERT_TRUE(truth == 0 || b.inside == (truth > 0));
  ASSERT_TRUE(keeps(scene.edges, p, b.gap.lo));
  ASSERT_TRUE(is_within(scene.edges, {p, p}, b.gap.hi));
  ASSERT_NEAR(static_cast<double>(length(b.inward_q30) / unit), 1, 1e-8);
  const long double away = distance(scene.edges, p);
  const bool is_close = away < 1e7L && std::all_of(scene.edges.begin(), scene.edges.end(),
                                                   [](const Edge& e) { return length(e) < 1e7L; });
  ASSERT_TRUE(is_within(scene.edges, {b.at, b.at}, is_close ? 1 : 3)) << b.at.x << " " << b.at.y;
  const long double to_it = length(minus(b.at, p));
  ASSERT_GE(to_it, away - 3);
  if (b.nearest != 0) {
    ASSERT_LE(to_it, away + (is_close ? 1.05L : 3));
  } else {
    ASSERT_GE(away + 2, static_cast<long double>(scene.tabled.horizon_mm));
  }
  if (truth == 0) return;
  // Straight to the boundary from outside, straight away from it inside.
  const Place there =
      moved(p, b, truth > 0 ? -(b.nearest != 0 ? away : to_it) : (b.nearest != 0 ? away : to_it));
  ASSERT_TRUE(is_within(scene.edges, {there, there}, is_close ? 2 : 4))
      << there.x << " " << there.y;
}

TEST(ZoneWays, ToTheBoundaryAreStraightAndNearest) {
  for_each_zone(150, 62, [](const Scene& scene, Random& random) {
    for (int i = 0; i < 200; ++i) {
      const Place p = random.one_in(8) ? Place{random.in(-extent_mm, extent_mm),
                                               random.in(-extent_mm, extent_mm)}
                                       : delicate_place(scene.edges, random);
      ASSERT_NO_FATAL_FAILURE(expect_border(scene, p)) << p.x << " " << p.y;
    }
  });
}

TEST(ZoneWays, FromTheBoundaryItselfLeadInwards) {
  // A square with a hole: on sides and corners, those of the hole are reflex.
  const Zone yard{"yard",
                  {{{0, 0}, {9000, 0}, {9000, 9000}, {0, 9000}},
                   {{3000, 3000}, {3000, 6000}, {6000, 6000}, {6000, 3000}}}};
  const Scene scene(yard);
  for (const Place p : {Place{4500, 0}, Place{0, 0}, Place{9000, 9000}, Place{9000, 0},
                        Place{0, 700}, Place{3000, 3000}, Place{6000, 3000}, Place{4500, 3000},
                        Place{3000, 5999}, Place{6000, 6000}}) {
    const probe_border b = probe_border_of(scene.tables.get(), p);
    EXPECT_EQ(b.at.x, p.x);
    EXPECT_EQ(b.at.y, p.y);
    EXPECT_GT(where(scene.edges, moved(p, b, 200)), 0) << p.x << " " << p.y;
    EXPECT_TRUE(keeps(scene.edges, moved(p, b, 200), 140)) << p.x << " " << p.y;
  }
}

TEST(ZoneWays, AcrossABayEndAtItsMouth) {
  // In over the bay and out again: the first of several edges counts, whatever their order.
  const Zone bay{"bay",
                 {{{0, 0},
                   {8000, 0},
                   {8000, 4000},
                   {6000, 4000},
                   {6000, 1000},
                   {5000, 1000},
                   {5000, 4000},
                   {0, 4000}}}};
  const Tables tables = tables_of(bay);
  const auto leave = [&](Place p, Place e) { return probe_leave_mm(tables.get(), p, e, 0); };
  EXPECT_EQ(leave({1000, 500}, {7000, 500}), all_the_way);
  EXPECT_NEAR(static_cast<double>(leave({1000, 2000}, {7000, 2000})), 3998.5, 1.5);
  EXPECT_NEAR(static_cast<double>(leave({7000, 2000}, {1000, 2000})), 998.5, 1.5);
  EXPECT_NEAR(static_cast<double>(leave({1000, 1000}, {7000, 1000})), 3998.5, 1.5);  // touches
  EXPECT_EQ(leave({5500, 2000}, {5500, 500}), 0);
  EXPECT_EQ(leave({5000, 2000}, {1000, 2000}), 0);  // on the boundary
  EXPECT_EQ(leave({1000, 2000}, {1000, 2000}), all_the_way);
  // A robot of 300 mm turns back that much earlier.
  const std::int64_t disc = probe_leave_mm(tables.get(), {1000, 2000}, {7000, 2000}, 300);
  EXPECT_LE(disc, 3700);
  EXPECT_GE(disc, 3693);
}

}  // namespace
}  // namespace rtac::kernel_test
