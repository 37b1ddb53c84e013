// Pilots against plants with noise and latency at the declared bounds.
#include "rtac/safe/pilot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rtac/safe/grid_route.h"
#include "tests/runtime/core/test_plants.h"

namespace rtac::safe {
namespace {

using test::Plant;

Setting drone() {
  Setting s;
  s.limits = test::drone_limits(), s.period_us = 50'000, s.speed_mps = 0.3;
  return s;
}
Setting cart() {
  Setting s;
  s.limits = test::cart_limits(), s.period_us = 100'000, s.speed_mps = 0.15;
  return s;
}
Path square() {
  Path way;
  for (const Vec2 p : {Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}, Vec2{0, 0}}) (void)way.points.push(p);
  return way;
}

// Drives the square; returns the largest distance of the true position from the leg it is on.
template <class Output>
double worst_deviation(const Setting& setting, TimeUs limit_us) {
  Plant<Output> plant(setting.limits, {0, 0});
  Pilot<Output> pilot(setting);
  pilot.engage(plant.observe());
  Path way = square();
  double worst = 0;
  while (!way.finished() && plant.now_us < limit_us) {
    plant.apply(driven(pilot, plant, way), setting.period_us);
    double nearest = 1e9;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2 a = square().points[i], b = square().points[(i + 1) % 4];
      nearest = std::min(nearest, distance_to_segment(plant.p, a, b));
    }
    worst = std::max(worst, nearest);
  }
  EXPECT_TRUE(way.finished()) << "still driving after " << plant.now_us / 1000 << " ms";
  return worst;
}

// A unicycle keeps within 5 cm of the legs, corners included.
TEST(UnicyclePilot, TracksASquare) {
  EXPECT_LT(worst_deviation<Twist>(cart(), 90'000'000), 0.05);
}

// So does a point mass, and both get round in reasonable time.
TEST(PointPilot, TracksASquare) {
  EXPECT_LT(worst_deviation<Acceleration>(drone(), 40'000'000), 0.05);
}

