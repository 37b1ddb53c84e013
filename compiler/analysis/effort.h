// What it takes to try a specification once, so that what is offered hangs neither on the machine
// nor on what else that does.
#pragma once

#include <cstdint>

#include "compiler/ir/module.h"

namespace rtac::analysis {

// In steps of some 7 to 20 us: what is looked at of each cell that a recovery drives over; and,
// where zones are evaluated anew, of each edge from each cell.
std::int64_t effort_of(const ir::Module& module, bool same_zones);
// Besides, of edges that were looked at and overlaid meanwhile (geometry/looks.h): where ways lead
// around many corners of a zone, more than of its cells.
std::int64_t effort_of_looks(std::int64_t looks);
// Besides, of the pairs of cells that are looked at where robots make room, once it is asked what
// is shown.
std::int64_t effort_of_pairs(const ir::Module& module);

}  // namespace rtac::analysis
