// Acknowledgements that accept what does not happen.
#pragma once

#include "compiler/analysis/arbitration.h"
#include "compiler/analysis/decided.h"

namespace rtac::analysis {

// 6008: without it nothing would be reported, and the recovery is shown to keep the monitor,
// whoever it drives for. What is kept because another monitor takes over, or is not shown at all,
// is none, and so is the recovery of the monitor itself: there it accepts other things (5030 and
// on).
void check_acknowledgements(const sema::Spec& spec, const ir::Module& module,
                            const ExactZone& exact, const ExactSolid& solid, const HowItLies& lies,
                            diag::Engine& diagnostics);

}  // namespace rtac::analysis
