// `r inside zone` and `clearance(r, zone) >= c`: disc or capsule keep c to the boundary, and so do
// the next legs.
#include "compiler/passes/lookahead/atoms.h"

namespace rtac::passes::lookahead {

using namespace ir;

Expanded fence(Expansion& expansion, const Atom& atom) {
  const auto bound = lower_bound(atom.from, atom.compare, expansion.decision().facts.params);
  if (!bound) return std::nullopt;
  expansion.decides_in(Unit::mm);
  const Lookahead& look = expansion.look();
  const auto zone = ZoneIndex(bound->leaf.table);
  const std::int64_t asked_mm = expansion.decision().body.radius_mm + bound->need.strictest;
  const std::int64_t least =
      bound->need.fixed + leave_beside_mm(expansion.monitor().recovery, zone, asked_mm);
  const auto more = expansion.more_of(bound->need, Unit::mm, atom.source, atom.to);
  std::optional<ValueId> result;
  if (look.duration) {
    result = add(atom.to, ZoneReach{zone, least, more}, atom.source);
    if (look.command) result = or_course(expansion, *result, ZoneCourse{zone, least, more}, atom);
  }
  if (look.waypoints > 0) {
    const ValueId legs = zone_legs(expansion, zone, least, more, atom);
    result = result ? add(atom.to, And{*result, legs}, atom.source) : legs;
  }
  return result ? *result : add(atom.to, ZoneReach{zone, least, more}, atom.source);
}

}  // namespace rtac::passes::lookahead
