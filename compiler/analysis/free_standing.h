// Blocks that stand free on the ground: what a retreat in space keeps off them on its way out of
// what its zone leaves out around them (docs/templates.md, in space).
#pragma once

#include <cstdint>
#include <string>

#include "compiler/analysis/straight_in.h"
#include "compiler/geometry/solid.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// What it takes for ways back within a zone, from where robots start outside of it, to come nearer
// to the boundary of the fence than where they begin, or than `asked_mm` beyond the body, by no
// more than the hold has room for: "`away` has to go on for 6.2 m around the block". "": they do.
// The zone lies in the fence, and who starts has as much of it.
std::string missing_off_blocks(const TakeOver& at, ir::ZoneIndex within, ir::ZoneIndex fence,
                               std::int64_t asked_mm, const geometry::Solid& starts);

}  // namespace rtac::analysis
