#include "compiler/recheck/sides.h"

#include <algorithm>
#include <array>

#include "compiler/recheck/at_place.h"
#include "compiler/recheck/at_worst.h"
#include "compiler/recheck/company.h"
#include "compiler/recheck/starts.h"
#include "compiler/recheck/sums.h"
#include "compiler/sema/same.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

// The limit of its own speed that a comparison asks for, which has to be true, or false.
std::optional<LimitOfOne> most_speed(const sema::Spec& spec, const sema::Expr& e, bool value) {
  const auto limit = limit_of_one(spec, e, value);
  const bool is_one = limit && !limit->at_least && limit->of.kind == Measured::Kind::speed;
  return is_one ? limit : std::nullopt;
}

// That one comparison says what the other one denies: `a <= b` and `a > b`, or `b < a`.
bool denies(const sema::Expr& one, const sema::Expr& other) {
  const auto* const a = std::get_if<sema::Compare>(&one.node);
  const auto* const b = std::get_if<sema::Compare>(&other.node);
  if (a == nullptr || b == nullptr) return false;
  using Op = sema::CompareOp;
  // as `low < high`, or `low <= high`
  struct Ordered {
    const sema::Expr *low, *high;
    bool strict;
  };
  const auto ordered = [](const sema::Compare& c) {
    const bool at_most = c.op == Op::less || c.op == Op::less_equal;
    const bool strict = c.op == Op::less || c.op == Op::greater;
    return at_most ? Ordered{c.left.get(), c.right.get(), strict}
                   : Ordered{c.right.get(), c.left.get(), strict};
  };
  const Ordered x = ordered(*a), y = ordered(*b);
  return x.strict != y.strict && sema::same_value(*x.low, *y.high) &&
         sema::same_value(*x.high, *y.low);
}

}  // namespace

Sides::Sides(const sema::Spec& spec, const sema::Decision& decision, Claims& claims)
    : spec_(spec),
      decision_(decision),
      claims_(claims),
      numbers_(numbers_of(spec, decision, jitter_of(spec, decision))) {
  for (const sema::Robot& robot : spec.robots) robots_ += robot.kind == decision.kind ? 1 : 0;
}

// What a negation says of what it negates.
Sides::Part Sides::plain(Part part) {
  for (;;) {
    const auto* logic = std::get_if<sema::Logic>(&part.expr->node);
    if (logic == nullptr || logic->op != sema::LogicOp::logical_not) return part;
    part = {logic->operands[0].get(), !part.value};
  }
}

Sides::Split Sides::split(const Part& part) {
  Split out;
  const auto* logic = std::get_if<sema::Logic>(&part.expr->node);
  if (logic == nullptr) return out;
  using Op = sema::LogicOp;
  const auto add = [&](std::size_t k, bool value) {
    out.parts.push_back(plain({logic->operands[k].get(), value}));
  };
  switch (logic->op) {
    case Op::logical_not:
      return split(plain(part));
    case Op::logical_and:
    case Op::logical_or:
      for (std::size_t k = 0; k < logic->operands.size(); ++k) add(k, part.value);
      (logic->op == Op::logical_and) == part.value ? out.all = true : out.any = true;
      return out;
    case Op::implies:
      add(0, !part.value);
      add(1, part.value);
      part.value ? out.any = true : out.all = true;
      return out;
    case Op::iff:
    case Op::logical_xor:
      return out;
  }
  return out;
}

// What is said of each of the others.
std::optional<Sides::Part> Sides::of_each(const Part& part) {
  const auto* each = std::get_if<sema::ForOthers>(&part.expr->node);
  if (each == nullptr || !each->universal || !part.value) return std::nullopt;
  return plain({each->body.get(), true});
}

bool Sides::speaks_of_inputs(const Part& part) {
  const Split parts = split(part);
  if (!parts.all && !parts.any) return !sema::speaks_of_robot(*part.expr);
  return std::any_of(parts.parts.begin(), parts.parts.end(), speaks_of_inputs);
}

