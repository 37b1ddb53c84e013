#include "compiler/recheck/coming_in.h"

#include <algorithm>
#include <variant>

#include "compiler/recheck/entering.h"
#include "compiler/recheck/free_blocks.h"
#include "compiler/recheck/starts.h"
#include "compiler/recheck/travel.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

using Either = std::vector<Held>;

std::optional<Rational> least_of(const sema::Spec& spec, const sema::Expr& e) {
  if (const auto* constant = std::get_if<sema::Constant>(&e.node)) return constant->value;
  if (const auto* param = std::get_if<sema::ParamRef>(&e.node)) {
    return spec[param->param].least.value;
  }
  return std::nullopt;
}

// What is known of a zone where the expression has that value.
std::optional<Held> held_by(const sema::Spec& spec, const sema::Expr& e, bool value) {
  const auto* inside = std::get_if<sema::InsideZone>(&e.node);
  if (inside != nullptr && value) return Held{inside->zone, 0};
  const auto* compare = std::get_if<sema::Compare>(&e.node);
  if (compare == nullptr) return std::nullopt;
  using Op = sema::CompareOp;
  const bool above = compare->op == Op::greater || compare->op == Op::greater_equal;
  if (!above && compare->op != Op::less && compare->op != Op::less_equal) return std::nullopt;
  const bool at_least = above == value;
  const auto* gap =
      std::get_if<sema::Clearance>(at_least ? &compare->left->node : &compare->right->node);
  const auto least = least_of(spec, at_least ? *compare->right : *compare->left);
  if (gap == nullptr || !least || *least < 0) return std::nullopt;
  return Held{gap->zone, *least};
}

// The parts of which all have to have a value, or any.
struct Operands {
  bool all = false, any = false;
  std::vector<std::pair<const sema::Expr*, bool>> of;
};
Operands operands_of(const sema::Expr& e, bool value) {
  Operands parts;
  const auto* logic = std::get_if<sema::Logic>(&e.node);
  if (logic == nullptr) return parts;
  using Op = sema::LogicOp;
  const bool implies = logic->op == Op::implies;
  if (logic->op != Op::logical_and && logic->op != Op::logical_or && logic->op != Op::logical_not &&
      !implies) {
    return parts;
  }
  for (const sema::ExprPtr& each : logic->operands) {
    const bool negated = logic->op == Op::logical_not || (implies && parts.of.empty());
    parts.of.emplace_back(each.get(), value != negated);
  }
  parts.all = logic->op == Op::logical_not || (logic->op == Op::logical_and) == value;
  parts.any = !parts.all;
  return parts;
}

// False: a side of an `or` may hold wherever the robot is.
bool sides_of(const sema::Spec& spec, const sema::Expr& e, bool value, Either& sides) {
  const Operands parts = operands_of(e, value);
  if (parts.any || parts.of.size() == 1) {
    return std::ranges::all_of(parts.of, [&](const auto& part) {
      return sides_of(spec, *part.first, part.second, sides);
    });
  }
  const auto held = held_by(spec, e, value);
  if (held) sides.push_back(*held);
  return held.has_value();
}
void collect(const sema::Spec& spec, const sema::Expr& e, bool value, std::vector<Either>& all) {
  const Operands parts = operands_of(e, value);
  if (parts.all) {
    for (const auto& [part, wanted] : parts.of) collect(spec, *part, wanted, all);
    return;
  }
  Either sides;
  if (sides_of(spec, e, value, sides)) all.push_back(std::move(sides));
}

}  // namespace

std::vector<std::vector<Held>> held_in(const sema::Spec& spec, const sema::Expr& property) {
  std::vector<Either> all;
  collect(spec, property, true, all);
  return all;
}

bool relied_on(const sema::Spec& spec, const sema::Decision& d, const sema::Monitor& m) {
  const bool looks = !m.ahead.duration || m.ahead.duration->value >= least_ahead(spec, d, m);
  return looks && !m.ahead.waypoints_only &&
         std::ranges::none_of(d.acknowledgements, [&](const sema::Acknowledgement& a) {
           return &spec[a.monitor] == &m;
         });
}

