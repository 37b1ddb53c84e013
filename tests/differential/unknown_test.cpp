// How near a boundary a place or a leg must be to be unknown: outlines on the grid and off it, with
// blunt corners and with one of 28 degrees, as they are, grown and shrunk.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "tests/differential/places.h"

namespace rtac::differential {
namespace {

struct Outline {
  const char* name;
  std::vector<std::array<double, 2>> corners;  // counter-clockwise, in metres
};
const std::vector<Outline>& outlines() {
  static const std::vector<Outline> all = {
      {"surveyed", {{0, 0}, {9, 1.5}, {8.333, 7}, {4, 3.5}, {0.5, 9}}},
      {"projected",
       {{0.00037, 0.00012},
        {9.00081, 1.50047},
        {8.33329, 7.00074},
        {4.00053, 3.50091},
        {0.50068, 9.00039}}},
      {"sharp", {{0.00041, 0.00037}, {9.00015, 2.50051}, {0.00032, 5.00008}, {4.00073, 2.50022}}}};
  return all;
}

// Of a place p, or of the leg from p to q: true where it is at least so far inside.
struct Question {
  const char* property;
  double level_m;
  bool is_of_leg;
};
constexpr std::array questions{
    Question{"p inside z", 0, false},
    Question{"not p inside z", 0, false},
    Question{"clearance(p, z) >= 0 m", 0, false},
    Question{"not clearance(p, z) < 0 m", 0, false},
    Question{"0 m > clearance(p, z)", 0, false},
    Question{"0 m <= clearance(p, z)", 0, false},
    Question{"clearance(p, z) > 0 m", 0, false},
    Question{"clearance(p, z) <= 0 m", 0, false},
    Question{"p inside grow(z, 3 m)", -3, false},
    Question{"p inside shrink(z, 1 m)", 1, false},
    Question{"leg(p, q) inside z", 0, true},
    Question{"clearance(leg(p, q), z) >= 0 m", 0, true},
};

std::string spec_of(const Outline& outline) {
  std::string corners;
  for (const auto& [x, y] : outline.corners) {
    corners +=
        (corners.empty() ? "(" : ", (") + std::to_string(x) + " m, " + std::to_string(y) + " m)";
  }
  std::string text = "spec s;\nperiod 1 s;\nzone z = polygon [" + corners +
                     "];\ninput p : point;\ninput q : point;\n";
  for (std::size_t k = 0; k < questions.size(); ++k) {
    text +=
        "monitor m" + std::to_string(k) + " { \"R3: it\" always " + questions[k].property + "; }\n";
  }
  return text;
}

using Place = std::array<double, 2>;  // m

double distance_m(const Place& p, const Place& a, const Place& b) {
  const Place d{b[0] - a[0], b[1] - a[1]}, v{p[0] - a[0], p[1] - a[1]};
  const double t = std::clamp((v[0] * d[0] + v[1] * d[1]) / (d[0] * d[0] + d[1] * d[1]), 0.0, 1.0);
  return std::hypot(v[0] - t * d[0], v[1] - t * d[1]);
}
// Negative outside.
double clearance_m(const std::vector<Place>& corners, const Place& p) {
  double least = 1e9;
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Place &a = corners[i], &b = corners[(i + 1) % corners.size()];
    least = std::min(least, distance_m(p, a, b));
    const double across = (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0];
    if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < across) inside = !inside;
  }
  return inside ? least : -least;
}
// Of all its places, to 10 um where it is the least one of only a part of the leg.
double clearance_m(const std::vector<Place>& corners, const Place& p, const Place& q) {
  const auto at = [&](double t) {
    return clearance_m(corners, {p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
  };
  constexpr int parts = 1000;
  double least = at(0), where = 0;
  const auto look = [&](double from, double to) {
    for (int k = 0; k <= parts; ++k) {
      const double t = std::clamp(from + (to - from) * k / parts, 0.0, 1.0), found = at(t);
      if (found < least) least = found, where = t;
    }
  };
  look(0, 1);
  look(where - 1.0 / parts, where + 1.0 / parts);
  return least;
}

// Within 1 cm of the boundary, or of what is so much farther out or in.
class Around {
 public:
  explicit Around(const std::vector<Place>& corners) : corners_(corners) {}
  std::array<std::int64_t, 4> next(bool on_grid) {
    const double level_m = questions[random_() % questions.size()].level_m;
    const auto side = random_() % corners_.size();
    const Place& a = corners_[side];
    const Place& b = corners_[(side + 1) % corners_.size()];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const auto place = [&](double along, double off_m) {
      return Place{a[0] + along * (b[0] - a[0]) - off_m * (b[1] - a[1]) / length,
                   a[1] + along * (b[1] - a[1]) + off_m * (b[0] - a[0]) / length};
    };
    Place p = place(unit_(random_), level_m + 0.02 * unit_(random_) - 0.01);
    if (random_() % 2 == 0) p = at_corner(a, level_m);
    const Place q = place(unit_(random_), level_m + 0.02 * unit_(random_) - 0.01);
    const std::int64_t step = on_grid ? 1000 : 1;
    const auto micro = [&](double metres) {
      return std::int64_t{std::llround(metres * 1e6 / double(step))} * step;
    };
    return {micro(p[0]), micro(p[1]), micro(q[0]), micro(q[1])};
  }

 private:
  // Where offsets are round, and outlines are farthest off the grid.
  Place at_corner(const Place& corner, double level_m) {
    const double angle = 6.2831853 * unit_(random_);
    const double reach = std::abs(level_m) + 0.02 * unit_(random_) - 0.01;
    return {corner[0] + reach * std::cos(angle), corner[1] + reach * std::sin(angle)};
  }

  const std::vector<Place>& corners_;
  std::mt19937 random_{11};
  std::uniform_real_distribution<double> unit_{0, 1};
};

class Unknown : public ::testing::TestWithParam<std::size_t> {};

// How far, at most, in mm: of places on the grid 1.8 for an outline off it, and 1 for an offset;
// of other places 1.4 more for their own cell; of clearances that are not those of `inside` 3 for
// their bounds, and 2 more for the cell; of legs, whose ends are taken to the grid, likewise.
double most_m(const Question& question, bool on_grid) {
  const std::string text = question.property;
  const bool is_gap = text.ends_with("> 0 m") || text.ends_with("<= 0 m");
  if (question.is_of_leg || is_gap) return on_grid ? 0.0048 : 0.008;
  return on_grid ? 0.0028 : 0.0042;
}

TEST_P(Unknown, IsWithinAFewUnitsOfTheGrid) {
  const Outline& outline = outlines()[GetParam()];
  const auto checked = check(spec_of(outline), Until::kernel);
  ASSERT_EQ(checked->problem, "");
  const auto reference = driver::make_interpreter(*checked->compilation.spec);
  const driver::KernelCode code = driver::kernel_code(checked->compilation);
  const driver::LoadedKernel kernel = load(code);
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  const driver::LoadedKernel alone = load_verdicts(code);
  ASSERT_NE(alone.engine, nullptr) << alone.problem;
  std::vector<driver::Judgement> exact, found, verdicts;
  Around around(outline.corners);
  std::size_t decided = 0, unknown = 0;
  for (std::int64_t tick = 0; tick < 4000; ++tick) {
    const bool on_grid = tick % 2 == 0;
    const std::int64_t now_us = tick * 1'000'000;
    std::vector<driver::Observed> inputs;
    const std::array<std::int64_t, 4> at = around.next(on_grid);
    for (const std::int64_t micro : at) inputs.push_back(observed(micro, now_us));
    reference->step(now_us, inputs, exact);
    kernel.engine->step(now_us, inputs, found);
    alone.engine->step(now_us, inputs, verdicts);
    const Place p{double(at[0]) * 1e-6, double(at[1]) * 1e-6};
    const Place q{double(at[2]) * 1e-6, double(at[3]) * 1e-6};
    for (std::size_t k = 0; k < questions.size(); ++k) {
      const bool is_unknown = found[k].verdict == interp::Verdict::unknown;
      ++(is_unknown ? unknown : decided);
      ASSERT_EQ(verdicts[k].verdict, found[k].verdict) << questions[k].property;
      ASSERT_TRUE(is_unknown || found[k].verdict == exact[k].verdict) << questions[k].property;
      if (!is_unknown) continue;
      const bool of_leg = questions[k].is_of_leg;
      const double gap_m =
          of_leg ? clearance_m(outline.corners, p, q) : clearance_m(outline.corners, p);
      EXPECT_LE(std::abs(gap_m - questions[k].level_m), most_m(questions[k], on_grid))
          << questions[k].property << ": " << p[0] << " " << p[1] << " to " << q[0] << " " << q[1];
    }
  }
  EXPECT_GT(decided, 5 * unknown);
}

INSTANTIATE_TEST_SUITE_P(Outlines, Unknown, ::testing::Range<std::size_t>(0, outlines().size()),
                         [](const auto& outline) {
                           return std::string(outlines()[outline.param].name);
                         });

// A tip off the grid is cut where the grid has room in it: rule 7.2 says how far that is known.
class Tip : public ::testing::TestWithParam<int> {};

TEST_P(Tip, IsKnownAsFarAsItIsWide) {
  const double half_rad = GetParam() * 3.14159265 / 360;
  constexpr double tip_m = 0.0003, length_m = 8, level_m = 0.8;
  const double wide_m = length_m * std::tan(half_rad);
  const std::vector<Place> corners = {
      {tip_m, tip_m}, {tip_m + length_m, tip_m - wide_m}, {tip_m + length_m, tip_m + wide_m}};
  std::string text = "spec s;\nperiod 1 s;\nzone z = polygon [";
  for (const auto& [x, y] : corners) {
    text +=
        (text.back() == '[' ? "(" : ", (") + std::to_string(x) + " m, " + std::to_string(y) + " m)";
  }
  text +=
      "];\ninput p : point;\nmonitor near { \"R1: near\" always distance(p, z) <= 0.8 m; }\n"
      "monitor far { \"R2: far\" always distance(p, z) >= 0.8 m; }\n";
  const auto checked = check(text, Until::kernel);
  ASSERT_EQ(checked->problem, "");
  const driver::LoadedKernel kernel = load(driver::kernel_code(checked->compilation));
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  const double most_off_m = 0.00075 / std::sin(half_rad) + 0.003;
  std::vector<driver::Judgement> found;
  std::size_t unknown = 0;
  for (std::int64_t tick = 0; tick < 1600; ++tick) {
    const std::int64_t now_us = tick * 1'000'000, x_mm = -1600 + tick;
    kernel.engine->step(now_us, {observed(x_mm * 1000, now_us), observed(0, now_us)}, found);
    const double off_m = -clearance_m(corners, {double(x_mm) * 1e-3, 0}) - level_m;
    for (std::size_t k = 0; k < found.size(); ++k) {
      const bool holds = k == 0 ? off_m <= 0 : off_m >= 0;
      if (found[k].verdict == interp::Verdict::unknown) {
        ++unknown;
        EXPECT_LE(std::abs(off_m), most_off_m) << x_mm;
      } else {
        EXPECT_EQ(found[k].verdict == interp::Verdict::yes, holds) << x_mm;
      }
    }
  }
  EXPECT_GT(unknown, 0U);
}

INSTANTIATE_TEST_SUITE_P(Degrees, Tip, ::testing::Values(11, 3, 1));

}  // namespace
}  // namespace rtac::differential
