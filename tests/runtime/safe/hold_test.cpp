// theory, the brake: the sampled hold does not creep. A robot that was driven at a wall stands for
// an hour, in noise on its bounds and with samples as old as they may be.
#include <gtest/gtest.h>

#include "tests/runtime/safe/robots.h"
#include "yard_brake_system.h"

namespace {

using rtac::TimeUs;
using rtac::Vec2;

constexpr TimeUs second = 1'000'000;

RTAC_TEST_YARD(yard_brake);

template <class Robot>
class Hold : public testing::Test {};
using Robots = testing::Types<yard_brake_drone, yard_brake_cart>;
TYPED_TEST_SUITE(Hold, Robots);

// The adversary drives at the wall at full effort for as long as it is let. Where it stops there is
// too little clearance to give control back, so the robot stays for the rest of the hour.
TYPED_TEST(Hold, AnHourWithoutCreep) {
  using Output = typename TypeParam::Output;
  rtac::sim::PushAtNearest<Output> push(TypeParam::limits(), &TypeParam::zone());
  rtac::sim::RobotSetup robot;
  robot.start = {2.5, 3};
  Vec2 rest{};
  double crept_m = 0, clearance_m = 9;
  const auto shares = TypeParam::run(
      robot, 3, 3600 * second, push, [&](TimeUs now_us, const rtac::sim::TruthState& truth) {
        if (now_us <= 60 * second) rest = truth.position;
        crept_m = std::max(crept_m, rtac::norm(truth.position - rest));
        clearance_m =
            std::min(clearance_m, rtac::signed_clearance(TypeParam::zone(), truth.position) - 0.2);
      });
  EXPECT_GT(shares.longest_us(), 3300 * second);
  EXPECT_GE(clearance_m, 0);
  // far less than what the compiler takes a hold to move
  EXPECT_LT(crept_m, 0.05);
}

}  // namespace
