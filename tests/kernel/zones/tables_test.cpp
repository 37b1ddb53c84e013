// What the tables of a zone may cost, and when the compiler refuses to make them.
#include <map>

#include "tests/kernel/zones/scene.h"

namespace rtac::kernel_test {
namespace {

std::size_t edges_within(const std::vector<Edge>& edges, Place p, std::int64_t mm) {
  return static_cast<std::size_t>(std::count_if(edges.begin(), edges.end(), [&](const Edge& e) {
    return is_within({e}, {p, p}, mm);
  }));
}

TEST(ZoneTables, OfManyEdgesTellOfSixteenForAPlaceAndStayWithinTheirBytes) {
  if (probe_has_trees() == 0) GTEST_SKIP() << "every edge is looked at";
  std::map<std::string, int> made;
  for_each_zone(160, 50, [&](const Scene& scene, Random&) {
    EXPECT_LE(scene.tabled.edges_most, 16);
    EXPECT_LE(scene.tabled.bytes, 64 * scene.edges.size() + 65'536) << scene.zone;
    made[scene.zone.name] += 1;
  });
  // Of every family, most are not refused.
  EXPECT_EQ(made.size(), static_cast<std::size_t>(Family::count));
  for (const auto& [name, count] : made) EXPECT_GE(count, 20) << name;
}

TEST(ZoneTables, AreRefusedOnlyWhereManyEdgesAreTogether) {
  if (probe_has_trees() == 0) GTEST_SKIP() << "none is refused";
  for (int f = 0; f < static_cast<int>(Family::count); ++f) {
    Random random(51 + static_cast<std::uint64_t>(f));
    for (int i = 0; i < 10; ++i) {
      const Zone zone = random_zone(static_cast<Family>(f), random);
      const Tabled tabled = table(zone);
      if (tabled.tables) continue;
      const geometry::TooDense& d = tabled.dense;
      EXPECT_GT(d.edges, 16U) << zone;
      // The place is on the grid, the distance in whole millimetres.
      EXPECT_GE(edges_within(edges_of(zone), {d.at.x_mm, d.at.y_mm}, d.within_mm + 2), d.edges)
          << zone;
    }
  }
}

}  // namespace
}  // namespace rtac::kernel_test
