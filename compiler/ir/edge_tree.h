// What the kernel relies on when it looks a place up in a tree of cells.
#pragma once

#include <cstddef>

#include "compiler/ir/module.h"

namespace rtac::ir {

// Every word leads to edges, to lists or to parts that are there, and a place passes `depth`
// divisions at most; there are no more than `leaves` cells. A zone of a few edges needs no tree.
bool leads_to_edges(const EdgeTree& tree, std::size_t edges);

}  // namespace rtac::ir
