// Windows over conditions: generated code against hand-written code, and long windows against short
// ones, which cost the same.
#include "tests/bench/watch/hand/windows.h"
#include "tests/bench/watch/watch_bench.h"
#include "tests/bench/watch/window_replay.h"

namespace rtac::bench {
namespace {

struct HandIn {
  hand_number calm, alarm;
};

std::function<double()> once_by_hand() {
  auto state = std::make_shared<hand_once_state>();
  hand_once_init(state.get());
  return replay_windows<HandIn>([state](const HandIn& in, std::int64_t now_us) {
    hand_window_out out;
    hand_once_step(state.get(), &in.alarm, now_us, &out);
    keep(&out);
  });
}
std::function<double()> since_by_hand() {
  auto state = std::make_shared<hand_since_state>();
  hand_since_init(state.get());
  return replay_windows<HandIn>([state](const HandIn& in, std::int64_t now_us) {
    hand_window_out out;
    hand_since_step(state.get(), &in.calm, &in.alarm, now_us, &out);
    keep(&out);
  });
}

}  // namespace

void measure_windows(int rounds, Report& report) {
  constexpr int short_ticks = 10, middle_ticks = 1'000, long_ticks = 1'000'000;
  Contest contest;
  const auto add = [&](const std::function<double()>& pass, int ticks) {
    return contest.add(warmed_up(pass, ticks));
  };
  const std::size_t once = add(generated_window<OnceMiddle>(), middle_ticks);
  const std::size_t once_hand = add(once_by_hand(), middle_ticks);
  const std::size_t since = add(generated_window<SinceMiddle>(), middle_ticks);
  const std::size_t since_hand = add(since_by_hand(), middle_ticks);
  const std::size_t once_short = add(generated_window<OnceShort>(), short_ticks);
  const std::size_t once_long = add(generated_window<OnceLong>(), long_ticks);
  const std::size_t since_short = add(generated_window<SinceShort>(), short_ticks);
  const std::size_t since_long = add(generated_window<SinceLong>(), long_ticks);
  contest.run(rounds, 101);
  report.section("Monitors: windows over conditions, in ticks");
  report.add("watch_once_ratio", "once[0, 1000] / hand-written (target: at most 2)",
             contest.ratio(once, once_hand), "x", 2);
  report.add("watch_since_ratio", "since[300, 1000] / hand-written (target: at most 2)",
             contest.ratio(since, since_hand), "x", 2);
  report.add("watch_once_long_ratio", "once: [0, 10^6] / [0, 10] (target: at most 1.5)",
             contest.ratio(once_long, once_short), "x", 2);
  report.add("watch_since_long_ratio", "since: [300000, 10^6] / [3, 10] (target: at most 1.5)",
             contest.ratio(since_long, since_short), "x", 2);
  report.add("watch_once_ns", "once[0, 1000]", contest.tick_ns(once), "ns/tick", 1);
  report.add("watch_once_hand_ns", "  hand-written", contest.tick_ns(once_hand), "ns/tick", 1);
  report.add("watch_since_ns", "since[300, 1000]", contest.tick_ns(since), "ns/tick", 1);
  report.add("watch_since_hand_ns", "  hand-written", contest.tick_ns(since_hand), "ns/tick", 1);
  report.add("watch_since_long_bytes", "since[300000, 10^6]: state",
             static_cast<double>(sizeof(SinceLong::State)), "bytes", 0);
}

}  // namespace rtac::bench
