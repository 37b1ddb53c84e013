// Why a candidate that passes is right. No two edges of the old and the new rings meet, and each
// new ring lies next to its old one, on the side that it was moved to (both exactly, by a sweep).
// No old edge comes nearer to a new one than the distance. So the straight way from a place of the
// smaller set out of the larger one crosses a new and an old ring, one of each, and between them it
// has the distance at least. Nor is anything between the rings far from the old ones: new edges
// that begin as the old ones and move straight to their places sweep over all of it, each within
// the hull of where it begins and ends, and its ends are near the edge that it begins as. How the
// candidate was found does not matter.
#include "compiler/geometry/moved.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "compiler/geometry/ring.h"
#include "compiler/geometry/sweep.h"

namespace rtac::geometry {
namespace {

// Doubles of coordinates within 10^6 m are exact within 10^-9 m with all that is computed here; new
// vertices are on a grid of 1 um.
constexpr double coordinates_m_max = 1e6;
constexpr double certain_m = 1e-7;
constexpr double excess_m = 2e-6;
constexpr double um_per_m = 1e6;
// Corners that move farther are left to the thorough way.
constexpr double miter_max = 50;

struct Vector {
  double x, y;
};
Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y};
}
double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y;
}

struct Segment {
  Vector a, b;
};
double distance(const Vector& p, const Segment& s) {
  const Vector d = s.b - s.a, q = p - s.a;
  const double square = dot(d, d);
  const double share = square > 0 ? std::clamp(dot(q, d) / square, 0.0, 1.0) : 0;
  return std::hypot(q.x - share * d.x, q.y - share * d.y);
}
double distance(const Segment& s, const Segment& t) {
  return std::min({distance(s.a, t), distance(s.b, t), distance(t.a, s), distance(t.b, s)});
}

// Boxes around segments, halved again and again: finds those near another one in log n.
class Nearby {
 public:
  explicit Nearby(const std::vector<Segment>& segments) : segments_(segments) {
    order_.resize(segments.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    boxes_.resize(segments.size() * 2);
    if (!segments.empty()) build(0, segments.size(), 0, 0);
  }
  // Does every segment keep that distance from `s`?
  [[nodiscard]] bool keeps(const Segment& s, double distance_m) const {
    return segments_.empty() || keeps(0, segments_.size(), 0, s, distance_m);
  }

 private:
  struct Box {
    double x0, y0, x1, y1;
  };
  static Box box(const Segment& s) {
    return {std::min(s.a.x, s.b.x), std::min(s.a.y, s.b.y), std::max(s.a.x, s.b.x),
            std::max(s.a.y, s.b.y)};
  }
  static std::size_t middle(std::size_t from, std::size_t to) { return from + (to - from) / 2; }

  // The halves of node i are 2 i + 1 and 2 i + 2.
  Box build(std::size_t from, std::size_t to, std::size_t node, int axis) {
    if (node >= boxes_.size()) boxes_.resize(node + 1);
    Box all = box(segments_[order_[from]]);
    for (std::size_t i = from + 1; i < to; ++i) {
      const Box one = box(segments_[order_[i]]);
      all = {std::min(all.x0, one.x0), std::min(all.y0, one.y0), std::max(all.x1, one.x1),
             std::max(all.y1, one.y1)};
    }
    boxes_[node] = all;
    if (to - from <= leaf) return all;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t half = middle(from, to);
    std::nth_element(at(from), at(half), at(to), [&](std::size_t i, std::size_t j) {
      const Segment &s = segments_[i], &t = segments_[j];
      return axis == 0 ? s.a.x + s.b.x < t.a.x + t.b.x : s.a.y + s.b.y < t.a.y + t.b.y;
    });
    build(from, half, 2 * node + 1, 1 - axis);
    build(half, to, 2 * node + 2, 1 - axis);
    return all;
  }
  [[nodiscard]] bool keeps(std::size_t from, std::size_t to, std::size_t node, const Segment& s,
                           double distance_m) const {
    const Box &one = boxes_[node], other = box(s);
    if (one.x0 > other.x1 + distance_m || other.x0 > one.x1 + distance_m ||
        one.y0 > other.y1 + distance_m || other.y0 > one.y1 + distance_m) {
      return true;
    }
    if (to - from <= leaf) {
      for (std::size_t i = from; i < to; ++i) {
        if (distance(segments_[order_[i]], s) < distance_m) return false;
      }
      return true;
    }
    const std::size_t half = middle(from, to);
    return keeps(from, half, 2 * node + 1, s, distance_m) &&
           keeps(half, to, 2 * node + 2, s, distance_m);
  }

  static constexpr std::size_t leaf = 8;
  const std::vector<Segment>& segments_;
  std::vector<std::size_t> order_;
  std::vector<Box> boxes_;
};

class Mover {
 public:
  Mover(const std::vector<PolygonWithHoles>& parts, const Rational& distance,
        const Rational& excess, BandSide side)
      : parts_(parts),
        distance_m_(distance.get_d()),
        farthest_m_(Rational(distance + excess).get_d() - certain_m),
        // the region is on the left of its edges
        left_(side == BandSide::interior) {}

