// Points of space against zones with height: generated code against exact geometry, on walls,
// floors, ceilings, edges and corners, around them. Stacks with steps and gaps, off the grid, far
// away, round.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tests/differential/batch.h"

namespace rtac::differential {
namespace {

using Spot = std::array<double, 3>;
struct Case {
  const char* name;
  const char* zone;
  bool on_grid;
  double scale_m;            // of random points
  std::vector<Spot> places;  // corners
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"box",
       "rectangle (0 m, 0 m, -1 m) to (5 m, 4 m, 2 m)",
       true,
       6,
       {{0, 0, -1}, {5, 0, -1}, {5, 4, 2}, {0, 4, 2}, {5, 4, -1}, {0, 0, 2}}},
      {"steps",
       "rectangle (0 m, 0 m, 0 m) to (6 m, 6 m, 2 m) | rectangle (1 m, 1 m, 2 m) to (4 m, 5 m, "
       "3.5 m) | rectangle (2 m, 0 m, 3.5 m) to (3 m, 6 m, 4 m)",
       true,
       8,
       {{0, 0, 0},
        {6, 6, 2},
        {1, 1, 2},
        {4, 5, 3.5},
        {2, 0, 3.5},
        {3, 6, 4},
        {2, 1, 3.5},
        {3, 3, 2}}},
      {"gap",
       "prism (rectangle (0 m, 0 m) to (5 m, 5 m) - rectangle (2 m, 2 m) to (3 m, 3 m)) from 0 m "
       "to "
       "2 m | prism (polygon [(0 m, 0 m), (4 m, 1 m), (2 m, 4 m)]) from 2.5 m to 4 m",
       true,
       7,
       {{0, 0, 0}, {5, 5, 2}, {2, 2, 2}, {3, 3, 0}, {0, 0, 2.5}, {4, 1, 4}, {2, 4, 2.5}}},
      {"cave",
       "rectangle (0 m, 0 m, 0 m) to (6 m, 6 m, 6 m) - rectangle (2 m, 2 m, 2 m) to (4 m, 4 m, 4 "
       "m)",
       true,
       8,
       {{0, 0, 0}, {6, 6, 6}, {2, 2, 2}, {4, 4, 4}, {2, 4, 2}, {4, 2, 4}}},
      {"far",
       "prism (polygon [(500000 m, 400000 m), (500003 m, 400001 m), (500001 m, 400004 m)]) from "
       "300000 m to 300002 m",
       true,
       530000,
       {{500000, 400000, 300000}, {500003, 400001, 300002}, {500001, 400004, 300000}}},
      {"off_grid",
       "prism (polygon [(0.0004 m, 0 m), (4.0003 m, 1.0007 m), (1 m, 3.0005 m)]) from 0.0003 m to "
       "1.0006 m | prism (polygon [(0 m, 0 m), (3 m, 0 m), (1 m, 3 m)]) from 1.0006 m to 2.0005 m",
       false,
       5,
       {{0, 0, 0}, {4, 1.001, 1.001}, {1, 3, 1}, {3, 0, 2}, {1, 3, 2.001}}},
      {"round",
       "prism (circle (1 m, 1 m) radius 2 m) from 0 m to 3 m - shrink(rectangle (0 m, 0 m, 0 m) to "
       "(2 m, 2 m, 3 m), 0.5 m)",
       false,
       4,
       {{3, 1, 0}, {1, 3, 3}, {0.5, 0.5, 0.5}, {1.5, 1.5, 2.5}, {-1, 1, 3}}},
      {"grown",
       "grow(rectangle (0 m, 0 m, 0 m) to (2 m, 2 m, 1 m), 0.5 m)",
       false,
       4,
       {{-0.5, 0, -0.5}, {2.5, 2, 1.5}, {2, 2.5, 1.5}, {2, 2, 1}}},
  };
  return all;
}

driver::Observed observed(std::int64_t micro, std::int64_t now_us) {
  const std::string text = to_decimal(Rational(static_cast<long>(micro), 1000000));
  return {{interp::Reading::Kind::number, *interp::Decimal::parse(text)}, now_us, true};
}