namespace {

std::vector<Either> held_at(const sema::Spec& spec, const sema::Decision& d,
                            const sema::Monitor& judged) {
  std::vector<Either> all;
  for (const sema::MonitorId id : d.priority) {
    if (&spec[id] != &judged && !relied_on(spec, d, spec[id])) continue;
    collect(spec, *spec[id].always, true, all);
  }
  return all;
}

// Whether it says anything of speed, charge or others, which change on the way or of themselves.
bool speaks_of_more(const sema::Expr& e) {
  return sema::speaks_of_speed(e) || sema::speaks_of_charge(e) ||
         sema::speaks_of<sema::EnergyTo>(e) || sema::speaks_of<sema::Distance>(e) ||
         sema::speaks_of<sema::AgentDistance>(e) || sema::speaks_of<sema::ForOthers>(e) ||
         sema::speaks_of<sema::CountOthers>(e) || sema::speaks_of<sema::OverMembers>(e);
}
// What each comparison that speaks of the fence asks of it; less than 0 of what is not read.
void collect_said(const sema::Spec& spec, const sema::Expr& e, bool value, sema::ZoneId fence,
                  std::vector<Rational>& all) {
  const Operands parts = operands_of(e, value);
  for (const auto& [part, wanted] : parts.of) collect_said(spec, *part, wanted, fence, all);
  if (!parts.of.empty() || std::ranges::count(all_zones(e), fence) == 0) return;
  const auto held = held_by(spec, e, value);
  all.push_back(held ? held->gap : Rational(-1));
}
// The least of these: below 0 bodies may stick out of the fence, or that is not known.
Rational least_said(const sema::Spec& spec, const sema::Expr& property, sema::ZoneId fence) {
  std::vector<Rational> all;
  collect_said(spec, property, true, fence, all);
  return all.empty() ? Rational(-1) : *std::ranges::min_element(all);
}
// Where a property that has several sides holds by what it says of the fence; by another side of an
// `or`, the way has nothing to keep of that, and the recovery leads there.
std::vector<Either> held_by_fence(const sema::Spec& spec, const sema::Decision& d,
                                  const sema::Monitor& judged, sema::ZoneId fence) {
  std::vector<Either> all = held_at(spec, d, judged);
  const Rational least = least_said(spec, *judged.always, fence);
  if (least >= 0 && !speaks_of_more(*judged.always)) all.push_back({{fence, least}});
  return all;
}

// What is left of a zone so far inside; of one of the plane no less up and down.
geometry::Solid within(NamedZones& zones, sema::ZoneId zone, const Rational& by) {
  const auto solid = zones.solid(zone);
  if (!solid) return geometry::Solid::everywhere();
  return solid->shrink(by, zones.region(zone) != nullptr ? Rational(0) : by);
}

// The same of balls, which come nearer to edges: no place that keeps so far off is left out.
geometry::Solid kept_by_balls(NamedZones& zones, sema::ZoneId zone, const Rational& by) {
  const auto solid = zones.solid(zone);
  if (!solid || zones.region(zone) != nullptr) return within(zones, zone, by);
  return solid->shrink_by_ball(by);
}

// Where the centre of a body may be while those of `held` are kept; with no body, or one that may
// stick out of them, all of these zones.
geometry::Solid where_held(NamedZones& zones, const std::vector<Either>& held,
                           const std::optional<Rational>& radius) {
  geometry::Solid starts = geometry::Solid::everywhere();
  for (const Either& sides : held) {
    geometry::Solid some;
    for (const Held& each : sides) {
      some = some.unite(radius ? kept_by_balls(zones, each.zone, *radius + each.gap)
                               : within(zones, each.zone, 0));
    }
    starts = starts.intersect(some);
  }
  return starts;
}

// Of numbers that the compiler rounds up to millimetres, m.
const Rational rounding(4, 1000);

// Where bodies may be that are kept so, and do not lie in the zone: they reach beyond it.
geometry::Solid held_outside(NamedZones& zones, const std::vector<Either>& held, sema::ZoneId zone,
                             const Rational& radius) {
  const Rational body = std::max(Rational(radius - offsets_round), Rational(0));
  geometry::Solid outside = where_held(zones, held, radius).subtract(within(zones, zone, body));
  if (outside.empty()) return outside;
  const Rational reach = radius + offsets_round;
  return outside.intersect(
      where_held(zones, held, std::nullopt).subtract(within(zones, zone, 0)).grow(reach, reach));
}

bool all_within(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                const std::vector<Either>& held, sema::ZoneId zone) {
  const auto is_zone = [&](const Either& e) { return e.size() == 1 && e[0].zone == zone; };
  if (std::ranges::any_of(held, is_zone)) return true;
  NamedZones& zones = claims.zones();
  if (!zones.solid(zone)) return false;
  const Rational radius = spec[d.kind].radius.value;
  return held_outside(zones, held, zone, radius).empty();
}

}  // namespace

