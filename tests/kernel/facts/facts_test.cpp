// Facts: what monitors of robots say of plain inputs, parameters and the past. They run the kernel
// of the golden case `robot_facts`, where a monitor without a robot says the same.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "rtac/decision_text.h"
#include "spec.h"

namespace facts {
namespace {

constexpr int walls = 0, allowed = 1, seen = 2;
constexpr rtac::TimeUs period_us = 50'000;

// A drone that hovers in the middle with a permit, cool and parked, unless the fields say
// otherwise.
struct Flight {
  const rtac::DecisionRecord& tick(int periods = 1) {
    now_us += periods * period_us;
    return step();
  }
  const rtac::DecisionRecord& step() {
    const rtac::TimeUs at_us = now_us + jitter_us;
    fly.position({rtac::Length(x), rtac::Length(2.5)}, at_us - late_us);
    fly.velocity({rtac::Speed(0), rtac::Speed(0)}, at_us);
    if (gives) {
      fly.permit(permit, at_us).gear(gear, at_us).heat(heat, at_us);
      twin.permit(permit, at_us).gear(gear, at_us).heat(heat, at_us);
    }
    return fly.step(at_us);
  }
  std::string reason() {
    char text[200] = {};
    (void)rtac::reason_text(*record, text, sizeof text);
    return text;
  }
  // Ticks until the advanced controller drives again, at most 100.
  int ticks_to_advanced() {
    int n = 1;
    while (!tick().advanced() && n < 100) ++n;
    return n;
  }

