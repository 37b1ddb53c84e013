// A decision as it is written and as it is derived: what checks of its numbers ask for.
#pragma once

#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/trials.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

struct Decided {
  const sema::Spec& spec;
  const sema::Decision& written;
  const ir::Module& module;
  const ir::Decision& decision;
  const HowItLies& lies;
  Trials* trials = nullptr;  // none: nothing is offered
};

}  // namespace rtac::analysis
