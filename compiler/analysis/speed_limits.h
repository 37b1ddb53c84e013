// Limits of speed: whether recoveries keep them, and whether control can come back.
#pragma once

#include <vector>

#include "compiler/analysis/decided.h"
#include "compiler/diagnostics/engine.h"

namespace rtac::analysis {

// 5033, of each comparison that asks for at most some speed.
std::vector<diag::Diagnostic> unkept_speed_limits(const Decided& of);

}  // namespace rtac::analysis
