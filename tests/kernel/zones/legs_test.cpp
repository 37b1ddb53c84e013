// Legs against zones: whether they cross the boundary, and how close they come to it.
#include "tests/kernel/zones/scene.h"

namespace rtac::kernel_test {
namespace {

TEST(ZoneLegs, CrossTheBoundaryOrKeepADistanceThatIsSafeAndClose) {
  for_each_zone(100, 4, [](const Scene& scene, Random& random) {
    for (int i = 0; i < 200; ++i) {
      const Edge leg = delicate_leg(scene.edges, random);
      const std::int64_t lower = probe_leg_lo(scene.tables.get(), leg.a, leg.b);
      const auto said = [&] {
        return testing::Message() << leg.a.x << " " << leg.a.y << " to " << leg.b.x << " "
                                  << leg.b.y;
      };
      ASSERT_EQ(lower < 0, crosses(scene.edges, leg)) << said();
      if (lower < 0) continue;
      ASSERT_NO_FATAL_FAILURE(expect_lower_bound(scene, leg, lower)) << said();
    }
  });
}

TEST(ZoneLegs, WithBothEndsInsideAreCaughtWhenTheyLeave) {
  // Across the mouth of a bay, a hole, a gap of 1 mm: no end says anything.
  std::int64_t caught = 0;
  for_each_zone(60, 5, [&](const Scene& scene, Random& random) {
    for (int i = 0; i < 200; ++i) {
      const Edge leg{uniform_place(scene.edges, random), uniform_place(scene.edges, random)};
      if (where(scene.edges, leg.a) <= 0 || where(scene.edges, leg.b) <= 0) continue;
      if (!crosses(scene.edges, leg)) continue;
      ++caught;
      const Place plan[] = {leg.a, leg.b};
      ASSERT_EQ(probe_plan_in(scene.tables.get(), plan, 2, 1), PROBE_FALSE)
          << leg.a.x << " " << leg.a.y << " to " << leg.b.x << " " << leg.b.y;
    }
  });
  EXPECT_GE(caught, 3'000);
}

}  // namespace
}  // namespace rtac::kernel_test
