// The tree of cells of a zone, as the kernel of its module has it (rtac/zone_table.h): which edges
// matter for a place. The same cells as there, asked about places between those of the grid, whose
// coordinates are doubles in mm. Internal to this folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "rtac/types.h"
#include "rtac/zone_table.h"

namespace rtac::detail {

// Closed to the south and west.
struct ZoneCell {
  std::int64_t x_mm = 0, y_mm = 0;  // south-west corner
  std::int32_t shift = 0;           // 2^shift mm wide
  std::uint32_t word = 0;

  // Of the boundary nothing is known but that it is at least so far away.
  [[nodiscard]] bool is_far() const { return word >> 30 == 0 && !is_met(); }
  // By the boundary.
  [[nodiscard]] bool is_met() const { return (word >> 28 & 1) != 0; }
  // One edge or two tell what is inside.
  [[nodiscard]] bool tells_by_sides() const { return word >> 30 == 0 && is_met(); }
  [[nodiscard]] double far_mm() const { return word & 0xfffffff; }
  [[nodiscard]] std::size_t edges() const {
    if (is_far()) return 0;
    return (word >> 24 & (tells_by_sides() ? 3 : 15)) + 1;
  }
  [[nodiscard]] std::size_t edge(const ZoneOutline& tree, std::size_t i) const {
    const std::size_t at = (word & (tells_by_sides() ? 0x7fffff : 0xffffff)) + i;
    return word >> 30 == 2 ? tree.lists[at] : at;
  }
};

class ZoneCells {
 public:
  explicit ZoneCells(const ZoneOutline& tree) : tree_(tree) {}

  // False: there is none, so far away is the place, or it is not a number.
  [[nodiscard]] bool find(Vec2 p_mm, ZoneCell& cell) const;
  // Of a place in that cell. Of places on the boundary it says nothing.
  [[nodiscard]] bool contains(const ZoneCell& cell, Vec2 p_mm) const;
  // `visit(cell)` for the cells that the segment passes, one after the other from `p_mm`; what it
  // passes for less than `hair_mm` may be left out, since a cell tells of its closed square. False:
  // it leaves the square of the tree.
  template <class Visit>
  [[nodiscard]] bool along(Vec2 p_mm, Vec2 e_mm, const Visit& visit) const {
    Vec2 at = p_mm;
    for (std::int32_t i = 0; i < tree_.leaves; ++i) {
      ZoneCell cell;
      if (!find(at, cell)) return false;
      visit(cell);
      if (!next(cell, p_mm, e_mm, at)) return true;
    }
    return false;
  }

 private:
  // Moves `at` to where the segment enters the next cell. False: it ends in this one.
  static bool next(const ZoneCell& cell, Vec2 p_mm, Vec2 e_mm, Vec2& at);

  const ZoneOutline& tree_;
};

}  // namespace rtac::detail
