#include "compiler/passes/lookahead/registry.h"

#include <array>
#include <vector>

#include "compiler/passes/lookahead/atoms.h"
#include "compiler/support/words.h"

namespace rtac::passes::lookahead {
namespace {

using namespace ir;
using Kind = Leaf::Kind;

struct Transformer {
  std::vector<Kind> of;            // the signals of the comparison, in the order of their kinds
  std::vector<const char*> forms;  // that it knows, as 5006 lists them
  Expanded (*expand)(Expansion&, const Atom&);
};

const std::array<Transformer, 9>& registry() {
  static const std::array<Transformer, 9> all = {{
      {{Kind::clearance}, {"`inside`", "`clearance(r, zone) >= c`"}, fence},
      {{Kind::received}, {}, received},  // written as of any zone
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

// The zone of a clearance.
std::string zone_name(const Expansion& in, const Leaf& leaf) {
  if (leaf.kind == Kind::clearance) return in.module()[ZoneIndex(leaf.table)].name;
  return in.decision().facts[ReceivedIndex(leaf.table)].name;
}

std::string written(const Expansion& in, const Leaf& length) {
  if (length.kind == Kind::received) {
    const bool outside = in.decision().facts[ReceivedIndex(length.table)].outside;
    return (outside ? "distance(r, " : "clearance(r, ") + zone_name(in, length) + ")";
  }
  if (length.kind == Kind::clearance) {
    return "clearance(r, " + zone_name(in, length) + ")";
  }
  const bool of_agent = length.kind == Kind::agent;
  return "distance(r, " + (of_agent ? in.decision()[AgentIndex(length.table)].name : "q") + ")";
}

// Of a distance that grows with the speed: what it comes to at the declared one, in words.
std::string at_full_speed(const Expansion& expansion, const Atom& atom) {
  const Linear form = linear_form(atom.from, atom.compare);
  if (form.terms.size() != 2 || !form.rest.params.empty()) return "";
  const Leaf speed{Kind::speed, 0};
  const auto at = form.terms.find(speed);
  if (at == form.terms.end() || at->second > 0) return "";
  const auto& [length, of_length] =
      form.terms.begin() == at ? *form.terms.rbegin() : *form.terms.begin();
  const bool known = length.kind == Kind::clearance || length.kind == Kind::distance ||
                     length.kind == Kind::agent || length.kind == Kind::received;
  if (!known || of_length < 0) return "";
  const Rational most_mmps = static_cast<long>(expansion.decision().motions.front().speed_mmps);
  const Rational need_mm = -(at->second * most_mmps + form.rest.constant) / of_length;
  return quoted(written(expansion, length) + " >= " + metres(ceil_to_int(need_mm))) +
         " works, which is what it comes to at " + to_decimal(Rational(most_mmps / 1000)) +
         " m/s, the declared speed; ";
}

// Of a speed or a height that is at most what a parameter says: the strictest limit that it may
// become, in words; "": it is none of these.
std::string at_the_strictest(const Expansion& expansion, const Atom& atom) {
  const Linear form = linear_form(atom.from, atom.compare);
  if (form.terms.size() != 1 || form.rest.params.empty()) return "";
  const auto& [leaf, coefficient] = *form.terms.begin();
  const bool speed = leaf.kind == Kind::speed;
  if (coefficient > 0 || (!speed && leaf.kind != Kind::altitude)) return "";
  Rational least = form.rest.constant;
  for (const auto& [param, k] : form.rest.params) {
    const Range& range = expansion.decision().facts.params[param].range;
    least += k * static_cast<long>(k > 0 ? range.lo : range.hi);
  }
  const Rational most_mm = floor_to_int(Rational(least / -coefficient));
  return (speed ? "`r.speed <= " : "`r.position.z <= ") + to_decimal(Rational(most_mm / 1000)) +
         (speed ? " m/s`" : " m`") + " works, the strictest that it may become; ";
}

}  // namespace

ValueId transform(Expansion& expansion, const Atom& atom) {
  const std::vector<Kind> signals = signals_of(atom);
  for (const Transformer& t : registry()) {
    if (t.of != signals) continue;
    if (const Expanded done = t.expand(expansion, atom)) return *done;
  }
  const auto most = upper_bound(atom.from, atom.compare);
  const bool of_zone =
      most && (most->leaf.kind == Kind::clearance ||
               (most->leaf.kind == Kind::received &&
                !expansion.decision().facts[ReceivedIndex(most->leaf.table)].outside));
  if (of_zone && most->most < 0) {
    // where the body is not inside, some of it is outside: all of it is a form that is known
    const std::string zone = zone_name(expansion, most->leaf);
    return expansion.refuse(atom.source,
                            "that a robot is not inside cannot be looked ahead: some of it "
                            "outside is enough for that",
                            atom.to,
                            "`distance(r, " + zone +
                                ") >= 0 m` works, which says that all of the "
                                "robot is outside of it; ");
  }
  if (const std::string strictest = at_the_strictest(expansion, atom); !strictest.empty()) {
    return expansion.refuse(atom.source,
                            "a limit of speed or height cannot be looked ahead as a parameter: it "
                            "has to be a constant",
                            atom.to, strictest);
  }
  return expansion.refuse(atom.source,
                          "this comparison cannot be looked ahead: no bound is known for how it "
                          "changes while the robot moves",
                          atom.to, at_full_speed(expansion, atom));
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
