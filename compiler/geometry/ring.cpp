#include "compiler/geometry/ring.h"

#include <algorithm>
#include <cstddef>

namespace rtac::geometry {

bool lower_left(const Point& a, const Point& b) {
  const int by_y = cmp(a.y, b.y);
  return by_y != 0 ? by_y < 0 : a.x < b.x;
}

Rational cross(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int orientation(const Point& a, const Point& b, const Point& c) {
  return sgn(cross(a, b, c));
}

bool within_bounds(const Point& p, const Point& a, const Point& b) {
  const auto between = [](const Rational& v, const Rational& e, const Rational& f) {
    return e <= f ? e <= v && v <= f : f <= v && v <= e;
  };
  return between(p.x, a.x, b.x) && between(p.y, a.y, b.y);
}

bool on_segment(const Point& p, const Point& a, const Point& b) {
  return within_bounds(p, a, b) && orientation(a, b, p) == 0;
}

Rational twice_area(const Ring& ring) {
  Rational sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

Side locate(const Point& p, const Ring& ring) {
  // Crossings of the ray to the right; an edge owns its lower end only, so that a ray through a
  // vertex counts once.
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    const bool a_below = a.y <= p.y;
    const bool b_below = b.y <= p.y;
    if (a_below == b_below && a.y != p.y && b.y != p.y) continue;
    if (on_segment(p, a, b)) return Side::boundary;
    if (a_below != b_below && orientation(a, b, p) == (a_below ? 1 : -1)) inside = !inside;
  }
  return inside ? Side::inside : Side::outside;
}

Ring canonical(const Ring& ring) {
  Ring corners;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& before = ring[(i + ring.size() - 1) % ring.size()];
    const Point& after = ring[(i + 1) % ring.size()];
    if (orientation(before, ring[i], after) != 0) corners.push_back(ring[i]);
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), lower_left),
              corners.end());
  return corners;
}

Ring reversed(const Ring& ring) {
  return Ring(ring.rbegin(), ring.rend());
}

bool ring_order(const Ring& a, const Ring& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), lower_left);
}

}  // namespace rtac::geometry
