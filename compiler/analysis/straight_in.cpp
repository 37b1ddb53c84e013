#include "compiler/analysis/straight_in.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "compiler/analysis/boundless.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/free_standing.h"
#include "compiler/analysis/in_sight.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/liveness.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/tables.h"
#include "compiler/geometry/entry.h"
#include "compiler/geometry/kept.h"
#include "compiler/ir/linear.h"
#include "compiler/ir/operands.h"

namespace rtac::analysis {
namespace {

using geometry::Region;
using geometry::Solid;
using Held = std::vector<std::vector<Standoff>>;

Held held_at(const TakeOver& at) {
  const ir::Decision& d = at.decision;
  Held all;
  for (std::size_t k = 0; k < d.monitors.size(); ++k) {
    const ir::Monitor& m = d.monitors[k];
    if (k != at.judged && !relied_on(d, m)) continue;
    for (auto& either : surely_in(m.property, d.facts.params)) all.push_back(std::move(either));
  }
  return all;
}

// Whether a property speaks of nothing but places, heights and inputs: what a recovery keeps on its
// way, or what it does not change.
bool is_of_places(const ir::Block& property) {
  return std::ranges::none_of(property.values, [](const ir::Value& value) {
    const ir::Op& op = value.op;
    return std::holds_alternative<ir::Speed>(op) || std::holds_alternative<ir::Battery>(op) ||
           std::holds_alternative<ir::EnergyTo>(op) || std::holds_alternative<ir::Distance>(op) ||
           std::holds_alternative<ir::AgentDistance>(op) || ir::body_of(op) != nullptr;
  });
}
// The least that any comparison with a clearance of the fence asks for: below 0 bodies may stick
// out of it, or that is not known.
std::int64_t least_asked_mm(const TakeOver& at, ir::ZoneIndex fence) {
  const auto of_fence = [&](const auto& term) {
    const ir::Leaf& leaf = term.first;
    return leaf.kind == ir::Leaf::Kind::clearance && ir::ZoneIndex{leaf.table} == fence;
  };
  const ir::Block& property = at.decision.monitors[at.judged].property;
  std::optional<std::int64_t> least_mm;
  ir::for_each_comparison(property, [&](const ir::Block& block, const ir::AtLeast& compare) {
    if (std::ranges::none_of(ir::linear_form(block, compare).terms, of_fence)) return;
    const auto bound = ir::lower_bound(block, compare, at.decision.facts.params);
    const std::int64_t mm = bound ? bound->need.laxest : -1;
    least_mm = std::min(least_mm.value_or(mm), mm);
  });
  return least_mm.value_or(-1);
}
// Where the property holds by what it asks of that fence. Where it holds by another side of an `or`
// alone, nothing is asked of the way with regard to that fence, which the recovery leads back to.
Held held_by_fence(const TakeOver& at, ir::ZoneIndex fence) {
  Held all = held_at(at);
  const std::int64_t least_mm = least_asked_mm(at, fence);
  const bool places_settle_it = is_of_places(at.decision.monitors[at.judged].property);
  if (least_mm >= 0 && places_settle_it) all.push_back({{fence, least_mm}});
  return all;
}

// The places of bodies that lie so far off the boundary; more of them where that is not known.
Region centres(const TakeOver& at, const Standoff& held) {
  const Region& region = at.exact(held.zone);
  return within(region, at.decision.body.radius_mm + held.mm).value_or(region);
}
// What the unions of each of these have in common.
template <class Zone, class Each, class Of>
Zone common(const std::vector<std::vector<Each>>& held, const Of& zone_of) {
  Zone all = Zone::everywhere();
  for (const std::vector<Each>& either : held) {
    Zone some;
    for (const Each& each : either) some = some.unite(zone_of(each));
    all = all.intersect(some);
  }
  return all;
}
Region where_held(const TakeOver& at, const Held& held) {
  return common<Region>(held, [&](const Standoff& each) { return centres(at, each); });
}

// The same of bodies in the plane; what is known already is not found again.
Region centres_where_held(const TakeOver& at, const Held& held) {
  if (at.known == nullptr) return where_held(at, held);
  std::vector<std::vector<KnownPlaces::Off>> key;
  for (const std::vector<Standoff>& either : held) {
    key.emplace_back();
    for (const Standoff& each : either) key.back().emplace_back(each.zone, each.mm);
  }
  const auto [found, is_new] = at.known->held.try_emplace(std::move(key));
  if (is_new) found->second = where_held(at, held);
  return found->second;
}
std::optional<Region> inside_of(const TakeOver& at, ir::ZoneIndex zone, std::int64_t mm) {
  if (at.known == nullptr) return within(at.exact(zone), mm);
  const auto [found, is_new] = at.known->within.try_emplace({zone, mm});
  if (is_new) found->second = within(at.exact(zone), mm);
  return found->second;
}

// How far a body takes its centre off a boundary, and so much more, but for what offsets round.
std::int64_t body_in_mm(const TakeOver& at, std::int64_t off_mm = 0) {
  return std::max<std::int64_t>(at.decision.body.radius_mm + off_mm - offsets_round_mm, 0);
}
// Bodies with their centres there lie in the zone, so far from its boundary.
bool fits_all(const TakeOver& at, ir::ZoneIndex zone, const Region& centres, std::int64_t off_mm) {
  const auto inside = inside_of(at, zone, body_in_mm(at, off_mm));
  return inside && inside->contains(centres);
}

// What is asked of held_outside, again and again while changes are tried.
struct Outside {
  struct Zone {
    Solid solid;
    std::int64_t off_mm = 0;
    bool has_height = false;

