#include "compiler/analysis/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtac::analysis::outline {
namespace {

constexpr double resolution_mm = 1;

P closest_on(const Segment& s, P p) {
  const P d = s.b - s.a, ap = p - s.a;
  const double length2 = d.x * d.x + d.y * d.y;
  const double t = length2 > 0 ? std::clamp((ap.x * d.x + ap.y * d.y) / length2, 0.0, 1.0) : 0.0;
  return s.a + t * d;
}

}  // namespace

double norm(P a) {
  return std::hypot(a.x, a.y);
}

Outline Outline::of(const geometry::Region& region) {
  std::vector<Segment> edges;
  for (const geometry::Ring& ring : region.rings()) {
    const auto mm = [](const geometry::Point& p) {
      return P{1000 * p.x.get_d(), 1000 * p.y.get_d()};
    };
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.push_back({mm(ring[i]), mm(ring[(i + 1) % ring.size()])});
    }
  }
  return Outline(std::move(edges));
}
Outline Outline::of(const ir::ZoneTable& zone) {
  std::vector<Segment> edges;
  for (const ir::Edge& e : zone.edges) {
    edges.push_back({{double(e.ax), double(e.ay)}, {double(e.bx), double(e.by)}});
  }
  return Outline(std::move(edges));
}

bool Outline::contains(P p) const {
  bool inside = false;
  for (const auto& [a, b] : edges_) {
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}
P Outline::nearest(P p) const {
  P best = p;
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& e : edges_) {
    const P q = closest_on(e, p);
    if (const double away = norm(q - p); away < least) {
      least = away;
      best = q;
    }
  }
  return best;
}
double Outline::clearance(P p) const {
  const double away = norm(nearest(p) - p);
  return contains(p) ? away : -away;
}
// Clearance changes no faster than the place.
bool Outline::keeps(P a, P b, double least) const {
  const P middle = 0.5 * (a + b);
  const double half = norm(b - a) / 2, here = clearance(middle);
  if (here < least) return false;
  if (here - half >= least || half <= resolution_mm) return true;
  return keeps(a, middle, least) && keeps(middle, b, least);
}
std::optional<Outline::Outside> Outline::left_on(P a, P b, double strays_mm) const {
  std::vector<double> cuts = {0, 1};
  const P d = b - a;
  for (const auto& [c, e] : edges_) {
    const P f = e - c, ac = c - a;
    const double cross = d.x * f.y - d.y * f.x;
    if (cross == 0) continue;
    const double t = (ac.x * f.y - ac.y * f.x) / cross, s = (ac.x * d.y - ac.y * d.x) / cross;
    if (t > 0 && t < 1 && s >= 0 && s <= 1) cuts.push_back(t);
  }
  std::sort(cuts.begin(), cuts.end());
  std::optional<Outside> found;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    constexpr int looks = 4;
    for (int k = 1; k <= looks; ++k) {
      const P at = a + (cuts[i] + (cuts[i + 1] - cuts[i]) * k / looks) * d;
      const double deep = -clearance(at);
      if (deep > (found ? found->deep : strays_mm)) found = {at, deep};
    }
  }
  return found;
}

}  // namespace rtac::analysis::outline
