// Who has driven into a violation: under which mode a look-ahead held, and a monitor let go, for
// the last time, and who drove from then on.
#include "blame.h"

#include <gtest/gtest.h>

namespace rtac::simulate {
namespace {

// Two robots, and two monitors: mode 1 is the recovery of the first, mode 2 that of the second one.
constexpr std::size_t robots = 2, monitors = 2;
constexpr int judged = 1;

DecisionRecord decision(int robot, int mode, Verdict ahead, bool engaged) {
  DecisionRecord record;
  record.robot = robot;
  record.mode = mode;
  record.monitors[judged].ahead = ahead;
  record.monitors[judged].engaged = engaged;
  return record;
}
Asked driven_by(int mode) {
  Asked asked{std::vector<bool>(monitors + 1, false), {}};
  asked.driven_by[static_cast<std::size_t>(mode)] = true;
  return asked;
}
Asked without(Asked asked, int mode) {
  asked.not_driven_by.assign(monitors + 1, false);
  asked.not_driven_by[static_cast<std::size_t>(mode)] = true;
  return asked;
}
// Robot 0, as it was decided at each tick; its monitor does not let go.
std::vector<Drove> after(const std::vector<std::pair<int, Verdict>>& ticks) {
  Blame blame(robots, monitors);
  blame.decided(decision(1, 0, Verdict::is_true, false));
  bool engaged = false;
  for (const auto& [mode, ahead] : ticks) {
    engaged = engaged || ahead != Verdict::is_true;
    blame.decided(decision(0, mode, ahead, engaged));
  }
  return blame.who(judged, 0);
}

TEST(Blame, IsOnWhoDrivesAtTheViolation) {
  const auto who = after({{0, Verdict::is_true}, {1, Verdict::is_false}});
  ASSERT_EQ(who.size(), 1U);
  EXPECT_TRUE(as_asked(driven_by(1), who));
  EXPECT_FALSE(as_asked(driven_by(2), who));
  EXPECT_TRUE(as_asked({}, who));
}

TEST(Blame, KnowsWhetherEverybodyHasDecided) {
  Blame blame(robots, monitors);
  for (int ticks = 0; ticks < 2; ++ticks) {
    EXPECT_FALSE(blame.everybody_has_decided());
    blame.decided(decision(1, 0, Verdict::is_true, false));
  }
  blame.decided(decision(0, 0, Verdict::is_true, false));
  EXPECT_TRUE(blame.everybody_has_decided());
}

// The recovery that is left with it could not help it any more.
TEST(Blame, IsOnWhoDroveWhenTheLookAheadHeldForTheLastTime) {
  const auto who = after({{2, Verdict::is_true}, {1, Verdict::is_true}, {2, Verdict::is_false}});
  EXPECT_TRUE(as_asked(driven_by(1), who));
  EXPECT_TRUE(as_asked(driven_by(2), who));
  EXPECT_FALSE(as_asked(driven_by(0), who));
}

// What one recovery spends, another one lacks on the way home, which looks well for a while.
TEST(Blame, IsOnWhoDroveWhenTheMonitorEngaged) {
  const auto who = after({{2, Verdict::is_true},
                          {2, Verdict::is_false},
                          {1, Verdict::is_true},
                          {1, Verdict::is_false}});
  EXPECT_TRUE(as_asked(driven_by(2), who));
  EXPECT_FALSE(as_asked(without(driven_by(1), 2), who));
}

TEST(Blame, IsNotOnWhoCameBetween) {
  const auto who = after({{0, Verdict::is_true}, {1, Verdict::is_false}, {2, Verdict::is_false}});
  EXPECT_FALSE(as_asked(driven_by(1), who));
}

TEST(Blame, IsTakenByWhatIsAccepted) {
  const auto who = after({{2, Verdict::is_true}, {2, Verdict::is_unknown}, {1, Verdict::is_false}});
  EXPECT_FALSE(as_asked(without(driven_by(1), 2), who));
  const auto before = after({{2, Verdict::is_true}, {0, Verdict::is_true}, {1, Verdict::is_false}});
  EXPECT_TRUE(as_asked(without(driven_by(1), 2), before));
}

TEST(Blame, IsOnEitherOfTwoRobotsThatAreTooClose) {
  Blame blame(robots, monitors);
  blame.decided(decision(0, 0, Verdict::is_false, true));
  blame.decided(decision(1, 1, Verdict::is_false, true));
  EXPECT_TRUE(as_asked(driven_by(1), blame.who(judged, 0)));
  blame.decided(decision(1, 1, Verdict::is_true, false));  // it keeps what it is to keep
  EXPECT_FALSE(as_asked(driven_by(1), blame.who(judged, 0)));
}

}  // namespace
}  // namespace rtac::simulate
