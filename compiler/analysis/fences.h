// Which zones a property keeps a robot in.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/analysis/standoffs.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// The zones whose clearance a property bounds from below, each once, while its parameters ask for
// most: what a recovery has to stay in, though a body may stick out of it where the bound is
// negative.
std::vector<ir::ZoneIndex> fences_of(const ir::Block& property,
                                     const std::vector<ir::Param>& params);

// The zones of the branches of an `or`, each once, at least one: one of them holds the robot
// wherever the property holds, or what it has no part in does.
using Choice = std::vector<ir::ZoneIndex>;
// `rest_mmps`: a limit of speed below that counts as none of them, as nobody is seen to keep it.
std::vector<Choice> choices_of(const ir::Block& property, const std::vector<ir::Param>& params,
                               std::int64_t rest_mmps = 0);
// A robot that stands, as the look-ahead sees it.
struct AtRest {
  std::int64_t mmps = 0;                   // as fast as it may become
  std::function<bool(ir::ValueId)> holds;  // so slow, wherever it is, and whatever it is told
};
// Whether each `or` of places is such a one, which is true where one of its zones holds the robot,
// whatever inputs are, or true of a robot at rest wherever it is, or where others are far; and
// whether inputs and limits of its own speed stand beside places in nothing else.
bool places_settle(const ir::Block& property, const std::vector<ir::Param>& params,
                   const AtRest& at_rest);

// What a robot surely has wherever the property holds, whatever its parameters become: of each
// entry it is in at least one of the zones, body and all, and so far from its boundary.
std::vector<std::vector<Standoff>> surely_in(const ir::Block& property,
                                             const std::vector<ir::Param>& params);

// The zones of entries of one zone: where a centre is whatever parameters become.
std::vector<ir::ZoneIndex> sure_fences(const ir::Block& property,
                                       const std::vector<ir::Param>& params);

// Whether a monitor keeps what it says until its recovery takes over, whoever drives: it looks
// ahead as far as it has to, and nobody is accepted to break it.
bool relied_on(const ir::Decision& decision, const ir::Monitor& monitor);

// The zones of which inputs say when each of them counts, as in `if rain then r inside shelter else
// r inside field`, each once: a recovery has to lead to all of them, as inputs may say either.
std::vector<ir::ZoneIndex> told_fences_of(const ir::Block& property,
                                          const std::vector<ir::Param>& params);

// Whether some comparison of the property, of any branch, asks for a clearance or a height, or for
// a distance; whether all that it asks of places is not to be too high; and whether something of
// places is compared in another way, such as that a robot is not inside.
struct Asks {
  bool clearance = false, distance = false, only_lower = false, other = false;
};
Asks asks_of(const ir::Block& property, const std::vector<ir::Param>& params);

}  // namespace rtac::analysis
