// How far a recovery keeps the limits of speed in a property, where what the robot is told decides
// which of them count: `estop implies r.speed <= c`, `if loaded then r.speed <= a else ...`.
#pragma once

#include <cstdint>
#include <functional>

#include "compiler/ir/module.h"

namespace rtac::analysis {

enum class Pace {
  kept,        // by the recovery, whatever the robot is told
  told,        // depends on what it is told alone
  told_kept,   // the part of the robot is kept: what it is told may make it false
  while_told,  // kept while what it is told says so; a robot at rest waits where it does not
  broken
};

// Whether a comparison of something else than the speed is kept.
using KeepsElsewhere = std::function<bool(const ir::Block&, const ir::AtLeast&)>;

// `mmps`: how fast the recovery drives; `from_rest_mmps`: how fast a robot at rest may become until
// a recovery would act. A limit that is broken, and below that, lets no robot at rest go on: who
// stands there because of it does so until the inputs change, and no recovery takes over from
// another one meanwhile.
Pace pace_of(const ir::Block& block, ir::ValueId id, std::int64_t mmps, std::int64_t from_rest_mmps,
             const KeepsElsewhere& keeps_elsewhere);

// Whether nothing but what the robot is told decides a value.
bool told(const ir::Block& block, ir::ValueId id);

}  // namespace rtac::analysis
