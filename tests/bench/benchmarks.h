// The nine groups of `./dev bench`. Each adds its rows; false: it could not measure, and said why
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
  std::size_t zone_places = 4'000;  // of either kind
  double zone_pass_ms = 10;         // about so long at most
  int zone_cold_questions = 15;
  std::size_t zone_shapes = 3;  // of outlines
  int share_seconds = 600;      // of each of four runs
};

// The study whose step is measured, of those that its program is built with.
struct StepSubject {
  const char *key, *title, *target;  // of the rows; the ratio that is wanted
};
bool measure_steps(const StepSubject& subject, const Effort& effort, Report& report);
bool measure_hundred(const Effort& effort, Report& report);  // in a program of its own
bool measure_fleets(const Effort& effort, Report& report);
bool measure_simulation(const Effort& effort, Report& report);
bool measure_watch(const Effort& effort, Report& report);
bool measure_compiler(const Effort& effort, Report& report);
bool measure_geometry(const Effort& effort, Report& report);
bool measure_zone_kernels(const Effort& effort, Report& report);  // a part of it
bool measure_zones(const Effort& effort, Report& report);
bool measure_kills(const Effort& effort, Report& report);
bool measure_shares(const Effort& effort, Report& report);

}  // namespace rtac::bench
