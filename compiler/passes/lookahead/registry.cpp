#include "compiler/passes/lookahead/registry.h"

#include <array>
#include <vector>

#include "compiler/passes/lookahead/atoms.h"

namespace rtac::passes::lookahead {
namespace {

using namespace ir;
using Kind = Leaf::Kind;

struct Transformer {
  std::vector<Kind> of;            // the signals of the comparison, in the order of their kinds
  std::vector<const char*> forms;  // that it knows, as 5006 lists them
  Expanded (*expand)(Expansion&, const Atom&);
};

const std::array<Transformer, 8>& registry() {
  static const std::array<Transformer, 8> all = {{
      {{Kind::clearance}, {"`inside`", "`clearance(r, zone) >= c`"}, fence},
      {{Kind::distance}, {"`distance(r, q) >= c`"}, separation},
      {{Kind::agent}, {"`distance(r, agent) >= c`"}, agent},
      {{Kind::battery}, {"`r.battery >= c`"}, charge},
      {{Kind::battery, Kind::energy_to}, {"`r.battery >= energy_to(site) + c`"}, charge_for_way},
      {{Kind::count}, {"`count(q : Kind, q != r : distance(r, q) <= c) <= n`"}, count},
      {{Kind::speed}, {"`r.speed <= c`"}, speed},
      {{Kind::altitude}, {"`r.position.z <= c`"}, altitude},
  }};
  return all;
}

std::vector<Kind> signals_of(const Atom& atom) {
  std::vector<Kind> kinds;
  for (const auto& [leaf, coefficient] : linear_form(atom.from, atom.compare).terms) {
    kinds.push_back(leaf.kind);
  }
  return kinds;
}

}  // namespace

ValueId transform(Expansion& expansion, const Atom& atom) {
  const std::vector<Kind> signals = signals_of(atom);
  for (const Transformer& t : registry()) {
    if (t.of != signals) continue;
    if (const Expanded done = t.expand(expansion, atom)) return *done;
  }
  const auto most = upper_bound(atom.from, atom.compare);
  if (most && most->leaf.kind == Kind::clearance && most->most < 0) {
    // where the body is not inside, some of it is outside: all of it is a form that is known
    const std::string& zone = expansion.module()[ZoneIndex(most->leaf.table)].name;
    return expansion.refuse(atom.source,
                            "that a robot is not inside cannot be looked ahead: some of it "
                            "outside is enough for that",
                            atom.to,
                            "`distance(r, " + zone +
                                ") >= 0 m` works, which says that all of the "
                                "robot is outside of it; ");
  }
  return expansion.refuse(atom.source,
                          "this comparison cannot be looked ahead: no bound is known for how it "
                          "changes while the robot moves",
                          atom.to);
}

std::string registered_forms() {
  std::vector<std::string> forms;
  for (const Transformer& t : registry()) forms.insert(forms.end(), t.forms.begin(), t.forms.end());
  std::string list;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    list += (i == 0 ? "" : i + 1 == forms.size() ? " and " : ", ") + forms[i];
  }
  return list;
}

}  // namespace rtac::passes::lookahead
