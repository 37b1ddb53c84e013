// Places of space against zones with height in the kernel: verdicts of a place without error
// against exact geometry, around every corner, edge and face; bounds of clearances; verdicts alone.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "airspace.h"
#include "tests/kernel/exact_rings.h"

namespace airspace {
namespace {

using rtac::kernel_test::m;
using rtac::kernel_test::mm;
using rtac::kernel_test::pad;
using rtac::kernel_test::Place;
using rtac::kernel_test::Rings;
using rtac::kernel_test::Um;

constexpr double mast_m = -5;  // its middle, on both axes

struct Spot {
  Place at;
  Um z;
};
struct Slab {
  Rings base;
  Um floor, ceiling;
};

Rings box(Um x0, Um y0, Um x1, Um y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}
const std::vector<Slab>& stack() {
  static const std::vector<Slab> slabs = {
      {pad(), -1 * m, 2 * m},
      {box(-500 * mm, 500 * mm, 3 * m, 3 * m), 2 * m, 3500 * mm},
      {box(1 * m, 1 * m, 5 * m, 2 * m), 4 * m, 5 * m}};
  return slabs;
}

bool on_stack(const Spot& p) {
  for (const Slab& slab : stack()) {
    if (slab.floor <= p.z && p.z <= slab.ceiling && within(slab.base, p.at)) return true;
  }
  return false;
}

// What is known of a place that lies between millimetres is their cell.
struct Cell {
  std::vector<Place> corners;
  Um z0, z1;
};
Um down(Um at) {
  return at - (at % mm + mm) % mm;
}
Um up(Um at) {
  return -down(-at);
}
Cell cell_of(const Spot& p) {
  const Um x0 = down(p.at.x), y0 = down(p.at.y), x1 = up(p.at.x), y1 = up(p.at.y);
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, down(p.z), up(p.z)};
}
// Corners of slabs are corners of cells, so that a cell is where all its corners are.
bool in_stack(const Cell& cell) {
  return std::any_of(stack().begin(), stack().end(), [&](const Slab& slab) {
    return slab.floor <= cell.z0 && cell.z1 <= slab.ceiling &&
           std::all_of(cell.corners.begin(), cell.corners.end(),
                       [&](Place p) { return within(slab.base, p); });
  });
}
bool meets_stack(const Cell& cell) {
  return std::any_of(stack().begin(), stack().end(), [&](const Slab& slab) {
    return slab.floor <= cell.z1 && cell.z0 <= slab.ceiling &&
           std::any_of(cell.corners.begin(), cell.corners.end(),
                       [&](Place p) { return within(slab.base, p); });
  });
}

// Faces at a height are where a place is in what lies below or above, but not in both.
double boundary_m(const Spot& p) {
  double least = 1e9;
  for (const Slab& slab : stack()) {
    const Um beyond = std::max({slab.floor - p.z, p.z - slab.ceiling, Um{0}});
    least = std::min(least, std::hypot(boundary_m(slab.base, p.at), double(beyond) / double(m)));
    for (const Um face : {slab.floor, slab.ceiling}) {
      int covered = 0;
      for (const Slab& other : stack()) {
        if (other.floor == face && within(other.base, p.at)) ++covered;
        if (other.ceiling == face && within(other.base, p.at)) ++covered;
      }
      if (covered == 1) least = std::min(least, double(std::abs(p.z - face)) / double(m));
    }
  }
  return least;
}
// Negative outside.
double clearance_m(const Spot& p) {
  return on_stack(p) ? boundary_m(p) : -boundary_m(p);
}

// Around points on the edges of all slabs at their floors and ceilings and between them, on the
// grid of millimetres and off it; and far from all of them.
std::vector<Spot> spots() {
  std::vector<Spot> all;
  const std::vector<Um> offsets = {-375 * mm, -1400, -400, 0, 1, 1600, 125 * mm};
  for (const Slab& slab : stack()) {
    for_each_edge(slab.base, [&](Place a, Place b) {
      for (int step = 0; step < 4; ++step) {
        const Place from{a.x + (b.x - a.x) / 4 * step, a.y + (b.y - a.y) / 4 * step};
        for (const Um z : {slab.floor, (slab.floor + slab.ceiling) / 2, slab.ceiling}) {
          for (const Um x : offsets) {
            for (const Um y : offsets) {
              for (const Um up : offsets) all.push_back({{from.x + x, from.y + y}, z + up});
            }
          }
        }
      }
    });
  }
  for (Um x = -8 * m; x <= 8 * m; x += 2 * m) {
    for (Um y = -8 * m; y <= 8 * m; y += 2 * m) {
      for (Um z = -8 * m; z <= 8 * m; z += 1 * m) all.push_back({{x, y}, z});
    }
  }
  return all;
}
// Doubles hold these millimetres exactly, and no others.
bool is_on_grid(Um at) {
  return at % (125 * mm) == 0;
}
bool is_on_grid(const Spot& p) {
  return is_on_grid(p.at.x) && is_on_grid(p.at.y) && is_on_grid(p.z);
}

rtac::Verdict verdict(bool holds) {
  return holds ? rtac::Verdict::is_true : rtac::Verdict::is_false;
}

class Prisms : public ::testing::Test {
 protected:
  static std::array<double, 3> metres(const Spot& p) {
    return {double(p.at.x) / double(m), double(p.at.y) / double(m), double(p.z) / double(m)};
  }
  // All verdicts are the same when they are computed alone.
  const auto& step() {
    const auto& found = monitors_.step(now_us_);
    const auto& verdicts = alone_.verdicts(now_us_);
    for (std::size_t k = 0; k < Monitors::count; ++k) EXPECT_EQ(verdicts[k], found[k].verdict) << k;
    return found;
  }
  const auto& mark(const Spot& p) {
    now_us_ += 100'000;
    monitors_.mark(metres(p), now_us_);
    alone_.mark(metres(p), now_us_);
    return step();
  }
  const auto& at(const std::array<double, 3>& place) {
    now_us_ += 100'000;
    monitors_.at(place, now_us_);
    alone_.at(place, now_us_);
    return step();
  }
  Monitors monitors_, alone_;
  rtac::TimeUs now_us_ = 1'000'000;
};

// On the grid that is always, elsewhere but for the cells that the boundary meets.
TEST_F(Prisms, MarksAreJudgedAsFarAsTheirCellTells) {
  for (const Spot& p : spots()) {
    const auto& found = mark(p);
    SCOPED_TRACE(::testing::Message() << p.at.x << " " << p.at.y << " " << p.z);
    const Cell cell = cell_of(p);
    if (in_stack(cell) || !meets_stack(cell)) {
      ASSERT_EQ(found[Monitors::stacked_index].verdict, verdict(on_stack(p)));
      ASSERT_EQ(found[Monitors::bare_index].verdict, verdict(!on_stack(p)));
    } else {
      ASSERT_NE(found[Monitors::stacked_index].verdict, verdict(!on_stack(p)));
      ASSERT_NE(found[Monitors::bare_index].verdict, verdict(on_stack(p)));
    }
  }
}

// The lower end is that of `spare`, the upper one that of `bare`, turned round.
TEST_F(Prisms, MarksHaveClearancesWithinBounds) {
  for (const Spot& p : spots()) {
    const auto& found = mark(p);
    SCOPED_TRACE(::testing::Message() << p.at.x << " " << p.at.y << " " << p.z);
    const double exact_m = clearance_m(p);
    const double lo_m = found[Monitors::spare_index].margin + 0.5;
    const double hi_m = -found[Monitors::bare_index].margin;
    const double most_m = is_on_grid(p) ? 0.00401 : 0.009;
    const double slack_m = 1e-6;  // of margins, which are rounded to millionths
    ASSERT_LE(lo_m, exact_m + slack_m);
    ASSERT_GE(hi_m, exact_m - slack_m);
    ASSERT_GE(lo_m, exact_m - most_m);
    ASSERT_LE(hi_m, exact_m + most_m);
  }
}

// With an error of 5 cm along each axis, what lies nearer to a face than that is unknown, and
// nothing that lies farther than the corners of the error.
TEST_F(Prisms, PlacesWithAnErrorAreKnownBeyondIt) {
  for (const Spot& p : spots()) {
    const auto& found = at(metres(p));
    SCOPED_TRACE(::testing::Message() << p.at.x << " " << p.at.y << " " << p.z);
    const bool on = on_stack(p);
    ASSERT_NE(found[Monitors::kept_index].verdict, verdict(!on));
    ASSERT_NE(found[Monitors::off_index].verdict, verdict(on));
    if (boundary_m(p) > 0.095) {  // 5 cm * sqrt(3), and resolution
      ASSERT_EQ(found[Monitors::kept_index].verdict, verdict(on));
      ASSERT_EQ(found[Monitors::off_index].verdict, verdict(!on));
    }
    if (boundary_m(p) < 0.048) {
      ASSERT_EQ(found[Monitors::kept_index].verdict, rtac::Verdict::is_unknown);
    }
  }
}

// The mast lies between two polygons, from the ground to 6 m.
TEST_F(Prisms, NearTheMastAreKnownBetweenTwoPolygons) {
  for (int k = 0; k < 360; ++k) {
    const double angle = 0.0174533 * k;
    for (const double z : {-0.7, -0.45, -0.3, 0.2, 3.0, 5.8, 6.3, 6.45, 6.7}) {
      for (const double out_m : {1.8, 2.2, 2.45, 2.62, 2.7}) {
        const double x = mast_m + out_m * std::cos(angle), y = mast_m + out_m * std::sin(angle);
        const auto verdict = at({x, y, z})[Monitors::off_mast_index].verdict;
        const double gap_m = std::hypot(std::max({-z, z - 6, 0.0}), std::max(out_m - 2, 0.0));
        SCOPED_TRACE(::testing::Message() << k << " degrees, " << out_m << " m, " << z << " m up");
        ASSERT_TRUE(gap_m >= 0.5 || verdict != rtac::Verdict::is_true);
        ASSERT_TRUE(gap_m <= 0.61 || verdict == rtac::Verdict::is_true);
        ASSERT_TRUE(gap_m >= 0.39 || verdict == rtac::Verdict::is_false);
      }
    }
  }
}

// The boxes that the errors make of a place are in the mast, off it, or neither.
TEST_F(Prisms, PlacesWithAnErrorAreInTheMastWithAllOfIt) {
  for (int k = 0; k < 360; ++k) {
    const double angle = 0.0174533 * k;
    for (double out_m = 1.8; out_m < 2.2; out_m += 0.01) {
      const double x = out_m * std::cos(angle), y = out_m * std::sin(angle);
      const auto verdict = at({mast_m + x, mast_m + y, 3})[Monitors::at_mast_index].verdict;
      const double far_m = std::hypot(std::fabs(x) + 0.05, std::fabs(y) + 0.05);
      const double near_m =
          std::hypot(std::max(std::fabs(x) - 0.05, 0.0), std::max(std::fabs(y) - 0.05, 0.0));
      SCOPED_TRACE(::testing::Message() << k << " degrees, " << out_m << " m");
      ASSERT_TRUE(far_m <= 2 || verdict != rtac::Verdict::is_true);
      ASSERT_TRUE(near_m >= 2 || verdict != rtac::Verdict::is_false);
      ASSERT_TRUE(out_m > 1.89 || verdict == rtac::Verdict::is_true);
      ASSERT_TRUE(out_m < 2.11 || verdict == rtac::Verdict::is_false);
    }
  }
}
// Around it edges are many and near, so that a box holds more than the cell of a corner lists.
TEST_F(Prisms, PlacesWithAnErrorAreOnAPoleThatIsHardlyWider) {
  int on = 0;
  for (int column = -40; column <= 40; ++column) {
    for (int row = -40; row <= 40; ++row) {
      const double x = column * 0.005, y = row * 0.005;
      const auto verdict = at({5 + x, -5 + y, 1})[Monitors::on_pole_index].verdict;
      const double far_m = std::hypot(std::fabs(x) + 0.05, std::fabs(y) + 0.05);
      const double near_m =
          std::hypot(std::max(std::fabs(x) - 0.05, 0.0), std::max(std::fabs(y) - 0.05, 0.0));
      SCOPED_TRACE(::testing::Message() << x << " " << y);
      ASSERT_TRUE(far_m <= 0.1 || verdict != rtac::Verdict::is_true);
      ASSERT_TRUE(near_m >= 0.1 || verdict != rtac::Verdict::is_false);
      on += verdict == rtac::Verdict::is_true ? 1 : 0;
    }
  }
  EXPECT_GT(on, 0);
}

TEST_F(Prisms, MarksAreOnTheMastWithinACentimetre) {
  for (int k = 0; k < 360; ++k) {
    const double angle = 0.0174533 * k;
    for (double out_m = 1.985; out_m < 2.015; out_m += 0.0007) {
      now_us_ += 100'000;
      const std::array<double, 3> place = {mast_m + out_m * std::cos(angle),
                                           mast_m + out_m * std::sin(angle), 3};
      monitors_.mark(place, now_us_);
      alone_.mark(place, now_us_);
      const auto verdict = step()[Monitors::marked_index].verdict;
      SCOPED_TRACE(::testing::Message() << k << " degrees, " << out_m << " m");
      ASSERT_TRUE(out_m <= 2 || verdict != rtac::Verdict::is_true);
      ASSERT_TRUE(out_m >= 2 || verdict != rtac::Verdict::is_false);
      ASSERT_TRUE(out_m > 1.988 || verdict == rtac::Verdict::is_true);
      ASSERT_TRUE(out_m < 2.012 || verdict == rtac::Verdict::is_false);
    }
  }
}

TEST_F(Prisms, WithoutNumbersAreUnknown) {
  for (int axis = 0; axis < 3; ++axis) {
    std::array<double, 3> place = {3, 2, 2.5};
    place[static_cast<std::size_t>(axis)] = std::nan("");
    const auto& found = at(place);
    EXPECT_EQ(found[Monitors::kept_index].verdict, rtac::Verdict::is_unknown) << axis;
    EXPECT_EQ(found[Monitors::off_mast_index].verdict, rtac::Verdict::is_unknown) << axis;
  }
}

}  // namespace
}  // namespace airspace
