// The safe-controller templates in a closed loop: where they go, what they keep, when they stay.
#include "rtac/safe/controllers.h"

#include <gtest/gtest.h>

#include "tests/runtime/core/test_plants.h"
#include "tests/runtime/core/test_zone.h"

namespace rtac::safe {
namespace {

using test::Plant;
using test::tick;

const test::TestZone& room() {
  static const test::TestZone zone(test::square_rings(5000));
  return zone;
}
// A corridor of 1 m with a bay of 1 m x 1 m on its north side at x = 4..5.
const test::TestZone& corridor() {
  static const test::TestZone zone({{{0, 0},
                                     {8000, 0},
                                     {8000, 1000},
                                     {5000, 1000},
                                     {5000, 2000},
                                     {4000, 2000},
                                     {4000, 1000},
                                     {0, 1000}}});
  return zone;
}

Setting cart(const ZoneView& zone) {
  Setting s;
  s.limits = test::cart_limits(), s.period_us = 100'000, s.speed_mps = 0.15, s.zone = &zone;
  s.route_clearance_m = 0.2, s.return_clearance_m = 0.45, s.pass_gap_m = 0.7;
  return s;
}
Setting drone(const ZoneView& zone) {
  Setting s;
  s.limits = test::drone_limits(), s.period_us = 50'000, s.speed_mps = 0.3, s.zone = &zone;
  s.route_clearance_m = 0.2, s.return_clearance_m = 0.45, s.pass_gap_m = 0.7;
  return s;
}
void place_other(Observation& seen, int j, Vec2 p, TimeUs lease_end_us, bool claims = true) {
  seen.robots = std::max(seen.robots, j + 1);
  Announcement& other = seen.others[static_cast<std::size_t>(j)];
  other.position = {p, 0}, other.velocity = {{0, 0}, 0};
  other.lease_end_us = lease_end_us, other.claims = claims;
}
constexpr TimeUs always = INT64_MAX / 2;

// Where `hand` recoveries take over from each other every three ticks, in the middle of the room,
// for two minutes: how far it gets. Its velocity is measured too small by the declared error,
// always in the same direction.
double wandered_m(std::vector<SafeController<Acceleration>*> hand) {
  test::Plant<Acceleration> plant(test::drone_limits(), {2.5, 2.5});
  plant.noisy = 0;
  plant.velocity_bias = {-plant.limits.velocity_error_mps, 0};
  SafeController<Acceleration>* driving = nullptr;
  double farthest_m = 0;
  for (std::size_t i = 0; i < 2400; ++i) {
    SafeController<Acceleration>* next = hand[i / 3 % hand.size()];
    if (next != driving) {
      const std::optional<Halt> halt = driving == nullptr ? std::nullopt : driving->halt();
      next->engage(plant.observe());
      if (halt) next->go_on(*halt);
      driving = next;
    }
    tick<Acceleration>(*driving, plant, Gate::hold, 50'000);
    farthest_m = std::max(farthest_m, norm(plant.p - Vec2{2.5, 2.5}));
  }
  return farthest_m;
}

// A place that each of them latched for itself would creep with that error, 2 m in this time.
TEST(HandOver, KeepsThePlace) {
  const Setting setting = drone(room().view());
  BrakeAndHold<Acceleration> one(setting), two(setting);
  Retreat<Acceleration> three(setting);
  Sequence<Acceleration> four(step<BrakeAndHold, Acceleration>(100'000, setting),
                              step<BrakeAndHold, Acceleration>(0, setting));
  const double alone_m = wandered_m({&one});
  EXPECT_LE(wandered_m({&one, &two}), alone_m + 0.01);
  EXPECT_LE(wandered_m({&one, &three, &four}), alone_m + 0.01);
}

// Also between the steps of a sequence.
TEST(HandOver, KeepsThePlaceWithinASequence) {
  const Setting setting = drone(room().view());
  std::vector<Step<Acceleration>> steps;
  for (int i = 0; i < 600; ++i) steps.push_back(step<BrakeAndHold, Acceleration>(150'000, setting));
  Sequence<Acceleration> often(std::move(steps));
  BrakeAndHold<Acceleration> once(setting);
  EXPECT_LE(wandered_m({&often}), wandered_m({&once}) + 0.01);
}

// How near two retreats come to a wall 0.3 m beside them, which leave the robot to each other every
// `ticks` and drive in between, while their gate is open for `open` ticks of ten. Its velocity is
// measured too large away from the wall, its place too near to it while the gate is closed.
double nearest_m(int ticks, int open) {
  Setting setting = drone(room().view());
  setting.return_clearance_m = 0.6;
  setting.limits.velocity_error_mps = 0.05;
  Plant<Acceleration> plant(setting.limits, {0.3, 0.5});
  plant.noisy = 0;
  plant.velocity_bias = {setting.limits.velocity_error_mps, 0};
  Retreat<Acceleration> one(setting), two(setting);
  SafeController<Acceleration>*driving = &one, *other = &two;
  driving->engage(plant.observe());
  double least_m = 1;
  for (int i = 0; i < 4800; ++i) {
    const Gate gate = i % 10 < open ? Gate::free : Gate::hold;
    Observation seen = plant.observe();
    seen.position.value.x += (gate == Gate::free ? 1 : -1) * setting.limits.position_error_m;
    if (i % ticks == ticks - 1) {
      std::swap(driving, other);
      driving->engage(seen);
      if (const std::optional<Halt> halt = other->halt()) driving->go_on(*halt);
    }
    plant.apply(driving->command(seen, gate), setting.period_us);
    least_m = std::min(least_m, signed_clearance(room().view(), plant.p));
  }
  return least_m;
}

// A way that began anew at every stop, where noise has left the robot, carried it out of the zone.
TEST(HandOver, OnTheWayCarriesNothingOff) {
  for (const int ticks : {4, 6, 7, 9, 12, 24, 47, 5000}) {
    for (const int open : {1, 2, 4, 7, 10}) {
      EXPECT_GE(nearest_m(ticks, open), 0.1) << "every " << ticks << " ticks, open " << open;
    }
  }
}

// From close to a wall the drone gets to a clearance at which control returns, never closer to the
// wall than its stop, and then says that it holds.
TEST(Retreat, LeavesTheWall) {
  Plant<Acceleration> plant(test::drone_limits(), {0.6, 2.5});
  plant.v = {-0.6, 0};
  Retreat<Acceleration> retreat(drone(room().view()));
  retreat.engage(plant.observe());
  double least = 1;
  for (int i = 0; i < 300; ++i) {
    tick(retreat, plant, Gate::free, 50'000);
    least = std::min(least, signed_clearance(room().view(), plant.p));
  }
  EXPECT_GT(least, 0.6 - 0.18 - 0.15);
  EXPECT_GE(signed_clearance(room().view(), plant.p), 0.45 - 0.02);
  EXPECT_TRUE(retreat.holding());
}

// A way ends up to 2 cm short of its end, however well the robot knows its place. A retreat that
// stopped short of the clearance that it needs would never hand control back.
TEST(Retreat, GoesAllTheWayWithAPrecisePosition) {
  Setting setting = cart(room().view());
  setting.limits.position_error_m = 0.001;
  Plant<Twist> plant(setting.limits, {0.2, 2.5});
  Retreat<Twist> retreat(setting);
  retreat.engage(plant.observe());
  for (int i = 0; i < 300; ++i) tick(retreat, plant, Gate::free, 100'000);
  EXPECT_GE(signed_clearance(room().view(), plant.p), setting.return_clearance_m);
  EXPECT_TRUE(retreat.holding());
}

// Control is given back on the way, where the clearance is enough: it must not creep up to there.
// It goes on by what it takes to stop, and comes to rest.
TEST(Retreat, PassesThePlaceOfReturnAtFullSpeed) {
  const Setting setting = drone(room().view());
  Plant<Acceleration> plant(test::drone_limits(), {0.25, 2.5});
  Retreat<Acceleration> retreat(setting);
  retreat.engage(plant.observe());
  double passed_mps = 0;
  for (int i = 0; i < 300; ++i) {
    tick(retreat, plant, Gate::free, 50'000);
    if (passed_mps == 0 && plant.p.x >= setting.return_clearance_m) passed_mps = plant.v.x;
  }
  EXPECT_GT(passed_mps, 0.8 * setting.speed_mps);
  EXPECT_TRUE(retreat.holding());
  EXPECT_LT(plant.p.x, setting.return_clearance_m + run_out_m(setting) + 0.1);
}

// In the middle of a corridor of 1 m there is nothing beyond where the clearance would not fall.
TEST(Retreat, RunsOutOnlyWhereTheClearanceDoesNotFall) {
  Plant<Acceleration> plant(test::drone_limits(), {2, 0.25});
  Setting setting = drone(corridor().view());
  setting.return_clearance_m = 0.42;
  ASSERT_GT(run_out_m(setting), 0.1);
  Retreat<Acceleration> retreat(setting);
  retreat.engage(plant.observe());
  double most_m = 0;
  for (int i = 0; i < 300; ++i) {
    tick(retreat, plant, Gate::free, 50'000);
    most_m = std::max(most_m, plant.p.y);
  }
  EXPECT_GE(signed_clearance(corridor().view(), plant.p), setting.return_clearance_m - 0.02);
  EXPECT_LT(most_m, 0.5 + 0.05);
}

// In a corner no straight way from one wall is enough: it goes along the diagonal.
TEST(Retreat, LeavesACorner) {
  Plant<Twist> plant(test::cart_limits(), {0.2, 0.2});
  Retreat<Twist> retreat(cart(room().view()));
  retreat.engage(plant.observe());
  for (int i = 0; i < 300; ++i) tick(retreat, plant, Gate::free, 100'000);
  EXPECT_GE(signed_clearance(room().view(), plant.p), 0.43);
  EXPECT_TRUE(retreat.holding());
}

// Already outside it comes straight back in; the violation does not grow on the way.
TEST(Retreat, ComesBackFromOutside) {
  Plant<Twist> plant(test::cart_limits(), {-0.3, 2.0});
  Retreat<Twist> retreat(cart(room().view()));
  retreat.engage(plant.observe());
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    tick(retreat, plant, Gate::free, 100'000);
    worst = std::min(worst, signed_clearance(room().view(), plant.p));
  }
  EXPECT_GE(worst, -0.3 - 0.04);
  EXPECT_GE(signed_clearance(room().view(), plant.p), 0.43);
}

// A zone that nowhere has the clearance: hold, and do not blame the robots.
TEST(Retreat, HoldsWhereNoPlaceIsGoodEnough) {
  Setting setting = cart(corridor().view());
  setting.return_clearance_m = 0.9;
  Plant<Twist> plant(test::cart_limits(), {1, 0.5});
  Retreat<Twist> retreat(setting);
  retreat.engage(plant.observe());
  for (int i = 0; i < 50; ++i) tick(retreat, plant, Gate::free, 100'000);
  EXPECT_TRUE(retreat.holding());
  EXPECT_FALSE(retreat.blocked());
  EXPECT_LT(norm(plant.p - Vec2{1, 0.5}), 0.01);
}

// A closed gate stops every motion at once, and the wish to move is not a hold.
TEST(Retreat, ObeysTheGate) {
  Plant<Twist> plant(test::cart_limits(), {0.2, 2.5});
  Retreat<Twist> retreat(cart(room().view()));
  retreat.engage(plant.observe());
  for (int i = 0; i < 12; ++i) tick(retreat, plant, Gate::free, 100'000);
  EXPECT_GT(plant.p.x, 0.21);
  const Twist stopped = retreat.command(plant.observe(), Gate::hold);
  EXPECT_EQ(stopped.speed_mps, 0);
  EXPECT_EQ(stopped.turn_radps, 0);
  for (int i = 0; i < 10; ++i) tick(retreat, plant, Gate::hold, 100'000);
  const Vec2 before = plant.p;
  for (int i = 0; i < 50; ++i) tick(retreat, plant, Gate::hold, 100'000);
  EXPECT_LT(norm(plant.p - before), 1e-6);
  EXPECT_FALSE(retreat.holding());
}

// away_only: the way in leads towards a robot that stands there, so the robot stays.
TEST(Retreat, DoesNotApproachAHeldRobot) {
  Plant<Twist> plant(test::cart_limits(), {0.2, 2.5});
  place_other(plant.seen, 1, {1.2, 2.5}, always);
  Retreat<Twist> retreat(cart(room().view()));
  retreat.engage(plant.observe());
  const double before = norm(plant.p - Vec2{1.2, 2.5});
  for (int i = 0; i < 100; ++i) tick(retreat, plant, Gate::away_only, 100'000);
  EXPECT_GE(norm(plant.p - Vec2{1.2, 2.5}), before - 0.01);
}

// Blind, a unicycle commands zero, and control of the hold is not promised.
TEST(Retreat, BrakesWhenBlind) {
  Plant<Twist> plant(test::cart_limits(), {0.2, 2.5});
  Retreat<Twist> retreat(cart(room().view()));
  retreat.engage(plant.observe());
  for (int i = 0; i < 20; ++i) tick(retreat, plant, Gate::free, 100'000);
  Observation blind = plant.observe();
  blind.position.stamp_us = never_us;
  EXPECT_EQ(retreat.command(blind, Gate::free).speed_mps, 0);
  EXPECT_FALSE(retreat.holding());
}

// Wherever the other robots are and however clear the place is, it stays where it has stopped.
TEST(BrakeAndHold, StaysWhereItStops) {
  Plant<Acceleration> plant(test::drone_limits(), {0.6, 2.5});
  plant.v = {-0.6, 0};
  BrakeAndHold<Acceleration> brake(drone(room().view()));
  brake.engage(plant.observe());
  for (int i = 0; i < 60; ++i) tick(brake, plant, Gate::free, 50'000);
  EXPECT_TRUE(brake.holding());
  const Vec2 rest = plant.p;
  place_other(plant.seen, 1, {1.2, 2.5}, always);
  plant.seen.others[1].blocked = true;
  for (int i = 0; i < 600; ++i) tick(brake, plant, Gate::free, 50'000);
  EXPECT_TRUE(brake.holding());
  EXPECT_LT(norm(plant.p - rest), 0.05);
}

// Not in the corner, where only one clearance is needed, but around a place that is clear enough
// for the whole lap; and at rest after each, so that control can be given back.
TEST(Loiter, DrivesLapsWhereControlCanBeGivenBack) {
  const Setting setting = drone(room().view());
  Plant<Acceleration> plant(setting.limits, {0.3, 0.3});
  Loiter<Acceleration> loiter(setting);
  loiter.engage(plant.observe());
  int laps = 0;
  bool drove = false;
  double least_m = 9, driven_m = 0;
  for (int i = 0; i < 6'000; ++i) {
    const Vec2 before = plant.p;
    tick(loiter, plant, Gate::free, 50'000);
    if (i > 600) {
      least_m = std::min(least_m, signed_clearance(room().view(), plant.p));
      driven_m += norm(plant.p - before);
    }
    laps += drove && loiter.holding() ? 1 : 0;
    drove = !loiter.holding();
  }
  EXPECT_GE(laps, 6);
  EXPECT_GE(least_m, setting.return_clearance_m);
  EXPECT_GT(driven_m, 15);
  for (int i = 0; i < 200; ++i) tick(loiter, plant, Gate::hold, 50'000);  // a closed gate stops it
  const Vec2 before = plant.p;
  for (int i = 0; i < 200; ++i) tick(loiter, plant, Gate::hold, 50'000);
  EXPECT_LT(norm(plant.p - before), 0.05);
}

// Too narrow for laps: it holds.
TEST(Loiter, HoldsWhereThereIsNoRoomForALap) {
  Setting setting = cart(corridor().view());
  Plant<Twist> plant(test::cart_limits(), {2, 0.5});
  Loiter<Twist> loiter(setting);
  loiter.engage(plant.observe());
  for (int i = 0; i < 300; ++i) tick(loiter, plant, Gate::free, 100'000);
  EXPECT_TRUE(loiter.holding());
}

// Each step lasts its time, begins with a brake, and the last one goes on.
TEST(Sequence, DoesOneAfterTheOther) {
  Plant<Twist> plant(test::cart_limits(), {0.2, 2.5});
  const Setting setting = cart(room().view());
  Sequence<Twist> sequence(step<BrakeAndHold, Twist>(3'000'000, setting),
                           step<Retreat, Twist>(0, setting));
  for (int again = 0; again < 2; ++again) {
    plant.p = {0.2, 2.5};
    sequence.engage(plant.observe());
    for (int i = 0; i < 30; ++i) {
      tick(sequence, plant, Gate::free, 100'000);
      ASSERT_LT(norm(plant.p - Vec2{0.2, 2.5}), 0.02);
    }
    EXPECT_TRUE(sequence.holding());
    for (int i = 0; i < 200; ++i) tick(sequence, plant, Gate::free, 100'000);
    EXPECT_GE(signed_clearance(room().view(), plant.p), 0.43);
    EXPECT_TRUE(sequence.holding());
  }
}

// One that is outside is led in at once, and one that is in stands first.
TEST(Sequence, DoesNotStandOutside) {
  const Setting setting = cart(room().view());
  const double radius = setting.limits.radius_m;
  for (const double clearance : {-0.3, radius - 0.01, radius + 0.01}) {
    Plant<Twist> plant(test::cart_limits(), {clearance, 2.5});
    Sequence<Twist> sequence(step<BrakeAndHold, Twist>(30'000'000, setting),
                             step<Retreat, Twist>(0, setting));
    sequence.engage(plant.observe());
    for (int i = 0; i < 200; ++i) tick(sequence, plant, Gate::free, 100'000);
    EXPECT_EQ(signed_clearance(room().view(), plant.p) > radius + 0.1, clearance < radius)
        << clearance;
  }
}

// The way to the dock ends parked, and goes on being parked in spite of noise.
TEST(Route, ParksAtTheSite) {
  Plant<Twist> plant(test::cart_limits(), {3, 3});
  Route<Twist> route(cart(room().view()), {1, 1});
  route.engage(plant.observe());
  for (int i = 0; i < 400; ++i) tick(route, plant, Gate::free, 100'000);
  EXPECT_TRUE(route.parked());
  EXPECT_TRUE(route.holding());
  EXPECT_LT(norm(plant.p - Vec2{1, 1}), 0.07);
  for (int i = 0; i < 300; ++i) {
    tick(route, plant, Gate::free, 100'000);
    ASSERT_TRUE(route.parked());
  }
}

// A way of more points than a path holds is driven to its end, piece by piece.
TEST(Route, DrivesAWayOfManyPoints) {
  const test::Serpentine zone(60);
  Plant<Acceleration> plant(test::drone_limits(), zone.first());
  Route<Acceleration> route(drone(zone.view()), zone.last());
  route.engage(plant.observe());
  for (int i = 0; i < 12'000 && !route.parked(); ++i) tick(route, plant, Gate::free, 50'000);
  EXPECT_TRUE(route.parked());
  EXPECT_LT(norm(plant.p - zone.last()), 0.1);
}

// The pieces of such a way add nothing to its length, wherever beside their ends the robot rests.
TEST(Route, PiecesOfAWayAddUpToIt) {
  const test::Serpentine zone(60);
  Path whole;
  GridRoute search(zone.view());
  ASSERT_TRUE(search.to_point({0.2, zone.first(), {}, {}}, zone.last(), whole));
  RouteManoeuvre route(drone(zone.view()), zone.last());
  Observation seen;
  seen.robots = 1;
  seen.position = {zone.first(), 0};
  route.engage(seen);
  double driven_m = 0;
  for (int piece = 0; piece < 5 && !route.parked(); ++piece) {
    seen.now_us += 10'000'000;
    route.update(seen, seen.position.value, Gate::free, true);
    if (!route.wants_motion()) continue;
    const Vec2 end = route.way().points.back();
    const bool on = driven_m > 0;  // what lies between the rest and the cut is no part of the way
    driven_m += length_m(on ? route.way().points[0] : seen.position.value, route.way());
    route.way().index = route.way().points.size();
    seen.position.value = norm(end - zone.last()) > 0 ? end + Vec2{0.06, 0} : end;
  }
  EXPECT_TRUE(route.parked());
  EXPECT_LE(driven_m, search.length_m() + 1e-4);
}

// A held robot on the straight way is passed at the pass gap.
TEST(Route, GoesAroundAHeldRobot) {
  Plant<Acceleration> plant(test::drone_limits(), {1, 2.5});
  place_other(plant.seen, 1, {2.5, 2.5}, always);
  Route<Acceleration> route(drone(room().view()), {4, 2.5});
  route.engage(plant.observe());
  double least = 9;
  for (int i = 0; i < 600; ++i) {
    tick(route, plant, Gate::free, 50'000);
    least = std::min(least, norm(plant.p - Vec2{2.5, 2.5}));
  }
  EXPECT_TRUE(route.parked());
  EXPECT_GT(least, 0.7 - 0.05);
}

// The reserve covers `detour` once: what was driven since the recovery set out is taken off,
// however slowly it was driven. Here the speed is within three errors of the velocity.
TEST(Route, DoesNotGoAroundWhenTheDetourIsUsedUp) {
  for (const bool drives : {false, true}) {
    Setting setting = cart(room().view());
    setting.detour_m = 1;
    setting.limits.velocity_error_mps = 0.05;
    RouteManoeuvre route(setting, {4, 2.5});
    Observation seen;
    seen.position.value = {1, 2.5};
    route.engage(seen);
    route.update(seen, seen.position.value, Gate::free, true);  // three metres are left
    for (int i = 1; i <= 600; ++i) {
      seen.now_us = i * 100'000;
      seen.velocity.value = {drives ? 0.1 : 0, 0};
      route.update(seen, seen.position.value, Gate::free, !drives);
    }
    seen.now_us += 1'000'000;
    seen.velocity.value = {0, 0};
    place_other(seen, 1, {2, 2.5}, always);
    route.update(seen, seen.position.value, Gate::free, true);
    EXPECT_EQ(route.blocked(), drives);
  }
}

// A held robot that fills the corridor blocks the way: hold, ask, and go on once it has left.
TEST(Route, AsksForPassage) {
  Plant<Twist> plant(test::cart_limits(), {1, 0.5});
  place_other(plant.seen, 1, {2.5, 0.5}, always);
  Route<Twist> route(cart(corridor().view()), {7, 0.5});
  route.engage(plant.observe());
  for (int i = 0; i < 50; ++i) tick(route, plant, Gate::free, 100'000);
  EXPECT_TRUE(route.blocked());
  EXPECT_TRUE(route.holding());
  ASSERT_NE(route.path(), nullptr);
  EXPECT_LT(norm(route.path()->points.back() - Vec2{7, 0.5}), 1e-9);
  place_other(plant.seen, 1, {4.5, 1.7}, always);
  for (int i = 0; i < 50; ++i) tick(route, plant, Gate::free, 100'000);
  EXPECT_FALSE(route.blocked());
  EXPECT_GT(plant.p.x, 1.1);
}

// The lower-ranked robot in a corridor goes to the bay when the other asks for passage: off the
// whole announced way, and never closer to the one who waits.
TEST(Yield, GoesToThePassingPlace) {
  Plant<Twist> plant(test::cart_limits(), {3.0, 0.5});
  plant.seen.self = 1;
  place_other(plant.seen, 0, {1.8, 0.5}, always);
  plant.seen.robots = 2;
  Announcement& asker = plant.seen.others[0];
  asker.blocked = true;
  ASSERT_TRUE(asker.plan.points.push({7, 0.3}));
  Yield<Twist> yield(cart(corridor().view()));
  yield.engage(plant.observe());
  double least = 9;
  for (int i = 0; i < 400; ++i) {
    tick(yield, plant, Gate::away_only, 100'000);
    least = std::min(least, norm(plant.p - Vec2{1.8, 0.5}));
  }
  EXPECT_GE(least, 1.2 - 0.02);
  EXPECT_GE(distance_to_segment(plant.p, {1.8, 0.5}, {7, 0.3}), 0.7 - 0.05);
  EXPECT_TRUE(yield.holding());
}

// Of two that are asked the first in the order makes room first: at the same time each would keep
// the other one from moving.
TEST(Yield, WaitsForWhoMakesRoomFirst) {
  Plant<Twist> plant(test::cart_limits(), {3.0, 0.5});
  plant.seen.self = 2;
  place_other(plant.seen, 0, {1.8, 0.5}, always);
  place_other(plant.seen, 1, {2.4, 0.5}, never_us);
  plant.seen.robots = 3;
  plant.seen.others[0].blocked = true;
  ASSERT_TRUE(plant.seen.others[0].plan.points.push({7, 0.3}));
  Yield<Twist> yield(cart(corridor().view()));
  yield.engage(plant.observe());
  for (int i = 0; i < 100; ++i) tick(yield, plant, Gate::away_only, 100'000);
  EXPECT_TRUE(yield.holding());
  EXPECT_LT(norm(plant.p - Vec2{3.0, 0.5}), 0.01);
  plant.seen.others[1].lease_end_us = always;
  for (int i = 0; i < 400; ++i) tick(yield, plant, Gate::away_only, 100'000);
  EXPECT_GE(distance_to_segment(plant.p, {1.8, 0.5}, {7, 0.3}), 0.65);
}

// A robot with the stronger claim does not leave its place for one that asks.
TEST(Yield, StaysWhenItOutranks) {
  Plant<Twist> plant(test::cart_limits(), {3.0, 0.5});
  place_other(plant.seen, 1, {1.0, 0.5}, always);
  plant.seen.others[1].blocked = true;
  ASSERT_TRUE(plant.seen.others[1].plan.points.push({7, 0.5}));
  Yield<Twist> yield(cart(corridor().view()));
  yield.engage(plant.observe());
  for (int i = 0; i < 100; ++i) tick(yield, plant, Gate::free, 100'000);
  EXPECT_LT(norm(plant.p - Vec2{3.0, 0.5}), 0.01);
  EXPECT_TRUE(yield.holding());
}

// A parked robot makes no claim: it makes room even for one with a higher index.
TEST(Yield, ParkedRobotsMakeRoom) {
  Plant<Twist> plant(test::cart_limits(), {3.0, 0.5});
  plant.seen.claims = false;
  place_other(plant.seen, 1, {1.8, 0.5}, always);
  plant.seen.others[1].blocked = true;
  ASSERT_TRUE(plant.seen.others[1].plan.points.push({7, 0.3}));
  Yield<Twist> yield(cart(corridor().view()));
  yield.engage(plant.observe());
  for (int i = 0; i < 400; ++i) tick(yield, plant, Gate::away_only, 100'000);
  EXPECT_GE(distance_to_segment(plant.p, {1.8, 0.5}, {7, 0.3}), 0.65);
}

// Two held robots too close: after 2 s the first of the order wants to move, lets its lease lapse,
// and backs off once the gate opens; the second keeps holding.
TEST(Yield, FirstInOrderBacksOff) {
  Plant<Twist> first(test::cart_limits(), {2.5, 2.5}), second(test::cart_limits(), {2.9, 2.5});
  second.seen.self = 1;
  place_other(first.seen, 1, {2.9, 2.5}, always);
  place_other(second.seen, 0, {2.5, 2.5}, always);
  second.seen.robots = 2;
  Yield<Twist> a(cart(room().view())), b(cart(room().view()));
  a.engage(first.observe());
  b.engage(second.observe());
  for (int i = 0; i < 10; ++i) {
    tick(a, first, Gate::hold, 100'000);
    tick(b, second, Gate::hold, 100'000);
  }
  EXPECT_TRUE(a.holding());
  EXPECT_TRUE(b.holding());
  for (int i = 0; i < 30; ++i) {
    tick(a, first, Gate::hold, 100'000);
    tick(b, second, Gate::hold, 100'000);
  }
  EXPECT_FALSE(a.holding());
  EXPECT_TRUE(b.holding());
  EXPECT_LT(norm(first.p - Vec2{2.5, 2.5}), 1e-6);  // the gate was closed
  for (int i = 0; i < 200; ++i) tick(a, first, Gate::away_only, 100'000);
  EXPECT_GE(norm(first.p - Vec2{2.9, 2.5}), 0.65);
  EXPECT_TRUE(a.holding());
}

// A lease that has run out promises nothing any more.
TEST(Yield, KeepsHoldingWhenTheLeaseRanOut) {
  Plant<Twist> plant(test::cart_limits(), {2.5, 2.5});
  place_other(plant.seen, 1, {2.9, 2.5}, 1'000'000);
  Yield<Twist> yield(cart(room().view()));
  yield.engage(plant.observe());
  for (int i = 0; i < 100; ++i) tick(yield, plant, Gate::free, 100'000);
  EXPECT_TRUE(yield.holding());
  EXPECT_LT(norm(plant.p - Vec2{2.5, 2.5}), 0.01);
}

// A robot nearby that is not held may move any time: nothing but holding is safe to assume.
TEST(Yield, KeepsHoldingBesideAMovingRobot) {
  Plant<Twist> plant(test::cart_limits(), {2.5, 2.5});
  place_other(plant.seen, 1, {2.9, 2.5}, never_us);
  Yield<Twist> yield(cart(room().view()));
  yield.engage(plant.observe());
  for (int i = 0; i < 100; ++i) tick(yield, plant, Gate::free, 100'000);
  EXPECT_TRUE(yield.holding());
  EXPECT_LT(norm(plant.p - Vec2{2.5, 2.5}), 0.01);
}

}  // namespace
}  // namespace rtac::safe
