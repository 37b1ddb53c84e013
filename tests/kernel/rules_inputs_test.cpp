// Rules 5 and 6: an input that is missing, too old, not finite, from the future, going backwards or
// out of range is unknown, and unknown is never admissible for the advanced controller.
#include <gtest/gtest.h>

#include <functional>
#include <ostream>

#include "tests/kernel/scenes.h"

namespace rtac::kernel_test {
namespace {

struct Fault {
  const char* name;
  std::function<void(GuardScene&)> spoil;
  InputField field;
};
std::ostream& operator<<(std::ostream& to, const Fault& fault) {
  return to << fault.name;
}

class Input : public ::testing::TestWithParam<Fault> {};

TEST_P(Input, IsUnknownAndTheRecoveryDrivesWithTheRightReason) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  ASSERT_TRUE(s.tick().advanced());
  GetParam().spoil(s);
  const DecisionRecord& r = s.tick();
  EXPECT_FALSE(r.advanced());
  EXPECT_EQ(r.reason, Reason::input);
  EXPECT_EQ(r.reason_input, GetParam().field);
}

TEST_P(Input, IsUnknownAtTheStart) {
  GuardScene s;
  GetParam().spoil(s);
  const DecisionRecord& r = s.tick();
  EXPECT_FALSE(r.advanced());
  EXPECT_EQ(r.reason, Reason::input);
  EXPECT_EQ(r.reason_input, GetParam().field);
}

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all = {
      {"PositionTooOld", [](GuardScene& s) { s.position_age_us = 200'001; }, InputField::position},
      {"PositionFromTheFuture", [](GuardScene& s) { s.position_age_us = -1; },
       InputField::position},
      {"PositionNan", [](GuardScene& s) { s.at.x = nan_value; }, InputField::position},
      {"PositionInfinite", [](GuardScene& s) { s.at.y = -inf_value; }, InputField::position},
      {"VelocityTooOld", [](GuardScene& s) { s.velocity_age_us = 150'001; }, InputField::velocity},
      {"VelocityFromTheFuture", [](GuardScene& s) { s.velocity_age_us = -1; },
       InputField::velocity},
      {"VelocityNan", [](GuardScene& s) { s.v.y = nan_value; }, InputField::velocity},
      {"VelocityInfinite", [](GuardScene& s) { s.v.x = inf_value; }, InputField::velocity},
      {"VelocityOutOfRange", [](GuardScene& s) { s.v.x = 100.001; }, InputField::velocity},
      {"VelocityFarOutOfRange", [](GuardScene& s) { s.v.x = -1e300; }, InputField::velocity},
      {"BatteryTooOld", [](GuardScene& s) { s.battery_age_us = 5'000'001; }, InputField::battery},
      {"BatteryFromTheFuture", [](GuardScene& s) { s.battery_age_us = -1; }, InputField::battery},
      {"BatteryNan", [](GuardScene& s) { s.battery = nan_value; }, InputField::battery},
      {"BatteryInfinite", [](GuardScene& s) { s.battery = inf_value; }, InputField::battery},
      {"BatteryOutOfRange", [](GuardScene& s) { s.battery = 2.1; }, InputField::battery},
      {"BatteryBelowItsRange", [](GuardScene& s) { s.battery = -1.1; }, InputField::battery},
      {"OtherTooOld", [](GuardScene& s) { s.heard_age_us = 300'001; }, InputField::other_robot},
      {"OtherFromTheFuture", [](GuardScene& s) { s.heard_age_us = -1; }, InputField::other_robot},
      {"OtherNan", [](GuardScene& s) { s.other[2].x = nan_value; }, InputField::other_robot},
      {"OtherVelocityOutOfRange", [](GuardScene& s) { s.other_v[1].x = 200; },
       InputField::other_robot},
      {"PlanNan",
       [](GuardScene& s) {
         s.plan = path({{5, nan_value}});
       },
       InputField::plan},
      {"PlanIndexBeyondItsEnd",
       [](GuardScene& s) {
         s.plan = path({{6, 5}}, 2);
       },
       InputField::plan},
      {"PlanIndexOfAnotherCentury",
       [](GuardScene& s) {
         s.plan = path({{6, 5}}, std::size_t{1} << 32);
       },
       InputField::plan},
  };
  return all;
}

INSTANTIATE_TEST_SUITE_P(Rule6, Input, ::testing::ValuesIn(faults()),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(Rule6, AMissingPositionIsUnknown) {
  probe::Guard guard(0);
  const DecisionRecord& r = guard.step(10'000'000);
  EXPECT_FALSE(r.advanced());
  EXPECT_EQ(r.reason, Reason::input);
}

TEST(Rule6, AMemberOfTheFleetThatWasNeverHeardOfIsUnknown) {
  // Named fleets are closed: silence is not absence.
  GuardScene s;
  s.heard[2] = false;
  const DecisionRecord& r = s.tick();
  EXPECT_FALSE(r.advanced());
  EXPECT_EQ(r.reason, Reason::input);
  EXPECT_EQ(r.reason_input, InputField::other_robot);
  EXPECT_EQ(r.reason_other, 2);
}

TEST(Rule6, ExactlyTheLargestAgeIsGoodEnough) {
  GuardScene s;
  s.position_age_us = 200'000;
  s.velocity_age_us = 150'000;
  s.battery_age_us = 5'000'000;
  s.heard_age_us = 300'000;
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(s.tick().advanced());
}

TEST(Rule6, AStampThatGoesBackwardsIsUnknown) {
  for (TimeUs GuardScene::*age : {&GuardScene::position_age_us, &GuardScene::velocity_age_us,
                                  &GuardScene::battery_age_us, &GuardScene::heard_age_us}) {
    GuardScene s;
    ASSERT_TRUE(s.tick().advanced());
    s.*age = 100'001;
    const DecisionRecord& r = s.tick();
    EXPECT_FALSE(r.advanced());
    EXPECT_EQ(r.reason, Reason::input);
  }
}

TEST(Rule6, TheSameSampleAgainIsNoFault) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.position_age_us = s.velocity_age_us = s.battery_age_us = s.heard_age_us = 100'000;
  EXPECT_TRUE(s.tick().advanced());
}

TEST(Rule6, OneStampFromTheFutureDoesNotShutOutTheSamplesAfterIt) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.position_age_us = -3'600'000'000;
  ASSERT_FALSE(s.tick().advanced());
  s.position_age_us = 0;
  EXPECT_LT(s.ticks_to_advanced(), 20);
}

TEST(Rule5, ARecoveryEndsWhenTheInputIsBack) {
  for (const Fault& fault : faults()) {
    GuardScene s;
    const Path none;
    s.tick();
    fault.spoil(s);
    ASSERT_FALSE(s.tick().advanced());
    GuardScene good;
    s.at = good.at, s.v = good.v, s.battery = good.battery, s.plan = none;
    s.position_age_us = s.velocity_age_us = s.battery_age_us = s.heard_age_us = 0;
    for (int j = 1; j < 3; ++j) s.other[j] = good.other[j], s.other_v[j] = good.other_v[j];
    EXPECT_LT(s.ticks_to_advanced(), 20) << fault.name;
  }
}

TEST(Rule13, AFinitePositionBeyondTheExtentIsOutside) {
  for (const double x : {600'000.0, -1e12, 1e300}) {
    GuardScene s;
    ASSERT_TRUE(s.tick().advanced());
    s.at.x = x;
    const DecisionRecord& r = s.tick();
    EXPECT_EQ(r.mode, fence + 1);
    EXPECT_EQ(r.reason, Reason::violated);
  }
}

TEST(Rule6, ARobotThatIsNobodyOfTheFleetIsNeverAdmissible) {
  GuardScene s(7);
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(s.tick().advanced());
}

}  // namespace
}  // namespace rtac::kernel_test