// The brake of a unicycle is speed 0 and turn 0 at once, never a ramp.
TEST(UnicyclePilot, BrakesAtOnce) {
  Plant<Twist> plant(test::cart_limits(), {0, 0});
  plant.v = {0.22, 0}, plant.speed = 0.22, plant.turn = 2;
  Pilot<Twist> pilot(cart());
  pilot.engage(plant.observe());
  const Twist out = pilot.halt(plant.observe());
  EXPECT_EQ(out.speed_mps, 0);
  EXPECT_EQ(out.turn_radps, 0);
  EXPECT_FALSE(pilot.latched());
  for (int i = 0; i < 20; ++i) plant.apply(pilot.halt(plant.observe()), 100'000);
  EXPECT_TRUE(pilot.latched());
}

// The sampled brake ends in a position hold: with noise and latency it does not creep for 60 s,
// and it stops no further than the theory's stop set (theory: the brake).
TEST(PointPilot, BrakeDoesNotCreep) {
  Plant<Acceleration> plant(test::drone_limits(), {0, 0});
  plant.v = {0.8, 0.6};
  plant.noisy = 0.5, plant.velocity_bias = {0.01, 0};
  Pilot<Acceleration> pilot(drone());
  pilot.engage(plant.observe());
  const double eta = 0.02 + 0.07;  // eps_v + b (h + l)
  const double hold = 0.06;
  const double overshoot = eta * 1.0 + eta * eta + hold + 0.07;  // and the latency's way
  Vec2 rest{};
  double from_rest = 0, furthest = 0;
  while (plant.now_us < 62'000'000) {
    plant.apply(pilot.halt(plant.observe()), 50'000);
    if (plant.now_us == 3'000'000) rest = plant.p;
    if (plant.now_us > 3'000'000) from_rest = std::max(from_rest, norm(plant.p - rest));
    furthest = std::max(furthest, norm(plant.p));
  }
  EXPECT_TRUE(pilot.latched());
  EXPECT_LT(from_rest, 0.03);
  EXPECT_LT(furthest, 0.5 + overshoot);
  EXPECT_LT(norm(plant.v), 0.05);
}

// A velocity that errs to the side by just so much that what is left of the brake along the way is
// what pushes, now to the left, now to the right: the brake ends all the same, since it gives way
// to the hold above the speed at which that could go on (docs: lemmas, sampled_brake). A boat,
// adrift.
TEST(PointPilot, BrakeEndsWhateverTurnsItAside) {
  RobotLimits boat = test::drone_limits();
  boat.accel_mps2 = boat.brake_mps2 = 0.3, boat.disturbance_mps2 = 0.15;
  boat.velocity_error_mps = 0.1;
  boat.position_age_us = boat.velocity_age_us = boat.latency_us = 10'000;
  Setting setting;
  setting.limits = boat, setting.period_us = 10'000, setting.speed_mps = 0.3;
  Plant<Acceleration> plant(boat, {0, 0});
  plant.v = {0.3, 0};
  plant.noisy = 0;
  Pilot<Acceleration> pilot(setting);
  const double eta = 0.1 + 0.45 * 0.03;  // eps_v + (b + d) (h + l + age)
  bool begun = false;
  while (plant.now_us < 60'000'000) {
    const double speed = norm(plant.v), heading = std::atan2(plant.v.y, plant.v.x);
    plant.velocity_bias = {};
    if (speed > 0.01) {  // as slow as it may be shown without a hold, on the side of the heading
      const double shown = std::max(1.0001 * eta, std::sqrt(std::max(0.0, speed * speed - 0.01)));
      const double cosine = (speed * speed + shown * shown - 0.00999) / (2 * speed * shown);
      const double aside = std::acos(std::clamp(cosine, -1.0, 1.0)) * (heading > 0 ? 1 : -1);
      const Vec2 seen{shown * std::cos(heading + aside), shown * std::sin(heading + aside)};
      if (norm(seen - plant.v) <= 0.1) plant.velocity_bias = seen - plant.v;
    }
    const Observation& seen = plant.observe();
    if (!begun) pilot.engage(seen);
    begun = true;
    const Acceleration out = pilot.halt(seen);
    for (int i = 0; i < 10; ++i) {
      const double now = norm(plant.v);
      if (now > 0) plant.v = plant.v + (1e-3 * boat.disturbance_mps2 / now) * plant.v;
      plant.apply(out, 1'000);
    }
  }
  EXPECT_TRUE(pilot.latched());
  EXPECT_LT(norm(plant.p), 2.4);  // what the decision reckons with, computed by hand
}

// Without a position the point mass brakes along its last known motion, then commands nothing.
TEST(PointPilot, BrakesBlind) {
  Plant<Acceleration> plant(test::drone_limits(), {0, 0});
  plant.v = {0.5, 0};
  Pilot<Acceleration> pilot(drone());
  Observation blind = plant.observe();
  pilot.engage(blind);
  (void)pilot.halt(blind);
  blind.now_us += 100'000;
  EXPECT_FALSE(pilot.can_steer(blind));
  EXPECT_NEAR(pilot.brake_blind(blind).value_mps2.x, -1.0, 0.01);
  blind.now_us += 500'000;
  EXPECT_EQ(pilot.brake_blind(blind).value_mps2.x, 0.0);
  EXPECT_FALSE(pilot.latched());
}

// Without a position alone it brakes by its velocity, whatever it did before it went out of sight.
TEST(PointPilot, BrakesByItsVelocityAlone) {
  Plant<Acceleration> plant(test::drone_limits(), {0, 0});
  plant.v = {0.5, 0};
  Pilot<Acceleration> pilot(drone());
  pilot.engage(plant.observe());
  plant.v = {-0.3, 0.6};
  for (int i = 0; i < 60; ++i) {
    Observation seen = plant.observe();
    seen.position.value = {std::nan(""), 0};
    ASSERT_FALSE(pilot.can_steer(seen));
    plant.apply(pilot.brake_blind(seen), 50'000);
  }
  EXPECT_LT(norm(plant.v), 0.05);
  EXPECT_FALSE(pilot.latched());
}

// The hand-over shows the last velocity that was a number; the commands after it see none.
TEST(PointPilot, BrakesBlindFromTheHandOver) {
  Plant<Acceleration> plant(test::drone_limits(), {0, 0});
  plant.v = {0.5, 0};
  Pilot<Acceleration> pilot(drone());
  Observation seen = plant.observe();
  ASSERT_TRUE(pilot.can_steer(seen));
  pilot.engage(seen);
  seen.velocity.value = {std::nan(""), 0};
  EXPECT_FALSE(pilot.can_steer(seen));
  EXPECT_NEAR(pilot.brake_blind(seen).value_mps2.x, -1.0, 0.01);
}

// What a recovery hands on that holds `place` and was stopped on the leg from the origin to x = 4
// m.
Halt stopped_on_leg(Vec3 place) {
  Halt halt;
  halt.latched = true;
  halt.place = place;
  halt.leg = Leg{{0, 0}, {4, 0}};
  halt.leg_mps = drone().speed_mps;
  return halt;
}

// A drone that stands at `place` with `halt` and wants to go to `target`.
struct Standing {
  Standing(const Halt& halt, Vec2 place, Vec2 target)
      : plant(test::drone_limits(), place), pilot(drone()) {
    plant.noisy = 0;
    (void)way.points.push(target);
    pilot.engage(plant.observe());
    pilot.go_on(halt);
  }
  Plant<Acceleration> plant;
  Pilot<Acceleration> pilot;
  Path way;
};

// How near to that leg it gets on its way to a target that is as far beside it as `place`.
double nearest_to_leg_m(const Halt& halt, Vec2 place) {
  Standing drone_at(halt, place, {place.x + 2, place.y});
  Plant<Acceleration>& plant = drone_at.plant;
  double nearest_m = 1e9;
  while (!drone_at.way.finished() && plant.now_us < 60'000'000) {
    plant.apply(driven(drone_at.pilot, plant, drone_at.way), 50'000);
    nearest_m = std::min(nearest_m, distance_to_segment(plant.p, {0, 0}, {4, 0}));
  }
  EXPECT_TRUE(drone_at.way.finished());
  return nearest_m;
}

// From as near as its stop explains it sets out from its leg; from further off, where something
// else has brought it, nobody knows what lies between, and it sets out from where it stands. The
// bound of this drone, computed by hand: 6 cm beside the leg, 1.6 cm aside while it stops, a bend
// of 6.4 cm, a sway of 7.7 cm; past the end, 4.5 cm more.
TEST(PointPilot, GoesBackToItsLegOnlyFromNearIt) {
  EXPECT_LT(nearest_to_leg_m(stopped_on_leg({1, 0.21, 0}), {1, 0.21}), 0.08);
  EXPECT_GT(nearest_to_leg_m(stopped_on_leg({1, 0.225, 0}), {1, 0.225}), 0.21);
  EXPECT_GT(nearest_to_leg_m(stopped_on_leg({1, -1.5, 0}), {1, -1.5}), 1.45);
  const auto keeps_leg = [](Vec3 place) {
    Pilot<Acceleration> pilot(drone());
    pilot.go_on(stopped_on_leg(place));
    return pilot.halting()->leg.has_value();
  };
  EXPECT_TRUE(keeps_leg({4.25, 0, 0}));
  EXPECT_FALSE(keeps_leg({4.27, 0, 0}));
  EXPECT_FALSE(keeps_leg({-0.23, 0, 0}));
  EXPECT_FALSE(keeps_leg({std::nan(""), 0, 0}));
}

// As near as the stop of who drove on the leg explains it, not of who takes over: where that one is
// slower, it would begin anew at every hand-over. Who tells no speed has not driven far beside it.
TEST(PointPilot, GoesBackToTheLegOfAnotherAsThatOneWould) {
  Setting slow = drone();
  slow.speed_mps = 0.05;
  const auto keeps_leg = [&](double leg_mps, double y) {
    Pilot<Acceleration> pilot(slow);
    Halt halt = stopped_on_leg({1, y, 0});
    halt.leg_mps = leg_mps;
    pilot.go_on(halt);
    return pilot.halting()->leg.has_value();
  };
  EXPECT_TRUE(keeps_leg(0.3, 0.21));
  EXPECT_FALSE(keeps_leg(0.3, 0.225));
  EXPECT_FALSE(keeps_leg(0, 0.21));
  EXPECT_FALSE(keeps_leg(std::nan(""), 0.01));
  EXPECT_FALSE(keeps_leg(100, 0.4));  // no robot of this kind is so fast
}

// Carried off beside a wall while it was blind on its way: the place where it comes to rest is the
// one that it holds, and the next leg begins there.
TEST(PointPilot, IsNotDrawnThroughWhatLiesBesideItsOldLeg) {
  Standing drone_at({}, {0, 0}, {4, 0});
  Plant<Acceleration>& plant = drone_at.plant;
  Pilot<Acceleration>& pilot = drone_at.pilot;
  drone_at.way.points.clear();
  (void)drone_at.way.points.push({4, 0});
  pilot.engage(plant.observe());
  for (int i = 0; i < 60; ++i) plant.apply(driven(pilot, plant, drone_at.way), 50'000);
  ASSERT_GT(plant.p.x, 0.5);
  for (int i = 0; i < 60; ++i) {  // three seconds
    Observation blind = plant.observe();
    blind.position.stamp_us = blind.velocity.stamp_us = never_us;
    ASSERT_FALSE(pilot.can_steer(blind));
    plant.apply(pilot.brake_blind(blind), 50'000);
    plant.p.y += 0.03;
  }
  ASSERT_GT(plant.p.y, 1.7);
  double least_m = plant.p.y;
  drone_at.way.points.clear();
  drone_at.way.index = 0;
  (void)drone_at.way.points.push({3, plant.p.y});
  while (!drone_at.way.finished() && plant.now_us < 60'000'000) {
    plant.apply(driven(pilot, plant, drone_at.way), 50'000);
    least_m = std::min(least_m, plant.p.y);
  }
  EXPECT_TRUE(drone_at.way.finished());
  EXPECT_GT(least_m, 1.7);
}

// The move back to the leg is one that the gate is asked about, beside the way on from there.
TEST(PointPilot, GoesBackToItsLegOnlyAwayFromRobotsThatAreHeld) {
  const auto recedes = [](Vec2 place, double target_y, double held_y) {
    const Standing drone_at(stopped_on_leg({place.x, place.y, 0}), place, {});
    Observation seen;
    seen.position.value = place;
    return drone_at.pilot.recedes(seen, drone_at.pilot.on_way(seen), {2, target_y},
                                  {place.x, held_y});
  };
  EXPECT_FALSE(recedes({1, 0.15}, 3, -1));  // the leg lies between them
  EXPECT_TRUE(recedes({1, 0.15}, -3, 1));
  EXPECT_FALSE(recedes({1, -0.15}, -3, 1));
  EXPECT_TRUE(recedes({1, 0.05}, 3, -1));  // no more than a hold sways
  EXPECT_TRUE(recedes({1, 0.5}, 3, -1));   // too far off to go back
}

// Who tells no more than that it holds a place is taken over from at that place.
TEST(PointPilot, TakesOverAtThePlaceThatIsHeld) {
  Halt halt;
  halt.latched = true;
  halt.place = {3, 2, 0};
  Standing drone_at(halt, {3, 2}, {4, 2});
  Plant<Acceleration>& plant = drone_at.plant;
  double least_m = plant.p.x;
  while (!drone_at.way.finished() && plant.now_us < 60'000'000) {
    plant.apply(driven(drone_at.pilot, plant, drone_at.way), 50'000);
    least_m = std::min(least_m, plant.p.x);
  }
  EXPECT_TRUE(drone_at.way.finished());
  EXPECT_GT(least_m, 2.99);
}

// Not a number, a stamp from the future and a stamp that is too old all mean: cannot steer.
TEST(UnicyclePilot, RefusesBadSamples) {
  Plant<Twist> plant(test::cart_limits(), {0, 0});
  plant.now_us = 1'000'000;
  Pilot<Twist> pilot(cart());
  Observation seen = plant.observe();
  EXPECT_TRUE(pilot.can_steer(seen));
  seen.heading.value = std::nan("");
  EXPECT_FALSE(pilot.can_steer(seen));
  seen = plant.observe();
  seen.position.stamp_us += 1;
  EXPECT_FALSE(pilot.can_steer(seen));
  seen = plant.observe();
  seen.velocity.stamp_us -= 200'001;
  EXPECT_FALSE(pilot.can_steer(seen));
}

// A measurement that comes again, or from before the halt acted, shows no rest: the robot may have
// been driven off since.
TEST(UnicyclePilot, RestsOnNewMeasurementsOfTheHaltOnly) {
  Plant<Twist> plant(test::cart_limits(), {0, 0});
  plant.now_us = 1'000'000;
  Pilot<Twist> pilot(cart());
  Observation seen = plant.observe();
  pilot.engage(seen);
  for (int i = 0; i < 10; ++i) {
    (void)pilot.halt(seen);
    seen.now_us += 10'000;
  }
  EXPECT_FALSE(pilot.latched());
  for (int i = 0; i < 10; ++i) {
    seen.velocity.stamp_us = seen.now_us;
    (void)pilot.halt(seen);
    seen.now_us += 10'000;
  }
  EXPECT_FALSE(pilot.latched());
  // where it rests is not known before a position comes that is as new
  seen.position.stamp_us = seen.now_us;
  (void)pilot.halt(seen);
  EXPECT_TRUE(pilot.latched());
}

// Measured to be still, wheels with a weak brake and a large error may still come on by decimetres.
TEST(UnicyclePilot, TellsWhereItStandsOnceItMustHaveStopped) {
  Setting setting = cart();
  setting.limits.velocity_error_mps = 0.1, setting.limits.brake_mps2 = 0.25;
  setting.limits.accel_mps2 = 0.25;
  Plant<Twist> plant(setting.limits, {0, 0});
  plant.noisy = 0;
  plant.speed = setting.limits.speed_mps;
  plant.velocity_bias = {-setting.limits.velocity_error_mps, 0};
  Pilot<Twist> pilot(setting);
  pilot.engage(plant.observe());
  for (int i = 0; i < 100 && !pilot.latched(); ++i) {
    plant.apply(pilot.halt(plant.observe()), 20'000);
  }
  ASSERT_TRUE(pilot.latched());
  const Vec2 told{pilot.halting()->place.x, pilot.halting()->place.y};
  for (int i = 0; i < 100; ++i) plant.apply(pilot.halt(plant.observe()), 20'000);
  EXPECT_LT(norm(plant.p - told), 0.01);
}

// Over a gap of samples it rests where it did. Measured elsewhere it was carried off: it does not
// set out from there before it has rested anew.
TEST(UnicyclePilot, RestsAnewWhereItWasCarried) {
  const Setting setting = cart();
  Plant<Twist> plant(setting.limits, {1, 1});
  Pilot<Twist> pilot(setting);
  const auto rest = [&] {
    for (int i = 0; i < 20; ++i) plant.apply(pilot.halt(plant.observe()), setting.period_us);
    EXPECT_TRUE(pilot.latched());
    return Vec2{pilot.halting()->place.x, pilot.halting()->place.y};
  };
  pilot.engage(plant.observe());
  const Vec2 before = rest();
  (void)pilot.brake_blind(plant.observe());
  EXPECT_FALSE(pilot.latched());
  EXPECT_EQ(norm(rest() - before), 0);

  plant.p = {2, 1};
  Path way;
  ASSERT_TRUE(way.points.push({3, 1}));
  EXPECT_EQ(driven(pilot, plant, way).speed_mps, 0);
  EXPECT_FALSE(pilot.latched());
  EXPECT_LT(norm(rest() - plant.p), setting.limits.position_error_m);
}

// A robot that has stopped is measured where it was before: that is not where it holds.
TEST(PointPilot, HoldsWhereItIsMeasuredAtRest) {
  Pilot<Acceleration> pilot(drone());
  Observation seen = Plant<Acceleration>(test::drone_limits(), {3, 0}).observe();
  seen.now_us = 5'000'000;
  seen.position = {{2, 0}, 4'900'000};
  seen.velocity = {{0, 0}, 5'000'000};
  pilot.engage(seen);
  for (int i = 0; i < 5; ++i) {
    seen.now_us += 20'000;
    seen.velocity.stamp_us = seen.now_us;
    (void)pilot.halt(seen);
    EXPECT_FALSE(pilot.latched());
  }
  seen.now_us += 20'000;
  seen.position = {{3, 0}, seen.now_us};
  (void)pilot.halt(seen);
  EXPECT_TRUE(pilot.latched());
  EXPECT_NEAR(pilot.halting()->place.x, 3, 1e-9);
}

}  // namespace
}  // namespace rtac::safe
