// How far apart robots can be that are given back in one zone.
#pragma once

#include <cstdint>
#include <optional>

#include "compiler/analysis/recoveries_in_space.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

struct ExactZones {
  const ExactZone& flat;
  const ExactSolid& solid;
};

// How far apart two places of a zone are at most that are so clear of its boundary; nullopt: it has
// so many corners, or no end.
std::optional<std::int64_t> farthest_apart_mm(const ir::Module& module, bool in_space,
                                              const ExactZones& exact, ir::ZoneIndex fence,
                                              std::int64_t clearance_mm);

}  // namespace rtac::analysis