Keeping Sides::keeping(const sema::Controller& recovery, const sema::Expr& property) {
  Keeping asked;
  collect(recovery, plain({&property, true}), false, asked);
  return asked;
}

void Sides::collect(const sema::Controller& recovery, const Part& part, bool either,
                    Keeping& asked) {
  if (const auto body = of_each(part)) return collect(recovery, *body, either, asked);
  const Split parts = split(part);
  if (!parts.all && speaks_of_windows(*part.expr)) {
    asked.windows = true;
    return;
  }
  if (parts.any && !either && is_faster(recovery, part)) asked.faster = true;
  if (parts.any && keeps_a_side(recovery, part, parts)) {
    asked.by_sides = true;
    if (is_slow(recovery, parts)) return;
    asked.either.emplace_back();
    (void)zones_of(part, asked.either.back());
    return;
  }
  if (parts.all || parts.any) {
    for (const Part& each : parts.parts) collect(recovery, each, either || parts.any, asked);
    return;
  }
  for (const sema::ZoneId zone : all_zones(*part.expr)) asked.zones.push_back(zone);
}

bool Sides::is_faster(const sema::Controller& recovery, const Part& part) {
  if (all_zones(*part.expr).empty() || !sema::speaks_of_speed(*part.expr)) return false;
  const auto speed = claimed_speed_of(recovery);
  return !(speed && (slow_side(part, *speed) || slow(part, *speed)));
}

bool Sides::straight_between(const std::vector<std::vector<sema::ZoneId>>& either) {
  return std::ranges::all_of(either, [&](const std::vector<sema::ZoneId>& zones) {
    return claims_.zones().convex_for(zones, numbers_.radius);
  });
}

// A side that asks for no more than to be as slow as the recovery is, from when it stands on.
bool Sides::is_slow(const sema::Controller& recovery, const Split& parts) {
  const auto speed = speed_of(recovery);
  return speed &&
         std::ranges::any_of(parts.parts, [&](const Part& each) { return slow(each, *speed); });
}

// Such a side; or sides of which one holds a disc wherever another one lies in the zone of the
// recovery.
bool Sides::keeps_a_side(const sema::Controller& recovery, const Part& part, const Split& parts) {
  if (is_slow(recovery, parts)) return true;
  std::vector<sema::ZoneId> zones;
  if (!zones_of(part, zones)) return false;
  const auto within = moves_within(recovery);
  return std::all_of(within.begin(), within.end(),
                     [&](sema::ZoneId own) { return one_holds(own, zones, numbers_.radius); });
}

std::optional<Rational> Sides::speed_of(const sema::Controller& recovery) const {
  const std::vector<sema::Template> steps = sema::templates_of(recovery);
  if (steps.empty()) return std::nullopt;
  Rational speed = 0;
  for (const sema::Template& what : steps) {
    if (const auto of = sema::speed_of(what)) speed = std::max(speed, *of);
  }
  return while_driving(speed);
}

Rational Sides::while_driving(const Rational& speed) const {
  const bool in_space = spec_[decision_.kind].in_space;
  const Rational drives = speed == 0 ? speed : fastest_driven(numbers_, in_space, speed);
  return std::min(numbers_.speed, std::max(drives, numbers_.stands));
}

std::optional<Rational> Sides::claimed_speed_of(const sema::Controller& recovery) const {
  if (const auto claim = sema::claim_of(recovery)) return while_driving(claim->speed.value);
  return speed_of(recovery);
}

bool Sides::keeps_limits(const sema::Controller& recovery, const sema::Expr& property,
                         bool taken_over) {
  const auto speed = claimed_speed_of(recovery);
  return speed && within_limits(plain({&property, true}), *speed, taken_over);
}

bool Sides::holds_of_slow(const sema::Controller& recovery, const sema::Expr& property) {
  const auto speed = claimed_speed_of(recovery);
  return speed && slow(plain({&property, true}), *speed);
}

