// Runs a check on many zones of every family; a failure names the zone.
#pragma once

#include <gtest/gtest.h>

#include "tests/kernel/zones/shapes.h"
#include "tests/kernel/zones/tables.h"

namespace rtac::kernel_test {

inline std::ostream& operator<<(std::ostream& out, const Zone& zone) {
  out << zone.name;
  for (const Ring& ring : zone.rings) {
    out << " [";
    if (ring.size() > 40) out << ring.size() << " vertices";
    for (std::size_t i = 0; i < ring.size() && ring.size() <= 40; ++i) {
      out << "(" << ring[i].x << ", " << ring[i].y << ")";
    }
    out << "]";
  }
  return out;
}

// How far below a distance the kernel's may be; one unit more over hundreds of kilometres.
inline std::int64_t slack_mm(std::int64_t distance_mm) {
  return distance_mm < std::int64_t{1} << 28 ? 2 : 3;
}

struct Scene {
  Zone zone;
  std::vector<Edge> edges;
  Tabled tabled;
  Tables& tables = tabled.tables;
  explicit Scene(Zone of) : zone(std::move(of)), edges(edges_of(zone)), tabled(table(zone)) {}
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
};

// `check(scene, random)` until the first failure. Trees take some milliseconds each: then there are
// fewer zones, which are checked again with other places.
template <class Check>
void for_each_zone(int zones_per_family, std::uint64_t seed, const Check& check) {
  const int again = probe_has_trees() != 0 ? 4 : 1;
  zones_per_family /= again * again;
  for (int f = 0; f < static_cast<int>(Family::count); ++f) {
    Random random(seed * 100 + static_cast<std::uint64_t>(f));
    for (int i = 0; i < zones_per_family && !testing::Test::HasFatalFailure(); ++i) {
      const Scene scene(random_zone(static_cast<Family>(f), random));
      if (!scene.tables) continue;  // refused, see tables_test.cpp
      for (int k = 0; k < again && !testing::Test::HasFatalFailure(); ++k) check(scene, random);
      if (testing::Test::HasFatalFailure()) ADD_FAILURE() << "in " << scene.zone;
    }
  }
}

// The kernel's lower bound of a distance: never above it, and close below up to the horizon.
inline void expect_lower_bound(const Scene& scene, const Edge& leg, std::int64_t lower) {
  ASSERT_TRUE(keeps(scene.edges, leg, lower)) << lower << " is more than the distance";
  if (lower >= scene.tabled.horizon_mm) return;
  ASSERT_TRUE(is_within(scene.edges, leg, lower + slack_mm(lower)))
      << lower << " is far below the distance, " << distance_floor(scene.edges, leg);
}

}  // namespace rtac::kernel_test
