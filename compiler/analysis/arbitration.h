// Whether the recovery of one monitor keeps what another one says (theory, arbitration: the matrix
// C[i][j]; language rule 12). Several monitors share one output, so that whoever drives decides for
// all of them.
#pragma once

#include <string>
#include <vector>

#include "compiler/analysis/recoveries.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

enum class Keeping {
  kept,     // by the recovery itself, braking in and standing included
  guarded,  // the other monitor ranks higher: it is judged under the recovery's own motion in every
            // tick, and its recovery takes over in time
  broken,   // the other monitor ranks lower, and the recovery may lead to where it is false
};
struct Entry {
  Keeping keeping = Keeping::kept;
  std::string why;   // in words, with numbers
  std::string help;  // of what is broken: what would work
};
// One row for the recovery of each monitor, one column for the property of each.
using Arbitration = std::vector<std::vector<Entry>>;

Arbitration arbitration_of(const sema::RobotKind& kind, const ir::Module& module,
                           const ir::Decision& decision, const ExactZone& exact);

// 6005: a recovery that breaks what a monitor below it says, unless that is acknowledged.
void check_arbitration(const sema::Spec& spec, const ir::Module& module, const ExactZone& exact,
                       diag::Engine& diagnostics);

}  // namespace rtac::analysis
