#include "compiler/analysis/well_formed.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "compiler/analysis/boundless.h"
#include "compiler/analysis/company.h"
#include "compiler/analysis/derive.h"
#include "compiler/analysis/dials.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/reach.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/repairs.h"
#include "compiler/analysis/return_condition.h"
#include "compiler/analysis/return_set.h"
#include "compiler/analysis/site_room.h"
#include "compiler/analysis/sites.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/travel.h"
#include "compiler/analysis/vacuous.h"
#include "compiler/analysis/widening.h"
#include "compiler/analysis/zone_trials.h"
#include "compiler/analysis/zones.h"
#include "compiler/ir/linear.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

using diag::Code;

// Value of the cell that holds (x, y); nullopt beyond the table.
std::optional<std::size_t> cell_at(const ir::Cells& cells, std::int64_t x_mm, std::int64_t y_mm) {
  const std::int64_t cx = (x_mm - cells.origin_x_mm) / cells.cell_mm;
  const std::int64_t cy = (y_mm - cells.origin_y_mm) / cells.cell_mm;
  if (x_mm < cells.origin_x_mm || y_mm < cells.origin_y_mm || cx >= cells.columns ||
      cy >= cells.rows) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(cy * cells.columns + cx);
}

class WellFormed {
 public:
  WellFormed(const sema::Spec& spec, const ir::Module& module, const ir::TableMap& tables,
             const ExactZones& exact, const HowItLies& lies, Trials* trials,
             diag::Engine& diagnostics)
      : spec_(spec),
        module_(module),
        tables_(tables),
        exact_(exact),
        lies_(lies),
        trials_(trials),
        diagnostics_(diagnostics) {}

  void run() {
    for (std::size_t i = 0; i < module_.decisions.size(); ++i) {
      const ir::Decision& decision = module_.decisions[i];
      if (decision.on_plan) continue;
      const Decided decided{spec_, spec_.decisions[i], module_, decision, lies_, trials_};
      for (diag::Diagnostic& found : empty_return_sets(decided, exact_)) {
        diagnostics_.report(std::move(found));
      }
      for (diag::Diagnostic& found : unkept_speed_limits(decided)) {
        diagnostics_.report(std::move(found));
      }
      for (diag::Diagnostic& found : unkept_company(decision)) {
        diagnostics_.report(std::move(found));
      }
      for (diag::Diagnostic& found : unkept_agents(decided)) {
        diagnostics_.report(std::move(found));
      }
      for (std::size_t k = 0; k < decision.monitors.size(); ++k) {
        const ir::Monitor& monitor = decision.monitors[k];
        for (const ir::Recovery* step : ir::steps_of(monitor.recovery)) cells(*step);
        exact_far_enough(decided, monitor);
        legs(decided, monitor);
        if (auto found = hopeless_return(decided, k, exact_); found && !is_told_of(*found)) {
          diagnostics_.report(std::move(*found));
        }
        site(decided, monitor);
        vacuous(decided, monitor);
      }
    }
  }

