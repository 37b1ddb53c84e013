// Cells that nothing but their place tells apart, of what is asked of robots that part in them.
// Internal to this folder.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/clear_cells.h"
#include "compiler/geometry/connectors.h"

namespace rtac::geometry {

// Two cells are of one kind where the same cells around them are or may be clear, each moved to the
// other, up to `around_cells` to each side; and where not all are clear as far as legs lead, the
// edges that connectors up to `legs_mm` long are tested against are the same, too, off the cell. So
// a pair of cells is told by both kinds and by how the one lies off the other, as long as of it
// - no other cell is asked for, and of cells only which of them are clear,
// - places are only compared with places: of binary fractions of millimetres, the differences are
//   exact in doubles, wherever the cells are,
// - edges are only asked for by `Connectors`, of legs over cells that are not all clear. What these
//   say of one place of the zone holds at the other, too, because they leave room for the errors of
//   doubles.
class Alike {
 public:
  Alike(const CellGrid& cells, const ClearCells& clear, const ClearCells& may_be_clear,
        Connectors connectors, int around_cells, double legs_mm);

  // From 0 on; negative: the cell is outside of the zone.
  [[nodiscard]] int kind(int cell) const { return kinds_[static_cast<std::size_t>(cell)]; }
  [[nodiscard]] std::size_t kinds() const { return of_kind_.size(); }
  // No other cell is of its kind.
  [[nodiscard]] bool is_single(int cell) const {
    return of_kind_[static_cast<std::size_t>(kind(cell))] == 1;
  }
  // Of what is clear around it, whether it is clear itself or not.
  [[nodiscard]] int surroundings(int cell) const {
    return surroundings_[static_cast<std::size_t>(cell)];
  }
  // Cells and edges, in all.
  [[nodiscard]] std::int64_t looked_at() const { return looked_at_; }

 private:
  std::vector<int> surroundings_, kinds_, of_kind_;
  std::int64_t looked_at_;
};

}  // namespace rtac::geometry
