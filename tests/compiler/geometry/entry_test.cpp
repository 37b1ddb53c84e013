// Of straight ways into a zone that are shown to stay in a fence, those that recoveries take do.
#include "compiler/geometry/entry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/geometry/looks.h"
#include "rooms.h"
#include "rtac/safe/manoeuvre.h"
#include "rtac/safe/pilot.h"
#include "testing.h"
#include "zone_view.h"

#include "tests/slow.h"

namespace rtac::geometry {
namespace {

safe::Setting setting_of(const ZoneView& zone) {
  safe::Setting s;
  s.limits.speed_mps = 1, s.limits.accel_mps2 = s.limits.brake_mps2 = 1;
  s.limits.radius_m = 0.2, s.limits.position_error_m = 0.01, s.limits.latency_us = 20'000;
  s.period_us = 100'000, s.speed_mps = 0.3, s.zone = &zone;
  s.route_clearance_m = 0.45, s.return_clearance_m = 0.7;
  return s;
}

// Of a retreat, and of ways over cells.
EntryQuery cart_query(const safe::Setting& setting) {
  const safe::Setting& s = setting;
  const double slack_m = safe::end_reach_m(s) + s.limits.position_error_m;
  const auto mm = [](double m) { return static_cast<std::int32_t>(std::lround(1e3 * m)); };
  const std::int32_t aim_mm = mm(s.return_clearance_m + slack_m);
  return {.clearance_mm = 200,
          .body_mm = 190,
          .least_mm = 200,
          .loss_mm = 2,
          .straight_mm = {aim_mm, mm(s.return_clearance_m), mm(s.route_clearance_m),
                          mm(s.limits.radius_m + slack_m)},
          .alone = EntryQuery::Alone{aim_mm, 0}};
}
const EntryQuery cart = cart_query(setting_of({}));
const EntryQuery courier{.clearance_mm = 200,
                         .body_mm = 190,
                         .least_mm = 200,
                         .loss_mm = 8,
                         .alone = EntryQuery::Alone{450, 480}};

class Ways {
 public:
  Ways(const Region& zone, const Region& fence)
      : zone_(bake(*snap_inside(zone), 100)), fence_(bake(*snap_inside(fence), 100)) {}

  [[nodiscard]] Entry shown(const EntryQuery& query) const {
    return entry({zone_.edges, zone_.cells}, {fence_.edges, fence_.cells}, query);
  }
  // The first legs from places in the fence, where no body fits in the zone, that lead too near to
  // the boundary of the former.
  int astray(bool retreats, int places = 1500) {
    const View zone(zone_), fence(fence_);
    safe::GridRoute route(*zone);
    const CellGrid& cells = fence_.cells;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(0, cells.columns * cells.cell_mm);
    std::uniform_real_distribution<double> y(0, cells.rows * cells.cell_mm);
    int astray = 0;
    for (int looked = 0, tried = 0; looked < places && tried < 200'000; ++tried) {
      const Vec2 p{1e-3 * (cells.origin.x_mm + x(random)), 1e-3 * (cells.origin.y_mm + y(random))};
      const double gap_m = signed_clearance(*fence, p);
      if (gap_m < 0.19 || signed_clearance(*zone, p) >= 0.2) continue;
      ++looked;
      const std::optional<Vec2> to = retreats ? retreat_from(*zone, p) : along(route, p);
      if (!to) continue;
      if (!keeps_clearance(*fence, p, *to, std::min(0.2, gap_m) - 0.01)) ++astray;
    }
    return astray;
  }

 private:
  static std::optional<Vec2> retreat_from(const ZoneView& zone, Vec2 p) {
    safe::RetreatManoeuvre retreat(setting_of(zone));
    Observation seen;
    seen.now_us = 1'000'000;
    seen.position = {p, seen.now_us};
    retreat.engage(seen);
    retreat.update(seen, seen.position.value, Gate::free, true);
    if (retreat.way().points.empty()) return std::nullopt;
    return retreat.way().points[0];
  }
  // Home, at a corner of the zone.
  std::optional<Vec2> along(safe::GridRoute& route, Vec2 p) const {
    const Vec2 home{1e-3 * (zone_.cells.origin.x_mm + 800), 1e-3 * (zone_.cells.origin.y_mm + 800)};
    Path way;
    if (!route.to_point({0.45, p, {}, {}}, home, way)) return std::nullopt;
    return way.points[0];
  }

