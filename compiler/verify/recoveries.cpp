// P2a and the matrix of arbitration: what recoveries keep.
#include <algorithm>

#include "compiler/analysis/company.h"
#include "compiler/analysis/outline.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/analysis/windows.h"
#include "compiler/ir/linear.h"
#include "compiler/ir/words.h"
#include "compiler/support/words.h"
#include "compiler/verify/about_recovery.h"
#include "compiler/verify/atoms.h"
#include "compiler/verify/docking.h"
#include "compiler/verify/leaving.h"
#include "compiler/verify/proofs.h"
#include "compiler/verify/within_zones.h"

namespace rtac::verify {
namespace {

// What moves is gated by distances to others, robots and agents. How long it waits for them nothing
// bounds but what is declared (language rule 6.7): whoever writes `held` accepts that, and the
// proof is one of all the rest. A run in which a battery fails counts against the monitor's own
// recovery, unless something else may have spent the charge that the specification accepts.
Obligation as_long_as_declared(const Subject& s, std::size_t driving, const ir::Monitor& judged,
                               Obligation o) {
  const ir::Decision& d = s.decision;
  const bool alone = d.robots == 1 && !d.open_fleet;
  const bool by_robots = !alone && std::ranges::any_of(d.monitors, [](const ir::Monitor& m) {
    return atoms_of(m.property).distance;
  });
  const bool by_agents = std::ranges::any_of(
      d.monitors, [](const ir::Monitor& m) { return atoms_of(m.property).agent; });
  if (!(by_robots || by_agents) || !s.kind.energy || !atoms_of(judged.property).charge) return o;
  if (!moves_within_zones(d.monitors[driving].recovery)) return o;
  o.status = Status::acknowledged;
  o.method = "declared";
  o.because += ", as long as others keep it waiting within `held`, " +
               seconds(s.kind.energy->held.value) + " in all";
  // agents of the simulator stand in nobody's way for long
  if (!by_robots || o.kind != Kind::p2a) return o;
  const bool unaccepted = std::ranges::none_of(
      d.acknowledgements, [&](const auto& a) { return a.monitor == judged.name; });
  const Docking docking = docking_of(s, judged);
  o.declared = unaccepted || docking.in_turn();
  if (!o.declared) return o;
  o.mends = longer_waits(s, docking);
  if (docking.in_turn() && !d.body.in_space) o.dock = {docking.robot, docking.at_mm};
  if (docking.wait_s() <= s.kind.energy->held.value) return o;
  return held_for_too_long(s, docking, std::move(o));
}

// How often others take over before the robot is at its dock, and how much longer its way there
// becomes over the cells of another zone, nothing bounds but what is declared.
Obligation within_what_is_declared(const Subject& s, Obligation o) {
  if (o.status != Status::proved) return o;
  o.status = Status::acknowledged;
  o.method = "declared";
  o.because += ", as long as all that drive before it keep to `held`, " +
               seconds(s.kind.energy->held.value) + ", and `detour`, " +
               metres(s.kind.energy->detour.value) + ", in all";
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
// own.
Doubt doubt_about(const Subject& s, std::size_t k, std::size_t judged) {
  const ir::Block& property = s.decision.monitors[judged].property;
  const ir::Recovery& recovery = s.decision.monitors[k].recovery;
  if (Doubt behind = falls_behind(s, recovery); !behind.why.empty()) return behind;
  if (std::string windows = doubt_of_windows(s, k, judged); !windows.empty()) return {windows};
  if (!moves_within_zones(recovery)) return {};
  const Atoms atoms = atoms_of(property);
  if (atoms.charge || atoms.energy) {
    if (std::string off = off_its_dock(s, ir::last_step(recovery)); !off.empty()) return {off};
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

Obligation keeps_its_own(const Subject& s, std::size_t k) {
  const ir::Monitor& m = s.decision.monitors[k];
  Obligation o = blank(s, k, Kind::p2a);
  const Atoms atoms = atoms_of(m.property);
  o.status = Status::proved;
  o.method = std::string("template ") + ir::word_of(m.recovery.kind);
  if (m.recovery.kind == ir::RecoveryKind::external) {
    o.method = "claim, checked in every tick";
    o.because = quoted(m.recovery.name) + " is braked as soon as it might leave " +
                quoted(s.module[m.recovery.zone].name) +
                ", or is seen to be faster than it claims; that it is not so between two ticks is "
                "assumed";
  } else if (atoms.only_facts()) {
    o.method = "no part of the robot";
    o.because = "what " + quoted(m.name) + " says depends on inputs alone";
  } else {
    const bool moves = std::ranges::any_of(
        ir::steps_of(m.recovery), [](const ir::Recovery* step) { return ir::moves(step->kind); });
    const bool alone = s.decision.robots < 2 && !s.decision.open_fleet;
    o.because = quoted(m.recovery.name) + " brakes within what was found clear" +
                (moves ? ", and moves only where the property holds" : ", and holds its place") +
                (moves && !alone ? ", gated by the distances to others" : "");
    if (atoms.received) {
      o.because = quoted(m.recovery.name) +
                  " brakes within what was found clear, as long as the zone that was received "
                  "stays as it is";
    }
  }
  if (Doubt doubt = doubt_about(s, k, k); !doubt.why.empty()) {
    return doubted(std::move(o), std::move(doubt));
  }
  // which errors of the analysis say as well, but where another one comes first, or it is accepted
  const bool charged = m.recovery.kind == ir::RecoveryKind::route && m.recovery.charges;
  if (atoms.charge && !charged) {
    return doubted(std::move(o),
                   {"nobody accounts for the charge that " + quoted(m.recovery.name) + " spends"});
  }
  if (!slow_enough(s, k, k)) {
    return doubted(std::move(o), {quoted(m.recovery.name) + " may drive faster than " +
                                  quoted(m.name) + " allows"});
  }
  o = as_long_as_declared(s, k, m, std::move(o));
  if (o.status == Status::refuted) return o;
  o.claims.push_back(limits_claim(s));
  o.claims.push_back(recovery_claim(s, k));
  claim_zones(s, k, k, o.claims);
  claim_windows(s, k, o);
  if (m.recovery.kind != ir::RecoveryKind::brake) o.claims.push_back(lemma_claim("way_pieces"));
  for (const std::string& lemma : lemmas_of(atoms, s.decision, m)) {
    o.claims.push_back(lemma_claim(lemma));
  }
  return o;
}

}  // namespace

// Where the look-ahead is less than it takes, nothing was found clear for as long as it brakes.
Obligation recovery_keeps(const Subject& s, std::size_t k) {
  Obligation o = unless_accepted(s, k, Kind::p2a, [&] { return keeps_its_own(s, k); });
  const std::string why = unsound_reason(s, k);
  if (o.status != Status::proved || why.empty()) return o;
  return acknowledged(blank(s, k, Kind::p2a), "the look-ahead is declared unsound: " + why);
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
  if (const std::string unsound = unsound_reason(s, judged); !unsound.empty()) {
    return acknowledged(std::move(o), "the look-ahead is declared unsound: " + unsound);
  }
  const std::string itself = quoted(i.recovery.name) + " keeps " + quoted(j.name) +
                             " as far as its own robot goes, and others may break it";
  if (judged < driving && !s.decision.coordinated && i.recovery.name != j.recovery.name) {
    o.because = itself + ": " + quoted(j.name) + " ranks higher, and " + quoted(j.recovery.name) +
                " takes over as soon as they might";
    return o;
  }
  const bool brakes = i.recovery.kind == ir::RecoveryKind::brake;
  if (brakes && i.recovery.name == j.recovery.name && analysis::holds_held(s.decision, j)) {
    o.because += ", whose recovery it is, too: whoever comes near finds a robot that stands";
    return o;
  }
  o = doubted(std::move(o), {itself});
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
  if (place_mm.size() == 3) {
    const auto most = ir::upper_bound(block, *compare);
    const auto is_height = [](const auto& bound) {
      return bound && bound->leaf.kind == ir::Leaf::Kind::altitude;
    };
    if (!is_height(least) && !is_height(most)) return std::nullopt;
    const bool keeps = (!is_height(least) || place_mm[2] >= least->need.strictest) &&
                       (!is_height(most) || place_mm[2] <= most->most);
    return Says{keeps, !keeps};
  }
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

// What has one of the two properties fail may make the other one hold.
bool share_inputs(const Subject& s, std::size_t a, std::size_t b) {
  return analysis::share_inputs(s.spec, {s.monitor(a).always.get(), s.monitor(b).always.get()});
}

// No inputs have it fail, whatever the robot does.
bool is_never_false(const Subject& s, std::size_t k) {
  const analysis::Told told =
      analysis::told_to_be(s.spec, *s.monitor(k).always, false, analysis::ToldHow::exactly);
  return told.can == analysis::CanBeTold::no;
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
  if (!why.empty()) return acknowledged(std::move(o), why);
  const std::string within = entry.within.empty() ? "" : entry.within.front().help;
  o.repair = entry.help.empty() && !within.empty() ? within + " works" : entry.help;
  if (atoms_of(j.property).received) return o;  // that it happens is not shown either
  o.status = Status::refuted;
  o.method = "geometry and bounds";
  // what inputs may ask for nobody has to drive to: it drives faster than that as it is written
  o.by_a_run = !entry.while_told || share_inputs(s, driving, judged) || is_never_false(s, judged) ||
               i.recovery.speed_mmps <= analysis::least_limit_mmps(j.property);
  if (entry.silences) o.by_a_run = false;
  o.starts = starts_of_damage(s, driving, judged);
  if (atoms_of(j.property).charge) o.place_mm = engaged_at(s, i);
  if (!o.place_mm) o.place_mm = i.returns.stuck_mm;  // it waits there for ever
  if (entry.unending) {
    o.by_a_run = false;
    o.because += "; whoever keeps " + quoted(i.name) +
                 " engaged for as long as a battery lasts makes " + quoted(j.name) + " fail";
    o.unending = true;
  }
  if (entry.stands && !entry.unending) {
    o.because += ": where it stands " + quoted(i.name) + " may not give control back";
    o.unending = true;
  }
  const bool of_inputs = atoms_of(i.property).only_facts();
  if (of_inputs) o.unmet = i.name;
  if (o.unending) return o;
  // that its way leads there breaks a limit of speed only at that speed, which a run shows
  if (!o.starts.empty() && !atoms_of(j.property).speed && !share_inputs(s, driving, judged) &&
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
  Obligation o = blank(s, judged, Kind::keeps);
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
  Doubt doubt = doubt_about(s, driving, judged);
  const bool is_too_fast = !slow_enough(s, driving, judged);
  if (is_too_fast) {
    const Rational fastest(analysis::fastest_while_driving(s.decision, driving), 1000);
    doubt = {quoted(i.recovery.name) + " drives at up to " + to_decimal(fastest) + " m/s, and " +
             quoted(j.name) + " allows less"};
  }
  if (!doubt.why.empty() && !why.empty()) return acknowledged(std::move(o), why);
  if (!doubt.why.empty()) {
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
  claim_zones(s, driving, judged, o.claims);
  claim_windows(s, judged, o);
  if (atoms_of(j.property).charge && i.recovery.name != j.recovery.name) {
    if (const auto lasts = lasting_claim(s, driving)) {
      o.claims.push_back(*lasts);
      o = within_what_is_declared(s, std::move(o));
    }
  }
  if (analysis::others_may_break(s.decision, j, i.recovery)) {
    return among_others(s, driving, judged, std::move(o));
  }
  if (atoms_of(j.property).agent) {
    o.because += ", whoever comes near: the separation gate stops it, and then it is slow enough";
  }
  return o;
}

}  // namespace rtac::verify
