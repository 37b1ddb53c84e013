// Passes over a trace of two conditions, for whatever steps on them.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "tests/bench/watch/contest.h"
#include "tests/bench/watch/modules.h"
#include "tests/bench/watch/trace.h"

namespace rtac::bench {

inline constexpr int window_trace_ticks = 1024;

// A tick of a contestant: `In` has `alarm`, and `calm` or not.
template <class In>
struct WindowInputs {
  std::vector<std::int64_t> now_us;
  std::vector<In> in;
  std::int64_t length_us = 0;

  WindowInputs() {
    const Faults faults{.samples = true, .ticks = false};
    for (const WindowTick& tick : window_trace(11, window_trace_ticks, faults)) {
      In& to = in.emplace_back();
      now_us.push_back(tick.now_us);
      put_condition(to.alarm, tick.alarm, tick.now_us);
      if constexpr (HasCalm<In>) put_condition(to.calm, tick.calm, tick.now_us);
    }
    length_us = now_us[1] * window_trace_ticks - now_us[0] * window_trace_ticks;
  }
  void next_round() {
    for (std::int64_t& us : now_us) us += length_us;
    for (In& one : in) {
      one.alarm.stamp_us += length_us;
      if constexpr (HasCalm<In>) one.calm.stamp_us += length_us;
    }
  }
};

template <class In, class Step>
std::function<double()> replay_windows(const Step& step) {
  auto inputs = std::make_shared<WindowInputs<In>>();
  return [inputs, step] {
    const double ns =
        pass_ns(window_trace_ticks, [&](std::size_t i) { step(inputs->in[i], inputs->now_us[i]); });
    inputs->next_round();
    return ns;
  };
}

template <class Generated>
std::function<double()> generated_window() {
  auto state = std::make_shared<typename Generated::State>();
  Generated::init(state.get());
  return replay_windows<typename Generated::In>(
      [state](const typename Generated::In& in, std::int64_t now_us) {
        typename Generated::Out out;
        Generated::step(state.get(), &in, now_us, &out);
        keep(&out);
      });
}
template <class Generated>
std::function<double()> window_verdicts() {
  auto state = std::make_shared<typename Generated::VerdictsState>();
  Generated::verdicts_init(state.get());
  return replay_windows<typename Generated::In>(
      [state](const typename Generated::In& in, std::int64_t now_us) {
        std::int32_t found[1];
        Generated::verdicts(state.get(), &in, now_us, found);
        keep(found);
      });
}

// Until its window is full twice over.
inline std::function<double()> warmed_up(std::function<double()> pass, int window_ticks) {
  for (int ticks = 0; ticks < 2 * window_ticks; ticks += window_trace_ticks) pass();
  return pass;
}

}  // namespace rtac::bench
