// The constant tables of a module: boundaries of zones, what finds their edges, ways to sites.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rtac::ir {

enum class ZoneIndex : std::uint32_t {};
enum class SiteIndex : std::uint32_t {};
enum class RegionIndex : std::uint32_t {};
enum class SolidIndex : std::uint32_t {};
enum class ScheduleIndex : std::uint32_t {};
enum class AgentIndex : std::uint32_t {};
enum class ReceivedIndex : std::uint32_t {};

struct Edge {  // mm; the zone on its left; unit direction in Q30
  std::int32_t ax, ay, bx, by, ux_q30, uy_q30;
};
inline bool is_along_an_axis(const Edge& e) {
  return e.ax == e.bx || e.ay == e.by;
}
// Which edges matter for a place, so that a check looks at a few of them: a square of 2^32 mm is
// divided by 16 again and again. What the words mean: codegen/kernel/zone_cells.c.
struct EdgeTree {
  std::int32_t x_mm = 0, y_mm = 0;  // south-west corner of the square
  std::int32_t shift = 0;           // log2 of the width of the grid's cells, in mm
  std::int32_t column = 0, row = 0, columns = 0, rows = 0;  // of the grid, in cells
  std::int32_t depth = 0, leaves = 0;                       // most divisions; undivided cells
  std::int32_t edges_most = 0;                              // of a cell
  // longest distance that is exact, of all places and of those inside; none: all are
  std::optional<std::int32_t> exact_mm, exact_inside_mm;
  std::vector<std::uint32_t> words, lists;

  [[nodiscard]] std::size_t bytes() const {
    return (words.size() + lists.size()) * sizeof(std::uint32_t);
  }
};
inline constexpr std::size_t edges_without_tree = 16;  // so few are all checked
struct Cells {
  std::int32_t origin_x_mm = 0, origin_y_mm = 0, cell_mm = 100, columns = 0, rows = 0;
  std::vector<std::int32_t> clearance_mm_lo;
};
struct ZoneTable {
  std::string name;
  std::vector<Edge> edges;
  EdgeTree tree;
  std::vector<std::uint32_t> ring_starts;
  Cells cells;
  std::int32_t widest_mm = 0, widest_x_mm = 0, widest_y_mm = 0;
  // A zone with height that robots are in: slabs from below to above, whose insides are apart, each
  // over a table of its own; it has none of the above but its name and its widest place.
  struct Slab {
    std::int32_t floor_mm = 0, ceiling_mm = 0;  // both belong to it
    ZoneIndex base{};
  };
  std::vector<Slab> slabs{};
  std::int32_t widest_z_mm = 0;
  [[nodiscard]] bool has_height() const { return !slabs.empty(); }
};
inline constexpr std::int32_t no_body = -1;      // no body fits into the cell
inline constexpr std::int32_t no_way = 1 << 30;  // no way from the cell to the site
struct SiteTable {
  std::string name;
  ZoneIndex zone{};  // whose cells index `cost_ppm`
  struct Place {
    std::string robot;
    std::int32_t x_mm = 0, y_mm = 0;
    std::vector<std::int32_t> cost_ppm;  // of a full battery; empty when no property asks
  };
  std::vector<Place> places;  // by fleet index
  // The first robot with the place of this one: they share a table.
  [[nodiscard]] std::size_t table_of(std::size_t robot) const {
    std::size_t first = 0;
    while (places[first].x_mm != places[robot].x_mm || places[first].y_mm != places[robot].y_mm) {
      ++first;
    }
    return first;
  }
  std::int32_t drive_ppm_per_m = 0;  // of the driving alone, rounded down
};

}  // namespace rtac::ir
