// `distance(r, agent) >= c`: everything within reach keeps c from everything that the agent may
// reach until the robot stands. What the agent does then is nobody's to keep (theory, two robots:
// uncooperative agents).
#include "compiler/passes/lookahead/atoms.h"

namespace rtac::passes::lookahead {

using namespace ir;

Expanded agent(Expansion& expansion, const Atom& atom) {
  const auto bound = lower_bound(atom.from, atom.compare, expansion.decision().facts.params);
  if (!bound) return std::nullopt;
  expansion.decides_in(Unit::mm);
  if (!expansion.look().duration) {
    expansion.without_effect("`waypoints only` has no effect on the distance to an agent",
                             "an agent follows no plan: leave `waypoints only` out, or write the "
                             "distance in a monitor of its own");
  }
  const auto more = expansion.more_of(bound->need, Unit::mm, atom.source, atom.to);
  return add(atom.to, AgentReach{AgentIndex{bound->leaf.table}, bound->need.fixed, more},
             atom.source);
}

}  // namespace rtac::passes::lookahead
