#include "compiler/geometry/apart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/geometry/nearby.h"

namespace rtac::geometry {
namespace {

// The rings of a region: from each vertex, with its nearest doubles, an edge leads to the next.
struct Corners {
  explicit Corners(const Region& region) : rings(region.rings()) {
    for (const Ring& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
        ends.emplace_back(&p, &q);
        edges.push_back({{p.x.get_d(), p.y.get_d()}, {q.x.get_d(), q.y.get_d()}});
      }
    }
  }
  Corners(const Corners&) = delete;
  Corners& operator=(const Corners&) = delete;
  ~Corners() = default;

  std::vector<Ring> rings;
  std::vector<std::pair<const Point*, const Point*>> ends;
  std::vector<Segment> edges;
};

double reach_of(const Corners& corners) {
  double reach = 1;
  for (const Segment& s : corners.edges) {
    reach = std::max({reach, std::abs(s.a.x), std::abs(s.a.y)});
  }
  return reach;
}

Rational square_to(const Point& p, const Point& a, const Point& b) {
  const Rational dx = b.x - a.x, dy = b.y - a.y;
  const Rational qx = p.x - a.x, qy = p.y - a.y;
  const Rational along = qx * dx + qy * dy, whole = dx * dx + dy * dy;
  const Rational share = std::clamp(Rational(along / whole), Rational(0), Rational(1));
  const Rational x = qx - share * dx, y = qy - share * dy;
  return x * x + y * y;
}

// The least square from a vertex of one to an edge of the other, of those within `most` in doubles.
void shorten(const Corners& one, const Corners& other, const Nearby& edges, double most,
             std::optional<Rational>& least) {
  for (std::size_t i = 0; i < one.edges.size(); ++i) {
    edges.each_within(one.edges[i].a, most, [&](std::size_t k) {
      const auto& [a, b] = other.ends[k];
      const Rational square = square_to(*one.ends[i].first, *a, *b);
      if (!least || square < *least) least = square;
    });
  }
}

}  // namespace

// Of regions that have no area in common the nearest places are a vertex of one and a place of an
// edge of the other. Doubles, off by far less than 10^-9 of the coordinates, say which it may be.
Rational square_apart(const Region& a, const Region& b) {
  if (!a.intersect(b).empty()) return 0;
  const Corners of_a(a), of_b(b);
  const Nearby edges_a(of_a.edges), edges_b(of_b.edges);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment& s : of_a.edges) nearest = edges_b.nearest(s.a, nearest);
  for (const Segment& s : of_b.edges) nearest = edges_a.nearest(s.a, nearest);
  const double most = nearest + 1e-9 * std::max(reach_of(of_a), reach_of(of_b));
  std::optional<Rational> least;
  shorten(of_a, of_b, edges_b, most, least);
  shorten(of_b, of_a, edges_a, most, least);
  return *least;
}

Rational square_apart(const Solid& a, const Solid& b) {
  std::optional<Rational> least;
  for (const Slab& one : a.slabs()) {
    for (const Slab& other : b.slabs()) {
      const Rational up = std::max(
          {Rational(0), Rational(one.floor - other.ceiling), Rational(other.floor - one.ceiling)});
      if (least && up * up >= *least) continue;
      const Rational square = up * up + square_apart(one.region, other.region);
      if (!least || square < *least) least = square;
    }
  }
  return *least;
}

}  // namespace rtac::geometry