 private:
  // What cannot be built counts as false, and has been reported where it stands.
  bool is_told_of(const diag::Diagnostic& found) const {
    const auto& all = diagnostics_.all();
    return std::any_of(all.begin(), all.end(), [&](const diag::Diagnostic& d) {
      return diag::info(d.code).severity == diag::Severity::error && d.range && found.range &&
             d.range->file == found.range->file && d.range->begin == found.range->begin;
    });
  }
  void vacuous(const Decided& of, const ir::Monitor& monitor) {
    const auto k = static_cast<std::size_t>(&monitor - of.decision.monitors.data());
    const sema::Expr& written = *spec_[of.written.priority[k]].always;
    const CanBeTold told = told_to_be(spec_, written, false, ToldHow::exactly).can;
    const Vacuity vacuity = vacuity_of(module_, of.decision, monitor.property, told);
    if (vacuity.can_fail != CanFail::no) return;
    diag::Diagnostic d{};
    d.code = Code::monitor_vacuous;
    d.range = monitor.property[monitor.property.result].source;
    d.message = "the monitor `" + monitor.name + "` is never false, whatever the robots do";
    d.label = "finds nothing";
    for (const std::string& limit : vacuity.because) d.notes.push_back({std::nullopt, limit});
    d.help = vacuity.alone && d.notes.size() == 1
                 ? "a second robot in the fleet works, or leave the monitor out"
             : d.notes.empty() ? "a property that depends on the robot works"
                               : "a limit on the other side of that works";
    diagnostics_.report(std::move(d));
  }
  // A recovery searches cells: in a large zone they are wide, and all of a cell counts for as clear
  // as its worst place. Cells as narrow as can be are not asked: what they miss, straight ways
  // find. Where a route ends is asked of its site.
  void cells(const ir::Recovery& r) {
    if (!ir::moves(r.kind) || r.kind == ir::RecoveryKind::route) return;
    const ir::ZoneTable& zone = module_[r.zone];
    const ir::Cells& c = zone.cells;
    const std::int64_t need =
        r.kind == ir::RecoveryKind::yield ? r.route_clearance_mm : r.return_clearance_mm;
    if (c.cell_mm <= cell_mm_least || zone.widest_mm < need) return;
    const std::int64_t best = *std::max_element(c.clearance_mm_lo.begin(), c.clearance_mm_lo.end());
    if (best >= need) return;
    diag::Diagnostic d{};
    d.code = Code::cells_too_coarse;
    d.range = source_of(r.zone);
    d.message =
        "`" + r.name + "` would find no way in `" + zone.name + "`: its cells are too coarse";
    d.label = "so large that its cells are " + metres(c.cell_mm) + " wide";
    d.notes.push_back({std::nullopt, "`" + r.name + "` keeps a clearance of " + metres(need) +
                                         ", which a place has but no whole cell"});
    d.help = narrower(zone.widest_mm - need);
    diagnostics_.report(std::move(d));
  }
  // `ahead n waypoints`: a leg that keeps its distance has to fit somewhere (passes, legs).
  void legs(const Decided& of, const ir::Monitor& monitor) {
    const ir::Decision& decision = of.decision;
    if (monitor.lookahead.waypoints == 0) return;
    for (const ir::ZoneIndex fence : fences_of(monitor.property, decision.facts.params)) {
      std::int64_t own_mm = 0;
      for (const Standoff& each : fence_standoffs(monitor.property, decision.facts.params)) {
        if (each.zone == fence) own_mm = std::max(own_mm, each.mm);
      }
      const std::int64_t tracking_mm =
          monitor.lookahead.points_only ? 0 : decision.body.tracking_mm;
      const std::int64_t rest_mm = decision.body.radius_mm + own_mm + 1;
      const std::int64_t spare_mm = module_[fence].widest_mm - rest_mm;
      if (tracking_mm <= spare_mm) continue;
      const std::string zone = "`" + module_[fence].name + "`";
      diag::Diagnostic d{};
      d.code = Code::return_set_empty;
      d.range = monitor.lookahead_source;
      d.message = "with a plan, monitor `" + monitor.name + "` can never hand control back";
      d.label = "each way-point and leg keeps " + metres(rest_mm + tracking_mm) +
                " from the boundary of " + zone;
      d.notes.push_back({std::nullopt, "the widest place of " + zone + " has a clearance of " +
                                           metres(module_[fence].widest_mm)});
      const auto works =
          spare_mm >= 0 ? tracking_that_works(of.written.kind, spare_mm, fault_of(d.code, d.range))
                        : std::nullopt;
      d.help = works ? "`tracking <= " + metres(*works) + "` works"
                     : "no `tracking` alone works: widen the zone by " +
                           metres(std::max<std::int64_t>(-2 * spare_mm, 0));
      diagnostics_.report(std::move(d));
      return;
    }
  }
  std::optional<std::int64_t> tracking_that_works(sema::KindId id, std::int64_t guess_mm,
                                                  const Fault& fault) const {
    if (trials_ == nullptr) return std::nullopt;  // nobody reads it
    sema::RobotKind& kind = trials_->spec().kinds[static_cast<std::size_t>(id)];
    return kind.plan ? quantity_that_works(*trials_, {fault, 1000, 0, guess_mm, 0},
                                           "tracking of " + kind.name, kind.plan->tracking)
                     : std::nullopt;
  }
  // A cell of width s around the widest place has at least the clearance there less its diagonal.
  static std::string narrower(std::int64_t spare_mm) {
    const std::int64_t cell_mm = spare_mm * 7071 / 100'000 * 10;
    if (cell_mm < cell_mm_least) {  // cells are never so narrow
      const std::int64_t wider_mm = cell_mm_least * 14'143 / 10'000 + 1 - spare_mm;
      return "split the zone into parts within 20 m x 20 m, and widen its passages by " +
             metres(2 * wider_mm) + ": cells of " + metres(cell_mm_least) + " work then";
    }
    const std::int64_t side_mm = 200 * cell_mm;  // of the square with `cells_most` cells
    return "split the zone, or widen its passages: cells of at most " + metres(cell_mm) +
           " work, as a zone within " + metres(side_mm) + " x " + metres(side_mm) + " has them";
  }

