#include "compiler/verify/obligations.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <utility>

#include "compiler/analysis/joint_return.h"
#include "compiler/analysis/recoveries.h"
#include "compiler/analysis/recoveries_in_space.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/analysis/windows.h"
#include "compiler/analysis/zones.h"
#include "compiler/support/words.h"
#include "compiler/verify/atoms.h"
#include "compiler/verify/proofs.h"
#include "compiler/verify/starts.h"
#include "compiler/verify/turns.h"

namespace rtac::verify {
namespace {

using diag::Code;

// The zones of the specification behind the tables of a module, exactly.
class ExactZones {
 public:
  ExactZones(const sema::Spec& spec, const ir::TableMap& tables)
      : shown_(analysis::exact_zones(spec)) {
    for (std::size_t i = 0; i < tables.zones.size(); ++i) {
      if (!tables.zones[i]) continue;
      const auto at = static_cast<std::size_t>(*tables.zones[i]);
      if (of_table_.size() <= at) of_table_.resize(at + 1);
      of_table_[at] = i;
    }
  }
  const geometry::Region& operator()(ir::ZoneIndex zone) const {
    const auto& slabs = shown_[of_table_[static_cast<std::size_t>(zone)]];
    return slabs.empty() ? none_ : slabs.front().region;
  }
  // Of a zone with height.
  const geometry::Solid& solid(ir::ZoneIndex zone) {
    const std::size_t at = of_table_[static_cast<std::size_t>(zone)];
    const auto known = solids_.find(at);
    if (known != solids_.end()) return known->second;
    std::vector<geometry::Slab> slabs;
    for (const analysis::ShownSlab& slab : shown_[at]) {
      if (slab.heights) slabs.push_back({slab.heights->first, slab.heights->second, slab.region});
    }
    return solids_.emplace(at, geometry::Solid::of_slabs(slabs)).first->second;
  }

 private:
  std::vector<std::vector<analysis::ShownSlab>> shown_;
  std::vector<std::size_t> of_table_;
  std::map<std::size_t, geometry::Solid> solids_;
  geometry::Region none_;
};

analysis::Arbitration matrix_of(const Subject& s) {
  return analysis::arbitration_of(s.kind, s.module, s.decision, s.exact, any_solid(s));
}

class Prover {
 public:
  Prover(const Subject& subject, const protocol::CheckModel& check) : s_(subject), check_(check) {}

  Decision run() {
    out_.name = s_.decision.name;
    out_.kind = s_.kind.name;
    if (s_.decision.on_plan) {
      for (Obligation& o : plan_obligations(s_)) out_.obligations.push_back(std::move(o));
      take([&] { return switches_well(s_, {}, check_); });
      return std::move(out_);
    }
    for (std::size_t k = 0; k < s_.decision.monitors.size(); ++k) of_monitor(k);
    take([&] { return same_output(s_); });
    arbitration();
    take([&] { return returns_together(s_); });
    take([&] { return starts_well(s_); });
    return std::move(out_);
  }

