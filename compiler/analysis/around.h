// A retreat around what its property keeps it off, in a zone that leaves out no more than that.
#pragma once

#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// Whether a retreat of the plane that is alone keeps the standoff from the boundary of the fence,
// which its zone lies in, though places of the zone are nearer to it: it sets out where the judged
// property holds, and its own one asks for as much, so that its legs keep that. Where that boundary
// is the nearest one, ways lose nothing of it. Where another wall of the zone is, no way is so
// long. `judged`: as of keeps_off.
bool keeps_around(const sema::RobotKind& kind, const ir::Module& module,
                  const ir::Decision& decision, const ExactZone& exact, const ir::Monitor& driving,
                  const ir::Monitor& judged, const Standoff& fence);

}  // namespace rtac::analysis