bool starts_within(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                   const sema::Monitor& judged, sema::ZoneId zone) {
  return all_within(spec, d, claims, held_at(spec, d, judged), zone);
}

namespace {

// What recoveries lead the robots of a decision within a zone: whether some do over cells, or
// straight back, and how far beside its leg the one comes that is led best.
struct Led {
  bool over_cells = false, goes_back = false;
  Rational beside = beside_least;
};
Led led_within(const sema::Spec& spec, const sema::Decision& d, sema::ZoneId zone) {
  Led all;
  std::optional<Rational> beside;
  for (const sema::MonitorId id : d.priority) {
    if (!spec[id].recover) continue;
    for (const sema::Template& what : sema::templates_of(spec[*spec[id].recover])) {
      const auto moves = sema::moves_of(what);
      if (!moves || moves->zone != zone) continue;
      const bool over =
          std::holds_alternative<sema::Route>(what) || std::holds_alternative<sema::Yield>(what);
      (over ? all.over_cells : all.goes_back) = true;
      const Rational strays = beside_way(spec[d.kind], d, moves->speed);
      beside = beside ? std::min(*beside, strays) : strays;
    }
  }
  if (beside) all.beside = *beside;
  return all;
}

const Rational millimetre(1, 1000);
// Between the two, of which it is so of the least, and up to some: the highest of these, at most a
// millimetre too low.
template <class Is>
Rational highest(Rational low, Rational high, const Is& is) {
  while (high - low > millimetre) {
    const Rational middle = (low + high) / 2;
    (is(middle) ? low : high) = middle;
  }
  return low;
}

// How far from the boundary of the fence bodies have to be, beyond touching it, where parameters
// are laxest and where they are strictest, and something is said of the fence. `kept`: as much as
// they ask is all that is said of it, of every body.
struct Off {
  Rational laxest = 0, strictest = 0;
  bool kept = false;
};
Off off_of(const sema::Spec& spec, const sema::Expr& property, sema::ZoneId fence) {
  std::vector<Either> holds;
  collect(spec, property, true, holds);
  Off off;
  off.strictest = gap_of(spec, property, fence);
  off.laxest = least_said(spec, property, fence);
  std::ptrdiff_t sure = 0, said = 0;
  for (const Either& sides : holds) {
    if (sides.size() != 1 || sides[0].zone != fence) continue;
    off.laxest = std::max(off.laxest, sides[0].gap);
    ++sure;
  }
  sema::for_each_expr(property, [&](const sema::Expr& e) {
    const auto* gap = std::get_if<sema::Clearance>(&e.node);
    const auto* inside = std::get_if<sema::InsideZone>(&e.node);
    if ((gap != nullptr && gap->zone == fence) || (inside != nullptr && inside->zone == fence)) {
      ++said;
    }
  });
  off.kept = sure == said;
  return off;
}

// A way into a zone in a fence, which a body of that radius strays from by so much.
struct WayIn {
  sema::ZoneId zone, fence;
  Rational radius, strays;
};
// How far off the fence the strictest parameters ask for with which somebody is led into the zone;
// nullopt: with all of them everybody is there and has to spare what it strays, or so much less as
// all of the zone is farther from the fence than that.
std::optional<Rational> strictest_led(NamedZones& zones, const WayIn& way,
                                      const geometry::Solid& starts, const Off& off) {
  const auto is_deep = [&](const Rational& by) {
    return within(zones, way.zone, 0).subtract(within(zones, way.fence, by)).empty();
  };
  const Rational depth = highest(0, off.strictest + way.strays, is_deep);
  const auto all_keep = [&](const geometry::Solid& bodies, const Rational& asked) {
    const Rational besides = std::max(Rational(depth - asked), Rational(0));
    const Rational spare = std::max(Rational(way.strays - besides), Rational(0));
    const Rational fits = std::max(Rational(way.radius + spare - offsets_round), Rational(0));
    return bodies.subtract(within(zones, way.zone, fits)).empty();
  };
  if (all_keep(starts, off.strictest)) return std::nullopt;
  const auto leads_some = [&](const Rational& gap) {
    const auto kept = within(zones, way.fence, way.radius + gap + way.strays);
    return !all_keep(starts.intersect(kept), gap);
  };
  const bool some_keep = off.kept && off.strictest > off.laxest && !leads_some(off.strictest);
  return some_keep ? Rational(highest(off.laxest, off.strictest, leads_some) + millimetre)
                   : off.strictest;
}

// In the plane, cell by cell: each straight way that the recovery may take. Whoever recovers within
// that zone loses no more than ways over cells do. nullopt: what is claimed says too little.
struct StraightWays {
  Cells cells;
  Rational strays;  // a way is driven as it is seen, and not on the millimetre
  EnteringLimits limits;
};
std::optional<StraightWays> straight_ways(const sema::Spec& spec, const sema::Decision& d,
                                          Claims& claims, sema::ZoneId zone, const Values& v) {
  const sema::RobotKind& kind = spec[d.kind];
  const auto cell = number(v, "cell_mm"), x = number(v, "cells_x_mm"), y = number(v, "cells_y_mm"),
             aim_mm = number(v, "aim_mm");
  if (kind.in_space || !cell || !x || !y || !aim_mm) return std::nullopt;
  const Led led = led_within(spec, d, zone);
  const Rational error = kind.position ? kind.position->error.value : Rational(0);
  const Rational strays = error + led.beside - rounding, aim = milli(*aim_mm);
  const double radius = kind.radius.value.get_d();
  EnteringLimits limits{0,
                        0,
                        radius,
                        led.over_cells ? std::max(radius, aim.get_d()) : 0,
                        radius + strays.get_d(),
                        led.over_cells ? 0.008 : 0.002};
  if (led.goes_back) {
    // it looks for the clearance of return, or at least for the body and what its ways end short by
    constexpr double short_by = 0.02;
    const Rational back = claims.return_clearance(d, zone, 0);
    if (!led.over_cells && aim < back) return std::nullopt;
    limits.straight_least = std::max(radius, std::min(back.get_d(), radius + short_by));
    limits.straight_most = std::max(limits.straight_least, aim.get_d());
  }
  const auto robots = std::ranges::count_if(
      spec.robots, [&](const sema::Robot& robot) { return robot.kind == d.kind; });
  if (robots == 1 && aim >= kind.radius.value) {
    const double width = milli(*cell).get_d();
    const double reach = led.over_cells ? std::max(0.4, 2 * width) + width : 0;
    limits.alone = {aim.get_d(), reach};
  }
  return StraightWays{{*cell, *x, *y}, strays, limits};
}
bool stay_within(Claims& claims, const geometry::Region& zone, const geometry::Region& fence,
                 const StraightWays& ways) {
  const auto found = enters_beyond(zone, ways.cells, fence, ways.limits);
  const auto* const bad = std::get_if<BadCells>(&found);
  if (bad != nullptr && bad->too_many) claims.give_up();
  const auto* const place = std::get_if<std::optional<geometry::Point>>(&found);
  return place != nullptr && !place->has_value();
}

bool enters_within(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                   const sema::Monitor& judged, sema::ZoneId zone, sema::ZoneId fence,
                   const Values& v) {
  const geometry::Region *const inner = claims.zones().region(zone), *const outer =
                                                                         claims.zones().region(
                                                                             fence);
  auto ways = straight_ways(spec, d, claims, zone, v);
  if (inner == nullptr || outer == nullptr || inner->empty() || !ways) return false;
  // the hold leaves as much room at rest
  const Rational& radius = spec[d.kind].radius.value;
  const Off off = off_of(spec, *judged.always, fence);
  const geometry::Solid starts =
      where_held(claims.zones(), held_by_fence(spec, d, judged, fence), radius + ways->strays);
  const auto led_by =
      strictest_led(claims.zones(), {zone, fence, radius, ways->strays}, starts, off);
  if (!led_by) return true;
  if (off.laxest < 0) return false;  // who sticks out of the fence is not looked at
  ways->limits.clearance = Rational(radius + *led_by + ways->strays).get_d();
  ways->limits.body = Rational(radius + off.laxest + ways->strays).get_d();
  if (!has_end(*outer)) {
    if (starts.empty()) return true;
    for (const geometry::Slab& slab : starts.slabs()) {
      if (!has_end(slab.region)) return false;
      ways->limits.starts.push_back(slab.region);
    }
    ways->limits.starts_off = offsets_round.get_d();
  }
  return stay_within(claims, *inner, *outer, *ways);
}

// Of an `or` the fence is where the centre of a body in one of its zones may be, which the zone of
// the recovery reaches beyond by the body.
bool enters_by_sides(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                     sema::ZoneId zone, const std::vector<sema::ZoneId>& sides, const Values& v) {
  const geometry::Region* const inner = claims.zones().region(zone);
  auto ways = straight_ways(spec, d, claims, zone, v);
  if (inner == nullptr || inner->empty() || !ways) return false;
  const Rational& radius = spec[d.kind].radius.value;
  geometry::Region places;
  for (const sema::ZoneId side : sides) {
    const geometry::Region* const all = claims.zones().region(side);
    const auto of_bodies = all != nullptr ? all->offset(-radius) : std::nullopt;
    if (!of_bodies) return false;
    places = places.unite(*of_bodies);
  }
  if (places.empty() || !has_end(places)) return false;
  ways->limits.clearance = ways->strays.get_d();
  ways->limits.body = std::max(Rational(ways->strays - offsets_round), Rational(0)).get_d();
  ways->limits.depth = -Rational(radius + offsets_round).get_d();
  return stay_within(claims, *inner, places, *ways);
}

// In space, past blocks that stand free, which are as far off as is asked where it sets out.
bool enters_past_blocks(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                        const sema::Monitor& judged, sema::ZoneId zone, sema::ZoneId fence) {
  NamedZones& zones = claims.zones();
  const auto inner = zones.solid(zone), outer = zones.solid(fence);
  if (zones.region(zone) != nullptr || !inner || !outer) return false;
  if (least_said(spec, *judged.always, fence) < 0 || speaks_of_more(*judged.always)) return false;
  // what asks for more before it gives back, or moves there otherwise, may look for more
  const auto may_look_for_more = [&](const sema::Template& what) {
    const auto moves = sema::moves_of(what);
    return moves && moves->zone == zone && !std::holds_alternative<sema::Retreat>(what) &&
           !std::holds_alternative<sema::Loiter>(what);
  };
  for (const sema::MonitorId id : d.priority) {
    if (spec[id].return_when) return false;
    if (!spec[id].recover) continue;
    const sema::Controller& recovery = spec[*spec[id].recover];
    if (sema::claim_of(recovery) ||
        std::ranges::any_of(sema::templates_of(recovery), may_look_for_more)) {
      return false;
    }
  }
  const Rational sway = numbers_of(spec, d, jitter_of(spec, d)).sway;
  const FreeRoom room{spec[d.kind].radius.value, gap_of(spec, *judged.always, fence),
                      claims.return_clearance(d, zone, return_extra(spec, d)) + sway};
  return beside_free_blocks(
      *inner, *outer, room,
      held_outside(zones, held_by_fence(spec, d, judged, fence), zone, room.radius));
}

}  // namespace

