// Three properties of two robots: generated code against hand-written code with the same inputs,
// ages and outputs, and its entry for verdicts alone against naive checks.
#include <memory>

#include "tests/bench/watch/contest.h"
#include "tests/bench/watch/trace.h"
#include "tests/bench/watch/watch_bench.h"

namespace rtac::bench {
namespace {

constexpr int trace_ticks = 512;

// Each contestant has a trace of its own, whose stamps move on.
template <class Step>
std::function<double()> replay(const Step& step) {
  auto trace = std::make_shared<PatrolTrace>(
      patrol_trace(7, trace_ticks, {.samples = true, .ticks = false}));
  return [trace, step] {
    const double ns = pass_ns(trace_ticks, [&](std::size_t i) { step(*trace, i); });
    next_round(*trace);
    return ns;
  };
}

std::function<double()> generated() {
  auto state = std::make_shared<patrol_monitors_state>();
  patrol_monitors_init(state.get());
  return replay([state](const PatrolTrace& trace, std::size_t i) {
    patrol_monitors_out out;
    patrol_monitors_step(state.get(), &trace.kernel[i], trace.now_us[i], &out);
    keep(&out);
  });
}
std::function<double()> by_hand() {
  auto state = std::make_shared<hand_patrol_state>();
  hand_patrol_init(state.get());
  return replay([state](const PatrolTrace& trace, std::size_t i) {
    hand_patrol_out out;
    hand_patrol_step(state.get(), &trace.hand[i], trace.now_us[i], &out);
    keep(&out);
  });
}
std::function<double()> verdicts() {
  auto state = std::make_shared<patrol_monitors_verdicts_state>();
  patrol_monitors_verdicts_init(state.get());
  return replay([state](const PatrolTrace& trace, std::size_t i) {
    std::int32_t found[PATROL_MONITORS];
    patrol_monitors_verdicts(state.get(), &trace.kernel[i], trace.now_us[i], found);
    keep(found);
  });
}
std::function<double()> naive() {
  auto state = std::make_shared<naive_patrol_state>();
  return replay([state](const PatrolTrace& trace, std::size_t i) {
    int found[HAND_PATROL_MONITORS];
    naive_patrol_step(state.get(), &trace.naive[i], found);
    keep(found);
  });
}

}  // namespace

void measure_patrol(int rounds, Report& report) {
  Contest contest;
  const std::size_t kernel = contest.add(generated()), hand = contest.add(by_hand());
  const std::size_t truth = contest.add(verdicts()), checks = contest.add(naive());
  contest.run(rounds, 101);
  report.section("Monitors: charge, box and pair of two robots");
  report.add("watch_patrol_ratio", "generated / hand-written, same outputs (target: at most 1.2)",
             contest.ratio(kernel, hand), "x", 2);
  report.add("watch_verdicts_ratio", "verdicts only / naive checks (target: at most 3)",
             contest.ratio(truth, checks), "x", 2);
  report.add("watch_patrol_ns", "generated", contest.tick_ns(kernel), "ns/tick", 1);
  report.add("watch_patrol_hand_ns", "hand-written", contest.tick_ns(hand), "ns/tick", 1);
  report.add("watch_verdicts_ns", "generated, verdicts only", contest.tick_ns(truth), "ns/tick", 1);
  report.add("watch_naive_ns", "naive checks", contest.tick_ns(checks), "ns/tick", 1);
}

}  // namespace rtac::bench
