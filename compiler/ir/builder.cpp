#include "compiler/ir/builder.h"

#include <algorithm>
#include <optional>

#include "compiler/ir/schedule.h"
#include "compiler/ir/source_text.h"
#include "compiler/ir/watch_blocks.h"
#include "compiler/sema/received.h"
#include "compiler/sema/visit.h"

namespace rtac::ir {
namespace {

using diag::Code;

constexpr sema::Dimension length{.m = 1};
constexpr sema::Dimension ratio{.ratio = 1};
constexpr sema::Dimension speed{.m = 1, .s = -1};

bool is_compared(const sema::Dimension& dimension) {
  return dimension == length || dimension == ratio || dimension == speed;
}

class BlockBuilder {
 public:
  BlockBuilder(const sema::Spec& spec, const TableMap& tables, const SourceManager& sources,
               const Monitor& monitor, sema::KindId kind, Decision& decision,
               diag::Engine& diagnostics)
      : spec_(spec),
        tables_(tables),
        sources_(sources),
        monitor_(monitor),
        kind_(kind),
        decision_(decision),
        diagnostics_(diagnostics) {}

  Block property(const sema::Expr& e) { return build(e); }
  // All of it is judged now.
  Block return_condition(const sema::Expr& e) {
    all_now_ = true;
    Block block = build(e);
    all_now_ = false;
    return block;
  }

 private:
  Block build(const sema::Expr& e) {
    Block block;
    Block* const outer = block_;
    block_ = &block;
    block.result = margin(e);
    block_ = outer;
    return block;
  }

  ValueId add(Op op, std::optional<Unit> unit, const SourceRange& source) {
    std::string text = unit ? "" : one_line(sources_.text(source));
    block_->values.push_back(
        {std::move(op), std::move(unit), std::nullopt, source, std::move(text)});
    return ValueId(block_->values.size() - 1);
  }

  // ---- margins ----

