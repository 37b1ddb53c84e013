// Points and bodies against zones: generated code against exact geometry, on edges, vertices,
// around them. Zones with holes and notches, off the grid, sharp, far away and round.
#include <gtest/gtest.h>

#include "tests/differential/batch.h"
#include "tests/differential/places.h"

namespace rtac::differential {
namespace {

const std::vector<ZoneCase>& cases() {
  static const std::vector<ZoneCase> all = {
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

// A robot that is near enough to be known, and what is said of it by its name.
std::string robot(const ZoneCase& c) {
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

class PointsAndZones : public ::testing::TestWithParam<std::size_t> {};

TEST_P(PointsAndZones, AreJudgedConservativelyAndTightly) {
  const ZoneCase& c = cases()[GetParam()];
  expect_conservative_and_tight(c, spec_of(c, robot(c)), 0.003, 0.015);
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
