#include "compiler/recheck/recheck.h"

#include <algorithm>
#include <set>
#include <utility>

#include "compiler/recheck/acceptable.h"
#include "compiler/recheck/at_place.h"
#include "compiler/recheck/claims.h"
#include "compiler/recheck/coming_in.h"
#include "compiler/recheck/company.h"
#include "compiler/recheck/coordination.h"
#include "compiler/recheck/docking.h"
#include "compiler/recheck/joint.h"
#include "compiler/recheck/lasting.h"
#include "compiler/recheck/lemmas.h"
#include "compiler/recheck/return_when.h"
#include "compiler/recheck/seen.h"
#include "compiler/recheck/sides.h"
#include "compiler/recheck/sums.h"
#include "compiler/recheck/told.h"
#include "compiler/recheck/travel.h"
#include "compiler/recheck/turns.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

constexpr const char* switching = "switching";
constexpr const char* not_asked = "not asked, while something else is not proved";

class Check {
 public:
  Check(const sema::Spec& spec, const SourceManager& sources, const Provers& provers)
      : spec_(spec), provers_(provers), claims_(spec, sources, provers.lemma) {}

  Outcome run(const std::vector<Part>& parts) {
    spoken_of_once(parts);
    for (const sema::Decision& d : spec_.decisions) {
      const auto part = std::find_if(parts.begin(), parts.end(),
                                     [&](const Part& p) { return p.decision == d.name; });
      if (part == parts.end()) {
        fail("nothing is said of decision `" + d.name + "`");
        continue;
      }
      if (part->robot != spec_[d.kind].name) fail("`" + d.name + "` is about another robot");
      complete(d, *part);
      for (const Entry& e : part->entries) {
        if (e.kind != switching) entry(d, e, *part);
      }
    }
    lemmas();
    // Rests on the others, and takes longest.
    for (const sema::Decision& d : spec_.decisions) {
      for (const Part& part : parts) {
        if (part.decision != d.name) continue;
        for (const Entry& e : part.entries) {
          if (e.kind == switching) entry(d, e, part);
        }
      }
    }
    return std::move(out_);
  }

 private:
  void fail(std::string why) { out_.failed.push_back(std::move(why)); }

  // A second part of a decision, or one of none, would stand there as if somebody had looked at it.
  void spoken_of_once(const std::vector<Part>& parts) {
    for (auto part = parts.begin(); part != parts.end(); ++part) {
      const auto same = [&](const auto& other) { return other.decision == part->decision; };
      if (std::any_of(parts.begin(), part, same)) fail("`" + part->decision + "` is told twice");
      if (std::ranges::none_of(spec_.decisions,
                               [&](const sema::Decision& d) { return d.name == part->decision; })) {
        fail("there is no decision `" + part->decision + "`");
      }
    }
  }

  // theory, well-formed RTA modules: what there has to be.
  void complete(const sema::Decision& d, const Part& part) {
    const auto need = [&](const std::string& kind, const std::string& monitor,
                          const std::string& recovery = "") {
      if (find(part, kind, monitor, recovery) != nullptr) return;
      Entry missing{kind, monitor, recovery, "", {}};
      fail(whom(d, missing) + ": it is missing");
    };
    need("P1b", "");
    for (const sema::MonitorId id : d.priority) {
      const std::string& name = spec_[id].name;
      for (const char* kind : {"P2a", "P2b", "P3", "satisfiable"}) need(kind, name);
      if (d.on_plan) continue;
      need("P1a", name);
      if (sema::speaks_of_robot(*spec_[id].always)) need("not vacuous", name);
      for (const sema::MonitorId other : d.priority) {
        if (other != id && spec_[other].recover) need("C", name, spec_[*spec_[other].recover].name);
      }
    }
    need(switching, "");
    if (d.on_plan) return;
    need("joint return", "");
    need("initial", "");
  }

