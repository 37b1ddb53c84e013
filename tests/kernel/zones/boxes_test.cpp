// Boxes of the grid against zones: what is measured without error lies in one of at most 1 mm.
#include "tests/kernel/zones/exact_box.h"
#include "tests/kernel/zones/scene.h"

namespace rtac::kernel_test {
namespace {

bool has_vertex_on(const std::vector<Edge>& edges, const Box& b) {
  return std::any_of(edges.begin(), edges.end(), [&](const Edge& e) {
    return e.a.x >= b.x0 && e.a.x <= b.x1 && e.a.y >= b.y0 && e.a.y <= b.y1;
  });
}

void expect_right(const Scene& scene, const Box& b) {
  const int truth = box_in(scene.edges, b), found = probe_box_in(scene.tables.get(), b);
  const bool is_flat = b.x0 == b.x1 || b.y0 == b.y1;
  const bool may_be_open = truth == 1 && is_flat && has_vertex_on(scene.edges, b);
  ASSERT_TRUE(found == truth || (found == 0 && may_be_open))
      << b.x0 << " to " << b.x1 << ", " << b.y0 << " to " << b.y1 << ": " << found << " for "
      << truth;
}

TEST(ZoneBoxes, LieInAZoneOrNotAsTheyTrulyDo) {
  for_each_zone(100, 6, [](const Scene& scene, Random& random) {
    for (int i = 0; i < 250; ++i) {
      const Place p = delicate_place(scene.edges, random);
      const Box b{p.x, p.x + random.in(0, 1), p.y, p.y + random.in(0, 1)};
      ASSERT_NO_FATAL_FAILURE(expect_right(scene, b));
    }
  });
}

TEST(ZoneBoxes, HaveClearancesThatContainThoseOfTheirCorners) {
  for_each_zone(60, 7, [](const Scene& scene, Random& random) {
    for (int i = 0; i < 100; ++i) {
      const Place p = delicate_place(scene.edges, random);
      const Box b{p.x, p.x + random.in(0, 60), p.y, p.y + random.in(0, 60)};
      const probe_span found = probe_box_clearance(scene.tables.get(), b);
      for (const Place q :
           {Place{b.x0, b.y0}, Place{b.x1, b.y0}, Place{b.x0, b.y1}, Place{b.x1, b.y1}}) {
        // Signed: `low` <= clearance <= `high`.
        const bool in = where(scene.edges, q) >= 0;
        const std::int64_t low = in ? found.lo : -found.hi, high = in ? found.hi : -found.lo;
        ASSERT_TRUE(keeps(scene.edges, q, low)) << q.x << " " << q.y;
        ASSERT_GE(high, 0);
        ASSERT_FALSE(keeps(scene.edges, q, high + 1)) << q.x << " " << q.y;
      }
    }
  });
}

}  // namespace
}  // namespace rtac::kernel_test
