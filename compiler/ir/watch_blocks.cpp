#include "compiler/ir/watch_blocks.h"

#include <algorithm>
#include <initializer_list>

#include "compiler/ir/schedule.h"
#include "compiler/ir/signals.h"
#include "compiler/ir/watch_quantities.h"
#include "compiler/ir/weights.h"

namespace rtac::ir {
namespace {

class PropertyBuilder {
 public:
  PropertyBuilder(const sema::Spec& spec, const SourceManager& sources, const TableMap& tables,
                  Watch& watch, diag::Engine& diagnostics, const RobotSignals* robot,
                  bool margin_full)
      : spec_(spec),
        watch_(watch),
        diagnostics_(diagnostics),
        robot_(robot),
        values_(spec, sources, tables, watch, diagnostics, robot, margin_full,
                [this](const sema::Expr& e) { return margin(e, true); }) {}

  Block build(const sema::Expr& e) {
    const ValueId result = margin(e, true);
    return values_.take(result);
  }

 private:
  ValueId add(Op op, const sema::Expr& e) { return values_.add(std::move(op), std::nullopt, e); }
  ValueId negated(ValueId a, const sema::Expr& e) { return add(Not{a}, e); }
  // The margin of `e`, or of its negation.
  ValueId margin(const sema::Expr& e, bool wanted) {
    const ValueId result =
        std::visit([&](const auto& node) { return margin(node, e, wanted); }, e.node);
    const auto* logic = std::get_if<sema::Logic>(&e.node);
    const bool is_not = logic && logic->op == sema::LogicOp::logical_not;
    if (!wanted && !is_not) values_.say_negated(result);
    return result;
  }
  ValueId atom(Op op, const sema::Expr& e, bool wanted) {
    const ValueId is = add(std::move(op), e);
    return wanted ? is : negated(is, e);
  }

