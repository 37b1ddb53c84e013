#include "compiler/analysis/derive.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "compiler/analysis/arbitration.h"
#include "compiler/analysis/effort.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/magnitudes.h"
#include "compiler/analysis/reach.h"
#include "compiler/analysis/recoveries.h"
#include "compiler/analysis/repairs.h"
#include "compiler/analysis/return_condition.h"
#include "compiler/analysis/return_met.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/superfluous.h"
#include "compiler/analysis/timing.h"
#include "compiler/analysis/travel.h"
#include "compiler/analysis/well_formed.h"
#include "compiler/analysis/windows.h"
#include "compiler/analysis/zone_tables.h"
#include "compiler/analysis/zones.h"
#include "compiler/geometry/looks.h"
#include "compiler/ir/acknowledged.h"
#include "compiler/ir/builder.h"
#include "compiler/ir/signals.h"
#include "compiler/ir/source_text.h"
#include "compiler/ir/watch_builder.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"
#include "compiler/support/overloaded.h"

namespace rtac::analysis {
namespace {

using diag::Code;

// A recovery hands back after its return condition held for this long (hysteresis), and a tick.
constexpr std::int64_t dwell_us = 50'000;
// How long a HELD robot promises to stay; renewed every tick.
constexpr std::int64_t lease_us = 1'000'000;
// A connector leads from a place that a moving recovery avoids back to its cells, in mm between
// centres; cells that are wide need a longer one to reach their neighbours. The search of the
// recoveries joins its cells at least as far off.
std::int32_t connector_mm(std::int32_t cell_mm) {
  return std::max(400, 2 * cell_mm);
}

std::uint32_t index(auto id) {
  return static_cast<std::uint32_t>(id);
}

class Deriver {
 public:
  // `spec` is changed while offers are tried, and then as it was.
  Deriver(sema::Spec& spec, const SourceManager& sources, diag::Engine& diagnostics, Judge judge,
          bool offers = true, std::shared_ptr<const EvaluatedZones> zones = nullptr)
      : spec_(spec),
        sources_(sources),
        diagnostics_(diagnostics),
        judge_(std::move(judge)),
        offers_(offers),
        evaluated_(std::move(zones)) {}

  static Faults faults(sema::Spec& spec, const SourceManager& sources, const Judge& judge,
                       const Trials::Ask& ask,
                       std::shared_ptr<const EvaluatedZones> zones = nullptr) {
    diag::Engine aside;
    const bool same_zones = zones != nullptr;
    Deriver anew(spec, sources, aside, {}, false, std::move(zones));
    anew.remarks_ = ask.remarks;
    const std::int64_t before = geometry::looks();
    auto derived = anew.run(Finding::is_told);
    Faults found = faults_of(aside);
    found.remarks = ask.remarks;
    const std::int64_t plain = effort_of(derived ? derived->module : anew.out_.module, same_zones);
    found.effort = plain + effort_of_looks(geometry::looks() - before);
    if (!judge) return found;
    found.derived = derived.has_value();
    found.complete = derived && ask.worth(found);
    if (!found.complete) return found;
    found.effort = 0;
    found.effort_of_shown = 2 * plain + effort_of_pairs(derived->module);
    found.all.merge(judge(spec, std::move(*derived), aside, false));
    found.effort_of_shown += effort_of_looks(geometry::looks() - before);
    return found;
  }

