// Outlines that have broken programs before, each with what must be answered there: rays through
// vertices, level edges, bays and holes that touch, vertices on one line, fences as people draw
// them. Places are written in grid units.
#include "tests/kernel/zones/exact_box.h"
#include "tests/kernel/zones/scene.h"

namespace rtac::kernel_test {
namespace {

struct Asked {
  Place p;
  bool in;
};
void expect(const Zone& zone, std::initializer_list<Asked> places) {
  const Scene scene(zone);
  for (const Asked& a : places) {
    EXPECT_EQ(where(scene.edges, a.p) >= 0, a.in) << "the case itself: " << a.p.x << " " << a.p.y;
    EXPECT_EQ(probe_box_in(scene.tables.get(), {a.p.x, a.p.x, a.p.y, a.p.y}), a.in ? 1 : -1)
        << zone << " at " << a.p.x << " " << a.p.y;
  }
}
std::int64_t leg(const Zone& zone, Place from, Place to) {
  return probe_leg_lo(tables_of(zone).get(), from, to);
}
// A lower bound that is close.
void expect_below(std::int64_t lower, std::int64_t distance) {
  EXPECT_LE(lower, distance);
  EXPECT_GE(lower, std::max<std::int64_t>(distance - 2, 0));
}
int plan(const Zone& zone, std::initializer_list<Place> places) {
  return probe_plan_in(tables_of(zone).get(), places.begin(), static_cast<int>(places.size()), 1);
}

TEST(ZoneCases, RaysThroughVerticesOfADiamondCountOnce) {
  const Zone diamond{"diamond", {{{0, -10}, {10, 0}, {0, 10}, {-10, 0}}}};
  expect(diamond, {{{-11, 0}, false}, {{-9, 0}, true}, {{0, 0}, true}, {{11, 0}, false}});
  expect(diamond, {{{-1, 10}, false}, {{-1, -10}, false}, {{1, 10}, false}, {{0, 9}, true}});
}

TEST(ZoneCases, TipsThatARayTouchesCountTwiceOrNot) {
  // Teeth up and down whose tips are level with the places.
  const Zone teeth{"teeth",
                   {{{0, 0},
                     {10, 10},
                     {20, 0},
                     {30, 10},
                     {40, 0},
                     {40, 30},
                     {30, 20},
                     {20, 30},
                     {10, 20},
                     {0, 30}}}};
  expect(teeth, {{{-1, 10}, false}, {{1, 10}, true}, {{9, 10}, true}, {{-1, 20}, false}});
  expect(teeth, {{{20, 10}, true}, {{20, 20}, true}, {{41, 10}, false}, {{10, 9}, false}});
  expect(teeth, {{{10, 21}, false}, {{30, 21}, false}, {{-5, 30}, false}, {{10, 30}, false}});
}

TEST(ZoneCases, LevelEdgesAreNoCrossings) {
  // Every row of vertices has an edge along it.
  const Zone steps{"steps",
                   {{{0, 0},
                     {30, 0},
                     {30, 10},
                     {20, 10},
                     {20, 20},
                     {30, 20},
                     {30, 30},
                     {0, 30},
                     {0, 20},
                     {10, 20},
                     {10, 10},
                     {0, 10}}}};
  expect(steps, {{{-1, 0}, false}, {{-1, 10}, false}, {{-1, 20}, false}, {{-1, 30}, false}});
  expect(steps, {{{5, 10}, true}, {{15, 10}, true}, {{25, 10}, true}, {{31, 10}, false}});
  expect(steps, {{{5, 11}, false}, {{15, 15}, true}, {{25, 19}, false}, {{5, 20}, true}});
}

TEST(ZoneCases, VerticesOnOneLineChangeNothing) {
  const Zone plain{"plain", {{{0, 0}, {60, 20}, {40, 80}, {-20, 60}}}};
  const Zone split{"split",
                   {{{0, 0},
                     {15, 5},
                     {30, 10},
                     {45, 15},
                     {60, 20},
                     {50, 50},
                     {40, 80},
                     {10, 70},
                     {-20, 60},
                     {-15, 45},
                     {-10, 30},
                     {-5, 15}}}};
  const Tables one = tables_of(plain), other = tables_of(split);
  for (std::int64_t x = -25; x <= 65; ++x) {
    for (std::int64_t y = -5; y <= 85; ++y) {
      const Box b{x, x + 1, y, y + 1};
      ASSERT_EQ(probe_box_in(one.get(), b), probe_box_in(other.get(), b)) << x << " " << y;
      ASSERT_LE(std::abs(probe_gap_lo(one.get(), {x, y}) - probe_gap_lo(other.get(), {x, y})), 2);
    }
  }
}

TEST(ZoneCases, HolesThatTouchTheFenceOrEachOtherLeaveNoGap) {
  const Zone yard{"yard",
                  {{{0, 0}, {120, 0}, {120, 120}, {0, 120}},
                   {{0, 60}, {20, 80}, {20, 40}},
                   {{40, 40}, {60, 60}, {60, 20}},
                   {{60, 60}, {60, 90}, {90, 90}}}};
  expect(yard, {{{1, 60}, false}, {{0, 60}, true}, {{60, 60}, true}, {{59, 59}, true}});
  expect(yard, {{{58, 57}, false}, {{61, 61}, true}, {{62, 63}, false}, {{0, 61}, true}});
  // Along the fence past the hole's tip, through the place where two holes touch: in the zone, on
  // its boundary. Beside these places: through the hole.
  EXPECT_NE(plan(yard, {{0, 40}, {0, 80}}), PROBE_FALSE);
  EXPECT_NE(plan(yard, {{50, 70}, {60, 60}, {70, 50}}), PROBE_FALSE);
  EXPECT_EQ(plan(yard, {{3, 40}, {3, 80}}), PROBE_FALSE);
  EXPECT_EQ(plan(yard, {{50, 70}, {61, 67}, {90, 80}}), PROBE_FALSE);
}

TEST(ZoneCases, PartsThatTouchAtACornerAreTwo) {
  const Zone board{
      "board", {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{10, 10}, {20, 10}, {20, 20}, {10, 20}}}};
  expect(board,
         {{{5, 5}, true}, {{15, 15}, true}, {{10, 10}, true}, {{11, 9}, false}, {{9, 11}, false}});
  // The way through the corner stays in the zone, but no body does.
  EXPECT_NE(plan(board, {{5, 5}, {15, 15}}), PROBE_TRUE);
  EXPECT_EQ(plan(board, {{5, 5}, {12, 5}}), PROBE_FALSE);
  EXPECT_EQ(plan(board, {{5, 7}, {15, 18}}), PROBE_FALSE);
}

TEST(ZoneCases, IslandsInLakesAreIn) {
  const auto square = [](std::int64_t r, bool hole) {
    const Ring ring{{-r, -r}, {r, -r}, {r, r}, {-r, r}};
    return hole ? Ring(ring.rbegin(), ring.rend()) : ring;
  };
  Zone nested{"nested", {}};
  for (std::int64_t k = 8; k > 0; --k) nested.rings.push_back(square(100 * k, k % 2 == 1));
  for (std::int64_t k = 1; k <= 8; ++k) {
    const bool in = k % 2 == 0;
    expect(nested,
           {{{100 * k - 50, 3}, in}, {{3, 50 - 100 * k}, in}, {{50 - 100 * k, 100 * k - 50}, in}});
    expect(nested, {{{100 * k, 100 * k}, true}, {{-100 * k, 7}, true}});
  }
}

TEST(ZoneCases, LegsThatCutACornerAreCaught) {
  const Zone room{"room",
                  {{{0, 0}, {9000, 0}, {9000, 4000}, {4000, 4000}, {4000, 9000}, {0, 9000}}}};
  EXPECT_EQ(plan(room, {{8500, 3500}, {3500, 8500}}), PROBE_FALSE);
  EXPECT_EQ(plan(room, {{8500, 3500}, {3500, 3500}, {3500, 8500}}), PROBE_TRUE);
  EXPECT_EQ(leg(room, {4501, 3500}, {3500, 4500}), -1);  // by less than half a millimetre
  EXPECT_EQ(leg(room, {4500, 3500}, {3500, 4500}), 0);   // through the corner
  EXPECT_GE(leg(room, {4500, 3490}, {3490, 4500}), 5);
}

TEST(ZoneCases, LegsAlongAFenceAndAcrossAGateAreToldApart) {
  // Two yards with a gate of 1 m in the wall of 200 mm between them.
  const Zone yards{"yards",
                   {{{0, 0},
                     {5000, 0},
                     {5000, 2000},
                     {5200, 2000},
                     {5200, 0},
                     {9000, 0},
                     {9000, 6000},
                     {5200, 6000},
                     {5200, 3000},
                     {5000, 3000},
                     {5000, 6000},
                     {0, 6000}}}};
  EXPECT_EQ(plan(yards, {{4000, 2500}, {6000, 2500}}), PROBE_TRUE);
  EXPECT_EQ(plan(yards, {{4000, 1000}, {6000, 1000}}), PROBE_FALSE);
  EXPECT_EQ(plan(yards, {{4000, 3110}, {6000, 2910}}), PROBE_FALSE);
  expect_below(leg(yards, {4000, 2500}, {6000, 2500}), 500);
  EXPECT_EQ(leg(yards, {5000, 100}, {5000, 1900}), 0);  // along the wall
  expect_below(leg(yards, {4999, 100}, {4999, 1900}), 1);
  expect_below(leg(yards, {4990, 100}, {4990, 1900}), 10);
  EXPECT_EQ(leg(yards, {4999, 1900}, {5001, 1900}), -1);
}

TEST(ZoneCases, NeedlesAndSlitsOfOneUnitAreSeen) {
  // A slit 1 mm wide from the top almost to the bottom, a needle 1 mm thick to the right.
  const Zone odd{"odd",
                 {{{0, 0},
                   {1000, 0},
                   {1000, 500},
                   {90000, 500},
                   {90000, 501},
                   {1000, 501},
                   {1000, 1000},
                   {501, 1000},
                   {501, 10},
                   {500, 10},
                   {500, 1000},
                   {0, 1000}}}};
  expect(odd,
         {{{500, 500}, true}, {{501, 500}, true}, {{89999, 500}, true}, {{89999, 502}, false}});
  EXPECT_EQ(probe_box_in(tables_of(odd).get(), {500, 501, 500, 501}), 0);  // touches on both sides
  EXPECT_EQ(leg(odd, {400, 500}, {600, 500}), -1);
  EXPECT_GT(leg(odd, {400, 5}, {600, 5}), 2);
  EXPECT_EQ(plan(odd, {{900, 500}, {80000, 501}}), PROBE_UNKNOWN);
  EXPECT_EQ(plan(odd, {{900, 400}, {80000, 400}}), PROBE_FALSE);
}

TEST(ZoneCases, AFieldOfRepeatedPillarsHasTheSameAnswersAboutEachOfThem) {
  const std::int64_t pitch = 700, pillar = 200;
  Zone hall{
      "hall",
      {{{-pitch, -pitch}, {12 * pitch, -pitch}, {12 * pitch, 12 * pitch}, {-pitch, 12 * pitch}}}};
  for (std::int64_t k = 0; k < 100; ++k) {
    const std::int64_t x = k % 10 * pitch, y = k / 10 * pitch;
    hall.rings.push_back({{x, y}, {x, y + pillar}, {x + pillar, y + pillar}, {x + pillar, y}});
  }
  const Tables tables = tables_of(hall);
  for (std::int64_t dx = -30; dx <= pillar + 30; dx += 23) {
    for (std::int64_t dy = -30; dy <= pillar + 30; dy += 23) {
      const int in = probe_inside(tables.get(), {dx, dy});
      const std::int64_t gap = probe_gap_lo(tables.get(), {dx, dy});
      for (std::int64_t k = 1; k < 100; ++k) {
        const Place p{dx + k % 10 * pitch, dy + k / 10 * pitch};
        ASSERT_EQ(probe_inside(tables.get(), p), in);
        ASSERT_LE(std::abs(probe_gap_lo(tables.get(), p) - gap), 2);
      }
    }
  }
}

TEST(ZoneCases, TurnedAndMirroredZonesHaveTheSameAnswers) {
  // About the axes: what is level becomes upright, rays run the other way along an outline.
  Random random(31);
  for (int i = 0; i < 39; ++i) {
    const Zone zone = random_zone(static_cast<Family>(i % static_cast<int>(Family::count)), random);
    Zone turned = zone, mirrored = zone;
    for (Ring& ring : turned.rings) {
      for (Place& p : ring) p = {-p.y, p.x};
    }
    for (Ring& ring : mirrored.rings) {
      for (Place& p : ring) p = {-p.x, p.y};
      std::reverse(ring.begin(), ring.end());
    }
    const Scene scene(zone);
    const Tables quarter = tables_of(turned), mirror = tables_of(mirrored);
    if (!scene.tables || !quarter || !mirror) continue;
    for (int k = 0; k < 500; ++k) {
      const Edge l = delicate_leg(scene.edges, random);
      const Place p = l.a, q{-p.y, p.x}, r{-p.x, p.y};
      if (where(scene.edges, p) != 0) {
        const int in = probe_inside(scene.tables.get(), p);
        ASSERT_TRUE(probe_inside(quarter.get(), q) == in && probe_inside(mirror.get(), r) == in)
            << zone;
      }
      const bool leaves = probe_leg_lo(scene.tables.get(), p, l.b) < 0;
      ASSERT_EQ(probe_leg_lo(quarter.get(), q, {-l.b.y, l.b.x}) < 0, leaves) << zone;
      ASSERT_EQ(probe_leg_lo(mirror.get(), r, {-l.b.x, l.b.y}) < 0, leaves) << zone;
    }
  }
}

TEST(ZoneCases, AnAirfieldFenceKeepsItsAprons) {
  // In metres off a reference point 300 km away: runways, a notch for a road, two pans.
  const std::int64_t x0 = 300'000'000, y0 = -250'000'000;
  Zone field{
      "airfield",
      {{{0, 0},
        {2750, 40},
        {2810, 300},
        {2260, 310},
        {2250, 420},
        {2400, 700},
        {1700, 910},
        {1650, 330},
        {900, 320},
        {880, 605},
        {310, 640},
        {300, 310},
        {-60, 300}}},
  };
  field.rings.push_back({{500, 400}, {500, 560}, {700, 550}, {690, 400}});
  for (Ring& ring : field.rings) {
    for (Place& p : ring) p = {x0 + 1000 * p.x, y0 + 1000 * p.y};
  }
  const auto at = [&](std::int64_t x, std::int64_t y) {
    return Place{x0 + 1000 * x, y0 + 1000 * y};
  };
  expect(field, {{at(1000, 200), true}, {at(600, 450), false}, {at(400, 500), true}});
  expect(field, {{at(1200, 500), false}, {at(2000, 700), true}, {at(2700, 305), false}});
  EXPECT_EQ(plan(field, {at(20, 150), at(2700, 200)}), PROBE_TRUE);
  EXPECT_EQ(plan(field, {at(400, 500), at(800, 500)}), PROBE_FALSE);   // over the pan
  EXPECT_EQ(plan(field, {at(800, 500), at(1800, 600)}), PROBE_FALSE);  // over the notch
  EXPECT_EQ(plan(field, {at(800, 500), at(800, 250), at(1800, 250), at(1800, 600)}), PROBE_TRUE);
}

}  // namespace
}  // namespace rtac::kernel_test
