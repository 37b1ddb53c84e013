#include "compiler/recheck/turns.h"

#include <algorithm>
#include <array>
#include <variant>

#include "compiler/recheck/at_worst.h"
#include "compiler/recheck/company.h"
#include "compiler/recheck/coordination.h"
#include "compiler/recheck/sides.h"
#include "compiler/recheck/sums.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

template <class Node>
bool speaks_of(const sema::Expr* e) {
  bool found = false;
  if (e == nullptr) return false;
  sema::for_each_expr(*e, [&](const sema::Expr& part) {
    found = found || std::holds_alternative<Node>(part.node);
  });
  return found;
}

class Turns {
 public:
  Turns(const sema::Spec& spec, const sema::Decision& d, const Part& part, Claims& claims)
      : spec_(spec), d_(d), part_(part), claims_(claims) {}

  // Recovery i is proved to keep monitor j, and not only because j ranks higher; or it fails by its
  // inputs or by agents alone, whose answer is its own recovery, which drives then or need not.
  [[nodiscard]] bool keeps(std::size_t i, std::size_t j) const {
    if (shown_to_keep(spec_, d_, part_, monitor(i), monitor(j))) return true;
    if (d_.coordinated && asks_agents_only(*monitor(j).always)) {
      return !sema::templates_of(recovery(i)).empty();
    }
    return (d_.coordinated || j < i || accepts(i, j)) &&
           Sides(spec_, d_, claims_).keeps_while_told(recovery(i), monitor(j), extra());
  }

  // Whoever of the two drives, the robot is led the same way, and neither takes over from the
  // other.
  bool leads_on(std::size_t i, std::size_t j) {
    if (monitor(i).recover == monitor(j).recover) return true;
    const auto* one = std::get_if<sema::Retreat>(&recovery(i).implementation);
    const auto* other = std::get_if<sema::Retreat>(&recovery(j).implementation);
    const Claim* const way = way_back(i);
    const Claim* const next = way_back(j);
    if (one == nullptr || other == nullptr || way == nullptr || next == nullptr) return false;
    return one->zone == other->zone && one->speed.value == other->speed.value &&
           way->what == next->what &&
           std::ranges::all_of(std::array{"return_mm", "clearance_mm", "route_mm"},
                               [&](const char* const key) {
                                 return number(way->values, key) == number(next->values, key);
                               }) &&
           keeps(i, j) && keeps(j, i);
  }

  // Where recovery i may return, nothing keeps monitor j from giving control back.
  bool settles(std::size_t i, std::size_t j) {
    const sema::Expr& says = *monitor(j).always;
    if (Sides(spec_, d_, claims_).holds_at_rest(monitor(j), extra())) return true;
    return std::ranges::all_of(sides_of_and(says), [&](const sema::Expr* part) {
      return speaks_of_windows(*part) ? ends_clear(i, j, *part) : settles(i, j, *part);
    });
  }

  // As long as inputs ask for recovery i, which is not shown to keep what monitor j says of places,
  // another one leads back in, and gives the robot back to it.
  [[nodiscard]] bool turns_while_told(std::size_t i, std::size_t j) const {
    const sema::Expr& says = *monitor(j).always;
    if (!moves(recovery(i)) || !by_inputs(*monitor(i).always, false)) return false;
    bool heights = false;
    sema::for_each_expr(says, [&](const sema::Expr& e) { heights = heights || is_height(e); });
    if (all_zones(says).empty() && !heights) return false;
    const auto back = sema::templates_of(recovery(j));
    const bool stands = !back.empty() && std::holds_alternative<sema::BrakeAndHold>(back.back());
    return !stands && !holds(j) && !keeps(i, j) && !accepts(i, j);
  }

  // The specification accepts that recovery i may break monitor j.
  [[nodiscard]] bool accepts(std::size_t i, std::size_t j) const {
    return std::ranges::any_of(d_.acknowledgements, [&](const sema::Acknowledgement& a) {
      return spec_[a.recovery].name == recovery(i).name && spec_[a.monitor].name == monitor(j).name;
    });
  }
  // Or that it need not lead out by itself.
  [[nodiscard]] bool holds(std::size_t i) const { return monitor(i).hold_reason.has_value(); }

