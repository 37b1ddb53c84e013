// `r inside zone`, `clearance(r, zone) >= c` and `distance(r, zone) >= c` of a zone that is
// received: as of one of the specification. That it does not change before the robot stands is
// assumed.
#include "compiler/passes/lookahead/atoms.h"

namespace rtac::passes::lookahead {

using namespace ir;

Expanded received(Expansion& expansion, const Atom& atom) {
  const auto bound = lower_bound(atom.from, atom.compare, expansion.decision().facts.params);
  if (!bound) return std::nullopt;
  expansion.decides_in(Unit::mm);
  const Lookahead& look = expansion.look();
  const auto zone = ReceivedIndex(bound->leaf.table);
  if (look.waypoints > 0) {
    expansion.judges_waypoints(!look.points_only);  // if it could, which is what is reported
    return expansion.refuse(atom.source,
                            "the legs of a plan cannot be held against a zone that is received",
                            atom.to, "`ahead` of a duration works, without `waypoints`; ");
  }
  const std::int64_t least = bound->need.fixed;
  const auto more = expansion.more_of(bound->need, Unit::mm, atom.source, atom.to);
  const ValueId reach = add(atom.to, ReceivedReach{zone, least, more}, atom.source);
  if (!look.command) return reach;
  return or_course(expansion, reach, ReceivedCourse{zone, least, more}, atom);
}

}  // namespace rtac::passes::lookahead
