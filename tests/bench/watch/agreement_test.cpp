// The benchmark of monitors compares like with like: the generated code and the hand-written code
// that it is measured against find the same at every tick, to the last bit of their margins.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <memory>

#include "tests/bench/watch/hand/windows.h"
#include "tests/bench/watch/modules.h"
#include "tests/bench/watch/trace.h"

namespace rtac::bench {
namespace {

template <class Finding>
bool same(const Finding& a, const hand_finding& b) {
  return a.verdict == b.verdict && a.reason == b.reason && a.input == b.input && a.unit == b.unit &&
         a.lo == b.lo && a.hi == b.hi;
}
template <class Finding>
std::string text(const Finding& f) {
  return "verdict " + std::to_string(f.verdict) + " reason " + std::to_string(f.reason) +
         " input " + std::to_string(f.input) + " unit " + std::to_string(f.unit) + " [" +
         std::to_string(f.lo) + ", " + std::to_string(f.hi) + "]";
}

using Seen = std::array<int, 3>;  // ticks of each verdict

void patrol_agrees(const Faults& faults) {
  const PatrolTrace trace = patrol_trace(7, 60'000, faults);
  patrol_monitors_state kernel;
  patrol_monitors_verdicts_state verdicts_only;
  hand_patrol_state hand;
  patrol_monitors_init(&kernel);
  patrol_monitors_verdicts_init(&verdicts_only);
  hand_patrol_init(&hand);
  std::array<Seen, PATROL_MONITORS> seen{};
  for (std::size_t i = 0; i < trace.now_us.size(); ++i) {
    patrol_monitors_out k;
    hand_patrol_out h;
    std::int32_t verdicts[PATROL_MONITORS];
    patrol_monitors_step(&kernel, &trace.kernel[i], trace.now_us[i], &k);
    patrol_monitors_verdicts(&verdicts_only, &trace.kernel[i], trace.now_us[i], verdicts);
    hand_patrol_step(&hand, &trace.hand[i], trace.now_us[i], &h);
    ASSERT_EQ(k.tick, h.tick);
    for (std::size_t m = 0; m < PATROL_MONITORS; ++m) {
      ASSERT_TRUE(same(k.monitors[m], h.monitors[m]))
          << "monitor " << m << " at step " << i << ": " << text(k.monitors[m])
          << ", by hand: " << text(h.monitors[m]);
      ASSERT_EQ(verdicts[m], k.monitors[m].verdict) << "monitor " << m << " at step " << i;
      ++seen[m][static_cast<std::size_t>(verdicts[m])];
    }
  }
  for (const Seen& verdicts : seen) {
    for (const int ticks : verdicts) EXPECT_GT(ticks, 100) << "the trace shows every verdict";
  }
}

// A charge with errors and ages, a box and a pair of robots: also at ticks that were missed, with
// samples that are late, torn or out of range.
TEST(PatrolByHand, agrees_on_the_trace_of_the_benchmark) {
  patrol_agrees({.samples = true, .ticks = false});
}
TEST(PatrolByHand, agrees_when_ticks_are_missed) {
  patrol_agrees({.samples = true, .ticks = true});
}

// The naive checks ignore errors and samples that are missing. Where there is nothing to ignore and
// the generated code is sure, they say the same.
TEST(PatrolByHand, naive_checks_agree_where_the_kernel_is_sure) {
  const PatrolTrace trace = patrol_trace(7, 20'000, {.samples = false, .ticks = false});
  patrol_monitors_verdicts_state kernel;
  naive_patrol_state naive{};
  patrol_monitors_verdicts_init(&kernel);
  std::array<int, PATROL_MONITORS> sure{};
  for (std::size_t i = 0; i < trace.now_us.size(); ++i) {
    std::int32_t verdicts[PATROL_MONITORS];
    int by_hand[PATROL_MONITORS];
    patrol_monitors_verdicts(&kernel, &trace.kernel[i], trace.now_us[i], verdicts);
    naive_patrol_step(&naive, &trace.naive[i], by_hand);
    for (std::size_t m = 0; m < PATROL_MONITORS; ++m) {
      if (verdicts[m] == PATROL_VERDICT_UNKNOWN) continue;
      ++sure[m];
      ASSERT_EQ(by_hand[m] != 0, verdicts[m] == PATROL_VERDICT_TRUE) << m << " at step " << i;
    }
  }
  for (const int ticks : sure) EXPECT_GT(ticks, 10'000);
}

template <class Generated, class State, class Step>
void window_agrees(State& hand, const Step& step, const Faults& faults) {
  auto kernel = std::make_unique<typename Generated::State>();
  auto verdicts = std::make_unique<typename Generated::VerdictsState>();
  Generated::init(kernel.get());
  Generated::verdicts_init(verdicts.get());
  Seen seen{};
  int i = 0;
  for (const WindowTick& tick : window_trace(11, 300'000, faults)) {
    typename Generated::In in;
    typename Generated::Out k;
    hand_window_out h;
    hand_number calm, alarm;
    put_condition(in.alarm, tick.alarm, tick.now_us);
    if constexpr (HasCalm<typename Generated::In>) put_condition(in.calm, tick.calm, tick.now_us);
    put_condition(calm, tick.calm, tick.now_us);
    put_condition(alarm, tick.alarm, tick.now_us);
    std::int32_t verdict[1];
    Generated::step(kernel.get(), &in, tick.now_us, &k);
    Generated::verdicts(verdicts.get(), &in, tick.now_us, verdict);
    step(&hand, calm, alarm, tick.now_us, &h);
    ASSERT_EQ(k.tick, h.tick);
    ASSERT_TRUE(same(k.monitors[0], h.finding))
        << "at step " << i << ": " << text(k.monitors[0]) << ", by hand: " << text(h.finding);
    ASSERT_EQ(verdict[0], k.monitors[0].verdict) << "at step " << i;
    ++seen[static_cast<std::size_t>(h.finding.verdict)];
    ++i;
  }
  for (const int ticks : seen) EXPECT_GT(ticks, 500) << "the trace shows every verdict";
}
void once_agrees(const Faults& faults) {
  hand_once_state hand;
  hand_once_init(&hand);
  window_agrees<OnceMiddle>(
      hand,
      [](hand_once_state* s, const hand_number&, const hand_number& alarm, std::int64_t now_us,
         hand_window_out* out) { hand_once_step(s, &alarm, now_us, out); },
      faults);
}
void since_agrees(const Faults& faults) {
  hand_since_state hand;
  hand_since_init(&hand);
  window_agrees<SinceMiddle>(
      hand,
      [](hand_since_state* s, const hand_number& calm, const hand_number& alarm,
         std::int64_t now_us,
         hand_window_out* out) { hand_since_step(s, &calm, &alarm, now_us, out); },
      faults);
}

// once[0, 1000] in ticks, of a condition that is now and then missing.
TEST(WindowByHand, once_agrees) {
  once_agrees({.samples = true, .ticks = false});
}
TEST(WindowByHand, once_agrees_when_ticks_are_missed) {
  once_agrees({.samples = true, .ticks = true});
}
// since[300, 1000]: what is not in the window yet waits in a ring.
TEST(WindowByHand, since_agrees) {
  since_agrees({.samples = true, .ticks = false});
}
TEST(WindowByHand, since_agrees_when_ticks_are_missed) {
  since_agrees({.samples = true, .ticks = true});
}

}  // namespace
}  // namespace rtac::bench
