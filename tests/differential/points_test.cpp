// Points and bodies against zones: generated code against exact geometry, on edges, vertices,
// around them. Zones with holes and notches, off the grid, sharp, far away and round.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/differential/batch.h"

namespace rtac::differential {
namespace {

struct Case {
  const char* name;
  const char* zone;
  bool on_grid;
  double scale_m;                                 // of random points
  std::vector<std::pair<double, double>> places;  // vertices
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"room",
       "rectangle (0 m, 0 m) to (5 m, 5 m) - rectangle (2 m, 2 m) to (3 m, 3 m)",
       true,
       6,
       {{0, 0}, {5, 0}, {5, 5}, {0, 5}, {2, 2}, {3, 2}, {3, 3}, {2, 3}}},
      {"notch",
       "polygon [(0 m, 0 m), (4 m, 1 m), (3.333 m, 3 m), (2 m, 1.5 m), (0.5 m, 4 m)]",
       true,
       5,
       {{0, 0}, {4, 1}, {3.333, 3}, {2, 1.5}, {0.5, 4}}},
      {"needle",
       "polygon [(0 m, 0 m), (9 m, 0.001 m), (9 m, 0.5 m)]",
       true,
       10,
       {{0, 0}, {9, 0.001}, {9, 0.5}}},
      {"far",
       "polygon [(500000 m, 400000 m), (500003 m, 400001 m), (500001 m, 400004 m)]",
       true,
       530000,
       {{500000, 400000}, {500003, 400001}, {500001, 400004}}},
      {"off_grid",
       "polygon [(0.0004 m, 0 m), (4.0003 m, 1.0007 m), (1 m, 3.0005 m)]",
       false,
       5,
       {{0, 0}, {4, 1.001}, {1, 3}}},
      {"round",
       "circle (1 m, 1 m) radius 2 m - shrink(rectangle (0 m, 0 m) to (2 m, 2 m), 0.5 m)",
       false,
       4,
       {{3, 1}, {1, 3}, {0.5, 0.5}}},
      {"of_a_file",
       "import \"" RTAC_SOURCE_DIR "/compiler/docs/examples/field.geojson\" feature \"field\"",
       false,
       120,
       {{-98.138, -100.06}, {98.138, -100.06}, {98.135, 100.062}, {-98.135, 100.062}}},
      {"of_a_plan",
       "import \"" RTAC_SOURCE_DIR "/compiler/docs/examples/mission.plan\" inclusions all",
       false,
       150,
       {{-98.138, -77.824}, {30.196, -77.825}, {30.196, 100.062}, {-98.135, 100.062}, {27.5, 11}}},
  };
  return all;
}

driver::Observed observed(std::int64_t micro, std::int64_t now_us) {
  const std::string text = to_decimal(Rational(static_cast<long>(micro), 1000000));
  return {{interp::Reading::Kind::number, *interp::Decimal::parse(text)}, now_us, true};
}

// A robot that is near enough to be known, and what is said of it by its name.
std::string robot(const Case& c) {
  constexpr double far_m = 100000;
  if (c.scale_m > far_m) return "";
  return "robot Bot { body radius 10.05 cm; motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake "
         ">= 1 m/s^2; } sense position : point error 1 cm max_age 1 s; output push : acceleration; "
         "latency 20 ms; }\n"
         "fleet bots : Bot[2];\n"
         "monitor f { \"R6: in\" always bots[1] inside z; }\n"
         "monitor g { \"R7: clear\" always not clearance(bots[1], z) < 10 cm; }\n"
         "monitor h { \"R8: near\" always distance(bots[1], z) <= 50 cm; }\n";
}

class PointsAndZones : public ::testing::TestWithParam<std::size_t> {
 protected:
  // Around vertices, on edges, anywhere; in millionths of a metre.
  std::int64_t near(double metres) {
    const std::int64_t offsets[] = {0, 1, 400, 500, 1000, 3000, 20000};
    const auto at = static_cast<std::int64_t>(metres * 1e6 + (metres < 0 ? -0.5 : 0.5));
    const std::int64_t offset = offsets[random_() % 7];
    return random_() % 2 == 0 ? at + offset : at - offset;
  }
  std::pair<std::int64_t, std::int64_t> place(const Case& c) {
    const auto& one = c.places[random_() % c.places.size()];
    const auto& other = c.places[random_() % c.places.size()];
    if (random_() % 3 == 0) {
      std::uniform_real_distribution<double> any(-c.scale_m, c.scale_m);
      return {near(any(random_)), near(any(random_))};
    }
    const double t = static_cast<double>(random_() % 5) / 4;
    return {near(one.first + t * (other.first - one.first)),
            near(one.second + t * (other.second - one.second))};
  }
  std::mt19937 random_{7};
};

