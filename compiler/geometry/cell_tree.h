// Which edges of a zone matter for a place: a tree of square cells over the plane, so that a check
// looks at a few edges however many there are. Everything in mm.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "compiler/geometry/bake.h"

namespace rtac::geometry {

// A square of 2^32 mm, divided by 16 again and again where a cell would have too many edges. Cells
// are closed to the south and west, open to the north and east. Places near the zone start at a
// grid of cells, row by row from the south-west, instead of at the whole square.
//
// A word tells of a cell, in its two highest bits, that it is
//   0 far    the boundary is at least as many mm away as the lowest 28 bits say; with bit 28 set,
//     sides  its edges are neighbours as in a run, and its places inside are those on the left of
//     all
//            of them or, with bit 29, of any;
//   1 run    its edges are neighbours, the first one in the lowest 24 bits;
//   2 list   the lowest 24 bits lead to the numbers of its edges in `lists`;
//   3 split  the lowest 30 bits lead to the words of its 16 parts, row by row.
// Its edges: those that can be the nearest one to some place of the closed cell; bits 24 to 27 tell
// how many, less one. Bit 28: the boundary meets the closed cell (of one
// that is wider than those of the grid: 0, since its places outside the grid are outside). Bit 29,
// but of sides: the region contains a place just inside the south-west corner of the cell: nearer
// to its south side than to any vertex off that side, and much nearer still to its west side.
struct CellTree {
  std::int32_t x_mm = 0, y_mm = 0;   // south-west corner of the square
  std::int32_t shift = 0;            // the cells of the grid are 2^shift mm wide, an even power
  std::int32_t column = 0, row = 0;  // of the first one, counted from that corner
  std::int32_t columns = 0, rows = 0;
  std::int32_t depth = 0;   // most splits on the way to a cell
  std::int32_t leaves = 0;  // cells without parts
  std::int32_t edges_most = 0;
  // Distances up to this one are exact; longer ones are bounded from below. nullopt: all are. The
  // same of places inside.
  std::optional<std::int32_t> exact_mm, exact_inside_mm;
  std::vector<std::uint32_t> words;  // the grid, the square, then the parts of cells
  std::vector<std::uint32_t> lists;

  [[nodiscard]] std::size_t bytes() const { return (words.size() + lists.size()) * 4; }
};

inline constexpr std::size_t cell_edges_max = 16;
// Most bytes of edges and tree together.
constexpr std::size_t cell_tree_bytes_max(std::size_t edges) {
  return 64 * edges + 65536;
}

// Why there is no such tree: so many edges lie within so many mm of a place.
struct TooDense {
  GridPoint at;
  std::size_t edges = 0;
  std::int64_t within_mm = 0;
  std::size_t divided = 0;  // cells, until that was known: how the work grows
};

// Edges are numbered as edge_rows does. The zone has at least one ring. Distances up to `wanted_mm`
// are exact if the bytes suffice; with bytes left, cells that the boundary meets have fewer edges,
// and then distances are exact farther away.
std::variant<CellTree, TooDense> grow_cell_tree(const SnappedZone& zone, std::int64_t wanted_mm);

}  // namespace rtac::geometry
