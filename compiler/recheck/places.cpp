// Claims about places: where control is given back, what is seen there, and that ways lead there.
#include <algorithm>
#include <limits>

#include "compiler/recheck/claims.h"
#include "compiler/recheck/company.h"
#include "compiler/recheck/priced.h"
#include "compiler/recheck/return_when.h"
#include "compiler/recheck/sides.h"
#include "compiler/recheck/sight.h"
#include "compiler/recheck/sums.h"
#include "compiler/recheck/told.h"
#include "compiler/recheck/travel.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

using Found = std::optional<Doubt>;

Rational ahead_of(const sema::Spec& spec, const sema::Decision& d, const sema::Monitor& m) {
  return m.ahead.duration ? m.ahead.duration->value : least_ahead(spec, d, m);
}
Rational longest_ahead(const sema::Spec& spec, const sema::Decision& d) {
  Rational ahead = 0;
  for (const sema::MonitorId id : d.priority) {
    if (!spec[id].ahead.waypoints_only) ahead = std::max(ahead, ahead_of(spec, d, spec[id]));
  }
  return ahead;
}
// Of a robot at rest whose monitors look so far ahead.
Rational clear_at_rest(const sema::Spec& spec, const sema::Decision& d, const Rational& ahead) {
  const Numbers n = numbers_of(spec, d, jitter_of(spec, d));
  // a root from below: what is claimed rounds it up
  const Rational accel = n.unicycle ? interp::square_root(n.accel_square).below : n.accel;
  return resting_clearance(n, accel, ahead);
}

}  // namespace

Rational Claims::return_clearance(const sema::Decision& d, sema::ZoneId zone,
                                  const Rational& extra) {
  Rational most = clear_at_rest(spec_, d, extra);
  for (const sema::MonitorId id : d.priority) {
    const sema::Monitor& m = spec_[id];
    const auto own = all_zones(*m.always);
    if (std::find(own.begin(), own.end(), zone) == own.end()) continue;
    // wherever the robot has come to rest
    if (Sides(spec_, d, *this).holds_at_rest(m, extra)) continue;
    most = std::max(most, Rational(return_clearance(d, m, extra) + gap_of(spec_, *m.always, zone)));
  }
  return most;
}

Rational Claims::return_clearance(const sema::Decision& d, const sema::Monitor& m,
                                  const Rational& extra) const {
  return clear_at_rest(spec_, d,
                       (m.ahead.waypoints_only ? Rational(0) : ahead_of(spec_, d, m)) + extra);
}

Rational Claims::leg_clearance(const sema::Decision& d, const sema::Monitor& m,
                               sema::ZoneId zone) const {
  const sema::RobotKind& kind = spec_[d.kind];
  const std::vector<sema::Template> steps = sema::templates_of(spec_[*m.recover]);
  const auto moves = steps.empty() ? std::nullopt : sema::moves_of(steps.back());
  if (!moves) return kind.radius.value;
  // of a sequence, an earlier step may be the one that steers worst
  const bool steers = !kind.in_space && steps.size() == 1;
  return cruising_clearance(numbers_of(spec_, d, jitter_of(spec_, d)), moves->speed,
                            longest_ahead(spec_, d)) +
         (steers ? beside_way(kind, d, moves->speed) : beside_least) +
         gap_of(spec_, *m.always, zone);
}

Rational Claims::leg_in_space(const sema::Decision& d, const Rational& speed) const {
  const Numbers n = numbers_of(spec_, d, jitter_of(spec_, d));
  return cruising_clearance(n, speed, longest_ahead(spec_, d)) + beside_least;
}

// The place of a claim is in the zone, as far from its boundary.
Found Claims::lies_clear(sema::ZoneId zone, const Values& v, std::int64_t gap_mm) {
  const auto x = number(v, "x_mm"), y = number(v, "y_mm"), z = number(v, "z_mm");
  if (!x || !y) return wrong("no such place");
  const Rational near = without_excess(milli(gap_mm));
  const bool clear = z ? zones_.clear_in_space(zone, {milli(*x), milli(*y)}, milli(*z), near)
                       : zones_.clear(zone, {milli(*x), milli(*y)}, near);
  if (!clear) return wrong("the place is nearer to the boundary");
  return std::nullopt;
}

