// The delivery arena as a baked zone, written by hand: 5 m x 5 m with three boxes as holes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "rtac/types.h"
#include "rtac/zone.h"

namespace rtac::test {

inline constexpr std::array<std::int32_t, 64> arena_edges_mm = {
    // clang-format off
    // outer ring, counter-clockwise; the box [2,3] x [0,1] stands on the south wall
    0, 0, 2000, 0,        2000, 0, 2000, 1000,     2000, 1000, 3000, 1000,  3000, 1000, 3000, 0,
    3000, 0, 5000, 0,     5000, 0, 5000, 5000,     5000, 5000, 0, 5000,     0, 5000, 0, 0,
    // holes, clockwise: [2,3] x [3,4] and [1,1.6] x [2,3]
    2000, 3000, 2000, 4000,  2000, 4000, 3000, 4000,  3000, 4000, 3000, 3000,  3000, 3000, 2000, 3000,
    1000, 2000, 1000, 3000,  1000, 3000, 1600, 3000,  1600, 3000, 1600, 2000,  1600, 2000, 1000, 2000,
    // clang-format on
};
inline constexpr std::array<std::size_t, 3> arena_rings = {0, 8, 12};

inline ZoneView arena() {
  ZoneView zone;
  zone.name = "free";
  zone.edges_mm = arena_edges_mm.data();
  zone.edge_count = arena_edges_mm.size() / 4;
  zone.ring_start = arena_rings.data();
  zone.ring_count = arena_rings.size();
  return zone;
}

// Least clearance on the way, looked at every millimetre: independent of any segment formula.
inline double sampled_clearance_m(const ZoneView& zone, Vec2 a, Vec2 b) {
  const int steps = static_cast<int>(norm(b - a) / 1e-3) + 1;
  double least = signed_clearance(zone, a);
  for (int i = 1; i <= steps; ++i) {
    least = std::min(least, signed_clearance(zone, a + (double(i) / steps) * (b - a)));
  }
  return least;
}

}  // namespace rtac::test