  // Beyond the distances that a tree of cells holds exactly, its bounds from below may fail places
  // that are far enough from the boundary. In a zone that is not much wider than that, few are.
  void exact_far_enough(const Decided& of, const ir::Monitor& monitor) {
    if (!monitor.lookahead.duration) return;
    const ir::Decision& decision = of.decision;
    const std::int64_t reach_mm = reach_at_full_speed_mm(decision, monitor.lookahead.duration_us);
    for (const ir::Value& v : monitor.property.values) {
      const auto* compare = std::get_if<ir::AtLeast>(&v.op);
      const auto bound = compare
                             ? ir::lower_bound(monitor.property, *compare, decision.facts.params)
                             : std::nullopt;
      if (!bound || bound->leaf.kind != ir::Leaf::Kind::clearance) continue;
      const ir::ZoneIndex zone{bound->leaf.table};
      const std::int64_t need = reach_mm + bound->need.strictest;
      const std::int64_t enough = std::min<std::int64_t>(need, module_[zone].widest_mm / 4 * 3);
      for (const ir::ZoneTable* table : bases_of(zone)) {
        const auto exact = table->tree.exact_inside_mm;
        if (!exact || *exact >= enough) continue;
        too_short(of, monitor, zone, *table, *exact, need);
        return;
      }
    }
  }
  static std::int64_t reach_at_full_speed_mm(const ir::Decision& d, std::int64_t lookahead_us) {
    return disc_mm(d.body, d.motions[0], d.motions[0].speed_mmps,
                   horizon_us_max(d.body, lookahead_us) + d.return_extra_us);
  }
  // The tables of its edges.
  std::vector<const ir::ZoneTable*> bases_of(ir::ZoneIndex zone) const {
    if (!module_[zone].has_height()) return {&module_[zone]};
    std::vector<const ir::ZoneTable*> all;
    for (const auto& slab : module_[zone].slabs) all.push_back(&module_[slab.base]);
    return all;
  }
  void too_short(const Decided& of, const ir::Monitor& monitor, ir::ZoneIndex index,
                 const ir::ZoneTable& zone, std::int64_t exact_mm, std::int64_t need_mm) {
    const std::int64_t ahead_us = monitor.lookahead.duration_us;
    const std::int64_t asked_mm = need_mm - reach_at_full_speed_mm(of.decision, ahead_us);
    const auto numbers =
        repairs(of.written, of.trials, fault_of(Code::too_many_edges, source_of(index)),
                [&](const Trial& t) {
                  return reach_at_full_speed_mm(t.decision, std::min(ahead_us, covering_us(t))) +
                             asked_mm <=
                         exact_mm;
                });
    diag::Diagnostic d{};
    d.code = Code::too_many_edges;
    d.range = source_of(index);
    d.message = "distances to the boundary of `" + zone.name + "` are exact up to " +
                metres(exact_mm) + " alone: it has " + std::to_string(zone.edges.size()) +
                " edges, in tables of 64 bytes an edge and 64 KiB";
    d.notes.push_back({std::nullopt, "monitor `" + monitor.name + "` needs a clearance of " +
                                         metres(need_mm) + " at full speed"});
    d.help = numbers.empty() ? "fewer vertices are needed, a shorter `ahead` or a lower `speed`"
                             : joined(numbers) + " works; else fewer vertices are needed";
    diagnostics_.report(std::move(d));
  }