 private:
  template <class Prove>
  void take(const Prove& prove) {
    const auto start = std::chrono::steady_clock::now();
    Obligation o = prove();
    const auto took = std::chrono::steady_clock::now() - start;
    o.micros = std::chrono::duration_cast<std::chrono::microseconds>(took).count();
    out_.obligations.push_back(std::move(o));
  }
  void of_monitor(std::size_t k) {
    take([&] { return decided_in_time(s_, k); });
    take([&] { return recovery_keeps(s_, k); });
    take([&] { return control_returns(s_, k); });
    take([&] { return drives_until_next(s_, k); });
    take([&] { return can_hold(s_, k); });
    take([&] { return can_fail(s_, k); });
  }
  // A recovery of several monitors keeps another one for the same reasons, whomever it drives for:
  // that is one line, which rests on what is claimed of each.
  void say_once() {
    auto& all = out_.obligations;
    Obligation& last = all.back();
    const auto same = std::find_if(all.begin(), all.end() - 1, [&](const Obligation& o) {
      return o.kind == last.kind && o.monitor == last.monitor && o.recovery == last.recovery &&
             o.status == last.status && o.method == last.method && o.because == last.because &&
             o.repair == last.repair && o.by_a_run == last.by_a_run &&
             (o.status != Status::refuted || o.unmet == last.unmet);
    });
    if (same == all.end() - 1) return;
    for (Claim& claim : last.claims) {
      const bool known = std::any_of(same->claims.begin(), same->claims.end(), [&](const Claim& c) {
        return c.what == claim.what && c.values == claim.values;
      });
      if (!known) same->claims.push_back(std::move(claim));
    }
    if (same->starts.empty()) {
      same->starts = std::move(last.starts);
      same->unmet = std::move(last.unmet);
    }
    same->micros += last.micros;
    same->engaged.push_back(last.engaged.front());
    all.pop_back();
  }
  // Whom a recovery drives for is said where that makes a difference.
  void name_engaged() {
    auto& all = out_.obligations;
    std::map<std::pair<std::string, std::string>, int> lines;
    for (const Obligation& o : all) lines[{o.recovery, o.monitor}] += o.kind == Kind::keeps ? 1 : 0;
    for (Obligation& o : all) {
      if (lines[{o.recovery, o.monitor}] < 2) o.engaged.clear();
    }
  }
  void arbitration() {
    const analysis::Arbitration all = matrix_of(s_);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = 0; j < all.size(); ++j) {
        if (i == j) continue;
        take([&] { return keeps_others(s_, all[i][j], i, j); });
        out_.obligations.back().engaged = {s_.decision.monitors[i].name};
        say_once();
      }
    }
    name_engaged();
    take([&] { return switches_well(s_, all, check_); });
  }

  const Subject& s_;
  const protocol::CheckModel& check_;
  Decision out_;
};

// Which obligation an error of the analysis refutes; none: it is of another kind.
std::optional<Kind> refuted_by(const diag::Diagnostic& d) {
  if (analysis::is_apart_for_ever(d)) return Kind::joint_return;
  switch (d.code) {
    case Code::lookahead_too_short:
    case Code::latency_too_long:
      return Kind::p1a;
    case Code::outputs_differ:
      return Kind::p1b;
    case Code::recovery_missing:
    case Code::recovery_elsewhere:
    case Code::recovery_unclaimed:
    case Code::recovery_spends_charge:
    case Code::landing_outside:
    case Code::window_without_way_out:
    case Code::window_may_pass:
    case Code::others_unkept:
    case Code::agent_unkept:
      return Kind::p2a;
    case Code::speed_limit_unkept:
      return analysis::is_too_fast_at_rest(d) ? Kind::p2b : Kind::p2a;
    case Code::site_outside_zone:
    case Code::return_set_empty:
    case Code::site_not_returnable:
    case Code::site_unreachable:
    case Code::no_way_back:
    case Code::recovery_stands:
      return Kind::p2b;
    case Code::recovery_breaks:
      return Kind::keeps;
    case Code::limit_contradictory:
    case Code::window_too_short:
      return Kind::satisfiable;
    default:
      return std::nullopt;
  }
}

// What is not shown to be kept need not be broken: a recovery may never lead where it could be, nor
// drive as fast before somebody takes over, robots may see each other early enough, and who is kept
// waiting may still get out in time.
bool takes_a_run(const diag::Diagnostic& d) {
  return d.code == Code::recovery_elsewhere || d.code == Code::others_unkept ||
         d.code == Code::window_may_pass || analysis::ends_near_window(d) ||
         analysis::lands_near_the_limit(d) || analysis::stands_near_its_limit(d) ||
         (d.code == Code::speed_limit_unkept && !analysis::is_too_fast_at_rest(d));
}

