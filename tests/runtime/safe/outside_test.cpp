// Language rule 11: a robot that is outside at the start, whoever has put it there and however fast
// it is, comes back: after it has braked the violation never grows by more than twice the error of
// the position, and while the way in is driven it shrinks at half the declared speed at least.
#include <gtest/gtest.h>

#include <random>

#include "rtac/safe/controllers.h"
#include "tests/runtime/core/test_plants.h"
#include "yard_retreat_system.h"

namespace rtac {
namespace {

constexpr double s_per_us = 1e-6;
constexpr TimeUs second = 1'000'000;
constexpr double speed_mps = 0.3;
constexpr int starts = 500;

const ZoneView& yard() {
  return yard_retreat::yard_zone();
}

template <class Output>
safe::Setting setting_of(const RobotLimits& limits, double return_clearance_m, double route_m) {
  safe::Setting s;
  s.limits = limits, s.period_us = 50'000, s.speed_mps = speed_mps, s.zone = &yard();
  s.route_clearance_m = route_m, s.return_clearance_m = return_clearance_m, s.pass_gap_m = 1;
  return s;
}
struct Drone {
  using Output = Acceleration;
  static RobotLimits limits() { return yard_retreat::Drone_limits(); }
  static safe::Setting setting() {
    return setting_of<Output>(limits(), yard_retreat::DroneSystem::return_clearance_m, 0.511);
  }
};
struct Cart {
  using Output = Twist;
  static RobotLimits limits() { return yard_retreat::Cart_limits(); }
  static safe::Setting setting() {
    return setting_of<Output>(limits(), yard_retreat::CartSystem::return_clearance_m, 0.414);
  }
};

// Beyond the walls, at their corners, and in the shed: outside by a body at least.
Vec2 some_place_outside(std::mt19937_64& random) {
  std::uniform_real_distribution<> x(-0.8, 8.8), y(-0.8, 6.8);
  std::uniform_real_distribution<> shed_x(4, 5), shed_y(2.5, 3.5);
  const bool in_shed = random() % 4 == 0;
  for (;;) {
    const Vec2 p = in_shed ? Vec2{shed_x(random), shed_y(random)} : Vec2{x(random), y(random)};
    if (signed_clearance(yard(), p) < -0.01) return p;
  }
}

template <class Output>
void set_off(test::Plant<Output>& plant, std::mt19937_64& random) {
  std::uniform_real_distribution<> angle(-3.14, 3.14), part(0, 1);
  const double heading = angle(random), speed = part(random) * plant.limits.speed_mps;
  plant.heading = heading, plant.speed = speed;
  plant.v = speed * Vec2{std::cos(heading), std::sin(heading)};
  plant.noise.seed(static_cast<unsigned>(random()));
}

// By how much the body is outside.
double violation_m(Vec2 p, const RobotLimits& limits) {
  return std::max(0.0, limits.radius_m - signed_clearance(yard(), p));
}

// One run: every 10 ms how far the robot is outside.
template <class Output>
std::vector<double> come_back(SafeController<Output>& recovery, test::Plant<Output>& plant,
                              TimeUs period_us) {
  std::vector<double> outside_m;
  recovery.engage(plant.observe());
  while (plant.now_us < 30 * second) {
    const Output out = recovery.command(plant.observe(), Gate::free);
    for (TimeUs done_us = 0; done_us < period_us; done_us += 10'000) {
      plant.apply(out, 10'000);
      outside_m.push_back(violation_m(plant.p, plant.limits));
    }
  }
  return outside_m;
}

struct Worst {
  double growth_m = 0, rate_mps = 9, left_m = 0;
};

// theory, already outside: after V/b + tau; and from when it drives, until it is nearly in.
void judge(const std::vector<double>& outside_m, const RobotLimits& limits, Worst& worst) {
  const double tau_s = static_cast<double>(limits.latency_us + 50'000) * s_per_us;
  const auto braked = std::size_t((limits.speed_mps / limits.brake_mps2 + tau_s) * 100);
  double least = outside_m[braked];
  std::size_t drives = 0;
  for (std::size_t i = braked; i < outside_m.size(); ++i) {
    least = std::min(least, outside_m[i]);
    worst.growth_m = std::max(worst.growth_m, outside_m[i] - least);
    if (drives == 0 && outside_m[i] < outside_m[braked] - 0.08) drives = i;
  }
  worst.left_m = std::max(worst.left_m, outside_m.back());
  if (drives == 0) return;
  for (std::size_t i = drives; i + 200 < outside_m.size() && outside_m[i + 200] > 0; ++i) {
    worst.rate_mps = std::min(worst.rate_mps, (outside_m[i] - outside_m[i + 200]) / 2);
  }
}

template <class Robot, class Recovery>
Worst worst_of(Recovery& recovery, unsigned seed) {
  std::mt19937_64 random(seed);
  Worst worst;
  for (int i = 0; i < starts; ++i) {
    test::Plant<typename Robot::Output> plant(Robot::limits(), some_place_outside(random));
    set_off(plant, random);
    judge(come_back(recovery, plant, 50'000), Robot::limits(), worst);
  }
  return worst;
}

template <class Robot>
class Outside : public testing::Test {
 public:
  static void expect_back(const Worst& worst) {
    EXPECT_LE(worst.growth_m, 2 * Robot::limits().position_error_m);
    EXPECT_GE(worst.rate_mps, speed_mps / 2);
    EXPECT_LT(worst.rate_mps, 2 * speed_mps);  // it was measured
    EXPECT_EQ(worst.left_m, 0);
  }
};
using Robots = testing::Types<Drone, Cart>;
TYPED_TEST_SUITE(Outside, Robots);

TYPED_TEST(Outside, ARetreatComesBack) {
  safe::Retreat<typename TypeParam::Output> retreat(TypeParam::setting());
  this->expect_back(worst_of<TypeParam>(retreat, 1));
}
TYPED_TEST(Outside, ALoiteringRobotComesBack) {
  safe::Loiter<typename TypeParam::Output> loiter(TypeParam::setting());
  this->expect_back(worst_of<TypeParam>(loiter, 2));
}
TYPED_TEST(Outside, ARouteComesBack) {
  safe::Route<typename TypeParam::Output> route(TypeParam::setting(), {2, 3});
  this->expect_back(worst_of<TypeParam>(route, 3));
}

// What would stand for a while first does not do so there.
TYPED_TEST(Outside, ASequenceComesBack) {
  using Output = typename TypeParam::Output;
  safe::Sequence<Output> sequence(
      safe::step<safe::BrakeAndHold, Output>(25 * second, TypeParam::setting()),
      safe::step<safe::Retreat, Output>(0, TypeParam::setting()));
  this->expect_back(worst_of<TypeParam>(sequence, 4));
}

// A robot that stands on the way in is not driven over: it waits outside.
TYPED_TEST(Outside, NobodyIsDrivenOver) {
  test::Plant<typename TypeParam::Output> plant(TypeParam::limits(), {-0.5, 3});
  safe::Retreat<typename TypeParam::Output> retreat(TypeParam::setting());
  plant.seen.robots = 2;
  Announcement& other = plant.seen.others[1];
  other.position = {{0.4, 3}, 0}, other.velocity = {{0, 0}, 0}, other.lease_end_us = INT64_MAX / 2;
  retreat.engage(plant.observe());
  double nearest = 9;
  for (int i = 0; i < 400; ++i) {
    tick(retreat, plant, Gate::away_only, 50'000);
    nearest = std::min(nearest, norm(plant.p - Vec2{0.4, 3}));
  }
  EXPECT_GE(nearest, 0.9 - 0.05);
}

}  // namespace
}  // namespace rtac
