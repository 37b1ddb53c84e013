// P2a, P2b and the matrix of arbitration.
#include <algorithm>

#include "compiler/analysis/boundless.h"
#include "compiler/analysis/company.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/in_sight.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/liveness.h"
#include "compiler/analysis/outline.h"
#include "compiler/analysis/return_set.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/site_room.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/analysis/superfluous.h"
#include "compiler/analysis/tables.h"
#include "compiler/analysis/travel.h"
#include "compiler/analysis/windows.h"
#include "compiler/ir/linear.h"
#include "compiler/ir/words.h"
#include "compiler/support/words.h"
#include "compiler/verify/atoms.h"
#include "compiler/verify/leaving.h"
#include "compiler/verify/proofs.h"
#include "compiler/verify/within_zones.h"

namespace rtac::verify {
namespace {

// "" : it is not acknowledged.
std::string reason(const ir::Decision& decision, const std::string& recovery,
                   const std::string& monitor) {
  for (const ir::Acknowledgement& a : decision.acknowledgements) {
    if (a.recovery == recovery && a.monitor == monitor) return a.reason;
  }
  return "";
}

Obligation start(const Subject& s, std::size_t k, Kind kind) {
  Obligation o;
  o.kind = kind;
  o.monitor = s.decision.monitors[k].name;
  return o;
}
Obligation acknowledged(Obligation o, std::string why) {
  o.status = Status::acknowledged;
  o.method = "acknowledged";
  o.because = std::move(why);
  o.claims.clear();
  return o;
}

Claim recovery_claim(const Subject& s, std::size_t k) {
  const ir::Recovery& r = s.decision.monitors[k].recovery;
  return {"recovery",
          {{"decision", s.decision.name},
           {"monitor", s.decision.monitors[k].name},
           {"controller", r.name},
           {"template", ir::word_of(r.kind)}}};
}

// Who goes to a site to be charged has to rest so near to it (language rule 6.7); "": it does.
std::string off_its_dock(const Subject& s, const ir::Recovery& last) {
  if (!analysis::goes_to_charge(s.kind, s.spec, s.module, last)) return "";
  const std::int64_t off_mm = analysis::rests_off_mm(s.decision.body);
  if (off_mm <= analysis::dock_reach_mm) return "";
  return quoted(last.name) + " may come to rest " + metres(off_mm) + " from " +
         quoted(s.module[last.site].name) +
         ", where lasting errors and pushes let it come no nearer, and it is charged within " +
         metres(analysis::dock_reach_mm);
}

// What it needs around its site: in space its hold is carried there, errors and pushes that last
// keep it as far beside that as it sways, and that is where it has to be given back.
std::int64_t back_mm(const Subject& s, const ir::Recovery& last) {
  const bool aside = s.decision.body.in_space && last.kind == ir::RecoveryKind::route;
  return last.return_clearance_mm + (aside ? s.decision.body.end_reach_mm : 0);
}
// "": all of its sites have as much.
std::string rests_beside_site(const Subject& s, const ir::Recovery& last) {
  if (!s.decision.body.in_space || last.kind != ir::RecoveryKind::route) return "";
  const ir::Cells& cells = s.module[last.zone].cells;
  for (const ir::SiteTable::Place& place : s.module[last.site].places) {
    const auto column = (place.x_mm - cells.origin_x_mm) / cells.cell_mm;
    const auto row = (place.y_mm - cells.origin_y_mm) / cells.cell_mm;
    const auto at = static_cast<std::size_t>(row * cells.columns + column);
    if (at < cells.clearance_mm_lo.size() && cells.clearance_mm_lo[at] >= back_mm(s, last))
      continue;
    return quoted(last.name) + " may come to rest " + metres(s.decision.body.end_reach_mm) +
           " from " + quoted(s.module[last.site].name) + ", and control is given back there with " +
           "a clearance of " + metres(back_mm(s, last));
  }
  return "";
}

// In space the hold of who moves leads the robot, which follows as long as its brake is not spent:
// beyond, nothing is known of its ways. "": it follows.
std::string falls_behind(const Subject& s, const ir::Recovery& recovery) {
  if (!s.decision.body.in_space) return "";
  const Rational most = analysis::follows_up_to(s.kind, s.decision.period_us);
  for (const ir::Recovery* step : ir::steps_of(recovery)) {
    const bool carries = ir::moves(step->kind) || step->kind == ir::RecoveryKind::land;
    const Rational speed(static_cast<long>(step->speed_mmps), 1000);
    if (!carries || speed <= most) continue;
    return quoted(recovery.name) + " leads the robot at " + to_decimal(speed) +
           " m/s, and its brake is strong enough to follow at up to " +
           to_decimal(
               Rational(std::max<std::int64_t>(floor_to_int(Rational(most * 1000)), 0), 1000)) +
           " m/s";
  }
  return "";
}

// What moves is gated by distances to others. How long it waits for them nothing bounds but what is
// declared (language rule 6.7): whoever writes `held` accepts that, and the proof is one of all the
// rest. A run in which a battery fails counts against the monitor's own recovery, unless something
// else may have spent the charge that the specification accepts.
Obligation as_long_as_declared(const Subject& s, std::size_t driving, const ir::Monitor& judged,
                               Obligation o) {
  const ir::Decision& d = s.decision;
  const bool gated = std::ranges::any_of(
      d.monitors, [](const ir::Monitor& m) { return atoms_of(m.property).distance; });
  const bool alone = d.robots == 1 && !d.open_fleet;
  if (!gated || alone || !s.kind.energy || !atoms_of(judged.property).charge) return o;
  if (!moves_within_zones(d.monitors[driving].recovery)) return o;
  o.status = Status::acknowledged;
  o.method = "declared";
  o.because += ", as long as others keep it waiting within `held`, " +
               seconds(s.kind.energy->held.value) + " in all";
  o.declared = o.kind == Kind::p2a && std::ranges::none_of(d.acknowledgements, [&](const auto& a) {
                 return a.monitor == judged.name;
               });
  return o;
}

// Of zones that come and go; each of the monitors that a recovery drives for leads out as well.
std::string doubt_of_windows(const Subject& s, std::size_t driving, std::size_t judged) {
  const ir::Monitor& m = s.decision.monitors[judged];
  if (!analysis::has_windows(m.property)) return "";
  const std::string& recovery = s.decision.monitors[driving].recovery.name;
  if (recovery == m.recovery.name) return doubt_of_leaving(s, judged);
  return quoted(recovery) + " does not lead out of zones that come and go in time";
}

// Why it is not shown that the recovery of one monitor keeps the property of another one, or its
// own; "": it is.
std::string doubt_about(const Subject& s, std::size_t k, std::size_t judged) {
  const ir::Block& property = s.decision.monitors[judged].property;
  const ir::Recovery& recovery = s.decision.monitors[k].recovery;
  if (std::string behind = falls_behind(s, recovery); !behind.empty()) return behind;
  if (std::string windows = doubt_of_windows(s, k, judged); !windows.empty()) return windows;
  if (!moves_within_zones(recovery)) return "";
  const Atoms atoms = atoms_of(property);
  if (atoms.charge || atoms.energy) {
    if (std::string off = off_its_dock(s, ir::last_step(recovery)); !off.empty()) return off;
  }
  return doubt_of_zones(s, k, judged);
}
void claim_windows(const Subject& s, std::size_t judged, Obligation& o) {
  const ir::Monitor& m = s.decision.monitors[judged];
  if (!analysis::has_windows(m.property)) return;
  o.because += ", and leads out before a zone comes or goes, within " +
               seconds(Rational(static_cast<long>(m.recovery.leave_us), 1'000'000));
  o.claims.push_back(leaves_claim(s, judged));
}
std::string acknowledging(const std::string& recovery, const std::string& monitor) {
  return "`acknowledge " + recovery + " may break " + monitor + " \"why\"` accepts that";
}
Obligation doubted(Obligation o, std::string why) {
  o.status = Status::unknown;
  o.method = "no proof";
  o.because = std::move(why);
  o.claims.clear();
  return o;
}

// Farther from the boundary than its tables are exact they bound distances from below alone: who
// has enough may be taken for nearer, and is not given back; and a leg is refused that keeps what
// it has to. A recovery that looks for no more than is exact finds its ways as they are reckoned
// here.
std::string cut_short(const Subject& s, const ir::Recovery& last) {
  const ir::ZoneTable& zone = s.module[last.zone];
  const auto exact_mm = zone.tree.exact_inside_mm;
  const std::int64_t needs_mm = std::max(back_mm(s, last), last.route_clearance_mm);
  if (!exact_mm || *exact_mm >= needs_mm) return "";
  return "distances to the boundary of " + quoted(zone.name) + " are exact up to " +
         metres(*exact_mm) + ", and " + quoted(last.name) + " needs " + metres(needs_mm);
}

// Near the boundary a robot may be seen not to fit, and is led straight then. "": from everywhere.
std::string led_nowhere(const Subject& s, std::size_t k, const ir::Recovery& last) {
  const ir::ZoneTable& zone = s.module[last.zone];
  std::int64_t kept_mm = 0;
  const ir::Block& property = s.decision.monitors[k].property;
  for (const auto& either : analysis::surely_in(property, s.decision.facts.params)) {
    const bool here = either.size() == 1 && either[0].zone == last.zone;
    if (here) kept_mm = std::max(kept_mm, either[0].mm);
  }
  const ir::Cells& cells = zone.cells;
  const auto at = analysis::led_nowhere(analysis::edges_of(zone), cells, s.decision, last, kept_mm);
  if (!at) return "";
  const auto columns = static_cast<std::size_t>(cells.columns);
  const auto middle = [&](std::int64_t origin, std::size_t n) {
    return metres(origin + std::int64_t(n) * cells.cell_mm + cells.cell_mm / 2);
  };
  return "near (" + middle(cells.origin_x_mm, *at % columns) + ", " +
         middle(cells.origin_y_mm, *at / columns) + ") in " + quoted(zone.name) +
         " the robot may be seen to be outside, by its error of " +
         metres(s.decision.body.position_error_mm) +
         ", and no leg in sight leads to where it is seen to fit";
}

// Whether a robot fits into the zone at that place.
bool holds_body(const Subject& s, ir::ZoneIndex zone, const analysis::Stranded& part) {
  const Rational radius(static_cast<long>(s.decision.body.radius_mm), 1000);
  const geometry::Point at{analysis::metres_of(part.x_mm), analysis::metres_of(part.y_mm)};
  const geometry::Region& region = s.exact(zone);
  return region.contains(at) && square_to(region.rings(), at) >= radius * radius;
}

// Where no cell is clearly clearer than what is asked for the recheck does not find the way. "":
// one is, or all corners are on the grid, where it knows clearances to the millimetre.
std::string on_the_rim(const Subject& s, const ir::Recovery& last) {
  const ir::ZoneTable& zone = s.module[last.zone];
  const std::int64_t room_mm = analysis::room_mm(s.decision, last, zone);
  if (!ir::goes_back(last.kind) || is_on_grid(s, last.zone)) return "";
  if (room_mm >= last.return_clearance_mm + analysis::recheck_misses_mm) return "";
  return "no cell of " + quoted(zone.name) + " has more than " + metres(room_mm) +
         " of clearance, and to be seen by the recheck it takes " +
         metres(last.return_clearance_mm + analysis::recheck_misses_mm);
}

// Why ways over cells may not be those that the recovery takes, and what helps; "": they are.
struct Doubt {
  std::string why;
  const char* repair = "";
};
Doubt doubt_of_ways(const Subject& s, std::size_t k, const ir::Recovery& last) {
  if (std::string off = off_its_dock(s, last); !off.empty()) return {std::move(off)};
  if (std::string off = rests_beside_site(s, last); !off.empty()) return {std::move(off)};
  if (std::string cut = cut_short(s, last); !cut.empty()) {
    return {std::move(cut), "fewer vertices work, or less clearance that is asked for"};
  }
  if (std::string outside = led_nowhere(s, k, last); !outside.empty()) {
    return {std::move(outside), "a wider passage works, or less of an error"};
  }
  return {on_the_rim(s, last)};
}

Obligation without_end(const ir::ZoneTable& zone, Obligation o) {
  o.status = Status::unknown;
  o.because = analysis::name_as_written(zone) + " has no end, and a grid over all of it cells of " +
              metres(zone.cells.cell_mm) + ", which say nothing of ways around what bounds it";
  o.repair = "a recovery within a zone with an end";
  return o;
}

// A way from everywhere in the zone to where control is given back, as `liveness` finds them.
Obligation ways_back(const Subject& s, std::size_t k, Obligation o) {
  const ir::Recovery& recovery = s.decision.monitors[k].recovery;
  const ir::Recovery& last = ir::last_step(recovery);
  const ir::ZoneTable& zone = s.module[last.zone];
  o.method = "ways over cells";
  if (analysis::is_boundless(zone)) return without_end(zone, std::move(o));
  const analysis::Ways ways = analysis::ways_of(s.module, s.decision, last);
  if (!ways.stranded.empty()) {
    // rather one that has been looked at; of others a run may show as much
    const auto shut = analysis::shut_off(zone.cells, last, ways);
    const analysis::Stranded& part = shut.empty() ? ways.stranded.front() : shut.front();
    // where cells are too coarse for a way, the recovery may find one; and where they are so coarse
    // that nobody fits in the middle of one, no run begins there
    const bool fits = holds_body(s, last.zone, part);
    o.status = fits ? Status::refuted : Status::unknown;
    o.by_a_run = fits;
    if (fits) o.place_mm = {part.x_mm, part.y_mm};
    o.because =
        "from (" + metres(part.x_mm) + ", " + metres(part.y_mm) + ") in " + quoted(zone.name) +
        (shut.empty() ? " no way over its cells has been found to where control is given back"
                      : " no way over its cells leads to where control is given back");
    if (!fits) return o;
    // the part may be wide itself, and what leads out of it narrow
    if (part.clearance_mm < last.return_clearance_mm + zone.cells.cell_mm) {
      o.because += ": it is about " + metres(2 * part.clearance_mm) + " wide there, as cells of " +
                   metres(zone.cells.cell_mm) + " tell, and control returns " +
                   metres(last.return_clearance_mm) + " from the boundary";
    }
    return o;
  }
  if (Doubt doubt = doubt_of_ways(s, k, last); !doubt.why.empty()) {
    o.status = Status::unknown;
    o.because = std::move(doubt.why);
    o.repair = doubt.repair;
    return o;
  }
  const auto bound = analysis::return_seconds(s.kind, s.module, s.decision, recovery);
  // a property of places may have its robot elsewhere when it engages
  const ir::Monitor& m = s.decision.monitors[k];
  const std::vector<ir::ZoneIndex> fences =
      analysis::sure_fences(m.property, s.decision.facts.params);
  const bool begins_inside =
      !atoms_of(m.property).clearance || std::ranges::find(fences, last.zone) != fences.end();
  o.status = Status::proved;
  o.because = "from everywhere in " + quoted(zone.name) + " a way leads to a clearance of " +
              metres(back_mm(s, last)) +
              (bound ? ", within " + seconds(*bound) +
                           (atoms_of(s.decision.monitors[k].property).energy
                                ? ", and what it takes to charge"
                            : begins_inside ? " in all"
                                            : " from there")
                     : ", along cells that it enters once each");
  Claim claim = with_cells({"ways",
                            {{"decision", s.decision.name},
                             {"monitor", o.monitor},
                             {"zone", zone.name},
                             {"route_mm", std::to_string(last.route_clearance_mm)},
                             {"extra_us", std::to_string(s.decision.return_extra_us)},
                             {"return_mm", std::to_string(back_mm(s, last))}}},
                           zone);
  if (zone.tree.exact_inside_mm) {
    claim.values["exact_mm"] = std::to_string(*zone.tree.exact_inside_mm);
  }
  o.claims.push_back(std::move(claim));
  o.claims.push_back(lemma_claim("return_reached"));
  return o;
}

// What is accepted need not be so. Of a monitor that asks for places or charge what is proved
// counts; of others the acknowledgement accepts what is reported otherwise (5030 and on), and no
// proof looks at that.
template <class Prove>
Obligation unless_accepted(const Subject& s, std::size_t k, Kind kind, const Prove& prove) {
  const ir::Monitor& m = s.decision.monitors[k];
  const std::string why = reason(s.decision, m.recovery.name, m.name);
  if (why.empty()) return prove();
  if (analysis::leads_back_to_places(m)) {
    if (Obligation shown = prove(); shown.status == Status::proved) return shown;
  }
  return acknowledged(start(s, k, kind), why);
}

Obligation keeps_its_own(const Subject& s, std::size_t k) {
  const ir::Monitor& m = s.decision.monitors[k];
  Obligation o = start(s, k, Kind::p2a);
  const Atoms atoms = atoms_of(m.property);
  o.status = Status::proved;
  o.method = std::string("template ") + ir::word_of(m.recovery.kind);
  if (m.recovery.kind == ir::RecoveryKind::external) {
    o.method = "claim, checked in every tick";
    o.because = quoted(m.recovery.name) + " is braked as soon as it might leave " +
                quoted(s.module[m.recovery.zone].name);
  } else if (atoms.only_facts()) {
    o.method = "no part of the robot";
    o.because = "what " + quoted(m.name) + " says depends on inputs alone";
  } else {
    o.because = quoted(m.recovery.name) +
                " brakes within what was found clear, and moves only where the property holds, "
                "gated by the distances to others";
    if (atoms.received) {
      o.because = quoted(m.recovery.name) +
                  " brakes within what was found clear, as long as the zone that was received "
                  "stays as it is";
    }
  }
  if (std::string doubt = doubt_about(s, k, k); !doubt.empty()) {
    return doubted(std::move(o), std::move(doubt));
  }
  o = as_long_as_declared(s, k, m, std::move(o));
  o.claims.push_back(limits_claim(s));
  o.claims.push_back(recovery_claim(s, k));
  claim_zones(s, k, m, o.claims);
  claim_windows(s, k, o);
  if (m.recovery.kind != ir::RecoveryKind::brake) o.claims.push_back(lemma_claim("way_pieces"));
  for (const std::string& lemma : lemmas_of(atoms, s.decision, m)) {
    o.claims.push_back(lemma_claim(lemma));
  }
  return o;
}

// What is only too high has control given back on the way down, at the latest where it ends.
Obligation landing_returns(const Subject& s, std::size_t k, Obligation o) {
  const ir::Monitor& m = s.decision.monitors[k];
  const std::int64_t end_mm = ir::last_step(m.recovery).land_mm;
  const std::int64_t gap_mm =
      analysis::return_clearance_mm(s.decision, m.lookahead.duration_us) + s.decision.body.hold_mm;
  std::optional<std::int64_t> most_mm;
  ir::for_each_comparison(m.property, [&](const ir::Block& block, const ir::AtLeast& c) {
    const auto most = ir::upper_bound(block, c);
    if (!most || most->leaf.kind != ir::Leaf::Kind::altitude) return;
    most_mm = std::min(most_mm.value_or(most->most), most->most);
  });
  const bool lowers = analysis::asks_of(m.property, s.decision.facts.params).only_lower;
  if (!lowers || !most_mm || m.return_when || end_mm + gap_mm > *most_mm) {
    o.status = Status::unknown;
    o.method = "no proof";
    o.because = "nothing shows that control is given back where " + quoted(m.recovery.name) +
                " ends, at " + metres(end_mm);
    return o;
  }
  o.status = Status::proved;
  o.method = "closed form";
  o.because = quoted(m.recovery.name) + " ends at " + metres(end_mm) + ", " +
              metres(*most_mm - end_mm) + " below the limit, and " + metres(gap_mm) + " are enough";
  o.claims.push_back({"landing",
                      {{"decision", s.decision.name},
                       {"monitor", m.name},
                       {"land_mm", std::to_string(end_mm)},
                       {"extra_us", std::to_string(s.decision.return_extra_us)},
                       {"gap_mm", std::to_string(gap_mm)}}});
  o.claims.push_back(recovery_claim(s, k));
  return o;
}

}  // namespace

namespace {

// Another recovery may drive instead, which leads on from where that of monitor `k` leads no
// further.
bool may_be_led_on(const ir::Decision& d, std::size_t k) {
  const std::size_t many = d.coordinated ? d.monitors.size() : k;
  return std::any_of(d.monitors.begin(), d.monitors.begin() + std::ptrdiff_t(many),
                     [&](const ir::Monitor& m) {
                       return m.recovery.name != d.monitors[k].recovery.name &&
                              ir::last_step(m.recovery).kind != ir::RecoveryKind::brake;
                     });
}

// A monitor that asks for more than its property, to let go.
Obligation by_its_condition(const Subject& s, std::size_t k, Obligation o) {
  const ir::Monitor& m = s.decision.monitors[k];
  if (o.status != Status::proved || !m.return_when) return o;
  if (m.returns.how == ir::Returns::How::itself) return o;
  if (m.returns.how == ir::Returns::How::told) {
    o.because += "; its return condition waits for inputs";
    return o;
  }
  Obligation open = start(s, k, Kind::p2b);
  open.method = "no proof";
  open.because = "that `return when` of " + quoted(m.name) + " holds where " +
                 quoted(m.recovery.name) + " leads is not shown";
  open.repair = "a condition on what it leads to works, or `hold when violated \"why\"`";
  if (m.returns.shown_mmps) {
    const std::string mmps = to_decimal(Rational(*m.returns.shown_mmps, 1000)) + " m/s";
    open.because += ": samples may show a robot at rest at up to " + mmps;
    open.repair = "a limit of " + mmps + " in `return when` works, or `hold when violated \"why\"`";
  }
  if (m.returns.stuck_mm) {
    open.status = Status::refuted;
    open.method = by_geometry;
    open.place_mm = m.returns.stuck_mm;
    // the condition may hold on the way to the site
    const bool routes = ir::last_step(m.recovery).kind == ir::RecoveryKind::route;
    open.by_a_run = routes || may_be_led_on(s.decision, k);
    open.because = "at rest at (" + metres(open.place_mm->first) + ", " +
                   metres(open.place_mm->second) + ") " + quoted(m.recovery.name) +
                   " leads no further, and `return when` of " + quoted(m.name) +
                   " does not hold there";
    open.repair = routes ? "a site within what it asks for works"
                         : "a recovery within what it asks for works";
  }
  return open;
}
Obligation led_back(const Subject& s, std::size_t k, Obligation o);

}  // namespace

Obligation recovery_keeps(const Subject& s, std::size_t k) {
  return unless_accepted(s, k, Kind::p2a, [&] { return keeps_its_own(s, k); });
}

Obligation control_returns(const Subject& s, std::size_t k) {
  const ir::Monitor& m = s.decision.monitors[k];
  Obligation o = start(s, k, Kind::p2b);
  if (!m.hold_reason.empty()) return acknowledged(std::move(o), m.hold_reason);
  o = unless_accepted(s, k, Kind::p2b, [&] {
    return by_its_condition(s, k, led_back(s, k, start(s, k, Kind::p2b)));
  });
  o.patience_s = analysis::patience_s(s.kind, s.module, s.decision, m.recovery);
  if (atoms_of(m.property).charge && s.kind.energy && s.kind.energy->charge.value > 0) {
    o.patience_s += ceil_to_int(Rational(1 / s.kind.energy->charge.value));  // from empty to full
  }
  return o;
}

namespace {

// Ways over cells lead nowhere up or down.
bool asks_of_heights(const Subject& s, std::size_t k, const Atoms& atoms) {
  const auto fences = analysis::fences_of(s.decision.monitors[k].property, s.decision.facts.params);
  return atoms.altitude || std::ranges::any_of(fences, [&](ir::ZoneIndex fence) {
           return s.module[fence].has_height();
         });
}
Obligation keeps_its_height(const Subject& s, std::size_t k, Obligation o) {
  const ir::Monitor& m = s.decision.monitors[k];
  o.status = Status::unknown;
  o.method = "no proof";
  o.because = quoted(m.recovery.name) + " keeps its height, and that " + quoted(m.name) +
              " gives control back there is not shown";
  return o;
}

Obligation led_back(const Subject& s, std::size_t k, Obligation o) {
  const ir::Monitor& m = s.decision.monitors[k];
  const ir::RecoveryKind last = ir::last_step(m.recovery).kind;
  const Atoms atoms = atoms_of(m.property);
  const bool rests =
      last == ir::RecoveryKind::brake || (last == ir::RecoveryKind::land && atoms.only_speed());
  if (atoms.only_facts() || rests) {
    o.status = Status::proved;
    o.method = "closed form";
    o.because = atoms.only_facts()
                    ? "a robot at rest keeps its place until the inputs let it go on"
                    : "at rest the robot is as slow as every limit of " + quoted(m.name);
    o.claims.push_back(limits_claim(s));
    o.claims.push_back(recovery_claim(s, k));
    return atoms.only_speed() ? returned_at_rest(s, k, std::move(o)) : o;
  }
  if (std::string behind = falls_behind(s, m.recovery); !behind.empty()) {
    return doubted(std::move(o), std::move(behind));
  }
  if (ir::moves(last) && last != ir::RecoveryKind::yield) {
    const bool legs = s.decision.body.in_space && last != ir::RecoveryKind::route;
    Obligation ways = legs                           ? legs_back(s, k)
                      : asks_of_heights(s, k, atoms) ? keeps_its_height(s, k, std::move(o))
                                                     : ways_back(s, k, std::move(o));
    if (ways.status != Status::proved) {
      // wherever ways lead, some of them may end where nothing more happens
      Obligation rest = returned_at_rest(s, k, ways);
      const bool ends = rest.status == Status::refuted && rest.method == by_geometry;
      return ends && !rest.by_a_run ? rest : ways;
    }
    if (s.decision.robots > 1 || s.decision.open_fleet) {
      ways.because += ", as soon as no other robot stands in its way";
    }
    return returned_at_rest(s, k, std::move(ways));
  }
  if (last == ir::RecoveryKind::land) return landing_returns(s, k, std::move(o));
  if (last == ir::RecoveryKind::yield) return makes_room(s, k, std::move(o));
  o.status = Status::unknown;
  o.method = "no proof";
  o.because = "nothing is claimed of where " + quoted(m.recovery.name) + " leads";
  o.repair = "a template that leads back, or `hold when violated \"why\"`";
  return o;
}

}  // namespace

bool is_on_grid(const Subject& s, ir::ZoneIndex zone) {
  constexpr std::int32_t far_mm = 10'000'000;
  const auto is_near = [](const geometry::GridPoint& p) {
    return std::abs(p.x_mm) < far_mm && std::abs(p.y_mm) < far_mm;
  };
  const ir::ZoneTable& table = s.module[zone];
  return !table.has_height() && geometry::is_on_grid(s.exact(zone)) &&
         std::ranges::all_of(analysis::edges_of(table), is_near, &geometry::EdgeRow::a);
}

bool slow_enough(const Subject& s, std::size_t driving, std::size_t judged) {
  const analysis::HowItLies lies = how_it_lies(s);
  return analysis::keeps_speed_limits({s.spec, s.written, s.module, s.decision, lies}, driving,
                                      judged);
}

namespace {

// Of a recovery that keeps what the other monitor says as far as its robot goes, while others may
// break that: the other monitor's own recovery takes over, and what that may break is acknowledged
// (6003, 6004); or nobody does.
Obligation among_others(const Subject& s, std::size_t driving, std::size_t judged, Obligation o) {
  const ir::Monitor& i = s.decision.monitors[driving];
  const ir::Monitor& j = s.decision.monitors[judged];
  const std::string why = reason(s.decision, i.recovery.name, j.name);
  if (!why.empty()) return acknowledged(std::move(o), why);
  const std::string itself = quoted(i.recovery.name) + " keeps " + quoted(j.name) +
                             " as far as its own robot goes, and others may break it";
  if (judged < driving && !s.decision.coordinated && i.recovery.name != j.recovery.name) {
    o.because = itself + ": " + quoted(j.name) + " ranks higher, and " + quoted(j.recovery.name) +
                " takes over as soon as they might";
    return o;
  }
  const bool brakes = i.recovery.kind == ir::RecoveryKind::brake;
  if (brakes && i.recovery.name == j.recovery.name && analysis::holds_at_rest(s.decision, j)) {
    o.because += ", whose recovery it is, too: whoever comes near finds a robot that stands";
    return o;
  }
  o = doubted(std::move(o), itself);
  o.repair = acknowledging(i.recovery.name, j.name);
  return o;
}

// Of zones that come and go, whose monitor takes over from every recovery that it outranks.
bool leads_out_itself(const Subject& s, std::size_t driving, std::size_t judged) {
  const ir::Monitor &i = s.decision.monitors[driving], &j = s.decision.monitors[judged];
  return judged < driving && !s.decision.coordinated && i.recovery.name != j.recovery.name &&
         analysis::has_windows(j.property);
}

std::string text_of(const std::vector<std::int64_t>& place_mm) {
  std::string text;
  for (const std::int64_t mm : place_mm) text += (text.empty() ? "(" : ", ") + metres(mm);
  return text + ")";
}

// What may be said, of a robot at rest at a place, by any inputs.
struct Says {
  bool yes = false, no = false;
};
// One input says it, or that it is not so: it may be told both.
bool may_be_either(const ir::Block& fact) {
  ir::ValueId id = fact.result;
  while (const auto* negated = std::get_if<ir::Not>(&fact[id].op)) id = negated->a;
  const ir::Op& op = fact[id].op;
  return std::holds_alternative<ir::InputTruth>(op) || std::holds_alternative<ir::InputIs>(op);
}
// `told`: how many inputs it speaks of. nullopt: something else matters.
std::optional<Says> says_at(const Subject& s, const ir::Block& block, ir::ValueId id,
                            const std::vector<std::int64_t>& place_mm, int& told) {
  const ir::Op& op = block[id].op;
  const auto* both = std::get_if<ir::And>(&op);
  const auto* either = std::get_if<ir::Or>(&op);
  if (both != nullptr || either != nullptr) {
    const auto a = says_at(s, block, both ? both->a : either->a, place_mm, told);
    const auto b = says_at(s, block, both ? both->b : either->b, place_mm, told);
    if (!a || !b) return std::nullopt;
    if (both != nullptr) return Says{a->yes && b->yes, a->no || b->no};
    return Says{a->yes || b->yes, a->no && b->no};
  }
  if (const auto* negated = std::get_if<ir::Not>(&op)) {
    const auto of_it = says_at(s, block, negated->a, place_mm, told);
    return of_it ? std::optional(Says{of_it->no, of_it->yes}) : std::nullopt;
  }
  if (const auto* fact = std::get_if<ir::Fact>(&op)) {
    ++told;
    return may_be_either(s.decision.facts.monitors[fact->index].property)
               ? std::optional(Says{true, true})
               : std::nullopt;
  }
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  if (compare == nullptr) return std::nullopt;
  const auto least = ir::lower_bound(block, *compare, s.decision.facts.params);
  const bool of_zone = least && least->leaf.kind == ir::Leaf::Kind::clearance;
  if (!of_zone || place_mm.size() != 2) return std::nullopt;
  const ir::ZoneTable& zone = s.module[ir::ZoneIndex{least->leaf.table}];
  if (zone.has_height()) return std::nullopt;
  const double spare =
      analysis::outline::Outline::of(zone).clearance({double(place_mm[0]), double(place_mm[1])}) -
      double(s.decision.body.radius_mm + least->need.strictest);
  return Says{spare >= 0, spare < 0};
}
// Whether a robot that rests at a place keeps what a monitor says, or does not, as one input says.
bool inputs_decide(const Subject& s, const ir::Monitor& m,
                   const std::vector<std::int64_t>& place_mm) {
  if (atoms_of(m.property).only_facts()) return true;
  int told = 0;
  const auto says = says_at(s, m.property, m.property.result, place_mm, told);
  return says && told == 1 && says->yes && says->no;
}

// Where a monitor is engaged from the start on: at rest beside a boundary of the zone that its
// recovery moves within, nearer than control is given back.
std::optional<std::pair<std::int64_t, std::int64_t>> engaged_at(const Subject& s,
                                                                const ir::Monitor& m) {
  namespace outline = analysis::outline;
  constexpr double spare_mm = 10;
  const ir::Body& b = s.decision.body;
  const ir::Recovery& last = ir::last_step(m.recovery);
  const double near = double(b.radius_mm + b.hold_mm + b.position_error_mm) + spare_mm;
  if (!ir::moves(last.kind) || near >= double(last.return_clearance_mm)) return std::nullopt;
  const outline::Outline zone = outline::Outline::of(s.module[last.zone]);
  std::optional<outline::P> found;
  double longest = 0;
  for (const outline::Segment& edge : zone.edges()) {
    const outline::P along = edge.b - edge.a;
    const double length = outline::norm(along);
    for (const double side : {-1.0, 1.0}) {
      const outline::P inwards{-side * along.y / length, side * along.x / length};
      const outline::P at = edge.a + 0.5 * along + near * inwards;
      if (length <= longest || zone.clearance(at) < near - 1) continue;
      longest = length;
      found = at;
    }
  }
  if (!found) return std::nullopt;
  return std::pair(std::int64_t(found->x), std::int64_t(found->y));
}

// The matrix says that it may become false, and that nobody takes over in time.
Obligation broken(const Subject& s, const analysis::Entry& entry, std::size_t driving,
                  std::size_t judged, Obligation o) {
  const ir::Monitor& i = s.decision.monitors[driving];
  const ir::Monitor& j = s.decision.monitors[judged];
  const std::string why = reason(s.decision, i.recovery.name, j.name);
  o.because = entry.why;
  if (!entry.conflict.empty()) o.because += "; " + analysis::conflict_text(s.decision, entry);
  o.repair = entry.help.empty() && !entry.within.empty() ? entry.within.front().help + " works"
                                                         : entry.help;
  if (!why.empty()) return acknowledged(std::move(o), why);
  if (atoms_of(j.property).received) return o;  // that it happens is not shown either
  o.status = Status::refuted;
  o.method = "geometry and bounds";
  // what inputs may ask for, nobody has to drive to
  o.by_a_run = !entry.while_told;
  o.starts = starts_of_damage(s, driving, judged);
  if (atoms_of(j.property).charge) o.place_mm = engaged_at(s, i);
  if (!o.place_mm) o.place_mm = i.returns.stuck_mm;  // it waits there for ever
  if (entry.unending) {
    o.by_a_run = false;
    o.because += "; whoever keeps " + quoted(i.name) +
                 " engaged for as long as a battery lasts makes " + quoted(j.name) + " fail";
    o.unending = true;
  }
  const bool of_inputs = atoms_of(i.property).only_facts();
  if (of_inputs) o.unmet = i.name;
  if (o.unending) return o;
  // that its way leads there breaks a limit of speed only at that speed, which a run shows
  if (!o.starts.empty() && !atoms_of(j.property).speed &&
      inputs_decide(s, i, o.starts.front().place_mm)) {
    o.by_a_run = false;
    o.because += "; where inputs ask for it at " + text_of(o.starts.front().place_mm) +
                 ", its way leads out of what " + quoted(j.name) + " says";
  }
  return o;
}

}  // namespace

Obligation keeps_others(const Subject& s, const analysis::Entry& entry, std::size_t driving,
                        std::size_t judged) {
  const ir::Monitor& i = s.decision.monitors[driving];
  const ir::Monitor& j = s.decision.monitors[judged];
  Obligation o = start(s, judged, Kind::keeps);
  o.recovery = i.recovery.name;
  const std::string why = reason(s.decision, i.recovery.name, j.name);
  if (entry.keeping == analysis::Keeping::broken) {
    return broken(s, entry, driving, judged, std::move(o));
  }
  o.claims.push_back(recovery_claim(s, driving));
  o.status = Status::proved;
  const bool waits =
      entry.keeping == analysis::Keeping::kept && leads_out_itself(s, driving, judged);
  if (entry.keeping == analysis::Keeping::guarded || waits) {
    o.method = "priority";
    o.because = quoted(j.name) + " ranks higher, is judged under the motion of " +
                quoted(i.recovery.name) +
                " and takes over: " + (waits ? doubt_of_windows(s, driving, judged) : entry.why);
    o.claims.push_back(
        {"outranks", {{"decision", s.decision.name}, {"higher", j.name}, {"lower", i.name}}});
    return o;
  }
  if (entry.keeping == analysis::Keeping::coordinated) {
    o.method = "coordination";
    o.because = quoted(j.name) + " is judged under the motion of " + quoted(i.recovery.name) +
                ", and when it fails a recovery drives that keeps it: " + entry.why;
    o.claims.push_back(
        {"coordinated", {{"decision", s.decision.name}, {"driving", i.name}, {"judged", j.name}}});
    return o;
  }
  std::string doubt = doubt_about(s, driving, judged);
  const bool is_too_fast = !slow_enough(s, driving, judged);
  if (is_too_fast) {
    const Rational fastest(analysis::fastest_while_driving(s.decision, driving), 1000);
    doubt = quoted(i.recovery.name) + " drives at up to " + to_decimal(fastest) + " m/s, and " +
            quoted(j.name) + " allows less";
  }
  if (!doubt.empty() && !why.empty()) return acknowledged(std::move(o), why);
  if (!doubt.empty()) {
    o = doubted(std::move(o), std::move(doubt));
    if (!is_too_fast || !s.is_read) return o;  // nobody looks for a run
    o.status = Status::refuted;
    o.method = "geometry and bounds";
    o.by_a_run = true;
    o.starts = starts_of_damage(s, driving, judged);
    return o;
  }
  o.method = "geometry and bounds";
  o.because = quoted(i.recovery.name) + " keeps " + quoted(j.name);
  o = as_long_as_declared(s, driving, j, std::move(o));
  claim_zones(s, driving, j, o.claims);
  claim_windows(s, judged, o);
  if (atoms_of(j.property).charge && i.recovery.name != j.recovery.name) {
    if (const auto lasts = lasting_claim(s, driving)) o.claims.push_back(*lasts);
  }
  return analysis::others_may_break(s.decision, j) ? among_others(s, driving, judged, std::move(o))
                                                   : o;
}

}  // namespace rtac::verify
