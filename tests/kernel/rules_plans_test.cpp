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
      {"passed already", path({{12, 5}, {5, 6}}, 1), -1},
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

}  // namespace
}  // namespace rtac::kernel_test
