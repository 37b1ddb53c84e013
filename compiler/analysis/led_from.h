// How far a retreat of the plane leads from where it sets out.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

struct Led {
  // By cell of its zone, in mm: from any place of it no way is longer; -1: it does not set out
  // there.
  std::vector<std::int64_t> from_mm;
  // How much farther from the places of its way, which ends as deep as `aims_mm`, a robot may be.
  std::int64_t strays_mm = 0, aims_mm = 0;
};

// Of a retreat that is the recovery of `driving`, but for brakes before it: it sets out where it is
// measured to be less clear than control takes. nullopt: nothing bounds that, as where other robots
// of the fleet may stand in its way, or it is no such recovery.
std::optional<Led> led_from(const sema::RobotKind& kind, const ir::Module& module,
                            const ir::Decision& decision, const ir::Monitor& driving);

}  // namespace rtac::analysis
