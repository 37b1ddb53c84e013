// A retreat that has nowhere to go: where another property holds the robot deep inside its zone.
#pragma once

#include <optional>

#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// Of a step of the recovery of `driving`, in the plane: a zone that holds the robot wherever the
// property of `judged` holds, and which lies so deep in the zone of the step, by its standoff, that
// a retreat takes it for clear enough wherever the brake ends: it holds its place there, and does
// not set out. nullopt: it may set out, or that is not known.
std::optional<Standoff> stays_put(const ir::Module& module, const ir::Decision& decision,
                                  const ExactZone& exact, const ir::Monitor& driving,
                                  const ir::Recovery& step, const ir::Monitor& judged);

}  // namespace rtac::analysis