  ValueId margin(const sema::Truth& v, const sema::Expr& e, bool wanted) {
    return add(Truth{v.value == wanted}, e);
  }
  ValueId margin(const sema::InputRef& v, const sema::Expr& e, bool wanted) {
    return atom(InputTruth{channel(v), v.component}, e, wanted);
  }
  ValueId margin(const sema::ZoneOpen& v, const sema::Expr& e, bool wanted) {
    return atom(Open{schedule_in(watch_.schedules, spec_[v.zone])}, e, wanted);
  }
  ValueId margin(const sema::IsValue& v, const sema::Expr& e, bool wanted) {
    return atom(InputIs{channel_of(watch_, spec_[v.input].name), v.component, v.value}, e, wanted);
  }
  ValueId margin(const sema::SameValue& v, const sema::Expr& e, bool wanted) {
    return atom(InputSame{channel(v.left), v.left.component, channel(v.right), v.right.component},
                e, wanted);
  }
  [[nodiscard]] std::uint32_t channel(const sema::InputRef& v) const {
    return channel_of(watch_, spec_[v.input].name);
  }
  // Of a robot; only facts have one.
  ValueId margin(const sema::InsideZone& v, const sema::Expr& e, bool wanted) {
    // bodies: the centre lies in the zone and keeps the radius, that is clearance >= 0
    const ValueId clearance = values_.clearance(v.zone, e);
    const ValueId zero = values_.zero(clearance, e);
    return add(AtLeast{wanted ? clearance : zero, wanted ? zero : clearance, !wanted}, e);
  }
  ValueId margin(const sema::ForOthers& v, const sema::Expr& e, bool wanted) {
    return atom(ForOthers{v.universal, std::make_unique<Block>(robot_->others(*v.body))}, e,
                wanted);
  }
  ValueId margin(const sema::PointInside& v, const sema::Expr& e, bool wanted) {
    const ValueId is = values_.inside(v, e);
    remember_unit(values_.millimetres());
    return wanted ? is : negated(is, e);
  }
  ValueId margin(const sema::TrailInside& v, const sema::Expr& e, bool wanted) {
    const ValueId is = values_.inside(v, e);
    remember_unit(values_.millimetres());
    return wanted ? is : negated(is, e);
  }
  ValueId margin(const sema::PathGiven& v, const sema::Expr& e, bool wanted) {
    return atom(PathGiven{channel_of(watch_, spec_[v.input].name)}, e, wanted);
  }
  // not (a >= b) is b > a, and so on: the margin stays that of one comparison.
  ValueId margin(const sema::Compare& v, const sema::Expr& e, bool wanted) {
    const bool at_most = v.op == sema::CompareOp::less || v.op == sema::CompareOp::less_equal;
    const bool strict = v.op == sema::CompareOp::less || v.op == sema::CompareOp::greater;
    const auto left = fold_constant(*v.left), right = fold_constant(*v.right);
    if (left && right) {
      const bool turned = at_most == wanted;
      return fixed_margin(turned ? Rational(*right - *left) : Rational(*left - *right),
                          strict == wanted, e);
    }
    const auto [a, b] = values_.on_one_grid(*v.left, *v.right);
    remember_unit(values_.unit_of(a));
    const bool swapped = at_most == wanted;
    return add(AtLeast{swapped ? b : a, swapped ? a : b, strict == wanted}, e);
  }
  // The margin of what has no input: `difference` in SI, which may lie between two millionths of
  // the scale. Its sign is known, and so is the verdict: below 0 both ends are, strictly.
  ValueId fixed_margin(const Rational& difference, bool strict, const sema::Expr& e) {
    const bool holds = strict ? sgn(difference) > 0 : sgn(difference) >= 0;
    const Rational scale = scale_of(spec_, compared_in(e));
    const Unit unit{compared_in(e), scale / 1'000'000, scale};
    const Rational steps = difference / unit.step;
    // kernel: what is beyond half of the greatest margin is told as more than that
    constexpr std::int64_t most = margin_max / 2;
    std::int64_t below = holds ? most : -margin_max, above = holds ? margin_max : -most;
    if (abs(steps) < Rational(static_cast<long>(most))) {
      below = floor_to_int(steps);
      above = ceil_to_int(steps);
    }
    const ValueId a = below == above ? values_.add(Const{below}, unit, e)
                                     : values_.add(Between{below, above}, unit, e);
    const ValueId b = values_.add(Const{0}, unit, e);
    remember_unit(unit);
    return add(AtLeast{a, b, !holds}, e);
  }
  static const sema::Dimension& compared_in(const sema::Expr& compare) {
    return std::get<sema::Compare>(compare.node).left->dimension;
  }
  void remember_unit(const Unit& unit) {
    const auto same = [&](const Unit& other) {
      return other.dimension == unit.dimension && other.scale == unit.scale;
    };
    auto& units = watch_.units;
    // entry 0 is that of truth values
    if (std::any_of(units.begin() + 1, units.end(), same)) return;
    units.push_back(unit);
  }

  ValueId margin(const sema::Logic& v, const sema::Expr& e, bool wanted) {
    const auto joined = [&](bool as_and, ValueId a, ValueId b) {
      return as_and ? add(And{a, b}, e) : add(Or{a, b}, e);
    };
    const sema::Expr& left = *v.operands[0];
    switch (v.op) {
      case sema::LogicOp::logical_not:
        return margin(left, !wanted);
      case sema::LogicOp::logical_and:
      case sema::LogicOp::logical_or: {
        const bool as_and = (v.op == sema::LogicOp::logical_and) == wanted;
        ValueId all = margin(left, wanted);
        for (std::size_t i = 1; i < v.operands.size(); ++i) {
          all = joined(as_and, all, margin(*v.operands[i], wanted));
        }
        return all;
      }
      case sema::LogicOp::implies: {
        const ValueId a = margin(left, !wanted);
        return joined(!wanted, a, margin(*v.operands[1], wanted));
      }
      case sema::LogicOp::iff:
      case sema::LogicOp::logical_xor:
        break;
    }
    // each operand is computed once: it may remember
    const ValueId a = margin(left, true);
    const ValueId b = margin(*v.operands[1], true);
    const auto literal = [&](ValueId id, bool positive) {
      return positive == wanted ? id : negated(id, e);
    };
    // (not a or b) and (not b or a); (a or b) and (not a or not b); or the negation of these
    const bool iff = v.op == sema::LogicOp::iff;
    const ValueId one = joined(!wanted, literal(a, !iff), literal(b, true));
    const ValueId other = iff ? joined(!wanted, literal(b, false), literal(a, true))
                              : joined(!wanted, literal(a, false), literal(b, false));
    return joined(wanted, one, other);
  }