  void entry(const sema::Decision& d, const Entry& e, const Part& part) {
    ++out_.obligations;
    if (e.status == "unknown") return out_.unknown.push_back(whom(d, e));
    if (e.status == "refuted") return out_.refuted.push_back(whom(d, e));
    const bool proved = e.status == "proved", declared = waits(d, e);
    if (!proved && e.status != "acknowledged") {
      return fail(whom(d, e) + ": `" + e.status + "` is no status");
    }
    if (proved && declared) {
      return fail(whom(d, e) + ": what others take of a charge is declared, and not proved");
    }
    // of all turns the model is checked, with what is accepted taken to be kept
    const bool of_turns = e.kind == switching;
    // what is declared is shown as what is proved, whoever accepts it besides
    if (!proved && accepted(d, e) && !of_turns && !(declared && !e.claims.empty())) {
      if (!e.claims.empty()) fail(whom(d, e) + ": what is acknowledged rests on no claim");
      return acceptable(d, e);
    }
    if (!proved && !declared && !(of_turns && accepted(d, e)))
      return fail(whom(d, e) + ": nobody acknowledges it");
    rests_on(d, e, part);
    for (const Claim& claim : e.claims) {
      ++out_.claims;
      if (claim.what == "lemma") {
        lemmas_.emplace_back(whom(d, e), claim);
        continue;
      }
      take(whom(d, e), claim,
           claim.what == "protocol" ? turns(d, part, claim, !proved) : claims_.check(claim));
    }
  }
  // Of its own recovery not everything, and no limit of speed that lets nobody go who rests.
  void acceptable(const sema::Decision& d, const Entry& e) {
    const sema::Monitor* const back = e.kind == "P2b" ? monitor(d, e.monitor) : nullptr;
    if (back != nullptr && !back->hold_reason && too_fast_at_rest(spec_, d, claims_, *back)) {
      return fail(whom(d, e) + ": who rests may be too fast for it to give control back");
    }
    const sema::Monitor* const m = e.kind == "P2a" ? monitor(d, e.monitor) : nullptr;
    if (m == nullptr || d.on_plan) return;
    if (const auto doubt = leads_elsewhere(spec_, d, claims_, *m)) {
      (doubt->refuted ? out_.failed : out_.open).push_back(whom(d, e) + ": " + doubt->why);
    }
  }
  void take(const std::string& of, const Claim& claim, const std::optional<Doubt>& doubt) {
    if (!doubt) return;
    (doubt->refuted ? out_.failed : out_.open)
        .push_back(of + ": " + claim.what + ": " + doubt->why);
  }
  // They do not depend on the specification, and a solver takes its time.
  void lemmas() {
    if (!out_.failed.empty() && !lemmas_.empty()) {
      out_.open.emplace_back("the lemmas: " + std::string(not_asked));
      return;
    }
    for (const auto& [of, claim] : lemmas_) take(of, claim, claims_.check(claim));
  }

  std::optional<Doubt> turns(const sema::Decision& d, const Part& part, const Claim& claim,
                             bool accepting) {
    if (!out_.failed.empty()) return Doubt{false, not_asked};
    return check_turns(spec_, d, part, claim, accepting, claims_, provers_.model);
  }

  // It keeps what its monitor says of charge as long as others keep to what is declared; not where
  // that monitor takes over, or another recovery drives.
  bool waits(const sema::Decision& d, const Entry& e) const {
    if (e.kind != "P2a" && e.kind != "C") return false;
    const bool taken_over = claim_of(e, "outranks") || claim_of(e, "coordinated");
    if (d.on_plan || (e.kind == "C" && taken_over)) return false;
    const sema::Monitor* const m = monitor(d, e.monitor);
    if (m == nullptr || !m->recover) return false;
    if (claim_of(e, "lasts")) return true;
    return std::ranges::any_of(d.priority, [&](sema::MonitorId id) {
      const auto& recover = e.kind == "P2a" ? m->recover : spec_[id].recover;
      if (!recover || (e.kind == "C" && spec_[*recover].name != e.recovery)) return false;
      return waits_for_others(spec_, d, spec_[*recover], *m->always);
    });
  }

  // What the specification accepts in its own words.
  bool accepted(const sema::Decision& d, const Entry& e) const {
    if (e.kind == switching) {
      return !d.acknowledgements.empty() ||
             std::any_of(d.priority.begin(), d.priority.end(),
                         [&](sema::MonitorId id) { return spec_[id].hold_reason.has_value(); });
    }
    for (const sema::MonitorId id : d.priority) {
      const sema::Monitor& m = spec_[id];
      if (m.name != e.monitor) continue;
      const bool unsound = is_unsound(m.ahead);
      if (e.kind == "P1a" || e.kind == "P3") return unsound;
      if (e.kind == "P2a" && unsound) return true;
      if (e.kind == "P2b" && m.hold_reason) return true;
      if (e.kind != "P2a" && e.kind != "P2b" && e.kind != "C") return false;
      std::string recovery = e.recovery;
      if (recovery.empty() && m.recover) recovery = spec_[*m.recover].name;
      return std::any_of(d.acknowledgements.begin(), d.acknowledgements.end(), [&](const auto& a) {
        return spec_[a.recovery].name == recovery && spec_[a.monitor].name == m.name;
      });
    }
    return false;
  }

  void need(const sema::Decision& d, const Entry& e, const std::string& what, Values values = {},
            bool named = true) {
    if (named) values["decision"] = d.name;
    if (!has(e, what, values)) fail(whom(d, e) + ": it rests on no claim `" + what + "`");
  }

