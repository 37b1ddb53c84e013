// C code between `rtac-sim` and the decisions of a kernel, whose names and layouts depend on the
// specification: all goes through words of 64 bits, whose order stands in
// runtime/adapters/simulate/kernel_words.h.
#pragma once

#include <string>
#include <vector>

#include "compiler/driver/decision_engine.h"

namespace rtac::driver {

// Raised whenever the words change their meaning; `rtac-sim` refuses another one.
inline constexpr int sim_words_version = 6;

// Of decision K: `rtac_sim_state_bytes_K`, `rtac_sim_in_words_K`, `rtac_sim_out_words_K`,
// `rtac_sim_init_K(state)` and `rtac_sim_step_K(state, in, now_us, out)`. `source`: name of the
// kernel's .c file.
std::string sim_glue(const std::vector<DecisionInterface>& decisions, const std::string& source);

}  // namespace rtac::driver
