// A zone that was received while the monitors run, as tables that a generated kernel checks. An
// adapter makes them off the real-time path (rtac/geometry/zone_maker.h); a generated class takes
// them between two ticks.
#pragma once

#include <cstddef>
#include <cstdint>

#include "rtac/sample.h"

namespace rtac {

// Of what the numbers below mean: generated code takes tables of this version alone.
inline constexpr std::uint32_t zone_table_version = 1;

// One outline and the cells that tell which of its edges matter for a place.
struct ZoneOutline {
  // Six numbers an edge: ax, ay, bx, by in mm, the zone on the left; its direction in Q30.
  const std::int32_t* edges = nullptr;
  const std::uint32_t* cells = nullptr;
  const std::uint32_t* lists = nullptr;
  std::int32_t edge_count = 0, cell_count = 0, list_count = 0;
  std::int32_t x_mm = 0, y_mm = 0, shift = 0, column = 0, row = 0, columns = 0, rows = 0;
  std::int32_t depth = 0, leaves = 0;
};

// What lies within the zone and what lies around it, on the grid of 1 mm. Nothing here owns the
// arrays: whoever made them keeps them as they are while somebody looks at them.
struct ZoneTable {
  std::uint64_t checksum = 0;  // zone_checksum of all else
  std::uint32_t version = 0;
  ZoneOutline within, around;
};

namespace detail {

// FNV-1a, a number at a time.
class Checksum {
 public:
  void add(std::uint32_t number) { sum_ = (sum_ ^ number) * UINT64_C(0x100000001b3); }
  void add(const ZoneOutline& o) {
    for (const std::int32_t n : {o.edge_count, o.cell_count, o.list_count, o.x_mm, o.y_mm, o.shift,
                                 o.column, o.row, o.columns, o.rows, o.depth, o.leaves}) {
      add(static_cast<std::uint32_t>(n));
    }
    for (std::int32_t i = 0; i < 6 * o.edge_count; ++i) add(static_cast<std::uint32_t>(o.edges[i]));
    for (std::int32_t i = 0; i < o.cell_count; ++i) add(o.cells[i]);
    for (std::int32_t i = 0; i < o.list_count; ++i) add(o.lists[i]);
  }
  [[nodiscard]] std::uint64_t sum() const { return sum_; }

