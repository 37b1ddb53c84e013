// Sizes of declared quantities that the integers of a kernel, and the arithmetic that derives
// them, can hold. Everything later trusts that these checks passed.
#pragma once

#include "compiler/analysis/trials.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

void check_magnitudes(const sema::Spec& spec, Trials* trials, diag::Engine& diagnostics);

}  // namespace rtac::analysis
