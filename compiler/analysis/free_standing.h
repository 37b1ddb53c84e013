// Blocks that stand free on the ground: what a retreat in space keeps off them on its way out of
// what its zone leaves out around them (docs/templates.md, in space).
#pragma once

#include "compiler/analysis/straight_in.h"
#include "compiler/geometry/solid.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// Whether the ways of the step from where it starts, outside of its zone, come no nearer to the
// boundary of the fence, by more than the hold has room for, than they begin or than `asked_mm`
// beyond the body. The zone lies in the fence; each place in `starts` has that of a block. false
// also where that is not known.
bool leads_off_blocks(const TakeOver& at, const ir::Recovery& step, ir::ZoneIndex fence,
                      std::int64_t asked_mm, const geometry::Solid& starts);

}  // namespace rtac::analysis
