// Shamos and Hoey, "Geometric intersection problems", 1976: a vertical line moves to the right; the
// edges that it meets are kept in order from below. As long as no two edges meet, that order does
// not change, and two edges that meet first are neighbours in it before they do. Points with equal
// x are ordered by y, as if the line leaned a little, so that vertical edges need no rule of their
// own. At a point edges start before others end there, so that all edges at the point have been
// neighbours.
#include "compiler/geometry/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "compiler/geometry/ring.h"

namespace rtac::geometry {
namespace {

// get_d truncates towards zero: one step to either side contains the exact values.
Bounds bounds(double a, double b) {
  const double infinity = std::numeric_limits<double>::infinity();
  return {std::nextafter(std::min(a, b), -infinity), std::nextafter(std::max(a, b), infinity)};
}

// Two edges of one ring that follow each other intersect only when the second runs back along the
// first.
std::optional<Point> spike(const Edge& first, const Edge& second) {
  const Point& tip = *first.b;
  if (orientation(*first.a, tip, *second.b) != 0) return std::nullopt;
  const Rational forward =
      (tip.x - first.a->x) * (second.b->x - tip.x) + (tip.y - first.a->y) * (second.b->y - tip.y);
  return forward < 0 ? std::optional<Point>(tip) : std::nullopt;
}

}  // namespace

Edges::Edges(const std::vector<const Ring*>& rings) {
  // Relative to a vertex, doubles are as fine as the extent allows, wherever the rings lie.
  const auto some =
      std::find_if(rings.begin(), rings.end(), [](const Ring* r) { return !r->empty(); });
  const Point origin = some == rings.end() ? Point{} : (*some)->front();
  for (const Ring* ring : rings) add_ring(*ring, origin);
  rank_vertices();
  // With coordinates up to m, rounded by m 2^-52 each, differences are off by at most
  // 4 m 2^-52, products of them by 17 m^2 2^-52, and their difference by less than 40 m^2 2^-52.
  double most = 0;
  for (const Edge& e : edges_) {
    most = std::max({most, std::abs(e.x.lo), std::abs(e.x.hi), std::abs(e.y.lo), std::abs(e.y.hi)});
  }
  error_ = 64 * most * most * std::numeric_limits<double>::epsilon();
}

void Edges::add_ring(const Ring& ring, const Point& origin) {
  std::vector<double> x, y;
  for (const Point& p : ring) {
    x.push_back(Rational(p.x - origin.x).get_d());
    y.push_back(Rational(p.y - origin.y).get_d());
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t next = (i + 1) % ring.size();
    edges_.push_back({&ring[i], &ring[next], first_.size() - 1, i, bounds(x[i], x[next]),
                      bounds(y[i], y[next]), x[i], y[i], x[next], y[next], 0, 0});
  }
  first_.push_back(edges_.size());
}

void Edges::rank_vertices() {
  std::vector<std::size_t> order(edges_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto compare = [&](std::size_t i, std::size_t j) {
    const int by_x = cmp(edges_[i].a->x, edges_[j].a->x);
    return by_x != 0 ? by_x : cmp(edges_[i].a->y, edges_[j].a->y);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return compare(i, j) < 0; });
  std::uint32_t rank = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k > 0 && compare(order[k - 1], order[k]) != 0) ++rank;
    edges_[order[k]].rank_a = rank;
  }
  for (std::size_t r = 0; r < rings(); ++r) {
    for (std::size_t i = 0; i < size(r); ++i) {
      edges_[first(r) + i].rank_b = edges_[first(r) + (i + 1) % size(r)].rank_a;
    }
  }
}

int Edges::side(const Edge& e, const Edge& v, bool second_end) const {
  const std::uint32_t rank = second_end ? v.rank_b : v.rank_a;
  if (rank == e.rank_a || rank == e.rank_b) return 0;
  const double px = second_end ? v.bx : v.ax;
  const double py = second_end ? v.by : v.ay;
  const double det = (e.bx - e.ax) * (py - e.ay) - (e.by - e.ay) * (px - e.ax);
  if (det > error_) return 1;
  if (det < -error_) return -1;
  return orientation(*e.a, *e.b, second_end ? *v.b : *v.a);
}

// Both ends of `e` are certainly on one side of the line of `f`.
bool Edges::beside(const Edge& e, const Edge& f) const {
  const double dx = f.bx - f.ax;
  const double dy = f.by - f.ay;
  const double side_a = dx * (e.ay - f.ay) - dy * (e.ax - f.ax);
  const double side_b = dx * (e.by - f.ay) - dy * (e.bx - f.ax);
  return std::min(side_a, side_b) > error_ || std::max(side_a, side_b) < -error_;
}

std::optional<Point> Edges::meeting(const Edge& e, const Edge& f) const {
  if (disjoint(e.x, f.x) || disjoint(e.y, f.y) || beside(e, f) || beside(f, e)) return std::nullopt;
  if (e.ring == f.ring) {
    if ((e.index + 1) % size(e.ring) == f.index) return spike(e, f);
    if ((f.index + 1) % size(f.ring) == e.index) return spike(f, e);
  }
  return common_point(e, f);
}

