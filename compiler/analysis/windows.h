// Zones that come and go, in monitors of robots: whether their recovery leads out in time, and how
// long that takes (ADR 0012).
#pragma once

#include <functional>

#include "compiler/analysis/trials.h"
#include "compiler/analysis/zones.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

struct WindowTables {
  // The zone of a table, as it was evaluated.
  std::function<const EvaluatedZone&(ir::ZoneIndex)> zone;
  // The longest way off its cells that a recovery finds, by the width of the cells, in mm.
  std::function<std::int32_t(std::int32_t)> connector_mm;
};

// Sets `leave_us`, `leave_least_mm` and `leave_beside_mm` of the recoveries of monitors that speak
// of such zones; reports 5030, 5031 and 5032, with places that `trials` has found to work. Needs
// the clearances of the recoveries. false: some way out is not known, nor what it takes.
bool plan_windows(const sema::Spec& spec, const sema::Decision& from, const ir::Module& module,
                  ir::Decision& decision, const WindowTables& tables, Trials* trials,
                  diag::Engine& diagnostics);

// Whether this 5030 is of a way that leads out, and ends where control is not given back: that the
// property fails there is not said.
bool ends_near_window(const diag::Diagnostic& d);

// Whether a property speaks of a zone that is there at certain times.
bool has_windows(const ir::Block& property);
bool speaks_of_windows(const ir::Block& block, ir::ValueId id);  // of a part of it

}  // namespace rtac::analysis
