// Places against rings in whole micrometres: what the tests of generated monitors hold verdicts and
// clearances against. Sides are exact up to a kilometre.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace rtac::kernel_test {

using Um = std::int64_t;  // micrometres
struct Place {
  Um x, y;
};
using Ring = std::vector<Place>;
using Rings = std::vector<Ring>;

constexpr Um mm = 1000, m = 1000 * mm;

// A ground with a slanted north and a hole that is not convex.
inline const Rings& pad() {
  static const Rings rings = {
      {{0, 0}, {6 * m, 0}, {6 * m, 4 * m}, {0, 3250 * mm}},
      {{2 * m, 1 * m}, {4 * m, 1 * m}, {4 * m, 2 * m}, {3 * m, 1500 * mm}, {2 * m, 2 * m}}};
  return rings;
}

template <class Visit>
void for_each_edge(const Rings& rings, const Visit& visit) {
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
  }
}

// Twice the area of a, b and p: positive when p is on the left of a to b.
inline Um side(Place a, Place b, Place p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// Even-odd rule; the boundary belongs to them, that of a hole as well.
inline bool within(const Rings& rings, Place p) {
  bool inside = false, on_edge = false;
  for_each_edge(rings, [&](Place a, Place b) {
    const bool along = std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
                       std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
    on_edge = on_edge || (along && side(a, b, p) == 0);
    if ((a.y > p.y) != (b.y > p.y) && (b.y > a.y) == (side(a, b, p) > 0)) inside = !inside;
  });
  return inside || on_edge;
}

inline double distance_m(Place a, Place b, Place p) {
  const double dx = double(b.x - a.x), dy = double(b.y - a.y);
  const double t = (double(p.x - a.x) * dx + double(p.y - a.y) * dy) / (dx * dx + dy * dy);
  const double at = std::min(1.0, std::max(0.0, t));
  return std::hypot(double(p.x - a.x) - at * dx, double(p.y - a.y) - at * dy) / double(m);
}
// From the boundary, on either side of it.
inline double boundary_m(const Rings& rings, Place p) {
  double least = 1e9;
  for_each_edge(rings, [&](Place a, Place b) { least = std::min(least, distance_m(a, b, p)); });
  return least;
}

}  // namespace rtac::kernel_test
