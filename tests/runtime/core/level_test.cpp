// Routes and yields in space: at the height where the robot has come to rest, along the ways that
// the manoeuvres of the plane find.
#include "rtac/safe/level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "rtac/safe/controllers.h"
#include "tests/runtime/core/test_plants.h"
#include "tests/runtime/core/test_zone.h"

namespace rtac::safe {
namespace {

// 8 m x 6 m with a wall in the middle that leaves 2 m free on its north side.
const test::TestZone& hall() {
  static const test::TestZone zone({{{0, 0},
                                     {3800, 0},
                                     {3800, 4000},
                                     {4200, 4000},
                                     {4200, 0},
                                     {8000, 0},
                                     {8000, 6000},
                                     {0, 6000}}});
  return zone;
}
constexpr Vec2 site{7, 1};
constexpr double height_m = 2.5;

Setting flyer() {
  Setting s;
  s.limits = test::drone_limits();
  s.limits.in_space = true;
  s.period_us = 50'000, s.speed_mps = 0.5;
  s.zone = &hall().view();
  s.route_clearance_m = 0.3, s.return_clearance_m = 0.6, s.pass_gap_m = 0.9;
  return s;
}

// A point mass in space, its measurements and what it hears of one other robot that is HELD.
class Flight {
 public:
  explicit Flight(Vec3 from) : at(from) { seen.robots = 1; }
  const Observation& observe() {
    const Vec3 p = at + position_off + noise(setting.limits.position_error_m);
    const Vec3 w = v + velocity_off + noise(setting.limits.velocity_error_mps);
    seen.now_us = seen.position.stamp_us = seen.velocity.stamp_us = now_us;
    seen.position.value = {p.x, p.y}, seen.height_m = p.z;
    seen.velocity.value = {w.x, w.y}, seen.climb_mps = w.z;
    if (seen.robots > 1) {
      seen.others[1].position.stamp_us = now_us;
      seen.others[1].lease_end_us = now_us + 500'000;
    }
    return seen;
  }
  void hold_other(Vec2 there) {
    seen.robots = 2;
    seen.others[1].position.value = there;
    seen.others[1].height_m = height_m;
  }
  // Until `done`, at most so long. Returns the time it took.
  template <class Done>
  double fly(SafeController<Acceleration>& recovery, Gate gate, double most_s, const Done& done) {
    double s = 0;
    for (; s < most_s && !done(); s += 1e-6 * double(setting.period_us)) {
      move(recovery.command(observe(), gate));
    }
    return s;
  }
  void fly(SafeController<Acceleration>& recovery, Gate gate, double for_s) {
    fly(recovery, gate, for_s, [] { return false; });
  }
  double away_m(Vec2 from) const { return norm(Vec2{at.x, at.y} - from); }

  Setting setting = flyer();
  Vec3 at, v, position_off, velocity_off;
  double noisy = 0;
  TimeUs now_us = 0;
  Observation seen;
  double least_clear_m = 9, most_off_level_m = 0, fastest_mps = 0, nearest_other_m = 9;

 private:
  Vec3 noise(double bound) {
    const Vec2 level = random_.disc(noisy * bound);
    return {level.x, level.y, 0};
  }
  void move(const Acceleration& a) {
    const Vec3 push{a.value_mps2.x, a.value_mps2.y, a.up_mps2};
    for (TimeUs t = 0; t < setting.period_us; t += test::step_us) {
      v = v + (1e-6 * double(test::step_us)) * push;
      at = at + (1e-6 * double(test::step_us)) * v;
    }
    now_us += setting.period_us;
    least_clear_m = std::min(least_clear_m, signed_clearance(hall().view(), {at.x, at.y}));
    most_off_level_m = std::max(most_off_level_m, std::fabs(at.z - height_m));
    fastest_mps = std::max(fastest_mps, norm(v));
    if (seen.robots > 1) {
      nearest_other_m = std::min(nearest_other_m, away_m(seen.others[1].position.value));
    }
  }
  test::Noise random_;
};

class RoutingInSpace : public ::testing::Test {
 protected:
  RoutingInSpace() { route.engage(flight.observe()); }
  void expect_arrival(double most_s) {
    flight.fly(route, Gate::free, most_s, [&] { return route.parked(); });
    EXPECT_TRUE(route.parked());
    EXPECT_TRUE(route.holding());
    EXPECT_TRUE(route.errand());
    EXPECT_LT(flight.away_m(site), 0.1);
    EXPECT_GT(flight.least_clear_m, 0.3 - 0.05);
    EXPECT_LT(flight.most_off_level_m, 0.05);
  }