bool comes_in_within(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                     const sema::Monitor& judged, sema::ZoneId zone, sema::ZoneId fence,
                     const Values& v) {
  if (zone == fence) return true;
  const bool level = claims.zones().region(zone) != nullptr;
  return claims.zones().convex(fence, level) ||
         all_within(spec, d, claims, held_by_fence(spec, d, judged, fence), zone) ||
         enters_past_blocks(spec, d, claims, judged, zone, fence) ||
         enters_within(spec, d, claims, judged, zone, fence, v);
}

bool comes_in_by_sides(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                       const sema::Monitor& judged, sema::ZoneId zone,
                       const std::vector<std::vector<sema::ZoneId>>& either, const Values& v) {
  return starts_within(spec, d, claims, judged, zone) ||
         std::ranges::all_of(either, [&](const std::vector<sema::ZoneId>& sides) {
           return enters_by_sides(spec, d, claims, zone, sides, v);
         });
}

bool lies_level(Claims& claims, sema::ZoneId inner, sema::ZoneId outer, const Rational& off) {
  const geometry::Region* const flat = claims.zones().region(inner);
  const auto high = claims.zones().solid(outer);
  if (flat == nullptr || claims.zones().region(outer) != nullptr || !high) return false;
  return std::ranges::all_of(high->slabs(), [&](const geometry::Slab& slab) {
    const auto kept = slab.region.offset(-off);
    return kept && kept->contains(*flat);
  });
}

