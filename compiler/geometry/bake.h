// From an exact region to the integer tables that a kernel checks.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/geometry/region.h"

namespace rtac::geometry {

struct GridPoint {
  std::int32_t x_mm = 0, y_mm = 0;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

// A region whose vertices lie on the 1 mm grid. All rings in one list: outer rings
// counter-clockwise, holes clockwise, so that the region is on the left of every edge.
struct SnappedZone {
  std::vector<std::vector<GridPoint>> rings;
};

// Whether all vertices of a region do.
bool is_on_grid(const Region& region);
// The largest snapped region found that is a subset of `region` (keep-in, the safe side),
// re-verified exactly; a region already on the grid comes back unchanged. nullopt: nothing is left
// or a coordinate exceeds +-2^29 mm.
std::optional<SnappedZone> snap_inside(const Region& region);
// A snapped region of which `region` is a subset, as close as snap_inside comes from within;
// verified exactly, and the same where the region lies on the grid. nullopt: `region` is empty, or
// a coordinate comes within 1 m of +-2^29 mm.
std::optional<SnappedZone> snap_around(const Region& region);
Region to_region(const SnappedZone& zone);

// One directed edge; the region is on its left.
struct EdgeRow {
  GridPoint a, b;
  // Unit direction of the edge and inward unit normal in Q30, rounded to nearest: each component
  // is off by at most 2^-31.
  std::int32_t ux_q30 = 0, uy_q30 = 0, nx_q30 = 0, ny_q30 = 0;
  std::int32_t length_mm_up = 0;  // ceiling
};

// The edges of all rings, in order.
std::vector<EdgeRow> edge_rows(const SnappedZone& zone);

// Square cells over the bounding box, row by row from the south-west. Values are one-sided over
// the whole closed cell. A cell of which only border points can belong to the region, as boundary,
// has 0 for both bounds.
struct CellGrid {
  GridPoint origin;  // south-west corner
  std::int32_t cell_mm = 100;
  std::int32_t columns = 0, rows = 0;
  // Lower bound of the distance to the boundary for every point of the cell, in fact the smallest
  // such distance rounded down; 0 for a cell that meets the boundary, negative (-1) for one that
  // lies outside.
  std::vector<std::int32_t> clearance_mm_lo;
  // Upper bound, for deciding that no body can be there; -1 outside.
  std::vector<std::int32_t> clearance_mm_hi;
};

struct BakedZone {
  std::vector<EdgeRow> edges;
  CellGrid cells;
  // Place of largest clearance (pole of inaccessibility, within 1 mm; of corridors that are equally
  // wide over hundreds of metres, within a few) and that clearance, rounded down: what `the return
  // set is empty` reports.
  GridPoint widest_at;
  std::int32_t widest_mm = 0;
};
// The cells are as wide as the smallest multiple of `cell_mm` that makes at most 1,000,000 of them.
BakedZone bake(const SnappedZone& zone, std::int32_t cell_mm);

// Length of a path along cell centres, 8-connected (a diagonal step needs both its orthogonal
// neighbours), through cells with clearance_mm_lo >= clearance_mm, from anywhere in the cell to
// `site` (half a cell diagonal added at either end, rounded up). Cells below that clearance whose
// clearance_mm_hi >= body_mm get a connector, the straight way to the centre of an admissible cell
// within `connector_mm`: the value bounds, from every place of the cell with a clearance of
// `body_mm`, the shortest way over those cells that can be reached straight without coming closer
// to the boundary than the place is, or than clearance_mm. It is -1 when there is a place without
// such a cell. -1 as well: no way, or one of more than 2^31 mm. All cells have -1 when `site` is
// outside the grid or in no admissible cell (a site between cells is in all of them). Cells outside
// the region are never admissible, whatever `clearance_mm`.
std::vector<std::int32_t> distances_to(const BakedZone& zone, GridPoint site,
                                       std::int32_t clearance_mm, std::int32_t body_mm,
                                       std::int32_t connector_mm);

}  // namespace rtac::geometry
