// Places against zones: inside or not, and how far from the boundary.
#include "tests/kernel/zones/scene.h"

namespace rtac::kernel_test {
namespace {

TEST(ZonePlaces, AreInsideOrNotAsTheyTrulyAre) {
  for_each_zone(150, 1, [](const Scene& scene, Random& random) {
    for (int i = 0; i < 400; ++i) {
      const Place p = delicate_place(scene.edges, random);
      const int truth = where(scene.edges, p);
      // On the boundary itself either will do: the distance says that it is there.
      if (truth == 0) continue;
      ASSERT_EQ(probe_inside(scene.tables.get(), p), truth > 0) << p.x << " " << p.y;
    }
  });
}

TEST(ZonePlaces, HaveDistancesThatAreSafeAndClose) {
  for_each_zone(150, 2, [](const Scene& scene, Random& random) {
    for (int i = 0; i < 300; ++i) {
      const Place p = delicate_place(scene.edges, random);
      const std::int64_t lower = probe_gap_lo(scene.tables.get(), p);
      ASSERT_NO_FATAL_FAILURE(expect_lower_bound(scene, {p, p}, lower)) << p.x << " " << p.y;
    }
  });
}

TEST(ZonePlaces, AboutTinyZonesAreAllRight) {
  // Every place within 8 mm of outlines of a few mm.
  Random random(3);
  for (int i = 0; i < (probe_has_trees() != 0 ? 150 : 1'500); ++i) {
    const Scene scene(random_zone(random.one_in(3) ? Family::cells : Family::tiny, random));
    if (!scene.tables) continue;
    const Place at = scene.edges.front().a;
    for (std::int64_t k = 0; k < 17 * 17; ++k) {
      const Place p{at.x + k % 17 - 8, at.y + k / 17 - 8};
      const int truth = where(scene.edges, p);
      const std::int64_t lower = probe_gap_lo(scene.tables.get(), p);
      ASSERT_TRUE(truth == 0 || probe_inside(scene.tables.get(), p) == (truth > 0)) << scene.zone;
      ASSERT_NO_FATAL_FAILURE(expect_lower_bound(scene, {p, p}, lower)) << scene.zone;
    }
  }
}

}  // namespace
}  // namespace rtac::kernel_test
