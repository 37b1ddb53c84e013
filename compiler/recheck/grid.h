// The cells that recoveries find their ways over, found once more from exact outlines, in m.
#pragma once

#include <optional>
#include <vector>

#include "compiler/recheck/zones.h"

namespace rtac::recheck {

// Doubles find distances to this; bounds are taken to the safe side.
inline constexpr double slack_m = 1e-6;
// By so much the zone of a robot may be smaller than the exact one: it is on the grid.
inline constexpr double snap_m = 0.003;
// And the clearances of its cells less than exact ones: whole millimetres, rounded down.
inline constexpr double table_m = snap_m + 0.001;

struct Segment {
  double ax, ay, bx, by;
  bool on_grid = false;  // both ends are exactly in whole millimetres
};
std::vector<Segment> segments_of(const geometry::Region& region);
double square_to(const Segment& s, double x, double y);

struct Box {
  double x, y, right, top;
};
struct Grid {
  double x = 0, y = 0, cell = 0;
  std::size_t columns = 0, rows = 0;
  std::vector<double> clearance;  // of every place of the cell, at least; negative: none
  // By so much those that robots know may be less: of a zone with corners in whole millimetres they
  // are these very ones, but for what two doubles of one length differ by.
  double less = table_m;
  [[nodiscard]] Box box(std::size_t column, std::size_t row, std::size_t side) const {
    const double left = x + double(column) * cell, low = y + double(row) * cell;
    return {left, low, left + double(side) * cell, low + double(side) * cell};
  }
};
// nullopt: the cells are not those of a zone of this size.
std::optional<Grid> grid_of(const std::vector<Segment>& all, const Cells& cells);

}  // namespace rtac::recheck
