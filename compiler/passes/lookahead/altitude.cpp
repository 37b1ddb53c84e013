// `r.position.z <= c` and `r.position.z >= c`: the highest and the lowest place of the centre
// within reach, by disc or capsule.
#include "compiler/passes/lookahead/atoms.h"

namespace rtac::passes::lookahead {

using namespace ir;

Expanded altitude(Expansion& expansion, const Atom& atom) {
  AltitudeReach reach{};
  if (const auto most = upper_bound(atom.from, atom.compare)) {
    reach = {most->most, false};
  } else {
    const auto least = lower_bound(atom.from, atom.compare, expansion.decision().facts.params);
    if (!least || !least->need.params.empty()) return std::nullopt;
    reach = {least->need.fixed, true};
  }
  expansion.decides_in(Unit::mm);
  return add(atom.to, reach, atom.source);
}

}  // namespace rtac::passes::lookahead