  ValueId margin(const sema::Expr& e) {
    if (is_fact(e)) return fact(e);
    return std::visit([&](const auto& node) { return margin(node, e); }, e.node);
  }
  ValueId margin(const sema::Truth& v, const sema::Expr& e) {
    return add(Truth{v.value}, std::nullopt, e.range);
  }
  ValueId margin(const sema::InsideZone& v, const sema::Expr& e) { return inside(v, e, true); }
  // bodies: the centre lies in the zone and keeps the radius, that is clearance >= 0
  ValueId inside(const sema::InsideZone& v, const sema::Expr& e, bool is) {
    const ValueId clearance = this->clearance(v.zone, e);
    const ValueId zero = add(Const{0}, Unit::mm, e.range);
    return add(is ? AtLeast{clearance, zero, false} : AtLeast{zero, clearance, true}, std::nullopt,
               e.range);
  }
  ValueId margin(const sema::ZoneOpen& v, const sema::Expr& e) {
    return add(ZoneThere{schedule_in(decision_.facts.schedules, spec_[v.zone])}, std::nullopt,
               e.range);
  }
  ValueId margin(const sema::PlanInside& v, const sema::Expr& e) {
    return add(PlanInZone{tables_.zone(v.zone)}, std::nullopt, e.range);
  }
  ValueId margin(const sema::Compare& v, const sema::Expr& e) { return margin(v, e, v.op); }
  ValueId margin(const sema::Compare& v, const sema::Expr& e, sema::CompareOp op) {
    const bool flipped = op == sema::CompareOp::less || op == sema::CompareOp::less_equal;
    const bool strict = op == sema::CompareOp::less || op == sema::CompareOp::greater;
    if (counts(*v.left) || counts(*v.right)) return count_margin(v, flipped, strict, e);
    if (!is_compared(v.left->dimension)) {
      refuse(e, "the kernel compares lengths, ratios and speeds only");
      return add(Truth{false}, std::nullopt, e.range);
    }
    const ValueId left = quantity(*v.left);
    const ValueId right = quantity(*v.right);
    return add(AtLeast{flipped ? right : left, flipped ? left : right, strict}, std::nullopt,
               e.range);
  }
  static bool counts(const sema::Expr& e) {
    return std::holds_alternative<sema::CountOthers>(e.node);
  }
  // A count of robots is compared with a whole number, and with nothing else.
  ValueId count_margin(const sema::Compare& v, bool flipped, bool strict, const sema::Expr& e) {
    const auto limit = fold(counts(*v.left) ? *v.right : *v.left);
    if (!limit) {
      refuse(e, "a number of robots is compared with something else than a constant");
      return add(Truth{false}, std::nullopt, e.range);
    }
    const auto side = [&](const sema::Expr& s) {
      return counts(s) ? count(std::get<sema::CountOthers>(s.node), s) : constant(*limit, s);
    };
    const ValueId left = side(*v.left);
    const ValueId right = side(*v.right);
    return add(AtLeast{flipped ? right : left, flipped ? left : right, strict}, std::nullopt,
               e.range);
  }
  ValueId count(const sema::CountOthers& v, const sema::Expr& e) {
    auto body = std::make_unique<Block>(others(*v.body));
    return add(CountOthers{std::move(body)}, Unit::robots, e.range);
  }
  ValueId margin(const sema::Logic& v, const sema::Expr& e) {
    const auto inverse = [&](ValueId a) { return add(Not{a}, std::nullopt, e.range); };
    const auto both = [&](ValueId a, ValueId b) { return add(And{a, b}, std::nullopt, e.range); };
    const auto either = [&](ValueId a, ValueId b) { return add(Or{a, b}, std::nullopt, e.range); };
    if (v.op == sema::LogicOp::logical_not) return negated(*v.operands[0]);
    const bool implies = v.op == sema::LogicOp::implies;
    const ValueId a = implies ? negated(*v.operands[0]) : margin(*v.operands[0]);
    const ValueId b = margin(*v.operands[1]);
    switch (v.op) {
      case sema::LogicOp::logical_not:
        break;
      case sema::LogicOp::logical_and:
        return both(a, b);
      case sema::LogicOp::logical_or:
      case sema::LogicOp::implies:
        return either(a, b);
      case sema::LogicOp::iff:
        return both(either(inverse(a), b), either(inverse(b), a));
      case sema::LogicOp::logical_xor:
        return either(both(a, inverse(b)), both(b, inverse(a)));
    }
    return a;
  }
  // A negation moves inwards, so that what it says of a robot is a comparison, as if it had been
  // written that way round.
  ValueId negated(const sema::Expr& e) {
    if (!is_fact(e)) {
      if (const auto* v = std::get_if<sema::Truth>(&e.node)) {
        return add(Truth{!v->value}, std::nullopt, e.range);
      }
      if (const auto* v = std::get_if<sema::Compare>(&e.node)) {
        return margin(*v, e, opposite(v->op));
      }
      if (const auto* v = std::get_if<sema::InsideZone>(&e.node)) return inside(*v, e, false);
      if (const auto* v = std::get_if<sema::Logic>(&e.node)) {
        if (v->op == sema::LogicOp::logical_not) return margin(*v->operands[0]);
        const bool either = v->op == sema::LogicOp::logical_and;
        const bool implies = v->op == sema::LogicOp::implies;
        if (either || implies || v->op == sema::LogicOp::logical_or) {
          const ValueId a = implies ? margin(*v->operands[0]) : negated(*v->operands[0]);
          const ValueId b = negated(*v->operands[1]);
          return add(either ? Op(Or{a, b}) : Op(And{a, b}), std::nullopt, e.range);
        }
      }
    }
    const ValueId a = margin(e);
    return add(Not{a}, std::nullopt, e.range);
  }
  static sema::CompareOp opposite(sema::CompareOp op) {
    switch (op) {
      case sema::CompareOp::less:
        return sema::CompareOp::greater_equal;
      case sema::CompareOp::less_equal:
        return sema::CompareOp::greater;
      case sema::CompareOp::greater:
        return sema::CompareOp::less_equal;
      case sema::CompareOp::greater_equal:
        break;
    }
    return sema::CompareOp::less;
  }
  ValueId margin(const sema::HeldFor& v, const sema::Expr& e) {
    const ValueId operand = margin(*v.operand);
    const Rational ticks = v.duration.value * 1'000'000 / Rational(decision_.period_us);
    return add(HeldFor{operand, ceil_to_int(ticks), decision_.held_slots++}, std::nullopt, e.range);
  }
  ValueId margin(const sema::ForOthers& v, const sema::Expr& e) {
    auto body = std::make_unique<Block>(others(*v.body));
    return add(ForOthers{v.universal, std::move(body)}, std::nullopt, e.range);
  }
  template <class Node>
  ValueId margin(const Node&, const sema::Expr& e) {
    refuse(e, "this is not a truth value");
    return add(Truth{false}, std::nullopt, e.range);
  }

