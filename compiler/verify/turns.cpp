// The switching protocol: that somebody drives, and that recoveries do not take over from each
// other for ever. docs/protocol.md has the model.
#include "compiler/verify/turns.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

#include "compiler/analysis/by_border.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/paces.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/windows.h"
#include "compiler/ir/acknowledged.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"
#include "compiler/verify/atoms.h"
#include "compiler/verify/other_recoveries.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {
namespace {

// Where properties are about other robots, they promise each other to stay.
bool has_promises(const ir::Decision& d) {
  const auto& facts = d.facts.monitors;
  return std::any_of(facts.begin(), facts.end(),
                     [](const auto& fact) { return judges_others(fact.property); }) ||
         std::any_of(d.monitors.begin(), d.monitors.end(), [](const ir::Monitor& m) {
           return judges_others(m.property) || (m.ahead && judges_others(*m.ahead)) ||
                  (m.return_when && judges_others(*m.return_when));
         });
}

// Where recovery i leads is proved with P2b of one of the monitors that it recovers for.
bool leads_back(const Subject& s, std::size_t i) {
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    if (s.decision.monitors[k].recovery.name != s.decision.monitors[i].recovery.name) continue;
    const Obligation back = control_returns(s, k);
    const bool leads = std::any_of(back.claims.begin(), back.claims.end(), [](const Claim& c) {
      return c.what == "ways" || c.what == "legs";
    });
    if (back.status == Status::proved && leads) return true;
  }
  return false;
}

// Every limit of height, where a recovery has come to rest.
bool keeps_heights(const Subject& s, const ir::Recovery& last, const ir::Monitor& m) {
  const std::int64_t gap_mm = analysis::return_height_mm(s.decision, m.lookahead.duration_us);
  bool all = true;
  ir::for_each_comparison(m.property, [&](const ir::Block& block, const ir::AtLeast& compare) {
    for (const auto& [leaf, coefficient] : ir::linear_form(block, compare).terms) {
      if (leaf.kind != ir::Leaf::Kind::altitude) continue;
      all = all && rests_at_height(s, last, gap_mm, block, compare);
    }
  });
  return all;
}

// Who is as clear as that of the boundary of a zone, being in it, has what is needed.
bool leaves(const Subject& s, ir::ZoneIndex zone, std::int64_t clearance_mm, const Need& need) {
  const std::int64_t more_mm = need.clearance_mm - clearance_mm;
  if (need.zone == zone) return more_mm <= 0;
  if (more_mm <= 0) return lies_in(s, zone, need.zone);
  if (s.module[need.zone].has_height() || s.module[zone].has_height()) return false;
  // the zone may lie so deep in the other one that it leaves no more itself
  const auto deep = analysis::within(s.exact(need.zone), more_mm);
  return deep && deep->contains(s.exact(zone));
}

// A monitor lets its recovery go as soon as what it says of zones holds with the clearance to
// return, and its `return when`, which may be long before that is where it leads. Then that is what
// another one has, too; or the monitor says nothing of zones, and lets go where others are far or
// the robot is slow.
bool has_early(const Subject& s, const ir::Monitor& lets_go, const Need& need) {
  const auto& params = s.decision.facts.params;
  if (!atoms_of(lets_go.property).clearance) return true;
  const auto has = [&](const ir::Block& said, std::int64_t more_mm) {
    return std::ranges::any_of(analysis::surely_in(said, params), [&](const auto& one_of) {
      return !one_of.empty() && std::ranges::all_of(one_of, [&](const analysis::Standoff& in) {
        return leaves(s, in.zone, more_mm + in.mm, need);
      });
    });
  };
  return has(lets_go.property,
             analysis::return_clearance_mm(s.decision, lets_go.lookahead.duration_us)) ||
         (lets_go.return_when &&
          has(*lets_go.return_when, floor_to_int(Rational(1000 * s.kind.radius.value))));
}

// Whichever of two drives, the robot comes nearer to where both lead.
bool lead_the_same_way(const ir::Recovery& a, const ir::Recovery& b) {
  return a.kind == ir::RecoveryKind::retreat && b.kind == a.kind && a.zone == b.zone &&
         a.speed_mmps == b.speed_mmps && a.return_clearance_mm == b.return_clearance_mm &&
         a.route_clearance_mm == b.route_clearance_mm;
}

