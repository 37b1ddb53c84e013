// Margins over windows: both ends, and the entry that decides.
#include "tests/kernel/temporal/reference.h"

namespace rtac::temporal_test {
namespace {

// A margin whose units tell where it comes from.
probe_value any_margin(Random& random, std::int32_t index) {
  const std::int64_t lo = random.in(-9, 9);
  probe_value v = random.in(0, 9) == 0 ? unknown_margin() : value(lo, lo + random.in(0, 3));
  v.unit = index;
  v.upper_unit = index;
  return v;
}
std::vector<Window> small_and_odd_windows() {
  std::vector<Window> all = windows(9);
  for (const std::int64_t ticks : {16, 17, 31, 40}) {
    for (const std::int64_t a : {0, 1, 7, 30}) all.push_back({a, a + ticks - 1});
  }
  return all;
}

void compare_margins(std::int32_t kind) {
  Random random(std::uint32_t(kind) + 11);
  for (const Window& w : small_and_odd_windows()) {
    Operator margins(kind, w, true), verdicts(kind, w, false);
    for (int run = 0; run < 10; ++run) {
      margins.start();
      verdicts.start();
      History a, b;
      for (std::int64_t i = 0; i < 150; ++i) {
        a.push_back(any_margin(random, std::int32_t(2 * i + 1)));
        b.push_back(any_margin(random, std::int32_t(2 * i + 2)));
        const probe_value want = past(kind, a, b, i, w);
        const probe_value full = margins.step(a.back(), b.back());
        ASSERT_EQ(full.lo, want.lo) << w << " at " << i;
        ASSERT_EQ(full.hi, want.hi) << w << " at " << i;
        ASSERT_EQ(verdict(verdicts.step(a.back(), b.back())), verdict(full)) << w << " at " << i;
        if (full.upper_unit > 0) {  // what the upper end is about
          const History& of = full.upper_unit % 2 == 1 ? a : b;
          ASSERT_EQ(of[std::size_t(full.upper_unit - 1) / 2].hi, full.hi) << w << " at " << i;
        }
        if (full.unit > 0) {  // else the window is empty
          const History& of = full.unit % 2 == 1 ? a : b;
          ASSERT_EQ(of[std::size_t(full.unit - 1) / 2].lo, full.lo) << w << " at " << i;
          ASSERT_EQ(of[std::size_t(full.unit - 1) / 2].reason, full.reason) << w << " at " << i;
        }
      }
    }
  }
}

TEST(Margins, OnceIsTheGreatestOfTheWindow) {
  // Rule 3: both ends by a sliding window, the deciding entry travels along.
  compare_margins(PROBE_ONCE);
}

TEST(Margins, HistoricallyIsTheLeastOfTheWindow) {
  // Rule 3.
  compare_margins(PROBE_HISTORICALLY);
}

TEST(Margins, SinceIsTheGreatestOfTheLeast) {
  // Rule 3: the formula with S is the textbook meaning.
  compare_margins(PROBE_SINCE);
}

TEST(Margins, PreviouslyIsThatOfTheTickBefore) {
  // Rule 2; the whole margin comes back.
  compare_margins(PROBE_PREVIOUSLY);
}

TEST(Verdicts, OfNothingSaysWhatTheOperandSays) {
  // The reason of a verdict is that of the present operand, when both are the same.
  Operator once(PROBE_ONCE, {0, 5}, false);
  probe_value far = value(-3, -1);
  far.reason = 2;
  far.unit = 7;
  far.upper_unit = 1;
  const probe_value found = once.step(far);
  EXPECT_EQ(verdict(found), 0);
  EXPECT_EQ(found.reason, 2);
  EXPECT_EQ(found.unit, 7);
  EXPECT_EQ(found.upper_unit, 1);
}

TEST(Verdicts, AnUnknownOfThePastNamesItsInput) {
  // The operand is false now; which input left a gap is what the author wants to know.
  Operator once(PROBE_ONCE, {0, 5}, false);
  once.step(unknown_margin(PROBE_INPUT_FIRST + 3));
  const probe_value found = once.step(truth(0));
  EXPECT_EQ(verdict(found), 1);
  EXPECT_EQ(found.reason, PROBE_REASON_INPUT);
  EXPECT_EQ(found.input, PROBE_INPUT_FIRST + 3);
}

TEST(Verdicts, ATrueOneHasNoReason) {
  // Its operand may be false by now, and has one.
  Operator once(PROBE_ONCE, {0, 5}, false);
  once.step(truth(2));
  EXPECT_EQ(once.step(value(-5, -5)).reason, PROBE_REASON_NONE);
}

TEST(Verdicts, SinceNamesTheOperandThatFails) {
  // What has to hold, if it does not, else what should have been.
  Operator since(PROBE_SINCE, {0, 5}, false);
  probe_value hold = truth(0), x = truth(0);
  hold.unit = 1;
  x.unit = 2;
  EXPECT_EQ(since.step(hold, x).unit, 1);
  EXPECT_EQ(since.step(truth(2), x).unit, 2);
  hold = unknown_margin(PROBE_INPUT_FIRST + 4);
  since.step(truth(2), truth(2));
  EXPECT_EQ(since.step(hold, x).input, PROBE_INPUT_FIRST + 4);
}

}  // namespace
}  // namespace rtac::temporal_test