  std::optional<Derived> run(Finding finding) {
    out_.module.name = spec_.name;
    // who only checks, builds or plays a run again is not kept waiting
    if (finding != Finding::is_told) trials_.go_by_reports_alone();
    check_magnitudes(spec_, trials(), diagnostics_);
    const std::vector<ZoneUse> wanted = wanted_zones(spec_);
    if (!evaluated_) {
      evaluated_ =
          std::make_shared<const EvaluatedZones>(evaluate_zones(spec_, wanted, diagnostics_));
    }
    if (diagnostics_.has_errors()) return std::nullopt;
    PointTables points =
        number_zones(spec_, sources_, wanted, *evaluated_, out_.module, out_.tables);
    trials_.tables_are(out_.tables);
    number_sites();
    for (const sema::Decision& decision : spec_.decisions) {
      out_.module.decisions.push_back(this->decision(decision));
    }
    const ir::Signals signals = ir::build_signals(spec_, diagnostics_);
    ir::build_blocks(spec_, out_.tables, signals, sources_, out_.module, diagnostics_);
    out_.module.watch = ir::build_watch(spec_, signals, sources_, std::move(points.regions),
                                        std::move(points.solids), out_.tables, diagnostics_);
    for (ir::Decision& d : out_.module.decisions) fill_clearances(d);
    count_commands();
    fill_costs();
    fill_windows();
    if (!could_be_built()) finding = Finding::refuses;
    const ExactZone exact = [this](ir::ZoneIndex zone) -> const geometry::Region& {
      return zone_of(zone).exact;
    };
    const ExactSolid solid = [this](ir::ZoneIndex zone) {
      const EvaluatedZone& of = zone_of(zone);
      return of.solid ? of.solid->exact : without_end(of.exact);
    };
    check_well_formed(spec_, out_.module, out_.tables, {exact, solid}, lies_, trials(),
                      diagnostics_);
    judge_return_conditions(out_.module, exact, solid);
    check_recoveries(spec_, out_.module, exact, solid, lies_, trials(), remarks_, diagnostics_);
    if (finding == Finding::refuses && diagnostics_.has_errors()) return std::nullopt;
    // Whatever it says, the module can be built, and passes look at the rest.
    fill_keeps(spec_, out_.module, exact, solid, lies_);
    const Try attempt = [this](std::size_t n, const Change& change) { return tried(n, change); };
    check_arbitration(spec_, out_.module, exact, solid, attempt, trials(), diagnostics_);
    check_acknowledgements(spec_, out_.module, exact, solid, lies_, diagnostics_);
    return std::move(out_);
  }