  [[nodiscard]] protocol::Subject subject() const {
    protocol::Subject s;
    s.decision = d_.name;
    s.robot = spec_[d_.kind].name;
    s.advanced = spec_[d_.advanced].name;
    if (d_.safe) s.safe = spec_[*d_.safe].name;
    s.on_plan = d_.on_plan;
    for (std::size_t k = 0; k < d_.priority.size(); ++k) {
      const sema::Monitor& m = monitor(k);
      protocol::Monitor of{m.name, m.recover ? recovery(k).name : "", "", 1,
                           m.return_when != nullptr};
      if (!d_.on_plan && !m.ahead.waypoints_only) {
        const Rational ahead = m.ahead.duration ? m.ahead.duration->value : least_ahead(m);
        of.ahead_ticks = floor_to_int(Rational(ahead / d_.period->value));
      }
      s.promises = s.promises || others_in(m);
      s.monitors.push_back(std::move(of));
    }
    if (!d_.on_plan) s.surrenders_to = gives_way();
    s.coordinated = d_.coordinated && !d_.on_plan;
    bool any = s.coordinated;
    for (std::size_t i = 0; !s.on_plan && i < d_.priority.size(); ++i) {
      s.shown.emplace_back();
      for (std::size_t j = 0; j < d_.priority.size(); ++j) {
        const bool own = monitor(i).recover == monitor(j).recover;
        const bool shown =
            (s.coordinated ? shown_to_keep : drives_on)(spec_, d_, part_, monitor(i), monitor(j));
        any = any || (shown && !own);
        s.shown.back().push_back(own ? 2 : shown ? 1 : 0);
      }
    }
    if (!any) s.shown.clear();
    return s;
  }