// What becomes of a monitor when another one lets its recovery go.
struct LedOn {
  bool by_its_own;  // it has the same one
  bool as_before;   // or one that leads the same way, and neither takes over from the other
  bool kept;        // the recovery keeps what it says
};

// The zones of a property that holds wherever all of them are as clear as they are to be, whatever
// inputs say of when they count. False: it is no such property.
bool places_whatever_told(const Subject& s, const ir::Block& block, ir::ValueId id,
                          std::vector<ir::ZoneIndex>& zones) {
  const ir::Op& op = block[id].op;
  const auto of = [&](ir::ValueId side) { return places_whatever_told(s, block, side, zones); };
  // who only asks inputs is not about who drives
  if (analysis::told(block, id)) return true;
  if (const auto* both = std::get_if<ir::And>(&op)) return of(both->a) && of(both->b);
  if (const auto* either = std::get_if<ir::Or>(&op)) {
    if (analysis::told(block, either->a)) return of(either->b);
    return analysis::told(block, either->b) && of(either->a);
  }
  if (std::holds_alternative<ir::Not>(op) || std::holds_alternative<ir::ZoneThere>(op))
    return false;
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  if (compare == nullptr) return true;
  const auto bound = ir::lower_bound(block, *compare, s.decision.facts.params);
  if (bound && bound->leaf.kind == ir::Leaf::Kind::clearance) {
    zones.push_back(ir::ZoneIndex{bound->leaf.table});
    return true;
  }
  return std::ranges::none_of(ir::linear_form(block, *compare).terms, [](const auto& term) {
    return term.first.kind == ir::Leaf::Kind::clearance;
  });
}

// How clear of a zone a robot at rest is given back by every monitor that asks for it; one that a
// recovery drives, with that.
std::int64_t returned_mm(const Subject& s, ir::ZoneIndex zone, const ir::Motion* motion = nullptr) {
  std::int64_t most_mm = 0;
  for (const ir::Monitor& m : s.decision.monitors) {
    if (!m.lookahead.duration) continue;
    std::int64_t back_mm = analysis::return_clearance_mm(s.decision, m.lookahead.duration_us);
    if (motion != nullptr) {
      const std::int64_t ahead_us = m.lookahead.duration_us + s.decision.return_extra_us;
      back_mm = std::max(back_mm, analysis::cruise_clearance_mm(s.decision, *motion, ahead_us));
    }
    for (const analysis::Standoff& each :
         analysis::fence_standoffs(m.property, s.decision.facts.params)) {
      if (each.zone == zone) most_mm = std::max(most_mm, back_mm + each.mm);
    }
  }
  return most_mm;
}

// Wherever recovery i, which drives beside the border of its zone alone, is let go, be it on its
// way, the robot is as clear of another zone as all monitors ask for.
bool leaves_by_border(const Subject& s, std::size_t i, std::size_t j, ir::ZoneIndex other) {
  const analysis::ExactSolid solid = any_solid(s);
  const analysis::TakeOver at{s.module, s.decision, s.exact, solid, j, s.known.get()};
  const auto near_mm = analysis::let_go_within_mm(s.kind, at, i);
  const ir::ZoneIndex zone = ir::last_step(s.decision.monitors[i].recovery).zone;
  const std::int64_t need_mm = returned_mm(s, other, &s.decision.motions[i + 1]);
  return near_mm && analysis::border_lies_deep(at, zone, *near_mm, {other, need_mm});
}

// Where recovery i may return, the derived return condition of monitor j holds: others are far, at
// rest every limit of speed holds, and what recovery i leaves between itself and its zone is enough
// for the zones of j, which hold that one, as is what its own monitor has when it lets go, unless
// it is then led on as before: by the same recovery, or by one that neither takes over from it.
// Zones that come and go make no difference at the site that its own route leads on to (5030).
bool settles(const Subject& s, bool leads, const LedOn& led_on, std::size_t i, std::size_t j) {
  if (i == j) return true;
  const ir::Monitor& m = s.decision.monitors[j];
  const Atoms atoms = atoms_of(m.property);
  if (atoms.charge || atoms.energy) return false;
  if (analysis::holds_at_rest(s.decision, m)) return true;
  if (atoms.received) return false;
  if (!atoms.clearance && !atoms.altitude) return true;
  const ir::Recovery& last = ir::last_step(s.decision.monitors[i].recovery);
  if (!ir::goes_back(last.kind) && last.kind != ir::RecoveryKind::route) return false;
  if (!leads || (atoms.altitude && !keeps_heights(s, last, m))) return false;
  if (analysis::has_windows(m.property)) {
    return led_on.by_its_own && led_on.kept && last.kind == ir::RecoveryKind::route &&
           control_returns(s, j).status == Status::proved;
  }
  std::vector<ir::ZoneIndex> zones;
  return places_whatever_told(s, m.property, m.property.result, zones) &&
         std::ranges::all_of(zones, [&](ir::ZoneIndex zone) {
           const Need need{zone, returned_mm(s, zone)};
           const bool leads_there =
               leaves(s, last.zone, last.return_clearance_mm, need) &&
               (led_on.as_before || has_early(s, s.decision.monitors[i], need));
           return leads_there || (led_on.kept && leaves_by_border(s, i, j, zone));
         });
}

