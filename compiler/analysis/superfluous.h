// Acknowledgements that accept what does not happen.
#pragma once

#include "compiler/analysis/arbitration.h"
#include "compiler/analysis/decided.h"

namespace rtac::analysis {

// 6008: without it nothing would be reported, and the recovery is shown to keep the monitor,
// whoever it drives for. What is kept because another monitor takes over, or is not shown at all,
// is none. Of the recovery of the monitor itself it accepts other things, too (5030 and on), but
// where the monitor asks for nothing but places, or charge.
void check_acknowledgements(const sema::Spec& spec, const ir::Module& module,
                            const ExactZone& exact, const ExactSolid& solid, const HowItLies& lies,
                            diag::Engine& diagnostics);

// Whether a monitor speaks of charge and of clearances alone, of zones that are always there, and
// retreats or goes to a site: all that an acknowledgement of its own recovery can accept then is
// P2a and P2b.
bool leads_back_to_places(const ir::Monitor& monitor);

}  // namespace rtac::analysis