// Wherever the robot is, of agents that are far enough.
bool Sides::holds_far_from_agents(const Part& part) {
  const Split parts = split(part);
  const auto is = [&](const Part& each) { return holds_far_from_agents(each); };
  if (parts.all) return std::ranges::all_of(parts.parts, is);
  if (parts.any) return std::ranges::any_of(parts.parts, is);
  return far_agent(spec_, *part.expr, part.value);
}

// An `or` with zones is kept as the zones say, and one with inputs or agents where another recovery
// takes over.
bool Sides::within_limits(const Part& part, const Rational& speed, bool taken_over) {
  const Split parts = split(part);
  if (parts.all) {
    return std::all_of(parts.parts.begin(), parts.parts.end(),
                       [&](const Part& each) { return within_limits(each, speed, taken_over); });
  }
  if (const auto body = of_each(part)) return within_limits(*body, speed, taken_over);
  if (!parts.any) {
    const bool asks =
        std::holds_alternative<sema::Compare>(part.expr->node) && sema::speaks_of_speed(*part.expr);
    return !asks || slow(part, speed);
  }
  bool limits = false;
  const bool stopped = sema::speaks_of<sema::AgentDistance>(*part.expr) && slow_beside_agents(part);
  bool other = (taken_over && (speaks_of_inputs(part) || holds_far_from_agents(part))) || stopped ||
               !all_zones(*part.expr).empty();
  sema::for_each_expr(*part.expr, [&](const sema::Expr& e) {
    const auto* signal = std::get_if<sema::SignalRef>(&e.node);
    limits = limits || (signal != nullptr && signal->signal == sema::Signal::speed);
    other = other || (signal != nullptr && signal->signal != sema::Signal::speed) ||
            std::holds_alternative<sema::ForOthers>(e.node);
  });
  return !limits || other || keeps_each(part, speed) || slow(part, speed) || slow_side(part, speed);
}

// No limit in it is exceeded, whichever of them counts.
bool Sides::keeps_each(const Part& part, const Rational& speed) {
  const Split parts = split(part);
  if (!parts.all && !parts.any) return !sema::speaks_of_speed(*part.expr) || slow(part, speed);
  return std::all_of(parts.parts.begin(), parts.parts.end(),
                     [&](const Part& each) { return keeps_each(each, speed); });
}

bool Sides::keeps_while_told(const sema::Controller& recovery, const sema::Monitor& m,
                             const Rational& extra) {
  const auto speed = claimed_speed_of(recovery);
  return speed &&
         slow_while_told(plain({m.always.get(), true}), *speed, rests_of(m, extra).from_rest);
}

bool Sides::slow_while_told(const Part& part, const Rational& speed, const Rational& from_rest) {
  if (!sema::speaks_of_robot(*part.expr)) return true;
  const Split parts = split(part);
  const auto is = [&](const Part& each) { return slow_while_told(each, speed, from_rest); };
  if (parts.all) return std::all_of(parts.parts.begin(), parts.parts.end(), is);
  if (!parts.any || !speaks_of_inputs(part)) return slow_side(part, speed);
  return std::all_of(parts.parts.begin(), parts.parts.end(),
                     [&](const Part& each) { return is(each) || waits(each, from_rest); });
}

// A limit of speed that a robot at rest might exceed.
bool Sides::waits(const Part& part, const Rational& from_rest) {
  const Split parts = split(part);
  const auto is = [&](const Part& each) { return waits(each, from_rest); };
  if (parts.all) return std::any_of(parts.parts.begin(), parts.parts.end(), is);
  if (parts.any) return std::all_of(parts.parts.begin(), parts.parts.end(), is);
  const auto most = most_speed(spec_, *part.expr, part.value);
  return most && from_rest > most->bound;
}

