// Blocks that stand free on the ground: what a retreat in space keeps off them on its way out of
// what its zone leaves out around them (docs/templates.md, in space).
#pragma once

#include "compiler/analysis/straight_in.h"
#include "compiler/geometry/solid.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// Whether ways back within a zone, from where robots start outside of it, come nearer to the
// boundary of the fence than where they begin, or than `asked_mm` beyond the body, by no more than
// the hold has room for. The zone lies in the fence, and who starts has as much of it. false also
// where that is not known.
bool leads_off_blocks(const TakeOver& at, ir::ZoneIndex within, ir::ZoneIndex fence,
                      std::int64_t asked_mm, const geometry::Solid& starts);

}  // namespace rtac::analysis
