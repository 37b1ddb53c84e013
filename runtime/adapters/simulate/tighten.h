// Starts from which little is left to a recovery.
#pragma once

#include "kernel.h"
#include "run.h"

namespace rtac::simulate {

// Moves the first robot as close to the second one, and empties the batteries as far, as the
// decisions still hand control over at rest. What does not matter to them stays.
void tighten(const DecisionCase& decision, const Kernel::Functions& kernel, Setup& setup);

}  // namespace rtac::simulate
