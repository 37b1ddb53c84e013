// From checked monitors without a robot to their IR.
#pragma once

#include <optional>

#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"
#include "compiler/ir/signals.h"
#include "compiler/ir/table_map.h"
#include "compiler/sema/spec.h"
#include "compiler/support/source.h"

namespace rtac::ir {

// Input: a checked specification, all of its signals, the zones that places are held against, and
// which is which. Output: its monitors without a robot, with their inputs and parameters; nullopt
// when there are none.
std::optional<Watch> build_watch(const sema::Spec& spec, const Signals& signals,
                                 const SourceManager& sources, std::vector<Region> regions,
                                 std::vector<Solid> solids, const TableMap& tables,
                                 diag::Engine& diagnostics);

}  // namespace rtac::ir
