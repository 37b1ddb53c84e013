// A zone that is received while the monitors run: from polygons in metres to the exact region, by
// the checks and the projection that a zone of a specification goes through. Bounded time and
// memory; never on the real-time path.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/geometry/bake.h"
#include "compiler/geometry/cell_tree.h"
#include "compiler/geometry/import/areas.h"
#include "compiler/geometry/region.h"

namespace rtac::geometry {

// What surely lies in the zone, and what surely contains it: places are exact to 1 um, and where
// that rounds a coordinate both differ by so much.
struct ReceivedRegions {
  Region within, around;
  std::vector<import::Note> notes{};  // what the text says besides: of files alone
};

// Why it is refused. `where`: the ring and, where one is at fault, its vertex, counted from 1.
struct RefusedZone {
  std::string where, message, help;
};

// The union of the polygons, each with its holes, x to the east and y to the north of (0 m, 0 m).
// More than `edges_most` vertices are refused before anything is computed.
std::variant<ReceivedRegions, RefusedZone> receive_zone(
    const std::vector<import::Polygon>& polygons, std::size_t edges_most);

// The same of well-known text in metres: POLYGON, MULTIPOLYGON. Positions with heights are refused.
std::variant<ReceivedRegions, RefusedZone> receive_wkt(const std::string& text,
                                                       std::size_t edges_most);

// What a kernel checks: the edges, the zone on their left, and which of them matter where.
struct OutlineTable {
  std::vector<EdgeRow> edges;
  CellTree tree;
};
struct ZoneTables {
  OutlineTable within;
  std::optional<OutlineTable> around;  // none: the same
};
// Snapped to the grid of 1 mm, to either side, as zones of a specification are.
std::variant<ZoneTables, RefusedZone> make_zone_tables(const ReceivedRegions& regions,
                                                       std::size_t edges_most);

// Distances up to here are exact where the bytes suffice: farther than robots look ahead.
inline constexpr std::int64_t exact_mm_wanted = 50'000;
// Most bytes of both outlines together.
constexpr std::size_t zone_table_bytes_most(std::size_t edges_most) {
  return 2 * cell_tree_bytes_max(edges_most);
}

// Most bytes of such a text: more than 200 for each vertex are no outline.
constexpr std::size_t wkt_bytes_most(std::size_t edges_most) {
  return 200 * edges_most + 4096;
}

}  // namespace rtac::geometry