namespace {

// Who goes back in a prism is led off its floor, or its ceiling, by no more than the clearance that
// it looks for and as far as it strays, and keeps its height in between. nullopt: that is not
// known.
std::optional<Rational> led_off_ends(const sema::Spec& spec, const sema::Decision& d,
                                     const Claims& claims, const sema::Controller& recovery,
                                     sema::ZoneId zone) {
  bool loiters = false;
  Rational fastest = 0;
  for (const sema::Template& what : sema::templates_of(recovery)) {
    fastest = std::max(fastest, sema::speed_of(what).value_or(Rational(0)));
    const auto moves = sema::moves_of(what);
    if (!moves || moves->zone != zone) continue;
    if (std::holds_alternative<sema::Loiter>(what)) {
      loiters = true;
    } else if (!std::holds_alternative<sema::Retreat>(what)) {
      return std::nullopt;
    }
  }
  if (sema::claim_of(recovery)) return std::nullopt;
  Rational back = 0, gap = 0;
  for (const sema::MonitorId id : d.priority) {
    const sema::Monitor& m = spec[id];
    if (m.return_when) return std::nullopt;
    back = std::max(back, claims.return_clearance(d, m, return_extra(spec, d)));
    for (const sema::ZoneId each : all_zones(*m.always)) {
      gap = std::max(gap, gap_of(spec, *m.always, each));
    }
  }
  const Numbers n = numbers_of(spec, d, jitter_of(spec, d));
  const Rational leg = claims.leg_in_space(d, fastest) + gap;
  const Rational lap(1, 2), strays = leg - n.radius;
  const Rational looks_for =
      std::max(Rational(back + gap), leg) + n.sway +
      (loiters ? Rational(n.sway + 2 * n.position_error + lap) : Rational(0));
  return looks_for + strays;
}

}  // namespace

