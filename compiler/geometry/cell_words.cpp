#include "compiler/geometry/cell_words.h"

#include <algorithm>
#include <cmath>

namespace rtac::geometry {
namespace {

__extension__ using SignedWide = __int128;

constexpr std::uint32_t kind(std::uint32_t number) {
  return number << 30;
}
std::uint32_t edges_word(std::uint32_t of_kind, std::size_t at, std::size_t edges, bool inside,
                         bool crossed) {
  return kind(of_kind) | (inside ? 1U << 29 : 0) | (crossed ? 1U << 28 : 0) |
         static_cast<std::uint32_t>(edges - 1) << 24 | static_cast<std::uint32_t>(at);
}

// The corner, moved, lies on the left of the edge's line.
bool is_left(const PreparedEdge& e, const Corner& p) {
  const SignedWide c = SignedWide{e.dx} * (p.y - e.ay) - SignedWide{e.dy} * (p.x - e.ax);
  if (c != 0) return c > 0;
  return e.dx != 0 ? e.dx > 0 : e.dy < 0;
}
bool spans_x(const PreparedEdge& e, std::int64_t x) {
  return (e.ax > x) != (e.bx > x);
}
bool spans_y(const PreparedEdge& e, std::int64_t y) {
  return (e.ay > y) != (e.by > y);
}

}  // namespace

std::uint32_t far_word(std::int32_t distance_mm, bool inside) {
  return kind(0) | (inside ? 1U << 29 : 0) | static_cast<std::uint32_t>(distance_mm);
}
std::uint32_t run_word(std::size_t first, std::size_t edges, bool inside, bool crossed) {
  return edges_word(1, first, edges, inside, crossed);
}
std::uint32_t list_word(std::size_t at, std::size_t edges, bool inside, bool crossed) {
  return edges_word(2, at, edges, inside, crossed);
}
std::uint32_t sides_word(std::size_t first, std::size_t edges, const Sides& sides) {
  return kind(0) | (sides.either ? 1U << 29 : 0) | 1U << 28 |
         static_cast<std::uint32_t>(sides.first) << 26 |
         static_cast<std::uint32_t>(edges - 1) << 24 | (sides.edges == 2 ? 1U << 23 : 0) |
         static_cast<std::uint32_t>(first);
}
bool tells_by_sides(std::uint32_t word) {
  return word >> 30 == 0 && (word >> 28 & 1) != 0;
}
std::uint32_t split_word(std::size_t at) {
  return kind(3) | static_cast<std::uint32_t>(at);
}
std::int32_t edges_of(std::uint32_t word) {
  if (word >> 30 == 3) return 0;
  if (word >> 30 != 0) return static_cast<std::int32_t>(word >> 24 & 15) + 1;
  return tells_by_sides(word) ? static_cast<std::int32_t>(word >> 24 & 3) + 1 : 0;
}

double Grid::diameter_mm() const {
  return std::hypot(static_cast<double>(columns), static_cast<double>(rows)) *
         static_cast<double>(cell_mm());
}
bool Grid::overlaps(const Square& s) const {
  const std::int64_t west = x_mm + column * cell_mm(), south = y_mm + row * cell_mm();
  return s.x_mm < west + columns * cell_mm() && s.x_mm + s.side_mm > west &&
         s.y_mm < south + rows * cell_mm() && s.y_mm + s.side_mm > south;
}
std::optional<std::size_t> Grid::index(const Square& s) const {
  if (s.side_mm != cell_mm() || !overlaps(s)) return std::nullopt;
  const std::int64_t c = ((s.x_mm - x_mm) >> shift) - column;
  const std::int64_t r = ((s.y_mm - y_mm) >> shift) - row;
  return static_cast<std::size_t>(r * columns + c);
}

Grid grid_for(const std::vector<PreparedEdge>& edges) {
  std::int64_t x0 = edges[0].ax, x1 = x0, y0 = edges[0].ay, y1 = y0;
  for (const PreparedEdge& e : edges) {
    x0 = std::min(x0, e.ax);
    x1 = std::max(x1, e.ax);
    y0 = std::min(y0, e.ay);
    y1 = std::max(y1, e.ay);
  }
  // A third of the square west and south of the zone: 1/3 is 0.0101..., so that the zone's corner
  // lies a third into every cell, and the cells around those that hold it are few.
  constexpr std::int64_t third = 0x55555555;
  Grid grid{x0 - third, y0 - third, 0, 0, 0, 0, 0};
  const auto most = static_cast<std::int64_t>(2 * edges.size());
  do {
    grid.shift += 2;
    grid.column = (x0 - 1 - grid.x_mm) >> grid.shift;
    grid.row = (y0 - 1 - grid.y_mm) >> grid.shift;
    grid.columns = ((x1 + 1 - grid.x_mm) >> grid.shift) - grid.column + 1;
    grid.rows = ((y1 + 1 - grid.y_mm) >> grid.shift) - grid.row + 1;
  } while (grid.columns > most / grid.rows);
  return grid;
}

bool crosses_way(const PreparedEdge& e, const Corner& from, const Corner& to) {
  const Corner turn{from.x, to.y};
  const bool first = spans_x(e, from.x) && is_left(e, from) != is_left(e, turn);
  const bool second = spans_y(e, to.y) && is_left(e, turn) != is_left(e, to);
  return first != second;
}

std::vector<char> corners_inside(const std::vector<PreparedEdge>& edges, const Grid& grid) {
  // Of every edge and row, the first corner east of it; from there on, one more is crossed.
  std::vector<char> inside(grid.cells(), 0);
  const std::int64_t cell = grid.cell_mm();
  const std::int64_t west = grid.x_mm + grid.column * cell, south = grid.y_mm + grid.row * cell;
  for (const PreparedEdge& e : edges) {
    const std::int64_t first = (std::min(e.ay, e.by) - south) / cell;
    const std::int64_t last = (std::max(e.ay, e.by) - south) / cell;
    for (std::int64_t row = first; row <= last; ++row) {
      const std::int64_t y = south + row * cell;
      if (!spans_y(e, y)) continue;
      const auto is_east = [&](std::int64_t column) {
        return is_left(e, {west + column * cell, y}) == (e.dy < 0);
      };
      std::int64_t low = (std::min(e.ax, e.bx) - west) / cell;
      std::int64_t high = (std::max(e.ax, e.bx) - west) / cell + 1;  // east of the whole edge
      while (low < high) {
        const std::int64_t middle = (low + high) / 2;
        is_east(middle) ? high = middle : low = middle + 1;
      }
      if (low < grid.columns) inside[static_cast<std::size_t>(row * grid.columns + low)] ^= 1;
    }
  }
  const auto columns = static_cast<std::size_t>(grid.columns);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    if (i % columns != 0) inside[i] = static_cast<char>(inside[i] ^ inside[i - 1]);
  }
  return inside;
}

}  // namespace rtac::geometry