  BakedZone zone_, fence_;
};

void expect_within(const Region& zone, const Region& fence) {
  Ways ways(zone, fence);
  for (const bool retreats : {true, false}) {
    const Entry found = ways.shown(retreats ? cart : courier);
    EXPECT_EQ(found.how, Entry::How::within) << found.place.x_mm << ", " << found.place.y_mm;
    EXPECT_EQ(ways.astray(retreats), 0);
  }
}

Region inset(const Region& region, long mm) {
  return *region.offset(q(-mm, 1000));
}

TEST(Entry, AroundAPillar) {
  const Region hall = box(0, 0, 7000, 6000).subtract(box(3000, 2500, 4000, 3500));
  expect_within(inset(hall, 300), hall);
}
TEST(Entry, AroundACorner) {
  const Region hall = box(0, 0, 9000, 9000).unite(box(9000, 0, 14'000, 4000));
  expect_within(inset(hall, 300), hall);
}
// Also once more, and of a zone with more edges more: trials of numbers end by what they take.
TEST(Entry, WhatASearchTakesIsCounted) {
  const Region hall = box(0, 0, 7000, 6000), pillar = box(3000, 2500, 4000, 3500);
  const auto taken = [&](const Region& zone) {
    Ways ways(zone, hall.subtract(pillar));
    const std::int64_t before = looks();
    (void)ways.shown(cart);
    return looks() - before;
  };
  const Region plain = inset(hall, 300).subtract(box(2700, 2200, 4300, 3800));
  const Region round = inset(hall, 300).subtract(*pillar.offset(q(300, 1000)));
  const std::int64_t once = taken(plain);
  EXPECT_EQ(taken(plain), once);
  EXPECT_GT(once, 100'000);
  EXPECT_GT(taken(round), 3 * once / 2);
}
// From the tip of a corner a far cell beyond another corner would do, if everything nearer were in
// the way of other robots: the way there leads no farther from the zone than the tip, and out.
TEST(Entry, OfARobotThatIsAloneToNoneThatIsFartherThanOneInSight) {
  const Region hall = box(0, 0, 6000, 6000).unite(box(6000, 0, 9000, 3000));
  expect_within(inset(hall, 300), hall);
  EntryQuery among_others = cart;
  among_others.alone.reset();
  EXPECT_EQ(Ways(inset(hall, 300), hall).shown(among_others).how, Entry::How::beyond);
}
TEST(Entry, InRandomRooms) {
  std::mt19937 random(29);
  int shown = 0;
  for (int i = 0; i < rooms_count() / 3; ++i) {
    const Region room = random_room(random);
    const long off = 220 + static_cast<long>(random() % 300);
    const Region zone = inset(room, off);
    if (zone.empty() || !snap_inside(zone)) continue;
    Ways ways(zone, room);
    for (const bool retreats : {true, false}) {
      if (ways.shown(retreats ? cart : courier).how != Entry::How::within) continue;
      ++shown;
      EXPECT_EQ(ways.astray(retreats, 150), 0) << "room " << i;
    }
  }
  EXPECT_GT(shown, rooms_count() / 12);
}

// Where no body fits between the two, whoever is in the zone has little of its clearance.
TEST(Entry, FromWhereTheZoneIsNarrowerThanTheFence) {
  std::mt19937 random(31);
  int shown = 0;
  for (int i = 0; i < rooms_count() / 6; ++i) {
    const Region room = random_room(random);
    const long off = 10 + static_cast<long>(random() % 190);
    const long x = 500 + static_cast<long>(random() % 3000);
    // along all walls, or along a gap
    const Region part =
        random() % 2 == 0 ? inset(room, off) : room.subtract(box(x, -100'000, x + off, 100'000));
    if (part.empty() || !snap_inside(part)) continue;
    Ways ways(part, room);
    for (const bool retreats : {true, false}) {
      if (ways.shown(retreats ? cart : courier).how != Entry::How::within) continue;
      ++shown;
      EXPECT_EQ(ways.astray(retreats, 150), 0) << "room " << i;
    }
  }
  EXPECT_GT(shown, rooms_count() / 40);
}
// Beside the wall of an arm that the zone leaves a hand's breadth of out: a leg round the corner of
// the room keeps no more than what is left of the clearance.
TEST(Entry, RoundACornerWithLittleToSpare) {
  const Region room = box(0, 1300, 4000, 4000);
  Ways ways(room.unite(box(3500, 1000, 7000, 1700)), room.unite(box(3500, 830, 7000, 1700)));
  EXPECT_EQ(ways.shown(cart).how, Entry::How::beyond);
  EXPECT_GT(ways.astray(true), 10);
}

// A retreat behind a wall with a door in it: straight is through the wall.
TEST(Entry, NotThroughAWall) {
  const Region hall = box(0, 0, 8000, 4000).subtract(box(4000, 0, 4400, 3000));
  Ways ways(box(4900, 500, 7500, 3500), hall);
  const Entry found = ways.shown(cart);
  EXPECT_EQ(found.how, Entry::How::beyond);
  EXPECT_LT(found.place.x_mm, 4400);
  EXPECT_GT(ways.astray(true), 100);
}

TEST(SlowTests, AreThere) {
  EXPECT_EQ(rtac::test::slow_tests_gone("compiler_geometry"), std::set<std::string>{});
}

}  // namespace
}  // namespace rtac::geometry
