// `r.speed <= c`: it gains speed until the recovery acts, and brakes from then on. How fast the
// recovery drives afterwards is checked where it is derived.
#include "compiler/passes/lookahead/atoms.h"

namespace rtac::passes::lookahead {

using namespace ir;

Expanded speed(Expansion& expansion, const Atom& atom) {
  const auto bound = upper_bound(atom.from, atom.compare);
  if (!bound) return std::nullopt;
  expansion.decides_in(Unit::mmps);
  if (!expansion.look().duration) {
    expansion.without_effect("`waypoints only` has no effect on the speed",
                             "the speed is judged for the time until the recovery acts: leave "
                             "`waypoints only` out, or write the speed in a monitor of its own");
  }
  return add(atom.to, SpeedReach{bound->most}, atom.source);
}

}  // namespace rtac::passes::lookahead
