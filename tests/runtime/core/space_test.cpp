// A retreat in space finds its way however long it is: in a hall of a kilometre that widens from 2
// m to 3 m, every place with enough clearance is hundreds of metres away.
#include "rtac/safe/space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "rtac/safe/controllers.h"
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

// A robot that flies straight down at 1 m/s on `land`, and what becomes of it.
class Stopping : public ::testing::Test {
 protected:
  Stopping() : land_(setting()) {
    seen_.robots = 1;
    sense({});
    land_.engage(seen_);
  }
  static Setting setting() {
    Setting s;
    s.limits = test::drone_limits();
    s.limits.in_space = true;
    s.period_us = 50'000;
    s.speed_mps = 1;
    s.land_at_m = 1;
    return s;
  }
  // In a straight stop from the speed of the recovery, what it comes on until its brake acts and
  // where its hold sways included.
  static double stop_m() {
    const double lag_s = 0.05 + 1e-6 * double(setting().limits.latency_us);
    return 1 / (2 * setting().limits.brake_mps2) + 2 * lag_s + 0.05;
  }
  void sense(Vec3 off) {
    seen_.now_us = seen_.position.stamp_us = seen_.velocity.stamp_us = now_us_;
    seen_.position.value = {at_.x + off.x, at_.y + off.y}, seen_.height_m = at_.z + off.z;
    seen_.velocity.value = {v_.x, v_.y}, seen_.climb_mps = v_.z;
  }
  void move(const Acceleration& a) {
    const Vec3 push{a.value_mps2.x, a.value_mps2.y, a.up_mps2};
    for (TimeUs t = 0; t < setting().period_us; t += test::step_us) {
      v_ = v_ + (1e-6 * double(test::step_us)) * push;
      at_ = at_ + (1e-6 * double(test::step_us)) * v_;
    }
    now_us_ += setting().period_us;
  }
  void fly(SafeController<Acceleration>& recovery, Gate gate, double for_s, bool sees = true) {
    for (double t = 0; t < for_s; t += 1e-6 * double(setting().period_us)) {
      sense({});
      if (!sees) seen_.position.stamp_us = seen_.velocity.stamp_us = blind_since_us_;
      move(recovery.command(seen_, gate));
      if (sees) blind_since_us_ = seen_.now_us;
    }
  }
  void fly_down() {
    fly(land_, Gate::free, 8);
    ASSERT_GT(-v_.z, 0.9);
    from_m_ = at_.z;
  }

  Land land_;
  Observation seen_;
  Vec3 at_{5, 5, 20}, v_{};
  TimeUs now_us_ = 0, blind_since_us_ = 0;
  double from_m_ = 0;
};

// The hold leads the robot by more than a stop takes: it brakes.
TEST_F(Stopping, IsABrakeWhereTheGateCloses) {
  fly_down();
  fly(land_, Gate::hold, 10);
  EXPECT_LT(norm(v_), 0.01);
  EXPECT_LT(from_m_ - at_.z, stop_m());
  fly(land_, Gate::free, 60);
  EXPECT_NEAR(at_.z, 1, 0.05);  // and goes on afterwards
}

TEST_F(Stopping, IsABrakeWhereAnotherRecoveryTakesOver) {
  fly_down();
  BrakeAndHold<Acceleration> stop(setting());
  sense({});
  const std::optional<Halt> halt = land_.halt();
  stop.engage(seen_);
  if (halt) stop.go_on(*halt);
  fly(stop, Gate::free, 10);
  EXPECT_LT(norm(v_), 0.01);
  EXPECT_LT(from_m_ - at_.z, stop_m());
}

TEST_F(Stopping, IsABrakeWhereItSeesNothing) {
  fly_down();
  fly(land_, Gate::free, 3, false);
  EXPECT_LT(norm(v_), 0.15);  // what is left after whole periods of the brake
  EXPECT_LT(from_m_ - at_.z, stop_m() + 0.2 + 3 * 0.15);  // and until its samples are too old
}

