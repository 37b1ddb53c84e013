// Small exact predicates on points and rings. Internal to this folder.
#pragma once

#include "compiler/geometry/region.h"

namespace rtac::geometry {

inline bool same(const Point& a, const Point& b) {
  return a.x == b.x && a.y == b.y;
}

// Reading order of corners: the lower first, of two equally low the left one.
bool lower_left(const Point& a, const Point& b);

// Twice the signed area of the triangle a, b, c: positive when c is on the left of a -> b.
Rational cross(const Point& a, const Point& b, const Point& c);

// +1 left turn, 0 collinear, -1 right turn.
int orientation(const Point& a, const Point& b, const Point& c);

// p lies in the closed box about a and b; on the closed segment.
bool within_bounds(const Point& p, const Point& a, const Point& b);
bool on_segment(const Point& p, const Point& a, const Point& b);

// Twice the signed area; positive for counter-clockwise.
Rational twice_area(const Ring& ring);

enum class Side { inside, boundary, outside };
Side locate(const Point& p, const Ring& ring);

// Drops vertices that lie straight between their neighbours, then starts at the lowest-left
// vertex. The ring must be simple.
Ring canonical(const Ring& ring);
Ring reversed(const Ring& ring);

// Order of rings by their first vertices; rings that touch there are told apart by the vertices
// that follow.
bool ring_order(const Ring& a, const Ring& b);

}  // namespace rtac::geometry
