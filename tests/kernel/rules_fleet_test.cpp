// Two robots and fleets (theory): the gate of moving recoveries, HELD leases, and whose promises
// may be relied upon.
#include <gtest/gtest.h>

#include "tests/kernel/kernel_probe.h"
#include "tests/kernel/scenes.h"

namespace rtac::kernel_test {
namespace {

// A recovery drives because the advanced side gave up; nothing fails.
const DecisionRecord& surrendered(GuardScene& s, bool holding = false) {
  return s.tick(holding, true);
}

TEST(Gate, IsFreeFarFromEverybody) {
  GuardScene s;
  s.tick();
  surrendered(s);
  EXPECT_EQ(surrendered(s).gate, Gate::free);
}

TEST(Gate, HoldsNearARobotThatMayMove) {
  GuardScene s;
  s.tick();
  s.other[1] = {5.6, 5};
  surrendered(s);
  EXPECT_EQ(surrendered(s).gate, Gate::hold);
}

TEST(Gate, LetsTheRobotGoAwayFromOneThatStays) {
  GuardScene s;
  s.tick();
  s.other[1] = {5.42, 5};
  s.held[1] = true;
  surrendered(s);
  EXPECT_EQ(surrendered(s).gate, Gate::away_only);
}

TEST(Gate, ASecondRobotThatMayMoveHoldsAllTheSame) {
  GuardScene s;
  s.tick();
  s.other[1] = {5.42, 5};
  s.held[1] = true;
  s.other[2] = {5, 5.5};
  surrendered(s);
  EXPECT_EQ(surrendered(s).gate, Gate::hold);
}

TEST(Gate, HoldsWhenARobotIsUnknown) {
  GuardScene s;
  s.tick();
  s.heard_age_us = 300'001;
  EXPECT_EQ(surrendered(s).gate, Gate::hold);
}

TEST(Gate, RightAfterATakeoverAnyControlIsAssumedOfTheRobotItself) {
  // What it did last is not yet in the samples: first 0.9 m are too near, then they are not.
  GuardScene s;
  s.tick();
  s.other[1] = {5.9, 5};
  EXPECT_EQ(surrendered(s).gate, Gate::hold);
  s.other[1] = {5.9, 5};
  EXPECT_EQ(surrendered(s).gate, Gate::free);
}

TEST(Gate, AClockThatGoesBackwardsDoesNotDateTheTakeoverBack) {
  // The next sample is older than the takeover, however early the clock said that this was.
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.now_us -= 4 * GuardScene::period_us;
  ASSERT_EQ(s.tick().mode, separation + 1);
  s.now_us += 3 * GuardScene::period_us;
  s.position_age_us = s.velocity_age_us = GuardScene::period_us;
  s.other[1] = {5.9, 5};
  EXPECT_EQ(s.tick().gate, Gate::hold);
  EXPECT_EQ(s.tick().gate, Gate::free);
}

TEST(Lease, IsRenewedWhileTheRecoveryHoldsAndNotWhenItLeaves) {
  GuardScene s;
  s.other[1] = {5.5, 5};
  ASSERT_EQ(s.tick().lease_end_us, never_us);
  TimeUs end_us = 0;
  for (int i = 0; i < 5; ++i) {
    const TimeUs now_us = s.now_us;
    end_us = s.tick(true).lease_end_us;
    EXPECT_EQ(end_us, now_us + 1'000'000);
  }
  EXPECT_EQ(s.tick(false).lease_end_us, end_us);
}

TEST(Lease, IsNotShortenedByAClockThatGoesBackwards) {
  GuardScene s;
  s.other[1] = {5.5, 5};
  s.tick();
  const TimeUs end_us = s.tick(true).lease_end_us;
  ASSERT_NE(end_us, never_us);
  s.now_us -= 500'000;
  EXPECT_GE(s.tick(true).lease_end_us, end_us);
}

TEST(Lease, IsNotGivenByTheAdvancedController) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  const DecisionRecord& r = s.tick(true);
  EXPECT_TRUE(r.advanced());
  EXPECT_EQ(r.lease_end_us, never_us);
}

TEST(Lease, IsNotGivenInTheTickOfATakeover) {
  // `holding` speaks of the recovery that drove until now.
  GuardScene s;
  s.battery = 0.03;
  ASSERT_EQ(s.tick().mode, charge + 1);
  s.at = {0.12, 5};
  EXPECT_EQ(s.tick(true).lease_end_us, never_us);
}

TEST(Lease, BindsUntilItsEnd) {
  // The reason is gone, control could be given back; but others rely on the promise.
  GuardScene s;
  s.tick();
  surrendered(s);
  const TimeUs end_us = surrendered(s, true).lease_end_us;
  ASSERT_NE(end_us, never_us);
  for (int i = 0; i < 30; ++i) {
    const TimeUs now_us = s.now_us;
    const DecisionRecord& r = s.tick();
    ASSERT_EQ(r.advanced(), now_us >= end_us);
    if (r.advanced()) break;
    ASSERT_EQ(r.gate, Gate::hold);
  }
}

TEST(Lease, BindsAHigherRecoveryToo) {
  GuardScene s;
  s.battery = 0.03;
  s.tick();
  ASSERT_NE(s.tick(true).lease_end_us, never_us);
  s.at = {0.12, 5};
  const DecisionRecord& r = s.tick();
  ASSERT_EQ(r.mode, fence + 1);
  EXPECT_EQ(r.gate, Gate::hold);
}

// Distances that suffice from a cart that stays, and not from one that may move: for starting, with
// the longer horizon, and for driving on. Carts are ordered by index: 0 goes first.
constexpr double start_m = 1.1, near_m = 0.9;

TEST(Promise, OfARobotThatStaysIsReliedUpon) {
  GuardScene s(1);
  s.other[0] = {5 + start_m, 5};
  EXPECT_FALSE(GuardScene(s).tick().advanced());
  s.held[0] = true;
  EXPECT_TRUE(s.tick().advanced());
}

TEST(Promise, OfAHigherRobotThatWaitsToGoOnIsNotReliedUponForReturning) {
  GuardScene s(1);
  s.other[0] = {5 + start_m, 5};
  s.held[0] = s.claims[0] = true;
  EXPECT_FALSE(s.tick().advanced());
}

TEST(Promise, OfAHigherRobotThatWaitsToGoOnIsReliedUponWhileDriving) {
  GuardScene s(1);
  ASSERT_TRUE(s.tick().advanced());
  s.other[0] = {5 + near_m, 5};
  s.held[0] = s.claims[0] = true;
  for (int i = 0; i < 10; ++i) ASSERT_TRUE(s.tick().advanced());
}

TEST(Promise, OfALowerRobotThatWaitsToGoOnIsReliedUpon) {
  GuardScene s(0);
  s.other[1] = {5 + start_m, 5};
  s.held[1] = s.claims[1] = true;
  EXPECT_TRUE(s.tick().advanced());
}

TEST(Promise, ThatEndsWithinTheHorizonIsWorthNothing) {
  // 250 ms from the decision to the recovery.
  for (const TimeUs left_us : {250'000, 249'999}) {
    GuardScene s;
    ASSERT_TRUE(s.tick().advanced());
    Observation& o = s.seen;
    o.now_us = s.now_us;
    o.position.stamp_us = o.velocity.stamp_us = o.battery.stamp_us = s.now_us;
    o.heading.stamp_us = s.now_us;
    for (std::size_t j = 1; j < 3; ++j) {
      o.others[j].position.stamp_us = o.others[j].velocity.stamp_us = s.now_us;
    }
    o.others[1].position.value = {5 + near_m, 5};
    o.others[1].lease_end_us = s.now_us + left_us;
    EXPECT_EQ(s.guard.step(o, false, false).advanced(), left_us == 250'000);
  }
}

// Others rely on a promise until its end, so nobody may take it back: who does is not understood.
TEST(Promise, ThatIsTakenBackMakesTheRobotUnknownUntilItsEnd) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.held[1] = true;
  const TimeUs end_us = s.now_us + s.lease_left_us;
  ASSERT_TRUE(s.tick().advanced());
  s.held[1] = false;
  while (s.now_us < end_us) {
    const DecisionRecord& r = s.tick();
    ASSERT_FALSE(r.advanced());
    ASSERT_EQ(r.monitors[separation].now, Verdict::is_unknown);
    ASSERT_EQ(r.reason_input, InputField::other_robot);
  }
  EXPECT_EQ(s.tick().monitors[separation].now, Verdict::is_true);
}

TEST(Promise, ThatWasKeptMayBeFollowedByNone) {
  GuardScene s;
  s.held[1] = true;
  ASSERT_TRUE(s.tick().advanced());
  s.now_us += s.lease_left_us;
  s.held[1] = false;
  EXPECT_EQ(s.tick().monitors[separation].now, Verdict::is_true);
}

// The time of a tick is read before the messages come in: a fresh promise may end a little more
// than a lease from then. It is a promise like any other, and no reason to take over.
TEST(Promise, GivenAfterTheClockWasReadIsReliedUpon) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.other[1] = {5 + near_m, 5};
  s.held[1] = true;
  s.lease_left_us = 1'000'300;
  const DecisionRecord& r = s.tick();
  EXPECT_TRUE(r.advanced());
  EXPECT_EQ(r.monitors[separation].now, Verdict::is_true);
}