  Flight flight{{1, 1, height_m}};
  RouteInSpace route{flyer(), site};
};

TEST_F(RoutingInSpace, ReachesItsSiteOnItsLevel) {
  expect_arrival(120);
  EXPECT_LT(flight.fastest_mps, 0.55);
  EXPECT_EQ(route.path(), nullptr);
}

TEST_F(RoutingInSpace, ShowsItsWay) {
  flight.fly(route, Gate::free, 5);
  ASSERT_NE(route.path(), nullptr);
  EXPECT_LT(norm(route.path()->points.back() - site), 1e-9);
  EXPECT_FALSE(route.holding());
}

TEST_F(RoutingInSpace, StopsWhereTheGateClosesAndGoesOn) {
  flight.noisy = 1;
  for (int i = 0; i < 12; ++i) {
    flight.fly(route, Gate::free, 4);
    flight.fly(route, Gate::hold, 5);
    EXPECT_LT(norm(flight.v), 0.06);
    EXPECT_FALSE(route.parked() && flight.away_m(site) > 0.2);
  }
  expect_arrival(120);
}

// Every place that it latches is measured wrong to one side, and the next one right: from the leg
// it does not wander off, stop by stop.
TEST_F(RoutingInSpace, DoesNotWanderOffStopByStop) {
  flight.at = {0.5, 5, height_m};
  RouteInSpace along(flyer(), Vec2{7.5, 5});
  along.engage(flight.observe());
  flight.fly(along, Gate::free, 3);
  const double error_m = flight.setting.limits.position_error_m;
  double aside_m = 0;
  for (int i = 0; i < 60 && flight.at.x < 6; ++i) {
    flight.position_off = {};
    flight.fly(along, Gate::free, 1.2);
    flight.position_off = {0, error_m, 0};
    flight.fly(along, Gate::hold, 3);
    aside_m = std::max(aside_m, std::fabs(flight.at.y - 5));
  }
  EXPECT_GT(flight.at.x, 3);
  EXPECT_LT(aside_m, 2 * error_m + 0.02);
}

// Up and down neither, where every stop leaves it beside its leg by what errors of the velocity do.
TEST_F(RoutingInSpace, KeepsItsHeightStopByStop) {
  Setting setting = flyer();
  setting.limits.velocity_error_mps = 0.05;
  flight.setting = setting;
  flight.at = {0.5, 5, height_m};
  RouteInSpace along(setting, Vec2{7.5, 5});
  flight.velocity_off = {0, 0, 0.05};
  along.engage(flight.observe());
  flight.fly(along, Gate::free, 4);
  int stops = 0;
  for (; stops < 40 && flight.at.x < 7; ++stops) {
    flight.fly(along, Gate::free, 1);
    flight.fly(along, Gate::hold, 4);
  }
  EXPECT_GT(stops, 10);
  EXPECT_LT(flight.most_off_level_m, 0.25);  // what it sways, and one stop leaves
}

TEST_F(RoutingInSpace, ParksWhateverErrorsLast) {
  const double p = flight.setting.limits.position_error_m;
  const double v = flight.setting.limits.velocity_error_mps;
  for (const Vec3 off : {Vec3{p, 0, 0}, Vec3{0, -p, 0}, Vec3{0, 0, p}}) {
    flight.at = {1, 1, height_m}, flight.v = {};
    flight.position_off = off, flight.velocity_off = (v / p) * off;
    route.engage(flight.observe());
    flight.fly(route, Gate::free, 120, [&] { return route.parked(); });
    EXPECT_TRUE(route.parked());
    EXPECT_TRUE(route.holding());
    EXPECT_LT(flight.away_m(site), 0.12);
    flight.fly(route, Gate::free, 10);
    EXPECT_TRUE(route.parked());
  }
}

// The gap beside the wall is as wide as both need.
TEST_F(RoutingInSpace, GoesAroundARobotThatIsHeld) {
  flight.at = {1, 4.6, height_m};
  route.engage(flight.observe());
  flight.hold_other({2.4, 5});
  flight.fly(route, Gate::free, 120, [&] { return route.parked(); });
  EXPECT_TRUE(route.parked());
  EXPECT_GT(flight.nearest_other_m, 0.9 - 0.1);
}

TEST_F(RoutingInSpace, WaitsForARobotThatIsHeldInItsWay) {
  flight.hold_other({4, 5});
  flight.fly(route, Gate::free, 60);
  EXPECT_TRUE(route.blocked());
  EXPECT_TRUE(route.holding());
  ASSERT_NE(route.path(), nullptr);  // the way that it asks for
  EXPECT_GT(flight.nearest_other_m, 0.9 - 0.1);
  flight.seen.robots = 1;
  expect_arrival(120);
}

// A robot that comes to its hold on the way.
TEST_F(RoutingInSpace, BrakesForARobotThatComesToItsHold) {
  flight.fly(route, Gate::free, 60, [&] { return flight.at.y > 2.8; });
  flight.hold_other({4, 5});
  flight.fly(route, Gate::free, 40);
  EXPECT_TRUE(route.blocked());
  EXPECT_LT(norm(flight.v), 0.05);
  EXPECT_GT(flight.nearest_other_m, 0.9 - 0.1);
}

TEST_F(RoutingInSpace, RecedesFromRobotsThatAreHeld) {
  flight.hold_other({1, 0.2});  // behind it
  flight.fly(route, Gate::away_only, 12);
  EXPECT_GT(flight.at.y, 1.5);
}

// Noise has put its hold beside its leg, and the way back to that leads a little towards the other
// robot: who could not take it would stay behind such a gate for ever.
TEST_F(RoutingInSpace, RecedesFromBesideItsLeg) {
  flight.at = {0.5, 5, height_m};
  RouteInSpace along(flyer(), Vec2{7.5, 5});
  along.engage(flight.observe());
  flight.fly(along, Gate::free, 4);
  flight.position_off = {0, flight.setting.limits.position_error_m, 0};
  flight.fly(along, Gate::hold, 4);
  flight.position_off = {};
  const double from_m = flight.at.x;
  flight.hold_other({from_m - 0.9, 4.5});
  flight.fly(along, Gate::away_only, 10);
  EXPECT_GT(flight.at.x, from_m + 1);
}

// Nobody has looked at what lies between its leg and where something else has brought it.
TEST_F(RoutingInSpace, PlansAnewWhereItWasCarriedOff) {
  flight.fly(route, Gate::free, 60, [&] { return flight.at.y > 2.5; });
  flight.fly(route, Gate::hold, 0.1);
  flight.at = {6, 1.5, height_m + 0.6}, flight.v = {};  // beyond the wall
  flight.least_clear_m = 9;
  flight.fly(route, Gate::free, 120, [&] { return route.parked(); });
  EXPECT_TRUE(route.parked());
  EXPECT_LT(flight.away_m(site), 0.1);
  EXPECT_GT(flight.least_clear_m, 0.3 - 0.05);
  EXPECT_NEAR(flight.at.z, height_m + 0.6, 0.05);
}

// Another recovery has driven in between: it comes back to its leg, and looks from there.
TEST_F(RoutingInSpace, ComesBackToItsLegAfterAnotherRecovery) {
  flight.at = {0.5, 5, height_m};
  RouteInSpace along(flyer(), Vec2{7.5, 5});
  along.engage(flight.observe());
  flight.fly(along, Gate::free, 5);
  BrakeAndHold<Acceleration> stop(flyer());
  const std::optional<Halt> driven = along.halt();
  stop.engage(flight.observe());
  stop.go_on(*driven);
  flight.position_off = {0, 0.02, 0};
  flight.fly(stop, Gate::free, 6);
  const std::optional<Halt> held = stop.halt();
  along.engage(flight.observe());
  along.go_on(*held);
  flight.position_off = {};
  flight.fly(along, Gate::free, 60, [&] { return along.parked(); });
  EXPECT_TRUE(along.parked());
  EXPECT_NEAR(flight.at.y, 5, 0.03);
}

TEST_F(RoutingInSpace, BrakesWhereItSeesNothing) {
  flight.fly(route, Gate::free, 6);
  ASSERT_GT(norm(flight.v), 0.4);
  flight.seen.position.stamp_us = flight.seen.velocity.stamp_us = flight.now_us;
  for (int i = 0; i < 60; ++i) {
    flight.seen.now_us += flight.setting.period_us;
    const Acceleration a = route.command(flight.seen, Gate::free);
    const double s = 1e-6 * double(flight.setting.period_us);
    flight.v = flight.v + s * Vec3{a.value_mps2.x, a.value_mps2.y, a.up_mps2};
  }
  EXPECT_LT(norm(flight.v), 0.15);  // what is left after whole periods of the brake
}

// A robot that goes first is HELD, and asks for the way that leads through this one.
TEST(YieldInSpace, MakesRoomOnItsLevel) {
  Flight flight({2, 1, height_m});
  YieldInSpace yield(flyer());
  flight.seen.self = 0;
  flight.hold_other({2, 3});
  yield.engage(flight.observe());
  flight.fly(yield, Gate::free, 6);
  EXPECT_TRUE(yield.holding());
  EXPECT_LT(flight.away_m({2, 1}), 0.05);
  Announcement& asker = flight.seen.others[1];
  asker.blocked = true, asker.claims = asker.errand = true, asker.urgency = 5;
  (void)asker.plan.points.push({2, 0.5});
  flight.fly(yield, Gate::free, 30);
  EXPECT_GT(std::fabs(flight.at.x - 2), 0.8);
  EXPECT_TRUE(yield.holding());
  EXPECT_FALSE(yield.errand());
  EXPECT_LT(flight.most_off_level_m, 0.05);
  EXPECT_GT(flight.least_clear_m, 0.3 - 0.05);
}

// Both in a corner, one over the other: errors that last show the other one on the side of the
// room, which holds on the side of the corner. It leads away from there, gate or not.
TEST(YieldInSpace, LeavesThePlaceThatTheOtherOneHolds) {
  for (const Gate gate : {Gate::free, Gate::away_only}) {
    Flight flight({0.32, 0.32, height_m});
    YieldInSpace yield(flyer());
    flight.hold_other({0.36, 0.36});
    flight.seen.others[1].hold = Vec3{0.3, 0.3, height_m - 0.7};
    yield.engage(flight.observe());
    flight.fly(yield, gate, 12);
    EXPECT_GT(flight.away_m({0.3, 0.3}), 0.9);
    EXPECT_FALSE(yield.blocked());
    EXPECT_GT(flight.least_clear_m, 0.3 - 0.05);
  }
}

// It asks the other one, where that holds on the side of the room.
TEST(YieldInSpace, AsksWhoHoldsInItsWay) {
  Flight flight({0.32, 0.32, height_m});
  YieldInSpace yield(flyer());
  flight.hold_other({0.3, 0.3});
  flight.seen.others[1].hold = Vec3{0.36, 0.36, height_m - 0.7};
  yield.engage(flight.observe());
  flight.fly(yield, Gate::free, 12);
  EXPECT_LT(flight.away_m({0.32, 0.32}), 0.05);
  EXPECT_TRUE(yield.blocked());
}

// Straight over each other in a corner: the middle of their cell is on the side of the corner, and
// no way leads on from there.
TEST(YieldInSpace, LeavesFromStraightOverTheOtherOne) {
  Flight flight({0.36, 0.36, height_m});
  YieldInSpace yield(flyer());
  flight.hold_other({0.36, 0.36});
  yield.engage(flight.observe());
  flight.fly(yield, Gate::free, 1);
  const std::optional<Halt> halt = yield.halt();
  ASSERT_TRUE(halt && halt->latched);
  flight.seen.others[1].hold = Vec3{halt->place.x, halt->place.y, height_m - 0.7};
  flight.fly(yield, Gate::away_only, 12);
  EXPECT_GT(flight.away_m({0.36, 0.36}), 0.9);
  EXPECT_GT(flight.least_clear_m, 0.3 - 0.05);
}

TEST(YieldInSpace, StaysWhereItIsToldTo) {
  Flight flight({2, 1, height_m});
  YieldInSpace yield(flyer());
  flight.hold_other({2, 3});
  yield.engage(flight.observe());
  flight.fly(yield, Gate::hold, 20);
  EXPECT_LT(flight.away_m({2, 1}), 0.05);
}

}  // namespace
}  // namespace rtac::safe
