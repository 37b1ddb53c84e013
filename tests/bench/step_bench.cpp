// The decision step of the delivery study: generated kernel and generated class against the
// hand-written step, on the same recorded stream.
//
// How. The stream is a shift in simulation, in windows of 16 consecutive ticks: small enough to
// stay in the cache together with its inputs, so that arithmetic is compared and not memory. A
// window is timed as a whole (a clock costs 25 ns, a window microseconds), from the recorded state
// on, several times; its time is the median. All contestants take turns on each window, so that a
// change of the machine's speed meets all of them. A round is the whole stream; ratios are taken
// within a round, and their spread over the rounds is reported.
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <vector>

#include "tests/bench/benchmarks.h"
#include "tests/bench/shift.h"
#include "tests/bench/tables.h"

namespace rtac::bench {
namespace {

constexpr std::size_t window_ticks = 16;
constexpr int windows_apart_ticks = 96;  // of one robot, from start to start
constexpr int passes = 5;

struct Tick {
  Observation observation;
  bool holding = false, surrender = false;
  KernelIn in{};
  HandInput hand;
};
struct Window {
  std::array<Tick, window_ticks> ticks;
  std::size_t count = 0;
  std::size_t recovery = 0;  // ticks that begin in a recovery mode
  KernelState kernel{};
  hand_state hand{};
  robot_delivery::PlanExecutor module;
};

class Recorder final : public Listener {
 public:
  void on_decision(const Decision& d) override {
    const auto robot = static_cast<std::size_t>(d.observation.self);
    const int phase = seen_[robot]++ % windows_apart_ticks;
    if (phase == 0) open_[robot] = start(d);
    if (phase >= static_cast<int>(window_ticks)) return;
    Window& window = *open_[robot];
    Tick& tick = window.ticks[window.count++];
    tick.observation = d.observation;
    tick.holding = d.holding;
    tick.surrender = d.surrender;
    tick.in = d.in;
    fill(tick.hand, d.observation, d.holding, d.surrender);
    window.recovery += d.state.mode != 0 ? 1 : 0;
    if (window.count == window_ticks) windows_.push_back(std::move(open_[robot]));
  }
  std::vector<std::unique_ptr<Window>> take() { return std::move(windows_); }

 private:
  static std::unique_ptr<Window> start(const Decision& d) {
    auto window = std::make_unique<Window>();
    window->kernel = d.state;
    window->hand = hand_state_of(d.state);
    window->module = d.module;
    return window;
  }
  std::array<int, HAND_ROBOTS> seen_{};
  std::array<std::unique_ptr<Window>, HAND_ROBOTS> open_;
  std::vector<std::unique_ptr<Window>> windows_;
};

enum Contestant { hand_prepared, hand_full, kernel, module, contestants };

// Each pass starts from the recorded state; the copy is not timed.
template <class State, class Step>
double window_ns(const State& start, const Step& step) {
  std::vector<double> times;
  times.reserve(passes);
  for (int pass = 0; pass <= passes; ++pass) {
    State state = start;
    const auto from = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < window_ticks; ++i) step(state, i);
    const auto to = std::chrono::steady_clock::now();
    // the first pass fills the caches
    if (pass > 0) times.push_back(std::chrono::duration<double, std::nano>(to - from).count());
  }
  return spread_of(times).median / window_ticks;
}

double time_of(Contestant who, Window& w, const hand_tables& tables) {
  static_assert(contestants == 4);
  KernelOut kernel_out;
  hand_out out;
  HandInput scratch;
  switch (who) {
    case hand_prepared:
      return window_ns(w.hand, [&](hand_state& s, std::size_t i) {
        hand_step(&tables, &s, &w.ticks[i].hand.in, w.ticks[i].observation.now_us, &out);
      });
    case hand_full:  // from the observation of the runtime, like the generated class
      return window_ns(w.hand, [&](hand_state& s, std::size_t i) {
        const Tick& t = w.ticks[i];
        fill(scratch, t.observation, t.holding, t.surrender);
        hand_step(&tables, &s, &scratch.in, t.observation.now_us, &out);
      });
    case kernel:
      return window_ns(w.kernel, [&](KernelState& s, std::size_t i) {
        const Tick& t = w.ticks[i];
        robot_delivery_plan_executor_step(&s, &t.in, t.observation.now_us, &kernel_out);
      });
    case module:
      return window_ns(w.module, [&](robot_delivery::PlanExecutor& m, std::size_t i) {
        const Tick& t = w.ticks[i];
        m.step(t.observation, t.holding, t.surrender);
      });
    case contestants:
      break;
  }
  return 0;
}

using Times = std::array<double, contestants>;  // ns per step, mean over windows

// Which windows a row is about.
enum Kind { all, advanced, recovery, kinds };
bool is_of(const Window& w, Kind kind) {
  return kind == all || (kind == advanced ? w.recovery == 0 : w.recovery == w.count);
}

struct Rounds {
  std::array<std::vector<Times>, kinds> of;
  Times worst{};  // window, least over the rounds: what is not noise
};

Rounds run(std::vector<std::unique_ptr<Window>>& windows, const hand_tables& tables, int rounds) {
  Rounds result;
  std::vector<Times> least(windows.size());
  for (int round = 0; round < rounds; ++round) {
    std::array<Times, kinds> sum{};
    std::array<int, kinds> count{};
    for (std::size_t k = 0; k < windows.size(); ++k) {
      Times times{};
      for (int c = 0; c < contestants; ++c) {  // another one begins every time
        const auto who = static_cast<Contestant>((c + round + static_cast<int>(k)) % contestants);
        times[who] = time_of(who, *windows[k], tables);
        least[k][who] = round == 0 ? times[who] : std::min(least[k][who], times[who]);
      }
      for (int kind = 0; kind < kinds; ++kind) {
        if (!is_of(*windows[k], static_cast<Kind>(kind))) continue;
        ++count[static_cast<std::size_t>(kind)];
        for (std::size_t c = 0; c < contestants; ++c) {
          sum[static_cast<std::size_t>(kind)][c] += times[c];
        }
      }
    }
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      for (double& ns : sum[kind]) ns /= std::max(count[kind], 1);
      result.of[kind].push_back(sum[kind]);
    }
  }
  for (const Times& times : least) {
    for (std::size_t c = 0; c < contestants; ++c) {
      result.worst[c] = std::max(result.worst[c], times[c]);
    }
  }
  return result;
}

