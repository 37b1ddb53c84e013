#include "compiler/geometry/clearings.h"

#include <algorithm>
#include <cmath>

namespace rtac::geometry {

Clearings::Clearings(double size_mm, double goal_mm, double reach_mm)
    : size_mm_(size_mm),
      goal_mm_(goal_mm),
      reach_mm_(reach_mm),
      length_(static_cast<int>(std::ceil(goal_mm / size_mm)) + 1) {}

Clearings::Rectangle Clearings::of(Step way) const {
  return {std::min(way.columns * length_, 0), std::min(way.rows * length_, 0),
          std::max(way.columns * length_, 0), std::max(way.rows * length_, 0)};
}

std::uint8_t Clearings::clear_from(const ClearCells& cells, int column, int row) const {
  std::uint8_t all = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Rectangle r = of(steps[i]);
    if (cells.all(column + r.west, row + r.south, column + r.east, row + r.north)) {
      all = static_cast<std::uint8_t>(all | 1U << i);
    }
  }
  return all;
}

std::uint8_t Clearings::that_do(Step other) const {
  const Box there{middle(other), size_mm_ / 2};
  std::uint8_t all = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (does(of(steps[i]), there)) all = static_cast<std::uint8_t>(all | 1U << i);
  }
  return all;
}

// Once a step leads away from the other robot, more of them in the same way do, too.
bool Clearings::leads(Step cell, const Rectangle& clear, const Box& other) const {
  return std::any_of(steps.begin(), steps.end(), [&](Step way) {
    if (!recedes(middle({cell.columns + way.columns, cell.rows + way.rows}), {middle(cell), 0},
                 other)) {
      return is_beyond(middle(cell), other, goal_mm_);
    }
    for (Step at = cell; clear.has(at); at = {at.columns + way.columns, at.rows + way.rows}) {
      if (is_beyond(middle(at), other, goal_mm_)) return true;
    }
    return false;
  });
}

// The search begins with the cell itself, unless the leg to its middle comes nearer, or else with
// one of those near it.
bool Clearings::does(const Rectangle& clear, const Box& other) const {
  const Box here{{}, size_mm_ / 2};
  if (!leads({0, 0}, clear, other) && !comes_nearer({}, here, other)) return false;
  const int far = static_cast<int>(reach_mm_ / size_mm_);
  for (int r = std::max(clear.south, -far); r <= std::min(clear.north, far); ++r) {
    for (int c = std::max(clear.west, -far); c <= std::min(clear.east, far); ++c) {
      const Vec to = middle({c, r});
      if (std::hypot(to.x, to.y) > reach_mm_) continue;
      if (recedes(to, here, other) && leads({c, r}, clear, other)) return true;
    }
  }
  return false;
}

}  // namespace rtac::geometry