 private:
  // The whole specification once more, with all that may come of it.
  Tried tried(std::size_t n, const Change& change) {
    Tried found;
    if (!offers_) return found;
    sema::Decision& decision = spec_.decisions[n];
    sema::RobotKind& kind = spec_.kinds[index(decision.kind)];
    const auto order = decision.priority;
    const auto energy = kind.energy;
    auto controllers = spec_.controllers;
    controllers.swap(spec_.controllers);  // who looks at one of them goes on doing so
    std::vector<std::optional<sema::ControllerId>> recoveries;
    for (const sema::MonitorId id : order) recoveries.push_back(spec_[id].recover);
    std::vector<sema::ExprPtr> returns;
    for (const std::size_t k : change.without_return) {
      returns.push_back(std::exchange(spec_.monitors[index(order[k])].return_when, nullptr));
    }
    write(change, decision, kind);
    diag::Engine aside;
    auto derived = Deriver(spec_, sources_, aside, {}, false).run(Finding::is_told);
    found.waits = !derived || waits(derived->module.decisions[n]);
    if (derived && judge_) found.left.all = judge_(spec_, std::move(*derived), aside, true);
    decision.priority = order;
    kind.energy = energy;
    spec_.controllers = std::move(controllers);
    for (std::size_t k = 0; k < order.size(); ++k) {
      spec_.monitors[index(order[k])].recover = recoveries[k];
    }
    for (std::size_t k = 0; k < returns.size(); ++k) {
      spec_.monitors[index(order[change.without_return[k]])].return_when = std::move(returns[k]);
    }
    for (const diag::Diagnostic& d : aside.all()) {
      if (diag::info(d.code).severity == diag::Severity::error) found.errors.push_back(d);
    }
    return found;
  }
  void write(const Change& change, sema::Decision& decision, sema::RobotKind& kind) {
    const auto order = decision.priority;
    const auto monitor = [&](std::size_t k) -> sema::Monitor& {
      return spec_.monitors[index(order[k])];
    };
    for (std::size_t k = 0; k < change.order.size(); ++k) {
      decision.priority[k] = order[change.order[k]];
    }
    if (change.follows) {
      monitor(change.follows->first).recover = monitor(change.follows->second).recover;
    }
    if (change.lands) {
      sema::land_at(spec_.controllers[index(*monitor(change.lands->first).recover)],
                    Rational(static_cast<long>(change.lands->second), 1000));
    }
    // another one for that monitor alone: others may recover by the same
    if (change.stands) {
      sema::Controller standing = spec_[*monitor(*change.stands).recover];
      standing.name += " that stands";
      standing.implementation = sema::BrakeAndHold{};
      monitor(*change.stands).recover = sema::ControllerId(spec_.controllers.size());
      spec_.controllers.push_back(std::move(standing));
    }
    if (change.held) kind.energy->held.value = *change.held;
    if (change.detour) kind.energy->detour.value = *change.detour;
  }
  // For numbers to be tried in, too; none in what is tried itself.
  Trials* trials() { return offers_ ? &trials_ : nullptr; }
  // A monitor asks for what may never come about, nobody has accepted that, and others rank lower.
  static bool waits(const ir::Decision& decision) {
    return std::any_of(
        decision.monitors.begin(), decision.monitors.end(), [&](const ir::Monitor& m) {
          return m.return_when && m.returns.how == ir::Returns::How::open &&
                 m.hold_reason.empty() && !ir::acknowledged(decision, m.recovery.name, m.name);
        });
  }
  // A look-ahead that is too short, and who does not lead out of a zone before it comes or goes, is
  // built as if its author had accepted that.
  bool could_be_built() const {
    const auto& all = diagnostics_.all();
    return ways_out_are_known_ &&
           std::all_of(all.begin(), all.end(), [](const diag::Diagnostic& d) {
             return d.code == Code::lookahead_too_short || d.code == Code::window_without_way_out ||
                    d.code == Code::window_may_pass || d.code == Code::window_too_short ||
                    diag::info(d.code).severity != diag::Severity::error;
           });
  }
  // A site table lives on the zone of the route that leads to it; there is one for a kind of
  // robots.
  void number_sites() {
    out_.tables.sites.assign(spec_.kinds.size(),
                             std::vector<std::optional<ir::SiteIndex>>(spec_.sites.size()));
    for (const sema::Controller& c : spec_.controllers) {
      const auto route = sema::route_of(c);
      if (!route) continue;
      const ir::ZoneIndex zone = out_.tables.zone(route->zone);
      auto& slot = out_.tables.sites[index(c.kind)][index(route->site)];
      if (slot) {
        if (out_.module[*slot].zone != zone) report_routes_differ(c, *route);
        continue;
      }
      slot = ir::SiteIndex(out_.module.sites.size());
      out_.module.sites.push_back(site(c.kind, route->site, zone));
    }
  }
  void report_routes_differ(const sema::Controller& c, const sema::Route& route) {
    const std::string site = "`" + spec_[route.site].name + "`";
    const auto leads_there = [&](const sema::Controller& other) {
      const auto r = sema::route_of(other);
      return r && other.kind == c.kind && r->site == route.site;
    };
    const auto first = std::ranges::find_if(spec_.controllers, leads_there);
    diagnostics_.report(
        {Code::routes_differ,
         c.name_range,
         "`" + c.name + "` leads to " + site + " within another zone than `" + first->name + "`",
         "",
         {{first->name_range, "the ways to " + site + " and their charge are those of this zone"}},
         "the same zone for both works, or a site of its own at the same place",
         {}});
  }
  ir::SiteTable site(sema::KindId kind, sema::SiteId id, ir::ZoneIndex zone) const {
    ir::SiteTable t;
    t.name = spec_[id].name;
    for (const ir::SiteTable& other : out_.module.sites) {
      // two kinds of robots go there, each on its own table
      if (other.name == t.name) t.name += "_of_" + spec_[kind].name;
    }
    t.zone = zone;
    for (std::uint32_t r = 0; r < spec_.robots.size(); ++r) {
      if (spec_.robots[r].kind != kind) continue;
      for (const auto& place : spec_[id].places) {
        if (place.robot && *place.robot != sema::RobotId(r)) continue;
        t.places.push_back({spec_.robots[r].name,
                            static_cast<std::int32_t>(floor_to_int(place.position.x * 1000)),
                            static_cast<std::int32_t>(floor_to_int(place.position.y * 1000)),
                            {}});
        break;
      }
    }
    return t;
  }

