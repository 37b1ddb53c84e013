// A robot in a zone of 10,000 edges: the runtime looks its questions up in the tables of the
// kernel, with the answers that looking at every edge gives, and recoveries get the robot out of
// trouble.
#include <gtest/gtest.h>

#include <limits>

#include "quay_10000/quay.h"
#include "rtac/safe/controllers.h"
#include "rtac/safe/grid_route.h"
#include "tests/runtime/core/test_plants.h"
#include "tests/runtime/zones/places.h"

namespace rtac {
namespace {

using test::Places;

constexpr double rounding_m = 1e-9;

const ZoneView& quay() {
  return quay_10000::quay_zone();
}
const ZoneView& all_edges() {
  static const ZoneView zone = test::without_tree(quay());
  return zone;
}
double exact_m() {
  return quay_10000_quay_area.exact * 1e-3;
}

TEST(Quay, ClearancesOfPlacesAreThoseOfAllEdges) {
  ASSERT_NE(quay().tree, nullptr);
  ASSERT_GT(quay().edge_count, 9'900U);
  Places places(quay(), 1);
  for (int i = 0; i < 4'000; ++i) {
    const Vec2 p = i % 4 == 0 ? places.anywhere() : places.near(i % 4 == 1 ? 1e-2 : 5);
    const double truth = signed_clearance(all_edges(), p), found = signed_clearance(quay(), p);
    if (truth < exact_m()) {
      ASSERT_NEAR(found, truth, rounding_m) << p.x << " " << p.y;
    } else {
      ASSERT_LE(found, truth) << p.x << " " << p.y;
      ASSERT_GE(found, exact_m()) << p.x << " " << p.y;
    }
    ASSERT_NEAR(norm(nearest_boundary(quay(), p) - p), norm(nearest_boundary(all_edges(), p) - p),
                truth < exact_m() ? rounding_m : 1e9);
  }
}

// On vertices and half-way between them, where the boundary turns.
TEST(Quay, PlacesOnTheBoundaryHaveNoClearance) {
  for (std::size_t i = 0; i < quay().edge_count; ++i) {
    const std::int32_t* e = quay().edges_mm + 4 * i;
    const Vec2 a{e[0] * 1e-3, e[1] * 1e-3}, middle{(e[0] + e[2]) * 5e-4, (e[1] + e[3]) * 5e-4};
    ASSERT_NEAR(signed_clearance(quay(), a), 0, rounding_m);
    ASSERT_NEAR(signed_clearance(quay(), middle), 0, rounding_m);
    const Vec2 in = inward(quay(), middle);
    ASSERT_NEAR(norm(in), 1, 1e-9);
    ASSERT_GT(signed_clearance(quay(), middle + 0.001 * in), 0) << middle.x << " " << middle.y;
  }
}

TEST(Quay, ClearancesOfLegsAreThoseOfAllEdges) {
  Places places(quay(), 2);
  int crossing = 0;
  for (int i = 0; i < 1'500; ++i) {
    const Vec2 a = i % 3 == 0 ? places.anywhere() : places.near(3);
    const double length_m = i % 2 == 0 ? 4 : 60;
    const Vec2 b =
        a + Vec2{places.between(-length_m, length_m), places.between(-length_m, length_m)};
    const double truth = signed_clearance(all_edges(), a, b),
                 found = signed_clearance(quay(), a, b);
    crossing += truth <= 0 ? 1 : 0;
    if (truth <= 0) {
      ASSERT_NEAR(found, truth, 2e-3) << a.x << " " << a.y << " to " << b.x << " " << b.y;
    } else if (truth < exact_m()) {
      ASSERT_NEAR(found, truth, rounding_m) << a.x << " " << a.y << " to " << b.x << " " << b.y;
    } else {
      ASSERT_TRUE(found <= truth && found >= exact_m());
    }
  }
  EXPECT_GT(crossing, 100);
}

// What the kernel answers in integers, never late; the runtime in doubles.
TEST(Quay, LegsAreLeftWhereTheKernelSaysOrJustBehind) {
  Places places(quay(), 3);
  int left = 0;
  for (int i = 0; i < 2'000; ++i) {
    const auto mm = [](double m) { return std::llround(1e3 * m); };
    const auto on_grid = [&](Vec2 p) {
      return Vec2{static_cast<double>(mm(p.x)) * 1e-3, static_cast<double>(mm(p.y)) * 1e-3};
    };
    const Vec2 a = on_grid(places.near(20)), b = on_grid(places.near(20));
    const double found_m = distance_to_leave(quay(), a, b);
    const std::int64_t kernel_mm =
        quay_10000_leave_mm(&quay_10000_quay_area, mm(a.x), mm(a.y), mm(b.x), mm(b.y), 0);
    if (found_m == std::numeric_limits<double>::infinity()) {
      ASSERT_EQ(kernel_mm, INT64_MAX);
      continue;
    }
    left += found_m > 0 ? 1 : 0;
    ASSERT_LE(static_cast<double>(kernel_mm), 1e3 * found_m + 1e-3);
    ASSERT_GE(static_cast<double>(kernel_mm), 1e3 * found_m - 3);
    const double disc_m = distance_to_leave(quay(), a, b, 0.5);
    ASSERT_LE(disc_m, found_m + rounding_m);
    if (disc_m <= 1e-3) continue;
    const double share = disc_m / norm(b - a);
    ASSERT_GE(signed_clearance(quay(), a, a + 0.999 * share * (b - a)), 0.5 - rounding_m);
    ASSERT_LT(signed_clearance(quay(), a, a + std::min(1.0, 1.001 * share) * (b - a)), 0.5 + 1e-2);
  }
  EXPECT_GT(left, 500);
}

TEST(Quay, TheKernelShowsTheWayIn) {
  Places places(quay(), 4);
  for (int i = 0; i < 2'000; ++i) {
    const Vec2 p = places.near(8);
    quay_10000_border border;
    quay_10000_border_of(&quay_10000_quay_area, std::llround(1e3 * p.x), std::llround(1e3 * p.y),
                         &border);
    const double truth_mm = 1e3 * signed_clearance(all_edges(), p);
    ASSERT_EQ(border.nearest, 1);
    ASSERT_LE(static_cast<double>(border.gap_mm_lo), std::abs(truth_mm) + 1);
    ASSERT_GE(static_cast<double>(border.gap_mm_hi), std::abs(truth_mm) - 1);
    if (std::abs(truth_mm) < 20) continue;
    ASSERT_EQ(border.inside, truth_mm > 0);
    const Vec2 in{static_cast<double>(border.inward_x_q30) * 0x1p-30,
                  static_cast<double>(border.inward_y_q30) * 0x1p-30};
    // Straight in, and as far as it was away: on the boundary; outside it only gets better.
    if (truth_mm < 0) {
      ASSERT_NEAR(1e3 * signed_clearance(all_edges(), p - (truth_mm * 1e-3) * in), 0, 3);
    }
  }
}

safe::Setting cart(const ZoneView& zone) {
  safe::Setting s;
  s.limits = quay_10000::Cart_limits(), s.period_us = 50'000, s.speed_mps = 0.5, s.zone = &zone;
  s.route_clearance_m = 0.5, s.return_clearance_m = 0.8, s.pass_gap_m = 1;
  return s;
}

// From the edge of the quay, and from beyond it, the cart gets to where control returns.
TEST(Quay, ACartRetreatsFromItsEdge) {
  Places places(quay(), 5);
  int outside = 0, close = 0;
  for (int i = 0; i < 40; ++i) {
    const Vec2 start = places.near(0.6);
    const double before_m = signed_clearance(quay(), start);
    outside += before_m < 0 ? 1 : 0;
    test::Plant<Acceleration> plant(quay_10000::Cart_limits(), start);
    safe::Retreat<Acceleration> retreat(cart(quay()));
    retreat.engage(plant.observe());
    for (int k = 0; k < 400; ++k) tick(retreat, plant, Gate::free, 50'000);
    close += signed_clearance(all_edges(), plant.p) >= 0.75 ? 1 : 0;
    EXPECT_GT(signed_clearance(all_edges(), plant.p), std::min(before_m, 0.5) - 0.1);
  }
  EXPECT_GE(outside, 8);
  EXPECT_GE(close, 36);  // some bays are too narrow to turn round in
}

TEST(Quay, WaysAcrossItKeepTheirClearance) {
  Places places(quay(), 6);
  safe::GridRoute route(quay());
  int found = 0;
  for (int i = 0; i < 200 && found < 20; ++i) {
    const Vec2 a = places.anywhere(), b = places.anywhere();
    if (signed_clearance(quay(), a) < 1 || signed_clearance(quay(), b) < 1) continue;
    Path way;
    if (!route.to_point({0.5, a, {}, {}}, b, way) || route.cut()) continue;
    ++found;
    Vec2 from = a;
    for (const Vec2 p : way.points) {
      ASSERT_GE(signed_clearance(all_edges(), from, p), 0.5 - 1e-2);
      from = p;
    }
    EXPECT_NEAR(norm(from - b), 0, 1e-9);
  }
  EXPECT_EQ(found, 20);
}

}  // namespace
}  // namespace rtac
