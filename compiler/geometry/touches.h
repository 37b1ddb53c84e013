// Rings of one polygon may touch one another in points, as long as they do not cross there and the
// area between them stays in one piece (OGC 06-103r4, 6.1.11.1). Internal to this folder.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/geometry/sweep.h"

namespace rtac::geometry {

// How edges of one ring leave a point that they share with another ring.
enum class Leaves { inwards, outwards, otherwise };  // otherwise: to both sides, or along an edge

// Of the ring of edge `leaving` at `at`, a point of it and of edge `of`, seen from the ring of
// `of`. `counter_clockwise` tells the orientation of the latter.
Leaves leaves(const Edges& edges, const Edge& leaving, const Edge& of, bool counter_clockwise,
              const Point& at);

struct Touch {
  std::size_t ring, other;  // ring < other
  std::size_t edge;         // of `other`, by index in it
  Point at;
};

// The first touch, by `other` and edge, that cuts the area between the rings in two: the rings it
// joins were joined by others before. nullptr: the area is in one piece.
const Touch* first_cut(std::size_t rings, std::vector<Touch>& touches);

}  // namespace rtac::geometry
