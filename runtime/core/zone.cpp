#include "rtac/zone.h"

#include <algorithm>
#include <limits>

namespace rtac {
namespace {

constexpr double m_per_mm = 1e-3;
// How far below the true minimum along a segment that leaves the zone the search may stop short.
constexpr double outside_resolution_m = 1e-3;

struct Edge {
  Vec2 a, b;  // metres
};

Edge edge_at(const ZoneView& zone, std::size_t i) {
  const std::int32_t* e = zone.edges_mm + 4 * i;
  return {{e[0] * m_per_mm, e[1] * m_per_mm}, {e[2] * m_per_mm, e[3] * m_per_mm}};
}

double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}

Vec2 closest_on(const Edge& e, Vec2 p) {
  const Vec2 d = e.b - e.a;
  const double length2 = dot(d, d);
  if (length2 <= 0) return e.a;
  const double t = std::clamp(dot(p - e.a, d) / length2, 0.0, 1.0);
  return e.a + t * d;
}

bool segments_meet(const Edge& e, Vec2 a, Vec2 b) {
  const Vec2 d = e.b - e.a, s = b - a;
  const double a_side = cross(d, a - e.a), b_side = cross(d, b - e.a);
  const double ea_side = cross(s, e.a - a), eb_side = cross(s, e.b - a);
  if (a_side == 0 && b_side == 0) return false;  // collinear: the end points' distances decide
  return ((a_side <= 0 && b_side >= 0) || (a_side >= 0 && b_side <= 0)) &&
         ((ea_side <= 0 && eb_side >= 0) || (ea_side >= 0 && eb_side <= 0));
}

// Even-odd rule over all rings: holes need no special case.
bool contains(const ZoneView& zone, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < zone.edge_count; ++i) {
    const Edge e = edge_at(zone, i);
    if ((e.a.y > p.y) == (e.b.y > p.y)) continue;
    const double x = e.a.x + (p.y - e.a.y) / (e.b.y - e.a.y) * (e.b.x - e.a.x);
    if (p.x < x) inside = !inside;
  }
  return inside;
}

double boundary_distance(const ZoneView& zone, Vec2 p) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < zone.edge_count; ++i) {
    best = std::min(best, norm(p - closest_on(edge_at(zone, i), p)));
  }
  return best;
}

// Smallest signed clearance along a segment that leaves the zone. Signed clearance is 1-Lipschitz,
// so an interval whose middle is high enough needs no further look.
double deepest(const ZoneView& zone, Vec2 a, Vec2 b) {
  struct Interval {
    double lo, hi;  // fractions of the segment
  };
  // Depth first: each level leaves at most one interval behind, and halving ends at the resolution.
  FixedList<Interval, 64> open;
  double best = std::min(signed_clearance(zone, a), signed_clearance(zone, b));
  const double length = norm(b - a);
  (void)open.push({0, 1});
  while (!open.empty()) {
    const Interval at = open.back();
    open.resize_down(open.size() - 1);
    const double middle = (at.lo + at.hi) / 2, half_m = (at.hi - at.lo) / 2 * length;
    const double s = signed_clearance(zone, a + middle * (b - a));
    best = std::min(best, s);
    if (s - half_m >= best - outside_resolution_m || half_m <= outside_resolution_m) continue;
    if (!open.push({at.lo, middle}) || !open.push({middle, at.hi})) break;
  }
  return best;
}

}  // namespace

double signed_clearance(const ZoneView& zone, Vec2 p) {
  const double distance = boundary_distance(zone, p);
  return contains(zone, p) ? distance : -distance;
}

double signed_clearance(const ZoneView& zone, Vec2 a, Vec2 b) {
  bool crosses = false;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < zone.edge_count; ++i) {
    const Edge e = edge_at(zone, i);
    crosses = crosses || segments_meet(e, a, b);
    const Edge s{a, b};
    best = std::min({best, norm(a - closest_on(e, a)), norm(b - closest_on(e, b)),
                     norm(e.a - closest_on(s, e.a)), norm(e.b - closest_on(s, e.b))});
  }
  if (!crosses && contains(zone, a)) return best;
  // Touching the boundary from inside gives 0; a true crossing is negative at an end point or found
  // by the search, and never reported above 0.
  return std::min(deepest(zone, a, b), 0.0);
}

Vec2 nearest_boundary(const ZoneView& zone, Vec2 p) {
  Vec2 best = p;
  double best_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < zone.edge_count; ++i) {
    const Vec2 q = closest_on(edge_at(zone, i), p);
    const double d = norm(p - q);
    if (d < best_m) {
      best_m = d;
      best = q;
    }
  }
  return best;
}

}  // namespace rtac
