// Places against zones in the kernel of the golden case `plain_points`: verdicts of a place without
// error against exact geometry, around every vertex and along every edge; bounds of clearances.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "spec.h"
#include "tests/kernel/exact_rings.h"

namespace crane {
namespace {

using rtac::kernel_test::m;
using rtac::kernel_test::mm;
using rtac::kernel_test::pad;
using rtac::kernel_test::Place;
using rtac::kernel_test::Um;

bool on_pad(Place p) {
  return within(pad(), p);
}
// From the boundary, negative outside.
double clearance_m(Place p) {
  return on_pad(p) ? boundary_m(pad(), p) : -boundary_m(pad(), p);
}

// Around all vertices and points on edges, on the grid of millimetres and off it.
std::vector<Place> places() {
  std::vector<Place> all;
  const std::vector<Um> offsets = {-375 * mm, -125 * mm, -3 * mm, -mm, -400,   -1,
                                   0,         1,         500,     mm,  3 * mm, 125 * mm};
  for_each_edge(pad(), [&](Place a, Place b) {
    for (int step = 0; step < 8; ++step) {
      const Place from{a.x + (b.x - a.x) / 8 * step, a.y + (b.y - a.y) / 8 * step};
      for (const Um x : offsets) {
        for (const Um y : offsets) all.push_back({from.x + x, from.y + y});
      }
    }
  });
  return all;
}
// Doubles hold these millimetres exactly, and few others.
bool is_on_grid(Place p) {
  return p.x % (125 * mm) == 0 && p.y % (125 * mm) == 0;
}
// Is all of the millimetre around the place on one side of the boundary?
bool is_clear(Place p) {
  return std::abs(clearance_m(p)) > 0.0015;
}

class Places : public ::testing::Test {
 protected:
  const std::array<rtac::Finding, Monitors::count>& at(Place p) {
    now_us_ += 100'000;
    const rtac::Position place{rtac::Length(double(p.x) / double(m)),
                               rtac::Length(double(p.y) / double(m))};
    return crane_.mark(place, now_us_).step(now_us_);
  }
  const std::array<rtac::Finding, Monitors::count>& hook(double x, double y) {
    now_us_ += 100'000;
    return crane_.hook({rtac::Length(x), rtac::Length(y)}, now_us_).step(now_us_);
  }
  Monitors crane_;
  rtac::TimeUs now_us_ = 1'000'000;
};

TEST_F(Places, OnTheGridAreJudgedExactly) {
  for (const Place p : places()) {
    if (!is_on_grid(p)) continue;
    const auto& found = at(p);
    const rtac::Verdict due = on_pad(p) ? rtac::Verdict::is_true : rtac::Verdict::is_false;
    ASSERT_EQ(found[Monitors::marked_index].verdict, due) << p.x << " " << p.y;
    ASSERT_NE(found[Monitors::bare_index].verdict, due) << p.x << " " << p.y;
    ASSERT_NE(found[Monitors::bare_index].verdict, rtac::Verdict::is_unknown) << p.x << " " << p.y;
  }
}

TEST_F(Places, OffTheGridAreNeverMisjudged) {
  for (const Place p : places()) {
    const auto& found = at(p);
    const bool inside = on_pad(p);
    const rtac::Verdict wrong = inside ? rtac::Verdict::is_false : rtac::Verdict::is_true;
    ASSERT_NE(found[Monitors::marked_index].verdict, wrong) << p.x << " " << p.y;
    if (is_clear(p)) {
      ASSERT_EQ(found[Monitors::marked_index].verdict,
                inside ? rtac::Verdict::is_true : rtac::Verdict::is_false)
          << p.x << " " << p.y;
    }
  }
}

// The lower end is that of `spare`, the upper one that of `bare`, turned round.
TEST_F(Places, HaveClearancesWithinBounds) {
  for (const Place p : places()) {
    const auto& found = at(p);
    const double exact_m = clearance_m(p);
    const double lo_m = found[Monitors::spare_index].margin + 0.5;
    const double hi_m = -found[Monitors::bare_index].margin;
    const double most_m = is_on_grid(p) ? 0.00301 : 0.0075;
    const double slack_m = 1e-6;  // of margins, which are rounded to millionths
    ASSERT_LE(lo_m, exact_m + slack_m) << p.x << " " << p.y;
    ASSERT_GE(hi_m, exact_m - slack_m) << p.x << " " << p.y;
    ASSERT_GE(lo_m, exact_m - most_m) << p.x << " " << p.y;
    ASSERT_LE(hi_m, exact_m + most_m) << p.x << " " << p.y;
  }
}

// The mast lies between two polygons, and the hook within 5 cm of each coordinate.
TEST_F(Places, NearACircleAreKnownBetweenTwoPolygons) {
  for (int k = 0; k < 720; ++k) {
    const double angle = 0.0087266 * k, reach_m = 0.0707107;
    for (const double out_m : {2.55, 2.565, 2.575, 2.58, 2.60, 2.7}) {
      const double x = 20 + out_m * std::cos(angle), y = 12 + out_m * std::sin(angle);
      const auto& found = hook(x, y)[Monitors::off_mast_index];
      if (out_m - reach_m < 2.5) {
        ASSERT_NE(found.verdict, rtac::Verdict::is_true) << k << " " << out_m;
      }
      if (out_m > 2.6) {  // the polygon around is no more than 1 cm wider
        ASSERT_EQ(found.verdict, rtac::Verdict::is_true) << k << " " << out_m;
      }
    }
    const double in_m = 2.06;
    const auto& near = hook(20 + in_m * std::cos(angle), 12 + in_m * std::sin(angle));
    ASSERT_EQ(near[Monitors::off_mast_index].verdict, rtac::Verdict::is_false) << k;
  }
}

// A clearance is no better than the deepest place allows.
TEST_F(Places, WithoutNumbersAreUnknown) {
  const auto& found = hook(std::nan(""), 3);
  EXPECT_EQ(found[Monitors::over_ground_index].verdict, rtac::Verdict::is_unknown);
  EXPECT_EQ(found[Monitors::off_mast_index].verdict, rtac::Verdict::is_unknown);
}

}  // namespace
}  // namespace crane