  // A proof that leaves out a part proves nothing.
  void rests_on(const sema::Decision& d, const Entry& e, const Part& part) {
    const Values of_monitor{{"monitor", e.monitor}};
    if (e.kind == "P1b") return need(d, e, "output");
    if (e.kind == "initial") return need(d, e, "start");
    if (e.kind == switching) return need(d, e, "protocol");
    if (d.on_plan && e.kind != "satisfiable") return need(d, e, "judged");
    if (e.kind == "P1a") return need(d, e, "horizon", of_monitor);
    if (e.kind == "joint return") {
      for (const std::string& why : doubts_of_return(spec_, d, e, claims_))
        fail(whom(d, e) + ": " + why);
      return;
    }
    const sema::Monitor* const m = monitor(d, e.monitor);
    if (m == nullptr) return fail(whom(d, e) + ": there is no such monitor");
    if (e.kind == "not vacuous") {
      told(d, e, *m, "false");
      return need(d, e, "fails", of_monitor);
    }
    if (e.kind == "P2a") return keeps(d, e, *m);
    if (e.kind == "P2b") return returns(d, e, *m);
    if (e.kind == "P3") {
      need(d, e, "limits");
      need(d, e, "return", of_monitor);
      look_ahead(d, e, *m);
      return need(d, e, "lemma", {{"name", "return_implies_ahead"}}, false);
    }
    if (e.kind == "C") return keeps_other(d, e, *m, part);
    if (e.kind == "satisfiable") return satisfiable(d, e, *m);
    fail(whom(d, e) + ": there is no such obligation");
  }
  // A place in each zone that it asks for; of none, that the robot is as it is declared.
  void satisfiable(const sema::Decision& d, const Entry& e, const sema::Monitor& m) {
    const auto zones = asked_in(spec_, *m.always);
    for (const sema::ZoneId zone : zones) {
      need(d, e, "seen", {{"monitor", m.name}, {"zone", claims_.zones().name(zone)}});
    }
    if (zones.empty() && !has(e, "seen", {{"decision", d.name}, {"monitor", m.name}})) {
      need(d, e, "limits");
    }
    told(d, e, m, "true");
    as_a_whole(d, e, m);
    if (d.on_plan) return;
    one_place(d, e, m);
    if (const std::string limit = limit_unseen(spec_, d, *m.always); !limit.empty()) {
      fail(whom(d, e) + ": " + limit);
    }
    seen_beside_zones(d, e, m);
  }
  // How clear a place is of a zone, or how far from it, at most.
  [[nodiscard]] bool asks_for_at_most(const sema::Expr& e) const {
    const auto* const compare = std::get_if<sema::Compare>(&e.node);
    if (compare == nullptr) return false;
    if (const auto limit = limit_of_one(spec_, e)) return !limit->at_least;
    using Op = sema::CompareOp;
    const bool above = compare->op == Op::greater || compare->op == Op::greater_equal;
    return all_zones(above ? *compare->left : *compare->right).empty();
  }
  // It is true at a place that is claimed, or at one where no zone is asked for, with inputs as
  // they are said to be: in those zones, and in no other one.
  void as_a_whole(const sema::Decision& d, const Entry& e, const sema::Monitor& m) {
    std::map<std::string, std::set<std::string>> zones_at;
    for (const Claim& c : e.claims) {
      if (c.what != "seen" || text(c.values, "decision") != d.name) continue;
      zones_at[text(c.values, "x_mm") + " " + text(c.values, "y_mm")].insert(
          text(c.values, "zone"));
    }
    if (zones_at.empty()) zones_at[""] = {};
    const Claim* const told = claim_with(e, "told", {{"decision", d.name}, {"monitor", m.name}});
    const auto inputs = told_inputs(spec_, told != nullptr ? text(told->values, "inputs") : "");
    if (!inputs) return;  // the claim is wrong
    const bool is_so = std::ranges::any_of(zones_at, [&](const auto& at) {
      return told_makes_true_but(
          spec_, *m.always, *inputs, [&](const sema::Expr& leaf, bool value) {
            auto zones = all_zones(leaf);
            if (const auto* plan = std::get_if<sema::PlanInside>(&leaf.node)) {
              zones.push_back(plan->zone);
            }
            const bool lies = std::ranges::any_of(zones, [&](sema::ZoneId zone) {
              return at.second.contains(claims_.zones().name(zone));
            });
            // how far it is at most says nothing where the place is not known to lie
            if (!zones.empty() && asks_for_at_most(leaf)) return !(lies && value);
            if (!zones.empty()) return lies == value;
            return !value && is_told(spec_, *m.always) && judges_robots(spec_, d, leaf);
          });
    });
    if (!is_so) fail(whom(d, e) + ": it need not be true at any place that is claimed");
  }
  // Charge and heights at the place that is claimed, or anywhere where none is; and whether others
  // can be as far away as is asked.
  void seen_beside_zones(const sema::Decision& d, const Entry& e, const sema::Monitor& m) {
    std::vector<Spot> spots;
    for (const Claim& c : e.claims) {
      if (c.what != "seen" || text(c.values, "decision") != d.name) continue;
      if (spots.empty()) spots.push_back(spot_of(c));
      spots[0].zones.insert(text(c.values, "zone"));
    }
    AtPlace there(spec_, d, claims_);
    if (spots.empty()) spots = there.sites();
    if (std::ranges::none_of(spots, [&](const Spot& spot) { return there.is_seen(m, spot); })) {
      fail(whom(d, e) + ": its charge, or a height, need not be seen at that place");
    }
    if (asks_out_of_sight(spec_, d, *m.always)) {
      fail(whom(d, e) + ": no agent is known to be so far away");
    }
    const auto asked = distance_asked(spec_, d, *m.always);
    const double radius = spec_[d.kind].radius.value.get_d();
    for (const sema::ZoneId zone : kept_in(spec_, *m.always)) {
      const geometry::Region* const region = claims_.zones().region(zone);
      if (!asked || region == nullptr) continue;
      if (asked->get_d() + 2 * radius <= widest_apart(*region, radius)) continue;
      fail(whom(d, e) + ": no two robots are so far apart in `" + claims_.zones().name(zone) + "`");
    }
  }
  void told(const sema::Decision& d, const Entry& e, const sema::Monitor& m, const char* value) {
    if (!told_in(spec_, *m.always).empty()) {
      return need(d, e, "told", {{"monitor", m.name}, {"value", value}});
    }
    const bool holds = value == std::string("true");
    const auto rest = holds ? shown_at_rest(spec_, d) : std::nullopt;
    if (told_makes(spec_, *m.always, {}, holds, rest)) return;
    fail(whom(d, e) + ": nothing that its robot may sense makes it so");
  }
  // All zones are seen at one place, and of each `or` one side.
  void one_place(const sema::Decision& d, const Entry& e, const sema::Monitor& m) {
    std::set<std::string> places, heights, zones;
    for (const Claim& c : e.claims) {
      if (c.what != "seen" || text(c.values, "decision") != d.name) continue;
      places.insert(text(c.values, "x_mm") + " " + text(c.values, "y_mm"));
      if (c.values.count("z_mm") != 0) heights.insert(text(c.values, "z_mm"));
      zones.insert(text(c.values, "zone"));
    }
    if (places.size() > 1 || heights.size() > 1) {
      fail(whom(d, e) + ": it is not one place that is seen to be in all of its zones");
    }
    if (!is_on_each_side(claims_.zones(), *m.always, zones)) {
      fail(whom(d, e) + ": nothing is said of any side of an `or`");
    }
  }
  const sema::Monitor* monitor(const sema::Decision& d, const std::string& name) const {
    return monitor_of(spec_, d, name);
  }

