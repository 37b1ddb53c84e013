// Cells where the lines of one edge or two tell which places are inside. Internal to this folder.
#pragma once

#include <span>

#include "compiler/geometry/cell_distance.h"

namespace rtac::geometry {

// What a word has room for.
inline constexpr std::size_t sides_edges_max = 4, sides_first_max = (1 << 23) - 4;

// Inside is what lies on the left of the edges `first` and, if there are two, the next one;
// `either`: on the left of one or the other.
struct Sides {
  std::size_t edges = 0;  // 0: no such edges
  std::size_t first = 0;
  bool either = false;
};

// Of the closed square and some neighbouring edges of the boundary, among them all that meet it.
// Said of squares that one edge passes through, or two that share a vertex in it.
Sides sides_of(const Square& square, std::span<const PreparedEdge> edges);

}  // namespace rtac::geometry
