// Blocks that stand free on the ground: what a retreat in space keeps off them on its way out of
// what its zone leaves out around them (docs/templates.md, in space).
#pragma once

#include "compiler/analysis/straight_in.h"
#include "compiler/geometry/solid.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// Whether the ways of the step from where it starts, outside of its zone, come nearer to the
// boundary of the fence than where they begin, or than `asked_mm` beyond the body, by no more than
// the hold has room for. The zone lies in the fence, and who starts has as much of it. false also
// where that is not known.
bool leads_off_blocks(const TakeOver& at, const ir::Recovery& step, ir::ZoneIndex fence,
                      std::int64_t asked_mm, const geometry::Solid& starts);

}  // namespace rtac::analysis
