// A zone as it could be written, of the names of others.
#pragma once

#include <string>

#include "compiler/sema/spec.h"

namespace rtac::analysis {

// "yard - grow(pond, 0.5 m)", with what has no name in its place; "": a shape is written there, or
// something that is read.
std::string zone_text(const sema::Spec& spec, const sema::ZoneExpr& zone);

}  // namespace rtac::analysis