Spread column(const std::vector<Times>& rounds, Contestant who) {
  std::vector<double> values;
  for (const Times& times : rounds) values.push_back(times[who]);
  return spread_of(values);
}
Spread ratio(const std::vector<Times>& rounds, Contestant who, Contestant against) {
  std::vector<double> values;
  for (const Times& times : rounds) values.push_back(times[who] / times[against]);
  return spread_of(values);
}

// False: the kernel takes longer than its target says.
bool tell(const StepSubject& subject, const Rounds& rounds, Report& report) {
  const std::vector<Times>& every = rounds.of[all];
  const auto add = [&](const char* key, const std::string& what, const Spread& value,
                       const char* unit, int decimals) {
    report.add(subject.key + std::string("_") + key, what, value, unit, decimals);
  };
  const auto worst = [&](Contestant who) {
    return Spread{rounds.worst[who], rounds.worst[who], rounds.worst[who]};
  };
  const Spread taken = ratio(every, kernel, hand_prepared);
  add("kernel_ratio",
      "generated kernel / hand-written (target: at most " + std::string(subject.target) + ")",
      taken, "x", 2);
  add("kernel_ratio_advanced", "  while the advanced controller drives",
      ratio(rounds.of[advanced], kernel, hand_prepared), "x", 2);
  add("kernel_ratio_recovery", "  while a recovery drives",
      ratio(rounds.of[recovery], kernel, hand_prepared), "x", 2);
  add("module_ratio", "generated class / hand-written, inputs included",
      ratio(every, module, hand_full), "x", 2);
  add("module_kernel_ratio", "generated class / hand-written without inputs",
      ratio(every, module, hand_prepared), "x", 2);
  add("hand_ns", "hand-written, prepared inputs", column(every, hand_prepared), "ns/step", 0);
  add("kernel_ns", "generated kernel, prepared inputs", column(every, kernel), "ns/step", 0);
  add("hand_full_ns", "hand-written, from an observation", column(every, hand_full), "ns/step", 0);
  add("module_ns", "generated class, observation in, record out", column(every, module), "ns/step",
      0);
  add("hand_worst_ns", "hand-written, slowest window", worst(hand_prepared), "ns/step", 0);
  add("kernel_worst_ns", "generated kernel, slowest window", worst(kernel), "ns/step", 0);
  return taken.median <= std::stod(subject.target);
}

}  // namespace

bool measure_steps(const StepSubject& subject, const Effort& effort, Report& report) {
  Recorder recorder;
  if (!run_shift(1, effort.shift_minutes, &recorder)) {
    std::fputs("rtac_bench: the recorded shift did not run to its end\n", stderr);
    return false;
  }
  std::vector<std::unique_ptr<Window>> windows = recorder.take();
  int recoveries = 0;
  for (const auto& window : windows) recoveries += static_cast<int>(window->recovery);
  const auto steps = static_cast<int>(windows.size() * window_ticks);
  char title[200];
  std::snprintf(title, sizeof title,
                "Decision step, %s: %d ticks of a shift (%.0f %% in a recovery), %d rounds",
                subject.title, steps, steps > 0 ? 100.0 * recoveries / steps : 0,
                effort.step_rounds);
  report.section(title);
  hand_tables tables;
  bench_tables_init(&tables);
  if (tell(subject, run(windows, tables, effort.step_rounds), report)) return true;
  std::fprintf(stderr, "rtac_bench: %s: the kernel takes more than %s times as long as by hand\n",
               subject.title, subject.target);
  return false;
}

}  // namespace rtac::bench
