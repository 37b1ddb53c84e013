// The grid that a tree of cells starts at, the sides of its corners, and the words of its cells.
// Internal to this folder. mm; edges within +-2^29 mm.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/geometry/cell_distance.h"
#include "compiler/geometry/cell_sides.h"

namespace rtac::geometry {

inline constexpr int square_shift = 32;
inline constexpr std::int32_t far_most_mm = (1 << 28) - 1;

// `distance_mm`: 0 to far_most_mm.
std::uint32_t far_word(std::int32_t distance_mm, bool inside);
std::uint32_t run_word(std::size_t first, std::size_t edges, bool inside, bool crossed);
std::uint32_t list_word(std::size_t at, std::size_t edges, bool inside, bool crossed);
// Of at most 4 neighbouring edges, where `sides` is clear.
std::uint32_t sides_word(std::size_t first, std::size_t edges, const Sides& sides);
bool tells_by_sides(std::uint32_t word);
std::uint32_t split_word(std::size_t at);
// How many edges a cell has; 0 of what has none.
std::int32_t edges_of(std::uint32_t word);

// The whole boundary lies within its cells, none of it on the outer border.
struct Grid {
  std::int64_t x_mm, y_mm;  // south-west corner of the whole square
  int shift;                // cells are 2^shift mm wide
  std::int64_t column, row, columns, rows;

  [[nodiscard]] std::int64_t cell_mm() const { return std::int64_t{1} << shift; }
  [[nodiscard]] std::size_t cells() const { return static_cast<std::size_t>(columns * rows); }
  [[nodiscard]] double diameter_mm() const;
  [[nodiscard]] bool overlaps(const Square& square) const;
  // Of a cell of the grid; nullopt: the square is none.
  [[nodiscard]] std::optional<std::size_t> index(const Square& square) const;
};
Grid grid_for(const std::vector<PreparedEdge>& edges);

struct Corner {
  std::int64_t x, y;
};
// Whether the edge is crossed between two corners, on the way north or south and then east or west.
// Corners count as moved north by less than anything else, and east by less than that.
bool crosses_way(const PreparedEdge& edge, const Corner& from, const Corner& to);

// Whether the region contains the south-west corner of each cell of the grid, moved like that.
std::vector<char> corners_inside(const std::vector<PreparedEdge>& edges, const Grid& grid);

}  // namespace rtac::geometry
