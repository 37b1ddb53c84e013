// What the tables of a zone may cost.
#include <map>

#include "tests/kernel/zones/scene.h"

namespace rtac::kernel_test {
namespace {

TEST(ZoneTables, OfManyEdgesTellOfSixteenForAPlaceAndStayWithinTheirBytes) {
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

}  // namespace
}  // namespace rtac::kernel_test
