// P2b: from everywhere in the zone of a recovery a way leads to where control is given back.
#include <algorithm>

#include "compiler/analysis/boundless.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/in_sight.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/liveness.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/return_set.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/analysis/tables.h"
#include "compiler/analysis/waits.h"
#include "compiler/analysis/windows.h"
#include "compiler/ir/linear.h"
#include "compiler/sema/visit.h"
#include "compiler/support/words.h"
#include "compiler/verify/about_recovery.h"
#include "compiler/verify/atoms.h"
#include "compiler/verify/other_recoveries.h"

namespace rtac::verify {

bool is_on_grid(const Subject& s, ir::ZoneIndex zone) {
  constexpr std::int32_t far_mm = 10'000'000;
  const auto is_near = [](const geometry::GridPoint& p) {
    return std::abs(p.x_mm) < far_mm && std::abs(p.y_mm) < far_mm;
  };
  const ir::ZoneTable& table = s.module[zone];
  return !table.has_height() && geometry::is_on_grid(s.exact(zone)) &&
         std::ranges::all_of(analysis::edges_of(table), is_near, &geometry::EdgeRow::a);
}

namespace {

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
  const auto at = analysis::led_nowhere(analysis::edges_of(zone), cells, s.decision, last, kept_mm,
                                        s.exact(last.zone));
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

// Whether to name a part that has been looked at: it is no sliver beside others, of which a run may
// show as much.
bool is_looked_at(const std::vector<analysis::Stranded>& shut, const analysis::Ways& ways) {
  constexpr std::int64_t sliver = 10;
  return !shut.empty() && shut.front().cells * sliver >= ways.stranded.front().cells;
}

// Inputs with which no other monitor has a recovery drive, wherever the robot is; none: nobody
// knows of any, or none is asked.
std::vector<analysis::ToldInput> none_else_asks(const Subject& s, std::size_t k) {
  std::vector<const sema::Expr*> others;
  for (std::size_t other = 0; other < s.written.priority.size(); ++other) {
    const sema::Expr& always = *s.monitor(other).always;
    if (other != k && !analysis::inputs_in(s.spec, always).empty()) others.push_back(&always);
  }
  return analysis::told_at_once(s.spec, {}, others).inputs;
}

// Whether time alone may have a robot that stands given back, or led on.
bool waits_for_time(const ir::Monitor& m) {
  constexpr std::int64_t soon_us = 5'000'000;
  const bool asks = m.return_when && m.returns.how != ir::Returns::How::itself;
  return asks || ir::steps_of(m.recovery).size() > 1 || m.returns.after_us > soon_us ||
         analysis::has_windows(m.property);
}

// The clearest place of the cell in the middle of a part: in the middle of a passage there is more
// room than cells tell, which a way over them has to keep. Measured there a robot stays there;
// none: control may be given back at once.
std::optional<Start> clearest_in_middle(const Subject& s, std::size_t k, const ir::Recovery& last,
                                        const analysis::Stranded& part) {
  if (waits_for_time(s.decision.monitors[k])) return std::nullopt;
  const geometry::Region& region = s.exact(last.zone);
  const std::int64_t half_mm = s.module[last.zone].cells.cell_mm / 2;
  const Rational back_m = analysis::metres_of(last.return_clearance_mm);
  Start clearest;
  Rational most = 0;
  for (int i = 0; i < 9; ++i) {
    const std::int64_t x_mm = part.middle_x_mm + (i % 3 - 1) * half_mm;
    const std::int64_t y_mm = part.middle_y_mm + (i / 3 - 1) * half_mm;
    const geometry::Point at{analysis::metres_of(x_mm), analysis::metres_of(y_mm)};
    if (!region.contains(at)) continue;
    const Rational square = square_to(region.rings(), at);
    if (square <= most) continue;
    most = square;
    clearest.place_mm = {x_mm, y_mm};
  }
  if (most == 0 || most >= back_m * back_m) return std::nullopt;
  clearest.seen_there = true;
  clearest.told = none_else_asks(s, k);
  return clearest;
}

// In the middle of a part, and of the largest others.
std::vector<Start> starts_in(const Subject& s, std::size_t k, const ir::Recovery& last,
                             const analysis::Stranded& part, const analysis::Ways& ways) {
  constexpr std::size_t most = 4;
  std::vector<Start> all{{{part.middle_x_mm, part.middle_y_mm}}};
  if (auto clearest = clearest_in_middle(s, k, last, part)) {
    all.insert(all.begin(), *std::move(clearest));
  }
  for (const analysis::Stranded& other : ways.stranded) {
    if (all.size() == most) break;
    const bool same = other.x_mm == part.x_mm && other.y_mm == part.y_mm;
    if (!same && holds_body(s, last.zone, other)) {
      all.push_back({{other.middle_x_mm, other.middle_y_mm}});
    }
  }
  return all;
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

// Why ways over cells may not be those that the recovery takes.
Doubt doubt_of_ways(const Subject& s, std::size_t k, const ir::Recovery& last) {
  if (std::string off = sema::asks_for_charge(s.monitor(k)) ? off_its_dock(s, last) : "";
      !off.empty()) {
    return {std::move(off)};
  }
  if (std::string off = rests_beside_site(s, last); !off.empty()) return {std::move(off)};
  if (std::string cut = cut_short(s, last); !cut.empty()) {
    return {std::move(cut), "fewer vertices are needed, or less clearance that is asked for"};
  }
  if (std::string outside = led_nowhere(s, k, last); !outside.empty()) {
    return {std::move(outside), "a wider passage is needed, or less of an error"};
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
    const auto shut = analysis::shut_off(zone.cells, last, ways);
    const bool looked_at = is_looked_at(shut, ways);
    const analysis::Stranded& part = looked_at ? shut.front() : ways.stranded.front();
    // where cells are too coarse for a way, the recovery may find one; and where they are so coarse
    // that nobody fits in the middle of one, no run begins there
    const bool fits = holds_body(s, last.zone, part);
    o.status = fits ? Status::refuted : Status::unknown;
    o.by_a_run = fits;
    if (fits) {
      o.place_mm = {part.x_mm, part.y_mm};
      o.starts = starts_in(s, k, last, part, ways);
    }
    o.because =
        "from (" + metres(part.x_mm) + ", " + metres(part.y_mm) + ") in " + quoted(zone.name) +
        (looked_at ? " no way over its cells leads to where control is given back"
                   : " no way over its cells has been found to where control is given back");
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

// What is only too high has control given back on the way down, at the latest where it ends.
Obligation landing_returns(const Subject& s, std::size_t k, Obligation o) {
  const ir::Monitor& m = s.decision.monitors[k];
  const std::int64_t end_mm = ir::last_step(m.recovery).land_mm;
  const std::int64_t gap_mm =
      analysis::return_height_mm(s.decision, m.lookahead.duration_us) + s.decision.body.hold_mm;
  std::optional<std::int64_t> most_mm;
  ir::for_each_comparison(m.property, [&](const ir::Block& block, const ir::AtLeast& c) {
    const auto most = ir::upper_bound(block, c);
    if (!most || most->leaf.kind != ir::Leaf::Kind::altitude) return;
    most_mm = std::min(most_mm.value_or(most->most), most->most);
  });
  const bool lowers = analysis::asks_of(m.property, s.decision.facts.params).only_lower;
  if (lowers && most_mm && end_mm + gap_mm > *most_mm) {
    o.status = Status::refuted;
    o.method = "closed form";
    o.by_a_run = true;
    o.because = quoted(m.recovery.name) + " ends at " + metres(end_mm) + ", and control is given " +
                "back no higher than " + metres(*most_mm - gap_mm) + ", " + metres(gap_mm) +
                " below the limit";
    if (s.is_read) o.mends = {OtherLanding{m.recovery.name, *most_mm - gap_mm}};
    return o;
  }
  if (!lowers || !most_mm) {
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

// A condition on where the robot is and how fast, and on nothing that others have a hand in.
bool asks_itself_alone(const ir::Block& when) {
  const Atoms asked = atoms_of(when);
  if (asked.charge || asked.energy || asked.agent || asked.others || asked.received) return false;
  return std::ranges::none_of(when.values, [](const ir::Value& v) {
    return std::holds_alternative<ir::Fact>(v.op) || std::holds_alternative<ir::InputTruth>(v.op) ||
           std::holds_alternative<ir::InputIs>(v.op);
  });
}

// A monitor that asks for more than its property, to let go.
Obligation by_its_condition(const Subject& s, std::size_t k, Obligation o) {
  const ir::Monitor& m = s.decision.monitors[k];
  if (o.status != Status::proved || !m.return_when) return o;
  if (m.returns.how == ir::Returns::How::itself) return o;
  if (m.returns.how == ir::Returns::How::told) {
    o.because += "; its return condition waits for inputs, or for samples of another age";
    return o;
  }
  Obligation open = blank(s, k, Kind::p2b);
  open.method = "no proof";
  open.because = "that `return when` of " + quoted(m.name) + " holds where " +
                 quoted(m.recovery.name) + " leads is not shown";
  open.repair = "a condition on what it leads to is needed, or `hold when violated \"why\"`";
  if (m.returns.shown_mmps) {
    const std::string mmps = to_decimal(Rational(*m.returns.shown_mmps, 1000)) + " m/s";
    open.because += ": samples may show a robot at rest at up to " + mmps;
    open.repair = "a limit of " + mmps + " in `return when` works, or `hold when violated \"why\"`";
  }
  if (m.returns.shown_high_mm) {
    const std::string height = metres(*m.returns.shown_high_mm);
    open.because += ": it ends at " + metres(ir::last_step(m.recovery).land_mm) +
                    ", where samples may show a robot up to " + height;
    open.repair =
        "a limit of " + height + " in `return when` works, or `hold when violated \"why\"`";
    if (m.returns.lands_above) {
      open.status = Status::refuted;
      open.by_a_run = true;
    }
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
    open.repair = routes ? "a site within what it asks for is needed"
                         : "a recovery within what it asks for is needed";
    if (s.is_read) open.mends = recoveries_to_its_condition(s, k);
  } else if (open.status == Status::unknown && asks_itself_alone(*m.return_when)) {
    auto starts = starts_stranded_in_space(s, k);
    if (!starts.empty()) {
      return shown_from(s, ir::last_step(m.recovery), std::move(open), std::move(starts));
    }
  }
  return open;
}

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

// Who moves has to come to where its `return when` holds, whatever inputs say.
bool returns_at_a_place(const ir::Monitor& m) {
  const ir::RecoveryKind last = ir::last_step(m.recovery).kind;
  if (!m.return_when || !ir::moves(last) || last == ir::RecoveryKind::yield) return false;
  const Atoms asked = atoms_of(*m.return_when);
  return asked.clearance || asked.altitude || asked.charge;
}

Obligation led_back(const Subject& s, std::size_t k, Obligation o) {
  const ir::Monitor& m = s.decision.monitors[k];
  const ir::RecoveryKind last = ir::last_step(m.recovery).kind;
  const Atoms atoms = atoms_of(m.property);
  const bool rests = last == ir::RecoveryKind::brake ||
                     (last == ir::RecoveryKind::land &&
                      (atoms.only_speed() || analysis::holds_at_rest(s.decision, m)));
  if ((atoms.only_facts() && !returns_at_a_place(m)) || rests) {
    o.status = Status::proved;
    o.method = "closed form";
    o.because = atoms.only_facts()
                    ? "a robot at rest keeps its place until the inputs let it go on"
                    : "at rest the robot is as slow as every limit of " + quoted(m.name);
    if (atoms.agent && !analysis::holds_in_hold(s.decision, m)) {
      o.because += ", as soon as no agent is as near as it asks";
    }
    o.claims.push_back(limits_claim(s));
    o.claims.push_back(recovery_claim(s, k));
    const bool asks = atoms.only_speed() || atoms.charge || judges_others(m.property);
    return asks && !atoms.only_facts() ? returned_at_rest(s, k, std::move(o)) : o;
  }
  if (Doubt behind = falls_behind(s, m.recovery); !behind.why.empty()) {
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
    if (std::ranges::any_of(s.decision.monitors, [](const ir::Monitor& each) {
          return atoms_of(each.property).agent;
        })) {
      ways.because += ", as soon as no agent stands in its way";
    }
    // which say nothing of when that is
    if (analysis::waits_for_inputs(m.property)) {
      ways.because += ", as soon as what " + quoted(m.name) +
                      " asks of inputs and of the ages of samples is so";
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

Obligation control_returns(const Subject& s, std::size_t k) {
  const ir::Monitor& m = s.decision.monitors[k];
  Obligation o = blank(s, k, Kind::p2b);
  if (!m.hold_reason.empty()) return acknowledged(std::move(o), m.hold_reason);
  o = unless_accepted(s, k, Kind::p2b, [&] {
    return told_at_once(s, k, by_its_condition(s, k, led_back(s, k, blank(s, k, Kind::p2b))));
  });
  o.patience_s += analysis::patience_s(s.kind, s.module, s.decision, m.recovery);
  const auto most = o.status == Status::refuted  // a run is to show it
                        ? analysis::return_seconds(s.kind, s.module, s.decision, m.recovery)
                        : std::nullopt;
  if (most) o.patience_s = std::max(o.patience_s, ceil_to_int(*most));
  std::int64_t waits_us = m.returns.after_us;
  for (const ir::Recovery* step : ir::steps_of(m.recovery)) waits_us += step->lasts_us;
  o.patience_s += ceil_to_int(Rational(static_cast<long>(waits_us), 1'000'000));
  if (atoms_of(m.property).charge && s.kind.energy && s.kind.energy->charge.value > 0) {
    o.patience_s += ceil_to_int(Rational(1 / s.kind.energy->charge.value));  // from empty to full
  }
  return o;
}

}  // namespace rtac::verify
