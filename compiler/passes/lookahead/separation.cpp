// `distance(r, q) >= c`: everything within reach of both keeps c apart, and so do the next legs.
#include "compiler/passes/lookahead/atoms.h"

namespace rtac::passes::lookahead {

using namespace ir;

Expanded separation(Expansion& expansion, const Atom& atom) {
  const auto bound = lower_bound(atom.from, atom.compare, expansion.decision().facts.params);
  if (!bound) return std::nullopt;
  expansion.decides_in(Unit::mm);
  const Lookahead& look = expansion.look();
  const std::int64_t least = bound->need.fixed;
  const auto more = expansion.more_of(bound->need, Unit::mm, atom.source, atom.to);
  expansion.keeps_apart(bound->need.strictest);
  if (look.points_only) {
    expansion.without_effect("`points only` has no effect on the distance to another robot",
                             "robots keep apart on the whole of their legs: leave `points only` "
                             "out, or write the distance in a monitor of its own");
  }
  std::optional<ValueId> result;
  if (look.duration) {
    result = add(atom.to, PairReach{least, more}, atom.source);
    if (look.command) result = or_course(expansion, *result, PairCourse{least, more}, atom);
  }
  if (look.waypoints > 0) {
    const ValueId legs = legs_apart(expansion, least, more, atom);
    result = result ? add(atom.to, And{*result, legs}, atom.source) : legs;
  }
  return result ? *result : add(atom.to, PairReach{least, more}, atom.source);
}

}  // namespace rtac::passes::lookahead
