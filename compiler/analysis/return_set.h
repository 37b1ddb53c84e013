// Whether the recoveries of a decision have a place to hand control back at.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/analysis/across.h"
#include "compiler/analysis/decided.h"
#include "compiler/diagnostics/engine.h"

namespace rtac::analysis {

// The greatest clearance of the zone at which the last step of a recovery can hand back, in mm: a
// retreat of the plane finds its ways over cells, of which one has to be so clear as a whole.
std::int64_t room_mm(const ir::Decision& decision, const ir::Recovery& last,
                     const ir::ZoneTable& zone);
// So much more of it a cell needs for a proof that the recheck finds again, where some edge of the
// zone is slanted: it knows clearances to 4 mm.
inline constexpr std::int64_t recheck_misses_mm = 5;

// 5007: a zone that a monitor retreats within has the clearance nowhere at which all monitors of
// the decision hand back. Named is the monitor that asks for it, which need not be the one that
// retreats, with the longest look-ahead, the largest standoff or the width that works.
std::vector<diag::Diagnostic> empty_return_sets(const Decided& of, const ExactZones& exact);

// Longest look-ahead (us, whole ms) whose return clearance fits into `room_mm`; 0: none.
std::int64_t lookahead_max_us(const ir::Decision& decision, std::int64_t room_mm,
                              std::int64_t standoff_mm);

}  // namespace rtac::analysis