// What the specification accepts counts as if it did not happen: pairs that it acknowledges, and
// recoveries that do not lead out by themselves. Its reasons.
std::string accept(const ir::Decision& d, protocol::Arbitration& known) {
  std::vector<std::string> reasons;
  const auto add = [&](const std::string& why) {
    if (std::find(reasons.begin(), reasons.end(), why) == reasons.end()) reasons.push_back(why);
  };
  for (const ir::Acknowledgement& a : d.acknowledgements) {
    for (std::size_t i = 0; i < d.monitors.size(); ++i) {
      for (std::size_t j = 0; j < d.monitors.size(); ++j) {
        if (d.monitors[i].recovery.name != a.recovery || d.monitors[j].name != a.monitor) continue;
        known.keeps[i][j] = known.settles[i][j] = true;
        add(a.reason);
      }
    }
  }
  for (std::size_t i = 0; i < d.monitors.size(); ++i) {
    if (d.monitors[i].hold_reason.empty()) continue;
    known.settles[i].assign(d.monitors.size(), true);
    add(d.monitors[i].hold_reason);
  }
  std::string all;
  for (const std::string& why : reasons) all += (all.empty() ? "" : "; ") + why;
  return all;
}

using Answers = std::vector<protocol::Answer>;
const protocol::Answer* first(const Answers& answers, protocol::Answer::Kind kind) {
  const auto at = std::find_if(answers.begin(), answers.end(),
                               [&](const protocol::Answer& a) { return a.kind == kind; });
  return at == answers.end() ? nullptr : &*at;
}

// Whether inputs alone may have it be `value`, wherever the robot is; each of them may be told
// both.
bool by_inputs(const ir::Block& block, ir::ValueId id, bool value) {
  const ir::Op& op = block[id].op;
  const auto of = [&](ir::ValueId side) { return by_inputs(block, side, value); };
  if (std::holds_alternative<ir::Fact>(op)) return true;
  if (const auto* truth = std::get_if<ir::Truth>(&op)) return truth->value == value;
  if (const auto* negated = std::get_if<ir::Not>(&op)) return by_inputs(block, negated->a, !value);
  if (const auto* both = std::get_if<ir::And>(&op)) {
    return value ? of(both->a) && of(both->b) : of(both->a) || of(both->b);
  }
  const auto* either = std::get_if<ir::Or>(&op);
  if (either == nullptr) return false;
  return value ? of(either->a) || of(either->b) : of(either->a) && of(either->b);
}

// Of what these recoveries drive for nothing is about other robots or agents, who may have them
// drive whatever they do.
bool are_left_alone(const ir::Decision& d, const std::set<std::string>& names) {
  return std::ranges::none_of(d.monitors, [&](const ir::Monitor& m) {
    return names.contains(m.recovery.name) &&
           (judges_others(m.property) || atoms_of(m.property).agent ||
            (m.return_when && judges_others(*m.return_when)));
  });
}
// The first monitor of inputs alone that has one of these drive; "": there is none.
std::string asked_by_inputs(const ir::Decision& d, const std::set<std::string>& names) {
  const auto m = std::ranges::find_if(d.monitors, [&](const ir::Monitor& each) {
    return names.contains(each.recovery.name) && atoms_of(each.property).only_facts();
  });
  return m == d.monitors.end() ? "" : m->name;
}
Turns turns_among(const ir::Decision& d, const std::set<std::string>& names) {
  Turns turns;
  if (names.size() < 2 || !are_left_alone(d, names)) return turns;
  for (std::size_t k = 0; k < d.monitors.size(); ++k) {
    if (!names.contains(d.monitors[k].recovery.name)) continue;
    turns.modes.push_back(static_cast<int>(k) + 1);
  }
  return turns;
}