// Whatever inputs say: with one of them true and false, until none is left of which it matters.
bool Sides::slow(const Part& part, const Rational& speed) {
  Told told;
  return slow(part, speed, told);
}
bool Sides::slow(const Part& part, const Rational& speed, Told& told) {
  constexpr std::size_t most = 6;  // of twice as many cases each
  const sema::Expr* const open = said_by_inputs(part, told);
  if (open == nullptr) return slow_if(part, speed, told);
  if (told.size() == most) return false;
  const bool all = std::ranges::all_of(std::array{true, false}, [&](bool value) {
    told.emplace_back(open, value);
    const bool is = slow(part, speed, told);
    told.pop_back();
    return is;
  });
  return all;
}
std::optional<bool> Sides::as_told(const Part& part, const Told& told) {
  for (const auto& [expr, value] : told) {
    if (sema::same_value(*expr, *part.expr)) return value == part.value;
    if (denies(*expr, *part.expr)) return value != part.value;
  }
  return std::nullopt;
}
const sema::Expr* Sides::said_by_inputs(const Part& part, const Told& told) {
  const Split parts = split(part);
  if (!parts.all && !parts.any) {
    const bool open = !sema::speaks_of_robot(*part.expr) && !as_told(part, told);
    return open ? part.expr : nullptr;
  }
  for (const Part& each : parts.parts) {
    if (const sema::Expr* const found = said_by_inputs(each, told)) return found;
  }
  return nullptr;
}
bool Sides::slow_if(const Part& part, const Rational& speed, const Told& told) {
  const Split parts = split(part);
  const auto is = [&](const Part& each) { return slow_if(each, speed, told); };
  if (parts.all) return std::ranges::all_of(parts.parts, is);
  if (parts.any) return std::ranges::any_of(parts.parts, is);
  if (const auto said = as_told(part, told)) return *said;
  const auto most = most_speed(spec_, *part.expr, part.value);
  return most && (most->strict ? speed < most->bound : speed <= most->bound);
}

// All of it, or one side of an `or`, asks for no more than to be slow.
bool Sides::slow_side(const Part& part, const Rational& speed) {
  if (const auto body = of_each(part)) return slow_side(*body, speed);
  const Split parts = split(part);
  const auto is = [&](const Part& each) { return slow_side(each, speed); };
  if (parts.all) return std::all_of(parts.parts.begin(), parts.parts.end(), is);
  if (parts.any) return std::any_of(parts.parts.begin(), parts.parts.end(), is);
  return slow(part, speed);
}

bool Sides::zones_of(const Part& part, std::vector<sema::ZoneId>& zones) {
  const Split parts = split(part);
  if (parts.any) {
    return std::all_of(parts.parts.begin(), parts.parts.end(),
                       [&](const Part& each) { return zones_of(each, zones); });
  }
  if (parts.all || !part.value) return false;
  if (const auto* inside = std::get_if<sema::InsideZone>(&part.expr->node)) {
    zones.push_back(inside->zone);
    return true;
  }
  const auto* compare = std::get_if<sema::Compare>(&part.expr->node);
  const auto own = kept_in(spec_, *part.expr);
  if (compare == nullptr || own.size() != 1) return false;
  for (const sema::Expr* side : {compare->left.get(), compare->right.get()}) {
    const auto* least = std::get_if<sema::Constant>(&side->node);
    if (least != nullptr && least->value != 0) return false;
  }
  if (compare->op == sema::CompareOp::greater || compare->op == sema::CompareOp::less) return false;
  zones.push_back(own.front());
  return true;
}

bool Sides::one_holds(sema::ZoneId own, const std::vector<sema::ZoneId>& zones,
                      const Rational& radius) {
  const geometry::Region* const moves = claims_.zones().region(own);
  if (moves == nullptr) return false;
  geometry::Region all;
  // a leg to a way over cells loses 8 mm of the clearance that its robot has
  const Rational kept = radius - Rational(1, 125);
  auto left = moves->offset(offsets_round - std::max(kept, Rational(0)));
  for (const sema::ZoneId zone : zones) {
    const geometry::Region* const region = claims_.zones().region(zone);
    if (region == nullptr || !left) return false;
    all = all.unite(*region);
    const auto near = moves->subtract(*region).offset(radius + offsets_round);
    if (!near) return false;
    left = left->intersect(*near);
  }
  return left && left->empty() && all.contains(*moves);
}

