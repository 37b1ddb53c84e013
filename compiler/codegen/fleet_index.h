// Fleets: robots that are far off are left out before they are looked at closely.
#pragma once

#include "compiler/ir/module.h"

namespace rtac::codegen {

// Does the decision judge other robots by nothing but that each keeps a distance? Then one far
// beyond the nearest changes no margin. False where there are few: looking costs more than it
// saves.
bool leaves_far_out(const ir::Decision& decision);

}  // namespace rtac::codegen
