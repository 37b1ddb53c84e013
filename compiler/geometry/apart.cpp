#include "compiler/geometry/apart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "compiler/geometry/nearby.h"

namespace rtac::geometry {
namespace {

// An edge of one region, or a vertex of the other one, with its nearest doubles.
struct Corner {
  const Point *exact, *next;
  Segment near;  // to the next corner
};

double near(const Rational& value) {
  return value.get_d();
}

std::vector<Corner> corners_of(const std::vector<Ring>& rings) {
  std::vector<Corner> corners;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
      corners.push_back({&p, &q, {{near(p.x), near(p.y)}, {near(q.x), near(q.y)}}});
    }
  }
  return corners;
}

double reach_of(const std::vector<Corner>& corners) {
  double reach = 1;
  for (const Corner& c : corners) {
    reach = std::max({reach, std::abs(c.near.a.x), std::abs(c.near.a.y)});
  }
  return reach;
}

Rational square_to(const Point& p, const Corner& edge) {
  const Rational dx = edge.next->x - edge.exact->x, dy = edge.next->y - edge.exact->y;
  const Rational qx = p.x - edge.exact->x, qy = p.y - edge.exact->y;
  const Rational along = qx * dx + qy * dy, whole = dx * dx + dy * dy;
  const Rational share = std::clamp(Rational(along / whole), Rational(0), Rational(1));
  const Rational x = qx - share * dx, y = qy - share * dy;
  return x * x + y * y;
}

// Calls `visit` with each vertex and each edge of the other region, and how far apart they are in
// doubles.
template <class Visit>
void each_pair(const std::vector<Corner>& a, const std::vector<Corner>& b, const Visit& visit) {
  for (const Corner& p : a) {
    for (const Corner& q : b) {
      visit(p, q, distance(p.near.a, q.near));
      visit(q, p, distance(q.near.a, p.near));
    }
  }
}

}  // namespace

// Of regions that have no area in common the nearest places are a vertex of one and a place of an
// edge of the other. Doubles, off by far less than 10^-9 of the coordinates, say which it may be.
Rational square_apart(const Region& a, const Region& b) {
  if (!a.intersect(b).empty()) return 0;
  const std::vector<Ring> rings_a = a.rings(), rings_b = b.rings();
  const std::vector<Corner> of_a = corners_of(rings_a), of_b = corners_of(rings_b);
  double nearest = std::numeric_limits<double>::infinity();
  each_pair(of_a, of_b,
            [&](const Corner&, const Corner&, double gap) { nearest = std::min(nearest, gap); });
  const double most = nearest + 1e-9 * std::max(reach_of(of_a), reach_of(of_b));
  std::optional<Rational> least;
  each_pair(of_a, of_b, [&](const Corner& vertex, const Corner& edge, double gap) {
    if (gap > most) return;
    const Rational square = square_to(*vertex.exact, edge);
    if (!least || square < *least) least = square;
  });
  return *least;
}

Rational square_apart(const Solid& a, const Solid& b) {
  std::optional<Rational> least;
  for (const Slab& one : a.slabs()) {
    for (const Slab& other : b.slabs()) {
      const Rational up = std::max(
          {Rational(0), Rational(one.floor - other.ceiling), Rational(other.floor - one.ceiling)});
      const Rational square = up * up + square_apart(one.region, other.region);
      if (!least || square < *least) least = square;
    }
  }
  return *least;
}

}  // namespace rtac::geometry