Found Claims::place(const Values& v) {
  const sema::Decision* const d = decision(v);
  const auto zone = zones_.find(text(v, "zone"));
  const auto x = number(v, "x_mm"), y = number(v, "y_mm"), gap = number(v, "clearance_mm");
  const auto extra = number(v, "extra_us");
  if (d == nullptr || !zone || !x || !y || !gap || !extra) {
    return wrong("no such zone or place");
  }
  if (d->period && milli(*gap) < return_clearance(*d, *zone, micro(*extra))) {
    return wrong("a robot at rest with that clearance may not be given back");
  }
  return lies_clear(*zone, v, *gap);
}

// Every `return when` holds there.
Found Claims::returned(const Values& v) {
  const sema::Decision* const d = decision(v);
  const auto x = number(v, "x_mm"), y = number(v, "y_mm"), z = number(v, "z_mm");
  if (d == nullptr || !x || !y) return wrong("no such place");
  const auto height = z ? std::optional(milli(*z)) : std::nullopt;
  for (const sema::MonitorId id : d->priority) {
    if (lets_go_at(spec_, *d, *this, spec_[id], {milli(*x), milli(*y)}, height)) continue;
    return wrong("`return when` of `" + spec_[id].name + "` may not hold there");
  }
  return std::nullopt;
}

Rational Claims::led_to(const sema::Decision& d, const sema::Monitor& driving, sema::ZoneId zone,
                        const Rational& extra) {
  const geometry::Region* const own = zones_.region(zone);
  Rational clear = 0, gap = 0;
  for (const sema::MonitorId id : d.priority) {
    const sema::Monitor& m = spec_[id];
    clear = std::max(clear, return_clearance(d, m, extra));
    for (const sema::ZoneId asked : all_zones(*m.always)) {
      const Rational of = gap_of(spec_, *m.always, asked);
      const geometry::Region* const other = zones_.region(asked);
      if (of <= gap) continue;
      const bool lies =
          asked == zone || (own != nullptr && other != nullptr && other->contains(*own));
      const auto kept = lies && asked != zone ? other->offset(-without_excess(of)) : std::nullopt;
      const bool deep = kept && kept->contains(*own);
      if (lies ? !deep : m.recover == driving.recover) gap = of;
    }
  }
  return clear + gap;
}

Rational Claims::clear_where_led(const sema::Decision& d, sema::ZoneId zone,
                                 const Rational& extra) {
  Rational left = return_clearance(d, zone, extra);
  for (const sema::MonitorId id : d.priority) {
    left = std::max(left, return_clearance(d, spec_[id], extra));
  }
  return left;
}

// Who has come to rest within the zone is where the limits of height of its property let it go.
bool Claims::lets_go_at_height(const sema::Decision& d, const sema::Monitor& m, sema::ZoneId zone) {
  const auto solid = zones_.solid(zone);
  if (zones_.region(zone) != nullptr || !solid || solid->empty()) return true;
  if (Sides(spec_, d, *this).holds_of_slow(spec_[*m.recover], *m.always)) return true;
  const Rational extra = return_extra(spec_, d), left = clear_where_led(d, zone, extra);
  return keeps_heights_inside(spec_, *m.always, true, *solid, left, return_height(d, m, extra));
}

