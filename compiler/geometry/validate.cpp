// Exact throughout. Doubles only skip pairs of edges that are certainly apart: by their rounded-out
// boxes, then by the side of a line with a bound on the rounding error. A sweep over x keeps that
// near n log n for the outlines that occur, and at worst n^2 comparisons of doubles (10,000
// vertices: a fraction of a second). Unlike a library test for simplicity it names
// both edges and the meeting point.
#include "compiler/geometry/validate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "compiler/geometry/ring.h"

namespace rtac::geometry {
namespace {

struct Bounds {
  double lo, hi;
};

// get_d truncates towards zero: one step to either side contains the exact values.
Bounds bounds(const Rational& a, const Rational& b) {
  const double x = a.get_d();
  const double y = b.get_d();
  const double infinity = std::numeric_limits<double>::infinity();
  return {std::nextafter(std::min(x, y), -infinity), std::nextafter(std::max(x, y), infinity)};
}

struct Edge {
  const Point* a;
  const Point* b;
  std::size_t ring, index;
  Bounds x, y;
  double ax, ay, bx, by;
};

// Both ends of `e` are certainly on one side of the line of `f`. `error` bounds the error of the
// products below.
bool beside(const Edge& e, const Edge& f, double error) {
  const double dx = f.bx - f.ax;
  const double dy = f.by - f.ay;
  const double side_a = dx * (e.ay - f.ay) - dy * (e.ax - f.ax);
  const double side_b = dx * (e.by - f.ay) - dy * (e.bx - f.ax);
  return std::min(side_a, side_b) > error || std::max(side_a, side_b) < -error;
}

bool disjoint(const Bounds& a, const Bounds& b) {
  return a.hi < b.lo || b.hi < a.lo;
}

// The lowest-left common point of two closed segments.
std::optional<Point> meeting_point(const Edge& e, const Edge& f) {
  const int a_side = orientation(*f.a, *f.b, *e.a);
  const int b_side = orientation(*f.a, *f.b, *e.b);
  if (a_side * b_side < 0 && orientation(*e.a, *e.b, *f.a) * orientation(*e.a, *e.b, *f.b) < 0) {
    const Rational from_a = cross(*f.a, *f.b, *e.a);
    const Rational share = from_a / (from_a - cross(*f.a, *f.b, *e.b));
    return Point{e.a->x + share * (e.b->x - e.a->x), e.a->y + share * (e.b->y - e.a->y)};
  }
  // Otherwise a common point, if any, includes an end point of one of them.
  std::optional<Point> lowest;
  const auto consider = [&](const Point& p, const Edge& on) {
    if (on_segment(p, *on.a, *on.b) && (!lowest || lower_left(p, *lowest))) lowest = p;
  };
  consider(*e.a, f);
  consider(*e.b, f);
  consider(*f.a, e);
  consider(*f.b, e);
  return lowest;
}

// Two edges of one ring that follow each other share a vertex; they intersect only when the
// second runs back along the first (a spike).
std::optional<Point> spike(const Edge& first, const Edge& second) {
  const Point& tip = *first.b;
  if (orientation(*first.a, tip, *second.b) != 0) return std::nullopt;
  const Rational forward =
      (tip.x - first.a->x) * (second.b->x - tip.x) + (tip.y - first.a->y) * (second.b->y - tip.y);
  return forward < 0 ? std::optional<Point>(tip) : std::nullopt;
}

std::optional<Point> self_meeting(const Edge& e, const Edge& f, std::size_t ring_size) {
  if ((e.index + 1) % ring_size == f.index) return spike(e, f);
  if ((f.index + 1) % ring_size == e.index) return spike(f, e);
  return meeting_point(e, f);
}

bool on_one_line(const Ring& ring) {
  return std::all_of(ring.begin(), ring.end(),
                     [&](const Point& p) { return orientation(ring[0], ring[1], p) == 0; });
}

using Rings = std::vector<const Ring*>;

std::vector<Edge> edges_by_x(const Rings& rings) {
  std::vector<Edge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Ring& ring = *rings[r];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& a = ring[i];
      const Point& b = ring[(i + 1) % ring.size()];
      edges.push_back({&a, &b, r, i, bounds(a.x, b.x), bounds(a.y, b.y), a.x.get_d(), a.y.get_d(),
                       b.x.get_d(), b.y.get_d()});
    }
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const Edge& a, const Edge& b) { return a.x.lo < b.x.lo; });
  return edges;
}

// Calls visit(e, f), e before f in the order of rings and vertices, for every two edges that may
// meet.
template <typename Visit>
void for_each_near_pair(const std::vector<Edge>& edges, Visit visit) {
  // With coordinates up to m, rounded by m 2^-52 each, differences are off by at most
  // 4 m 2^-52, products of them by 17 m^2 2^-52, and their difference by less than 40 m^2 2^-52.
  double most = 0;
  for (const Edge& e : edges)
    most = std::max({most, std::abs(e.x.lo), std::abs(e.x.hi), std::abs(e.y.lo), std::abs(e.y.hi)});
  const double error = 64 * most * most * std::numeric_limits<double>::epsilon();
  std::vector<const Edge*> active;
  for (const Edge& edge : edges) {
    std::erase_if(active, [&](const Edge* other) { return other->x.hi < edge.x.lo; });
    for (const Edge* other : active) {
      if (disjoint(edge.y, other->y) || beside(edge, *other, error) ||
          beside(*other, edge, error)) {
        continue;
      }
      const bool in_order = std::tie(other->ring, other->index) < std::tie(edge.ring, edge.index);
      visit(in_order ? *other : edge, in_order ? edge : *other);
    }
    active.push_back(&edge);
  }
}

