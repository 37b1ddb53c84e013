// Why a candidate that passes is right. No two edges of the old and the new rings meet, and each
// new ring lies next to its old one, on the side that it was moved to (both exactly, by a sweep).
// No old edge comes nearer to a new one than the distance. So the straight way from a place of the
// smaller set out of the larger one crosses a new and an old ring, one of each, and between them it
// has the distance at least. Nor is anything between the rings far from the old ones: new edges
// that begin as the old ones, or at corners as points, and move straight to their places sweep over
// all of it, each within the hull of where it begins and ends, and its ends are near what it begins
// as. How the candidate was found does not matter.
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
constexpr double pieces_max = 1000;  // of a corner

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

  // Every edge moves along its normal; vertices are where neighbours then meet. Between neighbours
  // that part from each other there are further edges, as many as keep what they meet at near.
  bool move(const Ring& from, Ring& to) {
    const std::size_t count = from.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Vector before = of(from[(i + count - 1) % count]), at = of(from[i]),
                   after = of(from[(i + 1) % count]);
      if (std::max(std::abs(at.x), std::abs(at.y)) > coordinates_m_max) return false;
      const std::size_t size = to.size();
      if (!corner(normal(at - before), normal(after - at), at, to)) return false;
      began_.insert(began_.end(), to.size() - size - 1, Segment{at, at});
      began_.push_back({at, after});
    }
    return true;
  }
  [[nodiscard]] Vector normal(const Vector& edge) const {
    const double length = std::hypot(edge.x, edge.y) * (left_ ? 1 : -1);
    return {-edge.y / length, edge.x / length};
  }
  bool corner(const Vector& n, const Vector& m, const Vector& at, Ring& to) const {
    const double by = distance_m_ + excess_m;
    const double turn = std::atan2(n.x * m.y - n.y * m.x, dot(n, m));
    const bool parts = left_ ? turn < 0 : turn > 0;
    const double half = std::acos(by / (farthest_m_ - excess_m));  // between two edges, at most
    const double pieces = parts ? std::max(1.0, std::ceil(std::abs(turn) / (2 * half))) : 1;
    const double step = turn / pieces;
    // by / cos is how far the corner moves
    if (!(std::cos(step / 2) * miter_max > 1) || !(pieces <= pieces_max)) return false;
    const double far = by / std::cos(step / 2);
    for (double k = 0; k < pieces; ++k) {
      const double angle = std::atan2(n.y, n.x) + (k + 0.5) * step;
      to.push_back({in_um(at.x + far * std::cos(angle)), in_um(at.y + far * std::sin(angle))});
    }
    return true;
  }
  static Rational in_um(double metres) {
    Rational value(std::lround(metres * um_per_m), 1'000'000UL);
    value.canonicalize();
    return value;
  }

  // The ends of every edge, of what it began as.
  [[nodiscard]] bool stays_near() const {
    const std::vector<Segment> now = segments(moved_);
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (std::max(distance(now[i].a, began_[i]), distance(now[i].b, began_[i])) > farthest_m_) {
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
  std::vector<Segment> began_;  // what each edge of them moved from, in their order
};

}  // namespace

std::optional<std::vector<PolygonWithHoles>> moved_at_once(
    const std::vector<PolygonWithHoles>& parts, const Rational& distance, const Rational& excess,
    BandSide side) {
  return Mover(parts, distance, excess, side).run();
}

}  // namespace rtac::geometry
