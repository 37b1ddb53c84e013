// Whether properties can be seen to hold, can be false, and whether there is a place where all
// monitors of a decision give control back.
#include <algorithm>
#include <cmath>
#include <functional>

#include "compiler/analysis/across.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/keeps_off.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/return_condition.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/vacuous.h"
#include "compiler/geometry/crowding.h"
#include "compiler/sema/openings.h"
#include "compiler/sema/visit.h"
#include "compiler/support/words.h"
#include "compiler/verify/about_recovery.h"
#include "compiler/verify/atoms.h"
#include "compiler/verify/common_place.h"
#include "compiler/verify/proofs.h"
#include "compiler/verify/room_for_all.h"

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

}  // namespace

Claim place_claim(const Subject& s, ir::ZoneIndex zone, std::int64_t x_mm, std::int64_t y_mm,
                  std::int64_t clearance_mm) {
  return {"place",
          {{"decision", s.decision.name},
           {"zone", s.module[zone].name},
           {"x_mm", std::to_string(x_mm)},
           {"y_mm", std::to_string(y_mm)},
           {"extra_us", std::to_string(s.decision.return_extra_us)},
           {"clearance_mm", std::to_string(clearance_mm)}}};
}

// Square of the distance of a place from the boundary of a region, in m^2.
Rational square_to(const std::vector<geometry::Ring>& rings, const geometry::Point& p) {
  Rational least = -1;
  for (const geometry::Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const geometry::Point& a = ring[i];
      const geometry::Point& b = ring[(i + 1) % ring.size()];
      const Rational dx = b.x - a.x, dy = b.y - a.y;
      Rational along = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
      along = std::clamp(along, Rational(0), Rational(1));
      const Rational ex = a.x + along * dx - p.x, ey = a.y + along * dy - p.y;
      const Rational square = ex * ex + ey * ey;
      if (least < 0 || square < least) least = square;
    }
  }
  return least;
}

analysis::HowItLies how_it_lies(const Subject& s) {
  return [&s](ir::ZoneIndex inner, const analysis::Standoff& outer) {
    return analysis::lies_deep(s.module, s.exact, s.solid, inner, outer) ? analysis::Lies::deep
                                                                         : analysis::Lies::in;
  };
}

std::vector<Need> needs_of(const Subject& s) {
  std::vector<Need> all;
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    const ir::Monitor& m = s.decision.monitors[k];
    if (!m.lookahead.duration) continue;
    const auto& params = s.decision.facts.params;
    const std::int64_t back_mm = analysis::return_clearance_mm(s.decision, m.lookahead.duration_us);
    for (const ir::ZoneIndex zone : analysis::fences_of(m.property, params)) {
      const std::int64_t mm =
          std::max(back_mm + analysis::fence_standoff_mm(m.property, params, zone),
                   analysis::asked_clearance(s.module, s.decision, k, zone, how_it_lies(s)).mm);
      const auto known =
          std::find_if(all.begin(), all.end(), [&](const Need& need) { return need.zone == zone; });
      if (known == all.end()) {
        all.push_back({zone, mm});
      } else {
        known->clearance_mm = std::max(known->clearance_mm, mm);
      }
    }
  }
  return all;
}

