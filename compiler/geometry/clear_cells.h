// Which cells of a grid are clear enough for ways. Internal to this folder.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/bake.h"

namespace rtac::geometry {

// Nothing is clear off the grid.
class ClearCells {
 public:
  ClearCells(const CellGrid& cells, std::int32_t clearance_mm);

  [[nodiscard]] bool at(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns_ && row < rows_ &&
           clear_[static_cast<std::size_t>(row * columns_ + column)];
  }
  // All cells of a rectangle, both corners included.
  [[nodiscard]] bool all(int west, int south, int east, int north) const;
  // For each cell a number of which ones are clear up to `window` columns and rows to each side of
  // it: that of another cell is the same where these are the same, moved to it.
  [[nodiscard]] std::vector<int> numbers_around(int window) const;

 private:
  [[nodiscard]] std::int32_t& sum(int column, int row) {
    return not_clear_[static_cast<std::size_t>(row * (columns_ + 1) + column)];
  }
  [[nodiscard]] std::int32_t sum(int column, int row) const {
    return not_clear_[static_cast<std::size_t>(row * (columns_ + 1) + column)];
  }

  int columns_, rows_;
  std::vector<bool> clear_;
  std::vector<std::int32_t> not_clear_;  // how many of the cells south-west of each corner
};

}  // namespace rtac::geometry