  std::uint32_t slot() { return watch_.slots++; }
  // Of truth values alone there are no margins to remember.
  Window window(const sema::Interval& interval, std::initializer_list<ValueId> operands) const {
    Window w = values_.window(interval);
    w.full = w.full && std::any_of(operands.begin(), operands.end(),
                                   [&](ValueId id) { return values_.is_measured(id); });
    return w;
  }

  // What was not the case before the first tick is not the case there, nor is its negation.
  ValueId margin(const sema::Previously& v, const sema::Expr& e, bool wanted) {
    const ValueId a = margin(*v.operand, true);
    return atom(Previously{a, slot()}, e, wanted);
  }
  ValueId margin(const sema::Past& v, const sema::Expr& e, bool wanted) {
    const ValueId a = margin(*v.operand, wanted);
    const bool once = (v.op == sema::PastOp::once) == wanted;
    if (once) return add(Once{a, window(v.interval, {a}), slot()}, e);
    return add(Historically{a, window(v.interval, {a}), slot()}, e);
  }
  ValueId margin(const sema::Since& v, const sema::Expr& e, bool wanted) {
    const ValueId a = margin(*v.left, true);
    const ValueId b = margin(*v.right, true);
    return atom(Since{a, b, window(v.interval, {a, b}), slot()}, e, wanted);
  }
  // historically[0, d], and d has elapsed since the start
  ValueId margin(const sema::HeldFor& v, const sema::Expr& e, bool wanted) {
    const ValueId a = margin(*v.operand, wanted);
    const Window over = window({{0, v.duration.range}, v.duration}, {a});
    const ValueId all =
        wanted ? add(Historically{a, over, slot()}, e) : add(Once{a, over, slot()}, e);
    const ValueId long_enough = atom(Elapsed{over.to}, e, wanted);
    return wanted ? add(And{long_enough, all}, e) : add(Or{long_enough, all}, e);
  }
  // not ((not a) since[d, inf] (b and not a))
  ValueId margin(const sema::WithinOf& v, const sema::Expr& e, bool wanted) {
    const ValueId missing = margin(*v.operand, false);
    const ValueId trigger = margin(*v.trigger, true);
    const ValueId open = add(And{trigger, missing}, e);
    const ValueId late =
        add(Since{missing, open, window({v.duration, std::nullopt}, {missing, open}), slot()}, e);
    return wanted ? negated(late, e) : late;
  }
  ValueId margin(const sema::Choice& v, const sema::Expr& e, bool wanted) {
    const ValueId condition = margin(*v.condition, true);
    // (c and a) or (not c and b), or its negation: (not c or not a) and (c or not b)
    const auto branch = [&](ValueId a, ValueId b) {
      return wanted ? add(And{a, b}, e) : add(Or{a, b}, e);
    };
    const ValueId otherwise = negated(condition, e);
    const ValueId one = branch(wanted ? condition : otherwise, margin(*v.then_value, wanted));
    const ValueId other = branch(wanted ? otherwise : condition, margin(*v.else_value, wanted));
    return wanted ? add(Or{one, other}, e) : add(And{one, other}, e);
  }
  template <class Node>
  ValueId margin(const Node&, const sema::Expr& e, bool) {
    diagnostics_.report({diag::Code::expression_not_supported,
                         e.range,
                         "this is not a condition of a monitor without a robot",
                         "",
                         {},
                         "conditions on inputs work; those on a robot belong to `monitor ... for`",
                         {}});
    return add(Truth{false}, e);
  }

  const sema::Spec& spec_;
  Watch& watch_;
  diag::Engine& diagnostics_;
  const RobotSignals* robot_;  // null: none
  QuantityBuilder values_;
};

}  // namespace

Block build_watch_block(const sema::Expr& property, const sema::Spec& spec,
                        const SourceManager& sources, const TableMap& tables, Watch& watch,
                        diag::Engine& diagnostics, const RobotSignals* robot, bool margin_full) {
  return PropertyBuilder(spec, sources, tables, watch, diagnostics, robot, margin_full)
      .build(property);
}

}  // namespace rtac::ir