std::optional<Point> Edges::common_point(const Edge& e, const Edge& f) const {
  const int a_side = side(f, e, false), b_side = side(f, e, true);
  const int c_side = side(e, f, false), d_side = side(e, f, true);
  if (a_side * b_side < 0 && c_side * d_side < 0) {
    const Rational from_a = cross(*f.a, *f.b, *e.a);
    const Rational share = from_a / (from_a - cross(*f.a, *f.b, *e.b));
    return Point{e.a->x + share * (e.b->x - e.a->x), e.a->y + share * (e.b->y - e.a->y)};
  }
  // Otherwise a common point, if any, includes an end point of one of them.
  const Point* lowest = nullptr;
  const auto consider = [&](const Point& p, int side_of_p, const Edge& on) {
    if (side_of_p != 0 || !within_bounds(p, *on.a, *on.b)) return;
    if (lowest == nullptr || lower_left(p, *lowest)) lowest = &p;
  };
  consider(*e.a, a_side, f);
  consider(*e.b, b_side, f);
  consider(*f.a, c_side, e);
  consider(*f.b, d_side, e);
  return lowest != nullptr ? std::optional(*lowest) : std::nullopt;
}

namespace {

// Which of two edges on the line is the lower one. Edges on one line meet; they only have to be
// neighbours.
class Below {
 public:
  Below(const Edges& edges, std::uint64_t& comparisons)
      : edges_(&edges), comparisons_(&comparisons) {}
  bool operator()(const Edge* e, const Edge* f) const {
    ++*comparisons_;
    const bool e_later = left_rank(*e) >= left_rank(*f);
    const int side = e_later ? above(*f, *e) : -above(*e, *f);
    return side != 0 ? side < 0 : e < f;
  }

 private:
  static std::uint32_t left_rank(const Edge& e) { return std::min(e.rank_a, e.rank_b); }
  // +1: `later`, which starts at or after the start of `e`, lies above it.
  [[nodiscard]] int above(const Edge& e, const Edge& later) const {
    int side = edges_->side(e, later, !later.rising());
    if (side == 0) side = edges_->side(e, later, later.rising());
    return e.rising() ? side : -side;
  }

  const Edges* edges_;
  std::uint64_t* comparisons_;
};

struct Event {
  std::uint32_t rank;
  bool ends;
  const Edge* edge;
};

class Sweep {
 public:
  Sweep(const Edges& edges, std::size_t from, std::size_t to)
      : edges_(edges), from_(from), line_(Below(edges, comparisons_)), at_(to - from, line_.end()) {
    for (std::size_t i = from; i < to; ++i) {
      const Edge& e = edges[i];
      events_.push_back({std::min(e.rank_a, e.rank_b), false, &e});
      events_.push_back({std::max(e.rank_a, e.rank_b), true, &e});
    }
    std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
      if (a.rank != b.rank) return a.rank < b.rank;
      return a.ends != b.ends ? b.ends : a.edge < b.edge;
    });
  }

  Swept run() {
    parents_.assign(edges_.rings(), no_ring);
    seen_.assign(edges_.rings(), false);
    counter_clockwise_.assign(edges_.rings(), false);
    const bool meets = std::any_of(events_.begin(), events_.end(), [&](const Event& event) {
      return event.ends ? meet_at_end(*event.edge) : meet_at_start(*event.edge);
    });
    if (meets) parents_.clear();
    return {meets, std::move(parents_), comparisons_};
  }

 private:
  using Line = std::set<const Edge*, Below>;

  [[nodiscard]] bool meet(Line::iterator lower, Line::iterator upper) const {
    return edges_.meeting(**lower, **upper).has_value();
  }

  bool meet_at_start(const Edge& e) {
    // An edge without length: a vertex that repeats the one before it.
    if (e.rank_a == e.rank_b) return true;
    const auto it = line_.insert(&e).first;
    at_[index(e)] = it;
    if (it != line_.begin() && meet(std::prev(it), it)) return true;
    if (std::next(it) != line_.end() && meet(it, std::next(it))) return true;
    if (!seen_[e.ring]) enter_ring(e, it);
    return false;
  }

  bool meet_at_end(const Edge& e) {
    const auto after = line_.erase(at_[index(e)]);
    return after != line_.begin() && after != line_.end() && meet(std::prev(after), after);
  }

  // At the leftmost vertex of a ring: what lies below tells what is around it.
  void enter_ring(const Edge& e, Line::iterator it) {
    seen_[e.ring] = true;
    // The interior is above the lower one of the two edges that start here.
    const std::size_t n = edges_.size(e.ring);
    const std::size_t before = e.rising() ? (e.index + n - 1) % n : (e.index + 1) % n;
    const Edge& partner = edges_[edges_.first(e.ring) + before];
    const bool lower = line_.key_comp()(&e, &partner);
    counter_clockwise_[e.ring] = lower == e.rising();
    if (it == line_.begin()) return;
    const Edge& below = **std::prev(it);
    parents_[e.ring] =
        counter_clockwise_[below.ring] == below.rising() ? below.ring : parents_[below.ring];
  }

  [[nodiscard]] std::size_t index(const Edge& e) const {
    return edges_.first(e.ring) + e.index - from_;
  }

  const Edges& edges_;
  std::size_t from_;
  std::uint64_t comparisons_ = 0;
  std::vector<Event> events_;
  Line line_;
  std::vector<Line::iterator> at_;  // by edge
  std::vector<std::size_t> parents_;
  std::vector<bool> seen_, counter_clockwise_;
};

}  // namespace

Swept sweep(const Edges& edges, std::size_t from, std::size_t to) {
  return Sweep(edges, from, to).run();
}

}  // namespace rtac::geometry
