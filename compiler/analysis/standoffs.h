// What the properties of a decision keep beyond "not touching", however they are written.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/ir/module.h"

namespace rtac::analysis {

// Largest c of atoms like `clearance(r, zone) >= c` and `distance(r, q) >= c`, in mm, rounded up.
struct Standoffs {
  std::int64_t fence_mm = 0, separation_mm = 0;
};

// Raises `wanted` to what `property` asks for. The same atoms count as in the look-ahead: those
// that are linear in one clearance or one distance.
void ask_for_standoffs(const ir::Block& property, const std::vector<ir::Param>& params,
                       Standoffs& wanted);
// Of all monitors of the decision.
Standoffs standoffs_of(const ir::Decision& decision);

// How far from every other robot at least a robot is whenever the property holds, in mm, with
// parameters at their strictest. 0: it may hold however near one is.
std::int64_t sure_separation_mm(const ir::Block& property, const std::vector<ir::Param>& params);
// Of all monitors of the decision.
std::int64_t sure_separation_mm(const ir::Decision& decision);

// A clearance of some zone that a property asks for, on whichever side of an `or`.
struct Standoff {
  ir::ZoneIndex zone;
  std::int64_t mm;
};
std::vector<Standoff> fence_standoffs(const ir::Block& property,
                                      const std::vector<ir::Param>& params);
// The largest one of that zone; 0: none.
std::int64_t fence_standoff_mm(const ir::Block& property, const std::vector<ir::Param>& params,
                               ir::ZoneIndex zone);

// How a zone lies in another one: `deep` where each of its places keeps the standoff of that.
enum class Lies { elsewhere, in, deep };
using HowItLies = std::function<Lies(ir::ZoneIndex inner, const Standoff& outer)>;

// How far all of `inner` is from the boundary of another zone that it lies in, at most as far as
// `outer` asks for: who is as clear of the boundary of `inner`, is as much clearer of the other
// one.
std::int64_t depth_mm(ir::ZoneIndex inner, const Standoff& outer, const HowItLies& lies);

// What a recovery has to keep from the boundary of its `zone`, beyond what it keeps from any: so
// that the properties of the decision hold which the zone lies in, and that of its own monitor,
// whatever the zone. Of other zones, their own recoveries take care. What holds of one that is as
// slow as the recovery, wherever it is, asks for nothing but in its own zone. `own` is one of the
// decision's.
std::int64_t standoff_in(const ir::Decision& decision, const ir::Monitor& own, ir::ZoneIndex zone,
                         const HowItLies& lies);
// What one property adds to that.
std::int64_t standoff_of(const ir::Block& property, const std::vector<ir::Param>& params, bool own,
                         ir::ZoneIndex zone, const HowItLies& lies);

}  // namespace rtac::analysis
