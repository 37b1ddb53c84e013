// Points of space against zones with height: generated code against exact geometry, on walls,
// floors, ceilings, edges and corners, around them. Stacks with steps and gaps, off the grid, far
// away, round.
#include <gtest/gtest.h>

#include "tests/differential/places.h"

namespace rtac::differential {
namespace {

const std::vector<ZoneCase>& cases() {
  static const std::vector<ZoneCase> all = {
      {"box",
       "box (0 m, 0 m, -1 m) to (5 m, 4 m, 2 m)",
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

class PointsInSpace : public ::testing::TestWithParam<std::size_t> {};

TEST_P(PointsInSpace, AreJudgedConservativelyAndTightly) {
  const ZoneCase& c = cases()[GetParam()];
  expect_conservative_and_tight(c, spec_of(c), 0.004, 0.020);
}

INSTANTIATE_TEST_SUITE_P(Zones, PointsInSpace, ::testing::Range<std::size_t>(0, cases().size()),
                         [](const auto& zone) { return std::string(cases()[zone.param].name); });

}  // namespace
}  // namespace rtac::differential
