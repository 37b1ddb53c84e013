// Why a candidate that passes is right. No two edges of the old and the new rings meet, and each
// new ring lies next to its old one, on the side that it was moved to (both exactly, by a sweep).
// No old edge comes nearer to a new one than the distance. So the straight way from a place of the
// smaller set out of the larger one crosses a new and an old ring, one of each, and between them it
// has the distance at least. Nor is anything between the rings far from the old ones: new edges
// that begin as the old ones, or at corners as points, and move straight to their places sweep over
// all of it, each within the hull of where it begins and ends, and its ends are near what it begins
// as. An edge that vanishes moves to a point on the way, which is near it, and near the two that it
// is between by then: their ends move there with it, and on from there. How the candidate was found
// does not matter.
#include "compiler/geometry/moved.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "compiler/geometry/nearby.h"
#include "compiler/geometry/ring.h"
#include "compiler/geometry/sweep.h"
#include "compiler/geometry/vanishing.h"

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
constexpr double pieces_max = 2000;  // of a corner

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
    std::vector<MovingEdge> edges;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Vector a = of(from[i]), b = of(from[(i + 1) % from.size()]);
      if (std::max(std::abs(a.x), std::abs(a.y)) > coordinates_m_max) return false;
      edges.push_back({{a, b}, normal(b - a)});
    }
    const auto left = Vanishing(edges, distance_m_ + excess_m, excess_m, 2 * half_part_rad()).run();
    if (!left) return false;
    for (const auto& [before, edge, after, at] : left->events) {
      for (const std::size_t i : {before, edge, after}) vanished_.push_back({at, edges[i].from});
    }
    std::size_t before = left->remaining.back();
    for (const std::size_t edge : left->remaining) {
      const bool fits = (before + 1) % edges.size() == edge
                            ? corner(edges[before], edges[edge], to)
                            : joined(edges[before], edges[edge], to);
      if (!fits) return false;
      before = edge;
    }
    return true;
  }
  // Where two edges meet when those between them have vanished.
  bool joined(const MovingEdge& before, const MovingEdge& after, Ring& to) {
    const auto at = meeting_after(before, after, distance_m_ + excess_m);
    if (!at || std::max(std::abs(at->x), std::abs(at->y)) > coordinates_m_max) return false;
    to.push_back({in_um(at->x), in_um(at->y)});
    began_.push_back(after.from);
    return true;
  }
  [[nodiscard]] Vector normal(const Vector& edge) const {
    const double length = std::hypot(edge.x, edge.y) * (left_ ? 1 : -1);
    return {-edge.y / length, edge.x / length};
  }
  // Half of the most that two edges may part by, so that they meet near enough.
  [[nodiscard]] double half_part_rad() const {
    return std::acos((distance_m_ + excess_m) / (farthest_m_ - excess_m));
  }
  bool corner(const MovingEdge& before, const MovingEdge& after, Ring& to) {
    const Vector &n = before.normal, &m = after.normal, &at = after.from.a;
    const double by = distance_m_ + excess_m;
    const double turn = std::atan2(cross(n, m), dot(n, m));
    const bool parts = left_ ? turn < 0 : turn > 0;
    const double pieces =
        parts ? std::max(1.0, std::ceil(std::abs(turn) / (2 * half_part_rad()))) : 1;
    const double step = turn / pieces;
    // by / cos is how far the corner moves
    if (!(std::cos(step / 2) * miter_max > 1) || !(pieces <= pieces_max)) return false;
    const double far = by / std::cos(step / 2);
    for (double k = 0; k < pieces; ++k) {
      const double angle = std::atan2(n.y, n.x) + (k + 0.5) * step;
      to.push_back({in_um(at.x + far * std::cos(angle)), in_um(at.y + far * std::sin(angle))});
      if (k > 0) began_.push_back({at, at});
    }
    began_.push_back(after.from);
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
    return std::all_of(vanished_.begin(), vanished_.end(), [&](const Vanished& each) {
      return distance(each.to, each.from) <= farthest_m_;
    });
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
  // Edges that vanish move to a point first, and with them an end of the two that they were
  // between.
  struct Vanished {
    Vector to;
    Segment from;
  };
  std::vector<Vanished> vanished_;
};

}  // namespace

std::optional<std::vector<PolygonWithHoles>> moved_at_once(
    const std::vector<PolygonWithHoles>& parts, const Rational& distance, const Rational& excess,
    BandSide side) {
  return Mover(parts, distance, excess, side).run();
}

}  // namespace rtac::geometry