    bool operator==(const Zone& other) const {
      return off_mm == other.off_mm && has_height == other.has_height &&
             std::ranges::equal(solid.slabs(), other.solid.slabs(),
                                [](const auto& a, const auto& b) {
                                  return a.floor == b.floor && a.ceiling == b.ceiling &&
                                         a.region.rings() == b.region.rings();
                                });
    }
  };
  std::vector<std::vector<Zone>> held;
  Zone zone;
  std::int64_t radius_mm = 0;

  bool operator==(const Outside&) const = default;

  // Such a body reaches into what is kept beside the zone.
  [[nodiscard]] Solid find() const {
    const auto bodies_in = [&](const Zone& each) {
      const Rational by = metres_of(radius_mm + each.off_mm);
      return each.has_height ? each.solid.shrink_by_ball(by) : each.solid.shrink(by, 0);
    };
    const Rational fits = metres_of(std::max<std::int64_t>(radius_mm - offsets_round_mm, 0));
    const Solid& in = zone.solid;
    const Solid outside = common<Solid>(held, bodies_in)
                              .subtract(in.shrink(fits, zone.has_height ? fits : Rational(0)));
    if (outside.empty()) return outside;
    const Rational radius = metres_of(radius_mm + offsets_round_mm);
    const auto whole = [](const Zone& each) { return each.solid; };
    return outside.intersect(common<Solid>(held, whole).subtract(in).grow(radius, radius));
  }
};

// In space: where bodies may be that do not lie in the zone.
Solid held_outside(const TakeOver& at, const Held& held, ir::ZoneIndex zone) {
  thread_local geometry::Kept<Outside, Solid> kept;
  const auto zone_of = [&](const Standoff& each) {
    return Outside::Zone{at.solid(each.zone), each.mm, at.module[each.zone].has_height()};
  };
  Outside asked{{}, zone_of({zone, 0}), at.decision.body.radius_mm};
  for (const std::vector<Standoff>& either : held) {
    asked.held.emplace_back();
    for (const Standoff& each : either) asked.held.back().push_back(zone_of(each));
  }
  return kept.find(asked, [&] { return asked.find(); });
}

bool all_within(const TakeOver& at, const Held& held, ir::ZoneIndex zone) {
  const auto is_zone = [&](const std::vector<Standoff>& either) {
    return either.size() == 1 && either[0].zone == zone;
  };
  if (std::ranges::any_of(held, is_zone)) return true;
  if (at.decision.body.in_space) return held_outside(at, held, zone).empty();
  return fits_all(at, zone, centres_where_held(at, held), 0);
}

}  // namespace

bool starts_within(const TakeOver& at, ir::ZoneIndex zone) {
  return all_within(at, held_at(at), zone);
}

Solid led_in_from(const TakeOver& at, ir::ZoneIndex zone, ir::ZoneIndex fence) {
  return held_outside(at, held_by_fence(at, fence), zone);
}

std::string begins_inside(const ir::ZoneTable& zone) {
  return "a monitor that keeps robots inside " + name_as_written(zone) + " works";
}

std::int64_t aims_at_mm(const ir::Decision& decision, const ir::Recovery& step) {
  if (!ir::goes_back(step.kind)) return step.route_clearance_mm;
  return goals_mm(decision, step).back();
}

namespace {

std::int32_t in_mm(std::int64_t length) {
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(length, 0, 1 << 29));
}
// How far from the boundary of the fence a body has to be, beyond touching it: with the laxest
// parameters, and with the strictest, where something is asked of that fence. `alike`: with all of
// them each body is as far as is asked.
struct Asked {
  std::int64_t laxest_mm = 0, strictest_mm = 0;
  bool alike = false;
};
Asked asked_of(const TakeOver& at, ir::ZoneIndex fence) {
  Asked asked;
  int sure = 0, all = 0;
  const ir::Decision& d = at.decision;
  const ir::Block& property = d.monitors[at.judged].property;
  asked.laxest_mm = least_asked_mm(at, fence);
  for (const auto& either : surely_in(property, d.facts.params)) {
    if (either.size() != 1 || either[0].zone != fence) continue;
    asked.laxest_mm = std::max(asked.laxest_mm, either[0].mm);
    ++sure;
  }
  for (const Standoff& each : fence_standoffs(property, d.facts.params)) {
    if (each.zone != fence) continue;
    asked.strictest_mm = std::max(asked.strictest_mm, each.mm);
    ++all;
  }
  asked.alike = sure == all;
  return asked;
}
// How far all of the zone is from the boundary of the fence, up to `most_mm`.
std::int64_t depth_mm(const TakeOver& at, ir::ZoneIndex zone, ir::ZoneIndex fence,
                      std::int64_t most_mm) {
  const auto is_deep = [&](std::int64_t mm) {
    const auto inside = inside_of(at, fence, mm);
    return inside && inside->contains(at.exact(zone));
  };
  std::int64_t deep = 0, not_deep = most_mm + 1;
  while (not_deep - deep > 1) {
    const std::int64_t middle = deep + (not_deep - deep) / 2;
    (is_deep(middle) ? deep : not_deep) = middle;
  }
  return deep;
}
// The strictest that leads anybody in from outside of the zone: with stricter parameters each body
// where `keeps` says so, kept as far from the fence as they ask, lies in the zone already.
template <class Keeps>
std::int64_t led_in_mm(const Asked& asked, const Keeps& keeps) {
  std::int64_t led = asked.laxest_mm, fits = asked.strictest_mm;
  if (!asked.alike || led >= fits || !keeps(fits)) return fits;
  while (fits - led > 1) {
    const std::int64_t middle = led + (fits - led) / 2;
    (keeps(middle) ? fits : led) = middle;
  }
  return fits;
}
// The straight ways that the search may take into the zone of a step, but for what a fence asks.
geometry::EntryQuery straight_ways(const TakeOver& at, const ir::Recovery& step,
                                   std::int64_t strays_mm) {
  const ir::Body& body = at.decision.body;
  geometry::EntryQuery query{
      .least_mm = in_mm(body.radius_mm),
      .tested_mm = ir::goes_back(step.kind) ? 0 : in_mm(step.route_clearance_mm),
      .kept_mm = in_mm(body.radius_mm + strays_mm)};
  // what a retreat looks for, from outside of its zone, too (runtime/core/retreat.cpp)
  if (ir::goes_back(step.kind)) {
    const std::int64_t slack_mm = body.end_reach_mm + body.position_error_mm;
    query.straight_mm = {in_mm(aims_at_mm(at.decision, step)),
                         in_mm(step.return_clearance_mm + slack_mm),
                         in_mm(step.return_clearance_mm), in_mm(step.route_clearance_mm),
                         in_mm(body.radius_mm + slack_mm)};
    std::ranges::sort(query.straight_mm, std::greater());
  }
  // what a retreat loses (loss_m), and what ways over cells do (connector_loss_m)
  query.loss_mm = ir::goes_back(step.kind) ? 2 : 8;
  if (at.decision.robots == 1) {
    query.alone = {
        in_mm(aims_at_mm(at.decision, step)),
        ir::goes_back(step.kind) ? 0 : in_mm(joins_within_mm(at.module[step.zone].cells))};
  }
  return query;
}
geometry::Table table_of(const ir::ZoneTable& zone) {
  return {edges_of(zone), grid_of(zone)};
}

// The straight ways that the search may take from wherever a body may be in the fence. What a
// property asks for beyond touching the fence is kept, with room for what the robot strays from a
// way as it sees it. Where it takes over it has as much: the hold leaves room for that along walls
// (docs/templates.md, steering).
bool enters_within(const TakeOver& at, const ir::Recovery& step, ir::ZoneIndex fence) {
  const ir::Body& body = at.decision.body;
  const Asked asked = asked_of(at, fence);
  const std::int64_t strays_mm = beside_leg_mm(at.decision, step);
  const Region rested = common<Region>(held_by_fence(at, fence), [&](const Standoff& held) {
    return centres(at, {held.zone, held.mm + strays_mm});
  });
  // Whoever has as much to spare in the zone keeps that on its ways, and what the zone is farther
  // from the boundary of the fence than is asked besides.
  const std::int64_t deep_mm = depth_mm(at, step.zone, fence, asked.strictest_mm + strays_mm);
  const auto keeps = [&](const Region& bodies, std::int64_t asked_mm) {
    const std::int64_t besides_mm = std::max<std::int64_t>(deep_mm - asked_mm, 0);
    return fits_all(at, step.zone, bodies, std::max<std::int64_t>(strays_mm - besides_mm, 0));
  };
  if (keeps(rested, asked.strictest_mm)) return true;
  if (asked.laxest_mm < 0) return false;  // who sticks out of the fence is not looked at
  const std::int64_t standoff_mm = led_in_mm(asked, [&](std::int64_t mm) {
    return keeps(rested.intersect(centres(at, {fence, mm + strays_mm})), mm);
  });
  geometry::EntryQuery query = straight_ways(at, step, strays_mm);
  query.clearance_mm = in_mm(body.radius_mm + standoff_mm + strays_mm);
  query.body_mm = in_mm(body.radius_mm + asked.laxest_mm + strays_mm);
  // what has no end is not looked at cell by cell, but where what holds meanwhile keeps bodies
  if (is_boundless(at.module[fence])) {
    query.starts = rested;
  }
  return geometry::entry(table_of(at.module[step.zone]), table_of(at.module[fence]), query).how ==
         geometry::Entry::How::within;
}

// In space, past blocks that stand free. Each of the fence is as far off as is asked where the
// robot takes over.
std::optional<std::string> missing_past_blocks(const TakeOver& at, const ir::Recovery& step,
                                               ir::ZoneIndex fence) {
  if (least_asked_mm(at, fence) < 0 || !is_of_places(at.decision.monitors[at.judged].property)) {
    return "";
  }
  std::string missing = missing_off_blocks(at, step.zone, fence, asked_of(at, fence).strictest_mm,
                                           led_in_from(at, step.zone, fence));
  if (missing.empty()) return std::nullopt;
  return missing;
}

// The same of an `or`: the fence is where the centre of a body may be that lies in one of the
// zones. It asks for no more than what the robot strays from a way, and a body in the zone of the
// step has all of its clearance but the radius to its boundary.
bool enters_by_sides(const TakeOver& at, const ir::Recovery& step,
                     const std::vector<ir::ZoneIndex>& zones) {
  constexpr std::int32_t cell_mm = 100;
  constexpr std::int64_t grid_mm = 2;  // what is left out along a boundary that is not on it
  if (at.decision.body.in_space) return false;
  const std::int64_t radius_mm = at.decision.body.radius_mm;
  const auto places = places_of_discs(zones, at.exact, radius_mm);
  const auto snapped = places ? geometry::snap_inside(*places) : std::nullopt;
  if (!snapped) return false;
  const geometry::BakedZone fence = geometry::bake(*snapped, cell_mm);
  const std::int64_t strays_mm = beside_leg_mm(at.decision, step);
  geometry::EntryQuery query = straight_ways(at, step, strays_mm);
  query.clearance_mm = in_mm(strays_mm);
  query.body_mm = in_mm(strays_mm - offsets_round_mm - grid_mm);
  query.depth_mm = -in_mm(radius_mm + offsets_round_mm + grid_mm);
  return geometry::entry(table_of(at.module[step.zone]), {fence.edges, fence.cells}, query).how ==
         geometry::Entry::How::within;
}

}  // namespace

