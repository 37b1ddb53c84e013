// Whether the properties of a decision leave a place in common where control can be handed back
// (theory, arbitration: joint return).
#pragma once

#include <optional>

#include "compiler/analysis/decided.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/diagnostics/engine.h"

namespace rtac::analysis {

// 5007, of the first monitor that leaves none together with those before it. In the plane.
std::optional<diag::Diagnostic> apart_for_ever(const Decided& of, const ExactZone& exact);
// Whether a report is that one.
bool is_apart_for_ever(const diag::Diagnostic& report);

}  // namespace rtac::analysis
