#include "compiler/ir/watch_quantities.h"

#include <algorithm>

#include "compiler/ir/operands.h"
#include "compiler/ir/signals.h"
#include "compiler/ir/source_text.h"
#include "compiler/ir/watch_blocks.h"
#include "compiler/sema/dimension.h"
#include "compiler/sema/same.h"

namespace rtac::ir {
namespace {

using diag::Code;

// Longest source text that is worth a comment.
constexpr std::size_t shown_characters = 80;
// A tick is a microsecond at least, so no window is longer.
constexpr std::int64_t micros_per_second = 1'000'000;

std::optional<Rational> fold_sum(const sema::Arithmetic& a, const Rational& left,
                                 const Rational& right) {
  switch (a.op) {
    case sema::ArithmeticOp::add:
      return Rational(left + right);
    case sema::ArithmeticOp::subtract:
      return Rational(left - right);
    case sema::ArithmeticOp::multiply:
      return Rational(left * right);
    case sema::ArithmeticOp::divide:
      return sgn(right) == 0 ? std::nullopt : std::optional<Rational>(left / right);
    case sema::ArithmeticOp::negate:
      break;
  }
  return std::nullopt;
}

// The exact root of a square.
std::optional<Rational> exact_root(const Rational& value) {
  if (sgn(value) < 0 || !mpz_perfect_square_p(value.get_num().get_mpz_t()) ||
      !mpz_perfect_square_p(value.get_den().get_mpz_t())) {
    return std::nullopt;
  }
  return Rational(sqrt(value.get_num()), sqrt(value.get_den()));
}

std::optional<Rational> fold_math(const sema::Math& m) {
  std::vector<Rational> values;
  for (const sema::ExprPtr& operand : m.operands) {
    const auto value = fold_constant(*operand);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  switch (m.op) {
    case sema::MathOp::minimum:
      return *std::min_element(values.begin(), values.end());
    case sema::MathOp::maximum:
      return *std::max_element(values.begin(), values.end());
    case sema::MathOp::absolute:
      return Rational(abs(values[0]));
    case sema::MathOp::square_root:
      return exact_root(values[0]);
    case sema::MathOp::sine:
    case sema::MathOp::cosine:
      return std::nullopt;  // a rational number of no other angle than 0, which sema has folded
    case sema::MathOp::norm:
      break;
  }
  Rational squares = 0;
  for (const Rational& value : values) squares += value * value;
  return exact_root(squares);
}

// What remembers verdicts only has no finite margin.
bool remembers_margins(const Op& op) {
  return std::visit(
      [](const auto& node) {
        if constexpr (requires { node.window; }) {
          return node.window.full;
        } else {
          return true;
        }
      },
      op);
}

}  // namespace

std::optional<Rational> fold_constant(const sema::Expr& e) {
  if (const auto* c = std::get_if<sema::Constant>(&e.node)) return c->value;
  if (const auto* m = std::get_if<sema::Math>(&e.node)) return fold_math(*m);
  const auto* a = std::get_if<sema::Arithmetic>(&e.node);
  if (!a) return std::nullopt;
  const auto left = fold_constant(*a->operands[0]);
  if (!left) return std::nullopt;
  if (a->op == sema::ArithmeticOp::negate) return Rational(-*left);
  const auto right = fold_constant(*a->operands[1]);
  return right ? fold_sum(*a, *left, *right) : std::nullopt;
}

Block QuantityBuilder::take(ValueId result) {
  block_.result = result;
  return std::move(block_);
}

ValueId QuantityBuilder::add(Op op, std::optional<Unit> unit, const sema::Expr& e) {
  bool measured = std::holds_alternative<AtLeast>(op) || std::holds_alternative<ForOthers>(op);
  for_each_operand(op, [&](ValueId& id) { measured = measured || is_measured(id); });
  measured_.push_back(measured && remembers_margins(op));
  std::string text = one_line(sources_.text(e.range));
  if (text.size() > shown_characters) text = text.substr(0, shown_characters - 3) + "...";
  block_.values.push_back({std::move(op), std::move(unit), std::nullopt, e.range, std::move(text)});
  return ValueId(block_.values.size() - 1);
}

ValueId QuantityBuilder::quantity(const sema::Expr& e) {
  if (const auto value = fold_constant(e)) return constant_alone(*value, e);
  return std::visit([&](const auto& node) { return quantity(node, e); }, e.node);
}
template <class Node>
ValueId QuantityBuilder::quantity(const Node&, const sema::Expr& e) {
  return refuse(e, "this is not a quantity of a monitor without a robot",
                "inputs, parameters and arithmetic with them work");
}

ValueId QuantityBuilder::quantity(const sema::InputRef& v, const sema::Expr& e) {
  const std::uint32_t channel = channel_of(watch_, spec_[v.input].name);
  return add(Input{channel, v.component}, watch_.inputs[channel].grid(v.component).unit, e);
}
ValueId QuantityBuilder::quantity(const sema::ParamRef& v, const sema::Expr& e) {
  const std::uint32_t param = param_of(watch_, spec_[v.param].name);
  return add(ParamValue{param}, watch_.params[param].unit, e);
}
ValueId QuantityBuilder::quantity(const sema::AgeOf& v, const sema::Expr& e) {
  return add(Age{channel_of(watch_, spec_[v.input].name)},
             unit(e.dimension, Rational(1, micros_per_second)), e);
}
ValueId QuantityBuilder::quantity(const sema::SensedAge& v, const sema::Expr& e) {
  const Sensed signal = v.signal == sema::Sensed::position   ? Sensed::position
                        : v.signal == sema::Sensed::velocity ? Sensed::velocity
                                                             : Sensed::battery;
  return add(SensedAge{signal}, unit(e.dimension, Rational(1, micros_per_second)), e);
}

// Of robots, on their grids of lengths, speeds and charge.
ValueId QuantityBuilder::quantity(const sema::SignalRef& v, const sema::Expr& e) {
  if (robot_ == nullptr || v.subject != sema::Subject::self) {
    return refuse(e, "this signal of a robot cannot be compared here",
                  "`clearance`, `distance` from a zone and the robot's own `battery` and `speed` "
                  "work here; pass it as an input");
  }
  switch (v.signal) {
    case sema::Signal::battery:
      return add(Battery{}, unit(e.dimension, Unit::ppm.step), e);
    case sema::Signal::speed:
      return add(Speed{}, unit(e.dimension, Unit::mmps.step), e);
    case sema::Signal::altitude:
      break;
  }
  return add(Altitude{}, unit(e.dimension, Unit::mm.step), e);
}
ValueId QuantityBuilder::quantity(const sema::Clearance& v, const sema::Expr& e) {
  return clearance(v.zone, e);
}
ValueId QuantityBuilder::quantity(const sema::AgentDistance& v, const sema::Expr& e) {
  return add(AgentDistance{robot_->agent(v)}, unit(sema::dims::length, Unit::mm.step), e);
}
ValueId QuantityBuilder::clearance(sema::ZoneId zone, const sema::Expr& e) {
  return add(Clearance{robot_->tables.zone(zone)}, unit(sema::dims::length, Unit::mm.step), e);
}
ValueId QuantityBuilder::zero(ValueId like, const sema::Expr& e) {
  const Unit same = unit_of(like);
  return add(Const{0}, same, e);
}
ValueId QuantityBuilder::quantity(const sema::CountOthers& v, const sema::Expr& e) {
  return add(CountOthers{std::make_unique<Block>(robot_->others(*v.body))}, Unit::robots, e);
}
ValueId QuantityBuilder::quantity(const sema::EnergyTo& v, const sema::Expr& e) {
  const auto& site =
      robot_->tables
          .sites[static_cast<std::uint32_t>(robot_->kind)][static_cast<std::uint32_t>(v.site)];
  if (!site) {
    return refuse(e,
                  "no recovery of this kind of robot routes to this site, so its way has no price",
                  "a recovery `route to` the site works");
  }
  return add(EnergyTo{*site}, unit(e.dimension, Unit::ppm.step), e);
}

ValueId QuantityBuilder::quantity(const sema::Arithmetic& v, const sema::Expr& e) {
  const sema::Expr& left = *v.operands[0];
  switch (v.op) {
    case sema::ArithmeticOp::negate: {
      const ValueId a = quantity(left);
      return add(Negate{a}, unit_of(a), e);
    }
    case sema::ArithmeticOp::add:
    case sema::ArithmeticOp::subtract: {
      auto [a, b] = on_one_grid(left, *v.operands[1]);
      if (v.op == sema::ArithmeticOp::subtract) b = add(Negate{b}, unit_of(b), *v.operands[1]);
      return add(Add{a, b}, unit_of(a), e);
    }
    case sema::ArithmeticOp::multiply: {
      const sema::Expr& right = *v.operands[1];
      if (const auto k = fold_constant(left)) return scaled(right, *k, e);
      if (const auto k = fold_constant(right)) return scaled(left, *k, e);
      const ValueId a = quantity(left);
      return sema::same_value(left, right) ? square(a, e) : product(a, quantity(right), e);
    }
    case sema::ArithmeticOp::divide:
      break;
  }
  const auto k = fold_constant(*v.operands[1]);
  if (k && sgn(*k) != 0) return scaled(left, Rational(1 / *k), e);
  return refuse(e, k ? "a division by zero" : "a division by something that changes at run time",
                k ? "divide by a constant that is not zero"
                  : "multiply the other side of the comparison instead, or compute the quotient "
                    "outside and pass it as `input ... error e`");
}

ValueId QuantityBuilder::quantity(const sema::Math& v, const sema::Expr& e) {
  switch (v.op) {
    case sema::MathOp::absolute: {
      const ValueId a = quantity(*v.operands[0]);
      return add(Absolute{a}, unit_of(a), e);
    }
    case sema::MathOp::square_root:
      return root(quantity(*v.operands[0]), e);
    case sema::MathOp::norm:
      return norm(v, e);
    case sema::MathOp::sine:
    case sema::MathOp::cosine:
      return wave(v, e);
    case sema::MathOp::minimum:
    case sema::MathOp::maximum:
      break;
  }
  const auto least = [&](Pair p) {
    const Unit shared = unit_of(p.first);
    return v.op == sema::MathOp::minimum ? add(Minimum{p.first, p.second}, shared, e)
                                         : add(Maximum{p.first, p.second}, shared, e);
  };
  ValueId all = least(on_one_grid(*v.operands[0], *v.operands[1]));
  for (std::size_t i = 2; i < v.operands.size(); ++i) {
    const auto fixed = fold_constant(*v.operands[i]);
    if (fixed) all = fitted(all, *fixed, e);
    const ValueId next =
        fixed ? constant(*fixed, unit_of(all), *v.operands[i], e) : quantity(*v.operands[i]);
    all = least(meet(all, e, next, *v.operands[i]));
  }
  return all;
}

ValueId QuantityBuilder::quantity(const sema::Choice& v, const sema::Expr& e) {
  const ValueId condition = condition_(*v.condition);
  const auto [a, b] = on_one_grid(*v.then_value, *v.else_value);
  return add(Choose{condition, a, b}, unit_of(a), e);
}

ValueId QuantityBuilder::quantity(const sema::Aggregate& v, const sema::Expr& e) {
  const auto folded = [&](Fold fold, ValueId a, const Unit& in) {
    return add(Aggregate{fold, a, window(v.interval), watch_.slots++}, in, e);
  };
  switch (v.op) {
    case sema::AggregateOp::count:
      return folded(Fold::count, condition_(*v.operand), unit({}, 1));
    case sema::AggregateOp::rate:
      return rate(v, e);
    case sema::AggregateOp::mean:
    case sema::AggregateOp::sum:
      if (!v.interval.to) {
        return refuse(e, "a sum over all of the past does not fit the integer kernel",
                      "a window that ends works: `[0 s, 10 s]`");
      }
      break;
    case sema::AggregateOp::minimum:
    case sema::AggregateOp::maximum:
      break;
  }
  ValueId a = quantity(*v.operand);
  if (v.op == sema::AggregateOp::mean) a = averaged(a, *v.operand);
  const Fold fold = v.op == sema::AggregateOp::minimum   ? Fold::minimum
                    : v.op == sema::AggregateOp::maximum ? Fold::maximum
                    : v.op == sema::AggregateOp::mean    ? Fold::mean
                                                         : Fold::sum;
  return folded(fold, a, unit_of(a));
}

// The difference over the window in steps of the operand is the rate in steps per window length:
// exact, until it is brought onto the usual grid.
ValueId QuantityBuilder::rate(const sema::Aggregate& v, const sema::Expr& e) {
  const ValueId a = quantity(*v.operand);
  const Window over = window(v.interval);
  const Rational seconds =
      (v.interval.to ? v.interval.to->value : Rational(0)) - v.interval.from.value;
  if (over.to <= over.from) {
    return refuse(e, "a rate over no time", "`rate[0 s, 1 s](x)` works: it ends after it starts");
  }
  const Unit raw = unit(e.dimension, Rational(unit_of(a).step / seconds));
  const ValueId difference = add(Aggregate{Fold::rate, a, over, watch_.slots++}, raw, e);
  Unit to = finest(e.dimension);
  to.step = common_step(raw.step, to.step);
  if (!to.is_fine_enough()) to.step = to.scale / 1'000'000;
  return regrid(difference, to, e);
}

Window QuantityBuilder::window(const sema::Interval& interval) const {
  // theory of margins: rings of windows beyond this many ticks would leave the cache
  constexpr std::int64_t longest_full = 1024;
  Window w{ticks(interval.from.value), interval.to ? ticks(interval.to->value) : -1, true};
  w.full = margin_full_ || std::max(w.from, w.to) <= longest_full;
  return w;
}
std::int64_t QuantityBuilder::ticks(const Rational& seconds) const {
  return ceil_to_int(
      Rational(seconds * micros_per_second / Rational(static_cast<long>(watch_.period_us))));
}

}  // namespace rtac::ir
