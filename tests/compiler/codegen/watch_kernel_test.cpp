// Runs generated code of monitors without a robot: the golden case `plain_types`, compiled as it is
// kept. Period 20 ms; gear, wanted, cells and errors must arrive every tick, points hold, the
// charge holds for 1 s; the parameter `gap` only grows.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "spec.h"

namespace test_stand {
namespace {

constexpr rtac::TimeUs period_us = 20'000;

class Stand : public ::testing::Test {
 protected:
  // Everything is well; each test spoils one thing.
  void give(rtac::TimeUs now_us) {
    monitors_.gear(Gear::drive, now_us).wanted(Gear::drive, now_us);
    monitors_.wheel({rtac::Length(0), rtac::Length(0)}, now_us);
    monitors_.target({rtac::Length(3), rtac::Length(4)}, now_us);
    monitors_.cells({300, 310, 320}, now_us);
    monitors_.errors(1, now_us);
    monitors_.charge(rtac::Charge(0.5), now_us);
  }
  rtac::Finding step(rtac::TimeUs now_us, Monitors::Index monitor) {
    return monitors_.step(now_us)[monitor];
  }
  Monitors monitors_;
};

TEST_F(Stand, MarginsAreInTheUnitOfTheAtomThatDecides) {
  give(0);
  const auto& found = monitors_.step(0);
  EXPECT_EQ(found[Monitors::apart_index].verdict, rtac::Verdict::is_true);
  EXPECT_DOUBLE_EQ(found[Monitors::apart_index].margin, 4.8);
  EXPECT_STREQ(found[Monitors::apart_index].unit, "m");
  EXPECT_DOUBLE_EQ(found[Monitors::cool_index].margin, 10);
  EXPECT_STREQ(found[Monitors::cool_index].unit, "K");
  EXPECT_TRUE(std::isinf(found[Monitors::shifted_index].margin));
}

// Rule 13.1: the double next to a limit is on its other side, however near.
TEST_F(Stand, LimitsAreExactForEveryDouble) {
  const auto charged = [&](double charge, rtac::TimeUs now_us) {
    give(now_us);
    monitors_.charge(rtac::Charge(charge), now_us);
    return step(now_us, Monitors::alive_index).verdict;
  };
  // the double nearest to 1 % is more than that
  EXPECT_EQ(charged(0.01, 0), rtac::Verdict::is_true);
  EXPECT_EQ(charged(std::nextafter(0.01, 0), period_us), rtac::Verdict::is_false);
  const auto heated = [&](double kelvin, rtac::TimeUs now_us) {
    give(now_us);
    monitors_.cells({300, 310, kelvin}, now_us);
    return step(now_us, Monitors::cool_index).verdict;
  };
  EXPECT_EQ(heated(330, 2 * period_us), rtac::Verdict::is_true);
  EXPECT_EQ(heated(std::nextafter(330.0, 400.0), 3 * period_us), rtac::Verdict::is_false);
}

TEST_F(Stand, WhatMustArriveEveryTickIsMissedWhenItDoesNot) {
  give(0);
  monitors_.step(0);
  give(period_us);
  monitors_.errors(1, 0);
  const rtac::Finding clean = step(period_us, Monitors::clean_index);
  EXPECT_EQ(clean.verdict, rtac::Verdict::is_unknown);
  EXPECT_EQ(clean.reason, rtac::Reason::input);
  EXPECT_STREQ(clean.input, "errors");
}

TEST_F(Stand, WhatHoldsIsGoodForEver) {
  give(0);
  monitors_.step(0);
  EXPECT_EQ(step(3600 * 1'000'000LL, Monitors::apart_index).verdict, rtac::Verdict::is_true);
}

TEST_F(Stand, AStampFromTheFutureIsUnknown) {
  give(0);
  monitors_.errors(1, 1);                                   // every tick
  monitors_.target({rtac::Length(3), rtac::Length(4)}, 1);  // held
  const auto findings = monitors_.step(0);
  EXPECT_EQ(findings[Monitors::clean_index].verdict, rtac::Verdict::is_unknown);
  EXPECT_EQ(findings[Monitors::apart_index].verdict, rtac::Verdict::is_unknown);
}

TEST_F(Stand, AStampThatGoesBackwardsIsUnknown) {
  give(period_us);
  monitors_.step(period_us);
  give(2 * period_us);
  monitors_.target({rtac::Length(3), rtac::Length(4)}, 0);
  EXPECT_EQ(step(2 * period_us, Monitors::apart_index).verdict, rtac::Verdict::is_unknown);
}

TEST_F(Stand, AnAgeIsThatOfTheStamp) {
  give(1'000'000);
  monitors_.charge(rtac::Charge(0.5), 500'000);
  EXPECT_EQ(step(1'000'000, Monitors::fed_index).verdict, rtac::Verdict::is_true);
  EXPECT_EQ(step(1'020'000, Monitors::fed_index).verdict, rtac::Verdict::is_false);
}

TEST_F(Stand, WhatIsOutOfRangeOrNotFiniteIsUnknown) {
  for (const double bad : {350.001, 249.999, std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()}) {
    monitors_.reset();
    give(0);
    monitors_.cells({300, bad, 320}, 0);
    EXPECT_EQ(step(0, Monitors::cool_index).verdict, rtac::Verdict::is_unknown) << bad;
  }
  monitors_.reset();
  give(0);
  monitors_.cells({300, 330.0000001, 320}, 0);
  EXPECT_NE(step(0, Monitors::cool_index).verdict, rtac::Verdict::is_true);
}

// Nothing has been measured, whatever the numbers of the struct are.
TEST_F(Stand, WhatHoldsIsUnknownUntilItHasArrived) {
  EXPECT_EQ(step(0, Monitors::apart_index).verdict, rtac::Verdict::is_unknown);
  give(period_us);
  EXPECT_EQ(step(period_us, Monitors::apart_index).verdict, rtac::Verdict::is_true);
}

TEST_F(Stand, AParameterOnlyTightens) {
  give(0);
  monitors_.gap(0.4);
  EXPECT_DOUBLE_EQ(step(0, Monitors::apart_index).margin, 4.6);
  monitors_.gap(0.1);
  give(period_us);
  EXPECT_DOUBLE_EQ(step(period_us, Monitors::apart_index).margin, 4.6);
  monitors_.gap(9);  // beyond its range
  give(2 * period_us);
  EXPECT_DOUBLE_EQ(step(2 * period_us, Monitors::apart_index).margin, 4.6);
}

// What was asked for between two steps is not lost to what came after it.
TEST_F(Stand, AParameterIsNotLoosenedBeforeItWasSeen) {
  give(0);
  monitors_.gap(0.4);
  monitors_.gap(0.3);
  EXPECT_DOUBLE_EQ(step(0, Monitors::apart_index).margin, 4.6);
}

// The kernel keeps to the rule by itself, whoever fills its input.
TEST(StandKernel, AParameterOnlyTightens) {
  test_stand_monitors_in in{};
  in.wheel = {0, 1, 0, 0, 0};
  in.target = {0, 1, 0, 3000, 4000};
  test_stand_monitors_state state;
  test_stand_monitors_init(&state);
  rtac::TimeUs now_us = 0;
  const auto margin_mm = [&](std::int64_t gap_mm) {
    in.gap = gap_mm;
    test_stand_monitors_out out;
    test_stand_monitors_step(&state, &in, now_us += period_us, &out);
    return out.monitors[TEST_STAND_MONITORS_APART].lo / 2000;  // millionths of 0.5 m
  };
  EXPECT_EQ(margin_mm(200), 4800);
  EXPECT_EQ(margin_mm(400), 4600);
  EXPECT_EQ(margin_mm(300), 4600);  // looser
  EXPECT_EQ(margin_mm(501), 4600);  // beyond its range
  EXPECT_EQ(margin_mm(500), 4500);
}

TEST_F(Stand, ASecondStepWithinATickTellsNothing) {
  give(0);
  monitors_.step(0);
  const rtac::Finding again = step(1, Monitors::clean_index);
  EXPECT_EQ(again.verdict, rtac::Verdict::is_unknown);
  EXPECT_STREQ(again.input, "clock");
}

TEST_F(Stand, WhatIsOlderThanItsLimitIsUnknown) {
  give(1'000'000);
  monitors_.charge(rtac::Charge(0.5), -1);
  EXPECT_EQ(step(1'000'000, Monitors::alive_index).verdict, rtac::Verdict::is_unknown);
}

// The root of 2 lies between 1.414 and 1.415: the lower end is a true bound.
TEST_F(Stand, ARootIsRoundedOutward) {
  give(0);
  monitors_.target({rtac::Length(1), rtac::Length(1)}, 0);
  EXPECT_DOUBLE_EQ(step(0, Monitors::apart_index).margin, 1.214);
}

TEST_F(Stand, ChoicesAreComparedByTheirValue) {
  give(0);
  monitors_.wanted(Gear::reverse, 0);
  EXPECT_EQ(step(0, Monitors::shifted_index).verdict, rtac::Verdict::is_false);
  give(period_us);
  monitors_.gear(Gear::park, period_us);
  EXPECT_EQ(step(period_us, Monitors::shifted_index).verdict, rtac::Verdict::is_true);
}

TEST_F(Stand, WhatMissesByLittleIsFalse) {
  give(0);
  monitors_.errors(4, 0);
  const rtac::Finding clean = step(0, Monitors::clean_index);
  EXPECT_EQ(clean.verdict, rtac::Verdict::is_false);
  EXPECT_EQ(clean.reason, rtac::Reason::margin);
  EXPECT_DOUBLE_EQ(clean.margin, -1);
}

TEST_F(Stand, VerdictsAreThoseOfTheFindings) {
  give(0);
  Monitors other = monitors_;
  const auto& verdicts = other.verdicts(0);
  const auto& found = monitors_.step(0);
  for (std::size_t k = 0; k < Monitors::count; ++k) EXPECT_EQ(verdicts[k], found[k].verdict);
}

}  // namespace
}  // namespace test_stand