// Verdicts refine the exact ones, are the same when they are computed alone, and are as exact where
// both lie on the grid; margins are below the exact ones by 3 mm at most on the grid, by 15 mm
// elsewhere.
TEST_P(PointsAndZones, AreJudgedConservativelyAndTightly) {
  const Case& c = cases()[GetParam()];
  const std::string text =
      std::string("spec s;\nperiod 1 s;\norigin 47.3977 deg, 8.5456 deg;\nzone z = ") + c.zone +
      ";\ninput p : point;\ninput q : point error 2 cm;\n"
      "monitor a { \"R1: in\" always p inside z; }\n"
      "monitor b { \"R2: out\" always not p inside z; }\n"
      "monitor c { \"R3: clear\" always clearance(p, z) >= 10 cm; }\n"
      "monitor d { \"R4: near\" always distance(q, z) <= 50 cm; }\n"
      "monitor e { \"R5: in\" always q inside z; }\n" +
      robot(c);
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
    const auto [x, y] = place(c);
    const std::int64_t now_us = tick * 1000000;
    std::vector<driver::Observed> inputs;  // of p, q and the robot
    for (std::size_t k = 0; k < checked->compilation.spec->inputs.size(); ++k) {
      inputs.push_back(observed(x, now_us));
      inputs.push_back(observed(y, now_us));
    }
    reference->step(now_us, inputs, exact);
    kernel.engine->step(now_us, inputs, found);
    alone.engine->step(now_us, inputs, verdicts);
    const bool on_grid = c.on_grid && x % 1000 == 0 && y % 1000 == 0;
    for (std::size_t k = 0; k < exact.size(); ++k) {
      SCOPED_TRACE(std::string(c.name) + " monitor " + std::to_string(k) + " at " +
                   std::to_string(x) + " " + std::to_string(y) + " um: exact " + exact[k].margin +
                   ", found " + found[k].margin);
      ASSERT_EQ(verdicts[k].verdict, found[k].verdict);
      const bool is_unknown = found[k].verdict == interp::Verdict::unknown;
      ASSERT_TRUE(is_unknown || found[k].verdict == exact[k].verdict);
      if (on_grid && k < 2) {
        ASSERT_EQ(found[k].verdict, exact[k].verdict);
      }
      const double below = std::stod(exact[k].margin) - std::stod(found[k].margin);
      const double most_m = on_grid && k < 3 ? 0.003 : 0.015;
      ASSERT_LE(below, most_m + std::abs(std::stod(exact[k].margin)) * 1e-5);
      ASSERT_GT(below, -1e-5 * (1 + std::abs(std::stod(exact[k].margin))));
      decided += is_unknown ? 0 : 1;
      inside += k == 0 && exact[k].verdict == interp::Verdict::yes ? 1 : 0;
    }
  }
  EXPECT_GT(decided, 5000U);
  EXPECT_GT(inside, 100U);
}
// A place of which only a box is known: no end of its clearance is tighter than the exact one, even
// where the box reaches farther out, or deeper inside, than the ranges of the inputs let it.
TEST(PlacesInBoxes, HaveMarginsThatContainTheExactOnes) {
  const std::vector<std::string> formulas = {
      "(if a then q else p) inside bend", "(if a then q else s.xy) inside yard",
      "clearance((if a then q else s.xy), yard) >= 0 m",
      "distance((if a then q else s.xy), pond) >= 1 m",
      "mean[0 s, 2 s](clearance((if a then q else p), bend)) >= 0 m"};
  std::vector<std::string> lines;
  for (const std::string& formula : formulas) {
    lines.push_back("monitor m" + std::to_string(lines.size()) + " { \"R1: a box\" always " +
                    formula + "; }\n");
  }
  const Batch batch(3, 0, 400, lines);
  ASSERT_EQ(batch.problem() + batch.refused(), "");
  const driver::LoadedKernel kernel = load(batch.code(), {}, Speed::of_building);
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  const Batch::Result result = batch.compare(*kernel.engine);
  EXPECT_EQ(result.different, 0u) << result.first;
}

INSTANTIATE_TEST_SUITE_P(Zones, PointsAndZones, ::testing::Range<std::size_t>(0, cases().size()),
                         [](const auto& zone) { return std::string(cases()[zone.param].name); });

}  // namespace
}  // namespace rtac::differential