  // ---- quantities ----

  static Unit unit_of(const sema::Expr& e) {
    if (e.dimension == sema::Dimension{}) return Unit::robots;
    if (e.dimension == speed) return Unit::mmps;
    return e.dimension == ratio ? Unit::ppm : Unit::mm;
  }
  ValueId quantity(const sema::Expr& e) {
    if (!is_compared(e.dimension)) {
      refuse(e, "the kernel compares lengths, ratios and speeds only");
      return add(Const{0}, Unit::mm, e.range);
    }
    if (const auto constant = fold(e)) return this->constant(*constant, e);
    return std::visit([&](const auto& node) { return quantity(node, e); }, e.node);
  }
  ValueId quantity(const sema::SignalRef& v, const sema::Expr& e) {
    if (v.subject != sema::Subject::self) {
      refuse(e, "only the robot's own `battery` and `speed` can be compared directly");
    }
    if (v.signal == sema::Signal::battery) return add(Battery{}, Unit::ppm, e.range);
    if (v.signal == sema::Signal::altitude) return add(Altitude{}, Unit::mm, e.range);
    // margins of several units tell theirs by its place in this list
    auto& units = decision_.facts.units;
    if (std::find(units.begin(), units.end(), Unit::mmps) == units.end()) {
      units.push_back(Unit::mmps);
    }
    return add(Speed{}, Unit::mmps, e.range);
  }
  ValueId quantity(const sema::Clearance& v, const sema::Expr& e) { return clearance(v.zone, e); }
  ValueId clearance(sema::ZoneId zone, const sema::Expr& e) {
    const auto by = sema::received_by(spec_, zone);
    if (!by) return add(Clearance{tables_.zone(zone)}, Unit::mm, e.range);
    return add(ReceivedClearance{received(*by)}, Unit::mm, e.range);
  }
  // One for all that ask for this side of the zone.
  ReceivedIndex received(const sema::ReceivedBy& by) {
    const std::string& name = spec_[by.input].name;
    auto& all = decision_.facts.received;
    const auto found = std::find_if(all.begin(), all.end(), [&](const Received& each) {
      return each.name == name && each.outside == by.outside;
    });
    if (found != all.end()) return ReceivedIndex(found - all.begin());
    all.push_back({name, channel_of(decision_.facts, name), by.outside});
    return ReceivedIndex(all.size() - 1);
  }
  ValueId quantity(const sema::Distance&, const sema::Expr& e) {
    return add(Distance{}, Unit::mm, e.range);
  }
  ValueId quantity(const sema::AgentDistance& v, const sema::Expr& e) {
    return add(AgentDistance{agent_of(v)}, Unit::mm, e.range);
  }
  [[nodiscard]] AgentIndex agent_of(const sema::AgentDistance& v) const {
    const std::uint32_t seen = channel_of(decision_.facts, spec_[v.seen].name);
    const auto& all = decision_.agents;
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Agent& agent) { return agent.seen == seen; });
    return AgentIndex(found - all.begin());
  }
  ValueId quantity(const sema::EnergyTo& v, const sema::Expr& e) {
    const auto& slot =
        tables_.sites[static_cast<std::uint32_t>(kind_)][static_cast<std::uint32_t>(v.site)];
    if (!slot) {
      refuse(e, "no recovery of this kind of robot routes to this site, so its way has no price");
      return add(Const{0}, Unit::ppm, e.range);
    }
    return add(EnergyTo{*slot}, Unit::ppm, e.range);
  }
  ValueId quantity(const sema::ParamRef& v, const sema::Expr& e) {
    const std::uint32_t param = param_of(decision_.facts, spec_[v.param].name);
    const Unit own = decision_.facts.params[param].unit;
    const ValueId value = add(ParamValue{param}, own, e.range);
    const Unit unit = unit_of(e);
    if (own == unit) return value;
    const Rational steps(own.step / unit.step);
    return add(Scale{value, steps.get_num().get_si(), steps.get_den().get_si()}, unit, e.range);
  }
  ValueId quantity(const sema::InputRef& v, const sema::Expr& e) {
    diagnostics_.report({Code::atom_without_transformer,
                         e.range,
                         "`" + spec_[v.input].name +
                             "` cannot be compared with what is looked ahead: nothing is known of "
                             "how it changes",
                         "an input",
                         {},
                         "a constant or a parameter can stand here; an input can in a comparison "
                         "without the robot, and in `return when`",
                         {}});
    return add(Const{0}, unit_of(e), e.range);
  }
  ValueId quantity(const sema::Arithmetic& v, const sema::Expr& e) {
    const Unit unit = unit_of(e);
    switch (v.op) {
      case sema::ArithmeticOp::add:
        return sum(quantity(*v.operands[0]), quantity(*v.operands[1]), unit, e);
      case sema::ArithmeticOp::subtract: {
        const ValueId left = quantity(*v.operands[0]);
        const ValueId right = quantity(*v.operands[1]);
        return sum(left, add(Negate{right}, unit, e.range), unit, e);
      }
      case sema::ArithmeticOp::negate:
        return add(Negate{quantity(*v.operands[0])}, unit, e.range);
      case sema::ArithmeticOp::multiply: {
        if (const auto k = fold(*v.operands[0])) return scaled(*v.operands[1], *k, e);
        if (const auto k = fold(*v.operands[1])) return scaled(*v.operands[0], *k, e);
        break;
      }
      case sema::ArithmeticOp::divide:
        if (const auto k = fold(*v.operands[1]); k && sgn(*k) != 0) {
          return scaled(*v.operands[0], Rational(1 / *k), e);
        }
        break;
    }
    refuse(e, "products and quotients of signals are outside the integer kernel");
    return add(Const{0}, unit, e.range);
  }
  template <class Node>
  ValueId quantity(const Node&, const sema::Expr& e) {
    refuse(e, "this is not a quantity");
    return add(Const{0}, Unit::mm, e.range);
  }

