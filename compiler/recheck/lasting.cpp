#include "compiler/recheck/lasting.h"

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

#include "compiler/recheck/coming_in.h"
#include "compiler/recheck/company.h"
#include "compiler/recheck/coordination.h"
#include "compiler/recheck/numbers.h"
#include "compiler/recheck/return_when.h"
#include "compiler/recheck/sides.h"
#include "compiler/recheck/travel.h"
#include "compiler/recheck/way_legs.h"
#include "compiler/recheck/ways_said.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

// Whether a condition holds only after others have gone away, or inputs have changed. Of an `or`
// the recovery may lead to either side.
bool waits(const sema::Expr& e, bool value) {
  using Op = sema::LogicOp;
  const auto* logic = std::get_if<sema::Logic>(&e.node);
  if (logic == nullptr || logic->op == Op::iff || logic->op == Op::logical_xor) {
    bool others = false;
    sema::for_each_expr(e, [&](const sema::Expr& part) {
      others = others || std::holds_alternative<sema::ForOthers>(part.node) ||
               std::holds_alternative<sema::CountOthers>(part.node) ||
               std::holds_alternative<sema::Distance>(part.node) ||
               std::holds_alternative<sema::AgentDistance>(part.node);
    });
    return others || answers_to_inputs(e);
  }
  const auto of = [&](const sema::ExprPtr& x) { return waits(*x, value); };
  switch (logic->op) {
    case Op::logical_not:
      return waits(*logic->operands[0], !value);
    case Op::implies: {
      const bool first = waits(*logic->operands[0], !value), then = of(logic->operands[1]);
      return value ? first && then : first || then;
    }
    default:
      return (logic->op == Op::logical_and) == value ? std::ranges::any_of(logic->operands, of)
                                                     : std::ranges::all_of(logic->operands, of);
  }
}

// For how long a return condition has to hold.
Rational holds_for(const sema::Expr& condition) {
  Rational sum = 0;
  sema::for_each_expr(condition, [&](const sema::Expr& e) {
    if (const auto* held = std::get_if<sema::HeldFor>(&e.node)) sum += held->duration.value;
    const auto* past = std::get_if<sema::Past>(&e.node);
    if (past == nullptr) return;
    const bool once = past->op == sema::PastOp::once;
    if (once) sum += past->interval.from.value;
    if (!once && past->interval.to) sum += past->interval.to->value;
  });
  return sum;
}

// Legs that are counted; who may be seen with less than its body takes is led in by one more.
struct Legs {
  int count, looks;
  Rational led_in;
};
std::optional<Legs> legs_of(const geometry::Region& zone, const Said& said, const Rational& keeps,
                            const sema::RobotKind& kind, const sema::Template& last,
                            const std::vector<geometry::Point>& sites, const Values& v) {
  const auto count = number(v, "legs"), led_in_mm = number(v, "led_in_mm");
  const auto way_mm = number(v, "way_mm");
  const bool goes_back =
      std::holds_alternative<sema::Retreat>(last) || std::holds_alternative<sema::Loiter>(last);
  if (goes_back != sites.empty() || !count || !way_mm || !led_in_mm || *led_in_mm < 0)
    return std::nullopt;
  const std::vector<Rational> aims = aims_of(said, last);
  const Rational& body = kind.radius.value;
  const auto most = goes_back ? legs_of_ways(zone, said.cells, body, said.route, aims)
                              : legs_to_sites(zone, said.cells, said.route, sites);
  constexpr std::int64_t many = 1'000;
  if (!most || *count > many || *count < std::int64_t(*most) + 1) return std::nullopt;
  Legs legs{static_cast<int>(*count), 1, milli(*led_in_mm)};
  if (!goes_back) return legs;  // it searches from outside, too
  const auto in = led_in(zone, said, kind, last, keeps);
  if (!in) return std::nullopt;
  if (in->all == 0) return legs;
  const Rational in_all = joined_way(milli(*way_mm), milli(said.cells.cell_mm)) + legs.led_in;
  if (in->first > legs.led_in || in->all > in_all) return std::nullopt;
  legs.looks = 2;
  return legs;
}

// Why one of the monitors that a recovery drives for may not let go where it has led.
std::optional<Doubt> ends(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                          const sema::Monitor& monitor, const Rational& left, Rational& after) {
  if (waits(*monitor.always, true)) return wrong("`" + monitor.name + "` waits for others");
  for (const sema::MonitorId id : d.priority) {
    const sema::Monitor& m = spec[id];
    if (m.recover != monitor.recover || m.return_when == nullptr) continue;
    if (waits(*m.return_when, true) || !lets_go(spec, d, claims, m, left)) {
      return wrong("`return when` of `" + m.name + "` may never hold");
    }
    after = std::max(after, holds_for(*m.return_when));
  }
  return std::nullopt;
}

