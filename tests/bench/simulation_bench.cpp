// How much faster than the world a simulated shift runs: with everything that decides, without
// decisions, and bare.
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "tests/bench/benchmarks.h"
#include "tests/bench/shift.h"
#include "tests/campaign/kills.h"

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

// Of the children that have ended.
double children_s() {
  rusage used{};
  ::getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

// `rtac sim`, a batch of attacks of 10 s each on a fence with one robot, in robot-hours per second.
// What it takes to compile the kernel is in a short batch as well as in a long one.
bool batch_hours_per_s(double& result) {
  constexpr int few = 100, many = 2100;
  constexpr double hours = (many - few) * 10.0 / 3600;
  const campaign::Row row{"", "templates/retreat_point", "", 0, "templates/point.json"};
  double spent_s[2] = {};
  for (const int runs : {few, many}) {
    const double from_s = children_s();
    const campaign::Attack attack = campaign::attack(row, "", runs);
    if (attack.status != 0) {
      std::fprintf(stderr, "rtac_bench: a batch of attacks did not run to its end: %s\n",
                   attack.said.c_str());
      return false;
    }
    spent_s[runs == many] = children_s() - from_s;
  }
  result = hours / (spent_s[1] - spent_s[0]);
  return true;
}

bool measure_batch(int repetitions, Report& report) {
  std::vector<double> decided, undecided, ratio;
  for (int i = 0; i < repetitions; ++i) {
    double with = 0, without = 0;
    if (!batch_hours_per_s(with)) return false;
    ::setenv("RTAC_SIM", RTAC_BENCH_UNDECIDED, 1);
    const bool ran = batch_hours_per_s(without);
    ::unsetenv("RTAC_SIM");
    if (!ran) return false;
    decided.push_back(with);
    undecided.push_back(without);
    ratio.push_back(with / without);
  }
  report.add("simulation_batch", "rtac sim: attacks on a decision and its retreat, in a batch",
             spread_of(decided), "robot-hours/s", 3);
  report.add("simulation_batch_undecided", "the same attacks without the decision",
             spread_of(undecided), "robot-hours/s", 3);
  report.add("simulation_batch_ratio", "in the loop / without the decision", spread_of(ratio), "x",
             3);
  return true;
}

}  // namespace

bool measure_simulation(const Effort& effort, Report& report) {
  const double robot_hours = robot_count * effort.shift_minutes / 60;
  std::vector<double> full, undecided, bare, ratio, share;
  for (int i = 0; i < effort.shift_repetitions; ++i) {
    const auto seed = static_cast<std::uint64_t>(i + 1);
    double f = 0, u = 0, b = 0;
    const auto minutes = effort.shift_minutes;
    if (!hours_per_s(
            robot_hours, [&] { return run_shift(seed, minutes, nullptr); }, f) ||
        !hours_per_s(
            robot_hours, [&] { return run_undecided(seed, minutes); }, u) ||
        !hours_per_s(
            robot_hours, [&] { return run_bare(seed, minutes); }, b)) {
      std::fputs("rtac_bench: a simulated shift did not run to its end\n", stderr);
      return false;
    }
    full.push_back(f);
    undecided.push_back(u);
    bare.push_back(b);
    ratio.push_back(f / u);
    share.push_back(f / b);
  }
  char title[120];
  std::snprintf(title, sizeof title, "Simulation, one core: 2 robots, shifts of %.0f minutes",
                effort.shift_minutes);
  report.section(title);
  report.add("simulation_full", "decisions, recoveries and planners in the loop", spread_of(full),
             "robot-hours/s", 3);
  report.add("simulation_undecided", "the same controllers and planners without decisions",
             spread_of(undecided), "robot-hours/s", 3);
  report.add("simulation_bare", "bare simulator: motion, sensing, radio", spread_of(bare),
             "robot-hours/s", 3);
  report.add("simulation_ratio", "in the loop / without decisions", spread_of(ratio), "x", 3);
  report.add("simulation_share", "in the loop / bare", spread_of(share), "x", 3);
  return measure_batch(effort.shift_repetitions, report);
}

}  // namespace rtac::bench
