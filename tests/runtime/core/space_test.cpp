// A retreat in space finds its way however long it is: in a hall of a kilometre that widens from 2
// m to 3 m, every place with enough clearance is hundreds of metres away.
#include "rtac/safe/space.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/runtime/core/test_plants.h"
#include "tests/runtime/core/test_zone.h"

namespace rtac::safe {
namespace {

// Whether a robot that has come to rest carries its hold away, so that it is pulled.
bool is_pulled(Gate gate, Vec3 held) {
  Setting setting;
  setting.limits = test::drone_limits();
  setting.limits.in_space = true;
  setting.period_us = 50'000;
  setting.speed_mps = 0.5;
  setting.land_at_m = 1;
  Land land(setting);
  Observation seen;
  seen.robots = 2;
  seen.position.value = {5, 5};
  seen.height_m = 4;
  Announcement& other = seen.others[1];
  other.position.value = {held.x, held.y};
  other.height_m = held.z;
  land.engage(seen);
  Acceleration command{};
  for (TimeUs now_us = 0; now_us < 5'000'000; now_us += setting.period_us) {
    seen.now_us = seen.position.stamp_us = seen.velocity.stamp_us = now_us;
    other.position.stamp_us = now_us;
    other.lease_end_us = now_us + 500'000;
    command = land.command(seen, gate);
  }
  return command.up_mps2 < -0.01;
}

// Past robots that promised to stay it goes on only where its leg, straight down, brings it nearer
// to none of them.
TEST(CarriedInSpace, RecedesFromRobotsThatAreHeldByHeightToo) {
  EXPECT_TRUE(is_pulled(Gate::free, {5, 5, 2}));
  EXPECT_FALSE(is_pulled(Gate::hold, {5, 5, 6}));
  EXPECT_TRUE(is_pulled(Gate::away_only, {5, 5, 6}));
  EXPECT_TRUE(is_pulled(Gate::away_only, {9, 5, 4.5}));
  EXPECT_FALSE(is_pulled(Gate::away_only, {5, 5, 2}));
  EXPECT_FALSE(is_pulled(Gate::away_only, {9, 5, 3.5}));
}

// When a landing has ended, in s, of a robot that measures its climb wrong, and that something
// pushes up, all the time; 120: never.
double landed_s(double bias_mps, double push_mps2) {
  Setting setting;
  setting.limits = test::drone_limits();
  setting.limits.in_space = true;
  setting.limits.velocity_error_mps = std::fabs(bias_mps);
  setting.limits.disturbance_mps2 = std::fabs(push_mps2);
  setting.period_us = 50'000;
  setting.speed_mps = 0.5;
  setting.land_at_m = 1;
  Land land(setting);
  Observation seen;
  seen.robots = 1;
  double z = 4, climb = 0;
  land.engage(seen);
  bool set_out = false;
  for (TimeUs now_us = 0; now_us < 120'000'000; now_us += setting.period_us) {
    seen.now_us = seen.position.stamp_us = seen.velocity.stamp_us = now_us;
    seen.height_m = z, seen.climb_mps = climb + bias_mps;
    const double up_mps2 = land.command(seen, Gate::free).up_mps2 + push_mps2;
    set_out = set_out || !land.holding();
    if (set_out && z < 2 && land.holding()) return 1e-6 * static_cast<double>(now_us);
    for (TimeUs t = 0; t < setting.period_us; t += test::step_us) {
      climb += 1e-6 * static_cast<double>(test::step_us) * up_mps2;
      z += 1e-6 * static_cast<double>(test::step_us) * climb;
    }
  }
  return 120;
}

// It rests beside the place that it holds, by as much as what lasts takes from its spring.
TEST(CarriedInSpace, LegsEndWhateverLasts) {
  for (const double bias_mps : {-0.1, -0.03, 0.0, 0.03, 0.1}) {
    for (const double push_mps2 : {-0.3, 0.0, 0.3}) {
      EXPECT_LT(landed_s(bias_mps, push_mps2), 20) << bias_mps << " m/s, " << push_mps2 << " m/s^2";
    }
  }
}

// Whether a robot that has come to rest sets out.
bool sets_out(const Setting& setting, Vec2 from, double height_m) {
  RetreatInSpace retreat(setting);
  Observation seen;
  seen.height_m = height_m;
  seen.position.value = from;
  retreat.engage(seen);
  bool held = false;
  for (TimeUs now_us = 0; now_us < 5'000'000; now_us += setting.period_us) {
    seen.now_us = seen.position.stamp_us = seen.velocity.stamp_us = now_us;
    (void)retreat.command(seen, Gate::free);
    if (held && !retreat.holding()) return true;
    held = held || retreat.holding();
  }
  return false;
}

TEST(RetreatInSpace, SeesAPlaceAtTheEndOfALongCorridor) {
  const test::TestZone corridor({{{0, 0}, {200'000, 0}, {200'000, 1'000}, {0, 800}}}, 40);
  const SlabView slab{&corridor.view(), 0, 4};
  const SolidView solid{"corridor", &slab, 1};
  Setting setting;
  setting.limits = test::drone_limits();
  setting.limits.in_space = true;
  setting.period_us = 50'000;
  setting.speed_mps = 0.5;
  setting.route_clearance_m = 0.4;
  setting.return_clearance_m = 0.45;
  setting.solid = &solid;
  EXPECT_TRUE(sets_out(setting, {1, 0.4}, 2));
  setting.return_clearance_m = 0.6;  // nowhere
  EXPECT_FALSE(sets_out(setting, {1, 0.4}, 2));
}

// Over a crane, under a ledge, between the two: whatever is nested upwards or downwards towards a
// convex slab leads there at a glance, from wherever a robot has come to rest.
TEST(RetreatInSpace, FindsAWayOutOfNestedSlabs) {
  const test::TestZone beside_crane(
      {{{0, 0}, {9'000, 0}, {9'000, 9'000}, {0, 9'000}},
       {{6'000, 6'000}, {6'000, 7'000}, {7'000, 7'000}, {7'000, 6'000}}});
  const test::TestZone hall(test::square_rings(9'000));
  const test::TestZone loft({{{0, 0}, {5'000, 0}, {5'000, 9'000}, {0, 9'000}}});
  const std::array<SlabView, 3> slabs{
      {{&beside_crane.view(), 0, 4}, {&hall.view(), 4, 6}, {&loft.view(), 6, 10}}};
  const SolidView solid{"shed", slabs.data(), slabs.size()};
  Setting setting;
  setting.limits = test::drone_limits();
  setting.limits.in_space = true;
  setting.period_us = 50'000;
  setting.speed_mps = 0.5;
  setting.route_clearance_m = 0.5;
  setting.return_clearance_m = 0.9;
  setting.solid = &solid;
  test::Noise noise;
  int starts = 0;
  while (starts < 400) {
    const Vec2 at{4.5 + noise.scalar(4.5), 4.5 + noise.scalar(4.5)};
    const double height_m = 5 + noise.scalar(5);
    const double clear_m = signed_clearance(solid, {at.x, at.y, height_m});
    if (clear_m < setting.limits.radius_m || clear_m >= setting.return_clearance_m) continue;
    ++starts;
    EXPECT_TRUE(sets_out(setting, at, height_m)) << at.x << ", " << at.y << ", " << height_m;
  }
}

// Outside, nothing is clear at a glance. Of a stack of many slabs it looks at so many heights that
// its glances are spent on them: each way of looking has looks of its own.
TEST(RetreatInSpace, GlancesTakeNoLooksAwayFromPieces) {
  const test::TestZone hall(test::square_rings(9'000));
  std::array<SlabView, 40> slabs;
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    const auto floor_m = static_cast<double>(i);
    slabs[i] = {&hall.view(), floor_m, floor_m + 1};
  }
  const SolidView solid{"tower", slabs.data(), slabs.size()};
  Setting setting;
  setting.limits = test::drone_limits();
  setting.limits.in_space = true;
  setting.period_us = 50'000;
  setting.speed_mps = 0.5;
  setting.route_clearance_m = 0.5;
  setting.return_clearance_m = 0.9;
  setting.solid = &solid;
  EXPECT_TRUE(sets_out(setting, {-0.05, 4.5}, 20.5));
}

}  // namespace
}  // namespace rtac::safe
