// Each template against adversaries: the property holds on the true state of every millisecond, and
// control comes back.
#include <gtest/gtest.h>

#include "tests/runtime/safe/robots.h"
#include "yard_brake_system.h"
#include "yard_loiter_system.h"
#include "yard_retreat_system.h"
#include "yard_route_system.h"
#include "yard_sequence_system.h"

namespace {

using rtac::TimeUs;
using rtac::Vec2;

constexpr TimeUs second = 1'000'000;

RTAC_TEST_YARD(yard_brake);
RTAC_TEST_YARD(yard_retreat);
RTAC_TEST_YARD(yard_route);
RTAC_TEST_YARD(yard_loiter);
RTAC_TEST_YARD(yard_sequence);

template <class Robot>
class Templates : public testing::Test {};
using Robots =
    testing::Types<yard_brake_drone, yard_brake_cart, yard_retreat_drone, yard_retreat_cart,
                   yard_route_drone, yard_route_cart, yard_loiter_drone, yard_loiter_cart,
                   yard_sequence_drone, yard_sequence_cart>;
TYPED_TEST_SUITE(Templates, Robots);

// The least clearance of the body in a run.
template <class Robot>
double least_m(rtac::Controller<typename Robot::Output>& adversary, std::uint64_t seed) {
  rtac::sim::RobotSetup robot;
  robot.start = {2.0 + 0.1 * double(seed % 3), 3};
  robot.heading_rad = double(seed);
  double least = 9;
  (void)Robot::run(robot, seed, 60 * second, adversary,
                   [&](TimeUs, const rtac::sim::TruthState& truth) {
                     least = std::min(least, rtac::signed_clearance(Robot::zone(), truth.position));
                   });
  return least - Robot::limits().radius_m;
}

TYPED_TEST(Templates, KeepTheFence) {
  using Output = typename TypeParam::Output;
  double least = 9;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    rtac::sim::PushAtNearest<Output> push(TypeParam::limits(), &TypeParam::zone());
    rtac::sim::BangBang<Output> bang(TypeParam::limits(), seed, 50'000, 1'500'000);
    least = std::min(least, least_m<TypeParam>(push, seed));
    least = std::min(least, least_m<TypeParam>(bang, seed));
  }
  EXPECT_GE(least, 0);
  EXPECT_LT(least, 1);  // the adversaries do come near
}

// Whoever moves away from the wall gives control back again and again.
template <class Robot>
class Moving : public testing::Test {};
using MovingRobots = testing::Types<yard_retreat_drone, yard_retreat_cart, yard_loiter_drone,
                                    yard_loiter_cart, yard_sequence_drone, yard_sequence_cart>;
TYPED_TEST_SUITE(Moving, MovingRobots);

TYPED_TEST(Moving, GivesControlBack) {
  using Output = typename TypeParam::Output;
  rtac::sim::PushAtNearest<Output> push(TypeParam::limits(), &TypeParam::zone());
  rtac::sim::RobotSetup robot;
  robot.start = {2, 3};
  const auto shares = TypeParam::run(robot, 5, 120 * second, push, [](TimeUs, const auto&) {});
  EXPECT_GE(shares.engagements(), 4);
  EXPECT_LT(shares.longest_us(), 25 * second);
}

}  // namespace