// While inputs ask for a recovery that leads out of what another monitor says, that one takes over,
// leads back in, and gives the robot back to it, as often as it comes there: the model takes inputs
// to let go at some time. Of a charge the same is a robot that waits where it is charged. "": none.
struct WhileTold {
  std::string why;
  std::string repair;                   // of the first pair, if it is the only one
  std::set<std::string> drive{};        // of the first pair
  std::optional<OtherLanding> lands{};  // so high that the recovery keeps what it leaves now
};
// Of a pair a landing that ends higher, as what it leaves lies below, and keeps it there.
std::optional<OtherLanding> higher_landing(const std::string& recovery,
                                           const analysis::Entry& entry) {
  if (!entry.change || !entry.change->lands) return std::nullopt;
  return OtherLanding{recovery, entry.change->lands->second};
}
WhileTold turns_while_told(const Subject& s, const analysis::Arbitration& matrix,
                           const protocol::Arbitration& known) {
  const auto& monitors = s.decision.monitors;
  WhileTold found;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    const ir::Recovery& asked = monitors[i].recovery;
    const auto steps = ir::steps_of(asked);
    const bool moves = std::any_of(steps.begin(), steps.end(), [](const ir::Recovery* step) {
      return step->kind != ir::RecoveryKind::brake;
    });
    const ir::Block& says = monitors[i].property;
    if (!moves || !by_inputs(says, says.result, false)) continue;
    for (std::size_t j = 0; j < matrix.size(); ++j) {
      const Atoms atoms = atoms_of(monitors[j].property);
      if ((!atoms.clearance && !atoms.altitude) || known.keeps[i][j]) continue;
      if (ir::acknowledged(s.decision, asked.name, monitors[j].name)) continue;
      const ir::RecoveryKind back = ir::last_step(monitors[j].recovery).kind;
      const bool stands = back == ir::RecoveryKind::brake || !monitors[j].hold_reason.empty();
      if (stands) continue;
      auto lands = higher_landing(asked.name, matrix[i][j]);
      if (!found.why.empty()) {
        found.repair.clear();
        const bool both = found.lands && lands && found.lands->recovery == lands->recovery;
        if (both) lands->height_mm = std::max(lands->height_mm, found.lands->height_mm);
        found.lands = both ? std::move(lands) : std::nullopt;
        continue;
      }
      const std::string& why = matrix[i][j].why;
      found = {"as long as inputs ask for " + quoted(asked.name) + ", it and " +
                   quoted(monitors[j].recovery.name) + " may take over from each other: " +
                   (why.empty()
                        ? quoted(asked.name) + " is not shown to keep " + quoted(monitors[j].name)
                        : why),
               matrix[i][j].help,
               {asked.name, monitors[j].recovery.name},
               std::move(lands)};
    }
  }
  return found;
}

// Whether all recoveries that are named in there move in one zone at one speed.
bool are_alike(const ir::Decision& d, const std::set<std::string>& names) {
  const ir::Recovery* first = nullptr;
  for (const ir::Monitor& m : d.monitors) {
    if (!names.contains(m.recovery.name)) continue;
    const ir::Recovery& last = ir::last_step(m.recovery);
    if (first == nullptr) first = &last;
    if (!ir::moves(last.kind) || last.zone != first->zone || last.speed_mmps != first->speed_mmps) {
      return false;
    }
  }
  return first != nullptr;
}

std::string for_ever(const std::set<std::string>& drivers) {
  std::string names;
  for (const std::string& name : drivers) names += (names.empty() ? "" : ", ") + quoted(name);
  return names + (drivers.size() > 1 ? " take over from each other for ever"
                                     : " drives for one monitor after the other for ever");
}

Obligation unknown(Obligation o, const Subject& s, const protocol::Answer& answer) {
  o.status = Status::unknown;
  if (answer.kind == protocol::Answer::Kind::unknown) {
    o.because = "`" + answer.claim + "` is not shown: " + answer.why;
    return o;
  }
  o.because = "`" + answer.claim + "` is not shown";
  if (answer.drivers.empty()) return o;
  o.in_turns = turns_among(s.decision, answer.drivers);
  o.unmet = asked_by_inputs(s.decision, answer.drivers);
  o.because += ": in a run of the model " + for_ever(answer.drivers);
  const std::string later = "a `return when` that lets none go sooner than all give control back";
  o.repair = (are_alike(s.decision, answer.drivers)
                  ? later + " is needed, or monitors that ask for one zone"
                  : "recoveries of one zone and speed, which is within the zones of all of these "
                    "monitors, are needed, or " +
                        later) +
             "; `rtac protocol` writes the model of " + quoted(s.decision.name);
  return o;
}

}  // namespace