  ir::Decision decision(const sema::Decision& from) {
    const sema::RobotKind& kind = spec_[from.kind];
    ir::Decision d;
    d.name = from.name;
    d.kind = kind.name;
    d.advanced = spec_[from.advanced].name;
    if (from.safe) d.safe = spec_[*from.safe].name;
    d.on_plan = from.on_plan;
    d.coordinated = from.coordinated && !from.on_plan;
    d.period_us = from.period ? ceil_to_int(from.period->value * 1'000'000) : 0;
    d.return_extra_us = return_extra_us(spec_, from, d.period_us);
    d.dwell_ticks = d.period_us == 0 ? 0 : (dwell_us + d.period_us - 1) / d.period_us;
    d.lease_us = lease_us;
    d.robots = fleet_size(from.kind);
    d.open_fleet = kind.open_fleet;
    d.plan_capacity = kind.plan ? kind.plan->capacity : 0;
    d.body = body_of(kind, d.period_us, from.on_plan ? 0 : jitter_us(spec_, from, d.period_us));
    keep_off_walls(spec_, from, kind, d);
    d.standing_mm = standing_mm(d.body, d.period_us);
    if (kind.energy) {
      const auto& e = *kind.energy;
      d.hold_reserve_ppm = ceil_to_int(
          Rational((e.idle.value * e.held.value + e.drive.value * e.detour.value) * 1'000'000));
    }
    d.pushed_mmps = ceil_to_int(Rational(pushed_speed(kind, d.period_us) * 1000));
    if (!from.on_plan) d.motions.push_back(any_control(kind));
    for (const sema::MonitorId id : from.priority) {
      need_drain(spec_[id], kind);
      d.monitors.push_back(monitor(spec_[id], d));
      if (!from.on_plan) d.motions.push_back(motion(spec_[id], from, d));
    }
    d.heard_reach_mm = heard_reach_mm(d);
    for (const auto& a : from.acknowledgements) {
      d.acknowledgements.push_back({spec_[a.recovery].name, spec_[a.monitor].name, a.reason});
    }
    return d;
  }
  // See ir::Decision: what leaving out the robots far off counts with.
  static std::int64_t heard_reach_mm(const ir::Decision& d) {
    if (d.robots < 2 || d.on_plan) return 0;
    std::int64_t horizon_us = 0;
    for (const ir::Monitor& m : d.monitors) horizon_us = std::max(horizon_us, ir::horizon_us(d, m));
    return disc_mm(d.body, d.motions[0], d.motions[0].speed_mmps,
                   d.body.hears_age_us + horizon_us + d.return_extra_us);
  }
  std::uint32_t fleet_size(sema::KindId kind) const {
    return static_cast<std::uint32_t>(
        std::count_if(spec_.robots.begin(), spec_.robots.end(),
                      [&](const sema::Robot& r) { return r.kind == kind; }));
  }

