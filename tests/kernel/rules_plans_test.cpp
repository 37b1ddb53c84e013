// Rules 8 and 9: what is required of the way-points and of the legs between them.
#include <gtest/gtest.h>

#include "tests/kernel/scenes.h"

namespace rtac::kernel_test {
namespace {

// In the west half, so that the pool stands between (8, 5) and (12, 5).
struct Case {
  const char* name;
  Path plan;
  int leg;  // that fails; -1: none
};

TEST(Rule9, ThePresentLegAndTheNextTwoAreJudged) {
  const Case cases[] = {
      {"present", path({{12, 5}}), 0},
      {"next", path({{8, 5}, {12, 5}}), 1},
      {"after next", path({{6, 5}, {8, 5}, {12, 5}}), 2},
      {"third", path({{6, 5}, {7, 5}, {8, 5}, {12, 5}}), -1},
      {"around", path({{8, 7.5}, {12, 7.5}, {12, 5}}), -1},
      {"passed already", path({{12, 5}, {5, 5}, {5, 6}}, 2), -1},
  };
  for (const Case& c : cases) {
    GuardScene s;
    ASSERT_TRUE(s.tick().advanced());
    s.plan = c.plan;
    const DecisionRecord& r = s.tick();
    EXPECT_EQ(r.advanced(), c.leg < 0) << c.name;
    if (c.leg < 0) continue;
    EXPECT_EQ(r.mode, fence + 1) << c.name;
    EXPECT_EQ(r.reason, Reason::leg) << c.name;
    EXPECT_EQ(r.reason_index, c.leg) << c.name;
  }
}

TEST(Rule8, LegsAreGrownByRadiusErrorAndTracking) {
  // 5 cm of the property, 10 cm of body, 10 cm of tracking, 1 cm of error, 1 mm of rounding.
  for (const int mm : {260, 264}) {
    GuardScene s;
    ASSERT_TRUE(s.tick().advanced());
    s.at = {5, 1};
    s.plan = path({{5, mm * 1e-3}});
    EXPECT_EQ(s.tick().advanced(), mm == 264) << mm;
  }
}

// The cart drives from (4, 5) to (8, 5): how it stands to that leg, `mm` to the north of it.
Reason off_its_leg(int mm, std::size_t index = 1) {
  GuardScene s;
  EXPECT_TRUE(s.tick().advanced());
  s.at = {5, 5 + mm * 1e-3};
  s.plan = path({{4, 5}, {8, 5}, {8, 8}}, index);
  return s.tick().reason;
}

// Legs are grown by the declared tracking, so leaving it is not admissible. 10 cm of tracking, 1 cm
// of error, 1 mm of rounding: only a violation that is certain counts. Asking for a proof of the
// opposite would switch on the noise of a robot that tracks as well as it has promised.
TEST(Rule8, AViolatedTrackingIsNotAdmissible) {
  EXPECT_EQ(off_its_leg(110), Reason::none);
  EXPECT_EQ(off_its_leg(114), Reason::tracking);
  EXPECT_EQ(off_its_leg(-110), Reason::none);
  EXPECT_EQ(off_its_leg(-114), Reason::tracking);
}

TEST(Rule8, TrackingIsJudgedFromTheFirstLegOfThePlanToTheLast) {
  EXPECT_EQ(off_its_leg(500, 0), Reason::none);    // on its way to the first way-point
  EXPECT_EQ(off_its_leg(0, 2), Reason::tracking);  // 3 m from the leg from (8, 5) to (8, 8)
  EXPECT_EQ(off_its_leg(500, 3), Reason::none);    // nothing left
}

TEST(Rule8, BeyondTheEndsOfALegTheTrackingIsViolatedToo) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.at = {3.8, 5};
  s.plan = path({{4, 5}, {8, 5}}, 1);
  EXPECT_EQ(s.tick().reason, Reason::tracking);
}

TEST(Rule8, TheMarginOfTheTrackingIsThatOfTheMonitorsThatJudgeLegs) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.at = {5, 5.2};
  s.plan = path({{4, 5}, {8, 5}}, 1);
  const DecisionRecord& r = s.tick();
  EXPECT_EQ(r.mode, separation + 1);
  EXPECT_EQ(r.reason_index, 1);
  EXPECT_EQ(r.reason_other, -1);
  for (const int monitor : {separation, fence}) {
    const MonitorRecord& m = r.monitors[static_cast<std::size_t>(monitor)];
    EXPECT_EQ(m.ahead, Verdict::is_false) << monitor;
    EXPECT_NEAR(m.margin, -0.089, 0.0021) << monitor;
  }
  EXPECT_EQ(r.monitors[charge].ahead, Verdict::is_true);
}

// A recovery leaves the plan behind: that it does is no reason to hand over to another one.
TEST(Rule8, TrackingIsJudgedForTheAdvancedControllerAlone) {
  GuardScene s;
  EXPECT_FALSE(s.tick(false, true).advanced());
  s.plan = path({{4, 6}, {8, 6}}, 1);
  const DecisionRecord& r = s.tick();
  EXPECT_EQ(r.monitors[fence].ahead, Verdict::is_true);
  EXPECT_EQ(r.monitors[fence].safer, Verdict::is_false);  // nor does it get control back
  s.plan = path({});
  EXPECT_EQ(s.tick().monitors[fence].safer, Verdict::is_true);
}

TEST(Rule8, AnEmptyAndAFinishedPlanPass) {
  GuardScene s;
  s.plan = path({});
  EXPECT_TRUE(s.tick().advanced());
  s.plan = path({{12, 5}}, 1);
  EXPECT_TRUE(s.tick().advanced());
}

