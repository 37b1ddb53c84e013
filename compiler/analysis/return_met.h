// Whether what a monitor asks for in `return when` comes about where its recovery has led: else the
// monitor stays engaged, whoever ranks below it waits, and charge is spent without end.
#pragma once

#include "compiler/analysis/arbitration.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// Fills `returns` of every monitor of the decisions with a period. Before recoveries are
// checked.
void judge_return_conditions(ir::Module& module, const ExactZone& exact, const ExactSolid& solid);

}  // namespace rtac::analysis
