#include "rtac/zone.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "rtac/zone_table.h"
#include "zone_cells.h"
#include "zone_edges.h"

namespace rtac {
namespace {

using detail::closest_on;
using detail::Edge;
using detail::edge_at;
using detail::ZoneCell;
using detail::ZoneCells;

// How far below the true minimum along a segment that leaves the zone the search may stop short.
constexpr double outside_resolution_m = 1e-3;

Vec2 in_mm(Vec2 p) {
  return {p.x / detail::m_per_mm, p.y / detail::m_per_mm};
}

// The cell whose edges are those that matter for a place; false: all do.
bool find_cell(const ZoneView& zone, Vec2 p, ZoneCell& cell) {
  return zone.tree != nullptr && ZoneCells(*zone.tree).find(in_mm(p), cell);
}
template <class Visit>
void for_each_edge(const ZoneView& zone, const Visit& visit) {
  for (std::size_t i = 0; i < zone.edge_count; ++i) visit(edge_at(zone, i));
}
template <class Visit>
void for_each_edge(const ZoneView& zone, const ZoneCell& cell, const Visit& visit) {
  for (std::size_t i = 0; i < cell.edges(); ++i) visit(edge_at(zone, cell.edge(*zone.tree, i)));
}
// Those that the nearest place of the boundary lies on. Of a far cell the tree knows that the
// boundary is farther away than distances are exact, and not where; the kernel's border_of goes to
// some place of it then, but here the nearest one is asked for. So all edges are looked at: right,
// and as slow as they are many. In a tick only recoveries ask, at rest and once a second at most,
// and from a far cell only far outside of their zone, or inside where `return when` wants more
// clearance than is exact. Planners, the simulator and its judge are off the real-time path.
template <class Visit>
void for_each_near_edge(const ZoneView& zone, Vec2 p, const Visit& visit) {
  ZoneCell cell;
  if (find_cell(zone, p, cell) && !cell.is_far()) {
    for_each_edge(zone, cell, visit);
  } else {
    for_each_edge(zone, visit);
  }
}

// A ray to the east of the place meets the edge.
bool is_east(const Edge& e, Vec2 p) {
  if ((e.a.y > p.y) == (e.b.y > p.y)) return false;
  return p.x < e.a.x + (p.y - e.a.y) / (e.b.y - e.a.y) * (e.b.x - e.a.x);
}
// Even-odd rule over all rings: holes need no special case.
bool contains(const ZoneView& zone, Vec2 p) {
  bool inside = false;
  for_each_edge(zone, [&](const Edge& e) { inside = inside != is_east(e, p); });
  return inside;
}
bool contains(const ZoneView& zone, const ZoneCell& cell, Vec2 p) {
  return ZoneCells(*zone.tree).contains(cell, in_mm(p));
}

struct Along {
  double least_m = std::numeric_limits<double>::infinity();  // distance from the boundary
  bool crosses = false;

