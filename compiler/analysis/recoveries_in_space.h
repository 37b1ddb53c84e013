// Recoveries of robots in space against what their monitors need: a retreat stays where the
// property holds, heights included, and the way straight down of a landing does, too.
#pragma once

#include <functional>
#include <optional>

#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/trials.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/geometry/solid.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// The exact zone of a table: one with height, or one of the plane as all of its heights.
using ExactSolid = std::function<geometry::Solid(ir::ZoneIndex)>;

// A zone of the plane, from as far down to as far up as coordinates go.
geometry::Solid without_end(const geometry::Region& region);

// What is wrong with the recovery of the monitor, if anything; `written`: that monitor.
std::optional<diag::Diagnostic> misplaced_in_space(
    const sema::Monitor& written, const ir::Module& module, const ir::Decision& decision,
    const ir::Monitor& monitor, const ExactZone& flat, const ExactSolid& exact, Trials* trials);

// Of a landing that is refused (5034), that the property holds where it is meant to end: it need
// not be broken.
bool lands_near_the_limit(const diag::Diagnostic& report);

}  // namespace rtac::analysis
