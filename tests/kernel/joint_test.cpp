// What concerns more than one robot's motion: two robots that both do their worst, one that has
// promised to stay, the charge for the way home, and the legs of plans. A check that says "true"
// is compared with what then happens, or with exact geometry.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kernel/plants.h"

namespace rtac::kernel_test {
namespace {

constexpr double rounding_mm = 0.01;
constexpr std::int64_t horizon_us = 250'000;  // of a cart in probe.rta; here of all
constexpr std::int64_t least_mm = 200;

// A point mass with an ideal brake: nothing of the bounds is left over for it.
probe_robot ideal_robot() {
  probe_robot robot = probe_drone();
  robot.body.brake_lag_ms = robot.body.brake_lag_permille = 0;
  robot.body.hold_mm = 30;
  return robot;
}

// A robot with its samples; the other's may be as old as a message.
struct Mover {
  probe_robot robot;
  PointPlant plant;
  Whim whim;
  std::vector<Real> path;

  Mover(Random& random, Real at, std::int64_t age_us)
      : robot(ideal_robot()),
        plant{at,
              {},
              static_cast<double>(robot.motion.accel_mmps2),
              static_cast<double>(robot.body.brake_mmps2),
              static_cast<double>(robot.motion.speed_mmps)},
        whim(random) {
    plant.v = random.real(0, 1) * plant.cap * heading(random.real(-3.2, 3.2));
    robot.body.position_age_us = robot.body.velocity_age_us = age_us;
    robot.position = measured(
        plant.p + noise(random, static_cast<double>(robot.body.position_error_mm)), -age_us);
    robot.velocity = measured(
        plant.velocity() + noise(random, static_cast<double>(robot.body.velocity_error_mmps)),
        -age_us);
  }
  // Straight towards `goal`, as fast as it can.
  void charge_at(Real goal) {
    const double angle = std::atan2(goal.y - plant.p.y, goal.x - plant.p.x);
    plant.v = norm(plant.v) * heading(angle);
    whim.settle(1, angle);
    robot.velocity = measured(plant.v, robot.position.stamp_us);
  }
  void shift(Real by) {
    const Real old = plant.p;
    plant.p = old + by;
    robot.position = measured(plant.p, robot.position.stamp_us);
  }
  // From the stamp of its samples to rest.
  void run() {
    double t_s = 1e-6 * static_cast<double>(robot.position.stamp_us);
    path.push_back(plant.p);
    for (; t_s < 1e-6 * static_cast<double>(horizon_us) - dt_s / 2; t_s += dt_s) {
      plant.free(whim, t_s);
      path.push_back(plant.p);
    }
    for (int left = 3'000; left > 0 && !plant.rests(); --left) {
      plant.stop();
      path.push_back(plant.p);
    }
  }
};

double closest(const Mover& a, const Mover& b) {
  // aligned in time at their ends of control, which is the same instant for both
  const auto skip = [](const Mover& m) {
    return static_cast<std::size_t>(-m.robot.position.stamp_us / 2'000);
  };
  double least = 1e12;
  for (std::size_t t = 0; t < std::max(a.path.size(), b.path.size()); ++t) {
    const auto at = [&](const Mover& m) {
      return m.path[std::min(skip(m) + t, m.path.size() - 1)];
    };
    least = std::min(least, norm(at(a) - at(b)));
  }
  return least;
}

TEST(PairAhead, TwoRobotsThatDoTheirWorstKeepTheirDistance) {
  Random random(31);
  int passed = 0;
  double worst = 1e9;
  for (int i = 0; i < 40'000; ++i) {
    const Real there = random.real(500, 7'000) * heading(random.real(-3.2, 3.2));
    Mover one(random, {}, 2'000 * random.in(0, 75));
    Mover other(random, there, 2'000 * random.in(0, 150));
    if (random.one_in(2)) {
      one.charge_at(other.plant.p);
      other.charge_at(one.plant.p);
    }
    const auto margin = [&] {
      return probe_pair_ahead(&one.robot, &other.robot, 0, horizon_us, least_mm).lo;
    };
    if (margin() < 0) continue;
    // as near as the check allows
    other.shift((-1e-3 * static_cast<double>(margin() - 4'000) / norm(there)) * there);
    if (margin() < 0) continue;
    ++passed;
    one.run();
    other.run();
    const double gap = closest(one, other) - 2.0 * static_cast<double>(one.robot.body.radius_mm);
    worst = std::min(worst, gap - static_cast<double>(least_mm));
    ASSERT_GE(gap, static_cast<double>(least_mm) - rounding_mm);
  }
  RecordProperty("least_spare_mm", std::to_string(worst));
  EXPECT_GT(passed, 5'000);
  EXPECT_LT(worst, 150);  // errors and holds of both, of which they need not make use
}

TEST(PairAhead, ARobotThatStaysCountsAsWhereItWasHeard) {
  // HELD: wherever it rests within its hold, whatever the age of the message.
  Random random(32);
  int held = 0, moving = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Real there = random.real(300, 5'000) * heading(random.real(-3.2, 3.2));
    Mover one(random, {}, 2'000 * random.in(0, 75));
    Mover other(random, there, 300'000);
    other.plant.v = {};
    other.robot.velocity = measured({}, -300'000);
    moving += probe_pair_ahead(&one.robot, &other.robot, 0, horizon_us, least_mm).lo >= 0;
    other.robot.held = 1;
    if (probe_pair_ahead(&one.robot, &other.robot, 0, horizon_us, least_mm).lo < 0) continue;
    ++held;
    one.run();
    const Real rest = there + noise(random, static_cast<double>(other.robot.body.hold_mm));
    for (const Real& p : one.path) {
      ASSERT_GE(norm(p - rest) - 2.0 * static_cast<double>(one.robot.body.radius_mm),
                static_cast<double>(least_mm) - rounding_mm);
    }
  }
  EXPECT_GT(held, moving + 1'000);
}

TEST(EnergyAhead, WhereverTheRobotStopsTheChargeSufficesForItsWay) {
  // Drains at the declared maximum until the recovery acts, then stands somewhere within reach.
  Random random(33);
  constexpr std::int64_t drain = 10'000, reserve = 50'000;
  int passed = 0;
  for (int i = 0; i < 25'000; ++i) {
    const Real at = {random.real(300, 8'500), random.real(300, 9'700)};
    Mover one(random, at, 2'000 * random.in(0, 75));
    const std::int64_t age_us = 2'000 * random.in(0, 2'500);
    const double then = random.real(100'000, 400'000);
    const auto seen = static_cast<std::int64_t>(std::floor(then + random.real(-5'000, 5'000)));
    const probe_scalar battery = {seen, seen + 1, -age_us, 1};
    const probe_span charge = probe_charge(&battery, 0, 5'000'000, 5'000, drain);
    const probe_span margin =
        probe_energy_ahead(0, &one.robot, charge, 0, horizon_us, reserve, drain);
    if (margin.lo < 0) continue;
    ++passed;
    one.run();
    const Real rest = one.path.back();
    const double left = then - 1e-6 * static_cast<double>((age_us + horizon_us) * drain);
    const probe_span way =
        probe_way(0, {static_cast<std::int64_t>(rest.x), static_cast<std::int64_t>(rest.y)}, 0);
    if (way.hi == 1 << 30) continue;  // no body fits there: the fence keeps the robot away
    ASSERT_GE(left, static_cast<double>(way.hi + reserve));
  }
  EXPECT_GT(passed, 3'000);
}

TEST(Way, IsNotUnderestimatedWithinARadius) {
  Random random(34);
  for (int i = 0; i < 5'000; ++i) {
    const probe_vec at = {random.in(-500, 20'500), random.in(-500, 10'500)};
    const std::int64_t radius = random.in(0, 700);
    const probe_span near = probe_way(1, at, radius);
    for (int k = 0; k < 20; ++k) {
      const Real q = real(at) + noise(random, static_cast<double>(radius));
      const probe_span way = probe_way(
          1,
          {static_cast<std::int64_t>(std::floor(q.x)), static_cast<std::int64_t>(std::floor(q.y))},
          0);
      if (way.hi == 1 << 30) continue;
      ASSERT_LE(way.hi, near.hi);
      ASSERT_GE(way.hi, near.lo);
    }
  }
}

// `violated` has to be certain: a cell says what the way takes at most, and a true way may be
// cheaper. It takes what the straight line costs to drive at least: 0.5 % a metre, to (2 m, 4 m).
TEST(Way, TakesAtLeastTheDrivingOfTheStraightLine) {
  Random random(35);
  for (int i = 0; i < 5'000; ++i) {
    const probe_vec at = {random.in(-500, 20'500), random.in(-500, 10'500)};
    const std::int64_t radius = random.in(0, 700);
    const probe_span way = probe_way(1, at, radius);
    const Real dock{2'000, 4'000}, q = real(at) + noise(random, static_cast<double>(radius));
    ASSERT_LE(static_cast<double>(way.lo), 5 * norm(q - dock));
    // and not needlessly less: 1 mm and 1 ppm of rounding
    ASSERT_GE(static_cast<double>(way.lo), 5 * (norm(real(at) - dock) - double(radius)) - 6);
  }
}

// ---- legs ------------------------------------------------------------------------------------

probe_plan random_plan(Random& random) {
  probe_plan plan{};
  plan.valid = 1;
  plan.count = static_cast<std::int32_t>(random.in(1, 8));
  plan.index = static_cast<std::int32_t>(random.in(0, plan.count));
  probe_vec at = {random.in(0, 20'000), random.in(0, 10'000)};
  for (int k = 0; k < plan.count; ++k) {
    at = {at.x + random.in(-4'000, 4'000), at.y + random.in(-2'500, 2'500)};
    plan.x[k] = at.x;
    plan.y[k] = at.y;
  }
  return plan;
}

// Exactly: the leg lies inside and keeps `need` to the boundary; with 3 mm more it must pass.
struct ExactLeg {
  bool keeps, keeps_more;
};
ExactLeg exact_leg(const probe_zone& z, probe_vec from, probe_vec to, std::int64_t need) {
  ExactLeg leg{inside(z, from) && inside(z, to), true};
  leg.keeps_more = leg.keeps;
  for (std::int32_t i = 0; i < z.count; ++i) {
    for (const Square& s : segment_gaps(from, to, begin_of(z.edges[i]), end_of(z.edges[i]))) {
      leg.keeps = leg.keeps && s.at_least(need) && s.num > 0;
      leg.keeps_more = leg.keeps_more && s.at_least(need + 3);
    }
  }
  return leg;
}

TEST(Legs, PassExactlyWhenThePresentAndTheNextLegsKeepTheirDistance) {
  Random random(35);
  probe_zone z{};
  probe_floor(&z);
  int passed = 0, failed = 0;
  for (int i = 0; i < 40'000; ++i) {
    const probe_plan plan = random_plan(random);
    probe_robot robot = probe_cart();
    const probe_vec here = {random.in(0, 20'000), random.in(0, 10'000)};
    robot.position = {here.x, here.x, here.y, here.y, 0, 1};
    robot.velocity = {0, 0, 0, 0, 0, 1};
    const std::int64_t need = random.in(1, 300);
    const auto legs = static_cast<std::int32_t>(random.in(0, 3));
    const probe_span margin = probe_legs(&z, &robot, &plan, 0, legs, need);
    bool keeps = true, keeps_more = true;
    probe_vec from = here;
    for (int k = plan.index; k < plan.count && k <= plan.index + legs; ++k) {
      const probe_vec to = {plan.x[k], plan.y[k]};
      const ExactLeg leg = exact_leg(z, from, to, need + robot.body.position_error_mm);
      keeps = keeps && leg.keeps;
      keeps_more = keeps_more && leg.keeps_more;
      from = to;
    }
    ASSERT_TRUE(keeps || margin.lo < 0);
    ASSERT_TRUE(margin.lo >= 0 || !keeps_more);
    ++(margin.lo >= 0 ? passed : failed);
  }
  EXPECT_GT(passed, 5'000);
  EXPECT_GT(failed, 5'000);
}

TEST(PlanLegs, APlanThatCrossesTheBoundaryBetweenGoodWayPointsFails) {
  // Both ends lie well inside; the leg goes through the pool, or out and in again.
  probe_zone z{};
  probe_floor(&z);
  probe_plan plan{};
  plan.valid = 1;
  plan.count = 2;
  plan.x[0] = 8'000, plan.y[0] = 5'000;
  plan.x[1] = 12'000, plan.y[1] = 5'000;
  EXPECT_LT(probe_plan_legs(&z, &plan, 1).lo, 0);
  EXPECT_LT(probe_plan_legs(&z, &plan, 1).hi, 0);
  EXPECT_LT(probe_plan_legs(&z, &plan, 0).lo, 0);
  plan.y[0] = plan.y[1] = 7'000;
  EXPECT_GE(probe_plan_legs(&z, &plan, 1).lo, 0);
}

TEST(PlanLegs, TrueIsExactlyTrueAndFalseIsExactlyFalse) {
  Random random(36);
  probe_zone z{};
  probe_floor(&z);
  int yes = 0, no = 0;
  for (int i = 0; i < 40'000; ++i) {
    const probe_plan plan = random_plan(random);
    const probe_span margin = probe_plan_legs(&z, &plan, 1);
    bool keeps = true, keeps_more = true;
    for (int k = 0; k < plan.count; ++k) {
      const probe_vec to = {plan.x[k], plan.y[k]};
      const probe_vec from = k > 0 ? probe_vec{plan.x[k - 1], plan.y[k - 1]} : to;
      keeps = keeps && exact_leg(z, from, to, 0).keeps;
      keeps_more = keeps_more && exact_leg(z, from, to, 1).keeps_more;
    }
    ASSERT_TRUE(keeps || margin.lo < 0);
    ASSERT_FALSE(keeps && margin.hi < 0);
    ASSERT_TRUE(margin.lo >= 0 || !keeps_more);
    yes += margin.lo >= 0;
    no += margin.hi < 0;
  }
  EXPECT_GT(yes, 3'000);
  EXPECT_GT(no, 3'000);
}

}  // namespace
}  // namespace rtac::kernel_test