  ir::Monitor monitor(const sema::Monitor& from, const ir::Decision& d) {
    ir::Monitor m;
    m.name = from.name;
    m.requirement_id = from.requirement_id;
    m.requirement_text = from.requirement_text;
    const std::string& path = sources_.path(from.name_range.file);
    m.file = path.substr(path.find_last_of('/') + 1);
    m.line = sources_.position(from.name_range.file, from.name_range.begin).line;
    m.text = ir::one_line(sources_.text(from.always->range));
    if (from.return_when) m.return_text = ir::one_line(sources_.text(from.return_when->range));
    m.source = from.always_range;
    m.lookahead_source = from.ahead.range;
    m.lookahead.duration = !from.ahead.waypoints_only && !d.on_plan;
    const std::int64_t k = periods_of(spec_, from);
    m.lookahead.duration_us = lookahead_us(spec_, from, d.period_us);
    m.lookahead.too_short = m.lookahead.duration && m.lookahead.duration_us < k * d.period_us;
    // what is left for the time between two steps; never less than what every step takes
    m.lookahead.gap_us =
        std::max(m.lookahead.duration_us - (k - 1) * d.period_us, d.period_us) + d.body.jitter_us;
    if (m.lookahead.too_short && !from.ahead.duration_unsound) {
      const auto millis = [](std::int64_t us) { return to_decimal(Rational(us, 1000)) + " ms"; };
      const std::string least = millis(k * d.period_us);
      diagnostics_.report({Code::lookahead_too_short,
                           from.ahead.range,
                           "`ahead` of " + millis(m.lookahead.duration_us) + " is shorter than " +
                               (k == 1 ? "one period of " : "two periods of ") +
                               millis(d.period_us),
                           k == 1 ? "a template acts within one period"
                                  : "an external recovery acts within two periods",
                           {},
                           "`" + least + "` works, or `unsound \"why\"`",
                           {}});
    }
    m.lookahead.command = from.ahead.command;
    if (from.ahead.command && k > 1) report_command_late(from);
    m.lookahead.waypoints = from.ahead.waypoints;
    m.lookahead.points_only = from.ahead.points_only;
    if (from.recover) m.recovery = recovery(spec_[*from.recover], from.kind);
    m.hold_reason = from.hold_reason.value_or("");
    return m;
  }
  // theory, commanded input: only a recovery of the failing tick stops the last command in time
  void report_command_late(const sema::Monitor& from) {
    diagnostics_.report({Code::lookahead_too_short,
                         from.ahead.range,
                         "`ahead command` needs a recovery that acts within one period",
                         "an external recovery acts within two periods",
                         {},
                         "a template as recovery works, or `ahead` without `command`",
                         {}});
  }
  ir::Recovery recovery(const sema::Controller& from, sema::KindId kind) const {
    const std::vector<sema::Template> all = sema::templates_of(from);
    ir::Recovery r;
    if (const auto* sequence = std::get_if<sema::Sequence>(&from.implementation)) {
      r.kind = ir::RecoveryKind::sequence;
      for (const auto& each : sequence->steps) {
        r.steps.push_back(step(each.what, kind));
        r.steps.back().name = from.name;
        r.steps.back().lasts_us = each.lasts ? ceil_to_int(each.lasts->value * 1'000'000) : 0;
        r.speed_mmps = std::max(r.speed_mmps, r.steps.back().speed_mmps);
      }
    } else if (!all.empty()) {
      r = step(all.front(), kind);
    } else if (const auto claim = sema::claim_of(from)) {
      r.claims = true;
      r.zone = out_.tables.zone(claim->zone);
      r.speed_mmps = ceil_to_int(Rational(claim->speed.value * 1000));
    }
    r.name = from.name;
    return r;
  }
  ir::Recovery step(const sema::Template& what, sema::KindId kind) const {
    ir::Recovery r;
    r.kind =
        std::visit(Overloaded{[](const sema::Retreat&) { return ir::RecoveryKind::retreat; },
                              [](const sema::Route&) { return ir::RecoveryKind::route; },
                              [](const sema::Yield&) { return ir::RecoveryKind::yield; },
                              [](const sema::BrakeAndHold&) { return ir::RecoveryKind::brake; },
                              [](const sema::Loiter&) { return ir::RecoveryKind::loiter; },
                              [](const sema::Land&) { return ir::RecoveryKind::land; }},
                   what);
    if (const auto* land = std::get_if<sema::Land>(&what)) {
      r.land_mm = ceil_to_int(Rational(land->height.value * 1000));
      r.speed_mmps = ceil_to_int(Rational(land->speed.value * 1000));
    }
    if (const auto moves = sema::moves_of(what)) {
      r.zone = out_.tables.zone(moves->zone);
      r.speed_mmps = ceil_to_int(Rational(moves->speed * 1000));
    }
    if (const auto* route = std::get_if<sema::Route>(&what)) {
      r.site = out_.tables.site(kind, route->site);
      const auto& energy = spec_[kind].energy;
      r.charges = energy && energy->charge_at == route->site;
    }
    return r;
  }
  ir::Motion motion(const sema::Monitor& from, const sema::Decision& decision,
                    const ir::Decision& to) {
    const std::int64_t period_us = to.period_us;
    const sema::RobotKind& kind = spec_[decision.kind];
    const sema::Controller& c = spec_[*from.recover];
    const std::vector<sema::Template> all = sema::templates_of(c);
    if (all.empty()) {
      const auto claim = sema::claim_of(c);
      return recovery_motion(kind, to.body, c.name,
                             claim ? claim->speed.value : kind.motion.speed.value, period_us);
    }
    const Rational least = slowest_led(kind, period_us);
    Rational speed = 0;  // whoever stands never gets faster than it was found
    for (const sema::Template& what : all) {
      const auto own = sema::speed_of(what);
      if (!own) continue;
      speed = std::max(speed, *own);
      if (*own < least) report_no_way(decision, c, *own, least);
      if (heading_errors(kind, *own, period_us) > heading_errors_most) {
        report_off_heading(decision, c, *own);
      }
    }
    return recovery_motion(kind, to.body, c.name, speed, period_us);
  }
  void report_no_way(const sema::Decision& decision, const sema::Controller& c, const Rational& own,
                     const Rational& least) {
    const sema::RobotKind& kind = spec_[decision.kind];
    std::vector<diag::Note> notes;
    if (kind.velocity && !kind.in_space) {
      notes.push_back(
          {kind.velocity->error.range,
           "its velocity errs by up to " + to_decimal(kind.velocity->error.value) + " m/s"});
    }
    const std::int64_t period_us = ceil_to_int(Rational(decision.period->value * 1'000'000));
    const Rational pushed = pushed_speed(kind, period_us);
    if (pushed > 0) {
      notes.push_back(
          {kind.motion.disturbance ? kind.motion.disturbance->range : kind.output_error->range,
           "pushes it back at up to " + to_decimal(pushed) + " m/s"});
    }
    // a faster one, up to what the robot reaches, or another number with which it makes way as it
    // is
    std::vector<std::string> works;
    const Rational faster(ceil_to_int(Rational(least * 1000)), 1000);
    const auto makes_way = [](const sema::RobotKind& k, std::int64_t us, const Rational& speed) {
      return slowest_led(k, us) <= speed && (!k.in_space || speed <= follows_up_to(k, us));
    };
    if (faster <= kind.motion.speed.value && makes_way(kind, period_us, faster)) {
      works.push_back("a speed of at least " + to_decimal(faster) + " m/s");
    } else {
      works = repairs(decision, trials(), fault_of(Code::limit_contradictory, c.name_range),
                      [&](const Trial& t) { return makes_way(t.kind, t.decision.period_us, own); });
    }
    diagnostics_.report({Code::limit_contradictory,
                         c.name_range,
                         "`" + c.name + "` is too slow to make way for sure",
                         "it may be driven back instead",
                         std::move(notes),
                         works.empty()
                             ? "no speed up to that of the robot works, nor one other number alone"
                             : joined(works) + " works",
                         {}});
  }

