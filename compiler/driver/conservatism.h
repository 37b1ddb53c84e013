// How much of what monitors keep free the worst motion needs, as `rtac-sim` measures it.
#pragma once

#include <string>

#include "compiler/driver/compile.h"
#include "compiler/driver/sim.h"
#include "compiler/verify/obligation.h"

namespace rtac::driver {

// More than all of it refutes P3 of the monitor, unless its look-ahead is declared unsound. What
// could not be measured is said to be so.
void measure_conservatism(Simulator& simulator, Compilation& c, verify::Report& report);

// Says of every monitor why it was not measured.
void leave_unmeasured(verify::Report& report, const std::string& why);

}  // namespace rtac::driver
