#include "zone_cells.h"

#include <algorithm>
#include <cmath>

namespace rtac::detail {
namespace {

// Less than anything that matters, and more than what doubles round off at 537 km.
constexpr double hair_mm = 1e-6;
constexpr double square_mm = 4294967296.0;

// Sides of points that count as moved north by less than anything else, and east by less than that,
// so that none lies on an edge: from this value on, they are on its left.
bool on_left(double value, bool from_zero) {
  return from_zero ? value >= 0 : value > 0;
}

// Whether the edge crosses the way from the corner of the cell north to p.y, then east to p.x: as
// the kernel's `crosses_way`. The corner is exact; p is taken as doubles find it, but the same for
// both parts of the way, so that an edge near the turn is counted once or not at all.
bool crosses_way(const std::int32_t* e, const ZoneCell& cell, Vec2 p) {
  const std::int64_t dx = std::int64_t{e[2]} - e[0], dy = std::int64_t{e[3]} - e[1];
  const bool from_zero = dx > 0 || (dx == 0 && dy < 0);
  const std::int64_t at_start = dx * (cell.y_mm - e[1]) - dy * (cell.x_mm - e[0]);
  const bool start = at_start > 0 || (from_zero && at_start == 0);
  const auto x = static_cast<double>(dx), y = static_cast<double>(dy);
  const double north = x * (p.y - e[1]);
  const bool turn = on_left(north - y * static_cast<double>(cell.x_mm - e[0]), from_zero);
  const bool end = on_left(north - y * (p.x - e[0]), from_zero);
  const bool meets_first = (e[0] > cell.x_mm) != (e[2] > cell.x_mm);
  const bool meets_second = (e[1] > p.y) != (e[3] > p.y);
  return (meets_first && start != turn) != (meets_second && turn != end);
}

bool is_on_left(const std::int32_t* e, Vec2 p) {
  const auto dx = static_cast<double>(std::int64_t{e[2]} - e[0]);
  const auto dy = static_cast<double>(std::int64_t{e[3]} - e[1]);
  return dx * (p.y - e[1]) > dy * (p.x - e[0]);
}

}  // namespace

bool ZoneCells::find(Vec2 p_mm, ZoneCell& cell) const {
  const double x_mm = p_mm.x - tree_.x_mm, y_mm = p_mm.y - tree_.y_mm;
  if (!(x_mm >= 0 && y_mm >= 0 && x_mm < square_mm && y_mm < square_mm)) return false;
  const auto x = static_cast<std::int64_t>(x_mm), y = static_cast<std::int64_t>(y_mm);
  const std::int64_t column = (x >> tree_.shift) - tree_.column;
  const std::int64_t row = (y >> tree_.shift) - tree_.row;
  const std::int64_t columns = tree_.columns, rows = tree_.rows;
  const bool in_grid = column >= 0 && column < columns && row >= 0 && row < rows;
  cell.shift = in_grid ? tree_.shift : 32;
  cell.word = tree_.cells[in_grid ? row * columns + column : rows * columns];
  for (std::int32_t i = 0; i < tree_.depth && cell.word >> 30 == 3; ++i) {
    cell.shift -= 2;
    const std::int64_t part = (y >> cell.shift & 3) << 2 | (x >> cell.shift & 3);
    cell.word = tree_.cells[(cell.word & 0x3fffffff) + static_cast<std::size_t>(part)];
  }
  cell.x_mm = tree_.x_mm + (x >> cell.shift << cell.shift);
  cell.y_mm = tree_.y_mm + (y >> cell.shift << cell.shift);
  return true;
}

bool ZoneCells::contains(const ZoneCell& cell, Vec2 p_mm) const {
  if (cell.tells_by_sides()) {
    const std::size_t at = cell.edge(tree_, cell.word >> 26 & 3);
    const bool first = is_on_left(tree_.edges + 6 * at, p_mm);
    const bool second = is_on_left(tree_.edges + 6 * (at + (cell.word >> 23 & 1)), p_mm);
    return (cell.word >> 29 & 1) != 0 ? first || second : first && second;
  }
  bool inside = (cell.word >> 29 & 1) != 0;
  if (!cell.is_met()) return inside;
  for (std::size_t i = 0; i < cell.edges(); ++i) {
    inside ^= crosses_way(tree_.edges + 6 * cell.edge(tree_, i), cell, p_mm);
  }
  return inside;
}

bool ZoneCells::next(const ZoneCell& cell, Vec2 p_mm, Vec2 e_mm, Vec2& at) {
  const Vec2 d = e_mm - p_mm;
  const double side_mm = std::ldexp(1.0, cell.shift);
  const auto x0 = static_cast<double>(cell.x_mm), y0 = static_cast<double>(cell.y_mm);
  const double x1 = x0 + side_mm, y1 = y0 + side_mm;
  const bool by_x = d.x > 0 ? e_mm.x >= x1 : e_mm.x < x0;
  const bool by_y = d.y > 0 ? e_mm.y >= y1 : e_mm.y < y0;
  if (!by_x && !by_y) return false;
  // where it passes the lines of the sides that it runs towards, from p
  const Vec2 q{std::abs((d.x > 0 ? x1 : x0) - p_mm.x), std::abs((d.y > 0 ? y1 : y0) - p_mm.y)};
  if (by_x && (!by_y || q.x * std::abs(d.y) <= q.y * std::abs(d.x))) {
    const double y = p_mm.y + d.y * (q.x / std::abs(d.x));
    at = {d.x > 0 ? x1 : x0 - hair_mm, std::clamp(y, y0, y1 - hair_mm)};
  } else {
    const double x = p_mm.x + d.x * (q.y / std::abs(d.y));
    at = {std::clamp(x, x0, x1 - hair_mm), d.y > 0 ? y1 : y0 - hair_mm};
  }
  return true;
}

}  // namespace rtac::detail
