// Whether a monitor can ever hand back: its `return when`, and the charge that its property asks
// for where its recovery ends.
#pragma once

#include <optional>

#include "compiler/analysis/across.h"
#include "compiler/analysis/decided.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

struct AskedClearance {
  std::int64_t mm = 0;   // 0: none
  SourceRange source{};  // of the comparison
};
// Clearance of the centre in `zone`, in mm, at which the return condition of monitor `k` holds for
// a robot at rest; 0 when it asks for none, or for more than a zone has anywhere. Of another zone
// that `zone` lies deep in it is as much less.
AskedClearance asked_clearance(const ir::Module& module, const ir::Decision& decision,
                               std::size_t k, ir::ZoneIndex zone, const HowItLies& lies);

// 5007, with the largest value that works: the condition of monitor `k` holds nowhere, or at no
// charge; nullopt: it may hold. Needs the costs of the sites.
std::optional<diag::Diagnostic> hopeless_return(const Decided& of, std::size_t k,
                                                const ExactZones& exact);

// A property that is false whatever is measured: `false`, `1 m >= 2 m`, `exists` where there is no
// other robot, or all sides of an `or`.
bool never_holds(const ir::Decision& decision, const ir::Block& property);

}  // namespace rtac::analysis