class PointsInSpace : public ::testing::TestWithParam<std::size_t> {
 protected:
  // At corners, on edges and faces, anywhere; in millionths of a metre.
  std::int64_t near(double metres) {
    const std::int64_t offsets[] = {0, 0, 1, 400, 500, 1000, 3000, 20000};
    const auto at = static_cast<std::int64_t>(metres * 1e6 + (metres < 0 ? -0.5 : 0.5));
    const std::int64_t offset = offsets[random_() % 8];
    return random_() % 2 == 0 ? at + offset : at - offset;
  }
  std::array<std::int64_t, 3> place(const Case& c) {
    const Spot& one = c.places[random_() % c.places.size()];
    const Spot& other = c.places[random_() % c.places.size()];
    std::array<std::int64_t, 3> at{};
    std::uniform_real_distribution<double> any(-c.scale_m, c.scale_m);
    const bool anywhere = random_() % 3 == 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double t = static_cast<double>(random_() % 5) / 4;
      at[axis] = near(anywhere ? any(random_) : one[axis] + t * (other[axis] - one[axis]));
    }
    return at;
  }
  std::mt19937 random_{7};
};

// Verdicts refine the exact ones, are the same when they are computed alone, and are as exact where
// both lie on the grid; margins are below the exact ones by 4 mm at most on the grid, by 20 mm
// elsewhere.
TEST_P(PointsInSpace, AreJudgedConservativelyAndTightly) {
  const Case& c = cases()[GetParam()];
  const std::string text = std::string("spec s;\nperiod 1 s;\nzone z = ") + c.zone +
                           ";\ninput p : point3;\ninput q : point3 error 2 cm;\n"
                           "monitor a { \"R1: in\" always p inside z; }\n"
                           "monitor b { \"R2: out\" always not p inside z; }\n"
                           "monitor c { \"R3: clear\" always clearance(p, z) >= 10 cm; }\n"
                           "monitor d { \"R4: near\" always distance(q, z) <= 50 cm; }\n"
                           "monitor e { \"R5: in\" always q inside z; }\n";
  const auto checked = check(text, Until::kernel);
  ASSERT_EQ(checked->problem, "");
  const auto reference = driver::make_interpreter(*checked->compilation.spec);
  const driver::KernelCode code = driver::kernel_code(checked->compilation);
  const driver::LoadedKernel kernel = load(code);
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  const driver::LoadedKernel alone = load_verdicts(code);
  ASSERT_NE(alone.engine, nullptr) << alone.problem;
  std::vector<driver::Judgement> exact, found, verdicts;
  std::size_t decided = 0, inside = 0;
  for (std::int64_t tick = 0; tick < 3000; ++tick) {
    const auto at = place(c);
    const std::int64_t now_us = tick * 1000000;
    std::vector<driver::Observed> inputs;  // of p and q
    for (std::size_t k = 0; k < 6; ++k) inputs.push_back(observed(at[k % 3], now_us));
    reference->step(now_us, inputs, exact);
    kernel.engine->step(now_us, inputs, found);
    alone.engine->step(now_us, inputs, verdicts);
    const bool on_grid = c.on_grid && at[0] % 1000 == 0 && at[1] % 1000 == 0 && at[2] % 1000 == 0;
    for (std::size_t k = 0; k < exact.size(); ++k) {
      SCOPED_TRACE(std::string(c.name) + " monitor " + std::to_string(k) + " at " +
                   std::to_string(at[0]) + " " + std::to_string(at[1]) + " " +
                   std::to_string(at[2]) + " um: exact " + exact[k].margin + ", found " +
                   found[k].margin);
      ASSERT_EQ(verdicts[k].verdict, found[k].verdict);
      const bool is_unknown = found[k].verdict == interp::Verdict::unknown;
      ASSERT_TRUE(is_unknown || found[k].verdict == exact[k].verdict);
      if (on_grid && k < 2) {
        ASSERT_EQ(found[k].verdict, exact[k].verdict);
      }
      const double below = std::stod(exact[k].margin) - std::stod(found[k].margin);
      const double most_m = on_grid && k < 3 ? 0.004 : 0.020;
      ASSERT_LE(below, most_m + std::abs(std::stod(exact[k].margin)) * 1e-5);
      ASSERT_GT(below, -1e-5 * (1 + std::abs(std::stod(exact[k].margin))));
      decided += is_unknown ? 0 : 1;
      inside += k == 0 && exact[k].verdict == interp::Verdict::yes ? 1 : 0;
    }
  }
  EXPECT_GT(decided, 5000U);
  EXPECT_GT(inside, 100U);
}

INSTANTIATE_TEST_SUITE_P(Zones, PointsInSpace, ::testing::Range<std::size_t>(0, cases().size()),
                         [](const auto& zone) { return std::string(cases()[zone.param].name); });

}  // namespace
}  // namespace rtac::differential
