// The decision step with a fence of 100 vertices: the hand-written step looks at every edge, the
// kernel at those of a cell. Its kernel has the names of that of the study, so another program
// measures it.
#include <cstdio>
#include <string>

#include "tests/bench/benchmarks.h"

namespace rtac::bench {

bool measure_hundred(const Effort& effort, Report& report) {
  const std::string command = "'" RTAC_BENCH_HUNDRED "' " + std::to_string(effort.step_rounds) +
                              " " + std::to_string(effort.shift_minutes);
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return false;
  std::string lines;
  char buffer[4096];
  while (const std::size_t got = std::fread(buffer, 1, sizeof buffer, pipe)) {
    lines.append(buffer, got);
  }
  const bool good = pclose(pipe) == 0;
  if (!lines.empty() && report.add_lines(lines)) return good;
  std::fputs("rtac_bench: the step with a fence of 100 vertices was not measured\n", stderr);
  return false;
}

}  // namespace rtac::bench
