// Rules 7 and 11: the name of a robot is its body, and where the body is takes its position alone.
// Carts have a radius of 10 cm and err by 1 cm.
#include <gtest/gtest.h>

#include "tests/kernel/scenes.h"

namespace rtac::kernel_test {
namespace {

// What the monitor finds about the present, with the cart at `at`.
Verdict fence_at(Vec2 at) {
  GuardScene s;
  s.tick();
  s.at = at;
  return s.tick().monitors[fence].now;
}

TEST(Rule7, AClearanceIsThatOfTheBody) {
  // 5 cm from the wall to the body are 15 cm to the centre.
  EXPECT_EQ(fence_at({0.12, 5}), Verdict::is_false);
  EXPECT_EQ(fence_at({0.18, 5}), Verdict::is_true);
}

TEST(Rule7, AClearanceOutsideIsNegative) {
  EXPECT_EQ(fence_at({-5, 5}), Verdict::is_false);
  EXPECT_EQ(fence_at({10, 5}), Verdict::is_false) << "in the middle of the pool";
}

TEST(Rule7, ADistanceIsThatOfTheBodies) {
  // 20 cm between the bodies are 40 cm between the centres.
  for (const double centres_m : {0.35, 0.45}) {
    GuardScene s;
    s.tick();
    s.other[1] = {s.at.x + centres_m, s.at.y};
    EXPECT_EQ(s.tick().monitors[separation].now,
              centres_m < 0.4 ? Verdict::is_false : Verdict::is_true);
  }
}

// The fence asks for 15 cm to the centre.
TEST(Rule11, AViolationIsKnownFromThePositionAlone) {
  GuardScene s;
  s.tick();
  s.at = {0.12, 5};
  s.v.x = nan_value;
  EXPECT_EQ(s.tick().monitors[fence].now, Verdict::is_false);
}

// What lies ahead does take the velocity.
TEST(Rule11, AVelocityThatIsMissingIsNotAdmissibleWhereverTheRobotIs) {
  GuardScene s;
  s.tick();
  s.v.x = nan_value;
  const DecisionRecord& r = s.tick();
  EXPECT_EQ(r.monitors[fence].now, Verdict::is_true);
  EXPECT_EQ(r.monitors[fence].ahead, Verdict::is_unknown);
  EXPECT_FALSE(r.advanced());
}

// At 1 m/s it may be 10 cm farther in after 100 ms; at rest it would still be outside.
TEST(Rule11, WithoutAVelocityTheRobotMayHaveMovedAtItsDeclaredSpeed) {
  for (const bool known : {true, false}) {
    GuardScene s;
    s.tick();
    s.at = {0.1, 5};
    s.position_age_us = 100'000;
    if (!known) s.v.y = inf_value;
    EXPECT_EQ(s.tick().monitors[fence].now, known ? Verdict::is_false : Verdict::is_unknown);
  }
}

// A sample of it that comes late says as little.
TEST(Rule11, AVelocityThatGoesBackwardsIsNone) {
  GuardScene s;
  s.tick();
  s.at = {0.1, 5};
  s.position_age_us = 100'000;
  s.velocity_age_us = 120'000;
  EXPECT_EQ(s.tick().monitors[fence].now, Verdict::is_unknown);
}

// 20 cm between the bodies are 40 cm between the centres.
TEST(Rule11, TheVelocityOfAnotherRobotIsNotNeededEither) {
  GuardScene s;
  s.tick();
  s.other[1] = {s.at.x + 0.35, s.at.y};
  s.other_v[1].x = nan_value;
  const DecisionRecord& r = s.tick();
  EXPECT_EQ(r.monitors[separation].now, Verdict::is_false);
  EXPECT_EQ(r.reason, Reason::violated);
  s.heard_age_us = 100'000;
  EXPECT_EQ(s.tick().monitors[separation].now, Verdict::is_unknown);
}

}  // namespace
}  // namespace rtac::kernel_test