 private:
  [[nodiscard]] const sema::Monitor& monitor(std::size_t k) const { return spec_[d_.priority[k]]; }
  [[nodiscard]] const sema::Controller& recovery(std::size_t k) const {
    return spec_[*monitor(k).recover];
  }
  static bool moves(const sema::Controller& recovery) {
    const auto steps = sema::templates_of(recovery);
    return steps.empty() || std::ranges::any_of(steps, [](const sema::Template& step) {
             return !std::holds_alternative<sema::BrakeAndHold>(step);
           });
  }
  // Inputs alone may have it be `value`, wherever the robot is; what is not looked into, too.
  static bool by_inputs(const sema::Expr& e, bool value) {
    if (const auto* truth = std::get_if<sema::Truth>(&e.node)) return truth->value == value;
    if (!sema::speaks_of_robot(e)) return true;
    if (std::holds_alternative<sema::Compare>(e.node) ||
        std::holds_alternative<sema::InsideZone>(e.node) ||
        std::holds_alternative<sema::PlanInside>(e.node)) {
      return false;
    }
    if (const auto* others = std::get_if<sema::ForOthers>(&e.node)) {
      return by_inputs(*others->body, value);
    }
    const auto* logic = std::get_if<sema::Logic>(&e.node);
    if (logic == nullptr) return true;
    using Op = sema::LogicOp;
    if (logic->op == Op::logical_not) return by_inputs(*logic->operands.front(), !value);
    const bool implies = logic->op == Op::implies;
    if (logic->op != Op::logical_and && logic->op != Op::logical_or && !implies) return true;
    const auto is = [&](const sema::ExprPtr& each) {
      const bool condition = implies && each == logic->operands.front();
      return by_inputs(*each, value != condition);
    };
    const bool all = value == (logic->op == Op::logical_and);
    return all ? std::ranges::all_of(logic->operands, is)
               : std::ranges::any_of(logic->operands, is);
  }
  // What neither rest nor a place in a zone settles.
  static bool asks_for_more(const sema::Expr& e) {
    const auto* signal = std::get_if<sema::SignalRef>(&e.node);
    return (signal != nullptr && signal->signal == sema::Signal::battery) ||
           std::holds_alternative<sema::EnergyTo>(e.node) ||
           std::holds_alternative<sema::ZoneOpen>(e.node) ||
           std::holds_alternative<sema::WhileOpen>(e.node);
  }
  static bool is_height(const sema::Expr& e) {
    const auto* signal = std::get_if<sema::SignalRef>(&e.node);
    return signal != nullptr && signal->signal == sema::Signal::altitude;
  }
  // All that has to hold; of what speaks of no zone that comes and goes, the whole.
  static std::vector<const sema::Expr*> sides_of_and(const sema::Expr& e) {
    const auto* logic = std::get_if<sema::Logic>(&e.node);
    const bool all = logic != nullptr && logic->op == sema::LogicOp::logical_and;
    if (!all || !speaks_of_windows(e)) return {&e};
    std::vector<const sema::Expr*> sides;
    for (const sema::ExprPtr& each : logic->operands) {
      for (const sema::Expr* side : sides_of_and(*each)) sides.push_back(side);
    }
    return sides;
  }
  bool settles(std::size_t i, std::size_t j, const sema::Expr& says) {
    const auto zones = all_zones(says);
    bool other = false;
    sema::for_each_expr(says, [&](const sema::Expr& e) {
      other = other || asks_for_more(e) || (is_height(e) && !leaves_height(i, j));
    });
    if (other || (!zones.empty() && is_choice(says, true))) return false;
    return std::all_of(zones.begin(), zones.end(), [&](sema::ZoneId zone) {
      return (leaves_room(i, zone) && (leads_on(i, j) || lets_go_in(i, zone))) ||
             lets_go_by_border(i, j, zone);
    });
  }
  // The same way leads on to its sites, and each of them is as clear as control returns at with all
  // zones at their worst.
  bool ends_clear(std::size_t i, std::size_t j, const sema::Expr& says) {
    const auto way = sema::route_of(recovery(j));
    if (monitor(i).recover != monitor(j).recover || !way || way_back(j) == nullptr) return false;
    if (!keeps(i, j)) return false;
    const AtWorst worst = at_worst(spec_, says);
    if (worst.kind != AtWorst::Kind::limit) return worst.kind == AtWorst::Kind::holds;
    const Rational far = claims_.return_clearance(d_, monitor(j), extra()) + worst.limit->gap;
    return std::ranges::all_of(spec_[way->site].places, [&](const auto& place) {
      return claims_.zones().clear(worst.limit->zone, {place.position.x, place.position.y},
                                   without_excess(far));
    });
  }
  // How much further ahead it looks for control to return.
  [[nodiscard]] Rational extra() const { return return_extra(spec_, d_); }
  // The lowest and the highest place where recovery i leads to keep every limit of height.
  bool leaves_height(std::size_t i, std::size_t j) {
    const auto within = moves_within(recovery(i));
    const Claim* const way = way_back(i);
    if (within.empty() || way == nullptr || way->what != "legs") return false;
    const auto left_mm = number(way->values, "clearance_mm");
    const auto solid = claims_.zones().solid(within.back());
    if (!left_mm || !solid || solid->slabs().empty()) return false;
    const Rational left = Rational(*left_mm) / 1000;
    return keeps_heights_inside(spec_, *monitor(j).always, true, *solid, left,
                                claims_.return_height(d_, monitor(j), extra()));
  }
  // One side of it may be what rest settles, and another one what a place does: it is not known
  // which of them holds. Where inputs are all that the other sides ask, the one that is settled
  // holds whatever they say.
  static bool is_choice(const sema::Expr& e, bool value) {
    using Op = sema::LogicOp;
    const auto* logic = std::get_if<sema::Logic>(&e.node);
    const auto is = [&](const sema::ExprPtr& each) { return is_choice(*each, value); };
    if (logic == nullptr) {
      bool found = false;
      sema::for_each_operand(e, [&](const sema::ExprPtr& each) { found = found || is(each); });
      return found;
    }
    if (logic->op == Op::logical_not) return is_choice(*logic->operands.front(), !value);
    const bool either = logic->op == Op::logical_and || logic->op == Op::logical_or;
    if (either && (logic->op == Op::logical_and) == value) {
      return std::ranges::any_of(logic->operands, is);
    }
    const auto of_robot = std::ranges::count_if(
        logic->operands, [](const sema::ExprPtr& each) { return sema::speaks_of_robot(*each); });
    if (of_robot == 0) return false;
    if (either) return of_robot > 1 || std::ranges::any_of(logic->operands, is);
    if (logic->op != Op::implies || !value) return true;
    return sema::speaks_of_robot(*logic->operands.front()) || is(logic->operands.back());
  }
  // Where it leads, which is proved for one of the monitors that it recovers for.
  [[nodiscard]] const Claim* way_back(std::size_t i) const {
    for (std::size_t k = 0; k < d_.priority.size(); ++k) {
      if (monitor(k).recover != monitor(i).recover) continue;
      const Entry* const back = find(part_, "P2b", monitor(k).name);
      if (back == nullptr) continue;
      for (const char* const what : {"ways", "legs"}) {
        const Claim* const way =
            claim_with(*back, what, {{"decision", d_.name}, {"monitor", monitor(k).name}});
        if (way != nullptr) return way;
      }
    }
    return nullptr;
  }
  bool leaves_room(std::size_t i, sema::ZoneId zone) {
    const auto within = moves_within(recovery(i));
    const Claim* const way = way_back(i);
    if (within.empty() || way == nullptr) return false;
    const bool legs = way->what == "legs";
    const auto left_mm = number(way->values, legs ? "clearance_mm" : "return_mm");
    if (!left_mm) return false;
    return has_room(within.back(), Rational(*left_mm) / 1000, zone);
  }
  // Monitor i may let its recovery go before that is there: where what it says of zones, if it
  // says anything of them, holds with its clearance to return, and its `return when`.
  bool lets_go_in(std::size_t i, sema::ZoneId zone) {
    const sema::Monitor& own = monitor(i);
    return all_zones(*own.always).empty() ||
           lies_deep(*own.always, claims_.return_clearance(d_, own, extra()), zone) ||
           (own.return_when && lies_deep(*own.return_when, spec_[d_.kind].radius.value, zone));
  }
  // Recovery i is proved to drive beside the border of its zone alone while monitor j holds; where
  // the look-ahead of those that it drives for fails it brakes, no farther than that covers.
  bool lets_go_by_border(std::size_t i, std::size_t j, sema::ZoneId zone) {
    const auto steps = sema::templates_of(recovery(i));
    const auto* const retreat = steps.empty() ? nullptr : std::get_if<sema::Retreat>(&steps.back());
    const Entry* const kept = find(part_, "C", monitor(j).name, recovery(i).name);
    const Claim* const by = retreat == nullptr || kept == nullptr || !keeps(i, j)
                                ? nullptr
                                : claim_with(*kept, "by_border",
                                             {{"monitor", monitor(i).name},
                                              {"judged", monitor(j).name},
                                              {"zone", claims_.zones().name(retreat->zone)}});
    const auto near_mm = by != nullptr ? number(by->values, "near_mm") : std::nullopt;
    const auto back_mm = by != nullptr ? number(by->values, "return_mm") : std::nullopt;
    if (!near_mm || !back_mm) return false;
    Rational gap = 0, ahead = 0;
    for (const sema::MonitorId id : d_.priority) {
      const sema::Monitor& m = spec_[id];
      if (m.recover != monitor(i).recover) continue;
      const bool alone =
          asks_for_alone(*m.always, retreat->zone) &&
          (m.return_when == nullptr || asks_for_alone(*m.return_when, retreat->zone));
      if (!alone) return false;
      gap = std::max(gap, gap_of(spec_, *m.always, retreat->zone));
      ahead = std::max(ahead, m.ahead.duration ? m.ahead.duration->value : least_ahead(m));
    }
    const Numbers n = numbers_of(spec_, d_, jitter_of(spec_, d_));
    const Rational fails = cruising_clearance(n, n.speed, ahead + extra()) + gap;
    const Rational brakes = fails + std::max(fails, milli(*back_mm)) + n.sway + n.hold;
    const geometry::Region* const own = claims_.zones().region(retreat->zone);
    const geometry::Region* const other = claims_.zones().region(zone);
    if (own == nullptr || other == nullptr) return false;
    const auto middle = own->offset(-std::max(milli(*near_mm), brakes));
    Rational need = claims_.return_clearance(d_, zone, extra());
    const Rational speed = driven_at_most(n, recovery(i));
    for (const sema::MonitorId id : d_.priority) {
      const sema::Monitor& m = spec_[id];
      const auto of = all_zones(*m.always);
      if (std::ranges::find(of, zone) == of.end()) continue;
      const Rational looks =
          (m.ahead.duration ? m.ahead.duration->value : least_ahead(m)) + extra();
      need = std::max(
          need, Rational(cruising_clearance(n, speed, looks) + gap_of(spec_, *m.always, zone)));
    }
    return middle && other->shrink(without_excess(need)).contains(own->subtract(*middle));
  }
  // It fails nowhere but near the boundary of the zone, or because its robot is fast there.
  bool asks_for_alone(const sema::Expr& says, sema::ZoneId zone) {
    const auto* logic = std::get_if<sema::Logic>(&says.node);
    if (logic != nullptr && logic->op == sema::LogicOp::logical_and) {
      return std::ranges::all_of(
          logic->operands, [&](const sema::ExprPtr& each) { return asks_for_alone(*each, zone); });
    }
    const auto floor = floor_of(spec_, says, true);
    return floor && floor->zone == zone;
  }
  // Wherever a property holds with `more` to spare; of an `or`, of each of its sides.
  bool lies_deep(const sema::Expr& says, const Rational& more, sema::ZoneId zone,
                 bool value = true) {
    using Op = sema::LogicOp;
    if (const auto* logic = std::get_if<sema::Logic>(&says.node)) {
      const auto deep = [&](const sema::ExprPtr& each) {
        return lies_deep(*each, more, zone, value);
      };
      if (logic->op == Op::logical_not) {
        return lies_deep(*logic->operands.front(), more, zone, !value);
      }
      if (logic->op != Op::logical_and && logic->op != Op::logical_or) return false;
      return (logic->op == Op::logical_and) == value ? std::ranges::any_of(logic->operands, deep)
                                                     : std::ranges::all_of(logic->operands, deep);
    }
    const auto floor = floor_of(spec_, says, value);
    return floor && floor->laxest >= 0 && has_room(floor->zone, more + floor->laxest, zone);
  }
  // Who is in a zone, `left` clear of its boundary, is so clear of another one that it is given
  // back.
  bool has_room(sema::ZoneId own, const Rational& left, sema::ZoneId zone) {
    const Rational more = claims_.return_clearance(d_, zone, extra()) - left;
    if (own == zone) return more <= 0;
    if (more <= 0) {
      const auto in = claims_.zones().solid(own), out = claims_.zones().solid(zone);
      return in && out && in->subtract(*out).empty();
    }
    const geometry::Region* const in = claims_.zones().region(own);
    const geometry::Region* const out = claims_.zones().region(zone);
    return in != nullptr && out != nullptr && out->shrink(without_excess(more)).contains(*in);
  }
  // A period, two where the recovery is external (rule 9.1).
  [[nodiscard]] Rational least_ahead(const sema::Monitor& m) const {
    const bool external = m.recover && sema::templates_of(spec_[*m.recover]).empty();
    return d_.period->value * (external ? 2 : 1);
  }
  static bool others_in(const sema::Monitor& m) {
    return speaks_of<sema::ForOthers>(m.always.get()) ||
           speaks_of<sema::CountOthers>(m.always.get()) ||
           speaks_of<sema::ForOthers>(m.return_when.get()) ||
           speaks_of<sema::CountOthers>(m.return_when.get());
  }
  [[nodiscard]] std::int64_t gives_way() const {
    for (std::size_t k = 0; k < d_.priority.size(); ++k) {
      if (std::holds_alternative<sema::Yield>(recovery(k).implementation)) {
        return std::int64_t(k) + 1;
      }
    }
    return 1;
  }