  void site(const Decided& of, const ir::Monitor& monitor) {
    const sema::KindId kind = of.written.kind;
    const ir::Recovery& way = ir::last_step(monitor.recovery);
    if (way.kind != ir::RecoveryKind::route) return;
    const ir::SiteTable& site = module_[way.site];
    const ir::ZoneTable& zone = module_[site.zone];
    beside_dock(of, monitor, way);
    too_near(of, way);
    for (std::size_t p = 0; p < site.places.size(); ++p) {
      const ir::SiteTable::Place& place = site.places[p];
      const SourceRange range = source_of(way.site, p);
      const auto cell = cell_at(zone.cells, place.x_mm, place.y_mm);
      const std::int32_t clearance = cell ? zone.cells.clearance_mm_lo[*cell] : -1;
      const std::string what = "`" + site.name + "(" + place.robot + ")`";
      const std::int64_t route = way.route_clearance_mm;
      const std::int64_t give_back = way.return_clearance_mm;
      const auto misplaced = [&](Code code, std::string message) {
        report(monitor, code, range, std::move(message),
               other_place(of, way, place, clearance, fault_of(code, range)));
      };
      if (clearance < 0) {
        misplaced(Code::site_outside_zone, what + " lies outside `" + zone.name + "`");
      } else if (auto barred = barred_by(of, monitor, place)) {
        // whatever else is wrong there
        const auto works = place_for(of, way, place, fault_of(barred->code, range));
        if (works) barred->help = *works;
        barred->monitor = monitor.name;
        diagnostics_.report(std::move(*barred));
      } else if (clearance < route) {
        misplaced(Code::site_unreachable, what + " has a clearance of about " +
                                              clearance_text(zone.cells, clearance) + ", `" +
                                              monitor.recovery.name + "` keeps " + metres(route));
      } else if (clearance < give_back) {
        misplaced(Code::site_not_returnable, "control cannot be handed back at " + what +
                                                 ": its clearance is about " +
                                                 clearance_text(zone.cells, clearance) + ", " +
                                                 metres(give_back) + " is needed");
      } else if (!place.cost_ppm.empty()) {
        affordable(kind, of.decision, monitor, place, range, what);
      }
    }
  }

  [[nodiscard]] std::optional<diag::Diagnostic> barred_by(const Decided& of,
                                                          const ir::Monitor& monitor,
                                                          const ir::SiteTable::Place& at) const {
    const auto k = static_cast<std::size_t>(&monitor - of.decision.monitors.data());
    const auto& recover = spec_[of.written.priority[k]].recover;
    const auto route = recover ? sema::route_of(spec_[*recover]) : std::nullopt;
    if (!route) return std::nullopt;
    const sema::Site& site = spec_[route->site];
    const auto* const place = written_place(spec_, site, at.robot);
    if (place == nullptr) return std::nullopt;
    const RegionOf region_of = [&](sema::ZoneId id) -> std::optional<geometry::Region> {
      const auto table = tables_.zones[static_cast<std::size_t>(id)];
      if (!table || module_[*table].has_height()) return std::nullopt;
      return exact_.flat(*table);
    };
    const auto barred = barred_on_the_way(spec_, region_of, of.written, k, *place);
    if (!barred) return std::nullopt;
    return barred_site(spec_, *barred, monitor.recovery.name, site, *place);
  }

