// Evaluates the zones of a specification exactly and bakes those that are used.
#pragma once

#include <optional>
#include <vector>

#include "compiler/diagnostics/engine.h"
#include "compiler/geometry/bake.h"
#include "compiler/geometry/region.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

struct EvaluatedZone {
  geometry::Region exact;
  geometry::SnappedZone snapped;
  geometry::BakedZone baked;
};

// By ZoneId; nullopt for a zone that is faulty (reported) or not in `wanted`.
std::vector<std::optional<EvaluatedZone>> evaluate_zones(const sema::Spec& spec,
                                                         const std::vector<bool>& wanted,
                                                         diag::Engine& diagnostics);

}  // namespace rtac::analysis
