// Starts as the decisions see them: with enough charge, or from which little is left to a recovery.
#pragma once

#include "kernel.h"
#include "run.h"

namespace rtac::simulate {

// Charges the batteries that were drawn, not those that the scenario fixes, as far as the monitors
// of charge ask for: they know what the ways over cells take, while places were drawn by what the
// straight one does.
void charge(const DecisionCase& decision, const Kernel::Functions& kernel, const Scenario& scenario,
            Setup& setup);
// Moves the first robot as close to the second one, and empties the batteries as far, as the
// decisions still hand control over at rest, or, where the scenario asks for that, batteries of
// some robots alone. What does not matter to them stays.
void tighten(const DecisionCase& decision, const Kernel::Functions& kernel,
             const Scenario& scenario, Setup& setup);

}  // namespace rtac::simulate
