// What is wrong with a polygon, as a diagnostic: at its vertices in the specification, or by their
// place in the file that it comes from.
#pragma once

#include "compiler/diagnostics/engine.h"
#include "compiler/geometry/region.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// `range`: of the whole zone expression.
diag::Diagnostic describe(const geometry::Problem& problem, const sema::ZonePolygon& polygon,
                          const SourceRange& range);

}  // namespace rtac::analysis
