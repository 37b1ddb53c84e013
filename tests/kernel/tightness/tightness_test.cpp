// How tight the look-ahead of the kernel is, term by term: the worst case that was found across a
// wall over what the kernel demands to be free. 1: nothing is given away; above 1: unsound. Two
// searches that share nothing: Ipopt on the exact motion, and random restarts of a simulated robot.
// Bounds: theory, look-ahead against any control; what is asserted is stated in each row.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "rtac/optimize/worst_case.h"
#include "rtac/optimize/worst_unicycle.h"
#include "tests/kernel/plants.h"

namespace rtac::kernel_test {
namespace {

constexpr double pi = 3.141592653589793;
constexpr int restarts = 120;
// What integers and the step of the simulation may add, mm.
constexpr double rounding_mm = 0.5;

struct Term {
  const char* name;
  double at_least;  // share that some search must reach
  // mm, mm/s, us: zero is without
  std::int64_t speed_mmps = 20'000, accel_mmps2 = 1'500, brake_mmps2 = 2'000, horizon_us = 400'000;
  std::int64_t position_error_mm = 0, velocity_error_mmps = 0, age_us = 0, apart_us = 0;
  std::int64_t push_mmps2 = 0, brake_lag_ms = 0, hold_mm = 0;
  bool unicycle = false;
};

// Speeds from rest to this, mm/s.
double fastest(const Term& t) {
  return std::min<double>(static_cast<double>(t.speed_mmps), 2'000);
}

probe_robot robot_of(const Term& t) {
  probe_robot r = t.unicycle ? probe_cart() : probe_leaf();
  if (t.unicycle) return r;
  r.body.radius_mm = 0;
  r.body.speed_mmps = r.motion.speed_mmps = t.speed_mmps;
  r.body.accel_mmps2 = r.motion.accel_mmps2 = t.accel_mmps2 + t.push_mmps2;
  r.body.brake_mmps2 = t.brake_mmps2;
  r.body.position_error_mm = t.position_error_mm;
  r.body.velocity_error_mmps = t.velocity_error_mmps;
  r.body.brake_lag_ms = t.brake_lag_ms;
  r.body.brake_lag_permille = 0;
  r.body.hold_mm = t.hold_mm;
  const std::int64_t left = t.brake_mmps2 - t.push_mmps2;
  r.body.sway_permille = (1'000 * t.push_mmps2 + left - 1) / left;
  r.body.position_age_us = r.body.velocity_age_us = 1'000'000;
  return r;
}

// Seen at the origin at time 0, moving with `v`; the decision is `age_us` later.
probe_robot seen(const Term& t, Real v) {
  probe_robot r = robot_of(t);
  r.position = measured({0, 0}, t.apart_us);
  r.velocity = measured(v, 0);
  return r;
}

// How far off a wall across x has to be for the kernel to allow any control, mm.
double demanded_mm(const Term& t, Real v) {
  const probe_robot robot = seen(t, v);
  const probe_reach r = probe_reach_of(&robot, t.apart_us + t.age_us, t.horizon_us);
  EXPECT_EQ(r.input, 0) << t.name;
  const auto ahead = static_cast<double>(std::max<std::int64_t>(0, r.e.x - r.p.x));
  const auto capsule = static_cast<double>(r.capsule_mm - robot.body.radius_mm);
  return std::min(static_cast<double>(r.centre_mm), ahead + capsule);
}

// Of the cart of the probe, in units of the kernel.
constexpr double cart_accel_mmps2 = 1'000, cart_turn_radps = 2, cart_turn_accel_radps2 = 20;

double m(std::int64_t mm) {
  return 1e-3 * static_cast<double>(mm);
}

double unicycle_by_ipopt(const Term& t, Real v) {
  const probe_robot robot = seen(t, v);
  UnicycleProblem q;
  q.velocity = {1e-3 * v.x, 1e-3 * v.y};
  q.heading_rad = std::atan2(v.y, v.x);
  q.position_error_m = m(robot.body.position_error_mm);
  q.accel_mps2 = 1e-3 * cart_accel_mmps2;
  q.brake_mps2 = m(robot.body.brake_mmps2);
  q.speed_mps = m(robot.motion.speed_mmps);
  q.turn_radps = cart_turn_radps;
  q.turn_accel_radps2 = cart_turn_accel_radps2;
  q.horizon_s = 1e-6 * static_cast<double>(t.age_us + t.horizon_us);
  q.normal = {1, 0};
  const UnicycleMotion w = worst_motion(q);
  EXPECT_NE(w.status, SearchStatus::invalid_problem) << t.name;
  return 1e3 * w.reach_m;
}

// The worst that Ipopt finds, mm.
double by_ipopt(const Term& t, Real v) {
  if (t.unicycle) return unicycle_by_ipopt(t, v);
  ReachProblem q;
  q.velocity = {1e-3 * v.x, 1e-3 * v.y};
  q.position_error_m = m(t.position_error_mm);
  q.accel_mps2 = m(t.accel_mmps2 + t.push_mmps2);
  // the velocity may have changed before the position was measured
  q.velocity_error_mps = m(t.velocity_error_mmps) + q.accel_mps2 * 1e-6 * double(t.apart_us);
  q.brake_mps2 = m(t.brake_mmps2 - t.push_mmps2);  // pushed on, straight at the wall
  q.speed_mps = m(t.speed_mmps);
  q.horizon_s = 1e-6 * static_cast<double>(t.age_us + t.horizon_us);
  q.normal = {1, 0};
  const WorstCase w = worst_case(q);
  EXPECT_NE(w.status, SearchStatus::invalid_problem) << t.name;
  return 1e3 * w.excursion_m;
}

// The farthest across, from when its position was measured until it rests.
template <class Plant>
double farthest(Random& random, Plant plant, const Term& t, bool aimed, Real origin) {
  Whim whim(random);
  if (aimed) whim.settle(1, 0);
  double most = -1e9;
  const double end_s = 1e-6 * static_cast<double>(t.apart_us + t.age_us + t.horizon_us);
  for (int i = 0; i * dt_s < end_s - dt_s / 2; ++i) {
    if (i * dt_s >= 1e-6 * static_cast<double>(t.apart_us) - dt_s / 2) {
      most = std::max(most, plant.p.x - origin.x);
    }
    plant.free(whim, i * dt_s);
  }
  for (int left = 10'000; left > 0 && !plant.rests(); --left) {
    most = std::max(most, plant.p.x - origin.x);
    plant.stop();
  }
  return std::max(most, plant.p.x - origin.x);
}

// A true state that could have been seen so; half of the time the worst one.
Real within(Random& random, std::int64_t error, bool aimed) {
  return aimed ? Real{static_cast<double>(error), 0} : noise(random, static_cast<double>(error));
}

double by_restarts(const Term& t, Real v) {
  Random random(31);
  double most = -1e9;
  const probe_robot robot = seen(t, v);
  for (int i = 0; i < restarts; ++i) {
    const bool aimed = i % 2 == 0;
    if (t.unicycle) {
      CartPlant cart{{},
                     std::atan2(v.y, v.x),
                     norm(v),
                     0,
                     cart_accel_mmps2,
                     static_cast<double>(robot.body.brake_mmps2),
                     static_cast<double>(robot.motion.speed_mmps),
                     cart_turn_radps,
                     cart_turn_accel_radps2};
      cart.p = within(random, robot.body.position_error_mm, aimed);
      most = std::max(most, farthest(random, cart, t, aimed, {}));
      continue;
    }
    PointPlant plant{within(random, t.position_error_mm, aimed),
                     v + within(random, t.velocity_error_mmps, aimed),
                     static_cast<double>(t.accel_mmps2 + t.push_mmps2),
                     static_cast<double>(t.brake_mmps2), static_cast<double>(t.speed_mmps)};
    if (norm(plant.v) > plant.cap) plant.v = (plant.cap / norm(plant.v)) * plant.v;
    // moved before its position was measured: that is where it counts from
    Real origin{};
    if (t.apart_us > 0) {
      const double apart_s = 1e-6 * static_cast<double>(t.apart_us);
      origin = aimed ? apart_s * plant.v + (0.5 * plant.accel * apart_s * apart_s) * Real{1, 0}
                     : Real{1e9, 0};
    }
    most = std::max(most,
                    farthest(random, PushedPlant{plant, double(t.push_mmps2)}, t, aimed, origin));
  }
  return most;
}

struct Found {
  double ipopt = 0, restarts = 0;
};

// Over speeds and directions, the largest share of the bound.
Found tightness(const Term& t) {
  Found found;
  const double cap = t.unicycle ? static_cast<double>(probe_cart().motion.speed_mmps) : fastest(t);
  for (const double share : {0.0, 0.5, 0.999}) {
    for (const double angle : {0.0, pi / 3, 2 * pi / 3}) {
      const Real v = share * cap * heading(angle);
      const double demanded = demanded_mm(t, v);
      const double solved = by_ipopt(t, v), drawn = by_restarts(t, v);
      EXPECT_LE(solved, demanded + rounding_mm) << t.name << " " << share << " " << angle;
      EXPECT_LE(drawn, demanded + rounding_mm) << t.name << " " << share << " " << angle;
      found.ipopt = std::max(found.ipopt, solved / demanded);
      found.restarts = std::max(found.restarts, drawn / demanded);
    }
  }
  return found;
}

const Term terms[] = {
    {.name = "acceleration and stop (Mitsch 1)", .at_least = 0.95},
    {.name = "greatest speed", .at_least = 0.95, .speed_mmps = 1'200},
    {.name = "sample age", .at_least = 0.95, .age_us = 200'000},
    {.name = "position error", .at_least = 0.95, .position_error_mm = 50},
    {.name = "velocity error", .at_least = 0.95, .velocity_error_mmps = 100},
    {.name = "stamps apart", .at_least = 0.95, .apart_us = 100'000},
    {.name = "disturbance", .at_least = 0.95, .push_mmps2 = 300},
    {.name = "lag and hold of the brake",
     .at_least = 0.6,
     .position_error_mm = 20,
     .velocity_error_mmps = 20,
     .brake_lag_ms = 92,
     .hold_mm = 67},
    {.name = "noise and greatest speed",
     .at_least = 0.95,
     .speed_mmps = 1'500,
     .position_error_mm = 20,
     .velocity_error_mmps = 50,
     .age_us = 100'000},
    {.name = "unicycle", .at_least = 0.6, .horizon_us = 250'000, .unicycle = true},
};

// Two robots that come towards one another, one of which is known from a message of this age: how
// near they can get, over the gap that the kernel demands.
struct Pair {
  Term self, other;
};
double demanded_gap_mm(const Pair& pair, double speed) {
  constexpr double far_mm = 30'000;
  const std::int64_t now_us = pair.other.age_us;
  probe_robot r = robot_of(pair.self), q = robot_of(pair.other);
  r.position = measured({0, 0}, now_us - pair.self.age_us);
  r.velocity = measured({speed, 0}, now_us - pair.self.age_us);
  q.position = measured({far_mm, 0}, 0);
  q.velocity = measured({-speed, 0}, 0);
  const probe_span margin = probe_pair_ahead(&r, &q, now_us, pair.self.horizon_us, 0);
  EXPECT_EQ(margin.input, 0) << pair.other.name;
  return far_mm - 1e-3 * static_cast<double>(margin.lo);
}
Found tightness(const Pair& pair) {
  Found found;
  for (const double share : {0.0, 0.5, 0.999}) {
    const Real v{share * fastest(pair.self), 0};
    const double demanded = demanded_gap_mm(pair, v.x);
    const double solved = by_ipopt(pair.self, v) + by_ipopt(pair.other, v);
    const double drawn = by_restarts(pair.self, v) + by_restarts(pair.other, v);
    EXPECT_LE(solved, demanded + 2 * rounding_mm) << pair.other.name << " " << share;
    EXPECT_LE(drawn, demanded + 2 * rounding_mm) << pair.other.name << " " << share;
    found.ipopt = std::max(found.ipopt, solved / demanded);
    found.restarts = std::max(found.restarts, drawn / demanded);
  }
  return found;
}
const Pair pairs[] = {
    {{.name = "", .at_least = 0}, {.name = "two robots (Mitsch 2)", .at_least = 0.95}},
    {{.name = "", .at_least = 0},
     {.name = "two robots, age of a message", .at_least = 0.95, .age_us = 300'000}},
    {{.name = "",
      .at_least = 0,
      .position_error_mm = 20,
      .velocity_error_mmps = 50,
      .age_us = 100'000},
     {.name = "two robots, with noise",
      .at_least = 0.6,
      .position_error_mm = 20,
      .velocity_error_mmps = 50,
      .age_us = 300'000}},
};

void print_and_check(const Term& t, const Found& found) {
  char row[120];
  std::snprintf(row, sizeof row, "  %-35s  %.3f    %.3f\n", t.name, found.ipopt, found.restarts);
  std::cout << row;
  EXPECT_GE(found.ipopt, t.at_least) << t.name;
  EXPECT_GE(found.restarts, t.at_least) << t.name;
}

TEST(Tightness, OfTheLookAheadByTerm) {
  std::cout << "worst case found / bound               Ipopt  restarts\n";
  for (const Term& t : terms) print_and_check(t, tightness(t));
}

TEST(Tightness, OfTheLookAheadForTwoRobots) {
  std::cout << "worst case found / bound               Ipopt  restarts\n";
  for (const Pair& p : pairs) print_and_check(p.other, tightness(p));
}

}  // namespace
}  // namespace rtac::kernel_test
