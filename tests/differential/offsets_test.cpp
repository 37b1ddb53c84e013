// Zones that are grown and shrunk by kilometres, at their round corners, against distances that are
// computed here: what either engine finds is true there, and nothing is left open farther than what
// offsets give away.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/differential/engines.h"

namespace rtac::differential {
namespace {

struct Offset {
  const char* name;
  const char* zone;
  long distance_m;  // of its boundary from the square
  bool grows;       // it is inside of that boundary
  bool in_space;
};

// The square is `base`, 10 m wide about the origin; a place on the outer side of its first corner
// is as far from it as from the corner.
const std::vector<Offset>& cases() {
  static const std::vector<Offset> all = {
      {"grown", "grow(base, 9260 m)", 9'260, true, false},
      {"shrunk", "shrink(yard - base, 12 km)", 12'000, false, false},
      {"grown_twice", "grow(grow(base, 10 km), 1 km)", 11'000, true, false},
      {"grown_and_shrunk", "shrink(grow(base, 13 km), 2 km)", 11'000, true, false},
      {"shrunk_and_grown", "grow(shrink(yard - base, 10 km), 20 m)", 9'980, false, false},
      {"prism", "grow(rock, 10 km)", 10'000, true, true},
      {"prism_shrunk", "shrink(sky - rock, 10 km)", 10'000, false, true},
  };
  return all;
}

std::string spec_of(const Offset& c) {
  return "spec s;\nperiod 1 s;\n"
         "zone base = rectangle (-5 m, -5 m) to (5 m, 5 m);\n"
         "zone yard = rectangle (-90 km, -90 km) to (90 km, 90 km);\n"
         "zone rock = prism (base) from -15 km to 15 km;\n"
         "zone sky = prism (yard) from -12 km to 12 km;\n"
         "zone z = " +
         std::string(c.zone) + ";\ninput p : " + (c.in_space ? "point3" : "point") +
         ";\n"
         "monitor a { \"R1: in\" always p inside z; }\n"
         "monitor b { \"R2: out\" always not p inside z; }\n";
}

driver::Observed observed(const Rational& metres, std::int64_t now_us) {
  return {
      {interp::Reading::Kind::number, *interp::Decimal::parse(to_decimal(metres))}, now_us, true};
}

// To a micrometre.
Rational near(double metres) {
  Rational value(static_cast<long>(std::llround(metres * 1e6)), 1'000'000UL);
  value.canonicalize();
  return value;
}

void expect_true_and_tight(driver::Engine& engine, const Offset& c, double open_m) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angles(0.0001, 1.5707);
  std::vector<driver::Judgement> found;
  for (std::int64_t tick = 0; tick < 1500; ++tick) {
    const double offsets_m[] = {0, 2e-6, 1e-4, 9e-4, 1.1e-3, 2e-3, 4e-3, 6e-3, 1};
    const double by = offsets_m[random() % 9] * (random() % 2 == 0 ? 1 : -1);
    // corners stick out most where directions are far apart, near the axes
    const double angle = random() % 2 == 0 ? angles(random) : angles(random) / 100;
    const double reach = static_cast<double>(c.distance_m) + by;
    const Rational x = near(reach * std::cos(angle)), y = near(reach * std::sin(angle));
    const Rational limit = c.distance_m, square = x * x + y * y;
    const bool inside = c.grows ? square <= limit * limit : square >= limit * limit;
    const std::int64_t now_us = tick * 1'000'000;
    std::vector<driver::Observed> at = {observed(x + 5, now_us), observed(y + 5, now_us)};
    if (c.in_space) at.push_back(observed(0, now_us));
    engine.step(now_us, at, found);
    SCOPED_TRACE(std::string(c.name) + " " + std::to_string(by) + " m beyond, at " +
                 to_decimal(Rational(x + 5)) + ", " + to_decimal(Rational(y + 5)));
    using interp::Verdict;
    ASSERT_NE(found[0].verdict, inside ? Verdict::no : Verdict::yes);
    ASSERT_NE(found[1].verdict, inside ? Verdict::yes : Verdict::no);
    if (std::abs(by) < open_m) continue;
    ASSERT_EQ(found[0].verdict, inside ? Verdict::yes : Verdict::no);
    ASSERT_EQ(found[1].verdict, inside ? Verdict::no : Verdict::yes);
  }
}

class FarOffsets : public ::testing::TestWithParam<std::size_t> {};

// On exact numbers 1 mm is open; to the grid, where a point is not on it, it takes 2 mm more.
TEST_P(FarOffsets, AreTrueAtRoundCornersAndTight) {
  const Offset& c = cases()[GetParam()];
  const auto checked = check(spec_of(c), Until::kernel);
  ASSERT_EQ(checked->problem, "");
  const auto reference = driver::make_interpreter(*checked->compilation.spec);
  expect_true_and_tight(*reference, c, 0.00101);
  const driver::KernelCode code = driver::kernel_code(checked->compilation);
  const driver::LoadedKernel kernel = load(code, {}, Speed::of_building);
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  expect_true_and_tight(*kernel.engine, c, 0.004);
}

INSTANTIATE_TEST_SUITE_P(Zones, FarOffsets, ::testing::Range<std::size_t>(0, cases().size()),
                         [](const auto& zone) { return std::string(cases()[zone.param].name); });

}  // namespace
}  // namespace rtac::differential