// Nobody promises more than the specification lets it. An endless promise is believed for a lease
// from when it was said, and is kept when that has passed.
TEST(Promise, WithoutAnEndIsWorthOneLease) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.held[1] = true;
  s.lease_left_us = INT64_MAX / 2;
  const TimeUs end_us = s.now_us + 1'000'000;
  ASSERT_TRUE(s.tick().advanced());
  s.held[1] = false;
  while (s.now_us < end_us) {
    ASSERT_EQ(s.tick().monitors[separation].now, Verdict::is_unknown);
  }
  EXPECT_EQ(s.tick().monitors[separation].now, Verdict::is_true);
}

// A look-ahead beyond the longest promise relies on none.
TEST(Promise, IsWorthNothingBeyondTheLease) {
  EXPECT_TRUE(probe_relied_upon(INT64_MAX, 5'000'000, 1'000'000, 1'000'000));
  EXPECT_FALSE(probe_relied_upon(INT64_MAX, 5'000'000, 1'000'001, 1'000'000));
}

// A clock that goes backwards does not make room to take a promise back.
TEST(Promise, IsNotShortenedByAClockThatGoesBackwards) {
  int64_t last_us = INT64_MIN;
  EXPECT_TRUE(probe_promise_kept(9'000'000, 8'000'000, 1'000'000, &last_us));
  EXPECT_TRUE(probe_promise_kept(9'000'000, 7'000'000, 1'000'000, &last_us));
  EXPECT_FALSE(probe_promise_kept(8'500'000, 7'000'000, 1'000'000, &last_us));
}

