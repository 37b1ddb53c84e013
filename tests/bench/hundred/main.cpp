// rtac_bench_hundred ROUNDS MINUTES: the decision step with a fence of 100 vertices, as lines for
// rtac_bench. The rows for people go to the error stream as they come.
#include <cstdlib>
#include <iostream>

#include "tests/bench/benchmarks.h"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  rtac::bench::Effort effort;
  effort.step_rounds = std::atoi(argv[1]);
  effort.shift_minutes = std::atof(argv[2]);
  const rtac::bench::StepSubject fence{"hundred", "fence of 100 vertices with holes", "1.5"};
  rtac::bench::Report report;
  const bool good = rtac::bench::measure_steps(fence, effort, report);
  std::cout << report.lines();
  return good ? 0 : 1;
}