std::optional<std::string> missing_to_come_in(const TakeOver& at, const ir::Recovery& step,
                                              ir::ZoneIndex fence) {
  const ir::ZoneIndex zone = step.zone;
  if (zone == fence) return std::nullopt;
  if (!at.module[fence].has_height()) {
    if (is_convex(at.exact(fence)) || all_within(at, held_by_fence(at, fence), zone)) {
      return std::nullopt;
    }
    if (!at.decision.body.in_space && enters_within(at, step, fence)) return std::nullopt;
    return "";
  }
  const Solid solid = at.solid(fence);
  const bool level = !at.module[zone].has_height();
  const bool one = level || solid.slabs().size() == 1;
  const bool convex = one && std::ranges::all_of(solid.slabs(), [](const geometry::Slab& slab) {
                        return is_convex(slab.region);
                      });
  if (convex || all_within(at, held_by_fence(at, fence), zone)) return std::nullopt;
  return missing_past_blocks(at, step, fence);
}

bool comes_in_within(const TakeOver& at, const ir::Recovery& step, ir::ZoneIndex fence) {
  return !missing_to_come_in(at, step, fence);
}

bool comes_in_by_sides(const TakeOver& at, const ir::Recovery& step,
                       const std::vector<std::vector<ir::ZoneIndex>>& either) {
  const auto straight = [&](const std::vector<ir::ZoneIndex>& zones) {
    return straight_between(zones, at.exact, at.decision.body.radius_mm);
  };
  if (std::ranges::all_of(either, straight) || starts_within(at, step.zone)) return true;
  return std::ranges::all_of(either, [&](const std::vector<ir::ZoneIndex>& zones) {
    return enters_by_sides(at, step, zones);
  });
}

}  // namespace rtac::analysis
