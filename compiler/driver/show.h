// Runs that show what `rtac verify` has refuted.
#pragma once

#include "compiler/driver/compile.h"
#include "compiler/driver/options.h"
#include "compiler/driver/sim.h"
#include "compiler/verify/obligation.h"

namespace rtac::driver {

// For each refuted obligation that is about robots in motion, runs that are aimed at it: from the
// place that it names, or from where little is left to a recovery. The first one that shows it is
// written for `rtac sim SPEC --replay`, and named in the report. It ends in bounded time.
void show(const Options& options, Simulator& simulator, Compilation& c, verify::Report& report);

// How long runs are sought, of all obligations together, in core seconds.
double attack_core_s(const Options& options);

// The same, where nothing can be simulated: why there is no run.
void leave_unshown(verify::Report& report, const std::string& why);

// What only a run can refute, and none has, is unknown: that a recovery is not shown to keep what
// another monitor says may be the fault of the bounds.
void leave_open(verify::Report& report);

}  // namespace rtac::driver
