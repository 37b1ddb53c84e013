// Two robots in a corridor that is too narrow for both, with leases and gates as a decision module
// grants them: the passage protocol as a whole must end, and nobody may be touched.
#include <gtest/gtest.h>

#include "rtac/safe/controllers.h"
#include "tests/runtime/core/test_plants.h"
#include "tests/runtime/core/test_zone.h"

namespace rtac::safe {
namespace {

using test::Plant;

// 8 m x 1 m, a bay of 1 m x 1 m on the north side at x = 4..5.
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
// 8 m x 2.5 m
const test::TestZone& aisle() {
  static const test::TestZone zone({{{0, 0}, {8000, 0}, {8000, 2500}, {0, 2500}}});
  return zone;
}
Setting cart(const test::TestZone& zone = corridor()) {
  Setting s;
  s.limits = test::cart_limits(), s.period_us = 100'000, s.speed_mps = 0.15;
  s.zone = &zone.view();
  s.route_clearance_m = 0.2, s.return_clearance_m = 0.45, s.pass_gap_m = 0.7;
  return s;
}

// A stand-in for the decision module: a lease of 500 ms while the robot holds, and a gate that is
// closed while the own lease runs or while a robot that is not held is near.
struct Member {
  Plant<Twist> plant;
  SafeController<Twist>* controller;
  TimeUs lease_end_us = never_us;

  Gate gate(const Member& other) const {
    if (lease_end_us != never_us && lease_end_us >= plant.now_us) return Gate::hold;
    const double distance_m = norm(plant.p - other.plant.p);
    const bool held =
        other.lease_end_us != never_us && other.lease_end_us >= plant.now_us + 240'000;
    if (distance_m > (held ? 0.6 : 1.2)) return Gate::free;
    return held ? Gate::away_only : Gate::hold;
  }
  void tick(Member& other, std::size_t other_index) {
    Observation seen = plant.observe();
    seen.self = 1 - static_cast<int>(other_index), seen.robots = 2;
    Announcement& heard = seen.others[other_index];
    heard.position = {other.plant.p + plant.noise.disc(0.02), seen.now_us};
    heard.lease_end_us = other.lease_end_us;
    heard.claims = true;
    const std::optional<Halt> halt = other.controller->halt();
    heard.hold = halt && halt->latched ? std::optional(halt->place) : std::nullopt;
    heard.blocked = other.controller->blocked();
    if (other.controller->path() != nullptr) heard.plan = *other.controller->path();
    const Gate now = gate(other);
    if (controller->holding()) lease_end_us = seen.now_us + 500'000;
    plant.apply(controller->command(seen, now), 100'000);
  }
};

// The first robot is on the way to its dock at the far end; the second holds in its way, gives
// passage in the bay, and the first gets through.
class Passing : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Seeds, Passing, testing::Range(1u, 11u));

TEST_P(Passing, TheBayLetsTheFirstRobotThrough) {
  Route<Twist> route(cart(), {7.3, 0.5});
  Yield<Twist> yield(cart());
  Member first{{test::cart_limits(), {0.6, 0.5}}, &route};
  Member second{{test::cart_limits(), {2.6, 0.5}}, &yield};
  route.engage(first.plant.observe());
  yield.engage(second.plant.observe());
  first.plant.noise.seed(GetParam());
  second.plant.noise.seed(100 + GetParam());
  double least = 9, clearance = 9;
  for (int i = 0; i < 2400 && !route.parked(); ++i) {
    first.tick(second, 1);
    second.tick(first, 0);
    least = std::min(least, norm(first.plant.p - second.plant.p));
    clearance = std::min({clearance, signed_clearance(corridor().view(), first.plant.p),
                          signed_clearance(corridor().view(), second.plant.p)});
  }
  EXPECT_TRUE(route.parked()) << "first at " << first.plant.p.x << ", " << first.plant.p.y
                              << ", second at " << second.plant.p.x << ", " << second.plant.p.y;
  EXPECT_GT(least, 0.6);
  EXPECT_GT(clearance, 0.2 - 0.07);
}

// The first of the order stands at the dead end of the corridor and cannot back off: it asks, and
// the second one makes room.
TEST_P(Passing, ACorneredRobotAsksTheOther) {
  Yield<Twist> a(cart()), b(cart());
  Member first{{test::cart_limits(), {0.3, 0.5}}, &a},
      second{{test::cart_limits(), {0.75, 0.5}}, &b};
  a.engage(first.plant.observe());
  b.engage(second.plant.observe());
  first.plant.noise.seed(GetParam());
  second.plant.noise.seed(100 + GetParam());
  double least = 9;
  for (int i = 0; i < 300; ++i) {
    first.tick(second, 1);
    second.tick(first, 0);
    least = std::min(least, norm(first.plant.p - second.plant.p));
  }
  EXPECT_GT(norm(first.plant.p - second.plant.p), 0.7);
  EXPECT_GT(least, 0.45 - 0.02);
}

// Before both walls of an aisle, nearer to them than ways over cells lead: each of them comes
// nearer to the other one as it makes for a cell. One goes along its wall.
TEST_P(Passing, TwoAcrossAnAisleGetApart) {
  Setting wide = cart(aisle());
  wide.route_clearance_m = 0.7, wide.pass_gap_m = 1.6;
  Yield<Twist> a(wide), b(wide);
  Member first{{test::cart_limits(), {0.8, 0.6}}, &a},
      second{{test::cart_limits(), {0.8, 1.9}}, &b};
  a.engage(first.plant.observe());
  b.engage(second.plant.observe());
  first.plant.noise.seed(GetParam());
  second.plant.noise.seed(100 + GetParam());
  double least = 9, clearance = 9;
  for (int i = 0; i < 600; ++i) {
    first.tick(second, 1);
    second.tick(first, 0);
    least = std::min(least, norm(first.plant.p - second.plant.p));
    clearance = std::min({clearance, signed_clearance(aisle().view(), first.plant.p),
                          signed_clearance(aisle().view(), second.plant.p)});
  }
  EXPECT_GT(norm(first.plant.p - second.plant.p), 1.6);
  EXPECT_GT(least, 1.3 - 0.05);
  EXPECT_GT(clearance, 0.6 - 0.05);
}

// Two robots that hold too close to each other get apart: only the first of the order moves.
TEST_P(Passing, TwoHeldRobotsGetApart) {
  Yield<Twist> a(cart()), b(cart());
  Member first{{test::cart_limits(), {2.3, 0.5}}, &a},
      second{{test::cart_limits(), {2.7, 0.5}}, &b};
  a.engage(first.plant.observe());
  b.engage(second.plant.observe());
  first.plant.noise.seed(GetParam());
  second.plant.noise.seed(100 + GetParam());
  double least = 9;
  for (int i = 0; i < 300; ++i) {
    first.tick(second, 1);
    second.tick(first, 0);
    least = std::min(least, norm(first.plant.p - second.plant.p));
  }
  EXPECT_GT(norm(first.plant.p - second.plant.p), 0.7);
  EXPECT_GT(least, 0.4 - 0.02);
  EXPECT_LT(norm(second.plant.p - Vec2{2.7, 0.5}), 0.01);
  EXPECT_TRUE(a.holding());
  EXPECT_TRUE(b.holding());
}

}  // namespace
}  // namespace rtac::safe
