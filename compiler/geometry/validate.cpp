// One sweep over all edges tells that they are in order, in n log n steps whatever they are. Only
// when they are not, the first problem is searched, so that it can be named: sweeps over ever other
// starts of the list find the first edge that meets one before it. Rings that only touch one
// another in points are told there, too.
#include "compiler/geometry/validate.h"

#include <algorithm>
#include <utility>

#include "compiler/geometry/ring.h"
#include "compiler/geometry/runs.h"
#include "compiler/geometry/sweep.h"
#include "compiler/geometry/touches.h"

namespace rtac::geometry {
namespace {

using Kind = Problem::Kind;
using Rings = std::vector<const Ring*>;

std::optional<Problem> find_short_ring(const Rings& rings) {
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Ring& ring = *rings[r];
    if (ring.empty()) return Problem{Kind::too_short, r, 0, 0, Point{}};
    const auto is_new = [&](const Point& p) { return !same(p, ring[0]); };
    const auto second = std::find_if(ring.begin(), ring.end(), is_new);
    const bool three = std::any_of(second, ring.end(),
                                   [&](const Point& p) { return is_new(p) && !same(p, *second); });
    if (!three) return Problem{Kind::too_short, r, 0, 0, ring[0]};
  }
  return std::nullopt;
}

std::optional<Problem> find_repeated_vertex(const Edges& edges, const Rings& rings) {
  for (std::size_t r = 0; r < rings.size(); ++r) {
    std::vector<std::pair<std::uint32_t, std::size_t>> ranks;
    for (std::size_t i = 0; i < rings[r]->size(); ++i) {
      ranks.emplace_back(edges[edges.first(r) + i].rank_a, i);
    }
    std::sort(ranks.begin(), ranks.end());
    std::optional<Problem> first;
    for (std::size_t k = 1, start = 0; k < ranks.size(); ++k) {
      if (ranks[k].first != ranks[start].first) {
        start = k;
      } else if (!first || ranks[k].second < first->vertex) {
        first = Problem{Kind::repeats_vertex, r, ranks[k].second, ranks[start].second,
                        (*rings[r])[ranks[k].second]};
      }
    }
    if (first) return first;
  }
  return std::nullopt;
}

bool on_one_line(const Ring& ring) {
  return std::all_of(ring.begin(), ring.end(),
                     [&](const Point& p) { return orientation(ring[0], ring[1], p) == 0; });
}

// The last item of the shortest start of [from, to) that is out of order; all of it is.
template <typename OutOfOrder>
std::size_t culprit(std::size_t from, std::size_t to, OutOfOrder out_of_order) {
  std::size_t good = from;
  while (to - good > 1) {
    const std::size_t middle = good + (to - good) / 2;
    (out_of_order(middle) ? to : good) = middle;
  }
  return to - 1;
}

std::optional<Problem> find_crossing(const Edges& edges, std::size_t ring) {
  const std::size_t from = edges.first(ring), to = from + edges.size(ring);
  if (!sweep(edges, from, to).meet) return std::nullopt;
  const std::size_t f =
      culprit(from, to, [&](std::size_t end) { return sweep(edges, from, end).meet; });
  for (std::size_t e = from; e < f; ++e) {
    if (const auto where = edges.meeting(edges[e], edges[f])) {
      return Problem{Kind::self_intersects, ring, edges[e].index, edges[f].index, *where};
    }
  }
  return std::nullopt;
}

std::optional<Problem> find_degenerate(const Edges& edges, const Rings& rings) {
  // A ring on one line would always intersect itself; that it has no area is the better reason.
  std::optional<Problem> flat;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (on_one_line(*rings[r])) {
      if (!flat) flat = Problem{Kind::no_area, r, 0, 0, rings[r]->front()};
    } else if (auto problem = find_crossing(edges, r)) {
      return problem;
    }
  }
  return flat;
}

// How the rings of a polygon lie to one another, each of them being simple.
class Neighbours {
 public:
  Neighbours(const Edges& edges, const Rings& rings) : edges_(edges), outer_(*rings[0]) {
    for (std::size_t r = 0; r < rings.size(); ++r) {
      runs_.emplace_back(edges, edges.first(r), edges.first(r) + edges.size(r));
      counter_clockwise_.push_back(twice_area(*rings[r]) > 0);
    }
  }

  std::optional<Problem> hole_outside() {
    for (std::size_t r = 1; r < runs_.size(); ++r) {
      const std::size_t touches = touches_.size();
      if (auto met = clash(r, 0)) return beyond(r, std::move(*met));
      // Where no edges meet, one vertex speaks for the whole ring.
      if (touches_.size() == touches && !encloses(0, r)) {
        return Problem{Kind::hole_outside_ring, r, 0, 0, first_vertex(r)};
      }
    }
    return std::nullopt;
  }