Found Claims::legs(const Values& v) {
  const sema::Decision* const d = decision(v);
  const sema::Monitor* const m = d ? monitor_of(spec_, *d, text(v, "monitor")) : nullptr;
  const auto zone = zones_.find(text(v, "zone"));
  if (m == nullptr || !m->recover || !zone) return wrong("no such zone or monitor");
  const auto within = moves_within(spec_[*m->recover]);
  if (within.empty() || within.back() != *zone) return wrong("the recovery moves elsewhere");
  const auto gap = number(v, "clearance_mm"), aim = number(v, "aim_mm");
  const std::size_t slabs = zones_.slabs(*zone);
  if (!gap || *gap < 0 || !aim || slabs == 0) return wrong("no such clearance, or an unknown zone");
  const auto route = number(v, "route_mm");
  if (route && milli(*route) < leg_clearance(*d, *m, *zone)) return wrong(too_near);
  if (!lets_go_at_height(*d, *m, *zone)) {
    return wrong("it may come to rest at a height where control is not given back");
  }
  const Rational jitter = jitter_of(spec_, *d);
  if (milli(*aim) < milli(*gap) + numbers_of(spec_, *d, jitter).sway) {
    return wrong("at rest beside its aim the robot may be nearer to the boundary");
  }
  // its looks are enough for so many heights (runtime/core/space.cpp, looks_max)
  constexpr std::size_t slabs_max = 6;
  if (slabs > slabs_max) return wrong("more slabs than the recovery looks at");
  for (std::size_t from = 0; from < slabs; ++from) {
    const std::string of = "_" + std::to_string(from);
    const auto to = number(v, "to" + of), z = number(v, "z_mm" + of);
    if (!to || *to < 0) return wrong("one of its slabs leads nowhere");
    const auto target = static_cast<std::size_t>(*to);
    if (!zones_.leads_straight(*zone, from, target, milli(*aim))) {
      return wrong("a slab does not lead straight to that one");
    }
    if (const Found found = in_sight(*d, *zone, target, v)) return found;
    if (z && !zones_.within_slab(*zone, target, milli(*z), milli(*aim))) {
      return wrong("the place does not lie in that slab");
    }
    if (!z && slabs > 1) return wrong("the place has no height");
    Values there = v;
    for (const char* const axis : {"x_mm", "y_mm", "z_mm"}) {
      if (const auto found = v.find(axis + of); found != v.end()) there[axis] = found->second;
    }
    if (const Found found = place(there)) return found;
    if (const Found found = lies_clear(*zone, there, *aim)) return found;
  }
  return std::nullopt;
}

// Of a slab that is convex every place is in sight.
Found Claims::in_sight(const sema::Decision& d, sema::ZoneId zone, std::size_t slab,
                       const Values& v) {
  if (zones_.convex_slab(zone, slab)) return std::nullopt;
  const std::string of = "_of_" + std::to_string(slab);
  const auto cell = number(v, "cell_mm" + of), x = number(v, "cells_x_mm" + of);
  const auto y = number(v, "cells_y_mm" + of), route = number(v, "route_mm");
  const auto aim = number(v, "aim_mm");
  const geometry::Region* const region = zones_.slab(zone, slab);
  if (!cell || !x || !y || !route || !aim || region == nullptr) {
    return wrong("a slab is not convex, and nothing is said of its cells");
  }
  const sema::RobotKind& kind = spec_[d.kind];
  const Rational error = kind.position ? kind.position->error.value : Rational(0);
  const double body = std::max(0.0, Rational(kind.radius.value - error).get_d());
  const auto found =
      out_of_sight(*region, {*cell, *x, *y}, {milli(*aim).get_d(), milli(*route).get_d(), body});
  const auto* const place = std::get_if<std::optional<geometry::Point>>(&found);
  if (place == nullptr) return wrong("the cells are not those of the slab, or too many");
  if (!*place) return std::nullopt;
  return wrong("from (" + to_decimal((*place)->x) + " m, " + to_decimal((*place)->y) +
               " m) no place to return may be in sight");
}

Found Claims::height(const Values& v) {
  const sema::Decision* const d = decision(v);
  const auto z = number(v, "z_mm"), gap = number(v, "gap_mm"), extra = number(v, "extra_us");
  if (d == nullptr || !d->period || !z || !gap || !extra) {
    return wrong("no such decision or height");
  }
  const std::set<std::string> but = names_in(text(v, "but"));
  for (const sema::MonitorId id : d->priority) {
    if (but.contains(spec_[id].name)) continue;  // what inputs alone make true
    const Rational room = return_height(*d, spec_[id], micro(*extra));
    if (sema::speaks_of_height(*spec_[id].always) && milli(*gap) < room) {
      return wrong("a robot at rest with that clearance may not be given back");
    }
    if (keeps_heights(spec_, *spec_[id].always, true, milli(*z), room)) continue;
    return wrong("`" + spec_[id].name + "` needs another height");
  }
  return std::nullopt;
}

