// The outline of a zone as a robot has it, once more.
#pragma once

#include <optional>
#include <vector>

#include "compiler/recheck/grid.h"

namespace rtac::recheck {

// One ring, and no corner lies to the right of an edge.
bool is_convex(const std::vector<geometry::Ring>& rings);

// The outline that the robot has and its cells: on a grid of 1 mm, inside of the exact one, and
// lengths in whole millimetres from below. What legs lose of the clearance, which is no more than
// 2 mm where they lead straight to the end, is a matter of that outline. nullopt: there is none, or
// the cells are not those of a zone of this size.
struct OnGrid {
  std::vector<Segment> edges;
  Grid cells;
  bool convex;
};
std::optional<OnGrid> on_grid(const geometry::Region& zone, const Cells& cells);

}  // namespace rtac::recheck