  void look(const Edge& e, Vec2 a, Vec2 b) {
    crosses = crosses || detail::segments_meet(e, a, b);
    const Edge s{a, b};
    least_m = std::min({least_m, norm(a - closest_on(e, a)), norm(b - closest_on(e, b)),
                        norm(e.a - closest_on(s, e.a)), norm(e.b - closest_on(s, e.b))});
  }
};
Along look_along(const ZoneView& zone, Vec2 a, Vec2 b) {
  Along found;
  const auto look = [&](const Edge& e) { found.look(e, a, b); };
  const auto look_in = [&](const ZoneCell& cell) {
    if (cell.is_far()) found.least_m = std::min(found.least_m, cell.far_mm() * detail::m_per_mm);
    for_each_edge(zone, cell, look);
  };
  if (zone.tree == nullptr || !ZoneCells(*zone.tree).along(in_mm(a), in_mm(b), look_in)) {
    for_each_edge(zone, look);
  }
  return found;
}
bool inside(const ZoneView& zone, Vec2 p) {
  ZoneCell cell;
  return find_cell(zone, p, cell) ? contains(zone, cell, p) : contains(zone, p);
}

// Looks at places of a segment: `place(s)` is told the signed clearance of one and says from which
// clearance on its neighbourhood need not be looked at; nothing: no other place matters. Signed
// clearance is 1-Lipschitz, so an interval whose middle is high enough needs no further look.
template <class Place>
void search_along(const ZoneView& zone, Vec2 a, Vec2 b, const Place& place) {
  struct Interval {
    double lo, hi;  // fractions of the segment
  };
  if (!place(signed_clearance(zone, a)) || !place(signed_clearance(zone, b))) return;
  // Depth first: each level leaves at most one interval behind, and halving ends at the resolution.
  FixedList<Interval, 64> open;
  const double length = norm(b - a);
  (void)open.push({0, 1});
  while (!open.empty()) {
    const Interval at = open.back();
    open.resize_down(open.size() - 1);
    const double middle = (at.lo + at.hi) / 2, half_m = (at.hi - at.lo) / 2 * length;
    const double s = signed_clearance(zone, a + middle * (b - a));
    const std::optional<double> enough = place(s);
    if (!enough) return;
    if (s - half_m >= *enough || half_m <= outside_resolution_m) continue;
    if (!open.push({at.lo, middle}) || !open.push({middle, at.hi})) break;
  }
}

// Smallest signed clearance along a segment that leaves the zone.
double deepest(const ZoneView& zone, Vec2 a, Vec2 b) {
  double best = std::numeric_limits<double>::infinity();
  search_along(zone, a, b, [&](double s) -> std::optional<double> {
    best = std::min(best, s);
    return best - outside_resolution_m;
  });
  return best;
}

}  // namespace

double signed_clearance(const ZoneView& zone, Vec2 p) {
  ZoneCell cell;
  const bool in_tree = find_cell(zone, p, cell);
  bool is_inside = in_tree && contains(zone, cell, p);
  if (in_tree && cell.is_far() && is_inside) return cell.far_mm() * detail::m_per_mm;
  double squared_m2 = std::numeric_limits<double>::infinity();
  const auto look = [&](const Edge& e) {
    const Vec2 d = p - closest_on(e, p);
    squared_m2 = std::min(squared_m2, dot(d, d));
  };
  if (in_tree && !cell.is_far()) {
    for_each_edge(zone, cell, look);
  } else if (in_tree) {  // outside, where a bound would call a place less far out than it is
    for_each_edge(zone, look);
  } else {
    for_each_edge(zone, [&](const Edge& e) {
      is_inside = is_inside != is_east(e, p);
      look(e);
    });
  }
  const double distance_m = std::sqrt(squared_m2);
  return is_inside ? distance_m : -distance_m;
}

double signed_clearance(const ZoneView& zone, Vec2 a, Vec2 b) {
  const Along found = look_along(zone, a, b);
  if (!found.crosses && inside(zone, a)) return found.least_m;
  // Touching the boundary from inside gives 0; a true crossing is negative at an end point or found
  // by the search, and never reported above 0.
  return std::min(deepest(zone, a, b), 0.0);
}

bool keeps_clearance(const ZoneView& zone, Vec2 a, Vec2 b, double least_m) {
  const Along found = look_along(zone, a, b);
  if (!found.crosses && inside(zone, a)) return found.least_m >= least_m;
  if (least_m > 0) return false;
  bool keeps = true;
  search_along(zone, a, b, [&](double s) -> std::optional<double> {
    keeps = keeps && s >= least_m;
    return keeps ? std::optional(least_m) : std::nullopt;
  });
  return keeps;
}

Vec2 nearest_boundary(const ZoneView& zone, Vec2 p) {
  Vec2 best = p;
  double best_m2 = std::numeric_limits<double>::infinity();
  for_each_near_edge(zone, p, [&](const Edge& e) {
    const Vec2 q = closest_on(e, p);
    const Vec2 d = p - q;
    if (dot(d, d) < best_m2) {
      best_m2 = dot(d, d);
      best = q;
    }
  });
  return best;
}

Vec2 inward(const ZoneView& zone, Vec2 p) {
  constexpr double on_boundary_m = 1e-6;
  const Vec2 from = nearest_boundary(zone, p);
  const double distance_m = norm(p - from);
  if (distance_m > on_boundary_m) return ((inside(zone, p) ? 1 : -1) / distance_m) * (p - from);
  Vec2 sum{0, 0};
  for_each_near_edge(zone, p, [&](const Edge& e) {
    const Vec2 d = e.b - e.a;
    if (norm(p - closest_on(e, p)) > on_boundary_m || norm(d) <= 0) return;
    sum = sum + (1 / norm(d)) * Vec2{-d.y, d.x};
  });
  return norm(sum) > 0 ? (1 / norm(sum)) * sum : sum;
}

double distance_to_leave(const ZoneView& zone, Vec2 a, Vec2 b, double radius_m) {
  const auto keeps = [&](Vec2 end) {
    const Along found = look_along(zone, a, end);
    return !found.crosses && found.least_m > 0 && found.least_m >= radius_m;
  };
  if (!inside(zone, a) || !keeps(a)) return 0;
  if (keeps(b)) return std::numeric_limits<double>::infinity();
  double low = 0, high = 1;  // fractions
  for (int i = 0; i < 48; ++i) {
    const double middle = (low + high) / 2;
    (keeps(a + middle * (b - a)) ? low : high) = middle;
  }
  return low * norm(b - a);
}

}  // namespace rtac
