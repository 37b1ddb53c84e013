// Against NASA Copilot, verdicts only: the same properties, each by itself. Copilot knows neither
// errors nor ages nor missing inputs nor the tick; its inputs are plain doubles and truth values.
// What it costs to know them is shown by hand-written checks of the same inputs.
#include <cmath>
#include <optional>

#include "peer_apart_kernel.h"
#include "peer_charged_kernel.h"
#include "peer_fence_kernel.h"
#include "tests/bench/watch/hand/single.h"
#include "tests/bench/watch/peer/peer.h"
#include "tests/bench/watch/watch_bench.h"
#include "tests/bench/watch/window_replay.h"

double peer_battery_percent;
double peer_first_x_m, peer_first_y_m, peer_second_x_m, peer_second_y_m;
bool peer_calm, peer_alarm;

// The triggers of the peer: ticks at which a property does not hold.
namespace {
int violations = 0;
}
extern "C" {
void peer_charged_violated(void) {
  ++violations;
}
void peer_fence_violated(void) {
  ++violations;
}
void peer_apart_violated(void) {
  ++violations;
}
void peer_once_violated(void) {
  ++violations;
}
void peer_since_violated(void) {
  ++violations;
}
}

namespace rtac::bench {
namespace {

// So few that the inputs of all ticks, made right before the clock starts, stay in the first cache:
// those of a tick have just come.
constexpr int trace_ticks = 256;
constexpr Faults none{.samples = false, .ticks = false};

// Of both: the ticks of the first trace at which the property is false. Either side finds its
// inputs where its interface has them: a step of ours is given a pointer to them, wherever they
// are, as in all groups of this benchmark; the peer reads globals, so each tick puts there what it
// asks for.
struct Count {
  std::function<double()> pass;
  int violations;
};

// What ours cost when every tick puts all of its inputs into one place, stamps and flags included:
// as an application does that fills in a struct of its own.
enum class Inputs { in_place, copied };

template <class State, class In, class Fill>
Count generated(void (*init)(State*),
                void (*verdicts)(State*, const In*, std::int64_t, std::int32_t*), const Fill& fill,
                Inputs inputs = Inputs::in_place) {
  struct Replay {
    State state;
    PatrolTrace patrol = patrol_trace(7, trace_ticks, none);
    std::vector<In> in;
  };
  auto replay = std::make_shared<Replay>();
  init(&replay->state);
  for (std::size_t i = 0; i < trace_ticks; ++i) {
    fill(replay->in.emplace_back(), replay->patrol.kernel[i], replay->patrol.now_us[i]);
  }
  const auto pass = [replay, verdicts, fill, inputs] {
    // What is the same in every tick is looked up once, by both sides.
    next_round(replay->patrol);
    for (std::size_t i = 0; i < trace_ticks; ++i) {
      fill(replay->in[i], replay->patrol.kernel[i], replay->patrol.now_us[i]);
    }
    const std::vector<In> made = replay->in;
    keep(made.data());
    State* const state = &replay->state;
    const In* const in = made.data();
    const std::int64_t* const now_us = replay->patrol.now_us.data();
    static In now;
    const auto in_place = [=, step = verdicts](std::size_t i) {
      std::int32_t found[1];
      step(state, in + i, now_us[i], found);
      keep(found);
    };
    const auto copied = [=, step = verdicts](std::size_t i) {
      std::int32_t found[1];
      now = in[i];
      step(state, &now, now_us[i], found);
      keep(found);
    };
    return inputs == Inputs::copied ? pass_ns(trace_ticks, copied) : pass_ns(trace_ticks, in_place);
  };
  State state;
  init(&state);
  int count = 0;
  for (std::size_t i = 0; i < trace_ticks; ++i) {
    std::int32_t found[1];
    verdicts(&state, &replay->in[i], replay->patrol.now_us[i], found);
    count += found[0] == 0 ? 1 : 0;
  }
  return {pass, count};
}

// The sample is one of this tick.
template <class To, class From>
void copy(To& to, const From& from, std::int64_t now_us) {
  to.stamp_us = now_us;
  to.valid = from.valid;
  to.between = from.between;
  if constexpr (requires { from.x; }) {
    to.x = from.x;
    to.y = from.y;
  } else {
    to.value = from.value;
  }
}

template <class Fill>
Count peer(void (*step)(), const Fill& fill) {
  auto trace = std::make_shared<PatrolTrace>(patrol_trace(7, trace_ticks, none));
  const auto pass = [trace, step, fill] {
    const std::vector<naive_patrol_in> made = trace->naive;
    const naive_patrol_in* const in = made.data();
    return pass_ns(trace_ticks, [=, once = step](std::size_t i) {
      fill(in[i]);
      once();
    });
  };
  violations = 0;
  pass();
  return {pass, violations};
}

std::function<double()> peer_windows(void (*step)()) {
  struct In {
    int calm, alarm;
  };
  auto trace =
      std::make_shared<std::vector<WindowTick>>(window_trace(11, window_trace_ticks, none));
  return [trace, step] {
    return pass_ns(window_trace_ticks, [&](std::size_t i) {
      peer_calm = (*trace)[i].calm == 1;
      peer_alarm = (*trace)[i].alarm == 1;
      step();
    });
  };
}

void put_battery(const naive_patrol_in& in) {
  peer_battery_percent = in.battery_percent;
}
void put_first(const naive_patrol_in& in) {
  peer_first_x_m = in.first_x_m;
  peer_first_y_m = in.first_y_m;
}
void put_both(const naive_patrol_in& in) {
  put_first(in);
  peer_second_x_m = in.second_x_m;
  peer_second_y_m = in.second_y_m;
}

// Ours twice, with their inputs in either place.
struct Ours {
  Count in_place, copied;
};
template <class State, class In, class Fill>
Ours both_ways(void (*init)(State*),
               void (*verdicts)(State*, const In*, std::int64_t, std::int32_t*), const Fill& fill) {
  return {generated(init, verdicts, fill), generated(init, verdicts, fill, Inputs::copied)};
}

}  // namespace

void measure_peer(int rounds, Report& report) {
  struct Pair {
    const char* key;
    const char* what;
    Count ours, theirs;
    std::optional<Count> copied, by_hand;  // by hand: of the inputs that ours have
  };
  std::vector<Pair> pairs;
  const auto add = [&](const char* key, const char* what, Ours ours, Count theirs,
                       std::optional<Count> by_hand) {
    pairs.push_back({key, what, std::move(ours.in_place), std::move(theirs), std::move(ours.copied),
                     std::move(by_hand)});
  };
  add("charged", "unbounded since (target: at most 1.1)",
      both_ways(peer_charged_monitors_verdicts_init, peer_charged_monitors_verdicts,
                [](auto& to, const patrol_monitors_in& from, std::int64_t now_us) {
                  copy(to.battery, from.battery, now_us);
                }),
      peer(peer_charged_step, [](const naive_patrol_in& in) { put_battery(in); }), std::nullopt);
  add("fence", "box (target: below 1)",
      both_ways(peer_fence_monitors_verdicts_init, peer_fence_monitors_verdicts,
                [](auto& to, const patrol_monitors_in& from, std::int64_t now_us) {
                  copy(to.first, from.first, now_us);
                }),
      peer(peer_fence_step, [](const naive_patrol_in& in) { put_first(in); }),
      generated(hand_single_init, hand_fence_step,
                [](hand_point& to, const patrol_monitors_in& from, std::int64_t now) {
                  copy(to, from.first, now);
                }));
  add("apart", "pair (target: below 1)",
      both_ways(peer_apart_monitors_verdicts_init, peer_apart_monitors_verdicts,
                [](auto& to, const patrol_monitors_in& from, std::int64_t now_us) {
                  copy(to.first, from.first, now_us);
                  copy(to.second, from.second, now_us);
                }),
      peer(peer_apart_step, [](const naive_patrol_in& in) { put_both(in); }),
      generated(hand_single_init, hand_apart_step,
                [](hand_pair& to, const patrol_monitors_in& from, std::int64_t now) {
                  copy(to.first, from.first, now);
                  copy(to.second, from.second, now);
                }));
  pairs.push_back({"once",
                   "once[0, 1000] (target: below 1)",
                   {warmed_up(window_verdicts<OnceMiddle>(), 1000), 0},
                   {peer_windows(peer_once_step), 0},
                   std::nullopt,
                   std::nullopt});
  pairs.push_back({"since",
                   "since[300, 1000] (target: below 1)",
                   {warmed_up(window_verdicts<SinceMiddle>(), 1000), 0},
                   {peer_windows(peer_since_step), 0},
                   std::nullopt,
                   std::nullopt});
  report.section("Monitors: verdicts only, generated / Copilot");
  for (const Pair& pair : pairs) {
    // Each property by itself: what others leave in the caches is none of its time.
    Contest contest;
    const std::size_t ours = contest.add(pair.ours.pass), theirs = contest.add(pair.theirs.pass);
    const std::size_t by_hand = pair.by_hand ? contest.add(pair.by_hand->pass) : 0;
    const std::size_t copied = pair.copied ? contest.add(pair.copied->pass) : 0;
    contest.run(rounds, 31);
    const std::string key = std::string("watch_peer_") + pair.key;
    report.add(key + "_ratio", pair.what, contest.ratio(ours, theirs), "x", 3);
    report.add(key + "_ns", "  generated", contest.tick_ns(ours), "ns/tick", 1);
    report.add(key + "_peer_ns", "  Copilot", contest.tick_ns(theirs), "ns/tick", 1);
    if (pair.copied) {
      report.add(key + "_copied_ratio", "  the same, inputs copied every tick",
                 contest.ratio(copied, theirs), "x", 3);
      report.add(key + "_copied_ns", "  generated, inputs copied every tick",
                 contest.tick_ns(copied), "ns/tick", 1);
    }
    if (pair.by_hand) {
      report.add(key + "_hand_ratio", "  generated / hand-written, of the same inputs",
                 contest.ratio(ours, by_hand), "x", 3);
      report.add(key + "_hand_ns", "  hand-written", contest.tick_ns(by_hand), "ns/tick", 1);
    }
    if (pair.ours.violations == 0 && pair.theirs.violations == 0) continue;
    report.add(key + "_false", "  false ticks of the trace, generated", pair.ours.violations,
               "ticks", 0);
    report.add(key + "_peer_false", "  false ticks of the trace, Copilot", pair.theirs.violations,
               "ticks", 0);
    if (!pair.by_hand) continue;
    report.add(key + "_hand_false", "  false ticks of the trace, hand-written",
               pair.by_hand->violations, "ticks", 0);
  }
}

}  // namespace rtac::bench
