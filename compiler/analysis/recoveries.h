// Whether the recovery of a monitor can do what the monitor needs it for (theory, well-formed RTA
// modules; language rule 11): it moves where the property holds, it gets out again where the
// property is false, and its commands act in time.
#pragma once

#include "compiler/analysis/recoveries_in_space.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/trials.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"
#include "compiler/ir/table_map.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// `remarks`: whether to look for parts of zones that no way leads back from (5020, 5021), too.
void check_recoveries(const sema::Spec& spec, const ir::Module& module, const ExactZone& exact,
                      const ExactSolid& solid, const HowItLies& lies, Trials* trials, bool remarks,
                      diag::Engine& diagnostics);

// Of who stands and may never be given back (5017): it is at rest, and not while pushes and errors
// that turn around keep it moving.
bool stands_near_its_limit(const diag::Diagnostic& report);

}  // namespace rtac::analysis