  std::optional<Problem> overlap() {
    for (std::size_t s = 2; s < runs_.size(); ++s) {
      for (std::size_t r = 1; r < s; ++r) {
        if (auto problem = overlap(r, s)) return problem;
      }
    }
    return std::nullopt;
  }

  std::optional<Problem> cut() {
    const Touch* touch = first_cut(runs_.size(), touches_);
    if (touch == nullptr) return std::nullopt;
    return Problem{Kind::cuts_area, touch->other, touch->edge, touch->ring, touch->at};
  }

 private:
  struct Meeting {
    std::size_t edge, other_edge;
    Point where;
  };

  // Of the hole that clashes with the outer ring: the first vertex outside. Before the clash all
  // vertices are on one side, so that it is vertex 0 or an end of the edge; or the vertex behind,
  // of an edge that ends on the outer ring.
  [[nodiscard]] Problem beyond(std::size_t r, Meeting met) const {
    const std::size_t size = edges_.size(r), end = (met.edge + 1) % size;
    for (const std::size_t vertex : {std::size_t{0}, met.edge, end, (end + 1) % size}) {
      const Point& at = *edges_[edges_.first(r) + vertex].a;
      if (locate(at, outer_) != Side::outside) continue;
      return Problem{Kind::hole_outside_ring, r, vertex, 0, at};
    }
    return Problem{Kind::hole_outside_ring, r,   met.edge, met.other_edge,
                   std::move(met.where),    true};
  }
  [[nodiscard]] const Edge& first_edge(std::size_t ring) const {
    return edges_[edges_.first(ring)];
  }
  [[nodiscard]] const Point& first_vertex(std::size_t ring) const { return *first_edge(ring).a; }
  [[nodiscard]] bool encloses(std::size_t outer, std::size_t ring) const {
    return runs_[outer].enclose(first_edge(ring));
  }

  // The edges meet in a point alone, and the hole of `e` stays inside the outer ring, or beside the
  // other hole, there.
  [[nodiscard]] bool only_touch(const Edge& e, const Edge& f, const Point& at) const {
    const Leaves from_other = leaves(edges_, e, f, counter_clockwise_[f.ring], at);
    if (f.ring == 0) return from_other == Leaves::inwards;
    return from_other == Leaves::outwards &&
           leaves(edges_, f, e, counter_clockwise_[e.ring], at) == Leaves::outwards;
  }
  // The first edge of hole `r` that meets an edge of the other ring otherwise than by a touch.
  std::optional<Meeting> clash(std::size_t r, std::size_t other) {
    std::optional<Meeting> found;
    for (std::size_t i = 0; i < edges_.size(r) && !found; ++i) {
      const Edge& e = edges_[edges_.first(r) + i];
      runs_[other].for_each_meeting(e, [&](const Edge& f, const Point& at) {
        if (only_touch(e, f, at)) {
          touches_.push_back({std::min(r, other), std::max(r, other), r > other ? i : f.index, at});
        } else {
          found = Meeting{i, f.index, at};
        }
        return !found;
      });
    }
    return found;
  }
  std::optional<Problem> overlap(std::size_t r, std::size_t s) {
    if (runs_[r].apart(runs_[s])) return std::nullopt;
    const std::size_t touches = touches_.size();
    if (auto met = clash(r, s)) {
      return Problem{Kind::holes_overlap, r, met->edge, s, std::move(met->where), true};
    }
    if (touches_.size() > touches) return std::nullopt;
    if (encloses(s, r)) return Problem{Kind::holes_overlap, r, 0, s, first_vertex(r)};
    if (encloses(r, s)) return Problem{Kind::holes_overlap, r, 0, s, first_vertex(s)};
    return std::nullopt;
  }

  const Edges& edges_;
  const Ring& outer_;
  std::vector<Runs> runs_;
  std::vector<bool> counter_clockwise_;
  std::vector<Touch> touches_;
};

// No edges meet, and every hole lies in the outer ring and in nothing else.
bool in_order(const Edges& edges, const Rings& rings) {
  const Swept swept = sweep(edges, 0, edges.first(rings.size() - 1) + rings.back()->size());
  return !swept.meet && swept.parents[0] == no_ring &&
         std::all_of(swept.parents.begin() + 1, swept.parents.end(),
                     [](std::size_t parent) { return parent == 0; });
}

}  // namespace

std::optional<Problem> find_problem(const Ring& outer, const std::vector<Ring>& holes) {
  Rings rings{&outer};
  for (const Ring& hole : holes) rings.push_back(&hole);
  if (auto problem = find_short_ring(rings)) return problem;
  const Edges edges(rings);
  if (auto problem = find_repeated_vertex(edges, rings)) return problem;
  if (in_order(edges, rings)) return std::nullopt;
  if (auto problem = find_degenerate(edges, rings)) return problem;
  Neighbours neighbours(edges, rings);
  if (auto problem = neighbours.hole_outside()) return problem;
  if (auto problem = neighbours.overlap()) return problem;
  return neighbours.cut();
}

}  // namespace rtac::geometry