  // While one robot is there, the other one waits, or comes nearer than it may. Robots that share a
  // place take turns there.
  void too_near(const Decided& of, const ir::Recovery& way) {
    const ir::SiteTable& site = module_[way.site];
    const std::int64_t asked_mm = sure_separation_mm(of.decision);
    const std::int64_t need_mm = at_once_mm(of.decision);
    for (std::size_t p = 0; p < site.places.size(); ++p) {
      for (std::size_t q = 0; q < p; ++q) {
        const ir::SiteTable::Place &one = site.places[q], &other = site.places[p];
        const std::int64_t square = square_mm2(one, other);
        if (square == 0 || square >= need_mm * need_mm) continue;
        const auto name = [&](const auto& at) { return "`" + site.name + "(" + at.robot + ")`"; };
        diag::Diagnostic d{};
        d.code = Code::sites_too_near;
        d.range = source_of(way.site, p);
        d.message = name(one) + " and " + name(other) + " are too near for two robots to be there";
        d.label = "about " + metres(std::llround(std::sqrt(static_cast<double>(square)))) +
                  " from " + name(one);
        const std::string kept =
            asked_mm > 0 ? ", and monitors keep " + metres(asked_mm) + " between two of them" : "";
        d.notes.push_back(
            {std::nullopt, "bodies have a radius of " + metres(of.decision.body.radius_mm) + kept});
        d.help = "places at least " + metres(need_mm) + " apart are needed";
        if (!is_told_of_place(d)) diagnostics_.report(std::move(d));
        break;  // of one place, of one other
      }
    }
  }
  // Of a site that several recoveries lead to.
  bool is_told_of_place(const diag::Diagnostic& found) const {
    return std::ranges::any_of(diagnostics_.all(), [&](const diag::Diagnostic& d) {
      return d.code == found.code && d.range == found.range && d.message == found.message;
    });
  }

  // Who goes to be charged has to rest near enough for that.
  void beside_dock(const Decided& of, const ir::Monitor& monitor, const ir::Recovery& way) {
    const std::int64_t off_mm = rests_off_mm(of.decision.body);
    if (!way.charges || off_mm <= dock_reach_mm) return;
    const bool asks = std::ranges::any_of(of.written.priority, [&](sema::MonitorId id) {
      return spec_[id].name == monitor.name && sema::asks_for_charge(spec_[id]);
    });
    if (!asks) return;
    const SourceRange range = source_of(way.site, 0);
    const auto others = repairs_or_both_errors(
        of.written, of.trials, fault_of(Code::site_not_returnable, range),
        [](const Trial& t) { return rests_off_mm(t.decision.body) <= dock_reach_mm; });
    report(monitor, Code::site_not_returnable, range,
           "control cannot be handed back at `" + module_[way.site].name + "`: `" + way.name +
               "` may come to rest " + metres(off_mm) + " from it, and is charged within " +
               metres(dock_reach_mm),
           others.empty()
               ? "what pushes it has to be weaker, or its position and its velocity have to be "
                 "measured better, and sooner"
               : joined(others) + " works");
  }

  // A recovery knows the clearance of whole cells: where these are wide, a place has more than its
  // cell, and it is the cell that has to be spoken of.
  static std::string clearance_text(const ir::Cells& cells, std::int32_t clearance_mm) {
    const std::string text = metres(clearance_mm);
    if (cells.cell_mm <= cell_mm_least) return text;
    return text + " in its cell of " + metres(cells.cell_mm) + " (so wide in a zone so large)";
  }

  // A grid over a zone without an end knows of no place what it has around it.
  std::string end_for(const Decided& of, const ir::Recovery& way, const ir::SiteTable::Place& site,
                      const Fault& fault) const {
    const auto& monitors = of.decision.monitors;
    const auto name_of = [](const ir::Monitor& m) { return m.recovery.name; };
    const auto k = std::ranges::find(monitors, way.name, name_of) - monitors.begin();
    const sema::Monitor& written = spec_[of.written.priority[static_cast<std::size_t>(k)]];
    return name_as_written(module_[way.zone]) + " has no end: a route within a zone with one " +
           with_an_end(*of.trials, fault, written.range, module_, way, {site});
  }