  // Each zone that a recovery moves within lies in each zone that the property keeps the robot in,
  // or it keeps a side of it; and as far from their boundaries as the property asks, unless that
  // of the monitor that it drives for has the robot as far from the boundary of its own zone. Of
  // zones that come and go it leads out, as its own monitor asks.
  void within(const sema::Decision& d, const Entry& e, const sema::Monitor& driving,
              const sema::Monitor& m) {
    const sema::Controller& recovery = spec_[*driving.recover];
    follows(d, e, recovery);
    if (sema::speaks_of_charge(*m.always)) charged(d, e, recovery);
    std::vector<sema::ZoneId> moves = moves_within(recovery);
    std::erase_if(moves, [&](sema::ZoneId zone) { return stays_put(d, e, driving, m, zone); });
    const Keeping asked = Sides(spec_, d, claims_).keeping(recovery, *m.always);
    if (asked.windows) {
      need(d, e, "leaves", {{"monitor", m.name}});
      if (driving.recover != m.recover) {
        fail(whom(d, e) + ": `" + recovery.name + "` is not what leads out for `" + m.name + "`");
      }
    }
    for (const sema::ZoneId inner : moves) {
      if (asked.faster && !sema::claim_of(recovery) &&
          !starts_within(spec_, d, claims_, m, inner)) {
        fail(whom(d, e) + ": from outside of `" + claims_.zones().name(inner) + "` `" +
             recovery.name + "` may set out faster than `" + m.name + "` allows");
      }
      if (asked.by_sides) {
        need(d, e, "sides",
             {{"controller", recovery.name},
              {"monitor", m.name},
              {"zone", claims_.zones().name(inner)}});
      }
      for (const sema::ZoneId outer : asked.zones) {
        if (stays_by_border(d, e, driving, m, inner, outer)) continue;
        lies_in(d, e, driving, m, inner, outer);
        if (inner == outer || sema::claim_of(recovery)) continue;
        const NamedZones& zones = claims_.zones();
        need(d, e, "comes_in",
             {{"monitor", m.name}, {"zone", zones.name(inner)}, {"fence", zones.name(outer)}});
      }
    }
    lands_in(d, e, recovery, m, asked.zones);
    for (const std::vector<sema::ZoneId>& sides : asked.either) lands_in(d, e, recovery, m, sides);
    // of an `or` with a limit of speed, who is slow has no height to keep
    if (Sides(spec_, d, claims_).holds_of_slow(recovery, *m.always)) return;
    if (keeps_its_heights(spec_, d, claims_, recovery, *m.always)) return;
    fail(whom(d, e) + ": `" + recovery.name + "` may go beyond a height that `" + m.name +
         "` allows");
  }
  void lands_in(const sema::Decision& d, const Entry& e, const sema::Controller& recovery,
                const sema::Monitor& m, const std::vector<sema::ZoneId>& zones) {
    for (const sema::ZoneId zone : zones) {
      if (comes_down_within(spec_, d, claims_, recovery, *m.always, zone)) continue;
      fail(whom(d, e) + ": the way down of `" + recovery.name + "` need not lie in `" +
           claims_.zones().name(zone) + "`");
    }
  }
  // Whether all that recovers within a zone is a retreat, and some zone that the property holds the
  // robot in is claimed to lie as deep in that as a retreat leads: it holds its place there.
  bool stays_put(const sema::Decision& d, const Entry& e, const sema::Monitor& driving,
                 const sema::Monitor& m, sema::ZoneId zone) {
    const sema::RobotKind& kind = spec_[d.kind];
    const sema::Controller& recovery = spec_[*driving.recover];
    if (&driving == &m || kind.in_space || sema::claim_of(recovery)) return false;
    for (const sema::MonitorId id : d.priority) {
      if (spec_[id].recover == driving.recover && spec_[id].return_when) return false;
    }
    for (const sema::Template& what : sema::templates_of(recovery)) {
      const auto moves = sema::moves_of(what);
      if (moves && moves->zone == zone && !std::holds_alternative<sema::Retreat>(what))
        return false;
    }
    const Rational leads = claims_.return_clearance(d, zone, return_extra(spec_, d)) +
                           (kind.position ? kind.position->error.value : Rational(0));
    const std::string outer = claims_.zones().name(zone);
    return std::ranges::any_of(kept_in(spec_, *m.always), [&](sema::ZoneId held) {
      return std::ranges::any_of(e.claims, [&](const Claim& c) {
        return c.what == "contained" && text(c.values, "inner") == claims_.zones().name(held) &&
               text(c.values, "outer") == outer &&
               Rational(static_cast<long>(number(c.values, "standoff_mm").value_or(0))) >=
                   leads * 1000;
      });
    });
  }
  // A retreat need not lie all over in what it drives through only beside the border of its zone.
  bool stays_by_border(const sema::Decision& d, const Entry& e, const sema::Monitor& driving,
                       const sema::Monitor& m, sema::ZoneId inner, sema::ZoneId outer) {
    const NamedZones& zones = claims_.zones();
    const Rational gap = gap_of(spec_, *m.always, outer);
    return std::ranges::any_of(e.claims, [&](const Claim& c) {
      return c.what == "by_border" && text(c.values, "decision") == d.name &&
             text(c.values, "monitor") == driving.name && text(c.values, "judged") == m.name &&
             text(c.values, "zone") == zones.name(inner) &&
             text(c.values, "outer") == zones.name(outer) && covers(c, gap);
    });
  }
  // Or it keeps as far off, and its own property has the robot there where it sets out.
  bool goes_around(const sema::Decision& d, const Entry& e, const sema::Monitor& driving,
                   const sema::Monitor& m, sema::ZoneId inner, sema::ZoneId outer) {
    if (&driving != &m && !relied_on(spec_, d, driving)) return false;
    const NamedZones& zones = claims_.zones();
    const Rational gap = gap_of(spec_, *m.always, outer);
    return std::ranges::any_of(e.claims, [&](const Claim& c) {
      return c.what == "around" && text(c.values, "decision") == d.name &&
             text(c.values, "monitor") == driving.name &&
             text(c.values, "zone") == zones.name(inner) &&
             text(c.values, "outer") == zones.name(outer) && covers(c, gap);
    });
  }
  // A step of the grid is no more than touching.
  static bool covers(const Claim& c, const Rational& gap) {
    const Rational off(static_cast<long>(number(c.values, "standoff_mm").value_or(0)), 1000);
    return gap <= Rational(1, 1000) || off >= gap;
  }
  void lies_in(const sema::Decision& d, const Entry& e, const sema::Monitor& driving,
               const sema::Monitor& m, sema::ZoneId inner, sema::ZoneId outer) {
    const sema::Controller& recovery = spec_[*driving.recover];
    const Claim lies = lies_in_claim(claims_, recovery, inner, outer);
    need(d, e, lies.what, lies.values, false);
    const Rational gap = standoff_needed(spec_, d, driving, m, inner, outer);
    if (gap == 0) return;
    // the same boundary, under another name
    const Values back{{"inner", lies.values.at("outer")}, {"outer", lies.values.at("inner")}};
    if (!sema::claim_of(recovery) && has(e, "contained", back)) return;
    const bool far = std::ranges::any_of(e.claims, [&](const Claim& c) {
      return c.what == lies.what && text(c.values, "inner") == lies.values.at("inner") &&
             text(c.values, "outer") == lies.values.at("outer") &&
             Rational(static_cast<long>(number(c.values, "standoff_mm").value_or(0))) >= gap * 1000;
    });
    if (far || goes_around(d, e, driving, m, inner, outer)) return;
    fail(whom(d, e) + ": nothing says that `" + recovery.name + "` keeps so far from `" +
         lies.values.at("outer") + "`");
  }
  // Who goes to be charged has to rest within 15 cm of its dock (language rule 6.7): a way ends no
  // nearer than 2 cm or the position error, and there a robot is held off as far as it sways.
  void charged(const sema::Decision& d, const Entry& e, const sema::Controller& recovery) {
    if (!ends_charged(spec_, d, recovery)) return;
    const Numbers n = numbers_of(spec_, d, jitter_of(spec_, d));
    const Rational off = n.sway + std::max(Rational(n.position_error), Rational(2, 100));
    if (off > Rational(15, 100)) {
      fail(whom(d, e) + ": it may come to rest too far from its dock to be charged");
    }
  }
  void follows(const sema::Decision& d, const Entry& e, const sema::Controller& recovery) {
    if (follows_its_hold(spec_[d.kind], d, recovery)) return;
    fail(whom(d, e) + ": its brake is too weak to follow the hold of `" + recovery.name + "`");
  }
  void as_slow(const sema::Decision& d, const Entry& e, const sema::Controller& recovery,
               const sema::Monitor& m, bool taken_over) {
    if (Sides(spec_, d, claims_).keeps_limits(recovery, *m.always, taken_over)) return;
    fail(whom(d, e) + ": `" + recovery.name + "` drives faster than `" + m.name + "` allows");
  }
  // An agent that comes near a robot that its recovery has stopped finds it slow enough.
  bool stands_and_holds(const sema::Decision& d, const sema::Monitor& m) {
    return m.recover && !judges_robots(spec_, d, *m.always) &&
           std::holds_alternative<sema::BrakeAndHold>(spec_[*m.recover].implementation) &&
           Sides(spec_, d, claims_).holds_held(*m.always);
  }
  // The separation gate stops whatever moves before agents are nearer than is asked.
  bool slow_beside_agents(const sema::Decision& d, const sema::Controller& drives,
                          const sema::Monitor& m) {
    return !sema::templates_of(drives).empty() && !is_unsound(m.ahead) &&
           robots_keep(d, *m.always) && Sides(spec_, d, claims_).slow_beside_agents(*m.always);
  }
  // What speaks of no agent, together with all others.
  bool robots_keep(const sema::Decision& d, const sema::Expr& e) {
    const auto* const logic = std::get_if<sema::Logic>(&e.node);
    if (logic != nullptr && logic->op == sema::LogicOp::logical_and) {
      return std::ranges::all_of(logic->operands,
                                 [&](const auto& each) { return robots_keep(d, *each); });
    }
    return sema::speaks_of<sema::AgentDistance>(e) ? !judges_robots(spec_, d, e)
                                                   : kept_together(spec_, d, e);
  }
  void keeps(const sema::Decision& d, const Entry& e, const sema::Monitor& m) {
    if (is_unsound(m.ahead)) {
      fail(whom(d, e) + ": its look-ahead is declared unsound");
    }
    need(d, e, "limits");
    need(d, e, "recovery", {{"monitor", m.name}});
    if (m.recover) {
      within(d, e, m, m);
      as_slow(d, e, spec_[*m.recover], m, false);
      if (sema::speaks_of_charge(*m.always) &&
          !goes_to_be_charged(spec_, d, spec_[*m.recover], *m.always)) {
        fail(whom(d, e) + ": nobody accounts for the charge that `" + spec_[*m.recover].name +
             "` spends");
      }
      if (docks_for_longer(spec_, d, m)) {
        fail(whom(d, e) + ": until others are charged before it takes longer than `held`");
      }
    }
    const bool brakes =
        m.recover && std::holds_alternative<sema::BrakeAndHold>(spec_[*m.recover].implementation);
    const bool slow = m.recover && slow_beside_agents(d, spec_[*m.recover], m);
    if (!stands_and_holds(d, m) && !slow && !kept_together(spec_, d, *m.always)) {
      fail(whom(d, e) + ": others may break it, whatever the recovery does");
    }
    if (!brakes) {
      need(d, e, "lemma", {{"name", "way_pieces"}}, false);
    }
    look_ahead(d, e, m);
  }
  // What the test of its property rests on.
  void look_ahead(const sema::Decision& d, const Entry& e, const sema::Monitor& m) {
    for (const std::string& lemma : lemmas_for(spec_, d, m)) {
      need(d, e, "lemma", {{"name", lemma}}, false);
    }
  }
  // How clear of its zone a recovery leads to, as it claims; 0: it leads nowhere.
  static Rational left_by(const sema::Decision& d, const Entry& e, const sema::Monitor& m) {
    const std::pair<const char*, const char*> kinds[] = {{"ways", "return_mm"},
                                                         {"legs", "clearance_mm"}};
    for (const auto& [what, key] : kinds) {
      const Claim* const claim = claim_with(e, what, {{"decision", d.name}, {"monitor", m.name}});
      const auto mm = claim != nullptr ? number(claim->values, key) : std::nullopt;
      if (mm) return Rational(static_cast<long>(*mm)) / 1000;
    }
    return 0;
  }
  // Its last step ends at a place, by a way over cells or legs; to others it only makes room.
  static bool leads_somewhere(const sema::Controller& recovery) {
    const auto steps = sema::templates_of(recovery);
    return !steps.empty() && sema::moves_of(steps.back()) &&
           !std::holds_alternative<sema::Yield>(steps.back());
  }
  void returns(const sema::Decision& d, const Entry& e, const sema::Monitor& m) {
    const Claim* const told = claim_with(e, "at_once", {{"decision", d.name}, {"monitor", m.name}});
    for (const std::string& why : torn_returns(spec_, d, claims_, m.name, told)) {
      fail(whom(d, e) + ": " + why);
    }
    if (asks_at_once(spec_, d, m.name)) {
      need(d, e, "at_once", {{"monitor", m.name}});
    }
    if (m.recover && sema::asks_for_charge(m)) charged(d, e, spec_[*m.recover]);
    if (e.claims.empty()) return fail(whom(d, e) + ": it rests on no claim");
    if (m.recover && !makes_way(spec_[d.kind], d, spec_[*m.recover])) {
      return fail(whom(d, e) + ": `" + spec_[*m.recover].name + "` is too slow to make way");
    }
    if (m.recover) follows(d, e, spec_[*m.recover]);
    if (m.recover && sema::claim_of(spec_[*m.recover]) && sema::speaks_of_robot(*m.always)) {
      return fail(whom(d, e) + ": of where `" + spec_[*m.recover].name +
                  "` leads nothing is known");
    }
    if (has(e, "landing", {{"decision", d.name}, {"monitor", m.name}})) {
      if (lets_go(spec_, d, claims_, m, 0)) return;
      return fail(whom(d, e) + ": its `return when` may not hold where it has landed");
    }
    if (has(e, "parting", {{"decision", d.name}, {"monitor", m.name}})) {
      need(d, e, "lemma", {{"name", "return_reached"}}, false);
      if (lets_go(spec_, d, claims_, m, 0)) return;
      return fail(whom(d, e) + ": its `return when` may not hold where the robots have parted");
    }
    const bool moves =
        m.recover && leads_somewhere(spec_[*m.recover]) && sema::speaks_of_robot(*m.always);
    const bool legs = has(e, "legs", {{"decision", d.name}, {"monitor", m.name}});
    if (!legs && moves) need(d, e, "ways", {{"monitor", m.name}});
    if (has(e, "ways")) need(d, e, "lemma", {{"name", "return_reached"}}, false);
    if (!lets_go(spec_, d, claims_, m, left_by(d, e, m))) {
      fail(whom(d, e) + ": its `return when` may not hold where the recovery has led to");
    }
    if (Sides(spec_, d, claims_).gives_back(m, return_extra(spec_, d))) return;
    fail(whom(d, e) + ": where the recovery has led to, nothing gives control back");
  }
  static bool guards(const Entry& e, const sema::Decision& d, const sema::Monitor& judged,
                     const sema::Monitor& driving) {
    return has(e, "outranks",
               {{"decision", d.name}, {"higher", judged.name}, {"lower", driving.name}});
  }
  static bool coordinates(const Entry& e, const sema::Decision& d, const sema::Monitor& judged,
                          const sema::Monitor& driving) {
    return has(e, "coordinated",
               {{"decision", d.name}, {"driving", driving.name}, {"judged", judged.name}});
  }
  void keeps_other(const sema::Decision& d, const Entry& e, const sema::Monitor& m,
                   const Part& part) {
    const bool some = std::ranges::any_of(
        d.priority, [&](sema::MonitorId id) { return speaks_of(e, spec_[id]); });
    if (!some) return fail(whom(d, e) + ": it is about no monitor that the recovery drives for");
    for (const sema::MonitorId id : d.priority) {
      const sema::Monitor& driving = spec_[id];
      if (!driving.recover || spec_[*driving.recover].name != e.recovery) continue;
      if (&driving == &m) continue;
      const auto drives = [&] {
        need(d, e, "recovery", {{"monitor", driving.name}, {"controller", e.recovery}});
      };
      if (guards(e, d, m, driving)) {
        drives();
        continue;
      }
      if (coordinates(e, d, m, driving)) {
        drives();
        if (in_circle(spec_, d, part, m)) {
          fail(whom(d, e) + ": recoveries that do not keep each other lead round in a circle");
        }
        continue;
      }
      // the recovery of several monitors may have an entry for each of them
      const bool elsewhere =
          std::any_of(part.entries.begin(), part.entries.end(), [&](const Entry& other) {
            if (&other == &e || other.kind != "C" || other.monitor != e.monitor ||
                other.recovery != e.recovery) {
              return false;
            }
            return !is_shown(other) || speaks_of(other, driving);
          });
      if (elsewhere && !speaks_of(e, driving)) continue;
      drives();
      if (d.coordinated && driving.recover != m.recover && answers_to_inputs(*m.always)) {
        fail(whom(d, e) + ": only its own recovery answers to what it says of inputs");
      }
      if (!d.coordinated && !takes_over(d, m, driving) && silences(driving, m)) {
        fail(whom(d, e) + ": it drives on while inputs ask for a stop");
      }
      const bool alike = driving.recover == m.recover && stands_and_holds(d, m);
      const bool slow = slow_beside_agents(d, spec_[*driving.recover], m);
      const bool answers = takes_over(d, m, driving) && !is_unsound(m.ahead);
      if (!alike && !slow && !kept_together(spec_, d, *m.always) && !answers) {
        fail(whom(d, e) + ": others may break it, and nobody takes over");
      }
      within(d, e, driving, m);
      as_slow(d, e, spec_[*driving.recover], m, takes_over(d, m, driving));
      if (driving.recover != m.recover && spends_charge(spec_, d, claims_, driving, *m.always)) {
        need(d, e, "lasts", {{"monitor", driving.name}});
        if (const auto why = takes_too_much(spec_, d, part, m, e.recovery))
          fail(whom(d, e) + ": " + *why);
      }
    }
  }
  // `judged` stands still for what inputs say alone, and `driving` moves.
  [[nodiscard]] bool silences(const sema::Monitor& driving, const sema::Monitor& judged) const {
    const auto stands = [&](const sema::Monitor& m) {
      const auto steps = sema::templates_of(spec_[*m.recover]);
      return !steps.empty() && std::ranges::all_of(steps, [](const sema::Template& step) {
        return std::holds_alternative<sema::BrakeAndHold>(step);
      });
    };
    return judged.recover && stands(judged) && !stands(driving) && asks_by_inputs(*judged.always);
  }
  // `judged` ranks higher, and has another recovery, which drives as soon as its look-ahead fails.
  [[nodiscard]] bool takes_over(const sema::Decision& d, const sema::Monitor& judged,
                                const sema::Monitor& driving) const {
    if (d.coordinated || judged.recover == driving.recover) return false;
    const auto first = std::ranges::find_if(d.priority, [&](sema::MonitorId id) {
      return &spec_[id] == &judged || &spec_[id] == &driving;
    });
    return first != d.priority.end() && &spec_[*first] == &judged;
  }

  const sema::Spec& spec_;
  const Provers& provers_;
  Claims claims_;
  std::vector<std::pair<std::string, Claim>> lemmas_;  // with whom they are for
  Outcome out_;
};

}  // namespace

Outcome recheck(const sema::Spec& spec, const SourceManager& sources, const std::string& report,
                const Provers& provers) {
  const auto said = read_report(report);
  if (!said || said->spec != spec.name) {
    Outcome out;
    out.failed.emplace_back(said ? "verification.json is about `" + said->spec + "`"
                                 : "verification.json is no report of `rtac verify`");
    return out;
  }
  return Check(spec, sources, provers).run(said->parts);
}

}  // namespace rtac::recheck
