// What `rtac verify` prints.
#pragma once

#include <string>

#include "compiler/verify/obligation.h"

namespace rtac::verify {

// One line for each obligation, the matrix of arbitration, and how many there are of each status.
std::string to_text(const Report& report);
// The same with the claims; without times it is the same in every run.
std::string to_json(const Report& report, bool with_times);

}  // namespace rtac::verify