bool Sides::gives_back(const sema::Monitor& m, const Rational& extra) {
  const Back found = back(rests_of(m, extra), plain({m.always.get(), true}), false);
  return found != Back::no && found != Back::slow;
}

bool Sides::holds_at_rest(const sema::Monitor& m, const Rational& extra) {
  return slow_side(plain({m.always.get(), true}), rests_of(m, extra).from_rest);
}

bool Sides::holds_in_hold(const sema::Monitor& m, const Rational& extra) {
  return slow_side(plain({m.always.get(), true}), rests_of(m, extra).from_hold);
}

Rational Sides::fastest_held() const {
  return std::max(numbers_.stands, numbers_.latched);
}

bool Sides::holds_held(const sema::Expr& property) {
  return slow_side(plain({&property, true}), fastest_held());
}

bool Sides::slow_beside_agents(const sema::Expr& property) {
  return slow_beside_agents(plain({&property, true}));
}

bool Sides::slow_beside_agents(const Part& part) {
  const Split parts = split(part);
  if (parts.all) {
    return std::ranges::all_of(parts.parts,
                               [&](const Part& each) { return slow_beside_agents(each); });
  }
  return !sema::speaks_of<sema::AgentDistance>(*part.expr) ||
         (holds_far_from_agents(part) && slow_side(part, fastest_held()));
}

bool Sides::holds_at_rest(const sema::Expr& part, const sema::Monitor& m, const Rational& extra) {
  return slow(plain({&part, true}), rests_of(m, extra).from_rest);
}

bool Sides::is_exceeded_at_rest(const sema::Expr& part, const sema::Monitor& m,
                                const Rational& extra) {
  return waits(plain({&part, true}), rests_of(m, extra).from_rest);
}

Sides::Rests Sides::rests_of(const sema::Monitor& m, const Rational& extra) const {
  Rests rests{m, std::nullopt, 0, 0, 0};
  if (m.recover) {
    const auto within = moves_within(spec_[*m.recover]);
    const auto steps = sema::templates_of(spec_[*m.recover]);
    const bool stands = !steps.empty() && !sema::moves_of(steps.back());
    if (!within.empty() && !stands) rests.own = within.back();
  }
  const bool external = m.recover && sema::templates_of(spec_[*m.recover]).empty();
  const Rational least = numbers_.period * (external ? 2 : 1);
  const Rational ahead = m.ahead.duration ? m.ahead.duration->value : least;
  const Rational horizon = ahead + extra + numbers_.position_age + numbers_.latency +
                           numbers_.jitter + std::max(numbers_.position_age, numbers_.velocity_age);
  // a root from below: a limit that is hardly lower is taken for one that lets go
  const Rational accel =
      numbers_.unicycle ? interp::square_root(numbers_.accel_square).below : numbers_.accel;
  rests.from_rest =
      std::min(numbers_.speed, Rational(2 * numbers_.velocity_error + accel * horizon));
  // pushes and errors that turn around keep who holds a place moving
  rests.from_hold = std::min(numbers_.speed, Rational(rests.from_rest + numbers_.stands));
  rests.extra = extra;
  rests.clearance = claims_.return_clearance(decision_, m, extra);
  return rests;
}