  const sema::Spec& spec_;
  const sema::Decision& d_;
  const Part& part_;
  Claims& claims_;
};

}  // namespace

std::optional<Doubt> check_turns(const sema::Spec& spec, const sema::Decision& d, const Part& part,
                                 const Claim& claim, bool accepting, Claims& claims,
                                 const ProveModel& prove) {
  const protocol::Arbitration taken{protocol::table_of(text(claim.values, "keeps")),
                                    protocol::table_of(text(claim.values, "settles"))};
  const std::size_t count = d.on_plan ? 0 : d.priority.size();
  if (taken.keeps.size() != count || taken.settles.size() != count) {
    return Doubt{true, "its tables are not those of the monitors"};
  }
  Turns turns(spec, d, part, claims);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      if (i == j) continue;
      const std::string pair =
          "recovery " + std::to_string(i + 1) + " and monitor " + std::to_string(j + 1) + ": ";
      if (turns.turns_while_told(i, j)) {
        return Doubt{true, pair + "as long as inputs ask for one it leads out of the other"};
      }
      const bool accepted = accepting && turns.accepts(i, j);
      if (taken.keeps[i][j] && !turns.keeps(i, j) && !accepted) {
        return Doubt{true, pair + "it is not proved that it keeps what it says"};
      }
      const bool waits = accepted || (accepting && turns.holds(i));
      if (taken.settles[i][j] && !turns.settles(i, j) && !waits) {
        return Doubt{true, pair + "where one returns the other may not"};
      }
    }
  }
  protocol::Subject subject = turns.subject();
  const auto dwell = number(claim.values, "dwell_ticks");
  if (!d.on_plan && dwell != dwell_ticks(d))
    return Doubt{true, "control returns after another dwell"};
  subject.dwell_ticks = dwell.value_or(0);
  return prove(protocol_model(subject, taken, spec.name));
}

}  // namespace rtac::recheck
