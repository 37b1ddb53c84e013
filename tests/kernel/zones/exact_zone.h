// Zones as the tests know them: rings of grid points, and exact answers by looking at every edge.
// Nothing is shared with the compiler's geometry: products of differences up to 2^31 fit 64 bits,
// what is squared fits 128 bits, and nothing is rounded.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/kernel/zones/zone_probe.h"

namespace rtac::kernel_test {

__extension__ using Wide = __int128;

using Place = probe_place;
using Ring = std::vector<Place>;
// Outer rings counter-clockwise, holes clockwise.
struct Zone {
  std::string name;
  std::vector<Ring> rings;
};

struct Edge {
  Place a, b;
};
inline std::vector<Edge> edges_of(const Zone& zone) {
  std::vector<Edge> all;
  for (const Ring& ring : zone.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      all.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
  }
  return all;
}

inline bool operator==(const Place& a, const Place& b) {
  return a.x == b.x && a.y == b.y;
}
inline Place minus(Place a, Place b) {
  return {a.x - b.x, a.y - b.y};
}
inline Wide dot(Place a, Place b) {
  return Wide(a.x) * b.x + Wide(a.y) * b.y;
}
inline Wide cross(Place a, Place b) {
  return Wide(a.x) * b.y - Wide(a.y) * b.x;
}
// 1: p is on the left of a to b, -1: on its right, 0: on its line.
inline int side(Place a, Place b, Place p) {
  const Wide c = cross(minus(b, a), minus(p, a));
  return c > 0 ? 1 : (c < 0 ? -1 : 0);
}
inline bool on_edge(Place p, const Edge& e) {
  return p.x >= std::min(e.a.x, e.b.x) && p.x <= std::max(e.a.x, e.b.x) &&
         p.y >= std::min(e.a.y, e.b.y) && p.y <= std::max(e.a.y, e.b.y) && side(e.a, e.b, p) == 0;
}
inline bool meet(const Edge& e, const Edge& f) {
  return on_edge(e.a, f) || on_edge(e.b, f) || on_edge(f.a, e) || on_edge(f.b, e) ||
         (side(e.a, e.b, f.a) * side(e.a, e.b, f.b) < 0 &&
          side(f.a, f.b, e.a) * side(f.a, f.b, e.b) < 0);
}
// 1: inside, 0: on the boundary, -1: outside. By winding number, where the kernel counts crossings.
inline int where(const std::vector<Edge>& edges, Place p) {
  int winding = 0;
  for (const Edge& e : edges) {
    if (std::max(e.a.x, e.b.x) < p.x) continue;
    if ((e.a.y > p.y && e.b.y > p.y) || (e.a.y < p.y && e.b.y < p.y)) continue;
    if (on_edge(p, e)) return 0;
    const int s = side(e.a, e.b, p);
    if (e.a.y <= p.y && e.b.y > p.y && s > 0) ++winding;
    if (e.a.y > p.y && e.b.y <= p.y && s < 0) --winding;
  }
  return winding != 0 ? 1 : -1;
}

// The square of a distance, as a fraction.
struct Square {
  Wide num, den;
  [[nodiscard]] bool at_least(std::int64_t mm) const {
    return mm <= 0 || num >= Wide(mm) * mm * den;
  }
  [[nodiscard]] bool more_than(std::int64_t mm) const { return num > Wide(mm) * mm * den; }
};
inline Square place_edge(Place p, const Edge& e) {
  const Place d = minus(e.b, e.a), q = minus(p, e.a), r = minus(p, e.b);
  const Wide along = dot(q, d), length = dot(d, d);
  if (along <= 0) return {dot(q, q), 1};
  if (along >= length) return {dot(r, r), 1};
  return {cross(d, q) * cross(d, q), length};
}

// Of two boxes, the larger of their gaps along the axes: never more than the distance.
inline std::int64_t axis_gap(const Edge& e, const Edge& f) {
  const auto gap = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return std::max(std::min(a, b) - std::max(c, d), std::min(c, d) - std::max(a, b));
  };
  return std::max(gap(e.a.x, e.b.x, f.a.x, f.b.x), gap(e.a.y, e.b.y, f.a.y, f.b.y));
}
inline bool at_least(const Edge& leg, const Edge& e, std::int64_t mm) {
  if (mm <= 0 || axis_gap(leg, e) >= mm) return true;
  return !meet(leg, e) && place_edge(leg.a, e).at_least(mm) && place_edge(leg.b, e).at_least(mm) &&
         place_edge(e.a, leg).at_least(mm) && place_edge(e.b, leg).at_least(mm);
}
// Whether the distance of a leg, or of a place twice, from the boundary is at least that.
inline bool keeps(const std::vector<Edge>& edges, const Edge& leg, std::int64_t mm) {
  return std::all_of(edges.begin(), edges.end(),
                     [&](const Edge& e) { return at_least(leg, e, mm); });
}
inline bool keeps(const std::vector<Edge>& edges, Place p, std::int64_t mm) {
  return keeps(edges, Edge{p, p}, mm);
}
// Whether that distance is at most `mm`.
inline bool is_within(const std::vector<Edge>& edges, const Edge& leg, std::int64_t mm) {
  return std::any_of(edges.begin(), edges.end(), [&](const Edge& e) {
    if (axis_gap(leg, e) > mm) return false;
    return meet(leg, e) || !place_edge(leg.a, e).more_than(mm) ||
           !place_edge(leg.b, e).more_than(mm) || !place_edge(e.a, leg).more_than(mm) ||
           !place_edge(e.b, leg).more_than(mm);
  });
}
// Whether the leg passes from one side of an edge to the other within both.
inline bool crosses(const std::vector<Edge>& edges, const Edge& leg) {
  return std::any_of(edges.begin(), edges.end(), [&](const Edge& e) {
    return axis_gap(leg, e) < 0 && side(e.a, e.b, leg.a) * side(e.a, e.b, leg.b) < 0 &&
           side(leg.a, leg.b, e.a) * side(leg.a, leg.b, e.b) < 0;
  });
}
// The distance, rounded down.
inline std::int64_t distance_floor(const std::vector<Edge>& edges, const Edge& leg) {
  std::int64_t low = 0, high = std::int64_t{1} << 32;
  while (low + 1 < high) {
    const std::int64_t middle = (low + high) / 2;
    (keeps(edges, leg, middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace rtac::kernel_test