  void report_off_heading(const sema::Decision& decision, const sema::Controller& c,
                          const Rational& own) {
    const sema::RobotKind& kind = spec_[decision.kind];
    const auto errs = [](const std::string& of, const sema::Sense& sense, const char* unit) {
      return diag::Note{sense.error.range, "its " + of + " errs by up to " +
                                               to_decimal(sense.error.value) + " " + unit};
    };
    const Rational off =
        heading_errors(kind, own, ceil_to_int(Rational(decision.period->value * 1'000'000)));
    const auto works = repairs(
        decision, trials(), fault_of(Code::limit_contradictory, c.name_range), [&](const Trial& t) {
          return heading_errors(t.kind, own, t.decision.period_us) <= heading_errors_most;
        });
    diagnostics_.report(
        {Code::limit_contradictory,
         c.name_range,
         "`" + c.name + "` cannot be steered well enough",
         "errors show which way it heads to within " +
             to_decimal(Rational(ceil_to_int(Rational(off * 1000)), 1000)) + " rad, and " +
             to_decimal(heading_errors_most) + " rad is needed",
         {errs("heading", *kind.heading, "rad"), errs("position", *kind.position, "m")},
         works.empty() ? "no other number alone works" : joined(works) + " works",
         {}});
  }

  // A sample of the battery is of use only with a bound on how fast it runs down.
  void need_drain(const sema::Monitor& monitor, const sema::RobotKind& kind) {
    if (kind.energy) return;
    const auto in = [&](const sema::Expr& e) {
      const auto* v = std::get_if<sema::SignalRef>(&e.node);
      if (!v || v->signal != sema::Signal::battery) return;
      diagnostics_.report({Code::limit_missing,
                           e.range,
                           "`battery` needs `energy` of `" + kind.name + "`",
                           "how fast it runs down is not declared",
                           {{kind.name_range, "the robot is declared here"}},
                           "write `energy { drive <= 0.4 %/m; idle <= 0.01 %/s; drain <= 0.2 %/s; "
                           "charge >= 1 %/s at " +
                               (spec_.sites.empty() ? "dock; }`, with a `site dock = (1 m, 1 m);`"
                                                    : spec_.sites.front().name + "; }`") +
                               " and the robot's own values",
                           {}});
    };
    sema::for_each_expr(*monitor.always, in);
    if (monitor.return_when) sema::for_each_expr(*monitor.return_when, in);
  }