bool keeps_its_heights(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                       const sema::Controller& recovery, const sema::Expr& property) {
  const Rational jitter = jitter_of(spec, d);
  const Rational sway = numbers_of(spec, d, jitter).sway;
  for (const sema::Template& what : sema::templates_of(recovery)) {
    const auto* land = std::get_if<sema::Land>(&what);
    // it leads down, and holds who is lower
    if (land != nullptr &&
        !keeps_heights(spec, property, true, land->height.value, sway, Heights::from_below)) {
      return false;
    }
  }
  const bool claimed = sema::claim_of(recovery).has_value();
  for (const sema::ZoneId zone : moves_within(recovery)) {
    const bool flat = claims.zones().region(zone) != nullptr;
    if (flat && !claimed) continue;  // it keeps its height
    const auto solid = claims.zones().solid(zone);
    if (!solid || solid->empty()) return false;
    const Rational &low = solid->slabs().front().floor, &high = solid->slabs().back().ceiling;
    const auto led =
        solid->slabs().size() == 1 ? led_off_ends(spec, d, claims, recovery, zone) : std::nullopt;
    const bool up =
        keeps_heights(spec, property, true, high, 0, Heights::from_above) ||
        (led && keeps_heights(spec, property, true, low + *led, 0, Heights::from_above));
    const bool down =
        keeps_heights(spec, property, true, low, 0, Heights::from_below) ||
        (led && keeps_heights(spec, property, true, high - *led, 0, Heights::from_below));
    if (!up || !down) return false;
  }
  return true;
}

bool comes_down_within(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                       const sema::Controller& recovery, const sema::Expr& property,
                       sema::ZoneId zone) {
  if (claims.zones().region(zone) != nullptr) return true;  // at each height
  // as it is seen to hold its place there, or another monitor has it led up again
  const Numbers numbers = numbers_of(spec, d, jitter_of(spec, d));
  const Rational margin =
      numbers.radius + gap_of(spec, property, zone) + 2 * numbers.position_error + numbers.hold;
  for (const sema::Template& what : sema::templates_of(recovery)) {
    const auto* land = std::get_if<sema::Land>(&what);
    if (land == nullptr) continue;
    const auto solid = claims.zones().solid(zone);
    if (!solid) return false;
    const auto& slabs = solid->slabs();
    const Rational reach = land->height.value - margin;
    auto lower = std::ranges::find_if(
        slabs, [&](const geometry::Slab& s) { return s.floor <= reach && reach < s.ceiling; });
    if (lower == slabs.end()) return false;
    for (auto upper = std::next(lower); upper != slabs.end(); lower = upper++) {
      if (lower->ceiling != upper->floor || !lower->region.contains(upper->region)) return false;
    }
  }
  return true;
}

}  // namespace rtac::recheck
