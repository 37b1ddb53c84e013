// Whether a recovery in the plane moves where its property holds (language rule 11): its zone lies
// in what the property keeps the robot in, and its way there does.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "compiler/analysis/trials.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/geometry/region.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// The exact zone of a table.
using ExactZone = std::function<const geometry::Region&(ir::ZoneIndex)>;

// The places of the region that are so far from its boundary, all that are `offset_excess_m()`
// farther among them; none: the region has so many vertices that this takes long.
std::optional<geometry::Region> within(const geometry::Region& region, std::int64_t mm);

bool is_convex(const geometry::Region& region);

// With back-ticks; a zone within a property has no name of its own.
std::string name_as_written(const ir::ZoneTable& zone);

// About the recovery of a monitor, where it names that.
diag::Diagnostic about_recovery(const sema::Monitor& written, diag::Code code, std::string message);

// 5016 of a recovery that moves, or claims to stay in a zone, or 5020 where it finds no way into
// its zone; the first finding of each step.
std::vector<diag::Diagnostic> misplaced(const sema::RobotKind& kind, const sema::Monitor& written,
                                        const sema::Controller& controller,
                                        const ir::Module& module, const ExactZone& exact,
                                        const ir::Decision& decision, const ir::Monitor& monitor,
                                        Trials* trials);

}  // namespace rtac::analysis
