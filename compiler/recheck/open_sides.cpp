#include "compiler/recheck/open_sides.h"

#include <cmath>

namespace rtac::recheck {

OpenSides::OpenSides(double cell, double goal, double joins)
    : cell_(cell), goal_(goal), joins_(joins) {
  const int far = static_cast<int>(std::ceil(goal / cell)) + 1;
  blocks_ = {Block{0, 0, far, 0},   {-far, 0, 0, 0},   {0, 0, 0, far},    {0, -far, 0, 0},
             Block{0, 0, far, far}, {-far, 0, 0, far}, {0, -far, far, 0}, {-far, -far, 0, 0}};
}

OpenSides::Set OpenSides::against(int column, int row) const {
  const Box other{column * cell_, row * cell_, (column + 1) * cell_, (row + 1) * cell_};
  Set all;
  for (std::size_t i = 0; i < count; ++i) all[i] = does(blocks_[i], other);
  return all;
}

// Straight on from cell to cell of the block, as long as that recedes.
bool OpenSides::leads(int column, int row, const Block& block, const Box& other) const {
  for (int dr = -1; dr <= 1; ++dr) {
    for (int dc = -1; dc <= 1; ++dc) {
      for (int c = column, r = row; block.has(c, r); c += dc, r += dr) {
        const Place p = middle_of(c, r);
        const Box here{p.x, p.y, p.x, p.y};
        if (nearest(here, other) >= goal_) return true;
        if ((dc == 0 && dr == 0) || !recedes(middle_of(c + dc, r + dr), here, other)) break;
      }
    }
  }
  return false;
}

// From its own cell, unless that leads nearer, or else from one near it, with no cell between that
// is not of the block.
bool OpenSides::does(const Block& block, const Box& other) const {
  const Box here{0, 0, cell_, cell_};
  if (!leads(0, 0, block, other) && !comes_nearer(middle_of(0, 0), here, other)) return false;
  const int off = static_cast<int>(joins_ / cell_);
  for (int r = -off; r <= off; ++r) {
    for (int c = -off; c <= off; ++c) {
      if (!block.has(c, r) || length(c * cell_, r * cell_) > joins_) continue;
      if (recedes(middle_of(c, r), here, other) && leads(c, r, block, other)) return true;
    }
  }
  return false;
}

}  // namespace rtac::recheck