namespace {

// `shrink`, tables and the grid: a zone may be so much wider than it is found to be.
constexpr std::int64_t rounded_mm = 10;

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
// `mmps`: as fast as a robot at rest may be.
bool settles_places(const Subject& s, const ir::Monitor& m, std::int64_t mmps) {
  const auto rests = [&](ir::ValueId id) {
    return analysis::asks_for_slow(s.module, s.decision, m.property, id, mmps);
  };
  return analysis::places_settle(m.property, s.decision.facts.params, {mmps, rests});
}
constexpr const char* no_choice =
    "some `or` is no choice of one of several zones, and no place is found for it";
// Of a property without inputs.
bool is_no_choice(const Subject& s, std::size_t k) {
  const bool by_places = analysis::inputs_in(s.spec, *s.monitor(k).always).empty();
  return by_places && !s.decision.on_plan && !settles_places(s, s.decision.monitors[k], 0);
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
// In space, the widest place of one of the zones that is clear enough of the others as well.
std::optional<Witness> common_witness(const Subject& s, const std::vector<Need>& needs) {
  const bool flat = std::ranges::none_of(
      needs, [&](const Need& need) { return s.module[need.zone].has_height(); });
  if (flat) {
    const auto at = common_place(s, needs);
    return at ? std::optional(Witness{in_mm(at->x), in_mm(at->y), 0}) : std::nullopt;
  }
  const analysis::ExactSolid solid = any_solid(s);
  for (const Need& widest : needs) {
    const ir::ZoneTable& table = s.module[widest.zone];
    if (!table.has_height()) continue;
    const Witness at{table.widest_x_mm, table.widest_y_mm, table.widest_z_mm};
    const bool clear = std::ranges::all_of(needs, [&](const Need& need) {
      const Rational by = analysis::metres_of(need.clearance_mm);
      const Rational upright = s.module[need.zone].has_height() ? by : Rational(0);
      return solid(need.zone)
          .shrink(by, upright)
          .contains({analysis::metres_of(at.x_mm), analysis::metres_of(at.y_mm)},
                    analysis::metres_of(at.z_mm));
    });
    if (clear) return at;
  }
  return std::nullopt;
}
bool share_nothing(const Subject& s, const std::vector<Need>& needs) {
  const analysis::ExactSolid solid = any_solid(s);
  geometry::Solid common = geometry::Solid::everywhere();
  for (const Need& need : needs) {
    const Rational by =
        analysis::metres_of(std::max<std::int64_t>(need.clearance_mm - rounded_mm, 0));
    const Rational upright = s.module[need.zone].has_height() ? by : Rational(0);
    common = common.intersect(solid(need.zone).shrink(by, upright));
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

// Inputs with which it is seen to hold, or else is false.
analysis::Told told_for(const Subject& s, std::size_t k, bool holds) {
  return analysis::told_to_be(s.spec, *s.monitor(k).always, holds,
                              holds ? analysis::ToldHow::seen : analysis::ToldHow::exactly);
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

}  // namespace

Obligation can_hold(const Subject& s, std::size_t k) {
  const ir::Monitor& m = s.decision.monitors[k];
  Obligation o;
  o.kind = Kind::satisfiable;
  o.monitor = m.name;
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
  if (auto unseen = limits_unseen(s, m, o)) return std::move(*unseen);
  const analysis::Told told = told_for(s, k, true);
  if (told.can != analysis::CanBeTold::yes) return not_told(std::move(o), told);
  if (is_no_choice(s, k)) return doubted(std::move(o), {no_choice});
  o.status = Status::proved;
  o.method = "witness";
  std::vector<Need> needs = seen_needs(s, m);
  if (auto narrow = too_narrow_to_see(s, needs, o)) return std::move(*narrow);
  if (auto narrow = too_narrow_on_each_side(s, m, o)) return std::move(*narrow);
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
    return not_seen(std::move(o), !chosen && share_nothing(s, together), "geometry",
                    "no place is so clear of the boundaries of all of its zones that this is "
                    "seen, whatever the errors");
  }
  if (chosen) {
    for (const Need& need : together) add_need(needs, need);
  }
  for (const Need& need : needs) {
    const ir::ZoneTable& table = s.module[need.zone];
    const bool shared = common && std::ranges::any_of(together, [&](const Need& each) {
                          return each.zone == need.zone;
                        });
    const Witness at = shared ? *common : alone(s, need);
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
  const analysis::Told told = told_for(s, k, false);
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

namespace {

std::string where_others_are_far(const Subject& s) {
  const bool apart = std::ranges::any_of(
      s.decision.monitors, [](const ir::Monitor& m) { return atoms_of(m.property).distance; });
  return apart && (s.decision.robots > 1 || s.decision.open_fleet) ? ", as long as others are far"
                                                                   : "";
}

// Farther from a boundary than the tables of a zone are exact no place is seen to be as far as it
// is.
// "": they are exact so far.
std::string seen_too_near(const Subject& s, const std::vector<Need>& needs) {
  for (const Need& need : needs) {
    const auto exact_mm = s.module[need.zone].tree.exact_inside_mm;
    if (!exact_mm || *exact_mm >= need.clearance_mm) continue;
    return "distances to the boundary of " + quoted(s.module[need.zone].name) +
           " are exact up to " + metres(*exact_mm) + ", and control is given back at " +
           metres(need.clearance_mm);
  }
  return "";
}

// Of zones that leave no place for all, in words.
std::string what_is_needed(const Subject& s, const std::vector<Need>& all) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!s.exact(all[i].zone).intersect(s.exact(all[j].zone)).empty()) continue;
      return quoted(s.module[all[j].zone].name) + " and " + quoted(s.module[all[i].zone].name) +
             " have nothing in common: conditions that can be so at one place are needed";
    }
  }
  return "zones that share more room, a shorter `ahead` or a lower `speed` are needed";
}

Obligation together(const Subject& s, const JointNeeds& needs) {
  Obligation o;
  o.kind = Kind::joint_return;
  const std::vector<Need> all = all_of(needs);
  o.method = "witness";
  if (std::string near = seen_too_near(s, all); !near.empty()) {
    o.because = std::move(near);
    return o;
  }
  if (all.empty() && !asks_for_height(s, needs)) {
    if (!needs.open.empty()) return returns_open(needs, std::move(o));
    o.status = Status::proved;
    o.because = "no monitor asks for a place";
    o.claims.push_back({"no_fences", {{"decision", s.decision.name}}});
    return o;
  }
  if (s.decision.body.in_space) {
    o = returns_together_in_space(s, needs);
    if (o.status == Status::proved) o.because += where_others_are_far(s);
    return o;
  }
  if (const auto at = common_place(s, all)) {
    if (!needs.open.empty()) return returns_open(needs, std::move(o));
    const std::int64_t x_mm = in_mm(at->x), y_mm = in_mm(at->y);
    o.status = Status::proved;
    o.because = "all monitors give control back at (" + metres(x_mm) + ", " + metres(y_mm) + ")";
    for (const Need& need : all) {
      o.because += ", " + metres(need.clearance_mm) + " from the boundary of " +
                   quoted(s.module[need.zone].name);
    }
    o.because += where_others_are_far(s);
    for (const Need& need : needs.zones) {
      o.claims.push_back(place_claim(s, need.zone, x_mm, y_mm, need.clearance_mm));
    }
    for (Claim& claim : returned_claims(s, x_mm, y_mm, std::nullopt)) {
      o.claims.push_back(std::move(claim));
    }
    return needs.zones.empty()
               ? o
               : all_at_once(s, needs.zones, floor_of(s, needs.zones), std::move(o));
  }
  // `shrink` takes up to 1 mm more than it is asked for
  geometry::Region common = geometry::Region::everywhere();
  for (const Need& need : all) {
    common =
        common.intersect(s.exact(need.zone).shrink(analysis::metres_of(need.clearance_mm - 3)));
  }
  if (common.empty() && !needs.one_of_several) {
    o.status = Status::refuted;
    if (const auto at = any_place(s, all)) o.place_mm = {in_mm(at->x), in_mm(at->y)};
    o.because = "no place is so clear of the boundaries that all monitors give control back there";
    o.repair = what_is_needed(s, all);
    if (s.is_read) o.mends = earlier_returns(s);
  } else {
    o.status = Status::unknown;
    o.because = "a place where all monitors give control back was not found among the cells";
  }
  return o;
}

// Whether the robots do not fit where they are given back in a zone, so far apart: in the plane.
bool crowded(const Subject& s, ir::ZoneIndex fence, std::int64_t clearance_mm,
             std::int64_t separation_mm) {
  const ir::Decision& d = s.decision;
  const ir::ZoneTable& zone = s.module[fence];
  if (d.robots < 3 || d.body.in_space || zone.has_height() || zone.edges.empty()) return false;
  const auto deep =
      analysis::within(s.exact(fence), std::max<std::int64_t>(clearance_mm - rounded_mm, 0));
  return deep && geometry::too_many_for(*deep, static_cast<std::size_t>(d.robots),
                                        analysis::metres_of(separation_mm + 2 * d.body.radius_mm));
}

// That no two robots of the decision are ever as far apart as one of its properties asks for, in a
// zone that another one holds all of them in; "": that is not known.
std::string never_so_far_apart(const Subject& s) {
  const ir::Decision& d = s.decision;
  if (d.robots < 2 && !d.open_fleet) return "";
  for (const ir::Monitor& m : d.monitors) {
    if (!m.lookahead.duration) continue;
    const std::int64_t asked_mm = analysis::sure_separation_mm(m.property, d.facts.params);
    for (const ir::Monitor& other : d.monitors) {
      for (const ir::ZoneIndex fence : analysis::sure_fences(other.property, d.facts.params)) {
        if (!other.lookahead.duration) continue;
        const std::int64_t back_mm = analysis::return_clearance_mm(d, other.lookahead.duration_us);
        const auto across_mm = analysis::farthest_apart_mm(s.module, d.body.in_space,
                                                           {s.exact, any_solid(s)}, fence, back_mm);
        if (!across_mm) continue;
        const std::int64_t most_mm = std::max<std::int64_t>(*across_mm - 2 * d.body.radius_mm, 0);
        if (asked_mm > 0 && asked_mm <= most_mm && crowded(s, fence, back_mm, asked_mm)) {
          return quoted(m.name) + " asks for a distance of " + metres(asked_mm) + ", and " +
                 std::to_string(d.robots) +
                 " robots that are so far apart do not fit where they are given back in " +
                 quoted(s.module[fence].name);
        }
        if (asked_mm <= most_mm) continue;
        return quoted(m.name) + " asks for a distance of " + metres(asked_mm) +
               ", and no two robots are more than " + metres(most_mm) +
               " apart where both are given back in " + quoted(s.module[fence].name);
      }
    }
  }
  return "";
}

// For as long as any monitor looks ahead, and another minute, which is more than samples, latency
// and the return take.
bool are_windows_ever_gone(const Subject& s) {
  std::vector<const sema::Expr*> said;
  std::int64_t ahead_us = 0;
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    if (!s.looks_at_places(k)) continue;
    said.push_back(s.monitor(k).always.get());
    ahead_us = std::max(ahead_us, s.decision.monitors[k].lookahead.duration_us);
  }
  return sema::are_ever_gone(s.spec, said, ahead_us / 1'000'000 + 60);
}

Obligation returned_as_they_say(const Subject& s) {
  Obligation o;
  o.kind = Kind::joint_return;
  if (const std::string never = never_so_far_apart(s); !never.empty()) {
    o.status = Status::refuted;
    o.method = "geometry";
    o.because = never;
    if (!s.is_read) return o;
    const std::vector<Need> zones = joint_needs_of(s).zones;
    const bool flat = !s.decision.body.in_space && !zones.empty() && s.decision.robots >= 2;
    o.repair = flat ? room_that_works(s, zones) : "a wider zone is needed, or a smaller distance";
    return o;
  }
  const auto& monitors = s.decision.monitors;
  if (std::any_of(monitors.begin(), monitors.end(),
                  [](const ir::Monitor& m) { return atoms_of(m.property).received; })) {
    o.method = "no proof";
    o.because = "what zone will be received is not known, and so no place that it leaves free";
    return o;
  }
  if (!are_windows_ever_gone(s)) {
    o.method = "no proof";
    o.because = "no moment was found at which all zones that come and go are gone";
    return o;
  }
  std::vector<const ir::Monitor*> looking;
  for (std::size_t k = 0; k < monitors.size(); ++k) {
    if (!s.looks_at_places(k)) continue;
    looking.push_back(&monitors[k]);
    const std::int64_t mmps =
        analysis::fastest_from_rest(s.decision, monitors[k].lookahead.duration_us);
    if (settles_places(s, monitors[k], mmps)) continue;
    o.method = "no proof";
    o.because =
        "what " + quoted(monitors[k].name) +
        " asks of places is no choice of one of several zones, and no place is found for it";
    return o;
  }
  const std::vector<Sides> ways = ways_to_choose(
      s, looking,
      [&](const ir::Monitor& m, std::int64_t own_mm) {
        return analysis::return_clearance_mm(s.decision, m.lookahead.duration_us) + own_mm;
      },
      [&](const ir::Monitor& m) {
        return analysis::fastest_from_rest(s.decision, m.lookahead.duration_us);
      });
  const JointNeeds needs = joint_needs_of(s);
  if (ways.front().empty()) return together(s, needs);
  for (const Sides& sides : ways) {
    JointNeeds with = needs;
    for (const Need& side : sides) {
      const auto known = std::ranges::find(with.zones, side.zone, &Need::zone);
      if (known == with.zones.end()) {
        with.zones.push_back(side);
      } else {
        known->clearance_mm = std::max(known->clearance_mm, side.clearance_mm);
      }
    }
    o = together(s, with);
    if (o.status == Status::proved) return o;
  }
  o.status = Status::unknown;
  o.method = "no proof";
  o.because =
      "a place on one side of each `or`, where all monitors give control back, was not found";
  o.repair.clear();
  o.claims.clear();
  o.place_mm = {};
  return o;
}

using Monitors = std::set<std::size_t>;

// That inputs might make true wherever robots are.
Monitors that_inputs_may_make_true(const Subject& s) {
  Monitors all;
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    const sema::Monitor& m = s.monitor(k);
    if (!s.looks_at_places(k) || m.return_when) continue;
    if (!analysis::inputs_in(s.spec, *m.always).empty()) all.insert(k);
  }
  return all;
}
// All sets of a few of them, those of more first; and that of all.
std::vector<Monitors> sets_of(const Monitors& of) {
  constexpr std::size_t few = 5;
  std::vector<Monitors> all{{}};
  for (const std::size_t k : of) {
    if (all.size() == 1U << few) break;
    const std::vector<Monitors> without = all;
    for (Monitors set : without) {
      set.insert(k);
      all.push_back(std::move(set));
    }
  }
  all.erase(all.begin());
  if (of.size() > few) all.push_back(of);
  std::ranges::stable_sort(all, std::greater<>(), [](const Monitors& set) { return set.size(); });
  return all;
}

}  // namespace

