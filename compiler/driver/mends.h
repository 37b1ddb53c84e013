// What is offered as it has been verified to mend what is open.
#pragma once

#include <functional>

#include "compiler/driver/compile.h"
#include "compiler/verify/obligation.h"

namespace rtac::driver {

// Plays what runs alone can refute of a report, as `rtac verify` does, of a specification that was
// built anew.
using PlayAnew = std::function<void(BuiltAnew& built, verify::Report& report)>;

// Of each obligation that is not shown: tries what may mend it, one by one, and two together, by
// building and verifying the specification anew, and offers the first with which nothing is left
// that was not left without it. Asks the model checker, and of what is declared plays runs.
void offer_mends(Compilation& c, const PlayAnew& play, verify::Report& report);

}  // namespace rtac::driver
