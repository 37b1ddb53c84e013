// The outlines that other tests ask about are zones: rings touch in single points at most, and wind
// about every place once or not at all. Else the exact answers would say nothing.
#include <map>

#include "tests/kernel/zones/scene.h"

namespace rtac::kernel_test {
namespace {

bool overlap(const Edge& e, const Edge& f) {
  const bool on_one_line = side(e.a, e.b, f.a) == 0 && side(e.a, e.b, f.b) == 0;
  if (!on_one_line) return false;
  const Place d = minus(e.b, e.a);
  const auto along = [&](Place p) { return dot(minus(p, e.a), d); };
  return std::max<Wide>(0, std::min(along(f.a), along(f.b))) <
         std::min(dot(d, d), std::max(along(f.a), along(f.b)));
}

TEST(ZoneShapes, AreZones) {
  for_each_zone(32, 20, [](const Scene& scene, Random& random) {
    const std::vector<Edge>& all = scene.edges;
    for (std::size_t i = 0; i < all.size(); ++i) {
      ASSERT_FALSE(all[i].a == all[i].b);
      for (std::size_t j = i + 1; j < all.size(); ++j) {
        ASSERT_FALSE(overlap(all[i], all[j])) << all[i].a.x << " " << all[i].a.y;
        ASSERT_FALSE(crosses({all[i]}, all[j])) << all[i].a.x << " " << all[i].a.y;
      }
    }
    for (int i = 0; i < 200; ++i) {
      const Place p = delicate_place(all, random);
      int winding = 0;
      for (const Edge& e : all) {
        if (e.a.y <= p.y && e.b.y > p.y && side(e.a, e.b, p) > 0) ++winding;
        if (e.a.y > p.y && e.b.y <= p.y && side(e.a, e.b, p) < 0) --winding;
      }
      ASSERT_TRUE(where(all, p) == 0 || winding == 0 || winding == 1) << winding;
    }
  });
}

TEST(ZoneShapes, HavePlacesInsideOutsideAndOnTheBoundary) {
  std::map<std::string, std::array<int, 3>> found;
  for_each_zone(32, 21, [&](const Scene& scene, Random& random) {
    for (int i = 0; i < 100; ++i) {
      const int at = where(scene.edges, delicate_place(scene.edges, random));
      ++found[scene.zone.name][static_cast<std::size_t>(at + 1)];
    }
  });
  EXPECT_EQ(found.size(), static_cast<std::size_t>(Family::count));
  for (const auto& [name, places] : found) {
    for (const int count : places) EXPECT_GE(count, 20) << name;
  }
}

}  // namespace
}  // namespace rtac::kernel_test
