// Outlines of hundreds to tens of thousands of vertices, as they are in the field: what is looked
// up in their tables is what looking at every edge says.
#include "tests/bench/zones/outline.h"
#include "tests/kernel/zones/exact_box.h"
#include "tests/kernel/zones/first_touch.h"

namespace rtac::kernel_test {
namespace {

// All vertices are on the grid.
Scene scene_of(const bench::Outline& outline) {
  Zone zone{outline.name, {}};
  for (const auto& ring : outline.rings) {
    Ring& to = zone.rings.emplace_back();
    for (const bench::GridPlace& p : ring) {
      const Place at{p.x_mm, p.y_mm};
      if (to.empty() || !(to.back() == at)) to.push_back(at);
    }
    Wide area = 0;
    for (std::size_t i = 0; i < to.size(); ++i) area += cross(to[i], to[(i + 1) % to.size()]);
    const bool is_hole = zone.rings.size() > 1;
    if (is_hole == (area > 0)) std::reverse(to.begin(), to.end());
  }
  return Scene(std::move(zone));
}

void ask(const Scene& scene, Random& random, Place p) {
  const probe_tables* const tables = scene.tables.get();
  const int truth = where(scene.edges, p);
  ASSERT_TRUE(truth == 0 || probe_inside(tables, p) == (truth > 0)) << p.x << " " << p.y;
  ASSERT_NO_FATAL_FAILURE(expect_lower_bound(scene, {p, p}, probe_gap_lo(tables, p)))
      << p.x << " " << p.y;
  const Box b{p.x, p.x + 1, p.y, p.y + 1};
  ASSERT_EQ(probe_box_in(tables, b), box_in(scene.edges, b)) << p.x << " " << p.y;
  const std::int64_t size = std::int64_t{1} << random.in(0, 20);
  const Edge leg{p, {p.x + random.in(-size, size), p.y + random.in(-size, size)}};
  ASSERT_NO_FATAL_FAILURE(expect_leave(scene, leg))
      << p.x << " " << p.y << " to " << leg.b.x << " " << leg.b.y;
  const std::int64_t lower = probe_leg_lo(tables, leg.a, leg.b);
  ASSERT_EQ(lower < 0, crosses(scene.edges, leg))
      << p.x << " " << p.y << " to " << leg.b.x << " " << leg.b.y;
  if (lower < 0) return;
  ASSERT_NO_FATAL_FAILURE(expect_lower_bound(scene, leg, lower))
      << p.x << " " << p.y << " to " << leg.b.x << " " << leg.b.y;
}

// Why there are no tables: so many edges lie about that place.
void expect_many_together(const Scene& scene) {
  const geometry::TooDense& d = scene.tabled.dense;
  const Place middle{d.at.x_mm, d.at.y_mm};
  const auto near = std::count_if(scene.edges.begin(), scene.edges.end(), [&](const Edge& e) {
    return is_within({e}, {middle, middle}, d.within_mm + 1);  // the middle is on the grid
  });
  EXPECT_GT(d.edges, 16U);
  EXPECT_GE(near, static_cast<std::ptrdiff_t>(d.edges));
}

struct Case {
  const char* name;
  bench::Fence (*make)(std::size_t, bench::Vertices, std::uint64_t);
  std::size_t vertices;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name << " of " << c.vertices;
}
class LargeZones : public testing::TestWithParam<Case> {};

TEST_P(LargeZones, AreAnsweredAsEveryEdgeSays) {
  const Case& c = GetParam();
  const Scene scene =
      scene_of(bench::outline_of(c.name, c.make(c.vertices, bench::Vertices::on_grid, 1)));
  // Long edges close to each other are more than tables of a bounded size can tell.
  const bool may_be_refused = c.name == std::string("needles") || c.name == std::string("comb");
  ASSERT_TRUE(scene.tables || may_be_refused);
  if (!scene.tables) return expect_many_together(scene);
  Random random(40);
  // Looking at every edge takes its time.
  const std::size_t count = std::min<std::size_t>(3'000, 8'000'000 / c.vertices);
  for (std::size_t i = 0; i < count && !HasFatalFailure(); ++i) {
    ask(scene, random,
        random.one_in(3) ? uniform_place(scene.edges, random)
                         : delicate_place(scene.edges, random));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, LargeZones,
    testing::Values(Case{"coast", bench::coast, 300}, Case{"coast", bench::coast, 5'000},
                    Case{"coast", bench::coast, 30'000}, Case{"star", bench::mild_star, 1'000},
                    Case{"star", bench::mild_star, 20'000}, Case{"needles", bench::noisy_star, 500},
                    Case{"needles", bench::noisy_star, 10'000}, Case{"comb", bench::comb, 400},
                    Case{"comb", bench::comb, 20'000}, Case{"circle", bench::circle_fence, 2'000},
                    Case{"circle", bench::circle_fence, 20'000}),
    [](const auto& one) {
      return std::string(one.param.name) + "_" + std::to_string(one.param.vertices);
    });

}  // namespace
}  // namespace rtac::kernel_test