namespace {

// Of a pair that is coordinated: inputs and agents alone break it, and let go at some time. That is
// no doing of another recovery than the one that is the answer to them.
bool is_left_to_its_answer(const Subject& s, const analysis::Entry& entry, std::size_t i,
                           std::size_t j) {
  if (!entry.answered) return false;
  const ir::Block& says = s.decision.monitors[j].property;
  const Atoms atoms = atoms_of(says);
  if (atoms.only_facts() || atoms.only_speed()) return true;
  const auto steps = ir::steps_of(s.decision.monitors[i].recovery);
  return asks_agents_only(says) && std::ranges::none_of(steps, [](const ir::Recovery* step) {
           return step->kind == ir::RecoveryKind::external;
         });
}

// Whether it is proved, or fails by what inputs say alone: as little as a monitor of inputs fails
// because of who drives. Its recovery holds the robot until they let it go on.
bool keeps(const Subject& s, const analysis::Entry& entry, std::size_t i, std::size_t j) {
  if (entry.while_told && atoms_of(s.decision.monitors[j].property).only_speed()) return true;
  if (is_left_to_its_answer(s, entry, i, j)) return true;
  if (entry.keeping != analysis::Keeping::kept) return false;
  const Obligation kept = keeps_others(s, entry, i, j);
  // who has to take over is not kept
  return kept.status == Status::proved &&
         std::none_of(kept.claims.begin(), kept.claims.end(),
                      [](const Claim& c) { return c.what == "outranks"; });
}

// Of recovery i and monitor j; what is kept is known.
LedOn led_on(const Subject& s, const protocol::Arbitration& known, std::size_t i, std::size_t j) {
  const ir::Recovery& leading = s.decision.monitors[i].recovery;
  const ir::Recovery& next = s.decision.monitors[j].recovery;
  const bool own = leading.name == next.name;
  const bool alike = lead_the_same_way(leading, next) && known.keeps[i][j] && known.keeps[j][i];
  return {own, own || alike, known.keeps[i][j]};
}

}  // namespace

protocol::Arbitration known_turns(const Subject& s, const analysis::Arbitration& matrix) {
  protocol::Arbitration known;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    known.keeps.emplace_back();
    for (std::size_t j = 0; j < matrix.size(); ++j) {
      known.keeps.back().push_back(i == j || keeps(s, matrix[i][j], i, j));
    }
  }
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    known.settles.emplace_back();
    const bool leads = leads_back(s, i);
    for (std::size_t j = 0; j < matrix.size(); ++j) {
      known.settles.back().push_back(settles(s, leads, led_on(s, known, i, j), i, j));
    }
  }
  return known;
}

namespace {

// Of each monitor that gives control back before that is where its recovery leads, and where
// another one may not: that it waits for the zones which that one asks for. Of those that have a
// name.
std::vector<Mend> later_returns(const Subject& s, const protocol::Arbitration& known) {
  const auto& monitors = s.decision.monitors;
  const auto is_declared = [&](const std::string& name) {
    return std::ranges::any_of(s.spec.zones, [&](const sema::Zone& z) { return z.name == name; });
  };
  std::vector<Mend> all;
  for (std::size_t i = 0; i < monitors.size(); ++i) {
    if (monitors[i].return_when) continue;
    LaterReturn later{monitors[i].name, {}};
    bool can_be_written = true;
    const bool leads = leads_back(s, i);
    for (std::size_t j = 0; j < monitors.size(); ++j) {
      LedOn waiting = led_on(s, known, i, j);
      waiting.as_before = true;
      if (known.settles[i][j] || !settles(s, leads, waiting, i, j)) continue;
      const ir::Block& says = monitors[j].property;
      std::vector<ir::ZoneIndex> zones;
      (void)places_whatever_told(s, says, says.result, zones);
      for (const ir::ZoneIndex zone : zones) {
        can_be_written =
            can_be_written && is_declared(s.module[zone].name) && !s.module[zone].has_height();
        std::int64_t& mm = later.clearances_mm[s.module[zone].name];
        mm = std::max(mm, returned_mm(s, zone) - s.decision.body.radius_mm);
      }
    }
    if (can_be_written && !later.clearances_mm.empty()) all.emplace_back(std::move(later));
  }
  return all;
}

}  // namespace