  // The centre of a cell near there that would do.
  std::string other_place(const Decided& of, const ir::Recovery& way,
                          const ir::SiteTable::Place& from, std::int64_t clear_mm,
                          const Fault& fault) const {
    const ir::ZoneTable& zone = module_[way.zone];
    const std::int64_t clearance_mm = needed_mm(way);
    const std::string none =
        "no place of `" + zone.name + "` has a clearance of " + metres(clearance_mm);
    if (of.trials == nullptr) return none;  // nobody reads it
    if (is_boundless(zone)) return end_for(of, way, from, fault);
    if (const auto works = place_for(of, way, from, fault)) return *works;
    return (clear_places(way).empty() ? none
                                      : "no place of `" + zone.name + "` was found that works") +
           ": " + no_place(of, way, from, clearance_mm, clear_mm, fault);
  }
  static std::int64_t needed_mm(const ir::Recovery& way) {
    return std::max(way.route_clearance_mm, way.return_clearance_mm);
  }
  [[nodiscard]] std::vector<OtherPlace> clear_places(const ir::Recovery& way) const {
    const ir::Cells& cells = module_[way.zone].cells;
    std::vector<OtherPlace> all;
    for (std::int64_t i = 0; i < std::int64_t{cells.columns} * cells.rows; ++i) {
      const std::int64_t clear = cells.clearance_mm_lo[static_cast<std::size_t>(i)];
      if (clear < needed_mm(way)) continue;
      const std::int64_t half = cells.cell_mm / 2;
      all.push_back({{cells.origin_x_mm + i % cells.columns * cells.cell_mm + half,
                      cells.origin_y_mm + i / cells.columns * cells.cell_mm + half},
                     clear});
    }
    return all;
  }
  // "the place (3 m, 4 m) works"
  [[nodiscard]] std::optional<std::string> place_for(const Decided& of, const ir::Recovery& way,
                                                     const ir::SiteTable::Place& from,
                                                     const Fault& fault) const {
    const auto* const written = written_place(spec_, module_[way.site], from);
    if (of.trials == nullptr || written == nullptr || is_boundless(module_[way.zone])) {
      return std::nullopt;
    }
    const auto works = places_that_work(*of.trials, fault, {{written->range, clear_places(way)}});
    if (works.empty()) return std::nullopt;
    return "the place " + place(works[0].to.x_mm, works[0].to.y_mm) + " works";
  }

  // A wider zone, or other numbers with which the cell of the site, which is so clear, would do.
  std::string no_place(const Decided& of, const ir::Recovery& way, const ir::SiteTable::Place& from,
                       std::int64_t clearance_mm, std::int64_t clear_mm, const Fault& fault) const {
    const auto others = repairs(of.written, of.trials, fault, [&](const Trial& t) {
      const Rational speed(static_cast<long>(way.speed_mmps), 1000);
      const ir::Motion motion =
          recovery_motion(t.kind, t.decision.body, way.name, speed, t.decision.period_us);
      const std::int64_t need_mm = std::max(cruise_clearance_mm(t.decision, motion, t.lookahead_us),
                                            return_clearance_mm(t.decision, t.lookahead_us));
      return need_mm + standoff_mm(of.decision, way) <= clear_mm;
    });
    const auto fits = [&](const std::vector<geometry::EdgeRow>&, const ir::Cells& cells) {
      const auto cell = cell_at(cells, from.x_mm, from.y_mm);
      return cell && cells.clearance_mm_lo[*cell] >= clearance_mm;
    };
    const auto guess_mm =
        widening_mm(exact_.flat(way.zone), clearance_mm - clear_mm, 2 * clearance_mm, fits);
    const auto grown = guess_mm ? growth_that_works(*of.trials, way.zone, exact_.flat(way.zone),
                                                    *guess_mm, 2 * clearance_mm, fault)
                                : distance_that_works(*of.trials, way.zone, clearance_mm, fault);
    if (!grown && others.empty()) return "another site and a wider zone are needed";
    return grown.value_or("") + (grown && !others.empty() ? "; or " : "") +
           (others.empty() ? "" : joined(others) + " works");
  }

