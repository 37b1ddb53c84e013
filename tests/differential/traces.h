// Random runs over the inputs of generator.h: values at and around limits, outside of ranges, not
// numbers; samples that are missing, old, from the future or out of order; ticks that are late,
// early, missed or judged twice; parameters that tighten, and attempts to loosen them.
#pragma once

#include <cstdint>
#include <random>

#include "tests/differential/engines.h"
#include "tests/differential/generator.h"

namespace rtac::differential {

// How often each kind of trouble occurred.
struct Troubles {
  std::size_t not_a_number = 0, missing = 0, old = 0, future = 0, backwards = 0, out_of_range = 0,
              at_limit = 0, missed_ticks = 0, forgotten = 0, twice = 0, tightened = 0, loosened = 0,
              beyond_range = 0;
};
// A new one, which restarts what was before.
Steps random_run(std::mt19937& random, std::size_t steps, const std::vector<Signal>& signals,
                 const std::vector<sema::Param>& params, Troubles& troubles);
// Several, one behind the other.
Steps random_runs(std::uint32_t seed, std::size_t runs, std::size_t steps, const sema::Spec& spec,
                  Troubles& troubles);

}  // namespace rtac::differential
