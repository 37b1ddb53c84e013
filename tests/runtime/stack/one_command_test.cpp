// What the protocol model says of the plan executor (compiler/docs/protocol.md, `hand_over`):
// whatever the modes, exactly one controller sends a command in a tick, the one of the mode; after
// too long a silence the brake of the first recovery stands in for the advanced one.
#include <gtest/gtest.h>

#include <random>

#include "tests/runtime/stack/test_system.h"

namespace rtac {
namespace {

using test::Bench;

// Commands that each controller has sent so far.
std::array<int, 3> sent(const Bench& bench) {
  return {bench.advanced[0].calls, bench.give_way[0].commands, bench.go_charge[0].commands};
}

TEST(PlanExecutor, SendsOneCommandATickWhateverTheModes) {
  Bench bench;
  bench.tasks.waiting[0] = {{5, 0}};
  std::mt19937 random(7);
  int mode = 0, late = 0, switches = 0, stood_in = 0, ticks = 0;
  std::array<int, 3> then{};
  // At each decision the tick before it is over.
  const auto look_back = [&] {
    const bool was_late = bench.log.late > late;
    late = bench.log.late;
    const int due = was_late && mode == 0 ? 1 : mode;
    stood_in += was_late && mode == 0;
    const std::array<int, 3> now = sent(bench);
    for (int c = 0; c < 3; ++c) {
      const auto at = static_cast<std::size_t>(c);
      EXPECT_EQ(now[at] - then[at], c == due ? 1 : 0) << "tick " << ticks << " controller " << c;
    }
    then = now;
  };
  bench.decision[0].script = [&](const Observation& seen, DecisionRecord& record) {
    if (ticks++ > 0) look_back();
    const int before = mode;
    if (random() % 3 == 0) mode = static_cast<int>(random() % 3);
    switches += mode != before;
    record.mode = mode;
    if (random() % 10 == 0) {  // the platform freezes
      bench.fleet.jump_at_us = seen.now_us + 50'000;
      bench.fleet.jump_us = 1'000'000;
    }
  };
  ASSERT_EQ(bench.run(100), Status::ok);
  EXPECT_GT(ticks, 300);
  EXPECT_GT(switches, 50);
  EXPECT_GT(stood_in, 5);
}

}  // namespace
}  // namespace rtac
