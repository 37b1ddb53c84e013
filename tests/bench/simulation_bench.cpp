// How much faster than the world a simulated shift runs: with everything that decides, and bare.
#include <cstdio>
#include <ctime>
#include <vector>

#include "tests/bench/benchmarks.h"
#include "tests/bench/shift.h"

namespace rtac::bench {
namespace {

// Time of this process alone: the machine may have other work.
double processor_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

template <class Run>
bool hours_per_s(double robot_hours, const Run& run, double& result) {
  const double from = processor_s();
  if (!run()) return false;
  result = robot_hours / (processor_s() - from);
  return true;
}

}  // namespace

bool measure_simulation(const Effort& effort, Report& report) {
  const double robot_hours = robot_count * effort.shift_minutes / 60;
  std::vector<double> full, bare, ratio;
  for (int i = 0; i < effort.shift_repetitions; ++i) {
    const auto seed = static_cast<std::uint64_t>(i + 1);
    double f = 0, b = 0;
    const auto minutes = effort.shift_minutes;
    if (!hours_per_s(
            robot_hours, [&] { return run_shift(seed, minutes, nullptr); }, f) ||
        !hours_per_s(
            robot_hours, [&] { return run_bare(seed, minutes); }, b)) {
      std::fputs("rtac_bench: a simulated shift did not run to its end\n", stderr);
      return false;
    }
    full.push_back(f);
    bare.push_back(b);
    ratio.push_back(f / b);
  }
  char title[120];
  std::snprintf(title, sizeof title, "Simulation, one core: 2 robots, shifts of %.0f minutes",
                effort.shift_minutes);
  report.section(title);
  report.add("simulation_full", "decisions, recoveries and planners in the loop", spread_of(full),
             "robot-hours/s", 3);
  report.add("simulation_bare", "bare simulator: motion, sensing, radio", spread_of(bare),
             "robot-hours/s", 3);
  report.add("simulation_ratio", "in the loop / bare", spread_of(ratio), "x", 3);
  return true;
}

}  // namespace rtac::bench
