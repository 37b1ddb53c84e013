// After the start no tick allocates: every operator new of this executable is counted.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "rtac/safe/controllers.h"
#include "tests/runtime/core/test_plants.h"
#include "tests/runtime/core/test_zone.h"
#include "tests/runtime/stack/test_system.h"

namespace {
std::atomic<long> allocations{0};
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace rtac {
namespace {

// The counter itself works; otherwise the other tests could not fail.
TEST(Allocation, IsCounted) {
  const long before = allocations;
  auto owned = std::make_unique<std::array<int, 100>>();
  EXPECT_GT(allocations, before) << owned->size();
}

// Tasks, plans, rejections, blocking and switching, and no allocation in 60 s of ticks.
TEST(Allocation, NoneWhileTheSystemRuns) {
  test::Bench bench(2);
  bench.with_judge();
  for (int i = 0; i < 40; ++i) {
    bench.tasks.waiting[0].push_back({i % 2 == 0 ? 2.0 : 0.0, 0});
    bench.tasks.waiting[1].push_back({1, i % 2 == 0 ? 1.5 : -1.5});
  }
  bench.fleet.points[1].p = {1, -1.5};
  bench.decision[0].script = [](const Observation& seen, DecisionRecord& record) {
    if (seen.now_us / 1'000'000 % 7 == 3) record.mode = 2, record.reason = Reason::leg;
  };
  ASSERT_EQ(bench.run(1), Status::ok);
  const long before = allocations;
  ASSERT_EQ(bench.run(60), Status::ok);
  EXPECT_EQ(allocations, before);
  EXPECT_GT(bench.log.delivered + static_cast<int>(bench.log.skip_count), 5);
}

// The templates neither, route search included.
TEST(Allocation, NoneInTheSafeControllers) {
  const test::TestZone zone(test::square_rings(5000));
  safe::Setting setting;
  setting.limits = test::cart_limits(), setting.period_us = 100'000, setting.speed_mps = 0.15;
  setting.zone = &zone.view();
  setting.route_clearance_m = 0.2, setting.return_clearance_m = 0.45, setting.pass_gap_m = 0.7;
  safe::Retreat<Twist> retreat(setting);
  safe::Route<Twist> route(setting, {4, 4});
  safe::Yield<Twist> yield(setting);
  Observation seen;
  seen.position = {{0.2, 0.3}, 0}, seen.velocity = {{0, 0}, 0}, seen.heading = {0.0, 0};
  seen.robots = 2;
  seen.others[1].position = {{0.5, 0.5}, 0}, seen.others[1].lease_end_us = INT64_MAX;
  const long before = allocations;
  for (SafeController<Twist>* controller :
       {static_cast<SafeController<Twist>*>(&retreat), static_cast<SafeController<Twist>*>(&route),
        static_cast<SafeController<Twist>*>(&yield)}) {
    controller->engage(seen);
    for (int i = 0; i < 60; ++i) {
      seen.now_us += 100'000;
      seen.position.stamp_us = seen.velocity.stamp_us = seen.heading.stamp_us = seen.now_us;
      (void)controller->command(seen, i % 5 == 0 ? Gate::away_only : Gate::hold);
    }
  }
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace rtac