// Stop by stop on a leg that a gate or another recovery keeps breaking off, with every place that
// is latched measured wrong to one side and every other one to the other: it stays on its leg.
TEST_F(Stopping, DoesNotWanderOffStopByStop) {
  BrakeAndHold<Acceleration> stop(setting());
  const double error_m = setting().limits.position_error_m;
  for (const int open_ticks : {4, 12, 24}) {
    at_ = {5, 5, 20}, v_ = {};
    SafeController<Acceleration>*drives = &land_, *other = &stop;
    sense({});
    drives->engage(seen_);
    double aside_m = 0;
    for (int k = 0; k < 2400 && at_.z > 2; ++k) {
      // wrong to where it drifts while it brakes, right once it holds
      const bool open = k % (3 * open_ticks) < open_ticks;
      sense({open ? 0 : error_m, 0, 0});
      if (k % 60 == 59) {
        const std::optional<Halt> halt = drives->halt();
        std::swap(drives, other);
        drives->engage(seen_);
        if (halt) drives->go_on(*halt);
      }
      move(drives->command(seen_, open ? Gate::free : Gate::hold));
      aside_m = std::max(aside_m, std::hypot(at_.x - 5, at_.y - 5));
    }
    EXPECT_LT(at_.z, open_ticks > 4 ? 18.0 : 19.9) << open_ticks;  // it gets on
    EXPECT_LT(aside_m, 2 * error_m + 0.01) << open_ticks;
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

// From what is left out over a wide roof every level leg is long, and not seen to be clear but
// piece by piece.
TEST(RetreatInSpace, LooksStraightUpBeforeItLooksFarBeside) {
  const test::TestZone beside_hall(
      {{{0, 0}, {60'000, 0}, {60'000, 60'000}, {0, 60'000}},
       {{5'000, 5'000}, {5'000, 55'000}, {55'000, 55'000}, {55'000, 5'000}}},
      400);
  const test::TestZone above(test::square_rings(60'000), 400);
  const std::array<SlabView, 2> slabs{{{&beside_hall.view(), 0, 8}, {&above.view(), 8, 20}}};
  const SolidView solid{"over_the_hall", slabs.data(), slabs.size()};
  Setting setting;
  setting.limits = test::drone_limits();
  setting.limits.in_space = true;
  setting.period_us = 50'000;
  setting.speed_mps = 0.5;
  setting.route_clearance_m = 0.5;
  setting.return_clearance_m = 0.9;
  setting.solid = &solid;
  for (const double under_m : {0.001, 0.05, 0.5, 1.5}) {
    EXPECT_TRUE(sets_out(setting, {30, 30}, 8 - under_m)) << under_m;
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

// What a robot does that loiters and is never given control back, in a cube of 9 m.
struct Laps {
  double first_rest_s = 0;   // at rest before it sets out for the first time
  double least_clear_m = 9;  // of all places
  double farthest_m = 0;     // from where it came to rest at last, in the second half
  double fastest_mps = 0;    // once it has come to rest
  int sets_out = 0;
};
Laps loiter(const Setting& setting, Vec3 at, Vec3 position_off, Vec3 velocity_off, double until_s) {
  LoiterInSpace loiters(setting);
  Observation seen;
  seen.robots = 1;
  Vec3 v{};
  const auto sense = [&](TimeUs now_us) {
    const Vec3 p = at + position_off, w = v + velocity_off;
    seen.now_us = seen.position.stamp_us = seen.velocity.stamp_us = now_us;
    seen.position.value = {p.x, p.y}, seen.height_m = p.z;
    seen.velocity.value = {w.x, w.y}, seen.climb_mps = w.z;
  };
  sense(0);
  loiters.engage(seen);
  Laps laps;
  std::optional<Vec3> centre;
  bool held = false;
  for (TimeUs now_us = 0; now_us < TimeUs(1e6 * until_s); now_us += setting.period_us) {
    sense(now_us);
    const Acceleration a = loiters.command(seen, Gate::free);
    const Vec3 push{a.value_mps2.x, a.value_mps2.y, a.up_mps2};
    laps.sets_out += held && !loiters.holding() ? 1 : 0;
    held = loiters.holding();
    if (held && laps.sets_out == 0) laps.first_rest_s += 1e-6 * double(setting.period_us);
    if (held && double(now_us) > 0.5e6 * until_s && !centre) centre = at;
    if (centre) laps.farthest_m = std::max(laps.farthest_m, norm(at - *centre));
    for (TimeUs t = 0; t < setting.period_us; t += test::step_us) {
      v = v + (1e-6 * double(test::step_us)) * push;
      at = at + (1e-6 * double(test::step_us)) * v;
    }
    laps.least_clear_m = std::min(laps.least_clear_m, signed_clearance(*setting.solid, at));
    if (held || laps.sets_out > 0) laps.fastest_mps = std::max(laps.fastest_mps, norm(v));
  }
  return laps;
}

class LoiteringInSpace : public ::testing::Test {
 protected:
  LoiteringInSpace() {
    setting.limits = test::drone_limits();
    setting.limits.in_space = true;
    setting.period_us = 50'000;
    setting.speed_mps = 0.5;
    setting.route_clearance_m = 0.5;
    setting.return_clearance_m = 0.9;
    setting.solid = &cube;
  }
  // Laps of half a metre, and back to their centre, with a rest before each that is longer than the
  // dwell of a decision.
  void expect_laps(Vec3 start, Vec3 position_off, Vec3 velocity_off, int setting_out) {
    const Laps laps = loiter(setting, start, position_off, velocity_off, 120);
    EXPECT_GE(laps.first_rest_s, 12 * 0.05);
    EXPECT_GE(laps.sets_out, setting_out);
    EXPECT_GT(laps.farthest_m, 0.3);
    EXPECT_LT(laps.farthest_m, 1.2);
    EXPECT_LT(laps.fastest_mps, setting.speed_mps + 0.05);
    EXPECT_GE(laps.least_clear_m, setting.return_clearance_m - 0.1);
  }

  const test::TestZone hall{test::square_rings(9'000)};
  const SlabView slab{&hall.view(), 0, 9};
  const SolidView cube{"cube", &slab, 1};
  Setting setting;
};

TEST_F(LoiteringInSpace, DrivesLapsWhereThereIsRoom) {
  expect_laps({4.5, 4.5, 4.5}, {}, {}, 5);
}

TEST_F(LoiteringInSpace, GoesWhereThereIsRoomAfterARest) {
  expect_laps({1.1, 4.5, 8}, {}, {}, 5);
}

TEST_F(LoiteringInSpace, DrivesLapsWhateverErrorsLast) {
  const double p = setting.limits.position_error_m, v = setting.limits.velocity_error_mps;
  expect_laps({4.5, 4.5, 4.5}, {p, 0, 0}, {v, 0, 0}, 4);
  expect_laps({1.1, 4.5, 8}, {p, 0, 0}, {-v, 0, 0}, 4);
}

TEST_F(LoiteringInSpace, RestsWhereThereIsNone) {
  setting.return_clearance_m = 4.4;
  const Laps laps = loiter(setting, {4.5, 4.5, 4.5}, {}, {}, 60);
  EXPECT_EQ(laps.sets_out, 0);
  EXPECT_LT(laps.farthest_m, 0.01);
}

}  // namespace
}  // namespace rtac::safe
