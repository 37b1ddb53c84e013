// Every obligation of every decision, shown by closed forms and exact geometry as far as they
// reach.
#pragma once

#include <set>
#include <vector>

#include "compiler/analysis/trials.h"
#include "compiler/ir/module.h"
#include "compiler/ir/table_map.h"
#include "compiler/protocol/protocol.h"
#include "compiler/sema/spec.h"
#include "compiler/verify/obligation.h"

namespace rtac::verify {

// Of a module that is well formed but for what `found` says: errors of 5xxx and 6xxx each refute an
// obligation.
// `module`: null when none could be built; then nothing but that is told. `check` goes through all
// runs of a model of the switching protocol.
Report verify(const sema::Spec& spec, const ir::Module* module, const ir::TableMap& tables,
              const std::vector<diag::Diagnostic>& found, const protocol::CheckModel& check);

// What is neither shown nor accepted of a specification that is tried; of its switching only that
// recoveries take turns for ever, where `check` is there to find that.
std::set<analysis::Fault> open_obligations(const sema::Spec& spec, const ir::Module& module,
                                           const ir::TableMap& tables,
                                           const std::vector<diag::Diagnostic>& found,
                                           const protocol::CheckModel& check);

// 5020: the monitors whose recovery leads to a place where they do not let go, by what they ask for
// beside being clear of a boundary: P2b is refuted there, by geometry alone. Of a module without
// errors.
std::vector<diag::Diagnostic> never_given_back(const sema::Spec& spec, const ir::Module& module,
                                               const ir::TableMap& tables);

}  // namespace rtac::verify