// Of a robot at rest there every sample shows, as old as it may be, that it has what is asked for.
Found Claims::seen(const Values& v) {
  const sema::Decision* const d = decision(v);
  const sema::Monitor* const m = d ? monitor_of(spec_, *d, text(v, "monitor")) : nullptr;
  const auto zone = zones_.find(text(v, "zone"));
  const auto gap = number(v, "clearance_mm");
  if (m == nullptr || !zone || !gap) return wrong("no such zone or monitor");
  if (d->period) {
    const Numbers n = numbers_of(spec_, *d, 0);
    const Rational accel =
        (n.unicycle ? interp::square_root(n.accel_square).below : n.accel) + n.disturbance;
    const Rational start = std::min(n.speed, n.velocity_error), age = n.position_age;
    const Rational capped = n.speed - start;  // until it is as fast as can be
    const Rational moved = start + accel * age <= n.speed
                               ? Rational(start * age + accel * age * age / 2)
                               : Rational(n.speed * age - capped * capped / (2 * accel));
    const Rational need =
        n.radius + 2 * n.position_error + moved + gap_of(spec_, *m->always, *zone);
    if (milli(*gap) < need) return wrong("a sample may not show that clearance");
  }
  return lies_clear(*zone, v, *gap);
}

// Whose property only says how high it may be, and leaves that much room where the landing ends,
// whatever inputs ask for.
Found Claims::landing(const Values& v) {
  const sema::Decision* const d = decision(v);
  const sema::Monitor* const m = d ? monitor_of(spec_, *d, text(v, "monitor")) : nullptr;
  const auto end = number(v, "land_mm"), gap = number(v, "gap_mm"), extra = number(v, "extra_us");
  if (m == nullptr || !m->recover || !d->period || !end || !gap || !extra) {
    return wrong("no such monitor or height");
  }
  const std::vector<sema::Template> steps = sema::templates_of(spec_[*m->recover]);
  const auto* const land = steps.empty() ? nullptr : std::get_if<sema::Land>(&steps.back());
  if (land == nullptr || milli(*end) < land->height.value) return wrong("it does not land there");
  if (milli(*gap) < return_height(*d, *m, micro(*extra))) {
    return wrong("a robot at rest with that clearance may not be given back");
  }
  const bool high = !keeps_heights(spec_, *m->always, true, milli(*end), milli(*gap));
  bool elsewhere = !all_zones(*m->always).empty() || judges_robots(spec_, *d, *m->always);
  sema::for_each_expr(*m->always, [&](const sema::Expr& e) {
    const auto* const signal = std::get_if<sema::SignalRef>(&e.node);
    elsewhere = elsewhere || std::holds_alternative<sema::AgentDistance>(e.node) ||
                std::holds_alternative<sema::EnergyTo>(e.node) ||
                (signal != nullptr && signal->signal != sema::Signal::altitude);
  });
  if (high) return wrong("the landing ends too high, or too low");
  if (elsewhere) return wrong("the property asks for more than a height");
  return std::nullopt;
}

// By its error a robot may be seen with less clearance than its body takes, where its monitor asks
// for no more; it takes no detours then, but a leg straight to what legs keep, or to a little more
// than it takes: a way ends short of where it aims, by a measurement.
Found Claims::led_in(const sema::Decision& d, const sema::Monitor& m, sema::ZoneId zone,
                     const Cells& cells, const Rational& route) {
  const sema::RobotKind& kind = spec_[d.kind];
  const Rational error = kind.position ? kind.position->error.value : Rational(0);
  const Rational body = kind.radius.value + sure_gap_of(spec_, *m.always, zone);
  const Rational seen = body - error;
  if (sema::route_of(spec_[*m.recover]) || seen >= kind.radius.value) return std::nullopt;
  const Rational fits =
      std::min(route, Rational(kind.radius.value + error + std::max(error, Rational(2, 100))));
  const auto found =
      without_leg(*zones_.region(zone), cells, std::max(seen, Rational(0)), body, error, fits);
  if (std::holds_alternative<std::monostate>(found)) return std::nullopt;
  return wrong("from where it is seen to be outside no leg leads to where it fits");
}

