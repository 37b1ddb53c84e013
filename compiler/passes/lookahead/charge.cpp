// `r.battery >= c`, and `r.battery >= energy_to(site) + c`. Whoever drives from here on spends
// charge: the recovery's own way counts. With the way in the bound, a charge that suffices now
// suffices until the robot is there.
#include "compiler/ir/acknowledged.h"
#include "compiler/passes/lookahead/atoms.h"

namespace rtac::passes::lookahead {
namespace {

using namespace ir;

bool accepted(const Expansion& expansion) {
  const Monitor& monitor = expansion.monitor();
  return acknowledged(expansion.decision(), monitor.recovery.name, monitor.name);
}

bool leads_there(const Recovery& recovery, std::optional<SiteIndex> site) {
  return recovery.kind == RecoveryKind::route && (!site || *site == recovery.site);
}

void refuse(Expansion& expansion, std::optional<SiteIndex> site, const Atom& atom) {
  const Recovery& of = expansion.monitor().recovery;
  const std::string& recovery = of.name;
  const std::string accept =
      "`acknowledge " + recovery + " may break " + expansion.monitor().name + " \"why\"`";
  // the way is priced, and what is spent where it ends is not
  if (leads_there(of, site)) {
    return expansion.report(
        {diag::Code::recovery_spends_charge,
         atom.source,
         "the recovery `" + recovery + "` ends where nobody charges the robot",
         "is false sooner or later at `" + expansion.module()[of.site].name + "`",
         {},
         "`route to` the site where the robot is charged works; or " + accept,
         {}});
  }
  const std::string where =
      site ? "`route to " + expansion.module()[*site].name + "`" : "`route to` a site";
  expansion.report({diag::Code::recovery_spends_charge,
                    atom.source,
                    "the recovery `" + recovery + "` spends charge that nobody accounts for",
                    "may be false while `" + recovery + "` drives",
                    {},
                    "a recovery " + where + " works, its way is priced; or " + accept,
                    {}});
}

// `site`: the property asks for the way to it already.
ValueId reserve(Expansion& expansion, std::optional<SiteIndex> site, const Need& need,
                const Atom& atom) {
  expansion.decides_in(Unit::ppm);
  if (!expansion.look().duration) {
    expansion.without_effect("`waypoints only` has no effect on the charge",
                             "the charge is judged for everywhere within reach: leave `waypoints "
                             "only` out, or write the charge in a monitor of its own");
  }
  const Recovery& recovery = expansion.monitor().recovery;
  const bool drives_there = leads_there(recovery, site);
  // refused, and expanded as if it were accepted: a simulation shows what comes of it
  if (!(drives_there && recovery.charges) && !accepted(expansion)) refuse(expansion, site, atom);
  if (!site && drives_there) site = recovery.site;
  const auto more = expansion.more_of(need, Unit::ppm, atom.source, atom.to);
  if (!site) return add(atom.to, ChargeReach{need.fixed, more}, atom.source);
  return add(atom.to, EnergyReach{*site, need.fixed + expansion.decision().hold_reserve_ppm, more},
             atom.source);
}

}  // namespace

Expanded charge(Expansion& expansion, const Atom& atom) {
  const auto bound = lower_bound(atom.from, atom.compare, expansion.decision().facts.params);
  if (!bound) return std::nullopt;
  return reserve(expansion, std::nullopt, bound->need, atom);
}

Expanded charge_for_way(Expansion& expansion, const Atom& atom) {
  const auto way = ir::charge_for_way(atom.from, atom.compare, expansion.decision().facts.params);
  if (!way) return std::nullopt;
  return reserve(expansion, way->site, way->reserve, atom);
}

}  // namespace rtac::passes::lookahead