Obligation returns_together(const Subject& s) {
  const Obligation places = returned_as_they_say(s);
  Obligation o = told_at_once(s, std::nullopt, places);
  // what inputs exclude they do not allow where they decide alone
  if (places.status == Status::proved) return o;
  std::vector<Monitors> without_place;
  for (Monitors& told : sets_of(that_inputs_may_make_true(s))) {
    // of fewer all is asked that is asked of more
    const bool known = std::ranges::any_of(
        without_place, [&](const Monitors& more) { return std::ranges::includes(more, told); });
    if (known) continue;
    Subject with = s;
    with.is_read = false;
    with.told = std::move(told);
    Obligation each = returned_as_they_say(with);
    if (each.status == Status::refuted) {
      without_place.push_back(std::move(with.told));
      continue;
    }
    each = told_at_once(with, std::nullopt, std::move(each));
    const auto is_place = [](const Claim& c) { return c.what == "place" || c.what == "returned"; };
    if (each.status == Status::proved && std::ranges::any_of(each.claims, is_place)) return each;
    if (o.status != Status::refuted || each.status == Status::refuted) continue;
    // what inputs may keep from asking refutes nothing
    o = std::move(each);
    o.status = Status::unknown;
    o.claims.clear();
  }
  return o;
}

}  // namespace rtac::verify
