// What a decision costs in fleets of several sizes: robots on a square grid, a few metres apart,
// each heard a moment ago. Who is far off is left out before it is looked at closely.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "closed_of_128_kernel.h"
#include "closed_of_2_kernel.h"
#include "closed_of_32_kernel.h"
#include "closed_of_8_kernel.h"
#include "tests/bench/benchmarks.h"

namespace rtac::bench {
namespace {

constexpr std::int64_t period_us = 50'000, apart_mm = 4'000, spread_mm = 700, speed_mmps = 900;
constexpr int steps = 4'000;

template <class Point>
void put(Point& p, std::int64_t x, std::int64_t y, std::int64_t stamp_us) {
  p.x_lo = p.x_hi = x;
  p.y_lo = p.y_hi = y;
  p.stamp_us = stamp_us;
  p.valid = 1;
}

// Number j of a square grid, off its knot by some of the spread, in steps of a fixed sequence.
template <class Point>
void place(Point& position, Point& velocity, int j, int columns, std::int64_t stamp_us) {
  const std::int64_t x = (j % columns) * apart_mm + (j * 389) % spread_mm;
  const std::int64_t y = (j / columns) * apart_mm + (j * 173) % spread_mm;
  put(position, x, y, stamp_us);
  put(velocity, (j * 211) % (2 * speed_mmps) - speed_mmps, (j * 97) % speed_mmps, stamp_us);
}

// ns a step, for a robot in the middle of the fleet.
template <class In, class Out, class State, class Init, class Step>
double step_ns(int robots, const Init& init, const Step& step) {
  const auto in = std::make_unique<In>();
  const auto out = std::make_unique<Out>();
  const auto state = std::make_unique<State>();
  std::memset(in.get(), 0, sizeof *in);
  init(state.get());
  const int columns = static_cast<int>(std::ceil(std::sqrt(robots)));
  in->self = robots / 2;
  std::chrono::nanoseconds spent{0};
  for (int k = 0; k < steps; ++k) {
    const std::int64_t now_us = 10'000'000 + k * period_us;
    place(in->position, in->velocity, in->self, columns, now_us - 5'000);
    for (int j = 0; j < robots; ++j) {
      auto& o = in->others[j];
      place(o.position, o.velocity, j, columns, now_us - 20'000);
      o.lease_end_us = INT64_MIN;
    }
    const auto from = std::chrono::steady_clock::now();
    step(state.get(), in.get(), now_us, out.get());
    spent += std::chrono::steady_clock::now() - from;
  }
  return static_cast<double>(spent.count()) / steps;
}

#define RTAC_FLEET(count)                                                         \
  step_ns<closed_of_##count##_drive_in, closed_of_##count##_drive_out,            \
          closed_of_##count##_drive_state>(count, closed_of_##count##_drive_init, \
                                           closed_of_##count##_drive_step)

}  // namespace

bool measure_fleets(const Effort& effort, Report& report) {
  report.section("Decision step in a fleet on a grid of 4 m: separation from all others");
  const int sizes[] = {2, 8, 32, 128};
  std::vector<double> times[4];
  for (int round = 0; round < effort.step_rounds; ++round) {
    times[0].push_back(RTAC_FLEET(2));
    times[1].push_back(RTAC_FLEET(8));
    times[2].push_back(RTAC_FLEET(32));
    times[3].push_back(RTAC_FLEET(128));
  }
  for (int i = 0; i < 4; ++i) {
    const std::string size = std::to_string(sizes[i]);
    report.add("fleet_" + size + "_ns", size + " robots", spread_of(times[i]), "ns/step", 0);
    std::vector<double> each;
    for (const double ns : times[i]) each.push_back(ns / (sizes[i] - 1));
    report.add("fleet_" + size + "_robot_ns", "  for each other robot", spread_of(each), "ns", 1);
  }
  std::vector<double> growth;
  for (std::size_t k = 0; k < times[0].size(); ++k) growth.push_back(times[3][k] / times[1][k]);
  const Spread grown = spread_of(growth);
  constexpr double linear = 127.0 / 7;  // in the others
  report.add("fleet_growth", "128 robots / 8 robots (linear: 18)", grown, "x", 2);
  if (grown.median < linear) return true;
  std::fputs("rtac_bench: the step of a fleet takes time in proportion to its robots\n", stderr);
  return false;
}

}  // namespace rtac::bench