// A module that starts anew is the same robot to the others, which may drive past it meanwhile.
TEST(Lease, OutlivesAReset) {
  GuardScene s;
  s.tick();
  surrendered(s);
  const TimeUs end_us = surrendered(s, true).lease_end_us;
  ASSERT_GT(end_us, s.now_us);
  s.guard.reset();
  while (s.now_us < end_us) {
    const DecisionRecord& r = s.tick();
    ASSERT_FALSE(r.advanced());
    ASSERT_EQ(r.gate, Gate::hold);
    ASSERT_EQ(r.lease_end_us, end_us);
  }
  EXPECT_TRUE(s.tick().advanced());
}

TEST(Rule9, LegsKeepAwayFromARobotThatStays) {
  GuardScene s;
  s.other[1] = {5, 8};
  s.held[1] = true;
  ASSERT_TRUE(s.tick().advanced());
  s.plan = path({{3, 8}, {7, 8}});
  const DecisionRecord& r = s.tick();
  EXPECT_EQ(r.mode, separation + 1);
  EXPECT_EQ(r.reason, Reason::leg);
  EXPECT_EQ(r.reason_index, 1);
  EXPECT_EQ(r.reason_other, 1);
}

TEST(Rule9, LegsKeepAwayFromTheLegsOfTheRobotThatGoesFirst) {
  // Of two crossing plans the robot of lower order gives way, the other one does not.
  for (const int self : {0, 1}) {
    GuardScene s(self);
    ASSERT_TRUE(s.tick().advanced());
    const int other = 1 - self;
    s.claims[other] = true;
    s.other[other] = {3, 7};
    s.other_plan[other] = path({{7, 3}});
    s.at = {3, 3};
    s.plan = path({{7, 7}});
    EXPECT_EQ(s.tick().advanced(), self == 0);
  }
}

TEST(Rule6, AFalsePairDominatesAnUnknownOne) {
  // Kleene: one robot overlaps this one, another was not heard of; the property is false.
  GuardScene s;
  s.tick();
  s.other[1] = {5.05, 5};
  s.other[2].x = nan_value;
  const DecisionRecord& r = s.tick();
  EXPECT_EQ(r.monitors[separation].now, Verdict::is_false);
  EXPECT_EQ(r.reason, Reason::violated);
}

// The order is told to the kernel, not derived from indices: who waited longer goes first.
TEST(Rule9, LegsKeepAwayFromTheLegsOfARobotThatWaitedLonger) {
  for (const int urgency : {0, 1}) {
    GuardScene s(0);
    ASSERT_TRUE(s.tick().advanced());
    s.claims[1] = true;
    s.seen.others[1].urgency = urgency;
    s.other[1] = {3, 7};
    s.other_plan[1] = path({{7, 3}});
    s.at = {3, 3};
    s.plan = path({{7, 7}});
    EXPECT_EQ(s.tick().advanced(), urgency == 0);
  }
}

}  // namespace
}  // namespace rtac::kernel_test