  std::optional<std::vector<PolygonWithHoles>> run() {
    for (const PolygonWithHoles& part : parts_) {
      PolygonWithHoles& moved = moved_.emplace_back();
      if (!move(part.outer, moved.outer)) return std::nullopt;
      for (const Ring& hole : part.holes) {
        if (!move(hole, moved.holes.emplace_back())) return std::nullopt;
      }
    }
    if (!stays_near() || !keeps_distance() || !nests()) return std::nullopt;
    for (PolygonWithHoles& part : moved_) tidy(part);
    std::sort(moved_.begin(), moved_.end(),
              [](const auto& p, const auto& q) { return ring_order(p.outer, q.outer); });
    return std::move(moved_);
  }

 private:
  static Vector of(const Point& p) { return {p.x.get_d(), p.y.get_d()}; }
  static std::vector<Segment> segments(const std::vector<PolygonWithHoles>& parts) {
    std::vector<Segment> all;
    const auto add = [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        all.push_back({of(ring[i]), of(ring[(i + 1) % ring.size()])});
      }
    };
    for (const PolygonWithHoles& part : parts) {
      add(part.outer);
      std::for_each(part.holes.begin(), part.holes.end(), add);
    }
    return all;
  }

  // Every edge moves along its normal; vertices are where neighbours then meet.
  bool move(const Ring& from, Ring& to) const {
    const std::size_t count = from.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Vector before = of(from[(i + count - 1) % count]), at = of(from[i]),
                   after = of(from[(i + 1) % count]);
      const auto place = corner(before, at, after);
      if (!place) return false;
      to.push_back({in_um(place->x), in_um(place->y)});
    }
    return true;
  }
  [[nodiscard]] std::optional<Vector> corner(const Vector& before, const Vector& at,
                                             const Vector& after) const {
    if (std::max(std::abs(at.x), std::abs(at.y)) > coordinates_m_max) return std::nullopt;
    const auto normal = [&](const Vector& edge) {
      const double length = std::hypot(edge.x, edge.y) * (left_ ? 1 : -1);
      return Vector{-edge.y / length, edge.x / length};
    };
    const Vector n = normal(at - before), m = normal(after - at);
    const double by = distance_m_ + excess_m, spread = 1 + dot(n, m);
    // |n + m| / spread is how many times as far as an edge the corner moves
    if (!(spread * miter_max * miter_max > 2)) return std::nullopt;
    return Vector{at.x + by * (n.x + m.x) / spread, at.y + by * (n.y + m.y) / spread};
  }
  static Rational in_um(double metres) {
    Rational value(std::lround(metres * um_per_m), 1'000'000UL);
    value.canonicalize();
    return value;
  }

  // The ends of every edge, of the one that it was.
  [[nodiscard]] bool stays_near() const {
    const std::vector<Segment> before = segments(parts_), now = segments(moved_);
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (std::max(distance(now[i].a, before[i]), distance(now[i].b, before[i])) > farthest_m_) {
        return false;
      }
    }
    return true;
  }
  [[nodiscard]] bool keeps_distance() const {
    const std::vector<Segment> now = segments(moved_);
    const Nearby nearby(now);
    const std::vector<Segment> before = segments(parts_);
    return std::all_of(before.begin(), before.end(),
                       [&](const Segment& s) { return nearby.keeps(s, distance_m_ + certain_m); });
  }

  // Which ring lies in which: outer in outer, hole around hole, or the other way round.
  [[nodiscard]] bool nests() const {
    std::vector<const Ring*> rings;
    std::vector<bool> is_hole;
    for (const auto* parts : {&parts_, &moved_}) {
      for (const PolygonWithHoles& part : *parts) {
        rings.push_back(&part.outer);
        is_hole.push_back(false);
        for (const Ring& hole : part.holes) rings.push_back(&hole);
        is_hole.resize(rings.size(), true);
      }
    }
    const Edges edges(rings);
    const Swept swept = sweep(edges, 0, edges.first(rings.size()));
    if (swept.meet) return false;
    // of the two rings that one has become, from without to within
    const std::size_t count = rings.size() / 2;
    const std::size_t before = left_ ? 0 : count, after = left_ ? count : 0;
    std::size_t smaller = no_ring;
    for (std::size_t ring = 0; ring < count; ++ring) {
      const std::size_t around = ring + (is_hole[ring] ? after : before);
      const std::size_t within = ring + (is_hole[ring] ? before : after);
      const std::size_t parent = swept.parents[around];
      // a part lies in nothing, or in the hole of another one
      const bool fits = is_hole[ring] ? parent == smaller : parent == no_ring || is_hole[parent];
      if (!fits || swept.parents[within] != around) return false;
      if (!is_hole[ring]) smaller = within;
    }
    return true;
  }

  static void tidy(PolygonWithHoles& part) {
    part.outer = canonical(part.outer);
    for (Ring& hole : part.holes) hole = canonical(hole);
    std::sort(part.holes.begin(), part.holes.end(), ring_order);
  }

  const std::vector<PolygonWithHoles>& parts_;
  double distance_m_, farthest_m_;
  bool left_;
  std::vector<PolygonWithHoles> moved_;
};

}  // namespace

std::optional<std::vector<PolygonWithHoles>> moved_at_once(
    const std::vector<PolygonWithHoles>& parts, const Rational& distance, const Rational& excess,
    BandSide side) {
  return Mover(parts, distance, excess, side).run();
}

}  // namespace rtac::geometry
