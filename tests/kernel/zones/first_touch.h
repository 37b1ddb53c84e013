// How far a place may move along a leg before it first touches the boundary.
#pragma once

#include <cmath>
#include <limits>

#include "tests/kernel/zones/scene.h"

namespace rtac::kernel_test {

inline constexpr std::int64_t all_the_way = std::numeric_limits<std::int64_t>::max();

inline long double length(const Edge& leg) {
  const Place d = minus(leg.b, leg.a);
  return std::sqrt(static_cast<long double>(dot(d, d)));
}
// Which part of the leg lies before it first touches the boundary; above 1: all of it.
inline long double first_touch(const std::vector<Edge>& edges, const Edge& leg) {
  const Place d = minus(leg.b, leg.a);
  long double first = 2;
  for (const Edge& e : edges) {
    if (axis_gap(leg, e) > 0 || !meet(leg, e)) continue;
    const Place g = minus(e.b, e.a);
    Wide num = cross(g, minus(leg.a, e.a)), den = num - cross(g, minus(leg.b, e.a));
    if (den == 0) {  // on one line
      num = std::max<Wide>(0, std::min(dot(minus(e.a, leg.a), d), dot(minus(e.b, leg.a), d)));
      den = std::max<Wide>(1, dot(d, d));
    }
    first = std::min(first, static_cast<long double>(num) / static_cast<long double>(den));
  }
  return first;
}
inline void expect_leave(const Scene& scene, const Edge& leg) {
  const std::int64_t found = probe_leave_mm(scene.tables.get(), leg.a, leg.b, 0);
  if (where(scene.edges, leg.a) <= 0) {
    ASSERT_EQ(found, 0);
    return;
  }
  const long double part = first_touch(scene.edges, leg);
  if (part > 1) {
    ASSERT_EQ(found, all_the_way);
    return;
  }
  const long double truth = part * length(leg);  // within 1e-9
  ASSERT_LE(static_cast<long double>(found), truth + 1e-6L);
  ASSERT_GT(static_cast<long double>(found), truth - 3);
}

}  // namespace rtac::kernel_test