// A recovery that moves elsewhere leads to where its own zone has room, which says nothing of what
// else its monitor asks for: that it leads to where control is given back is no proof any more, and
// a run may show that it does not.
void doubt_return(const sema::Spec& spec, const Obligation& elsewhere,
                  std::vector<Obligation>& all) {
  const auto back = std::ranges::find_if(all, [&](const Obligation& o) {
    return o.kind == Kind::p2b && o.monitor == elsewhere.monitor;
  });
  const auto m = std::ranges::find(spec.monitors, elsewhere.monitor, &sema::Monitor::name);
  if (back == all.end() || m == spec.monitors.end() || !m->recover) return;
  if (back->status != Status::proved && back->status != Status::unknown) return;
  back->status = Status::refuted;
  back->by_a_run = true;
  back->method = elsewhere.method;
  back->because = "`" + spec[*m->recover].name + "` need not lead to where `" + elsewhere.monitor +
                  "` gives control back";
  back->repair = elsewhere.repair;
  back->claims.clear();
}

bool is_about(const diag::Diagnostic& d, const sema::Monitor& m) {
  if (!d.monitor.empty()) return d.monitor == m.name;
  return d.range && d.range->file == m.range.file && d.range->begin >= m.range.begin &&
         d.range->begin <= m.range.end;
}

// What breaks the monitor is the recovery of another one: that is said of the pair.
void refute_pair(Obligation refuted, const std::string& recovery, std::vector<Obligation>& all) {
  refuted.kind = Kind::keeps;
  refuted.recovery = recovery;
  const auto pair = std::ranges::find_if(all, [&](const Obligation& o) {
    return o.kind == Kind::keeps && o.monitor == refuted.monitor && o.recovery == recovery;
  });
  if (pair == all.end()) {
    all.push_back(std::move(refuted));
  } else if (pair->status != Status::acknowledged) {
    // where the matrix has an argument, there is one
    if (pair->status == Status::refuted && !pair->by_a_run) refuted.by_a_run = false;
    refuted.starts = std::move(pair->starts);
    refuted.unmet = std::move(pair->unmet);
    refuted.engaged = std::move(pair->engaged);
    *pair = std::move(refuted);
  }
}

// Who never gives control back does so nowhere together with others.
void refute_joint_return(const std::string& monitor, std::vector<Obligation>& all) {
  const auto joint = std::ranges::find(all, Kind::joint_return, &Obligation::kind);
  if (joint == all.end()) return;
  if (joint->status != Status::proved && joint->status != Status::unknown) return;
  joint->status = Status::refuted;
  joint->method = "P2b of `" + monitor + "`";
  joint->because = "`" + monitor + "` gives control back nowhere";
  const bool is_shown = std::ranges::any_of(all, [&](const Obligation& o) {
    return o.kind == Kind::p2b && o.monitor == monitor && o.status == Status::refuted;
  });
  if (is_shown) joint->not_shown = "a run that shows P2b shows it as well";
  joint->repair.clear();
  joint->claims.clear();
}
// The decision that a report stands in, with the line of the next one below it.
std::size_t decision_around(const sema::Spec& spec, const diag::Diagnostic& d) {
  std::size_t at = 0;
  for (std::size_t n = 0; n < spec.decisions.size() && d.range; ++n) {
    const SourceRange& name = spec.decisions[n].name_range;
    if (name.file == d.range->file && name.begin <= d.range->begin) at = n;
  }
  return at;
}
bool is_jitter(const sema::Decision& decision, const diag::Diagnostic& d) {
  return decision.jitter && d.range && decision.jitter->range.file == d.range->file &&
         decision.jitter->range.begin == d.range->begin;
}

