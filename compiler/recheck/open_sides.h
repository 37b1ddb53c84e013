// Robots beside which so much is clear that they can leave others over that alone.
#pragma once

#include <array>
#include <bitset>

#include "compiler/recheck/receding.h"

namespace rtac::recheck {

// Of cells beside one, itself included, by their columns and rows off it.
struct Block {
  int west, south, east, north;
  [[nodiscard]] bool has(int column, int row) const {
    return column >= west && column <= east && row >= south && row <= north;
  }
};
class OpenSides {
 public:
  // The strips along both axes and the squares between them.
  static constexpr std::size_t count = 8;
  using Set = std::bitset<count>;
  // Ways end at `goal` from the other robot; their first legs are at most `joins` long, from the
  // middle of a cell.
  OpenSides(double cell, double goal, double joins);
  [[nodiscard]] const std::array<Block, count>& blocks() const { return blocks_; }
  // Which blocks a robot anywhere in its cell can leave over, if they are clear, whatever else is,
  // another one anywhere in the cell that is so many columns and rows off.
  [[nodiscard]] Set against(int column, int row) const;

 private:
  [[nodiscard]] Place middle_of(int column, int row) const {
    return {(column + 0.5) * cell_, (row + 0.5) * cell_};
  }
  [[nodiscard]] bool does(const Block& block, const Box& other) const;
  [[nodiscard]] bool leads(int column, int row, const Block& block, const Box& other) const;

  double cell_, goal_, joins_;
  std::array<Block, count> blocks_;
};

}  // namespace rtac::recheck
