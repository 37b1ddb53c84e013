// Who has come to rest looks from the place that it holds, at the places that others hold, whatever
// is measured from then on.
#include <gtest/gtest.h>

#include "rtac/safe/controllers.h"
#include "tests/runtime/core/test_plants.h"
#include "tests/runtime/core/test_zone.h"

namespace rtac::safe {
namespace {

using test::Plant;

const ZoneView& room() {
  static const test::TestZone zone({{{0, 0}, {5000, 0}, {5000, 5000}, {0, 5000}}});
  return zone.view();
}

Setting setting_of(const RobotLimits& limits) {
  Setting s;
  s.limits = limits, s.period_us = 100'000, s.speed_mps = 0.15, s.zone = &room();
  s.route_clearance_m = 0.2, s.return_clearance_m = 0.45, s.pass_gap_m = 0.7;
  return s;
}
template <class Output>
RobotLimits limits_of();
template <>
RobotLimits limits_of<Twist>() {
  return test::cart_limits();
}
template <>
RobotLimits limits_of<Acceleration>() {
  return test::drone_limits();
}

// The first of two that hold 0.4 m from each other: its way, once it wants one. Measurements are
// exact while it comes to rest, and off by `error` after that: its own, and of the other one the
// opposite.
template <class Output>
Path way_of_first(Vec2 error) {
  const Setting setting = setting_of(limits_of<Output>());
  Plant<Output> plant(setting.limits, {2.5, 2.5});
  plant.noisy = 0;
  plant.seen.robots = 2;
  const Vec2 there{2.5, 2.9};
  Announcement& other = plant.seen.others[1];
  other.position = {there, 0}, other.velocity = {{0, 0}, 0};
  other.lease_end_us = INT64_MAX / 2, other.claims = true;
  other.hold = Vec3{there.x, there.y, 0};
  Yield<Output> yield(setting);
  yield.engage(plant.observe());
  const auto fly = [&](Vec2 off) {
    Observation seen = plant.observe();
    seen.position.value = seen.position.value + off;
    seen.others[1].position.value = there - off;
    plant.apply(yield.command(seen, Gate::hold), setting.period_us);
  };
  for (int i = 0; i < 10; ++i) fly({});
  EXPECT_TRUE(yield.holding());
  for (int i = 0; i < 30 && yield.path() == nullptr; ++i) fly(error);
  EXPECT_NE(yield.path(), nullptr);
  return yield.path() != nullptr ? *yield.path() : Path{};
}

template <class Output>
void expect_the_same_way() {
  const Path exact = way_of_first<Output>({});
  const double error_m = limits_of<Output>().position_error_m;
  for (const Vec2 error : {Vec2{0, error_m}, Vec2{0, -error_m}, Vec2{error_m, 0}}) {
    const Path way = way_of_first<Output>(error);
    ASSERT_EQ(way.points.size(), exact.points.size());
    for (std::size_t i = 0; i < way.points.size(); ++i) {
      EXPECT_LT(norm(way.points[i] - exact.points[i]), 1e-9);
    }
  }
}
TEST(HeldPlaces, AreWhereWheelsLookFrom) {
  expect_the_same_way<Twist>();
}
TEST(HeldPlaces, AreWherePointMassesLookFrom) {
  expect_the_same_way<Acceleration>();
}

// A leg that passes beside a place leads nowhere nearer to it from its beginning on, and so it does
// where errors put the robot behind that.
template <class Output>
void expect_to_recede() {
  const Setting setting = setting_of(limits_of<Output>());
  Plant<Output> plant(setting.limits, {2.5, 2.5});
  plant.noisy = 0;
  Pilot<Output> pilot(setting);
  pilot.engage(plant.observe());
  for (int i = 0; i < 10; ++i) plant.apply(pilot.halt(plant.observe()), setting.period_us);
  ASSERT_TRUE(pilot.latched());
  const Vec2 target{4, 2.5}, beside{2.5, 2.9}, ahead{2.6, 2.9};
  Path way;
  ASSERT_TRUE(way.points.push(target));
  const auto recedes = [&](Vec2 from) {
    Observation seen = plant.observe();
    seen.position.value.x -= setting.limits.position_error_m;
    return pilot.recedes(seen, pilot.on_way(seen), target, from);
  };
  EXPECT_TRUE(recedes(beside));
  EXPECT_FALSE(recedes(ahead));
  plant.apply(test::driven(pilot, plant, way), setting.period_us);
  ASSERT_FALSE(pilot.latched());
  EXPECT_TRUE(recedes(beside));
  EXPECT_FALSE(recedes(ahead));
}
TEST(HeldPlaces, WheelsRecedeFromThem) {
  expect_to_recede<Twist>();
}
TEST(HeldPlaces, PointMassesRecedeFromThem) {
  expect_to_recede<Acceleration>();
}

// Wheels that are at rest are so for whoever takes over, at the place that was told.
TEST(HeldPlaces, OfWheelsAreHandedOn) {
  const Setting setting = setting_of(limits_of<Twist>());
  Plant<Twist> plant(setting.limits, {2.5, 2.5});
  BrakeAndHold<Twist> one(setting);
  Yield<Twist> two(setting);
  one.engage(plant.observe());
  EXPECT_FALSE(one.halt()->latched);
  for (int i = 0; i < 10; ++i) test::tick(one, plant, Gate::hold, setting.period_us);
  ASSERT_TRUE(one.holding());
  const Halt halt = *one.halt();
  EXPECT_LT(norm(Vec2{halt.place.x, halt.place.y} - plant.p), setting.limits.position_error_m);
  two.engage(plant.observe());
  EXPECT_FALSE(two.holding());
  two.go_on(halt);
  EXPECT_TRUE(two.holding());
  test::tick(two, plant, Gate::hold, setting.period_us);
  EXPECT_TRUE(two.holding());
  EXPECT_EQ(norm(two.halt()->place - halt.place), 0);
}

}  // namespace
}  // namespace rtac::safe
