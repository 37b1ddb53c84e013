// The tables of a module as the searches of `geometry` take them.
#pragma once

#include <vector>

#include "compiler/geometry/bake.h"
#include "compiler/ir/tables.h"

namespace rtac::analysis {

inline std::vector<geometry::EdgeRow> edges_of(const ir::ZoneTable& zone) {
  std::vector<geometry::EdgeRow> edges;
  for (const ir::Edge& e : zone.edges) edges.push_back({{e.ax, e.ay}, {e.bx, e.by}});
  return edges;
}
// Without upper bounds of clearances.
inline geometry::CellGrid grid_of(const ir::ZoneTable& zone) {
  const ir::Cells& c = zone.cells;
  return {.origin = {c.origin_x_mm, c.origin_y_mm},
          .cell_mm = c.cell_mm,
          .columns = c.columns,
          .rows = c.rows,
          .clearance_mm_lo = c.clearance_mm_lo,
          .clearance_mm_hi = {}};
}

}  // namespace rtac::analysis