  // Every recovery heads for places where every monitor of the decision can hand back, and where
  // its own monitor's return condition holds.
  void fill_clearances(ir::Decision& d) const {
    if (d.on_plan) return;
    const Standoffs wanted = standoffs_of(d);
    std::int64_t longest_us = 0;
    for (const ir::Monitor& m : d.monitors) {
      longest_us = std::max(longest_us, m.lookahead.duration_us);
    }
    d.cruise_clearance_mm = cruise_clearance_mm(d, d.motions[0], longest_us) + wanted.fence_mm;
    const std::int64_t back_mm = return_clearance_mm(d, longest_us);
    for (std::size_t k = 0; k < d.monitors.size(); ++k) {
      const std::int64_t cruise_mm = cruise_clearance_mm(d, d.motions[k + 1], longest_us);
      const auto fill = [&](ir::Recovery& r) {
        const bool knows = ir::moves(r.kind) || r.claims;
        const std::int64_t own_mm =
            knows ? standoff_in(d, d.monitors[k], r.zone, lies_) : wanted.fence_mm;
        r.return_clearance_mm =
            std::max(back_mm + own_mm, asked_clearance(out_.module, d, k, r.zone, lies_).mm);
        r.route_clearance_mm = cruise_mm + own_mm;
        r.pass_gap_mm = pass_gap_mm(d, longest_us, wanted.separation_mm);
      };
      ir::Recovery& recovery = d.monitors[k].recovery;
      fill(recovery);
      for (ir::Recovery& step : recovery.steps) fill(step);
      // of a sequence counts what it does in the end
      if (recovery.steps.empty()) continue;
      const ir::Recovery last = recovery.steps.back();
      recovery.return_clearance_mm = last.return_clearance_mm;
      recovery.route_clearance_mm = last.route_clearance_mm;
    }
    lead_where_all_return(d.monitors);
  }
  // One controller drives for all monitors that name it, and leads to where each of them returns.
  static void lead_where_all_return(std::vector<ir::Monitor>& monitors) {
    const auto raise = [](ir::Recovery& r, const ir::Recovery& other) {
      r.return_clearance_mm = std::max(r.return_clearance_mm, other.return_clearance_mm);
    };
    for (ir::Monitor& m : monitors) {
      for (const ir::Monitor& other : monitors) {
        if (other.recovery.name != m.recovery.name) continue;
        raise(m.recovery, other.recovery);
        for (std::size_t step = 0; step < m.recovery.steps.size(); ++step) {
          raise(m.recovery.steps[step], other.recovery.steps[step]);
        }
      }
    }
  }
  Lies how_it_lies(ir::ZoneIndex inner, const Standoff& outer) const {
    const EvaluatedZone &in = zone_of(inner), &out = zone_of(outer.zone);
    if (in.solid || out.solid) return Lies::in;
    if (!out.exact.contains(in.exact)) return Lies::elsewhere;
    const auto kept = within(out.exact, outer.mm);
    return kept && kept->contains(in.exact) ? Lies::deep : Lies::in;
  }
  // A step may come early, within a period, too; where there are more, any control is assumed.
  void count_commands() {
    std::int64_t most = 0;
    for (const ir::Decision& d : out_.module.decisions) {
      if (!ir::judges_commands(d) || d.on_plan) continue;
      most = std::max(most, (d.body.position_age_us + d.body.latency_us) / d.period_us + 3);
    }
    for (ir::Decision& d : out_.module.decisions) {
      if (ir::judges_commands(d)) d.commands = most;
    }
  }
  // Ways to sites are priced for the recovery that drives them; of several, for the dearest.
  void fill_costs() {
    for (std::size_t i = 0; i < spec_.decisions.size(); ++i) {
      const sema::RobotKind& kind = spec_[spec_.decisions[i].kind];
      const ir::Decision& d = out_.module.decisions[i];
      for (std::size_t k = 0; k < d.monitors.size() && kind.energy; ++k) {
        const ir::Recovery& r = ir::last_step(d.monitors[k].recovery);
        if (r.kind == ir::RecoveryKind::route) {
          price(out_.module.sites[index(r.site)], r, d, kind);
        }
      }
    }
    for (std::size_t i = 0; i < spec_.decisions.size(); ++i) {
      for (const sema::Controller& c : spec_.controllers) price_unused(c, i);
    }
  }
  [[nodiscard]] bool is_asked_for(sema::SiteId site, const sema::Decision& decision) const {
    bool found = false;
    const auto in = [&](const sema::Expr& e) {
      const auto* const way = std::get_if<sema::EnergyTo>(&e.node);
      found = found || (way != nullptr && way->site == site);
    };
    for (const sema::MonitorId id : decision.priority) {
      sema::for_each_expr(*spec_[id].always, in);
      if (spec_[id].return_when) sema::for_each_expr(*spec_[id].return_when, in);
    }
    return found;
  }
  // Of a way that no monitor has its robot driven along: what it would take, where a property asks
  // for it, whose recovery may be accepted to break that.
  void price_unused(const sema::Controller& c, std::size_t decision) {
    const sema::KindId kind = spec_.decisions[decision].kind;
    const ir::Decision& d = out_.module.decisions[decision];
    const auto route = sema::route_of(c);
    if (!route || c.kind != kind || !spec_[kind].energy || d.on_plan) return;
    if (!is_asked_for(route->site, spec_.decisions[decision])) return;
    ir::SiteTable& site = out_.module.sites[index(out_.tables.site(kind, route->site))];
    const auto is_priced = [](const ir::SiteTable::Place& p) { return !p.cost_ppm.empty(); };
    if (std::ranges::any_of(site.places, is_priced)) return;
    if (route->speed.value < slowest_led(spec_[kind], d.period_us)) {
      const std::size_t cells = zone_of(site.zone).baked.cells.clearance_mm_lo.size();
      for (ir::SiteTable::Place& p : site.places) p.cost_ppm.assign(cells, ir::no_way);
      return;
    }
    std::int64_t longest_us = 0;
    for (const ir::Monitor& m : d.monitors) {
      longest_us = std::max(longest_us, m.lookahead.duration_us);
    }
    ir::Recovery way = ir::last_step(recovery(c, kind));
    const ir::Motion along =
        recovery_motion(spec_[kind], d.body, c.name, route->speed.value, d.period_us);
    way.route_clearance_mm = cruise_clearance_mm(d, along, longest_us) + standoffs_of(d).fence_mm;
    price(site, way, d, spec_[kind]);
  }
  // How long recoveries take to lead out of zones that come and go.
  void fill_windows() {
    const WindowTables tables{
        [this](ir::ZoneIndex zone) -> const EvaluatedZone& { return zone_of(zone); }, connector_mm};
    for (std::size_t i = 0; i < spec_.decisions.size(); ++i) {
      const bool known = plan_windows(spec_, spec_.decisions[i], out_.module,
                                      out_.module.decisions[i], tables, trials(), diagnostics_);
      ways_out_are_known_ = ways_out_are_known_ && known;
    }
  }
  const EvaluatedZone& zone_of(ir::ZoneIndex index) const {
    const auto zone =
        std::find_if(out_.tables.zones.begin(), out_.tables.zones.end(),
                     [&](const std::optional<ir::ZoneIndex>& z) { return z && *z == index; });
    return *evaluated_->zones[std::size_t(zone - out_.tables.zones.begin())];
  }
  void price(ir::SiteTable& site, const ir::Recovery& route, const ir::Decision& d,
             const sema::RobotKind& kind) {
    const auto& baked = zone_of(site.zone).baked;
    // where the robot seems to be when it sets out; 2: off the grid on either axis
    const auto nearest_body_mm = static_cast<std::int32_t>(
        std::max<std::int64_t>(0, d.body.radius_mm - d.body.position_error_mm - 2));
    site.drive_ppm_per_m = static_cast<std::int32_t>(std::min<std::int64_t>(
        ir::no_way, floor_to_int(Rational(kind.energy->drive.value * 1'000'000))));
    const TravelCost cost(kind, metres_of(route.speed_mmps), d.period_us, baked.cells.cell_mm);
    for (std::size_t r = 0; r < site.places.size(); ++r) {
      ir::SiteTable::Place& place = site.places[r];
      if (const std::size_t same = site.table_of(r); same != r) {
        place.cost_ppm = site.places[same].cost_ppm;
        continue;
      }
      const auto distances = geometry::distances_to(
          baked, {place.x_mm, place.y_mm}, static_cast<std::int32_t>(route.route_clearance_mm),
          nearest_body_mm, connector_mm(baked.cells.cell_mm));
      place.cost_ppm.resize(distances.size(), ir::no_body);
      for (std::size_t c = 0; c < distances.size(); ++c) {
        if (baked.cells.clearance_mm_hi[c] < d.body.radius_mm) continue;  // nobody is there
        // above a thousand batteries there is no way either
        const std::int64_t ppm = distances[c] < 0 ? ir::no_way : cost.ppm(distances[c]);
        place.cost_ppm[c] = std::max(
            place.cost_ppm[c], static_cast<std::int32_t>(std::min<std::int64_t>(ir::no_way, ppm)));
      }
    }
  }

  sema::Spec& spec_;
  const SourceManager& sources_;
  diag::Engine& diagnostics_;
  const Judge judge_;
  const bool offers_;  // false: this one is tried itself
  bool remarks_ = true;
  // Shared with what is tried: to evaluate them takes the longest.
  std::shared_ptr<const EvaluatedZones> evaluated_;
  bool ways_out_are_known_ = true;  // of zones that come and go
  Trials trials_{spec_, [this](const Trials::Ask& ask) {
                   return faults(spec_, sources_, judge_, ask,
                                 ask.same_zones ? evaluated_ : nullptr);
                 }};
  Derived out_;
  const HowItLies lies_ = [this](ir::ZoneIndex inner, const Standoff& outer) {
    return how_it_lies(inner, outer);
  };
};

}  // namespace

std::optional<Derived> derive(sema::Spec& spec, const SourceManager& sources,
                              diag::Engine& diagnostics, Finding finding, const Judge& judge,
                              bool offers) {
  return Deriver(spec, sources, diagnostics, judge, offers).run(finding);
}

}  // namespace rtac::analysis
