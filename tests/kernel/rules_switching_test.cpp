// When control is taken and when it is given back.
#include <gtest/gtest.h>

#include <random>

#include "tests/kernel/scenes.h"

namespace rtac::kernel_test {
namespace {

// 50 ms, in ticks of 100 ms.
constexpr int dwell_ticks = 1;

TEST(Rule10, AtStartTheAdvancedControllerDrivesWhenEveryReturnSetHolds) {
  GuardScene s;
  EXPECT_TRUE(s.tick().advanced());
}

TEST(Rule10, AtStartAMonitorOutsideItsReturnSetIsEngaged) {
  // Any control keeps the fence from 50 cm, but not with the longer horizon.
  GuardScene s;
  s.at = {0.5, 5};
  const DecisionRecord& r = s.tick();
  EXPECT_EQ(r.mode, fence + 1);
  EXPECT_EQ(r.reason, Reason::starting);
  EXPECT_FALSE(r.monitors[separation].engaged);
}

TEST(Rule9, AFailingLookAheadEngagesBeforeAnythingIsViolated) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.at = {1.0, 5};
  s.v = {-1, 0};
  const DecisionRecord& r = s.tick();
  EXPECT_EQ(r.mode, fence + 1);
  EXPECT_EQ(r.deciding_monitor, fence);
  EXPECT_EQ(r.reason, Reason::margin);
  EXPECT_EQ(r.monitors[fence].now, Verdict::is_true);
  EXPECT_LT(r.monitors[fence].margin, 0);
}

TEST(Rule9, DrivingAwayFromTheWallIsAdmissibleWhereDrivingAtItIsNot) {
  // The capsule knows the direction of 0.6 m/s, the disc does not.
  for (const double v : {0.6, -0.6}) {
    GuardScene s;
    ASSERT_TRUE(s.tick().advanced());
    s.at = {0.9, 5};
    s.v = {v, 0};
    EXPECT_EQ(s.tick().monitors[fence].ahead, v > 0 ? Verdict::is_true : Verdict::is_false);
  }
}

TEST(Rule9, AnOlderSampleReachesFurther) {
  // The horizon starts at the stamp of the sample, not at the decision.
  for (const TimeUs age_us : {TimeUs{0}, TimeUs{90'000}}) {
    GuardScene s;
    s.position_age_us = s.velocity_age_us = age_us;
    ASSERT_TRUE(s.tick().advanced());
    s.at = {1.05, 5};
    s.v = {-1, 0};
    EXPECT_EQ(s.tick().advanced(), age_us == 0);
  }
}

TEST(Rule11, OutsideIsViolated) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.at = {-1, 5};
  const DecisionRecord& r = s.tick();
  EXPECT_EQ(r.mode, fence + 1);
  EXPECT_EQ(r.reason, Reason::violated);
  EXPECT_EQ(r.monitors[fence].now, Verdict::is_false);
}

TEST(Rule4, UndecidedWithinTheDeclaredErrorsHasItsOwnReason) {
  // The body has 5 cm to spare exactly on the boundary of the property; the position errs by 1 cm.
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.at = {0.15, 5};
  const DecisionRecord& r = s.tick();
  EXPECT_EQ(r.mode, fence + 1);
  EXPECT_EQ(r.monitors[fence].now, Verdict::is_unknown);
  EXPECT_EQ(r.reason, Reason::within_error);
}

TEST(Rule10, TheHighestPriorityThatIsEngagedDrives) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.at = {0.3, 5};
  s.battery = 0.03;
  const DecisionRecord& r = s.tick();
  EXPECT_EQ(r.mode, fence + 1);
  EXPECT_TRUE(r.monitors[charge].engaged);
}

TEST(Rule10, AHigherMonitorPreempts) {
  GuardScene s;
  s.battery = 0.03;
  ASSERT_EQ(s.tick().mode, charge + 1);
  s.at = {0.12, 5};
  ASSERT_EQ(s.tick().mode, fence + 1);
  s.other[1] = {0.5, 5};
  const DecisionRecord& r = s.tick();
  EXPECT_EQ(r.mode, separation + 1);
  EXPECT_EQ(r.previous_mode, fence + 1);
  EXPECT_EQ(r.reason_other, 1);
}

// At 20 cm the fence cannot be looked ahead any more, under no motion; the way to the dock is shown
// to keep it all the same.
TEST(Rule10, ARecoveryThatIsShownToKeepAHigherMonitorDrivesOn) {
  GuardScene s;
  s.battery = 0.03;
  ASSERT_EQ(s.tick().mode, charge + 1);
  s.at = {0.2, 5};
  for (int i = 0; i < 20; ++i) {
    const DecisionRecord& r = s.tick();
    ASSERT_EQ(r.mode, charge + 1);
    ASSERT_TRUE(r.monitors[fence].engaged);
  }
  // what it has recorded is looked after as soon as the charge suffices, here on its way
  s.at = {1.5, 5};
  s.battery = 0.95;
  for (int i = 0; i < dwell_ticks; ++i) ASSERT_EQ(s.tick().mode, charge + 1);
  const DecisionRecord& r = s.tick();
  EXPECT_FALSE(r.monitors[charge].engaged);
  EXPECT_EQ(r.mode, fence + 1);  // its `return when` takes a second
}

TEST(Rule10, ARecoveryDoesNotDriveOnWhereAHigherMonitorIsFalse) {
  GuardScene s;
  s.battery = 0.03;
  s.tick();
  s.at = {0.2, 5};
  ASSERT_EQ(s.tick().mode, charge + 1);
  s.at = {0.12, 5};
  const DecisionRecord& r = s.tick();
  EXPECT_EQ(r.mode, fence + 1);
  EXPECT_EQ(r.reason, Reason::violated);
}

TEST(Rule10, ARecoveryDoesNotDriveOnAfterAMissedTick) {
  constexpr int either = 0, low = 1;
  for (const TimeUs step_us : {TimeUs{50'000}, TimeUs{200'000}, TimeUs{-1'000}}) {
    KiteScene s;
    s.battery = 0.2;
    for (int i = 0; i < 3; ++i) ASSERT_EQ(s.tick().mode, low + 1);
    s.now_us += step_us - 50'000;
    EXPECT_EQ(s.tick().mode, step_us == 50'000 ? low + 1 : either + 1) << step_us;
  }
}

TEST(Rule10, ARecoveryDoesNotDriveOnThatHasNotDriven) {
  // Both engage at once.
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.at = {0.2, 5};
  s.battery = 0.03;
  EXPECT_EQ(s.tick().mode, fence + 1);
}

// Others come near of themselves.
TEST(Rule10, ARecoveryDoesNotDriveOnBeforeOthers) {
  GuardScene s;
  s.battery = 0.03;
  ASSERT_EQ(s.tick().mode, charge + 1);
  s.other[1] = {5.5, 5};
  EXPECT_EQ(s.tick().mode, separation + 1);
}

TEST(Rule10, ALowerMonitorEngagesWhileAHigherOneDrives) {
  GuardScene s;
  s.at = {0.5, 5};
  ASSERT_EQ(s.tick().mode, fence + 1);
  s.battery = 0.03;
  const DecisionRecord& r = s.tick();
  EXPECT_EQ(r.mode, fence + 1);
  EXPECT_TRUE(r.monitors[charge].engaged);
}

TEST(Rule10, WhileARecoveryDrivesOthersAreJudgedUnderItsOwnMotion) {
  // At 35 cm from the wall any control fails the fence; the slow way to the dock does not.
  GuardScene any;
  ASSERT_TRUE(any.tick().advanced());
  any.at = {5, 0.35};
  EXPECT_TRUE(any.tick().monitors[fence].engaged);
  GuardScene slow;
  slow.battery = 0.03;
  for (int i = 0; i < 3; ++i) ASSERT_EQ(slow.tick().mode, charge + 1);
  slow.at = {5, 0.35};
  const DecisionRecord& r = slow.tick();
  EXPECT_EQ(r.mode, charge + 1);
  EXPECT_FALSE(r.monitors[fence].engaged);
}

TEST(Rule9, ASampleFromBeforeTheTakeoverMayShowTheDriverBefore) {
  // It was taken while any control drove: the limits of the recovery do not bound what came since.
  GuardScene s;
  s.position_age_us = s.velocity_age_us = 100'000;
  ASSERT_TRUE(s.tick().advanced());
  s.battery = 0.03;
  ASSERT_EQ(s.tick().mode, charge + 1);
  s.at = {5, 0.35};
  EXPECT_TRUE(s.tick().monitors[fence].engaged);
}

TEST(Rule10, ReturnTakesTheAuthorsConditionForItsTimeAndTheDwell) {
  // `return when ... for 1 s` is ten ticks after the first good one; then two in a row give back.
  GuardScene s;
  s.at = {0.3, 5};
  ASSERT_EQ(s.tick().mode, fence + 1);
  s.at = {5, 5};
  EXPECT_EQ(s.ticks_to_advanced(), 11 + dwell_ticks);
}

TEST(Rule10, WithoutAnAuthorsConditionTheDwellAloneCounts) {
  GuardScene s;
  s.other[1] = {5.5, 5};
  ASSERT_EQ(s.tick().mode, separation + 1);
  s.other[1] = {17, 2};
  EXPECT_EQ(s.ticks_to_advanced(), 1 + dwell_ticks);
}

TEST(Rule10, TheAuthorsConditionAloneDoesNotGiveBack) {
  // 40 cm of clearance satisfy `return when`, and are far too little for the longer horizon.
  GuardScene s;
  s.at = {0.5, 5};
  ASSERT_EQ(s.tick().mode, fence + 1);
  for (int i = 0; i < 60; ++i) ASSERT_EQ(s.tick().mode, fence + 1);
  EXPECT_EQ(s.tick().reason, Reason::returning);
}

TEST(Rule10, TheReturnSetMustHoldForTheDwell) {
  // The author's condition has held for long when the derived one begins to, in whatever tick.
  for (const int before : {30, 31, 32}) {
    GuardScene s;
    s.at = {0.5, 5};
    for (int i = 0; i < before; ++i) ASSERT_EQ(s.tick().mode, fence + 1);
    s.at = {5, 5};
    EXPECT_EQ(s.ticks_to_advanced(), 1 + dwell_ticks) << before;
  }
}

TEST(Rule10, OneBadTickStartsTheReturnAnew) {
  GuardScene s;
  s.at = {0.3, 5};
  s.tick();
  s.at = {5, 5};
  for (int i = 0; i < 10; ++i) ASSERT_EQ(s.tick().mode, fence + 1);
  s.at = {0.3, 5};
  ASSERT_EQ(s.tick().mode, fence + 1);
  s.at = {5, 5};
  EXPECT_EQ(s.ticks_to_advanced(), 11 + dwell_ticks);
}

TEST(Rule10, AReturnConditionOfAMonitorThatNeverEngagedPlaysNoPart) {
  // The charge is below the 90 % at which its recovery would give back.
  GuardScene s;
  s.battery = 0.6;
  s.plan = path({{13, 5}});  // through the pool
  ASSERT_EQ(s.tick().mode, fence + 1);
  s.plan = {};
  EXPECT_EQ(s.ticks_to_advanced(), 10 + dwell_ticks);
}

TEST(Rule10, AReturnConditionOfAMonitorThatEngagedCounts) {
  GuardScene s;
  s.battery = 0.03;
  ASSERT_EQ(s.tick().mode, charge + 1);
  s.battery = 0.6;
  EXPECT_EQ(s.ticks_to_advanced(), 100);
  s.battery = 0.95;
  EXPECT_EQ(s.ticks_to_advanced(), 1 + dwell_ticks);
}

TEST(Rule10, NothingIsGivenBackWhileAnotherReturnSetDoesNotHold) {
  GuardScene s;
  // Any control keeps the other cart away, but not with the longer horizon.
  s.at = {0.3, 5};
  ASSERT_EQ(s.tick().mode, fence + 1);
  s.at = {5, 5};
  s.other[1] = {6.0, 5};
  EXPECT_EQ(s.ticks_to_advanced(), 100);
}

// Switches in a minute at a place `x` from the wall, with noise at its bound.
int switches_at(double x) {
  GuardScene s;
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> noise(-0.01, 0.01);
  s.tick();
  int switches = 0, mode = 0;
  for (int i = 0; i < 600; ++i) {
    s.at = {x + noise(engine), 5};
    s.v = {0.7 * noise(engine), 0.7 * noise(engine)};
    const int now = s.tick().mode;
    switches += now != mode;
    mode = now;
  }
  return switches;
}

TEST(Rule10, NoPlaceFlapsUnderNoise) {
  bool stays = false, leaves = false;
  for (double x = 0.3; x < 1.6; x += 0.01) {
    const int switches = switches_at(x);
    ASSERT_LE(switches, 2) << x;
    stays = stays || switches == 0;
    leaves = leaves || switches == 1;
  }
  EXPECT_TRUE(stays);
  EXPECT_TRUE(leaves);
}

TEST(Rule1, AMissedTickCountsAsUnknown) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.now_us += GuardScene::period_us;
  const DecisionRecord& r = s.tick();
  EXPECT_FALSE(r.advanced());
  EXPECT_EQ(r.reason, Reason::input);
  EXPECT_EQ(r.reason_input, InputField::clock);
}

TEST(Rule1, AMissedTickResetsWhatMustHoldWithoutAGap) {
  GuardScene s;
  s.at = {0.3, 5};
  s.tick();
  s.at = {5, 5};
  for (int i = 0; i < 9; ++i) ASSERT_FALSE(s.tick().advanced());
  s.now_us += 2 * GuardScene::period_us;
  EXPECT_EQ(s.ticks_to_advanced(), 11 + dwell_ticks);
}

// `not (battery < 60 % for 1 s)`: in between nobody looked, so that it may well have lasted.
TEST(Rule1, WhatIsNotFalseMayHaveLastedThroughMissedTicks) {
  constexpr TimeUs tick_us = 50'000;
  struct Gaps {
    int count;
    TimeUs us;
  };
  for (const Gaps gaps : {Gaps{0, 0}, Gaps{5, 4 * tick_us}, Gaps{1, 40 * tick_us}}) {
    KiteScene s;
    s.at = {4, 0.05};
    s.battery = 0.55;
    ASSERT_EQ(s.tick().mode, 1);
    s.at = {4, 5};
    bool returned = false;
    for (int i = 0; i < 15; ++i) {
      if (i < gaps.count) s.now_us += gaps.us;
      returned = s.tick().advanced() || returned;
    }
    EXPECT_EQ(returned, gaps.count == 0) << gaps.us;
  }
}

TEST(Rule1, ATimerThatJittersMissesNothing) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  const TimeUs start_us = s.now_us;
  for (int i = 0; i < 50; ++i) {
    s.now_us = start_us + i * GuardScene::period_us + (i % 2 == 0 ? -40'000 : 40'000);
    ASSERT_TRUE(s.tick().advanced());
  }
}

// Two steps almost two periods apart may fall on neighbouring ticks; what counts is whether the
// look-ahead covers the time in which nobody decided.
TEST(Rule1, AGapThatTheLookAheadDoesNotCoverIsAMissedTick) {
  probe::Hover hover(0);
  Observation o;
  bool advanced = false;
  for (const TimeUs now_us : {1'000'000, 1'025'100, 1'124'900}) {
    o.now_us = now_us;
    o.position = {{10, 5}, now_us};
    o.velocity = {{0, 0}, now_us};
    advanced = hover.step(o, false, false).advanced();
    if (now_us < 1'100'000) {
      ASSERT_TRUE(advanced);
    }
  }
  EXPECT_FALSE(advanced);
}

// The latency passes after the decision: it is no time in which a step may be late.
TEST(Rule9, TheLatencyIsNoRoomForLateSteps) {
  // `Leaf` looks 50 ms ahead, with 10 ms for jitter and a latency of 20 ms
  for (const TimeUs gap_us : {60'000, 60'001, 70'000}) {
    probe::Drift drift(0);
    Observation o;
    bool advanced = false;
    for (const TimeUs now_us : {TimeUs{1'000'000}, 1'000'000 + gap_us}) {
      o.now_us = now_us;
      o.position = {{10, 5}, now_us};
      o.velocity = {{0, 0}, now_us};
      advanced = drift.step(o, false, false).advanced();
    }
    EXPECT_EQ(advanced, gap_us == 60'000) << gap_us;
  }
}

TEST(Rule1, StepsWithinATickDoNotSpeedUpTheReturn) {
  GuardScene s;
  s.other[1] = {5.5, 5};
  s.tick();
  s.other[1] = {17, 2};
  int n = 0;
  while (!s.tick().advanced() && n < 1'000) {
    s.now_us -= GuardScene::period_us - 10'000;
    ++n;
  }
  EXPECT_GE(n, 5);
}

TEST(Rule6, AClockThatGoesBackwardsIsUnknown) {
  GuardScene s;
  s.tick();
  ASSERT_TRUE(s.tick().advanced());
  s.now_us -= 3 * GuardScene::period_us;
  const DecisionRecord& r = s.tick();
  EXPECT_FALSE(r.advanced());
  EXPECT_EQ(r.reason, Reason::input);
  EXPECT_EQ(r.reason_input, InputField::clock);
}

TEST(Rule6, AClockThatGoesBackwardsIsUnknownToMonitorsWithoutMeasurementsToo) {
  // `posts` judges way-points only, and there are none: nothing but the clock can fail it.
  probe::Hover hover(0);
  Observation o;
  for (const TimeUs now_us : {1'000'000, 1'050'000}) {
    o.now_us = now_us;
    o.position = {{10, 5}, now_us};
    o.velocity = {{0, 0}, now_us};
    ASSERT_TRUE(hover.step(o, false, false).advanced());
  }
  o.now_us = 1'000'000;
  EXPECT_TRUE(hover.step(o, false, false).monitors[1].engaged);
}

TEST(Surrender, TheFirstRecoveryHoldsTheRobotUntilControlIsTakenUpAgain) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  const DecisionRecord& r = s.tick(false, true);
  EXPECT_EQ(r.mode, 1);
  EXPECT_EQ(r.reason, Reason::surrendered);
  EXPECT_FALSE(r.monitors[separation].engaged);
  EXPECT_TRUE(s.tick().advanced());
}

}  // namespace
}  // namespace rtac::kernel_test
