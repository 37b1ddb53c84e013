// Whether a monitor may be engaged without end, wherever its recovery leads: what others do, and
// what inputs say, takes its time.
#pragma once

#include <string>

#include "compiler/ir/module.h"

namespace rtac::analysis {

// What it lets go after, as in "lets go when ...", that no recovery brings about; "": nothing. Of
// an `or` that is so of both sides only, since the recovery may lead to the other one (P2b).
std::string waits_until(const ir::Block& property);

// Whether it may wait for what no decision has a hand in: inputs, agents, or a zone that is
// received. These may stay as they are for ever.
bool waits_for_outsiders(const ir::Block& property);

// Whether it waits for inputs, or for the ages of samples.
bool waits_for_inputs(const ir::Block& property);

}  // namespace rtac::analysis
