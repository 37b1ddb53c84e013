// The five groups of `./dev bench`. Each adds its rows; false: it could not measure, and said why
// on the error stream.
#pragma once

#include "tests/bench/report.h"

namespace rtac::bench {

struct Effort {
  int step_rounds = 9;  // of the whole recorded stream
  int shift_repetitions = 3;
  double shift_minutes = 12;
  int compile_repetitions = 5;
  int zone_rounds = 5;
  std::size_t zone_places = 10'000;  // of either kind
  int zone_cold_questions = 25;
  std::size_t zone_shapes = 3;  // of outlines
};

bool measure_steps(const Effort& effort, Report& report);
bool measure_simulation(const Effort& effort, Report& report);
bool measure_watch(const Effort& effort, Report& report);
bool measure_compiler(const Effort& effort, Report& report);
bool measure_zones(const Effort& effort, Report& report);
bool measure_zone_queries(const Effort& effort, Report& report);  // a part of it

}  // namespace rtac::bench
