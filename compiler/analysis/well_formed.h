// Checks that the derived numbers work out, and computes what would work when they do not.
#pragma once

#include "compiler/analysis/across.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/trials.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"
#include "compiler/ir/table_map.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// Every fence leaves a place where control can be given back; every site lies in its zone, can be
// reached along the cells of its route, and is a place where control can be given back.
void check_well_formed(const sema::Spec& spec, const ir::Module& module, const ir::TableMap& tables,
                       const ExactZones& exact, const HowItLies& lies, Trials* trials,
                       diag::Engine& diagnostics);

}  // namespace rtac::analysis