  ValueId sum(ValueId a, ValueId b, Unit unit, const sema::Expr& e) {
    return add(Add{a, b}, unit, e.range);
  }
  ValueId scaled(const sema::Expr& operand, const Rational& factor, const sema::Expr& e) {
    const ValueId a = quantity(operand);
    if (!factor.get_num().fits_slong_p() || !factor.get_den().fits_slong_p()) {
      refuse(e, "the factor does not fit the integer kernel");
      return a;
    }
    return add(Scale{a, factor.get_num().get_si(), factor.get_den().get_si()}, unit_of(e), e.range);
  }

  // Value of an expression without signals, in SI; nullopt otherwise.
  std::optional<Rational> fold(const sema::Expr& e) {
    if (const auto* c = std::get_if<sema::Constant>(&e.node)) return c->value;
    const auto* a = std::get_if<sema::Arithmetic>(&e.node);
    if (!a) return std::nullopt;
    const auto left = fold(*a->operands[0]);
    if (a->op == sema::ArithmeticOp::negate) {
      return left ? std::optional<Rational>(-*left) : std::nullopt;
    }
    const auto right = fold(*a->operands[1]);
    if (!left || !right) return std::nullopt;
    switch (a->op) {
      case sema::ArithmeticOp::add:
        return Rational(*left + *right);
      case sema::ArithmeticOp::subtract:
        return Rational(*left - *right);
      case sema::ArithmeticOp::multiply:
        return Rational(*left * *right);
      case sema::ArithmeticOp::divide:
        return sgn(*right) == 0 ? std::nullopt : std::optional<Rational>(*left / *right);
      case sema::ArithmeticOp::negate:
        break;
    }
    return std::nullopt;
  }

  // ---- facts ----

