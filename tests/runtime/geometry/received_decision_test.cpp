// Zones that arrive while a generated decision runs: what its robot is held against in every step.
#include <gtest/gtest.h>

#include "received.h"
#include "rtac/geometry/zone_maker.h"

namespace rtac {
namespace {

std::unique_ptr<HeldZone> square(double from, double to) {
  auto made = make_zone({{{{from, from}, {to, from}, {to, to}, {from, to}}, {}}}, 8);
  auto* zone = std::get_if<std::unique_ptr<HeldZone>>(&made);
  return zone == nullptr ? nullptr : std::move(*zone);
}

class ReceivedByADecision : public ::testing::Test {
 protected:
  // At rest there.
  const DecisionRecord& at(double x, double y, TimeUs now_us) {
    fly_.position({Length(x), Length(y)}, now_us).velocity({Speed(0), Speed(0)}, now_us);
    return fly_.step(now_us);
  }
  Verdict now(double x, double y, TimeUs now_us) { return at(x, y, now_us).monitors[0].now; }
  // Both zones, and steps until control is given to the pilot.
  void start() {
    ASSERT_TRUE(fly_.fence(fence_->table(), 0));
    ASSERT_TRUE(fly_.closed(closed_->table(), 0));
    for (TimeUs now_us = 0; now_us <= 300'000; now_us += 100'000) at(5, 5, now_us);
    ASSERT_EQ(at(5, 5, 400'000).mode, 0);
  }
  std::unique_ptr<HeldZone> fence_ = square(0, 20), closed_ = square(12, 15);
  ::received::Fly fly_;
};

TEST_F(ReceivedByADecision, NothingIsKnownBeforeTheFirst) {
  const DecisionRecord& none = at(5, 5, 0);
  EXPECT_EQ(none.monitors[0].now, Verdict::is_unknown);
  EXPECT_EQ(none.mode, 1);
  ASSERT_TRUE(fly_.fence(fence_->table(), 50'000));
  const DecisionRecord& one = at(5, 5, 100'000);
  EXPECT_EQ(one.monitors[0].now, Verdict::is_unknown);
  ASSERT_EQ(one.reason, Reason::input);
  const int input = static_cast<int>(one.reason_input) - first_plain_input;
  EXPECT_STREQ(fly_.info().inputs[input], "closed");
  ASSERT_TRUE(fly_.closed(closed_->table(), 150'000));
  EXPECT_EQ(now(5, 5, 200'000), Verdict::is_true);
}

TEST_F(ReceivedByADecision, AnotherOneCountsFromTheNextTickOn) {
  start();
  EXPECT_EQ(now(13, 13, 500'000), Verdict::is_false);
  EXPECT_EQ(now(11.2, 13, 600'000), Verdict::is_true);
  EXPECT_EQ(now(11.45, 13, 700'000), Verdict::is_false);
  const auto small = square(0, 4);
  ASSERT_TRUE(fly_.fence(small->table(), 750'000));
  const DecisionRecord& outside = at(5, 5, 800'000);
  EXPECT_EQ(outside.monitors[0].now, Verdict::is_false);
  EXPECT_EQ(outside.reason, Reason::violated);
  EXPECT_EQ(outside.mode, 1);
}

// What is received may be any other zone at once: nobody knows how soon it can be violated.
TEST_F(ReceivedByADecision, DoNotTellHowSoonTheyCanBeViolated) {
  start();
  EXPECT_EQ(at(5, 5, 500'000).time_to_violation_us, -1);
}

TEST_F(ReceivedByADecision, AreUnknownWhenTooOld) {
  start();
  for (TimeUs now_us = 500'000; now_us <= 1'000'000; now_us += 100'000) {
    EXPECT_EQ(at(5, 5, now_us).mode, 0) << now_us;
  }
  const DecisionRecord& old = at(5, 5, 1'100'000);
  EXPECT_EQ(old.monitors[0].now, Verdict::is_unknown);
  EXPECT_EQ(old.mode, 1);
  ASSERT_TRUE(fly_.fence(fence_->table(), 1'150'000));  // it still counts
  EXPECT_EQ(now(5, 5, 1'200'000), Verdict::is_true);
}

// A stamp from the future counts when its time has come, one from before the last one never.
TEST_F(ReceivedByADecision, StampsCountAsOfOtherInputs) {
  start();
  ASSERT_TRUE(fly_.fence(fence_->table(), 650'000));
  EXPECT_EQ(now(5, 5, 500'000), Verdict::is_unknown);
  EXPECT_EQ(now(5, 5, 700'000), Verdict::is_true);
  ASSERT_TRUE(fly_.fence(fence_->table(), 600'000));
  EXPECT_EQ(now(5, 5, 800'000), Verdict::is_unknown);
}

// A second step within a tick is held against what there is; one back in time knows nothing.
TEST_F(ReceivedByADecision, EveryStepOfATickLooksAtThem) {
  start();
  EXPECT_EQ(now(5, 5, 450'000), Verdict::is_true);
  const auto small = square(0, 4);
  ASSERT_TRUE(fly_.fence(small->table(), 460'000));
  EXPECT_EQ(now(5, 5, 470'000), Verdict::is_false);
  EXPECT_EQ(now(3, 3, 480'000), Verdict::is_true);
  const DecisionRecord& back = at(3, 3, 200'000);
  EXPECT_EQ(back.monitors[0].now, Verdict::is_unknown);
  EXPECT_EQ(back.mode, 1);
}

TEST_F(ReceivedByADecision, TablesThatDoNotFitAreRefusedAndTheOldOneStays) {
  start();
  const auto small = square(0, 4);
  ZoneTable table = small->table();
  table.checksum ^= 1;
  EXPECT_FALSE(fly_.fence(table, 450'000));
  EXPECT_EQ(now(5, 5, 500'000), Verdict::is_true);
}

}  // namespace
}  // namespace rtac