// Whether it takes over in its zone, as far as is known while the charge suffices.
bool begins_within(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                   sema::ZoneId zone) {
  const auto charge = std::ranges::find_if(
      d.priority, [&](sema::MonitorId id) { return sema::speaks_of_charge(*spec[id].always); });
  if (charge == d.priority.end()) return false;
  // it suffices nowhere but in the zone of its ways, or within reach of it
  bool in = false;
  sema::for_each_expr(*spec[*charge].always, [&](const sema::Expr& e) {
    const auto* way = std::get_if<sema::EnergyTo>(&e.node);
    if (way == nullptr) return;
    in = in || std::ranges::any_of(spec.controllers, [&](const sema::Controller& c) {
           const auto route = sema::route_of(c);
           return route && c.kind == d.kind && route->site == way->site && route->zone == zone;
         });
  });
  return in || starts_within(spec, d, claims, spec[*charge], zone);
}

}  // namespace

bool spends_charge(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
                   const sema::Monitor& driving, const sema::Expr& property) {
  if (!spec[decision.kind].energy) return false;
  const auto* logic = std::get_if<sema::Logic>(&property.node);
  if (logic != nullptr && logic->op == sema::LogicOp::logical_and) {
    return std::ranges::any_of(logic->operands, [&](const sema::ExprPtr& each) {
      return spends_charge(spec, decision, claims, driving, *each);
    });
  }
  return sema::speaks_of_charge(property) &&
         !Sides(spec, decision, claims).keeping(spec[*driving.recover], property).by_sides;
}

std::optional<std::string> takes_too_much(const sema::Spec& spec, const sema::Decision& decision,
                                          const Part& part, const sema::Monitor& charge,
                                          const std::string& driving) {
  const auto& energy = spec[decision.kind].energy;
  if (!energy || !charge.recover) return "no charge is declared";
  const auto home = sema::templates_of(spec[*charge.recover]);
  const auto moves = home.empty() ? std::nullopt : sema::moves_of(home.back());
  std::map<std::string, std::pair<Rational, Rational>> most;  // s and m, of each recovery
  for (const Entry& e : part.entries) {
    if (e.kind != "C" || e.monitor != charge.name) continue;
    const bool accepted = std::ranges::any_of(decision.acknowledgements, [&](const auto& a) {
      return spec[a.recovery].name == e.recovery && spec[a.monitor].name == charge.name;
    });
    if (accepted && e.recovery != driving) continue;
    for (const Claim& c : e.claims) {
      const auto held_us = number(c.values, "held_us"), driven_mm = number(c.values, "driven_mm");
      if (c.what != "lasts" || !held_us || !driven_mm) continue;
      const auto of = std::ranges::find(spec.controllers, e.recovery, &sema::Controller::name);
      if (of == spec.controllers.end()) return "there is no such recovery";
      // it leads away, and its robot has to get back
      const bool away = !ends_charged(spec, decision, *of);
      const Rational driven = milli(*driven_mm), back = away ? driven : Rational(0);
      if (back > 0 && (!moves || moves->speed <= 0))
        return "nothing leads back to where it is charged";
      auto& [seconds, metres] = most[e.recovery];
      seconds = std::max(
          seconds,
          Rational(micro(*held_us) + (back > 0 ? Rational(back / moves->speed) : Rational(0))));
      metres = std::max(metres, Rational(driven + back));
    }
  }
  Rational seconds = 0, metres = 0;
  for (const auto& [name, each] : most) seconds += each.first, metres += each.second;
  if (seconds > energy->held.value)
    return "with the ways back other recoveries last longer than `held`";
  if (metres > energy->detour.value)
    return "there and back other recoveries drive further than `detour`";
  return std::nullopt;
}

namespace {

// Who brakes alone is given back at rest, whatever it brakes for.
std::optional<Doubt> check_stopping(const sema::Spec& spec, const sema::Decision& decision,
                                    Claims& claims, const sema::Monitor& monitor,
                                    const Rational& held, const Rational& driven,
                                    const Rational& extra) {
  Rational after = 0;
  for (const sema::MonitorId id : decision.priority) {
    const sema::Monitor& m = spec[id];
    if (m.recover != monitor.recover) continue;
    if (!Sides(spec, decision, claims).holds_in_hold(m, extra)) {
      return wrong("`" + m.name + "` may not be given back at rest");
    }
    if (auto doubt = ends(spec, decision, claims, m, 0, after)) return doubt;
  }
  if (spec[decision.kind].motion.brake.value <= numbers_of(spec, decision, 0).disturbance) {
    return wrong("its brake is too weak for what pushes it");
  }
  const Stop stop = stop_of(spec[decision.kind], decision);
  if (stop.metres > driven) return wrong("it may drive further");
  if (stop.seconds + after > held) return wrong("it may last longer");
  return std::nullopt;
}

}  // namespace