std::optional<Problem> find_short_ring(const Rings& rings) {
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Ring& ring = *rings[r];
    std::size_t different = 0;
    for (std::size_t i = 0; i < ring.size() && different < 3; ++i) {
      const auto before = ring.begin() + static_cast<std::ptrdiff_t>(i);
      if (std::none_of(ring.begin(), before, [&](const Point& p) { return same(p, ring[i]); })) {
        ++different;
      }
    }
    if (different < 3) {
      return Problem{Problem::Kind::too_short, r, 0, 0, ring.empty() ? Point{} : ring[0]};
    }
  }
  return std::nullopt;
}

std::optional<Problem> find_repeated_vertex(const Rings& rings) {
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Ring& ring = *rings[r];
    std::map<Point, std::size_t, decltype(&lower_left)> seen(&lower_left);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto [first, added] = seen.emplace(ring[i], i);
      if (!added) return Problem{Problem::Kind::repeats_vertex, r, i, first->second, ring[i]};
    }
  }
  return std::nullopt;
}

bool precedes(const Problem& a, const Problem& b) {
  return std::tie(a.ring, a.vertex, a.other) < std::tie(b.ring, b.vertex, b.other);
}

void keep_first(std::optional<Problem>& first, const Problem& problem) {
  if (!first || precedes(problem, *first)) first = problem;
}

std::optional<Problem> find_degenerate(const Rings& rings, const std::vector<Edge>& edges) {
  // A ring on one line would always intersect itself; that it has no area is the better reason.
  std::vector<bool> flat(rings.size());
  for (std::size_t r = 0; r < rings.size(); ++r) flat[r] = on_one_line(*rings[r]);
  std::optional<Problem> first;
  for_each_near_pair(edges, [&](const Edge& e, const Edge& f) {
    if (e.ring != f.ring || flat[e.ring]) return;
    if (const auto where = self_meeting(e, f, rings[e.ring]->size())) {
      keep_first(first, {Problem::Kind::self_intersects, e.ring, e.index, f.index, *where});
    }
  });
  if (first) return first;
  const auto ring = std::find(flat.begin(), flat.end(), true);
  if (ring == flat.end()) return std::nullopt;
  const auto r = static_cast<std::size_t>(ring - flat.begin());
  return Problem{Problem::Kind::no_area, r, 0, 0, rings[r]->front()};
}

// All rings are simple by now.
std::optional<Problem> find_misplaced_hole(const Rings& rings, const std::vector<Edge>& edges) {
  std::optional<Problem> outside;
  std::optional<Problem> overlap;
  for_each_near_pair(edges, [&](const Edge& e, const Edge& f) {
    if (e.ring == f.ring) return;
    const auto where = meeting_point(e, f);
    if (!where) return;
    if (e.ring == 0) {
      keep_first(outside, {Problem::Kind::hole_outside_ring, f.ring, f.index, e.index, *where});
    } else if (!overlap || std::tie(e.ring, f.ring, e.index) <
                               std::tie(overlap->ring, overlap->other, overlap->vertex)) {
      overlap = Problem{Problem::Kind::holes_overlap, e.ring, e.index, f.ring, *where};
    }
  });
  // Where no edges meet, one vertex speaks for the whole ring.
  for (std::size_t r = 1; r < rings.size() && (!outside || outside->ring > r); ++r) {
    const Point& p = rings[r]->front();
    if (locate(p, *rings[0]) == Side::outside) {
      keep_first(outside, {Problem::Kind::hole_outside_ring, r, 0, 0, p});
    }
  }
  if (outside) return outside;
  for (std::size_t r = 1; r < rings.size(); ++r) {
    for (std::size_t s = r + 1; s < rings.size(); ++s) {
      if (overlap && std::tie(overlap->ring, overlap->other) <= std::tie(r, s)) return overlap;
      const Point& p = rings[r]->front();
      const Point& q = rings[s]->front();
      if (locate(p, *rings[s]) == Side::inside) {
        return Problem{Problem::Kind::holes_overlap, r, 0, s, p};
      }
      if (locate(q, *rings[r]) == Side::inside) {
        return Problem{Problem::Kind::holes_overlap, r, 0, s, q};
      }
    }
  }
  return overlap;
}

}  // namespace

std::optional<Problem> find_problem(const Ring& outer, const std::vector<Ring>& holes) {
  Rings rings{&outer};
  for (const Ring& hole : holes) rings.push_back(&hole);
  if (auto problem = find_short_ring(rings)) return problem;
  if (auto problem = find_repeated_vertex(rings)) return problem;
  const std::vector<Edge> edges = edges_by_x(rings);
  if (auto problem = find_degenerate(rings, edges)) return problem;
  return holes.empty() ? std::nullopt : find_misplaced_hole(rings, edges);
}

}  // namespace rtac::geometry