// The controller that is declared where the report stands; null: none is.
const sema::Controller* declared_at(const sema::Spec& spec, const diag::Diagnostic& d) {
  const auto declared = std::ranges::find_if(
      spec.controllers, [&](const sema::Controller& c) { return d.range == c.name_range; });
  return declared == spec.controllers.end() ? nullptr : &*declared;
}
// The first decision of the robots that it drives.
std::optional<std::size_t> decision_driven(const sema::Spec& spec, const diag::Diagnostic& d) {
  const sema::Controller* const declared = declared_at(spec, d);
  if (declared == nullptr) return std::nullopt;
  const auto of = std::ranges::find(spec.decisions, declared->kind, &sema::Decision::kind);
  if (of == spec.decisions.end()) return std::nullopt;
  return static_cast<std::size_t>(of - spec.decisions.begin());
}
// What a recovery cannot do with the limits says nothing of what its monitor asks for, which may
// well be satisfied: it does not keep it.
void blame_recovery(const sema::Spec& spec, const diag::Diagnostic& d, Obligation& o) {
  const sema::Controller* const declared = declared_at(spec, d);
  if (declared == nullptr) return;
  const auto engaged = std::ranges::find_if(spec.monitors, [&](const sema::Monitor& m) {
    return m.recover && &spec[*m.recover] == declared;
  });
  if (engaged == spec.monitors.end()) return;
  o.kind = Kind::p2a;
  o.monitor = engaged->name;
}
// Of a whole decision there is one obligation, and what is wrong with several recoveries is told of
// each.
bool is_told_besides(const Obligation& told, const Obligation& of) {
  return of.monitor.empty() && told.status == Status::refuted && told.method == of.method;
}
void tell_besides(Obligation& told, const Obligation& of) {
  told.because += "; " + of.because;
  if (told.repair != of.repair) told.repair += "; and " + of.repair;
}

// By the place of the report: the monitor, or the decision around it, or of a recovery.
void add_refuted(const sema::Spec& spec, const diag::Diagnostic& d, Kind kind, Report& report) {
  Obligation o;
  o.kind = kind;
  o.status = Status::refuted;
  o.method = by_diagnostic(d.code);
  o.because = d.message;
  o.repair = d.help;
  o.by_a_run = takes_a_run(d);
  if (d.code == Code::site_outside_zone) o.not_shown = "no way can end there, and no run has to";
  const bool of_decision = kind == Kind::joint_return;
  std::size_t at = 0;
  for (const sema::Monitor& m : spec.monitors) {
    if (!is_about(d, m)) continue;
    if (!of_decision) o.monitor = m.name;
    for (std::size_t n = 0; n < spec.decisions.size(); ++n) {
      for (const sema::MonitorId id : spec.decisions[n].priority) {
        if (&spec[id] == &m) at = n;
      }
    }
  }
  if (o.monitor.empty() && !of_decision) {
    const std::size_t around = decision_around(spec, d);
    const bool late = around < spec.decisions.size() && is_jitter(spec.decisions[around], d);
    if (late) o.kind = Kind::p1a;
    if (late || kind == Kind::p1b) at = around;
    at = decision_driven(spec, d).value_or(at);
  }
  if (at >= report.decisions.size()) return;
  // of a look-ahead that leaves no place to return to
  if (d.code == Code::limit_contradictory && !o.monitor.empty()) o.kind = Kind::p2b;
  if (d.code == Code::limit_contradictory && o.monitor.empty()) blame_recovery(spec, d, o);
  if (!d.recovery.empty()) {
    refute_pair(std::move(o), d.recovery, report.decisions[at].obligations);
    return;
  }
  // What was shown of the rest of it is no proof any more.
  auto& all = report.decisions[at].obligations;
  const bool never = d.code == Code::return_set_empty || analysis::is_too_fast_at_rest(d);
  if (never && !of_decision) refute_joint_return(o.monitor, all);
  const auto same = std::find_if(all.begin(), all.end(), [&](const Obligation& other) {
    return other.kind == o.kind && other.monitor == o.monitor;
  });
  if (d.code == Code::recovery_elsewhere) doubt_return(spec, o, all);
  if (same != all.end() && is_told_besides(*same, o)) {
    tell_besides(*same, o);
  } else if (same != all.end()) {
    if (!o.place_mm) o.place_mm = same->place_mm;  // a robot is stuck there all the same
    *same = std::move(o);
  } else {
    all.push_back(std::move(o));
  }
}

