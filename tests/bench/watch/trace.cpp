#include "tests/bench/watch/trace.h"

#include <cmath>
#include <limits>

#include "rtac/sim/random.h"

namespace rtac::bench {
namespace {

constexpr std::int64_t patrol_period_us = 10'000, window_period_us = 1'000;
constexpr std::int64_t start_us = 1'000'000'000;
// Samples of charge and position come at their own rates.
constexpr int battery_every_ticks = 8, position_every_ticks = 4;

struct Scalar {
  double value = 0;
  std::int64_t stamp_us = 0;
  bool valid = true;
};

// The bits of `between` follow one another. What has no value, or is of another sample than the
// first number, is none.
template <class Sample>
void put(Sample& to, std::int64_t& number, const Scalar& from, double per_unit, int bit) {
  const double steps = from.value * per_unit;
  number = std::numeric_limits<std::int64_t>::min();
  if (!from.valid || from.stamp_us != to.stamp_us) return;
  number = static_cast<std::int64_t>(std::floor(steps));
  if (std::floor(steps) < steps) to.between |= 1U << bit;
}
template <class Sample>
void start(Sample& to, std::int64_t stamp_us) {
  to.stamp_us = stamp_us;
  to.valid = 1;
  to.between = 0;
}
template <class Point>
void put_point(Point& to, const Scalar* from) {
  start(to, from[0].stamp_us);
  put(to, to.x, from[0], 1'000, 0);
  put(to, to.y, from[1], 1'000, 1);
}

// What may happen to a sample; those that do not arrive leave the one before in place.
class Sampler {
 public:
  Sampler(sim::Random& random, bool faulty) : random_(random), faulty_(faulty) {}

  // Of the components of one input, `count` of them.
  void sample(Scalar* of, const double* values, int count, std::int64_t now_us) {
    const double fate = faulty_ ? random_.uniform() : 1;
    if (fate < 0.02) silent_until_us_ = now_us + 300'000;
    if (now_us < silent_until_us_) return;
    for (int k = 0; k < count; ++k) {
      of[k].value = values[k];
      of[k].stamp_us = now_us;
      of[k].valid = true;
    }
    if (fate < 0.02) return;
    if (fate < 0.03) of[count - 1].valid = false;
    if (fate >= 0.03 && fate < 0.04) of[0].value = 1e4;
    if (fate >= 0.04 && fate < 0.05) of[count - 1].stamp_us -= 1;
    if (fate >= 0.05 && fate < 0.06) {
      for (int k = 0; k < count; ++k) of[k].stamp_us = now_us + 5'000;
    }
  }

 private:
  sim::Random& random_;
  bool faulty_;
  std::int64_t silent_until_us_ = 0;
};

// Ticks are missed, now and then more than are made up for, or stepped twice. `how_often`: of them.
std::int64_t irregular_us(sim::Random& random, std::int64_t period_us, double how_often) {
  const double fate = random.uniform() / how_often;
  if (fate < 0.2) return 0;
  if (fate < 0.8) return period_us * (2 + static_cast<std::int64_t>(random.next() % 4));
  if (fate < 1) return period_us * (6 + static_cast<std::int64_t>(random.next() % 400));
  return period_us;
}

}  // namespace

PatrolTrace patrol_trace(std::uint64_t seed, int ticks, const Faults& faults) {
  sim::Random random(seed);
  Sampler charge(random, faults.samples), here(random, faults.samples), there = here;
  PatrolTrace trace;
  Scalar battery, first[2], second[2];
  std::int64_t now_us = start_us;
  for (int i = 0; i < ticks; ++i) {
    const double turn = 2 * 3.141592653589793 * i / 256;
    // between full and below the reserve; in and out of the box; near to each other and far
    const double percent = 55 + 41 * std::sin(turn);
    const double at[2] = {2.5 + 2.7 * std::cos(turn * 1.5), 2.5 + 2.4 * std::sin(turn * 2)};
    const double other[2] = {2.5 + 2.7 * std::cos(turn * 1.5 + 0.4),
                             2.5 + 2.4 * std::sin(turn * 3)};
    if (i % battery_every_ticks == 0) charge.sample(&battery, &percent, 1, now_us);
    if (i % position_every_ticks == 0) {
      here.sample(first, at, 2, now_us);
      there.sample(second, other, 2, now_us);
    }
    const auto fill = [&](auto& in) {
      start(in.battery, battery.stamp_us);
      put(in.battery, in.battery.value, battery, 10'000, 0);
      put_point(in.first, first);
      put_point(in.second, second);
    };
    trace.now_us.push_back(now_us);
    fill(trace.kernel.emplace_back());
    fill(trace.hand.emplace_back());
    trace.naive.push_back(
        {battery.value, first[0].value, first[1].value, second[0].value, second[1].value});
    now_us += faults.ticks ? irregular_us(random, patrol_period_us, 0.02) : patrol_period_us;
  }
  trace.length_us = now_us - start_us;
  return trace;
}

void next_round(PatrolTrace& trace) {
  const auto move = [&](auto& in) {
    in.battery.stamp_us += trace.length_us;
    in.first.stamp_us += trace.length_us;
    in.second.stamp_us += trace.length_us;
  };
  for (std::int64_t& now_us : trace.now_us) now_us += trace.length_us;
  for (auto& in : trace.kernel) move(in);
  for (auto& in : trace.hand) move(in);
}

std::vector<WindowTick> window_trace(std::uint64_t seed, int ticks, const Faults& faults) {
  sim::Random random(seed);
  std::vector<WindowTick> trace;
  std::int64_t now_us = start_us;
  for (int i = 0; i < ticks; ++i) {
    WindowTick tick{now_us, random.uniform() < 0.002 ? 0 : 1, random.uniform() < 0.002 ? 1 : 0};
    if (faults.samples && random.uniform() < 0.003) tick.calm = missing;
    if (faults.samples && random.uniform() < 0.003) tick.alarm = missing;
    trace.push_back(tick);
    now_us += faults.ticks ? irregular_us(random, window_period_us, 0.001) : window_period_us;
  }
  return trace;
}

}  // namespace rtac::bench
