// Whether properties can be seen to hold, and can be false.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "compiler/analysis/across.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/return_condition.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/vacuous.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"
#include "compiler/verify/about_recovery.h"
#include "compiler/verify/at_place.h"
#include "compiler/verify/atoms.h"
#include "compiler/verify/common_place.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {
namespace {

// What is widest farther off is mostly a complement: a place that is nearer tells more.
constexpr std::int64_t zones_within_mm = 100'000'000;

bool is_far(const ir::ZoneTable& zone) {
  return std::max(std::abs(std::int64_t{zone.widest_x_mm}),
                  std::abs(std::int64_t{zone.widest_y_mm})) > zones_within_mm;
}

// The widest place of a zone; of a complement rather one beside the zones of the decision, where
// somebody looks, if one of them is as clear.
geometry::Point shown_place(const Subject& s, const Need& need) {
  const ir::ZoneTable& table = s.module[need.zone];
  if (is_far(table) && !s.decision.body.in_space) {
    for (const Need& other : needs_of(s)) {
      if (other.zone == need.zone || is_far(s.module[other.zone])) continue;
      const auto at = common_place(s, {need, {other.zone, s.decision.body.radius_mm}});
      if (at) return *at;
    }
  }
  return {analysis::metres_of(table.widest_x_mm), analysis::metres_of(table.widest_y_mm)};
}

// The zones that a monitor holds the robot, or the legs of its plans, against.
std::vector<ir::ZoneIndex> places_of(const Subject& s, const ir::Monitor& m) {
  std::vector<ir::ZoneIndex> zones = analysis::fences_of(m.property, s.decision.facts.params);
  for (const ir::Value& v : m.property.values) {
    if (const auto* plan = std::get_if<ir::PlanInZone>(&v.op)) zones.push_back(plan->zone);
  }
  return zones;
}

struct Witness {
  std::int64_t x_mm = 0, y_mm = 0, z_mm = 0;
};

// How clear of each zone that it names a robot at rest has to be to be seen to have what the
// property asks for.
std::vector<Need> seen_needs(const Subject& s, const ir::Monitor& m) {
  std::vector<Need> needs;
  for (const ir::ZoneIndex zone : places_of(s, m)) {
    const std::int64_t own_mm =
        analysis::fence_standoff_mm(m.property, s.decision.facts.params, zone);
    const std::int64_t need_mm =
        s.decision.on_plan
            ? 0
            : analysis::shown_clearance_mm(s.decision, s.decision.motions.front(), own_mm);
    needs.push_back({zone, need_mm});
  }
  return needs;
}
// The zones that a plan has to be in whichever way a property holds.
void sure_of_plan(const ir::Block& block, ir::ValueId id, std::vector<ir::ZoneIndex>& sure) {
  if (const auto* both = std::get_if<ir::And>(&block[id].op)) {
    sure_of_plan(block, both->a, sure);
    sure_of_plan(block, both->b, sure);
  } else if (const auto* plan = std::get_if<ir::PlanInZone>(&block[id].op)) {
    sure.push_back(plan->zone);
  }
}
// The zones of each way in which zones alone have a plan be as a property says; none: there is no
// such way, or there are too many.
using Ways = std::vector<std::set<ir::ZoneIndex>>;
Ways ways_of_plan(const ir::Block& block, ir::ValueId id, bool of_choice) {
  constexpr std::size_t ways_most = 64;
  const ir::Op& op = block[id].op;
  if (const auto* plan = std::get_if<ir::PlanInZone>(&op)) return {{plan->zone}};
  if (const auto* either = std::get_if<ir::Or>(&op)) {
    Ways all = ways_of_plan(block, either->a, true);
    const Ways more = ways_of_plan(block, either->b, true);
    all.insert(all.end(), more.begin(), more.end());
    return all.size() > ways_most ? Ways() : all;
  }
  if (const auto* both = std::get_if<ir::And>(&op)) {
    Ways all;
    const Ways ways = ways_of_plan(block, both->b, of_choice);
    for (const auto& one : ways_of_plan(block, both->a, of_choice)) {
      for (const auto& other : ways) {
        all.push_back(one);
        all.back().insert(other.begin(), other.end());
      }
    }
    return all.size() > ways_most ? Ways() : all;
  }
  // what is told is so, but for a side that need not be
  return of_choice ? Ways() : Ways{{}};
}
// Of these, the zones that the robot, or its plan, has to be in at once.
std::vector<Need> held_together(const Subject& s, const ir::Monitor& m,
                                const std::vector<Need>& needs) {
  std::vector<ir::ZoneIndex> sure;
  if (s.decision.on_plan) {
    sure_of_plan(m.property, m.property.result, sure);
  } else {
    sure = analysis::fences_of(m.property, s.decision.facts.params);
  }
  std::vector<Need> together;
  std::ranges::copy_if(needs, std::back_inserter(together), [&](const Need& need) {
    return std::ranges::find(sure, need.zone) != sure.end();
  });
  // on the boundary of both a plan is in neither
  for (Need& need : together) need.clearance_mm = std::max<std::int64_t>(need.clearance_mm, 1);
  return together;
}
constexpr const char* no_choice =
    "some `or` is no choice of one of several zones, and no place is found for it";
// The inputs that make each choice between them and what is sensed by themselves; none: nobody has
// found any.
std::optional<analysis::Told> told_alone(const Subject& s, std::size_t k) {
  const sema::Expr& always = *s.monitor(k).always;
  const auto parts = analysis::torn_parts(s.spec, always, [](const sema::Expr&) { return false; });
  if (parts.empty()) return std::nullopt;
  const analysis::ToHold asked{&always, seen_at_rest(s, s.decision.motions.front())};
  const analysis::Told told = analysis::told_at_once(s.spec, {asked}, parts);
  return told.can == analysis::CanBeTold::yes ? std::optional(told) : std::nullopt;
}
// Whether no place settles which side of an `or` holds, but where that is told.
bool is_no_choice(const Subject& s, std::size_t k, bool is_told) {
  if (s.decision.on_plan) return false;
  const std::int64_t rest_mmps = analysis::shown_speed_mmps(s.decision, s.decision.motions.front());
  return !settles_places(s, s.decision.monitors[k], rest_mmps, is_told);
}
// Of an `or` one side will do.
std::vector<Sides> sides_seen(const Subject& s, const ir::Monitor& m) {
  if (s.decision.on_plan) return {{}};
  return ways_to_choose(s, {&m}, [&](const ir::Monitor&, std::int64_t own_mm) {
    return analysis::shown_clearance_mm(s.decision, s.decision.motions.front(), own_mm);
  });
}
void add_need(std::vector<Need>& all, const Need& need) {
  const bool known =
      std::ranges::any_of(all, [&](const Need& each) { return each.zone == need.zone; });
  if (!known) all.push_back(need);
}
Witness alone(const Subject& s, const Need& need) {
  const geometry::Point at = shown_place(s, need);
  return {in_mm(at.x), in_mm(at.y), s.module[need.zone].widest_z_mm};
}
bool is_clear_of(const Subject& s, const std::vector<Need>& needs, const Witness& at) {
  const analysis::ExactSolid solid = any_solid(s);
  return std::ranges::all_of(needs, [&](const Need& need) {
    const Rational by = analysis::metres_of(need.clearance_mm);
    const Rational upright = s.module[need.zone].has_height() ? by : Rational(0);
    return solid(need.zone)
        .shrink(by, upright)
        .contains({analysis::metres_of(at.x_mm), analysis::metres_of(at.y_mm)},
                  analysis::metres_of(at.z_mm));
  });
}
// In space, the widest place of one of the zones that is clear enough of the others as well.
std::optional<Witness> common_witness(const Subject& s, const std::vector<Need>& needs) {
  const bool flat = std::ranges::none_of(
      needs, [&](const Need& need) { return s.module[need.zone].has_height(); });
  if (flat) {
    const auto at = common_place(s, needs);
    return at ? std::optional(Witness{in_mm(at->x), in_mm(at->y), 0}) : std::nullopt;
  }
  for (const Need& widest : needs) {
    const ir::ZoneTable& table = s.module[widest.zone];
    if (!table.has_height()) continue;
    const Witness at{table.widest_x_mm, table.widest_y_mm, table.widest_z_mm};
    if (is_clear_of(s, needs, at)) return at;
  }
  return std::nullopt;
}
bool share_nothing(const Subject& s, const std::vector<Need>& needs) {
  const analysis::ExactSolid solid = any_solid(s);
  geometry::Solid common = geometry::Solid::everywhere();
  for (const Need& need : needs) {
    const Rational by =
        analysis::metres_of(std::max<std::int64_t>(need.clearance_mm - rounded_mm, 0));
    const geometry::Solid whole = solid(need.zone);
    common = common.intersect(s.module[need.zone].has_height() ? whole.shrink_by_ball(by)
                                                               : whole.shrink(by, 0));
  }
  return common.empty();
}
// What one of its zones has nowhere.
std::optional<Obligation> too_narrow_to_see(const Subject& s, const std::vector<Need>& needs,
                                            const Obligation& o) {
  for (const Need& need : needs) {
    const ir::ZoneTable& table = s.module[need.zone];
    if (table.widest_mm >= need.clearance_mm) continue;
    const bool never = table.widest_mm + rounded_mm < need.clearance_mm;
    return not_seen(o, never, "geometry",
                    "the widest place of " + quoted(table.name) + " is " + metres(table.widest_mm) +
                        " from its boundary, and " + metres(need.clearance_mm) +
                        " are sure to be seen");
  }
  return std::nullopt;
}

// Each side of an `or` asks for a zone, and none of these has a place that is wide enough.
std::optional<Obligation> too_narrow_on_each_side(const Subject& s, const ir::Monitor& m,
                                                  const Obligation& o) {
  if (s.decision.on_plan) return std::nullopt;
  for (const auto& sides : analysis::surely_in(m.property, s.decision.facts.params)) {
    std::string all;
    for (const analysis::Standoff& side : sides) {
      const ir::ZoneTable& table = s.module[side.zone];
      const std::int64_t need_mm =
          analysis::shown_clearance_mm(s.decision, s.decision.motions.front(), side.mm);
      if (table.widest_mm + rounded_mm >= need_mm) {
        all.clear();
        break;
      }
      all += (all.empty() ? "the widest place of " : ", that of ") + quoted(table.name) + " is " +
             metres(table.widest_mm) + " from its boundary where " + metres(need_mm) +
             " are sure to be seen";
    }
    if (!all.empty()) return not_seen(o, true, "geometry", all);
  }
  return std::nullopt;
}

// Heights at which a robot at rest is seen to be within the limits of what it says, if it may be in
// one of the slabs then.
std::vector<std::int64_t> heights_seen(const Subject& s, const ir::Monitor& m,
                                       const std::vector<Need>& needs) {
  const std::int64_t errs_mm =
      analysis::shown_clearance_mm(s.decision, s.decision.motions.front(), 0) -
      s.decision.body.radius_mm;
  std::int64_t low_mm = std::numeric_limits<std::int32_t>::min();
  std::int64_t high_mm = std::numeric_limits<std::int32_t>::max();
  ir::for_each_comparison(m.property, [&](const ir::Block& block, const ir::AtLeast& c) {
    if (!ir::has_form(block, c)) return;
    const auto least = ir::lower_bound(block, c, s.decision.facts.params);
    const auto most = ir::upper_bound(block, c);
    if (least && least->leaf.kind == ir::Leaf::Kind::altitude) {
      low_mm = std::max(low_mm, least->need.strictest + errs_mm + 1);
    }
    if (most && most->leaf.kind == ir::Leaf::Kind::altitude) {
      high_mm = std::min(high_mm, most->most - errs_mm - 1);
    }
  });
  std::vector<std::int64_t> all;
  if (low_mm > high_mm) return all;
  for (const Need& need : needs) {
    const ir::ZoneTable& table = s.module[need.zone];
    if (table.has_height())
      all.push_back(std::clamp<std::int64_t>(table.widest_z_mm, low_mm, high_mm));
    for (const ir::ZoneTable::Slab& slab : table.slabs) {
      const std::int64_t middle_mm = (std::int64_t{slab.floor_mm} + slab.ceiling_mm) / 2;
      all.push_back(std::clamp(middle_mm, low_mm, high_mm));
    }
  }
  return all;
}
// A place as clear of all zones where what it asks for besides is seen, too: enough charge for a
// way, and a height. `first`: one of those places, if there is one.
std::optional<Witness> witness_of_all(const Subject& s, const ir::Monitor& m,
                                      const std::vector<Need>& needs,
                                      const std::optional<Witness>& first) {
  const auto is_seen = [&](const Place& at) { return is_seen_at(s, m.property, at, needs); };
  const bool flat = std::ranges::none_of(
      needs, [&](const Need& need) { return s.module[need.zone].has_height(); });
  if (flat) {
    std::optional<geometry::Point> known;
    if (first) known = {analysis::metres_of(first->x_mm), analysis::metres_of(first->y_mm)};
    const auto at = good_place(s, needs, known, is_seen);
    return at ? std::optional(Witness{in_mm(at->x), in_mm(at->y), 0}) : std::nullopt;
  }
  std::vector<Place> all = charging_places(s);
  for (const Need& need : needs) {
    const ir::ZoneTable& table = s.module[need.zone];
    all.insert(all.begin(), {table.widest_x_mm, table.widest_y_mm, std::nullopt});
  }
  if (first) all.insert(all.begin(), {first->x_mm, first->y_mm, first->z_mm});
  for (const Place& at : all) {
    std::vector<std::int64_t> heights = heights_seen(s, m, needs);
    if (at.z_mm) heights.insert(heights.begin(), *at.z_mm);
    for (const std::int64_t z_mm : heights) {
      const Witness there{at.x_mm, at.y_mm, z_mm};
      if (is_seen({at.x_mm, at.y_mm, z_mm}) && is_clear_of(s, needs, there)) return there;
    }
  }
  return std::nullopt;
}
// That no two robots are so far apart in its own zone, or that no agent is known to be so far away.
std::optional<Obligation> too_far_to_see(const Subject& s, std::size_t k, const Obligation& o) {
  const ir::Decision& d = s.decision;
  const ir::Monitor& m = d.monitors[k];
  if (d.on_plan) return std::nullopt;
  if (!out_of_sight(s, k).empty()) {
    return not_seen(o, false, "", "no agent is known to be as far away as it asks for");
  }
  const std::int64_t asked_mm = analysis::sure_separation_mm(m.property, d.facts.params);
  if (asked_mm <= 0 || (d.robots < 2 && !d.open_fleet)) return std::nullopt;
  for (const ir::ZoneIndex fence : analysis::sure_fences(m.property, d.facts.params)) {
    const auto across_mm = analysis::farthest_apart_mm(
        s.module, d.body.in_space, {s.exact, any_solid(s)}, fence, d.body.radius_mm);
    if (!across_mm) continue;
    const std::int64_t most_mm = std::max<std::int64_t>(*across_mm - 2 * d.body.radius_mm, 0);
    if (asked_mm <= most_mm) continue;
    return not_seen(o, false, "",
                    "no two robots in " + quoted(s.module[fence].name) + " are more than " +
                        metres(most_mm) + " apart");
  }
  return std::nullopt;
}

// Inputs with which it is false.
analysis::Told told_to_fail(const Subject& s, std::size_t k) {
  return analysis::told_to_be(s.spec, *s.monitor(k).always, false, analysis::ToldHow::exactly);
}
// Inputs with which it is seen to hold of a robot that rests.
analysis::Told told_to_hold(const Subject& s, std::size_t k) {
  std::optional<analysis::SeenAtRest> rest;
  if (!s.decision.on_plan) rest = seen_at_rest(s, s.decision.motions.front());
  return analysis::told_to_be(s.spec, *s.monitor(k).always, true, analysis::ToldHow::seen, rest);
}
Obligation not_told(Obligation o, const analysis::Told& told) {
  if (told.can == analysis::CanBeTold::open) {
    o.method = "no proof";
    o.because = "no inputs were found with which it is seen to hold";
    return o;
  }
  o.status = Status::refuted;
  o.method = "interval search";
  o.because = "no inputs are seen to make it true, whatever the robots do";
  o.repair = "a property that can be seen to be true is needed";
  return o;
}
void claim_told(const Subject& s, std::size_t k, bool holds,
                const std::vector<analysis::ToldInput>& told, Obligation& o) {
  if (told.empty()) return;
  o.because += (o.because.empty() ? "with " : ", with ") + analysis::told_text(s.spec, told);
  o.claims.push_back({"told",
                      {{"decision", s.decision.name},
                       {"monitor", s.decision.monitors[k].name},
                       {"value", holds ? "true" : "false"},
                       {"inputs", values_of(s, told)}}});
}

// Of a zone, at that place.
void claim_seen(const Subject& s, const ir::Monitor& m, const Need& need, const Witness& at,
                Obligation& o) {
  const ir::ZoneTable& table = s.module[need.zone];
  const std::string height = table.has_height() ? ", " + metres(at.z_mm) : "";
  o.because = std::string(s.decision.on_plan ? "a plan to (" : "a robot at rest at (") +
              metres(at.x_mm) + ", " + metres(at.y_mm) + height + ") is seen to be in " +
              quoted(table.name) + ", whatever the errors";
  Claim claim = place_claim(s, need.zone, at.x_mm, at.y_mm, need.clearance_mm);
  claim.what = "seen";
  claim.values.erase("extra_us");
  claim.values["monitor"] = m.name;
  if (table.has_height()) claim.values["z_mm"] = std::to_string(at.z_mm);
  o.claims.push_back(std::move(claim));
}

// Whether a plan has several ways to be as it says, or may have to be out of a zone.
bool chooses_plan(const ir::Block& property) {
  return std::ranges::any_of(property.values, [](const ir::Value& v) {
    return std::holds_alternative<ir::Or>(v.op) || std::holds_alternative<ir::Not>(v.op);
  });
}
// A plan to one place, in all zones of one of its ways.
Obligation planned(const Subject& s, std::size_t k, const std::vector<Need>& needs,
                   const analysis::Told& told, Obligation o) {
  const ir::Monitor& m = s.decision.monitors[k];
  for (const auto& way : ways_of_plan(m.property, m.property.result, false)) {
    std::vector<Need> all;
    for (const Need& need : needs) {
      if (way.contains(need.zone))
        all.push_back({need.zone, std::max<std::int64_t>(need.clearance_mm, 1)});
    }
    const auto at = all.size() == 1 ? std::optional(alone(s, all.front()))
                    : all.empty()   ? std::nullopt
                                    : common_witness(s, all);
    if (!at && !way.empty()) continue;
    for (const Need& need : all) claim_seen(s, m, need, *at, o);
    if (all.empty()) o.claims.push_back(limits_claim(s));
    claim_told(s, k, true, told.inputs, o);
    return o;
  }
  return doubted(std::move(o), {no_choice});
}

// What is known of it without a witness: that it is never so, or that nobody can see it.
std::optional<Obligation> unseen(const Subject& s, std::size_t k, Obligation o) {
  const ir::Monitor& m = s.decision.monitors[k];
  if (analysis::never_holds(s.decision, m.property)) {
    o.status = Status::refuted;
    o.method = "static check";
    o.because = "it is false, whatever is measured";
    o.repair = "a property that can be true is needed";
    return o;
  }
  if (atoms_of(m.property).received) {
    o.method = "no proof";
    o.because = "what zone will be received is not known";
    return o;
  }
  if (auto limits = limits_unseen(s, m, o)) return limits;
  return too_far_to_see(s, k, o);
}

}  // namespace

