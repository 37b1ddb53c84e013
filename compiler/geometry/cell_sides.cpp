#include "compiler/geometry/cell_sides.h"

namespace rtac::geometry {
namespace {

bool holds(const Square& s, std::int64_t x, std::int64_t y) {
  return x >= s.x_mm && x <= s.x_mm + s.side_mm && y >= s.y_mm && y <= s.y_mm + s.side_mm;
}

}  // namespace

// An edge that has no end in the square divides it. Two that meet in it and end outside bound an
// angle, which is inside, or all that is not in the angle.
Sides sides_of(const Square& square, std::span<const PreparedEdge> edges) {
  Sides sides;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!meets_closed(square, edges[i])) continue;
    if (sides.edges == 0) sides.first = i;
    ++sides.edges;
  }
  if (sides.edges == 0 || sides.edges > 2) return {};
  const PreparedEdge& e = edges[sides.first];
  const PreparedEdge& f = edges[sides.first + sides.edges - 1];
  if (holds(square, e.ax, e.ay) || holds(square, f.bx, f.by)) return {};
  if (sides.edges == 1) return sides;
  const bool joined = e.bx == f.ax && e.by == f.ay && holds(square, e.bx, e.by);
  sides.either = e.reflex_at_b;
  return joined ? sides : Sides{};
}

}  // namespace rtac::geometry
