// Whether the recoveries of a decision have a place to hand control back at.
#pragma once

#include <vector>

#include "compiler/analysis/decided.h"
#include "compiler/diagnostics/engine.h"

namespace rtac::analysis {

// 5007: a zone that a monitor retreats within has the clearance nowhere at which all monitors of
// the decision hand back. Named is the monitor that asks for it, which need not be the one that
// retreats, with the longest look-ahead, the largest standoff or the width that works.
std::vector<diag::Diagnostic> empty_return_sets(const Decided& of);

// Longest look-ahead (us, whole ms) whose return clearance fits into `widest_mm`; 0: none.
std::int64_t lookahead_max_us(const ir::Decision& decision, std::int64_t widest_mm,
                              std::int64_t standoff_mm);

}  // namespace rtac::analysis