  // Judged once a tick, whatever lies ahead: what says nothing of a robot; in a return condition
  // also the past of one, and arithmetic beyond that of the look-ahead.
  [[nodiscard]] bool is_fact(const sema::Expr& e) const {
    if (!speaks_of_signals(e)) return false;
    if (!sema::speaks_of_robot(e)) return true;
    if (!all_now_ || in_others_) return false;
    return remembers(e) || std::holds_alternative<sema::Compare>(e.node);
  }
  // Beyond constants, parameters, sums and multiples of what robots sense.
  static bool speaks_of_signals(const sema::Expr& e) {
    const bool of_robot = sema::speaks_of_robot(e);
    bool found = false;
    sema::for_each_expr(e, [&](const sema::Expr& each) {
      found = found || remembers(each) || std::holds_alternative<sema::InputRef>(each.node) ||
              std::holds_alternative<sema::AgeOf>(each.node) ||
              std::holds_alternative<sema::SensedAge>(each.node) ||
              std::holds_alternative<sema::IsValue>(each.node) ||
              std::holds_alternative<sema::SameValue>(each.node) ||
              std::holds_alternative<sema::Math>(each.node) ||
              std::holds_alternative<sema::Choice>(each.node) ||
              std::holds_alternative<sema::Aggregate>(each.node) ||
              (!of_robot && (std::holds_alternative<sema::ParamRef>(each.node) ||
                             std::holds_alternative<sema::HeldFor>(each.node)));
    });
    return found;
  }
  static bool remembers(const sema::Expr& e) {
    return std::holds_alternative<sema::Previously>(e.node) ||
           std::holds_alternative<sema::Past>(e.node) ||
           std::holds_alternative<sema::Since>(e.node) ||
           std::holds_alternative<sema::WithinOf>(e.node);
  }
  ValueId fact(const sema::Expr& e) {
    if (asks_for_received(e)) {
      refuse_past_of_received(e);
      return add(Truth{false}, std::nullopt, e.range);
    }
    const RobotSignals robot{tables_, kind_, [&](const sema::Expr& body) { return others(body); },
                             [&](const sema::AgentDistance& agent) { return agent_of(agent); }};
    PlainMonitor to;
    to.name = monitor_.name + "_fact_" + std::to_string(++facts_);
    to.requirement_id = monitor_.requirement_id;
    to.requirement_text = monitor_.requirement_text;
    to.file = monitor_.file;
    to.line = monitor_.line;
    to.text = one_line(sources_.text(e.range));
    to.source = e.range;
    to.property =
        build_watch_block(e, spec_, sources_, tables_, decision_.facts, diagnostics_, &robot);
    // behind those that it has parts in
    auto& facts = decision_.facts.monitors;
    facts.push_back(std::move(to));
    return add(Fact{static_cast<std::uint32_t>(facts.size() - 1), sema::speaks_of_robot(e)},
               std::nullopt, e.range);
  }
  [[nodiscard]] bool asks_for_received(const sema::Expr& e) const {
    bool found = false;
    sema::for_each_expr(e, [&](const sema::Expr& each) {
      const auto* clear = std::get_if<sema::Clearance>(&each.node);
      const auto* inside = std::get_if<sema::InsideZone>(&each.node);
      if (clear != nullptr) found = found || sema::received_by(spec_, clear->zone);
      if (inside != nullptr) found = found || sema::received_by(spec_, inside->zone);
    });
    return found;
  }
  void refuse_past_of_received(const sema::Expr& e) {
    diagnostics_.report({Code::zone_not_fixed,
                         e.range,
                         "the past of a robot does not speak of a zone that is received",
                         "a zone that stays as it is is due here",
                         {},
                         "a comparison of its own speaks of it as it is now, and so does `for`, "
                         "which asks for how long that has held: `clearance(r, zone) >= c for 1 s`",
                         {}});
  }
  Block others(const sema::Expr& body) {
    const bool outer = in_others_;
    in_others_ = true;
    Block block = build(body);
    in_others_ = outer;
    return block;
  }

