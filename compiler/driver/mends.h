// What is offered as it has been verified to mend what is open.
#pragma once

#include "compiler/driver/compile.h"
#include "compiler/verify/obligation.h"

namespace rtac::driver {

// Of each obligation that is not shown: tries what may mend it, one by one, each by building and
// verifying the specification anew, and offers the first one with which nothing is left that was
// not left without it. Asks the model checker.
void offer_mends(Compilation& c, verify::Report& report);

}  // namespace rtac::driver
