// What monitors say of other robots, and whether all of them together keep it.
#pragma once

#include <vector>

#include "compiler/analysis/decided.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// 6003, of what another robot may break that passes its own check: a monitor keeps what is a
// condition of each pair, the same seen from either robot, since whoever of the two moves checks
// it. A count, `exists` and an `or` with something that one of the two has to itself are none.
std::vector<diag::Diagnostic> unkept_company(const ir::Decision& decision);

// Whether robots that pass their own checks, or agents, may break what a monitor says whatever a
// robot does that this recovery drives: what 6003 and 6004 are about, acknowledged or not.
bool others_may_break(const ir::Decision& decision, const ir::Monitor& monitor,
                      const ir::Recovery& drives);

// 6004, of each monitor that speaks of agents: they obey no decision, so that what it says is kept
// while the robot moves, and nobody keeps it while that stands, unless who stands is slow enough.
std::vector<diag::Diagnostic> unkept_agents(const Decided& of);

}  // namespace rtac::analysis
