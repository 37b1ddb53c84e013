// Shorthand and exact reference computations for the geometry tests.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "compiler/geometry/bake.h"
#include "compiler/geometry/region.h"

namespace rtac::geometry {

inline Rational q(long numerator, long denominator = 1) {
  Rational value(numerator, denominator);
  value.canonicalize();
  return value;
}
inline Point pt(long x, long y) {
  return {q(x), q(y)};
}
inline Point mm(long x, long y) {
  return {q(x, 1000), q(y, 1000)};
}

inline Region polygon(const Ring& outer, const std::vector<Ring>& holes = {}) {
  return std::get<Region>(Region::polygon(outer, holes));
}
inline Ring box_ring(long x0, long y0, long x1, long y1) {
  return {mm(x0, y0), mm(x1, y0), mm(x1, y1), mm(x0, y1)};
}
// Corners in mm.
inline Region box(long x0, long y0, long x1, long y1) {
  return polygon(box_ring(x0, y0, x1, y1));
}

// The zone `free` of the delivery specification.
inline Region delivery_free() {
  return box(0, 0, 5000, 5000)
      .subtract(box(2000, 0, 3000, 1000)
                    .unite(box(2000, 3000, 3000, 4000))
                    .unite(box(1000, 2000, 1600, 3000)));
}

inline std::string text(const Region& region) {
  std::ostringstream out;
  const auto ring = [&](const Ring& r) {
    for (const Point& p : r) out << '(' << p.x << ' ' << p.y << ')';
    out << '\n';
  };
  for (const PolygonWithHoles& part : region.polygons()) {
    out << "part\n";
    ring(part.outer);
    for (const Ring& hole : part.holes) ring(hole);
  }
  return out.str();
}

struct Segment {
  Point a, b;
};
inline std::vector<Segment> boundary(const Region& region) {
  std::vector<Segment> edges;
  const auto add = [&](const Ring& r) {
    for (std::size_t i = 0; i < r.size(); ++i) edges.push_back({r[i], r[(i + 1) % r.size()]});
  };
  for (const PolygonWithHoles& part : region.polygons()) {
    add(part.outer);
    for (const Ring& hole : part.holes) add(hole);
  }
  return edges;
}

inline Rational squared_distance(const Point& p, const Segment& s) {
  const Rational dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
  const Rational length = dx * dx + dy * dy;
  Rational t = ((p.x - s.a.x) * dx + (p.y - s.a.y) * dy) / length;
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  const Rational x = p.x - s.a.x - t * dx, y = p.y - s.a.y - t * dy;
  return x * x + y * y;
}
inline Rational squared_distance(const Point& p, const std::vector<Segment>& edges) {
  Rational least = squared_distance(p, edges.front());
  for (const Segment& edge : edges) least = std::min(least, squared_distance(p, edge));
  return least;
}
// Between two sets of edges that do not cross: an end point of one of them is nearest.
inline Rational squared_distance(const std::vector<Segment>& a, const std::vector<Segment>& b) {
  Rational least = squared_distance(a.front().a, b);
  for (const Segment& edge : a) least = std::min(least, squared_distance(edge.a, b));
  for (const Segment& edge : b) least = std::min(least, squared_distance(edge.a, a));
  return least;
}

using Random = std::mt19937;
// Not std::uniform_int_distribution: its values differ between libraries.
inline long pick(Random& random, long lo, long hi) {
  return lo + static_cast<long>(random() % static_cast<unsigned long>(hi - lo + 1));
}
// Coordinates in 1/denominator of a mm.
inline Region random_triangle(Random& random, long extent_mm, long denominator) {
  const auto coordinate = [&] {
    return q(pick(random, 0, extent_mm * denominator), 1000 * denominator);
  };
  for (;;) {
    const Ring ring{
        {coordinate(), coordinate()}, {coordinate(), coordinate()}, {coordinate(), coordinate()}};
    const auto result = Region::polygon(ring, {});
    if (const auto* region = std::get_if<Region>(&result)) return *region;
  }
}
// Unions and differences of triangles: several parts, holes, slivers, corners of all angles.
inline Region random_region(Random& random, int operations, long denominator) {
  Region region = random_triangle(random, 5000, denominator);
  for (int i = 0; i < operations; ++i) {
    const Region other = random_triangle(random, 5000, denominator);
    region = random() % 3 == 0 ? region.subtract(other) : region.unite(other);
  }
  return region;
}

}  // namespace rtac::geometry
