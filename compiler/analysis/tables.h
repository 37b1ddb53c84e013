// The tables of a module as the searches of `geometry` take them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "compiler/geometry/bake.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

inline std::vector<geometry::EdgeRow> edges_of(const ir::ZoneTable& zone) {
  std::vector<geometry::EdgeRow> edges;
  for (const ir::Edge& e : zone.edges) edges.push_back({{e.ax, e.ay}, {e.bx, e.by}});
  return edges;
}
// Without upper bounds of clearances.
inline geometry::CellGrid grid_of(const ir::Cells& c) {
  return {.origin = {c.origin_x_mm, c.origin_y_mm},
          .cell_mm = c.cell_mm,
          .columns = c.columns,
          .rows = c.rows,
          .clearance_mm_lo = c.clearance_mm_lo,
          .clearance_mm_hi = {}};
}
inline geometry::CellGrid grid_of(const ir::ZoneTable& zone) {
  return grid_of(zone.cells);
}

// How large the box around a zone is, in mm; of a zone of the plane without a height.
struct Extent {
  std::int64_t x = 0, y = 0, z = 0;
};
inline Extent extent_of(const ir::Module& module, const ir::ZoneTable& zone) {
  std::int64_t low_x = INT64_MAX, high_x = INT64_MIN, low_y = INT64_MAX, high_y = INT64_MIN;
  const auto hold = [&](const ir::ZoneTable& table) {
    for (const ir::Edge& e : table.edges) {
      low_x = std::min<std::int64_t>(low_x, e.ax);
      high_x = std::max<std::int64_t>(high_x, e.ax);
      low_y = std::min<std::int64_t>(low_y, e.ay);
      high_y = std::max<std::int64_t>(high_y, e.ay);
    }
  };
  if (!zone.has_height()) {
    hold(zone);
    return {high_x - low_x, high_y - low_y, 0};
  }
  for (const auto& slab : zone.slabs) hold(module[slab.base]);
  return {high_x - low_x, high_y - low_y,
          std::int64_t{zone.slabs.back().ceiling_mm} - zone.slabs.front().floor_mm};
}

}  // namespace rtac::analysis