Obligation can_hold(const Subject& s, std::size_t k) {
  const ir::Monitor& m = s.decision.monitors[k];
  Obligation o;
  o.kind = Kind::satisfiable;
  o.monitor = m.name;
  if (auto found = unseen(s, k, o)) return std::move(*found);
  analysis::Told told = told_to_hold(s, k);
  if (told.can != analysis::CanBeTold::yes) return not_told(std::move(o), told);
  const auto by_themselves = s.decision.on_plan ? std::nullopt : told_alone(s, k);
  if (by_themselves) told = *by_themselves;
  if (is_no_choice(s, k, by_themselves.has_value())) return doubted(std::move(o), {no_choice});
  o.status = Status::proved;
  o.method = "witness";
  std::vector<Need> needs = seen_needs(s, m);
  if (auto narrow = too_narrow_to_see(s, needs, o)) return std::move(*narrow);
  if (auto narrow = too_narrow_on_each_side(s, m, o)) return std::move(*narrow);
  if (s.decision.on_plan && chooses_plan(m.property)) {
    return planned(s, k, needs, told, std::move(o));
  }
  std::optional<Witness> common;
  std::vector<Need> together;
  const std::vector<Sides> ways = sides_seen(s, m);
  for (const Sides& sides : ways) {
    together = held_together(s, m, needs);
    together.insert(together.end(), sides.begin(), sides.end());
    common = together.size() > 1 || !sides.empty() ? common_witness(s, together) : std::nullopt;
    if (common) break;
  }
  const bool chosen = !ways.front().empty();
  if ((together.size() > 1 || chosen) && !common) {
    const bool nowhere = !chosen && share_nothing(s, together);
    return not_seen(std::move(o), nowhere, "geometry",
                    std::string(nowhere ? "no place is" : "no place was found") +
                        " so clear of the boundaries of all of its zones that this is seen, "
                        "whatever the errors");
  }
  if (chosen) {
    for (const Need& need : together) add_need(needs, need);
  }
  std::optional<Witness> of_all;
  if (!s.decision.on_plan && asks_for_more(s, m.property)) {
    if (needs.size() == 1) of_all = alone(s, needs.front());
    of_all = witness_of_all(s, m, needs, common ? common : of_all);
    if (!of_all) {
      return not_seen(std::move(o), false, "",
                      "no place was found where all that it asks for is seen at once: enough "
                      "charge for the way from there, and a height that suits it");
    }
  }
  for (const Need& need : needs) {
    const bool shared =
        common && std::ranges::find(together, need.zone, &Need::zone) != together.end();
    claim_seen(s, m, need, of_all ? *of_all : shared ? *common : alone(s, need), o);
  }
  if (o.because.empty() && !s.decision.on_plan) {
    o.method = "closed form";
    o.because = std::string("a robot at rest that is far from others and charged") +
                (atoms_of(m.property).altitude ? ", at a height that suits it," : "") +
                " is seen to keep it";
    o.claims.push_back(limits_claim(s));
  }
  claim_told(s, k, true, told.inputs, o);
  return o;
}