  // A full battery must bring the robot home from the farthest connected place.
  void affordable(sema::KindId written, const ir::Decision& decision, const ir::Monitor& monitor,
                  const ir::SiteTable::Place& place, const SourceRange& range,
                  const std::string& what) {
    std::int64_t most = 0;
    for (const std::int32_t cost : place.cost_ppm) {
      if (cost != ir::no_way) most = std::max<std::int64_t>(most, cost);
    }
    const std::int64_t full = 1'000'000 - decision.body.battery_error_ppm;
    if (most + decision.hold_reserve_ppm < full) return;
    const std::string other = "a faster `" + monitor.recovery.name + "` or a nearer site";
    const auto less = trials_ != nullptr ? consumption_that_works(
                                               *trials_, fault_of(Code::site_unreachable, range),
                                               written, Rational(most) / full)
                                         : std::nullopt;
    report(monitor, Code::site_unreachable, range,
           "the way to " + what + " takes up to " +
               to_decimal(Rational(most + decision.hold_reserve_ppm, 10'000)) +
               " % of a full battery, `held` and `detour` included",
           less ? *less + " works; or " + other : other + " is needed");
  }

  void report(const ir::Monitor& monitor, Code code, const SourceRange& range, std::string message,
              std::string help) {
    diagnostics_.report(
        {code, range, std::move(message), "", {}, std::move(help), {}, monitor.name, {}});
  }

  SourceRange source_of(ir::ZoneIndex index) const {
    for (std::size_t i = 0; i < tables_.zones.size(); ++i) {
      const sema::Zone& zone = spec_.zones[i];
      if (tables_.zones[i] == index) return zone.name.empty() ? zone.value->range : zone.name_range;
    }
    return {};
  }
  SourceRange source_of(ir::SiteIndex index, std::size_t place) const {
    const auto* const written = written_place(spec_, module_[index], module_[index].places[place]);
    return written != nullptr ? written->range : SourceRange{};
  }

  const sema::Spec& spec_;
  const ir::Module& module_;
  const ir::TableMap& tables_;
  const ExactZones& exact_;
  const HowItLies& lies_;
  Trials* trials_;
  diag::Engine& diagnostics_;
};

}  // namespace

void check_well_formed(const sema::Spec& spec, const ir::Module& module, const ir::TableMap& tables,
                       const ExactZones& exact, const HowItLies& lies, Trials* trials,
                       diag::Engine& diagnostics) {
  WellFormed(spec, module, tables, exact, lies, trials, diagnostics).run();
}

std::vector<MonitorSummary> summarise(const ir::Module& module, const ir::Decision& decision) {
  std::vector<MonitorSummary> all;
  for (const ir::Monitor& m : decision.monitors) {
    MonitorSummary s;
    s.monitor = m.name;
    if (m.lookahead.duration && !decision.on_plan) {
      s.lookahead_us = m.lookahead.duration_us;
      s.horizon_us = horizon_us_max(decision.body, s.lookahead_us);
      s.stopping_mm =
          disc_mm(decision.body, decision.motions[0], decision.motions[0].speed_mmps, s.horizon_us);
      s.return_clearance_mm = m.recovery.return_clearance_mm;
      s.leave_us = m.recovery.leave_us;
      for (const ir::ZoneIndex fence : fences_of(m.property, decision.facts.params)) {
        const auto share =
            share_of(module[fence], decision.body.radius_mm, s.stopping_mm, s.return_clearance_mm);
        if (!share || !s.zone.empty()) continue;
        s.zone = module[fence].name;
        s.share = *share;
      }
      const ir::Recovery& last = ir::last_step(m.recovery);
      if (ir::goes_back(last.kind)) {
        s.lookahead_max_us = lookahead_max_us(decision, room_mm(decision, last, module[last.zone]),
                                              standoff_mm(decision, last));
      }
    }
    all.push_back(std::move(s));
  }
  return all;
}

}  // namespace rtac::analysis