std::optional<Doubt> check_lasting(const sema::Spec& spec, const sema::Decision& decision,
                                   Claims& claims, const sema::Monitor& monitor, const Values& v) {
  const sema::RobotKind& kind = spec[decision.kind];
  const auto held_us = number(v, "held_us"), extra_us = number(v, "extra_us");
  const auto driven_mm = number(v, "driven_mm");
  if (!held_us || !extra_us || !driven_mm) return wrong("a number is missing");
  if (!kind.energy) return wrong("no charge is declared");
  const Rational held = micro(*held_us);
  if (held > kind.energy->held.value) return wrong("it lasts longer than `held`");
  const std::vector<sema::Template> steps = sema::templates_of(spec[*monitor.recover]);
  if (steps.size() == 1 && std::holds_alternative<sema::BrakeAndHold>(steps.front())) {
    return check_stopping(spec, decision, claims, monitor, held, milli(*driven_mm),
                          micro(*extra_us));
  }
  const auto said = said_of(claims, v);
  const auto way_mm = number(v, "way_mm");
  if (!said || !way_mm) return wrong("a number is missing");
  const auto moves = steps.empty() ? std::nullopt : sema::moves_of(steps.back());
  if (!moves || moves->zone != said->zone || std::holds_alternative<sema::Yield>(steps.back())) {
    return wrong("the recovery stands, waits for others, or moves elsewhere");
  }
  const geometry::Region* const zone = claims.zones().region(said->zone);
  if (zone == nullptr || zone->empty()) return Doubt{false, "the zone is not known"};
  if (said->route < claims.leg_clearance(decision, monitor, said->zone)) return wrong(too_near);
  const Rational error = kind.position ? kind.position->error.value : Rational(0);
  const Rational step(1, 1000);  // of the kernel
  const Rational keeps = starts_off(spec, decision, monitor, said->zone);
  if (said->starts > kind.radius.value + keeps + 2 * step) {
    return wrong("it leaves out places that a body fits");
  }
  if (said->back < claims.led_to(decision, monitor, said->zone, micro(*extra_us)) ||
      said->aim < said->back + std::max(Rational(1, 50), error) + error) {
    return wrong("control may not be given back with that clearance");
  }
  if (!begins_within(spec, decision, claims, said->zone)) {
    return wrong("it may begin outside of its zone, from where no way is reckoned");
  }
  Rational after = 0;
  if (auto doubt = ends(spec, decision, claims, monitor, said->back, after)) return doubt;
  const std::vector<geometry::Point> sites = sites_of(spec, steps.back());
  const auto way = longest(*zone, *said, sites, steps.back());
  if (!way || *way > milli(*way_mm)) return wrong("its way may be longer");
  const sema::Controller& recovery = spec[*monitor.recover];
  const Rational cell = milli(said->cells.cell_mm);
  const auto ends_in = [&](const std::optional<Rational>& seconds,
                           const std::optional<Rational>& metres) -> std::optional<Doubt> {
    if (!metres || *metres > milli(*driven_mm)) return wrong("it may drive further");
    if (!seconds || *seconds + after > held) return wrong("it may last longer");
    return std::nullopt;
  };
  if (const auto leg = number(v, "leg_mm")) {
    if (!takes_legs(*zone, *said, kind, steps.back(), milli(*leg))) {
      return wrong("it may take a way over cells, or a longer leg");
    }
    return ends_in(leg_seconds(kind, decision, recovery, milli(*leg)),
                   driven_metres(kind, decision, recovery, std::nullopt, milli(*leg), after));
  }
  if (!v.contains("legs")) {
    return ends_in(return_seconds(kind, decision, recovery, cell, milli(*way_mm)),
                   driven_metres(kind, decision, recovery, cell, milli(*way_mm), after));
  }
  const auto legs = legs_of(*zone, *said, keeps, kind, steps.back(), sites, v);
  if (!legs) return wrong("its way may have more legs, or it may be led in first");
  const Rational in_all = milli(*way_mm) + legs->led_in;
  return ends_in(legs_seconds(kind, decision, recovery, cell, in_all, legs->count + legs->looks - 1,
                              legs->looks),
                 driven_metres(kind, decision, recovery, cell, in_all, after));
}

}  // namespace rtac::recheck