// Where a monitor by itself never gives control back, numbers are offered that have been tried on
// the whole specification: of all monitors together nothing else is the matter.
void repair_together(Report& report) {
  const std::string never_by_itself = by_diagnostic(Code::return_set_empty);
  for (Decision& decision : report.decisions) {
    auto& all = decision.obligations;
    const auto own = std::ranges::find_if(all, [&](const Obligation& o) {
      return o.kind == Kind::p2b && o.method == never_by_itself && !o.repair.empty();
    });
    const auto together = std::ranges::find_if(all, [](const Obligation& o) {
      return o.kind == Kind::joint_return && o.status == Status::refuted;
    });
    if (own == all.end() || together == all.end()) continue;
    if (together->method == never_by_itself) continue;
    const std::size_t growth = together->repair.find("`grow(");
    const std::string wider =
        growth == std::string::npos ? "" : "; or " + together->repair.substr(growth) + " works";
    together->repair = own->repair + wider;
  }
}

// What no sample shows to hold is never given back either, for which more is needed: there is one
// number for both, and it has been tried on the whole specification.
void repair_unseen(const sema::Spec& spec, const std::vector<diag::Diagnostic>& found,
                   Report& report) {
  const auto never_given_back = [](const diag::Diagnostic& d) {
    return d.code == Code::speed_limit_unkept ||
           (d.code == Code::return_set_empty && !analysis::is_apart_for_ever(d));
  };
  for (Decision& decision : report.decisions) {
    for (Obligation& o : decision.obligations) {
      if (o.kind != Kind::satisfiable || o.status == Status::proved) continue;
      const auto m = std::ranges::find(spec.monitors, o.monitor, &sema::Monitor::name);
      const auto tried = std::ranges::find_if(found, [&](const diag::Diagnostic& d) {
        return m != spec.monitors.end() && never_given_back(d) && is_about(d, *m);
      });
      if (tried != found.end()) o.repair = tried->help;
    }
  }
}

// Where ways lead nowhere, or are not found, the zone that the check has tried: of a passage that
// is too narrow, the one in which control is given back all along it (5020, 5021).
void repair_ways(const sema::Spec& spec, const std::vector<diag::Diagnostic>& found,
                 Report& report) {
  for (Decision& decision : report.decisions) {
    for (Obligation& o : decision.obligations) {
      const bool open = o.status == Status::refuted || o.status == Status::unknown;
      if (o.kind != Kind::p2b || !open || !o.repair.empty()) continue;
      const auto m = std::ranges::find(spec.monitors, o.monitor, &sema::Monitor::name);
      const auto tried = std::ranges::find_if(found, [&](const diag::Diagnostic& d) {
        const bool of_ways = d.code == Code::no_way_back || d.code == Code::corridor_too_narrow;
        return of_ways && m != spec.monitors.end() && is_about(d, *m) &&
               d.help.find(" works") != std::string::npos;
      });
      if (tried == found.end()) continue;
      o.repair = tried->help;
      if (tried->code == Code::corridor_too_narrow) {
        o.repair = o.repair.substr(o.repair.find("; ") + 2) + ": control is given back all along";
      }
    }
  }
}