  ValueId constant(const Rational& si, const sema::Expr& e) {
    const bool is_ratio = e.dimension == ratio;
    const bool is_number = e.dimension == sema::Dimension{};
    const Rational grid = si / unit_of(e).step;
    if (grid.get_den() != 1) {
      const auto show = [&](const Rational& steps) {
        if (is_number) return to_decimal(steps);
        if (is_ratio) return to_decimal(steps / 10'000) + " %";
        return to_decimal(steps / 1000) + (e.dimension == speed ? " m/s" : " m");
      };
      const std::string step = is_number              ? "whole numbers"
                               : is_ratio             ? "1 ppm"
                               : e.dimension == speed ? "1 mm/s"
                                                      : "1 mm";
      const Rational below(floor_to_int(grid));
      diagnostics_.report({Code::constant_off_grid,
                           e.range,
                           "this constant does not lie on the grid of " + step,
                           "",
                           {},
                           "`" + show(below) + "` and `" + show(below + 1) + "` do",
                           {}});
      return add(Const{0}, unit_of(e), e.range);
    }
    if (!fits_int64(grid)) {
      diagnostics_.report({Code::value_out_of_range,
                           e.range,
                           "this constant does not fit the integer kernel",
                           "",
                           {},
                           "a constant below 2^48 grid steps of 1 mm or 1 ppm works",
                           {}});
      return add(Const{0}, unit_of(e), e.range);
    }
    return add(Const{floor_to_int(grid)}, unit_of(e), e.range);
  }

  void refuse(const sema::Expr& e, const std::string& what) {
    diagnostics_.report({Code::expression_not_supported,
                         e.range,
                         what,
                         "",
                         {},
                         "compute it outside and pass it in, or compare clearance, distance, "
                         "battery or a number of robots with a constant",
                         {}});
  }

  const sema::Spec& spec_;
  const TableMap& tables_;
  const SourceManager& sources_;
  const Monitor& monitor_;
  sema::KindId kind_;
  Decision& decision_;
  diag::Engine& diagnostics_;
  Block* block_ = nullptr;
  bool all_now_ = false, in_others_ = false;
  int facts_ = 0;  // of this monitor
};

// The signals that the monitors of the decision speak of.
Watch facts_of(const sema::Spec& spec, const sema::Decision& from, const Signals& signals,
               std::int64_t period_us) {
  Watch facts;
  facts.period_us = period_us;
  UsedSignals used;
  for (const sema::MonitorId id : from.priority) used.add(spec, spec[id]);
  for (std::uint32_t i = 0; i < signals.inputs.size(); ++i) {
    if (used.inputs.count(sema::InputId{i}) > 0) facts.inputs.push_back(signals.inputs[i]);
  }
  for (std::uint32_t i = 0; i < signals.params.size(); ++i) {
    if (used.params.count(sema::ParamId{i}) > 0) facts.params.push_back(signals.params[i]);
  }
  facts.units = {{{}, 1, 1}, Unit::mm, Unit::ppm, Unit::robots};
  return facts;
}

// Those whose places are among the signals.
std::vector<Agent> agents_of(const sema::Spec& spec, const Watch& facts) {
  std::vector<Agent> all;
  for (const sema::Agent& from : spec.agents) {
    const std::uint32_t seen = channel_of(facts, spec[from.seen].name);
    if (seen == facts.inputs.size()) continue;
    const auto up = [](const Rational& si, long steps) {
      return ceil_to_int(Rational(si * steps));
    };
    Agent to;
    to.name = from.name;
    to.radius_mm = up(from.radius.value, 1000);
    const Rational larger = Rational(to.radius_mm, 1000) - from.radius.value;  // as of robots
    to.error_mm = up(Rational(from.position.error.value + larger), 1000);
    to.speed_mmps = up(from.speed.value, 1000);
    to.age_us = floor_to_int(from.position.max_age.value * 1'000'000);
    to.seen = seen;
    to.in_space = from.in_space;
    if (from.present) to.present = channel_of(facts, spec[*from.present].name);
    all.push_back(std::move(to));
  }
  return all;
}

}  // namespace

void build_blocks(const sema::Spec& spec, const TableMap& tables, const Signals& signals,
                  const SourceManager& sources, Module& module, diag::Engine& diagnostics) {
  for (std::size_t i = 0; i < module.decisions.size(); ++i) {
    const sema::Decision& from = spec.decisions[i];
    Decision& decision = module.decisions[i];
    decision.facts = facts_of(spec, from, signals, decision.period_us);
    decision.agents = agents_of(spec, decision.facts);
    for (std::size_t k = 0; k < decision.monitors.size(); ++k) {
      const sema::Monitor& monitor = spec[from.priority[k]];
      Monitor& to = decision.monitors[k];
      BlockBuilder builder(spec, tables, sources, to, from.kind, decision, diagnostics);
      to.property = builder.property(*monitor.always);
      if (monitor.return_when) to.return_when = builder.return_condition(*monitor.return_when);
    }
  }
}

}  // namespace rtac::ir