protocol::Subject protocol_subject(const ir::Decision& d) {
  protocol::Subject s;
  s.decision = d.name;
  s.robot = d.kind;
  s.advanced = d.advanced;
  s.safe = d.safe;
  s.on_plan = d.on_plan;
  s.period_us = d.period_us;
  s.dwell_ticks = d.dwell_ticks;
  s.promises = has_promises(d);
  if (!d.on_plan) s.surrenders_to = ir::surrender_mode(d);
  for (const ir::Monitor& m : d.monitors) {
    const std::string id = m.requirement_id.empty() ? "" : m.requirement_id + ": ";
    s.monitors.push_back(
        {m.name, m.recovery.name,
         id + m.requirement_text + " (" + m.file + ":" + std::to_string(m.line) + ")",
         m.lookahead.duration && !d.on_plan ? m.lookahead.duration_us / d.period_us : 1,
         m.return_when.has_value()});
  }
  s.coordinated = d.coordinated;
  for (const std::vector<ir::Kept>& row : d.keeps) {
    s.shown.emplace_back();
    for (const ir::Kept kept : row) s.shown.back().push_back(static_cast<int>(kept));
  }
  return s;
}

Obligation switches_well(const Subject& s, const analysis::Arbitration& matrix,
                         const protocol::CheckModel& check) {
  Obligation o;
  o.kind = Kind::switching;
  o.method = "model checker";
  if (!check) {
    o.because =
        "not asked, while the specification has errors: whether recoveries take turns with what is "
        "offered for them is told when it is written";
    return o;
  }
  const protocol::Subject subject = protocol_subject(s.decision);
  protocol::Arbitration known = known_turns(s, matrix);
  protocol::Model model = protocol_model(subject, known, s.spec.name);
  Answers answers = check(model);
  std::string reasons, accepted;
  if (const auto* broken = first(answers, protocol::Answer::Kind::broken)) {
    reasons = accept(s.decision, known);
    if (!reasons.empty() && !broken->drivers.empty()) {
      // which nobody has to have thought of
      accepted = "; that accepts, too, that in a run of the model " + for_ever(broken->drivers);
    }
    if (!reasons.empty()) {
      model = protocol_model(subject, known, s.spec.name);
      answers = check(model);
    }
  }
  if (const auto* broken = first(answers, protocol::Answer::Kind::broken)) {
    Obligation open = unknown(std::move(o), s, *broken);
    if (open.in_turns) {
      open.mends = later_returns(s, known);
      std::ranges::move(other_recoveries(s, matrix, broken->drivers),
                        std::back_inserter(open.mends));
    }
    return open;
  }
  if (const auto* open = first(answers, protocol::Answer::Kind::unknown)) {
    return unknown(std::move(o), s, *open);
  }
  if (WhileTold told = turns_while_told(s, matrix, known); !told.why.empty()) {
    o.because = std::move(told.why);
    // which is tried, and else nothing is said of it
    if (told.lands && s.is_read) {
      o.mends = {*std::move(told.lands)};
    } else {
      o.repair = std::move(told.repair);
    }
    o.in_turns = turns_among(s.decision, told.drive);
    o.unmet = asked_by_inputs(s.decision, told.drive);
    return o;
  }
  o.status = reasons.empty() ? Status::proved : Status::acknowledged;
  o.because = !reasons.empty() ? reasons + accepted
              : s.decision.on_plan
                  ? "in all runs every request is answered once, by a plan that no monitor refuses"
                  : "in all runs one controller drives, an engaged recovery within its look-ahead, "
                    "and recoveries do not take over from each other for ever" +
                        std::string(has_promises(s.decision) ? ", once other robots are far" : "");
  o.model = model.text();
  o.claims.push_back({"protocol",
                      {{"decision", s.decision.name},
                       {"dwell_ticks", std::to_string(s.decision.dwell_ticks)},
                       {"keeps", protocol::text_of(known.keeps)},
                       {"settles", protocol::text_of(known.settles)}}});
  return o;
}

}  // namespace rtac::verify