template <class Visit>
void for_each_subject(const sema::Spec& spec, const ir::Module& module, const ir::TableMap& tables,
                      const Visit& visit, bool is_read = true) {
  ExactZones zones(spec, tables);
  const analysis::ExactZone exact = [&](ir::ZoneIndex zone) -> const geometry::Region& {
    return zones(zone);
  };
  const std::function<const geometry::Solid&(ir::ZoneIndex)> solid =
      [&](ir::ZoneIndex zone) -> const geometry::Solid& { return zones.solid(zone); };
  const analysis::ZoneOf zone_of = [&](ir::ZoneIndex zone) -> std::optional<sema::ZoneId> {
    const auto at = std::ranges::find(tables.zones, std::optional(zone));
    if (at == tables.zones.end()) return std::nullopt;
    return sema::ZoneId(at - tables.zones.begin());
  };
  for (std::size_t n = 0; n < module.decisions.size(); ++n) {
    const sema::Decision& written = spec.decisions[n];
    visit(Subject{spec, module, written, module.decisions[n], exact, solid, zone_of,
                  spec[written.kind], is_read});
  }
}

// Of a pair, what the check has tried with the whole specification, and offers (6005), and nothing
// else: a number of the energy clause may take more charge than there is, a zone be too small for
// another property, and another order break another pair.
void repair_pairs(const sema::Spec& spec, const std::vector<diag::Diagnostic>& found,
                  Report& report) {
  for (Decision& decision : report.decisions) {
    for (Obligation& o : decision.obligations) {
      if (o.kind != Kind::keeps || o.status == Status::acknowledged) continue;
      if (o.repair.starts_with("`acknowledge ")) continue;  // changes nothing
      const auto drives = [&](const sema::Monitor& m, const diag::Diagnostic& d) {
        return m.recover && spec[*m.recover].name == o.recovery && d.range == m.recover_range;
      };
      const auto tried = std::ranges::find_if(found, [&](const diag::Diagnostic& d) {
        return d.code == Code::recovery_breaks &&
               d.label.find(quoted(o.monitor)) != std::string::npos &&
               std::ranges::any_of(spec.monitors, [&](const auto& m) { return drives(m, d); });
      });
      const bool repairs = tried != found.end() && !tried->help.starts_with("`acknowledge ");
      o.repair = repairs ? tried->help : "";
    }
  }
}

// That a recovery keeps what one of its own monitors says, whomever of them it drives for, is P2a.
void drop_own(const sema::Spec& spec, Report& report) {
  for (Decision& decision : report.decisions) {
    for (Obligation& o : decision.obligations) {
      if (o.kind != Kind::keeps || o.status != Status::proved) continue;
      const auto m = std::ranges::find_if(spec.monitors, [&](const sema::Monitor& each) {
        return each.name == o.monitor && each.recover && spec[*each.recover].name == o.recovery;
      });
      if (m == spec.monitors.end()) continue;
      const auto own = std::ranges::find_if(decision.obligations, [&](const Obligation& other) {
        return other.kind == Kind::p2a && other.monitor == o.monitor;
      });
      const bool shown = own == decision.obligations.end() || own->status == Status::proved;
      if (shown || own->status == Status::acknowledged) continue;
      o.status = Status::unknown;
      o.method = "no proof";
      o.because = "P2a of `" + o.monitor + "` is not shown, of the same recovery";
      o.claims.clear();
    }
  }
}

// Without places that runs might begin at.
Report obligations_of(const sema::Spec& spec, const ir::Module* module, const ir::TableMap& tables,
                      const std::vector<diag::Diagnostic>& found, const protocol::CheckModel& check,
                      bool is_read) {
  Report report;
  report.spec = spec.name;
  report.complete = module != nullptr;
  if (module != nullptr) {
    const bool refuted = std::any_of(found.begin(), found.end(), [](const diag::Diagnostic& d) {
      return diag::info(d.code).severity == diag::Severity::error;
    });
    const protocol::CheckModel asked = refuted ? protocol::CheckModel() : check;
    for_each_subject(
        spec, *module, tables,
        [&](const Subject& s) { report.decisions.push_back(Prover(s, asked).run()); }, is_read);
  } else {
    for (const sema::Decision& d : spec.decisions) {
      report.decisions.push_back({d.name, spec[d.kind].name, {}, {}});
    }
  }
  repair_pairs(spec, found, report);
  for (const diag::Diagnostic& d : found) {
    if (diag::info(d.code).severity != diag::Severity::error) continue;
    // of a place that is read, and no recovery leads to
    if (d.code == Code::site_outside_zone && d.monitor.empty()) continue;
    const auto kind = refuted_by(d);
    // what the matrix says already
    if (kind && *kind != Kind::keeps) add_refuted(spec, d, *kind, report);
  }
  repair_together(report);
  repair_unseen(spec, found, report);
  repair_ways(spec, found, report);
  drop_own(spec, report);
  return report;
}

}  // namespace