  Fly fly;
  Monitors twin;
  const rtac::DecisionRecord* record = nullptr;
  rtac::TimeUs now_us = 1'000'000, jitter_us = 0;  // jitter: a step comes so much after its time
  rtac::TimeUs late_us = 0;                        // how old the position is
  double x = 2.5, heat = 300;
  bool permit = true, gives = true;
  Gear gear = Gear::parked;
};

// Random inputs, missing, not finite and out of range ones too, with ticks that are missed and
// timers that jitter, beyond what the look-ahead covers, too: in each tick the fact is what the
// monitor without a robot finds.
TEST(Rule9_3, AFactIsWhatAMonitorWithoutARobotFinds) {
  std::mt19937 random(7);
  const auto one_of = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  int verdicts[3] = {};
  for (int run = 0; run < 20; ++run) {
    Flight f;
    for (int i = 0; i < 300; ++i) {
      f.permit = one_of(4) == 0;
      f.gives = one_of(6) > 0;
      f.gear = one_of(3) == 0 ? Gear::parked : Gear::moving;
      f.heat = one_of(12) == 0 ? std::nan("") : one_of(12) == 0 ? 500 : 330 + one_of(31);
      if (i > 0) f.jitter_us = one_of(40'001) - 20'000;
      const rtac::Verdict found = f.tick(one_of(15) == 0 ? 1 + one_of(8) : 1).monitors[allowed].now;
      const rtac::Finding twin = f.twin.step(f.now_us + f.jitter_us)[Monitors::twin_index];
      ASSERT_EQ(found, twin.verdict) << "run " << run << ", tick " << i;
      ++verdicts[static_cast<int>(found)];
    }
  }
  for (const int count : verdicts) EXPECT_GT(count, 100);
}

TEST(Rule9_3, AFactThatFailsEngagesItsMonitorWhateverLiesAhead) {
  Flight f;
  f.ticks_to_advanced();
  f.gear = Gear::moving;
  f.heat = 390;
  f.record = &f.tick();
  f.record = &f.tick();
  f.record = &f.tick();
  EXPECT_EQ(f.record->mode, allowed + 1);
  EXPECT_EQ(f.reason(), "violated");
  EXPECT_EQ(f.record->monitors[walls].ahead, rtac::Verdict::is_true);
}

// A missing input is named as the specification names it.
TEST(Rule9_3, AMissingInputIsToldByItsName) {
  Flight f;
  f.gear = Gear::moving;
  f.ticks_to_advanced();
  f.gives = false;
  f.record = &f.tick();
  EXPECT_EQ(f.record->mode, allowed + 1);
  EXPECT_EQ(f.reason(), "within error");  // the mean of a range
  for (int i = 0; i < 12; ++i) f.record = &f.tick();
  EXPECT_EQ(f.reason(), "input: permit");
  EXPECT_EQ(f.record->monitors[allowed].now, rtac::Verdict::is_unknown);
}

// The margin is that of the atom that decides, in its own unit.
TEST(Rule9_3, TheMarginOfAFactHasItsUnit) {
  Flight f;
  f.gear = Gear::moving;
  f.heat = 340;
  f.tick();
  f.tick();
  f.record = &f.tick();
  EXPECT_NEAR(f.record->monitors[allowed].margin, 9, 2e-6);  // 350 K less 340 K and the error
  EXPECT_STREQ(rtac::margin_unit(*f.record, allowed), "K");
  f.gear = Gear::parked;
  f.record = &f.tick();
  EXPECT_TRUE(std::isinf(f.record->monitors[allowed].margin));
  EXPECT_STREQ(rtac::margin_unit(*f.record, allowed), "");
}

// Exactly at the limit of a strict comparison nothing is known to hold.
TEST(Rule9_3, AFactAtItsStrictLimitDoesNotHold) {
  Flight f;
  f.gear = Gear::moving;
  f.ticks_to_advanced();
  f.heat = 349;  // 350 K with the error
  for (int i = 0; i < 4; ++i) f.tick();
  EXPECT_EQ(f.tick().monitors[allowed].now, rtac::Verdict::is_unknown);
  f.heat = 348.5;
  for (int i = 0; i < 4; ++i) f.tick();
  EXPECT_EQ(f.tick().monitors[allowed].now, rtac::Verdict::is_true);
}

// A second step within a tick finds what the first one found; one back in time knows nothing.
TEST(Rule9_3, ASecondStepWithinATickMovesNothing) {
  Flight f;
  f.gear = Gear::moving;
  f.ticks_to_advanced();
  f.heat = 399;
  f.now_us += 10'000;
  EXPECT_EQ(f.step().monitors[allowed].now, rtac::Verdict::is_true);
  f.now_us -= 20'000;
  const rtac::DecisionRecord& back = f.step();
  EXPECT_EQ(back.monitors[allowed].now, rtac::Verdict::is_unknown);
  EXPECT_EQ(back.mode, walls + 1);
}

// Near the wall for one tick: the past of the robot itself keeps control away.
TEST(Rule9_3, TheReturnConditionRemembersWhereTheRobotWas) {
  Flight f;
  const int always_inside = f.ticks_to_advanced();
  f.permit = false;
  for (int i = 0; i < 12; ++i) f.tick();
  f.x = 0.5;
  EXPECT_FALSE(f.tick().advanced());
  f.x = 2.5;
  f.permit = true;
  // half a second after the tick near the wall, and then the dwell of a tick
  EXPECT_EQ(f.ticks_to_advanced(), 11 + 1);
  EXPECT_LT(always_inside, 10);
}

// A tick that was missed is one in which the robot was not surely inside.
TEST(Rule9_3, AMissedTickIsUnknownInThePastOfTheRobot) {
  Flight f;
  f.ticks_to_advanced();
  for (int i = 0; i < 20; ++i) f.tick();
  f.tick(2);
  EXPECT_EQ(f.ticks_to_advanced(), 10 + 1);
}

// `moving since` it was near the wall: a fact of the robot and of an input.
TEST(Rule9_3, AFactOfAReturnMaySpeakOfRobotAndInputs) {
  Flight f;
  f.gear = Gear::moving;
  f.permit = false;
  f.x = 0.2;
  for (int i = 0; i < 8; ++i) f.tick();
  f.x = 2.5;
  f.permit = true;
  EXPECT_EQ(f.ticks_to_advanced(), 100);
  f.gear = Gear::parked;
  EXPECT_LT(f.ticks_to_advanced(), 10);
}

// A drone that was last seen in time three ticks ago and more.
Flight unseen() {
  Flight f;
  f.late_us = 60'000;
  for (int i = 0; i < 5; ++i) f.tick();
  return f;
}
TEST(Rule6_3, TheAgeOfAMeasurementIsJudgedNow) {
  Flight f = unseen();
  EXPECT_EQ(f.tick().monitors[seen].now, rtac::Verdict::is_false);
  f.late_us = 50'000;
  EXPECT_EQ(f.tick().monitors[seen].now, rtac::Verdict::is_true);
  f.late_us = 60'000;
  f.tick();
  EXPECT_EQ(f.tick().monitors[seen].now, rtac::Verdict::is_true);
  EXPECT_EQ(f.tick().monitors[seen].now, rtac::Verdict::is_false);
}
TEST(Rule6_3, TheMarginOfAnAgeIsATime) {
  Flight f;
  f.late_us = 20'000;
  f.tick();
  f.record = &f.tick();
  EXPECT_NEAR(f.record->monitors[seen].margin, 0.03, 1e-9);
  EXPECT_STREQ(rtac::margin_unit(*f.record, seen), "s");
}
// No numbers, a stamp from the future, and one that goes backwards.
TEST(Rule6_3, AMeasurementWithoutNumbersHasNoAge) {
  Flight f = unseen();
  f.x = std::nan("");
  EXPECT_EQ(f.tick().monitors[seen].now, rtac::Verdict::is_unknown);
}
TEST(Rule6_3, AMeasurementFromTheFutureHasNoAge) {
  Flight f = unseen();
  f.late_us = -10'000;
  EXPECT_EQ(f.tick().monitors[seen].now, rtac::Verdict::is_unknown);
}
TEST(Rule6_3, AMeasurementOutOfOrderHasNoAge) {
  Flight f = unseen();
  f.late_us = 120'000;
  EXPECT_EQ(f.tick().monitors[seen].now, rtac::Verdict::is_unknown);
}
TEST(Rule6_3, AMeasurementHasNoAgeInAMissedTick) {
  Flight f = unseen();
  EXPECT_EQ(f.tick(2).monitors[seen].now, rtac::Verdict::is_unknown);
}

// The kernel itself, 40 cm from a wall at rest: what a replay shows of the property now.
facts_fly_out judged_near_the_wall() {
  const auto put = [](auto& sample, std::int64_t value) {
    sample.stamp_us = 1'000'000;
    sample.valid = 1;
    sample.value = value;
  };
  facts_fly_state state;
  facts_fly_in in{};
  facts_fly_out out;
  facts_fly_init(&state);
  in.position = {400, 400, 2500, 2500, 1'000'000, 1};
  in.velocity = {0, 0, 0, 0, 1'000'000, 1};
  in.plan.valid = 1;
  put(in.facts.permit, 1);
  put(in.facts.gear, 1);
  put(in.facts.heat, 340'000);
  in.facts.h = 100;
  facts_fly_step(&state, &in, 1'000'000, &out);
  return out;
}
// 40 cm less the radius of 8 cm, the error of 2 cm and the limit; what is within reach is nearer.
TEST(Rule5, TheMarginNowIsTheLowerEndOfTheProperty) {
  const facts_fly_out out = judged_near_the_wall();
  EXPECT_LE(out.monitors[walls].now_margin, 200'000);
  EXPECT_GE(out.monitors[walls].now_margin, 197'000);
  EXPECT_LT(out.monitors[walls].margin, 197'000);
}
// 10 K less the error of 1 K, in a unit of the facts.
TEST(Rule5, TheMarginNowHasTheUnitOfWhatDecides) {
  const facts_fly_out out = judged_near_the_wall();
  EXPECT_NEAR(double(out.monitors[allowed].now_margin), 9e6, 2);
  EXPECT_GT(out.monitors[allowed].now_unit, FACTS_UNIT_COUNT);
}

// The check uses the present value; what was derived is for the strictest one.
TEST(Rule13_3, AParameterInALimitTightensTheLookAhead) {
  Flight f;
  f.x = 0.7;
  f.tick();
  const double before = f.tick().monitors[walls].margin;
  f.fly.h(0.3);
  EXPECT_NEAR(f.tick().monitors[walls].margin, before - 0.2, 1e-9);
  f.fly.h(0.2);  // looser: ignored
  EXPECT_NEAR(f.tick().monitors[walls].margin, before - 0.2, 1e-9);
  f.fly.h(7);  // beyond its range: ignored
  EXPECT_NEAR(f.tick().monitors[walls].margin, before - 0.2, 1e-9);
  f.fly.h(0.5);
  EXPECT_NEAR(f.tick().monitors[walls].margin, before - 0.4, 1e-9);
  f.fly.reset();
  f.fly.h(0.1);
  f.tick();
  EXPECT_NEAR(f.tick().monitors[walls].margin, before - 0.4, 1e-9);
}
TEST(Rule13_3, TheVerdictNowUsesThePresentValueToo) {
  Flight f;
  f.x = 0.4;
  EXPECT_EQ(f.tick().monitors[walls].now, rtac::Verdict::is_true);
  f.fly.h(0.5);
  EXPECT_EQ(f.tick().monitors[walls].now, rtac::Verdict::is_false);
}

}  // namespace
}  // namespace facts
