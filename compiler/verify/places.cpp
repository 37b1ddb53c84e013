// Whether there is a place where all monitors of a decision give control back.
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
#include "compiler/verify/at_place.h"
#include "compiler/verify/atoms.h"
#include "compiler/verify/common_place.h"
#include "compiler/verify/proofs.h"
#include "compiler/verify/room_for_all.h"

namespace rtac::verify {

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

Obligation too_dear(Obligation o) {
  o.status = Status::unknown;
  o.method = "no proof";
  o.because =
      "a place where all monitors give control back, with enough charge for the ways from there, "
      "was not found";
  return o;
}
// Where one robot is given back in these zones, with enough charge.
Floor charged_floor(const Subject& s, const std::vector<Need>& zones) {
  Floor floor = floor_of(s, zones);
  if (!asks_for_charge(s)) return floor;
  floor.has = [has = std::move(floor.has), &s, &zones](const geometry::Point& p) {
    return has(p) && is_charged_at(s, {in_mm(p.x), in_mm(p.y)}, zones);
  };
  return floor;
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
  const bool charged = asks_for_charge(s);
  const auto is_charged = [&](const Place& at) { return is_charged_at(s, at, all); };
  if (all.empty() && !asks_for_height(s, needs)) {
    if (!needs.open.empty()) return returns_open(needs, std::move(o));
    if (charged && !good_place(s, all, std::nullopt, is_charged)) return too_dear(std::move(o));
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
  if (auto at = common_place(s, all)) {
    if (!needs.open.empty()) return returns_open(needs, std::move(o));
    if (charged) at = good_place(s, all, at, is_charged);
    if (!at) return too_dear(std::move(o));
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
               : all_at_once(s, needs.zones, charged_floor(s, needs.zones), std::move(o));
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

// Why no place is looked for; "": it is.
std::string no_place_known(const Subject& s) {
  if (std::ranges::any_of(s.decision.monitors,
                          [](const ir::Monitor& m) { return atoms_of(m.property).received; })) {
    return "what zone will be received is not known, and so no place that it leaves free";
  }
  if (const std::string far = out_of_sight(s); !far.empty()) {
    return quoted(far) + " asks for an agent to be farther away than is ever known";
  }
  if (!are_windows_ever_gone(s)) {
    return "no moment was found at which all zones that come and go are gone";
  }
  return "";
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
    o.repair = "a wider zone is needed, or a smaller distance";
    if (flat) offer_room(s, zones, o);
    return o;
  }
  if (std::string why = no_place_known(s); !why.empty()) {
    o.method = "no proof";
    o.because = std::move(why);
    return o;
  }
  const auto& monitors = s.decision.monitors;
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
