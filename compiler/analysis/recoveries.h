// Whether the recovery of a monitor can do what the monitor needs it for (theory, well-formed RTA
// modules; language rule 11): it moves where the property holds, it gets out again where the
// property is false, and its commands act in time.
#pragma once

#include <functional>

#include "compiler/analysis/recoveries_in_space.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/geometry/region.h"
#include "compiler/ir/module.h"
#include "compiler/ir/table_map.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// The exact zone of a table.
using ExactZone = std::function<const geometry::Region&(ir::ZoneIndex)>;

void check_recoveries(const sema::Spec& spec, const ir::Module& module, const ExactZone& exact,
                      const ExactSolid& solid, diag::Engine& diagnostics);

}  // namespace rtac::analysis
