// Robots that leave others over a rectangle of clear cells, whatever is around that. Internal to
// this folder.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compiler/geometry/clear_cells.h"
#include "compiler/geometry/receding.h"

namespace rtac::geometry {

// To the cells around one, counter-clockwise from the east.
struct Step {
  int columns, rows;
};
inline constexpr std::array<Step, 8> steps{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

// The row of cells that lies that way from a cell, with that cell, or where it is a diagonal the
// quarter of a square between the two ways beside it: one of eight each, and so the bits of sets.
class Clearings {
 public:
  // Of cells `size_mm` wide, where ways end at `goal_mm` from the other one, and lead at first to
  // cells whose middles are within `reach_mm`.
  Clearings(double size_mm, double goal_mm, double reach_mm);

  // Those that are clear from a cell on.
  [[nodiscard]] std::uint8_t clear_from(const ClearCells& cells, int column, int row) const;
  // Those over which, if they are clear, the search finds a way for a robot anywhere in its cell,
  // from another one anywhere in the cell that is so many columns and rows off.
  [[nodiscard]] std::uint8_t that_do(Step other) const;

 private:
  struct Rectangle {
    int west, south, east, north;
    [[nodiscard]] bool has(Step s) const {
      return s.columns >= west && s.columns <= east && s.rows >= south && s.rows <= north;
    }
  };
  [[nodiscard]] Rectangle of(Step way) const;
  [[nodiscard]] Vec middle(Step cell) const {
    return {cell.columns * size_mm_, cell.rows * size_mm_};
  }
  [[nodiscard]] bool does(const Rectangle& clear, const Box& other) const;
  [[nodiscard]] bool leads(Step cell, const Rectangle& clear, const Box& other) const;

  double size_mm_, goal_mm_, reach_mm_;
  int length_;  // of each, in cells
};

}  // namespace rtac::geometry