 private:
  std::uint64_t sum_ = UINT64_C(0xcbf29ce484222325);
};

// Of a cell of at most 4 edges, which tells of one or two of them.
inline bool sides_are_sound(std::uint32_t word, std::int32_t edge_count) {
  const std::uint32_t first = word & 0x7fffff, count = (word >> 24 & 3) + 1;
  return first + count <= static_cast<std::uint32_t>(edge_count) &&
         (word >> 26 & 3) + (word >> 23 & 1) < count;
}

// Every index of it leads to something.
inline bool is_sound(const ZoneOutline& o) {
  const auto fits = [](std::uint32_t first, std::uint32_t count, std::int32_t all) {
    return std::uint64_t{first} + count <= static_cast<std::uint64_t>(all);
  };
  for (std::int32_t i = 0; i < o.cell_count; ++i) {
    const std::uint32_t word = o.cells[i], first = word & 0xffffff, count = (word >> 24 & 15) + 1;
    const std::uint32_t kind = word >> 30;
    const bool by_sides = kind == 0 && (word >> 28 & 1) != 0;
    if (by_sides && !sides_are_sound(word, o.edge_count)) return false;
    if (kind == 1 && !fits(first, count, o.edge_count)) return false;
    if (kind == 2 && !fits(first, count, o.list_count)) return false;
    if (kind == 3 && !fits(word & 0x3fffffff, 16, o.cell_count)) return false;
  }
  for (std::int32_t i = 0; i < o.list_count; ++i) {
    if (o.lists[i] >= static_cast<std::uint32_t>(o.edge_count)) return false;
  }
  const std::int64_t grid = std::int64_t{o.columns} * o.rows;
  const bool has_cells = o.columns > 0 && o.rows > 0 && grid < o.cell_count;
  return has_cells && o.shift >= 2 && o.shift <= 32 && o.shift % 2 == 0 && o.depth >= 0 &&
         o.depth <= o.shift / 2;
}

// 64 bytes an edge and 64 KiB, as the compiler reports it.
inline bool has_room(const ZoneOutline& o, std::int64_t edges_most) {
  if (o.edges == nullptr || o.cells == nullptr || (o.lists == nullptr && o.list_count > 0)) {
    return false;
  }
  if (o.edge_count < 3 || o.edge_count > edges_most || o.cell_count < 1 || o.list_count < 0) {
    return false;
  }
  const std::int64_t numbers = std::int64_t{6} * o.edge_count + o.cell_count + o.list_count;
  return 4 * numbers <= 64 * edges_most + 65536;
}

}  // namespace detail

inline std::uint64_t zone_checksum(const ZoneTable& table) {
  detail::Checksum sum;
  sum.add(table.version);
  sum.add(table.within);
  sum.add(table.around);
  return sum.sum();
}

// Can a kernel that was generated for so many edges check it? In bounded time: it looks at every
// number once.
inline bool is_usable(const ZoneTable& table, std::int64_t edges_most) {
  return table.version == zone_table_version && detail::has_room(table.within, edges_most) &&
         detail::has_room(table.around, edges_most) && zone_checksum(table) == table.checksum &&
         detail::is_sound(table.within) && detail::is_sound(table.around);
}

namespace bridge {

template <class KernelOutline>
void put_outline(KernelOutline& to, const ZoneOutline& from) {
  to.edges = from.edges;
  to.cells = from.cells;
  to.lists = from.lists;
  to.edge_count = from.edge_count;
  to.cell_count = from.cell_count;
  to.list_count = from.list_count;
  to.x = from.x_mm;
  to.y = from.y_mm;
  to.shift = from.shift;
  to.column = from.column;
  to.row = from.row;
  to.columns = from.columns;
  to.rows = from.rows;
  to.depth = from.depth;
  to.leaves = from.leaves;
}

// Of a zone that is compiled in: KernelArea { edges, ..., exact }.
template <class KernelArea>
ZoneOutline outline_of(const KernelArea& from) {
  ZoneOutline to;
  to.edges = from.edges;
  to.cells = from.cells;
  to.lists = from.lists;
  to.edge_count = from.edge_count;
  to.cell_count = from.cell_count;
  to.list_count = from.list_count;
  to.x_mm = from.x;
  to.y_mm = from.y;
  to.shift = from.shift;
  to.column = from.column;
  to.row = from.row;
  to.columns = from.columns;
  to.rows = from.rows;
  to.depth = from.depth;
  to.leaves = from.leaves;
  return to;
}

// KernelSample { stamp_us, valid }, KernelZone { checksum, version, within, around }. A
// table that is there already is not looked at again.
template <class KernelSample, class KernelZone>
bool put_zone(KernelSample& sample, KernelZone& zone, const ZoneTable& table,
              std::int64_t edges_most, TimeUs stamp_us) {
  if (stamp_us == never_us) return false;
  const bool is_there =
      sample.valid != 0 && zone.checksum == table.checksum && zone.version == table.version &&
      zone.within.edges == table.within.edges && zone.within.cells == table.within.cells &&
      zone.around.edges == table.around.edges && zone.around.cells == table.around.cells;
  if (!is_there && !is_usable(table, edges_most)) return false;
  sample.stamp_us = stamp_us;
  sample.valid = 1;
  zone.checksum = table.checksum;
  zone.version = table.version;
  put_outline(zone.within, table.within);
  put_outline(zone.around, table.around);
  return true;
}

}  // namespace bridge
}  // namespace rtac