Obligation can_fail(const Subject& s, std::size_t k) {
  const ir::Monitor& m = s.decision.monitors[k];
  const analysis::Told told = told_to_fail(s, k);
  const analysis::Vacuity vacuity =
      analysis::vacuity_of(s.module, s.decision, m.property, told.can);
  Obligation o;
  o.kind = Kind::not_vacuous;
  o.monitor = m.name;
  std::string because;
  for (const std::string& each : vacuity.because)
    because += (because.empty() ? "" : " and ") + each;
  if (vacuity.can_fail == analysis::CanFail::no) {
    o.status = Status::refuted;
    o.method = "static check";
    o.because = "it is never false" + (because.empty() ? "" : ": " + because);
    o.repair = "a property that can be false is needed";
    return o;
  }
  if (vacuity.can_fail == analysis::CanFail::open) {
    o.status = Status::unknown;
    o.method = "no proof";
    o.because = atoms_of(m.property).received ? "what zone will be received is not known"
                                              : "no state was found in which it is false";
    return o;
  }
  o.status = Status::proved;
  o.method = "witness";
  o.because = because.empty() ? "what it is told may make it false" : "it is false " + because;
  o.claims.push_back({"fails", {{"decision", s.decision.name}, {"monitor", m.name}}});
  claim_told(s, k, false, told.inputs, o);
  return o;
}

}  // namespace rtac::verify