Report verify(const sema::Spec& spec, const ir::Module* module, const ir::TableMap& tables,
              const std::vector<diag::Diagnostic>& found, const protocol::CheckModel& check) {
  Report report = obligations_of(spec, module, tables, found, check, true);
  if (module != nullptr) {
    for_each_subject(spec, *module, tables, [&](const Subject& s) {
      for (Decision& d : report.decisions) {
        if (d.name == s.decision.name) add_starts(s, d);
      }
    });
  }
  return report;
}

std::set<analysis::Fault> open_obligations(const sema::Spec& spec, const ir::Module& module,
                                           const ir::TableMap& tables,
                                           const std::vector<diag::Diagnostic>& found,
                                           const protocol::CheckModel& check) {
  std::set<analysis::Fault> all;
  const Report report = obligations_of(spec, &module, tables, found, check, false);
  for (std::size_t n = 0; n < report.decisions.size(); ++n) {
    for (const Obligation& o : report.decisions[n].obligations) {
      const bool open = o.status == Status::unknown || o.status == Status::refuted;
      if (!open || (o.kind == Kind::switching && !o.in_turns)) continue;
      const auto m = std::ranges::find(spec.monitors, o.monitor, &sema::Monitor::name);
      const SourceRange at = m != spec.monitors.end() ? m->range : spec.decisions[n].name_range;
      all.insert({{}, at.file, at.begin, std::string(name(o.kind)) + " " + o.recovery});
    }
  }
  return all;
}

std::vector<diag::Diagnostic> never_given_back(const sema::Spec& spec, const ir::Module& module,
                                               const ir::TableMap& tables) {
  std::vector<diag::Diagnostic> all;
  // of other monitors the ways back are all there is to say (5020, 5021)
  const auto asks_for_more = [](const ir::Monitor& m) {
    const auto& values = m.property.values;
    return m.return_when || std::any_of(values.begin(), values.end(), [](const ir::Value& v) {
             return std::holds_alternative<ir::Or>(v.op);
           });
  };
  const bool any =
      std::any_of(module.decisions.begin(), module.decisions.end(), [&](const ir::Decision& d) {
        return !d.on_plan && std::any_of(d.monitors.begin(), d.monitors.end(), asks_for_more);
      });
  if (!any) return all;
  for_each_subject(spec, module, tables, [&](const Subject& s) {
    for (std::size_t k = 0; k < s.decision.monitors.size() && !s.decision.on_plan; ++k) {
      if (!asks_for_more(s.decision.monitors[k])) continue;
      const Obligation back = control_returns(s, k);
      if (back.status != Status::refuted || back.method != by_geometry) continue;
      all.push_back({Code::no_way_back,
                     s.monitor(k).recover_range,
                     back.because,
                     "ends there once the robot is there",
                     {},
                     back.repair,
                     {}});
    }
  });
  return all;
}

std::vector<protocol::Arbitration> turns_of(const sema::Spec& spec, const ir::Module& module,
                                            const ir::TableMap& tables) {
  std::vector<protocol::Arbitration> all;
  for_each_subject(spec, module, tables, [&](const Subject& s) {
    all.push_back(s.decision.on_plan ? protocol::Arbitration() : known_turns(s, matrix_of(s)));
  });
  return all;
}

}  // namespace rtac::verify
