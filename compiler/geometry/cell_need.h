// What a tree of cells needs at least, so that what cannot succeed is not tried. Internal to this
// folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compiler/geometry/cell_distance.h"

namespace rtac::geometry {

// Of the boundary in a square: edges that meet the closed square, and how long they are within it.
struct Met {
  std::size_t edges = 0;
  double length_mm = 0;  // never more than it is
};
// Edges that meet the square are among `near`.
Met met_by(const Square& square, const std::vector<PreparedEdge>& edges,
           const std::vector<std::uint32_t>& near);

// Into how many cells of at most `edges_max` edges each such a square has to be divided, at least.
// 1: none are needed.
//
// Every edge is in all cells that it meets, so there are at least edges / edges_max. And a cell of
// side s has at most edges_max s sqrt(2) of their length; over cells that cover the square, of side
// S, the sum of all s^2 is S^2, hence that of all s at most S sqrt(cells), hence
//   length_mm <= edges_max sqrt(2) S sqrt(cells).
double cells_due(const Square& square, const Met& met, std::size_t edges_max);

// Divisions by 16 that make `from` cells so many.
std::size_t divisions_due(double cells, double from);

}  // namespace rtac::geometry
