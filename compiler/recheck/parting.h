// Robots that hold too near to each other, once more: whether one of two always finds a way out of
// the other's, as docs/templates.md says of `yield`. In m.
#pragma once

#include <optional>
#include <utility>

#include "compiler/recheck/claims.h"

namespace rtac::recheck {

// Of distances between middles, as they are measured.
struct PartingLimits {
  double route;             // clearance of cells that ways lead over
  double body;              // clearance with less of which a robot is nowhere
  double nearest;           // no two robots are nearer to each other
  double apart;             // at which they need not part
  double goal;              // at which a way may end
  bool each_alone = false;  // pairs that look alike are each looked at, for tests
};
// Two places from which neither may find a way; none: there are none. `BadCells`: the cells are not
// those of the zone, or there are too many pairs of them.
using Meeting = std::optional<std::pair<geometry::Point, geometry::Point>>;
std::variant<Meeting, BadCells> without_parting(const geometry::Region& zone, const Cells& cells,
                                                const PartingLimits& limits);

// The claim that the recovery of `monitor` makes room: at the distance that it leads to, control is
// given back, and one of two robots always gets there. Taken from the claim: the clearance that
// ways keep.
std::optional<Doubt> check_parting(const sema::Spec& spec, const sema::Decision& decision,
                                   Claims& claims, const sema::Monitor& monitor, const Values& v);

}  // namespace rtac::recheck