// Whether a property lets no robot be at a place, which a body of that radius is to be at: who
// comes there is led away by whoever ranks higher.
bool Claims::bars(const sema::Expr& e, const geometry::Point& at, const Rational& radius) {
  if (const auto* logic = std::get_if<sema::Logic>(&e.node)) {
    const auto bar = [&](const sema::ExprPtr& each) { return bars(*each, at, radius); };
    const auto& all = logic->operands;
    if (logic->op == sema::LogicOp::logical_and) return std::ranges::any_of(all, bar);
    return logic->op == sema::LogicOp::logical_or && std::ranges::all_of(all, bar);
  }
  const Rational hardly(2, 1000);
  const auto floor = floor_of(spec_, e);
  return floor && zones_.region(floor->zone) != nullptr &&
         !zones_.clear(floor->zone, at,
                       std::max(Rational(radius + floor->laxest - hardly), Rational(0)));
}

Found Claims::ways(const Values& v) {
  constexpr std::optional<std::int64_t> unlimited_mm = std::numeric_limits<std::int64_t>::max();
  const sema::Decision* const d = decision(v);
  const sema::Monitor* const m = d ? monitor_of(spec_, *d, text(v, "monitor")) : nullptr;
  const auto zone = zones_.find(text(v, "zone"));
  const auto route = number(v, "route_mm"), back = number(v, "return_mm");
  const auto extra = number(v, "extra_us");
  const auto cell = number(v, "cell_mm"), x = number(v, "cells_x_mm"), y = number(v, "cells_y_mm");
  if (m == nullptr || !m->recover || !zone || !route || !back || !extra || !cell || !x || !y) {
    return wrong("no such zone");
  }
  const auto within = moves_within(spec_[*m->recover]);
  if (within.empty() || within.back() != *zone) return wrong("the recovery moves elsewhere");
  const geometry::Region* const region = zones_.region(*zone);
  if (region == nullptr || region->empty()) return Doubt{false, "the zone is not known"};
  // in space errors that last keep the robot off its site by what its hold sways
  const Rational jitter = jitter_of(spec_, *d);
  const Rational off = spec_[d->kind].in_space ? numbers_of(spec_, *d, jitter).sway : Rational(0);
  if (milli(*back) < return_clearance(*d, *zone, micro(*extra)) + off) {
    return wrong("control may not be given back with that clearance");
  }
  if (milli(*route) < leg_clearance(*d, *m, *zone)) return wrong(too_near);
  // farther away than the tables of a zone are exact they bound distances from below alone
  const auto exact = v.count("exact_mm") != 0 ? number(v, "exact_mm") : unlimited_mm;
  if (!exact || *exact < std::max(*back, *route)) {
    return wrong("farther from the boundary than the tables are exact nothing gives control back");
  }
  std::vector<geometry::Point> sites;
  if (const auto way = sema::route_of(spec_[*m->recover])) {
    for (const auto& place : spec_[way->site].places) {
      sites.push_back({place.position.x, place.position.y});
      if (!zones_.clear(*zone, sites.back(), milli(*back))) {
        return wrong("a site of the recovery is nearer to the boundary than control is given back");
      }
      if (place.robot && spec_[*place.robot].kind != d->kind) continue;
      for (const sema::MonitorId higher : d->priority) {
        if (&spec_[higher] == m) break;
        if (spec_[higher].recover != m->recover &&
            bars(*spec_[higher].always, sites.back(), spec_[d->kind].radius.value)) {
          return wrong("a monitor that ranks higher lets none be at a site of the recovery");
        }
      }
    }
  }
  const auto found = without_way(*region, {*cell, *x, *y}, spec_[d->kind].radius.value,
                                 milli(*route), milli(*back), sites);
  if (std::holds_alternative<BadCells>(found)) return wrong("the cells are not those of the zone");
  if (const auto* const from = std::get_if<geometry::Point>(&found)) {
    return wrong("from (" + to_decimal(from->x) + " m, " + to_decimal(from->y) +
                 " m) no way leads back");
  }
  if (auto doubt = check_priced(spec_, *d, *this, *m, *region, {*cell, *x, *y}, milli(*route))) {
    return doubt;
  }
  return led_in(*d, *m, *zone, {*cell, *x, *y}, milli(*route));
}

}  // namespace rtac::recheck
