// What lets recoveries that take over from each other for ever come to an end.
#pragma once

#include "compiler/driver/compile.h"
#include "compiler/verify/obligation.h"

namespace rtac::driver {

// Of each *switching* that is not shown as recoveries take turns: tries what may mend it, one by
// one, each by building and verifying the specification anew, and offers the first one with which
// nothing is left that was not left without it. Asks the model checker.
void offer_end_of_turns(Compilation& c, verify::Report& report);

}  // namespace rtac::driver
