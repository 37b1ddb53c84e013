#include "compiler/interp/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace rtac::interp {
namespace {

// Doubles are off by less than this share of the largest coordinate, however they were computed.
constexpr double rough_share = 1e-9;

}  // namespace

Outline::Edge Outline::edge(const Place& a, const Place& b) {
  Edge e;
  e.a = a;
  e.b = b;
  e.d = minus(b, a);
  e.square = dot(e.d, e.d);
  e.ax = a.x.get_d(), e.ay = a.y.get_d();
  e.dx = e.d.x.get_d(), e.dy = e.d.y.get_d();
  e.x1 = std::max(e.ax, b.x.get_d());
  e.y0 = std::min(e.ay, b.y.get_d());
  e.y1 = std::max(e.ay, b.y.get_d());
  return e;
}

Outline::Outline(const geometry::Region& region) {
  const auto add = [&](const geometry::Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const geometry::Point& a = ring[i];
      const geometry::Point& b = ring[(i + 1) % ring.size()];
      Edge e = edge({a.x, a.y}, {b.x, b.y});
      reach_ = std::max({reach_, std::abs(e.ax), std::abs(e.ay)});
      edges_.push_back(std::move(e));
    }
  };
  for (const geometry::PolygonWithHoles& part : region.polygons()) {
    add(part.outer);
    for (const geometry::Ring& hole : part.holes) add(hole);
  }
}

double Outline::slack(double x, double y) const {
  return rough_share * std::max({1.0, reach_, std::abs(x), std::abs(y)});
}

// Even-odd rule: the edges that a ray to the right crosses. A place on an edge is one of the zone.
bool Outline::contains(const Place& p) const {
  const double x = p.x.get_d(), y = p.y.get_d();
  const double room = slack(x, y);
  bool inside = false;
  for (const Edge& e : edges_) {
    if (e.y0 > y + room || e.y1 < y - room || e.x1 < x - room) continue;
    const Rational qx = p.x - e.a.x, qy = p.y - e.a.y;
    const int side = cmp(Rational(e.d.x * qy), Rational(e.d.y * qx));
    if (side == 0) {
      const Rational along = qx * e.d.x + qy * e.d.y;
      if (along >= 0 && along <= e.square) return true;
    }
    if ((e.a.y > p.y) == (e.b.y > p.y)) continue;
    if ((e.b.y > e.a.y) == (side > 0)) inside = !inside;
  }
  return inside;
}

Rational Outline::square_to(const Edge& e, const Place& p) {
  const Rational qx = p.x - e.a.x, qy = p.y - e.a.y;
  const Rational along = qx * e.d.x + qy * e.d.y;
  if (along <= 0) return qx * qx + qy * qy;
  if (along >= e.square) {
    const Rational rx = p.x - e.b.x, ry = p.y - e.b.y;
    return rx * rx + ry * ry;
  }
  const Rational across = e.d.x * qy - e.d.y * qx;
  return across * across / e.square;
}

Rational Outline::square_to(const Place& p) const {
  const double x = p.x.get_d(), y = p.y.get_d();
  double nearest = std::numeric_limits<double>::infinity();
  std::vector<double> gaps;
  gaps.reserve(edges_.size());
  for (const Edge& e : edges_) {
    const double qx = x - e.ax, qy = y - e.ay;
    const double t = (qx * e.dx + qy * e.dy) / (e.dx * e.dx + e.dy * e.dy);
    const double share = std::clamp(t, 0.0, 1.0);
    gaps.push_back(std::hypot(qx - share * e.dx, qy - share * e.dy));
    nearest = std::min(nearest, gaps.back());
  }
  const double limit = nearest + 2 * slack(x, y);
  std::optional<Rational> least;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    if (gaps[i] > limit) continue;  // what is no number is looked at
    const Rational square = square_to(edges_[i], p);
    if (!least || square < *least) least = square;
  }
  return *least;
}

std::vector<Rational> Outline::meetings(const Edge& way) const {
  std::vector<Rational> shares;
  const auto add = [&](const Rational& share) {
    if (share > 0 && share < 1) shares.push_back(share);
  };
  for (const Edge& e : edges_) {
    const Place to = minus(e.a, way.a);
    const Rational turn = cross(way.d, e.d), side = cross(to, way.d);
    if (turn != 0) {
      const Rational along_edge = side / turn;
      if (along_edge >= 0 && along_edge <= 1) add(cross(to, e.d) / turn);
    } else if (side == 0 && way.square != 0) {  // on one line
      add(dot(to, way.d) / way.square);
      add(dot(minus(e.b, way.a), way.d) / way.square);
    }
  }
  std::sort(shares.begin(), shares.end());
  return shares;
}

// Between two places where it meets the boundary the way lies inside, on the boundary or outside
// as a whole.
bool Outline::contains(const Place& from, const Place& to) const {
  const Edge way = edge(from, to);
  std::vector<Rational> shares = meetings(way);
  shares.emplace_back(1);
  Rational before = 0;
  for (const Rational& share : shares) {
    const Rational middle = (before + share) / 2;
    if (!contains({from.x + middle * way.d.x, from.y + middle * way.d.y})) return false;
    before = share;
  }
  return true;
}

Root Outline::distance(const Place& from, const Place& to) const {
  const Edge way = edge(from, to);
  if (!meetings(way).empty()) return {0, 0};
  std::optional<Rational> least;
  for (const Edge& e : edges_) {
    const Rational square = std::min({square_to(e, from), square_to(e, to), square_to(way, e.a)});
    if (!least || square < *least) least = square;
  }
  return square_root(*least);
}

// Of the vertices, the one whose farthest corner is nearest.
Rational Outline::square_of_farthest(const Place& low, const Place& high) const {
  std::optional<Rational> least;
  for (const Edge& e : edges_) {
    const Rational dx = std::max(abs(Rational(low.x - e.a.x)), abs(Rational(high.x - e.a.x)));
    const Rational dy = std::max(abs(Rational(low.y - e.a.y)), abs(Rational(high.y - e.a.y)));
    const Rational square = dx * dx + dy * dy;
    if (!least || square < *least) least = square;
  }
  return *least;
}

std::pair<Place, Place> Outline::extent() const {
  Place low = edges_.front().a, high = low;
  for (const Edge& e : edges_) {
    low = {std::min(low.x, e.a.x), std::min(low.y, e.a.y)};
    high = {std::max(high.x, e.a.x), std::max(high.y, e.a.y)};
  }
  return {low, high};
}

Rational Outline::deepest() const {
  const auto [low, high] = extent();
  return std::min(Rational(high.x - low.x), Rational(high.y - low.y)) / 2;
}

}  // namespace rtac::interp