TEST(Rule8, APlanOverTheCapacityIsUnknown) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.plan = path({{5, 5}, {6, 5}, {7, 5}, {6, 5}, {5, 5}, {6, 5}, {7, 5}, {6, 5}, {5, 5}});
  const DecisionRecord& r = s.tick();
  EXPECT_FALSE(r.advanced());
  EXPECT_EQ(r.reason, Reason::over_capacity);
}

TEST(Rule8, APlanOfExactlyTheCapacityIsJudged) {
  GuardScene s;
  s.plan = path({{5, 5}, {6, 5}, {7, 5}, {6, 5}, {5, 5}, {6, 5}, {7, 5}, {6, 5}});
  EXPECT_TRUE(s.tick().advanced());
}

TEST(Rule8, AWayPointAtTheEndOfTheWorldLeavesTheZone) {
  GuardScene s;
  ASSERT_TRUE(s.tick().advanced());
  s.plan = path({{-1e300, 5}});
  EXPECT_EQ(s.tick().reason, Reason::leg);
}

TEST(Rule9, PointsOnlyJudgesTheNextWayPointsAndNothingBetween) {
  probe::Hover hover(0);
  const auto reason = [&](const Path& plan, int& index) {
    hover.reset();
    Observation o;
    for (int i = 0; i < 2; ++i) {
      o.now_us = 50'000 * i;
      o.position = {{10, 5}, o.now_us};
      o.velocity = {{0, 0}, o.now_us};
      o.plan = i == 0 ? Path() : plan;
      const DecisionRecord& r = hover.step(o, false, false);
      index = r.reason_index;
      if (i == 1) return r.reason;
    }
    return Reason::none;
  };
  int index = 0;
  EXPECT_EQ(reason(path({{9, 5}, {30, 5}}), index), Reason::waypoint);
  EXPECT_EQ(index, 1);
  EXPECT_EQ(reason(path({{9, 5}, {8, 5}, {30, 5}}), index), Reason::none);
  EXPECT_EQ(reason(path({{9, 0.05}}), index), Reason::waypoint);
}

// Points leave no room for tracking: nothing rests on it, so that it is no reason to switch.
TEST(Rule8, PointsOnlyDoesNotJudgeTheTracking) {
  probe::Hover hover(0);
  Observation o;
  for (int i = 0; i < 2; ++i) {
    o.now_us = 50'000 * i;
    o.position = {{10, 5}, o.now_us};
    o.velocity = {{0, 0}, o.now_us};
    if (i == 1) o.plan = path({{4, 8}, {8, 8}}, 1);
    EXPECT_EQ(hover.step(o, false, false).reason, Reason::none);
  }
}

TEST(OnPlan, EveryLegOfAProposedPlanIsJudgedAndAnEmptyPlanPasses) {
  probe::Draughtsman judge(0);
  EXPECT_TRUE(judge.judge(path({}), 0).advanced());
  EXPECT_TRUE(judge.judge(path({{5, 5}}), 0).advanced());
  EXPECT_TRUE(judge.judge(path({{5, 5}, {8, 7}, {12, 7}, {12, 5}}), 0).advanced());
  const DecisionRecord& r = judge.judge(path({{5, 5}, {6, 5}, {8, 5}, {12, 5}}), 0);
  EXPECT_FALSE(r.advanced());
  EXPECT_EQ(r.reason, Reason::leg);
  EXPECT_EQ(r.reason_index, 3);
  EXPECT_FALSE(judge.judge(path({{10, 5}}), 0).advanced());
  EXPECT_FALSE(judge.judge(path({{5, nan_value}}), 0).advanced());
}

// What touches the boundary lies in the zone, which contains it: on the grid that is not decided,
// and a proof that it leaves would be wrong.
TEST(OnPlan, ALegAlongTheBoundaryIsNotFalse) {
  probe::Draughtsman judge(0);
  const auto now = [&](const Path& plan) { return judge.judge(plan, 0).monitors[0].now; };
  EXPECT_EQ(now(path({{5, 0}, {8, 0}})), Verdict::is_unknown);
  EXPECT_EQ(now(path({{0, 0}, {0, 9}})), Verdict::is_unknown);
  EXPECT_EQ(now(path({{20, 1}, {20, 2}})), Verdict::is_unknown);
  EXPECT_EQ(now(path({{5, -0.01}, {8, -0.01}})), Verdict::is_false);
  EXPECT_EQ(now(path({{5, 1}, {5, -0.01}})), Verdict::is_false);
  EXPECT_EQ(now(path({{8, 5}, {12, 5}})), Verdict::is_false);
  EXPECT_EQ(now(path({{1, 1}, {-1, -1}})), Verdict::is_false);
  EXPECT_EQ(now(path({{-1, -1}, {1, 1}})), Verdict::is_false);
  EXPECT_EQ(now(path({{5, 0.01}, {8, 0.01}})), Verdict::is_true);
}

// The gap of a leg is found within 3 mm, from below: outside that makes it nearer than it is.
TEST(OnPlan, TheMarginOutsideIsNotAboveTheTrueOne) {
  probe::Draughtsman judge(0);
  const double margin = judge.judge(path({{5, -0.5}, {8, -1}}), 0).monitors[0].margin;
  EXPECT_LE(margin, -0.503);
  EXPECT_GE(margin, -0.505);
}

}  // namespace
}  // namespace rtac::kernel_test
