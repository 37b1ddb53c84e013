// One sweep over all edges tells that they are in order, in n log n steps whatever they are. Only
// when they are not, the first problem is searched, so that it can be named: sweeps over ever other
// starts of the list find the first edge that meets one before it.
#include "compiler/geometry/validate.h"

#include <algorithm>
#include <utility>

#include "compiler/geometry/ring.h"
#include "compiler/geometry/sweep.h"

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

// Runs of edges that follow each other, with the box around each run.
class Runs {
 public:
  Runs(const Edges& edges, std::size_t ring) : edges_(edges) {
    const std::size_t to = edges.first(ring) + edges.size(ring);
    for (std::size_t from = edges.first(ring); from < to; from += run_size) {
      Run run{from, std::min(from + run_size, to), edges[from].x, edges[from].y};
      for (std::size_t i = from; i < run.to; ++i) {
        run.x = around(run.x, edges[i].x);
        run.y = around(run.y, edges[i].y);
      }
      runs_.push_back(run);
      x_ = runs_.size() == 1 ? run.x : around(x_, run.x);
      y_ = runs_.size() == 1 ? run.y : around(y_, run.y);
    }
  }

  [[nodiscard]] bool apart(const Runs& other) const {
    return disjoint(x_, other.x_) || disjoint(y_, other.y_);
  }
  // The first edge that meets `e`, and where.
  [[nodiscard]] std::optional<std::pair<std::size_t, Point>> meeting(const Edge& e) const {
    for (const Run& run : runs_) {
      if (disjoint(e.x, run.x) || disjoint(e.y, run.y)) continue;
      for (std::size_t i = run.from; i < run.to; ++i) {
        if (auto where = edges_.meeting(e, edges_[i])) return std::pair{edges_[i].index, *where};
      }
    }
    return std::nullopt;
  }
  // The start of `v` lies inside the ring; not on it.
  [[nodiscard]] bool enclose(const Edge& v) const {
    bool inside = false;
    for (const Run& run : runs_) {
      if (disjoint(v.y, run.y) || run.x.hi < v.x.lo) continue;
      for (std::size_t i = run.from; i < run.to; ++i) {
        inside ^= is_crossed(edges_[i], v);
      }
    }
    return inside;
  }

 private:
  static constexpr std::size_t run_size = 64;
  struct Run {
    std::size_t from, to;
    Bounds x, y;
  };
  static Bounds around(const Bounds& a, const Bounds& b) {
    return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
  }
  // By the ray from the start of `v` to the right. An edge owns its lower end only.
  [[nodiscard]] bool is_crossed(const Edge& e, const Edge& v) const {
    const bool a_below = e.a->y <= v.a->y;
    return a_below != (e.b->y <= v.a->y) && edges_.side(e, v, false) == (a_below ? 1 : -1);
  }

  const Edges& edges_;
  std::vector<Run> runs_;
  Bounds x_{0, 0}, y_{0, 0};
};

// The first edge of `ring` that meets an edge of the other ring.
struct Meeting {
  std::size_t edge, other_edge;
  Point where;
};
std::optional<Meeting> first_meeting(const Edges& edges, std::size_t ring, const Runs& other) {
  for (std::size_t i = 0; i < edges.size(ring); ++i) {
    if (auto met = other.meeting(edges[edges.first(ring) + i])) {
      return Meeting{i, met->first, std::move(met->second)};
    }
  }
  return std::nullopt;
}

// All rings are simple by now.
std::optional<Problem> find_hole_outside(const Edges& edges, const Rings& rings) {
  const Runs outer(edges, 0);
  for (std::size_t r = 1; r < rings.size(); ++r) {
    if (auto met = first_meeting(edges, r, outer)) {
      return Problem{Kind::hole_outside_ring, r, met->edge, met->other_edge, std::move(met->where)};
    }
    // Where no edges meet, one vertex speaks for the whole ring.
    if (!outer.enclose(edges[edges.first(r)])) {
      return Problem{Kind::hole_outside_ring, r, 0, 0, rings[r]->front()};
    }
  }
  return std::nullopt;
}

// Of two holes, `second` being the runs of ring `s`.
std::optional<Problem> overlap(const Edges& edges, const Rings& rings, std::size_t r, std::size_t s,
                               const Runs& second) {
  const Runs first(edges, r);
  if (first.apart(second)) return std::nullopt;
  if (auto met = first_meeting(edges, r, second)) {
    return Problem{Kind::holes_overlap, r, met->edge, s, std::move(met->where)};
  }
  if (second.enclose(edges[edges.first(r)])) {
    return Problem{Kind::holes_overlap, r, 0, s, rings[r]->front()};
  }
  if (first.enclose(edges[edges.first(s)])) {
    return Problem{Kind::holes_overlap, r, 0, s, rings[s]->front()};
  }
  return std::nullopt;
}

// The holes before ring `end` neither meet nor enclose one another.
bool are_apart(const Edges& edges, std::size_t end) {
  const Swept swept = sweep(edges, edges.first(1), edges.first(end));
  return !swept.meet && std::all_of(swept.parents.begin(), swept.parents.end(),
                                    [](std::size_t parent) { return parent == no_ring; });
}

std::optional<Problem> find_overlap(const Edges& edges, const Rings& rings) {
  if (rings.size() < 2 || are_apart(edges, rings.size())) return std::nullopt;
  const std::size_t s =
      culprit(1, rings.size(), [&](std::size_t end) { return !are_apart(edges, end); });
  const Runs second(edges, s);
  for (std::size_t r = 1; r < s; ++r) {
    if (auto problem = overlap(edges, rings, r, s, second)) return problem;
  }
  return std::nullopt;
}

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
  if (auto problem = find_hole_outside(edges, rings)) return problem;
  return find_overlap(edges, rings);
}

}  // namespace rtac::geometry