Sides::Back Sides::back(const Rests& rests, const Part& part, bool either) {
  if (!sema::speaks_of_robot(*part.expr)) return Back::told;
  const Split parts = split(part);
  // where it leads to they do not matter (5030)
  if (!parts.all && speaks_of_windows(*part.expr)) return Back::yes;
  if (!parts.all && !parts.any) return back_of_leaf(rests, part, either);
  std::vector<Back> found;
  for (const Part& each : parts.parts) found.push_back(back(rests, each, either || parts.any));
  const auto some = [&](Back one) {
    return std::find(found.begin(), found.end(), one) != found.end();
  };
  if (parts.all) {
    for (const Back worst : {Back::no, Back::slow, Back::until_told}) {
      if (some(worst)) return worst;
    }
    return Back::yes;
  }
  const bool slow_enough = std::ranges::any_of(
      parts.parts, [&](const Part& each) { return slow(each, rests.from_hold); });
  if (slow_enough) return Back::yes;
  // what is told may keep its own side from holding for ever
  if (speaks_of_inputs(part) ? !some(Back::no) : some(Back::yes)) {
    const bool waits = some(Back::slow) || some(Back::until_told);
    const bool goes_on = some(Back::yes) || some(Back::told) || some(Back::until_told);
    if (!waits || !speaks_of_inputs(part)) return Back::yes;
    return goes_on ? Back::until_told : Back::slow;
  }
  std::vector<sema::ZoneId> zones;
  const bool covered =
      rests.own && zones_of(part, zones) && one_holds(*rests.own, zones, rests.clearance);
  return covered ? Back::yes : Back::no;
}

// The more charge there is, and the less the way takes, the better.
bool Sides::asks_for_charge(const Part& part) const {
  const auto sum = excess(spec_, *part.expr);
  if (!sum) return false;
  return std::ranges::all_of(sum->terms, [&](const auto& term) {
    const auto& [of, by] = term;
    if (of.kind == Measured::Kind::battery) return (by > 0) == part.value;
    return of.kind == Measured::Kind::energy_to && (by < 0) == part.value;
  });
}

Sides::Back Sides::back_of_leaf(const Rests& rests, const Part& part, bool either) {
  if (const auto* others = std::get_if<sema::ForOthers>(&part.expr->node)) {
    // of all others, where there is none; that there is one never holds then
    return robots_ < 2 && others->universal == part.value ? Back::yes : Back::no;
  }
  if (sema::speaks_of<sema::CountOthers>(*part.expr) && robots_ > 1) return Back::no;
  if (const auto most = most_speed(spec_, *part.expr, part.value)) {
    return rests.from_hold <= most->bound ? Back::yes : Back::slow;
  }
  if (sema::speaks_of_speed(*part.expr)) return Back::no;  // no limit: not known at rest
  const bool high = sema::speaks_of_height(*part.expr);
  const auto zones = all_zones(*part.expr);
  if (sema::speaks_of_charge(*part.expr)) {
    const auto& recover = rests.monitor.recover;
    const bool charged = recover && ends_charged(spec_, decision_, spec_[*recover]);
    return charged && asks_for_charge(part) ? Back::yes : Back::no;
  }
  if (zones.empty() && !high) return Back::yes;
  if (!rests.own) return Back::no;  // it stands, wherever that is
  if (high) {
    const auto solid = claims_.zones().solid(*rests.own);
    if (!solid || solid->slabs().empty()) return Back::no;
    const Rational left = claims_.clear_where_led(decision_, *rests.own, rests.extra);
    const Rational gap = claims_.return_height(decision_, rests.monitor, rests.extra);
    return keeps_heights_inside(spec_, *part.expr, part.value, *solid, left, gap) ? Back::yes
                                                                                  : Back::no;
  }
  // who keeps its height leads to no other, near floor or ceiling as well
  const bool level = claims_.zones().region(*rests.own) != nullptr;
  const bool beyond = level && std::ranges::any_of(zones, [&](sema::ZoneId zone) {
                        return claims_.zones().region(zone) == nullptr;
                      });
  if (beyond) return Back::no;
  if (!either && part.value) return Back::yes;
  return std::all_of(zones.begin(), zones.end(),
                     [&](sema::ZoneId zone) {
                       const auto in = claims_.zones().solid(*rests.own);
                       const auto out = claims_.zones().solid(zone);
                       return *rests.own == zone || (in && out && in->subtract(*out).empty());
                     })
             ? Back::yes
             : Back::no;
}

bool too_fast_at_rest(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
                      const sema::Monitor& m) {
  return Sides(spec, decision, claims)
      .is_exceeded_at_rest(*m.always, m, return_extra(spec, decision));
}

}  // namespace rtac::recheck
