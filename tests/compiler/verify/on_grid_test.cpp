// The cells that a robot knows of its zone are found once more to the millimetre.
#include "compiler/recheck/on_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compiler/geometry/bake.h"
#include "compiler/recheck/straight.h"
#include "tests/compiler/geometry/rooms.h"

namespace rtac::recheck {
namespace {

using geometry::Region;
using geometry::Ring;

int compared(const Region& zone, std::int32_t cell_mm) {
  const geometry::CellGrid known = geometry::bake(*geometry::snap_inside(zone), cell_mm).cells;
  const auto found = on_grid(zone, {known.cell_mm, known.origin.x_mm, known.origin.y_mm});
  if (!found) return 0;
  EXPECT_LT(found->cells.less, 0);
  EXPECT_EQ(found->cells.clearance.size(), known.clearance_mm_lo.size());
  int clear = 0;
  for (std::size_t at = 0; at < known.clearance_mm_lo.size(); ++at) {
    const auto mm = std::lround(1000 * found->cells.clearance[at]);
    if (mm <= 0 && known.clearance_mm_lo[at] <= 0) continue;  // at the boundary, or beyond
    EXPECT_EQ(mm, known.clearance_mm_lo[at]) << at;
    ++clear;
  }
  return clear;
}

Region polygon(const Ring& corners) {
  return std::get<Region>(Region::polygon(corners, {}));
}

// Three to four and five to twelve: distances from such edges are whole millimetres often.
TEST(OnGrid, CellsBesideSlantingEdges) {
  EXPECT_GT(compared(polygon({{0, 0}, {8, 0}, {8, 6}}), 100), 1000);
  EXPECT_GT(compared(polygon({{0, 0}, {12, 5}, {7, 17}, {-5, 12}}), 100), 1000);
  EXPECT_GT(compared(polygon({{0, 0}, {30, 0}, {0, 6}}), 100), 1000);
}
TEST(OnGrid, CellsOfAnyOutline) {
  std::mt19937 random(7);
  const auto upto = [&](unsigned mm) -> Rational { return Rational(random() % mm) / 1000; };
  int clear = 0;
  for (int i = 0; i < 12; ++i) {
    const Rational x = 8 + upto(3000), y = 7 + upto(2000);
    const Region room = polygon({{upto(900), upto(900)},
                                 {x, upto(1500)},
                                 {x - upto(2000), y},
                                 {upto(1500), y - upto(800)}});
    const Rational left = 3 + upto(2000), low = 3 + upto(1000);
    const Region pillar =
        polygon({{left, low}, {left + 1, low + upto(700)}, {left + upto(900), low + 1}});
    clear += compared(room.subtract(pillar), 100);
  }
  EXPECT_GT(clear, 10'000);
}
// A search tries every cell that the boundary passes through; few others are taken for one of them.
TEST(OnGrid, CellsOfTheBoundaryAreKnown) {
  std::mt19937 random(19);
  int meets = 0, others = 0;
  for (int i = 0; i < geometry::rooms_count(); ++i) {
    const Region room = geometry::random_room(random);
    const geometry::CellGrid known = geometry::bake(*geometry::snap_inside(room), 100).cells;
    const auto edges = segments_of(room);
    const auto grid = grid_of(edges, {known.cell_mm, known.origin.x_mm, known.origin.y_mm});
    ASSERT_TRUE(grid);
    ASSERT_EQ(grid->clearance.size(), known.clearance_mm_lo.size());
    const Straight straight(edges, *grid, 0.15, false);
    for (std::size_t at = 0; at < known.clearance_mm_lo.size(); ++at) {
      const bool meets_it = known.clearance_mm_lo[at] == 0;
      EXPECT_TRUE(!meets_it || straight.holds_some(at)) << i << ": " << at;
      meets += meets_it ? 1 : 0;
      others += known.clearance_mm_lo[at] < 0 && straight.holds_some(at) ? 1 : 0;
    }
  }
  EXPECT_GT(meets, 1000);
  EXPECT_LT(others, meets / 2);
}

// The robot has the corner up to 1 mm elsewhere, however little it is off.
TEST(OnGrid, ACornerThatIsHardlyOffTheGridIsOffIt) {
  const Rational hardly(1, 2'000'000'000);
  for (const bool off : {false, true}) {
    const Rational right = off ? Rational(8 + hardly) : Rational(8);
    const auto grid =
        grid_of(segments_of(polygon({{0, 0}, {right, 0}, {right, 6}, {0, 6}})), {100, 0, 0});
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->less > 0, off);
  }
}

}  // namespace
}  // namespace rtac::recheck
