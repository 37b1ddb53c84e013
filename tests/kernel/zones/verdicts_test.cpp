// Verdicts of places, plans and moving robots: never wrong, and open only within a few millimetres
// of the boundary.
#include <array>

#include "tests/kernel/zones/exact_box.h"
#include "tests/kernel/zones/scene.h"

namespace rtac::kernel_test {
namespace {

// How near to the boundary a verdict may be open.
constexpr std::int64_t unknown_mm = 2;

// That of `clearance >= need` for a place on the grid.
int verdict(const probe_span& clearance, std::int64_t need) {
  if (clearance.lo >= need) return PROBE_TRUE;
  return clearance.hi < need ? PROBE_FALSE : PROBE_UNKNOWN;
}
// clearance >= need, for a signed clearance and any need
bool has_clearance(const std::vector<Edge>& edges, Place p, std::int64_t need) {
  const int at = where(edges, p);
  if (need > 0) return at > 0 && keeps(edges, p, need);
  if (at >= 0) return true;
  return need < 0 && !keeps(edges, p, -need + 1);  // one-sided: within 1 mm
}

TEST(ZoneVerdicts, OfPlacesAreRightAndOpenOnlyNearTheBoundary) {
  for_each_zone(100, 8, [](const Scene& scene, Random& random) {
    for (int i = 0; i < 200; ++i) {
      const Place p = delicate_place(scene.edges, random);
      const int found = verdict(probe_box_clearance(scene.tables.get(), {p.x, p.x, p.y, p.y}), 0);
      const int truth = where(scene.edges, p);
      ASSERT_TRUE(found != PROBE_TRUE || truth >= 0) << p.x << " " << p.y;
      ASSERT_TRUE(found != PROBE_FALSE || truth < 0) << p.x << " " << p.y;
      if (found == PROBE_UNKNOWN) {
        ASSERT_TRUE(is_within(scene.edges, {p, p}, unknown_mm)) << p.x << " " << p.y;
      }
    }
  });
}

TEST(ZoneVerdicts, OfPlacesThatKeepADistanceAreRight) {
  for_each_zone(60, 9, [](const Scene& scene, Random& random) {
    for (int i = 0; i < 200; ++i) {
      const Place p = delicate_place(scene.edges, random);
      const std::int64_t near = distance_floor(scene.edges, {p, p});
      const std::int64_t need = std::max<std::int64_t>(1, near + random.in(-5, 5));
      const int found =
          verdict(probe_box_clearance(scene.tables.get(), {p.x, p.x, p.y, p.y}), need);
      const bool truth = has_clearance(scene.edges, p, need);
      ASSERT_TRUE(found != PROBE_TRUE || truth) << p.x << " " << p.y << " keeps " << need;
      ASSERT_TRUE(found != PROBE_FALSE || !truth) << p.x << " " << p.y << " keeps " << need;
      const bool is_exact = near + 10 < scene.tabled.horizon_mm && near < std::int64_t{1} << 28;
      ASSERT_TRUE(found != PROBE_UNKNOWN || !is_exact || std::abs(near - need) <= unknown_mm)
          << p.x << " " << p.y << " keeps " << need;
    }
  });
}

// Whether every point of the leg lies in the closed zone: between the places where it meets the
// boundary it does not change sides. A mirror image with one axis along the leg would not be on
// the grid, so that meeting places are fractions of the leg.
bool leg_in(const std::vector<Edge>& edges, const Edge& leg) {
  if (crosses(edges, leg) || where(edges, leg.a) < 0 || where(edges, leg.b) < 0) return false;
  std::vector<Fraction> cuts{{0, 1}, {1, 1}};
  const Place d = minus(leg.b, leg.a);
  if (dot(d, d) == 0) return true;
  for (const Edge& e : edges) {
    // No proper crossings are left: they meet in vertices of the zone, or at ends of the leg.
    if (on_edge(e.a, leg)) cuts.push_back({dot(minus(e.a, leg.a), d), dot(d, d)});
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    // Cuts lie on grid points of the leg: their middle is one of half steps.
    const auto at = [&](const Fraction& f) {
      return Place{leg.a.x + std::int64_t(d.x * f.num / f.den),
                   leg.a.y + std::int64_t(d.y * f.num / f.den)};
    };
    const Place p = at(cuts[i - 1]), q = at(cuts[i]);
    if (!(p == q) && where(edges, Wide(p.x) + q.x, Wide(p.y) + q.y, 2) < 0) return false;
  }
  return true;
}

TEST(ZoneVerdicts, OfPlansAreRightAndOpenOnlyNearTheBoundary) {
  for_each_zone(60, 10, [](const Scene& scene, Random& random) {
    for (int i = 0; i < 150; ++i) {
      const int count = static_cast<int>(random.in(1, 4));
      std::array<Place, PROBE_LEGS_MAX> plan{};
      const Edge first = delicate_leg(scene.edges, random);
      plan[0] = first.a;
      plan[1] = first.b;
      for (std::size_t k = 2; k < 4; ++k) plan[k] = delicate_place(scene.edges, random);
      bool in = where(scene.edges, plan[0]) >= 0,
           is_near = is_within(scene.edges, {plan[0], plan[0]}, unknown_mm);
      for (int k = 1; k < count; ++k) {
        const Edge leg{plan[std::size_t(k - 1)], plan[std::size_t(k)]};
        in = in && leg_in(scene.edges, leg);
        is_near = is_near || is_within(scene.edges, leg, unknown_mm);
      }
      // 1 mm for way-points that were rounded to the grid
      const int found = probe_plan_in(scene.tables.get(), plan.data(), count, 1);
      ASSERT_TRUE(found != PROBE_TRUE || in);
      ASSERT_TRUE(found != PROBE_FALSE || !in) << count;
      ASSERT_TRUE(found != PROBE_UNKNOWN || is_near);
    }
  });
}

TEST(ZoneVerdicts, OfCapsulesAreSafeAndWithinFourUnits) {
  for_each_zone(60, 11, [](const Scene& scene, Random& random) {
    for (int i = 0; i < 100; ++i) {
      const Edge leg = delicate_leg(scene.edges, random);
      const std::int64_t radius = random.in(0, 2'000);
      const bool truth = where(scene.edges, leg.a) > 0 && !crosses(scene.edges, leg) &&
                         keeps(scene.edges, leg, radius);
      const bool with_room = where(scene.edges, leg.a) > 0 && !crosses(scene.edges, leg) &&
                             keeps(scene.edges, leg, radius + 4);
      // The disc is too large to be of help.
      const bool found =
          probe_reach_mm(scene.tables.get(), leg.a, leg.b, std::int64_t{1} << 32, radius) >= 0;
      ASSERT_TRUE(!found || truth || radius == 0) << radius;
      ASSERT_TRUE(found || !with_room) << radius;
    }
  });
}

TEST(ZoneVerdicts, OfUniformPlacesAndLegsAreAlmostAlwaysKnown) {
  // Of zones as people have them, metres to hundreds of metres wide.
  Random random(12);
  int places = 0, open_places = 0, open_legs = 0;
  while (places < 40'000) {
    const Family family =
        std::array{Family::star, Family::round, Family::fence}[std::size_t(random.in(0, 2))];
    const Scene scene(random_zone(family, random));
    std::int64_t width = 0;
    for (const Edge& e : scene.edges) width = std::max(width, e.a.x - scene.edges[0].a.x);
    if (width < 5'000 || !scene.tables) continue;
    for (int i = 0; i < 2'000; ++i, ++places) {
      const Place p = uniform_place(scene.edges, random), q = uniform_place(scene.edges, random);
      const Place plan[] = {p, q};
      open_places += verdict(probe_box_clearance(scene.tables.get(), {p.x, p.x, p.y, p.y}), 0) ==
                     PROBE_UNKNOWN;
      open_legs += probe_plan_in(scene.tables.get(), plan, 2, 1) == PROBE_UNKNOWN;
    }
  }
  EXPECT_LE(open_places * 200, places) << "0.5 %";
  EXPECT_LE(open_legs * 200, places) << "0.5 %";
}

}  // namespace
}  // namespace rtac::kernel_test
