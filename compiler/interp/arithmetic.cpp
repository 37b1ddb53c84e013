#include "compiler/interp/arithmetic.h"

#include <cstddef>
#include <utility>
#include <variant>

#include "compiler/interp/signals.h"
#include "compiler/sema/same.h"

namespace rtac::interp {
namespace {

template <class Operator>
Span folded(const std::vector<Span>& operands, const Operator& op) {
  Span result = operands.front();
  for (std::size_t i = 1; i < operands.size(); ++i) result = op(result, operands[i]);
  return result;
}

struct WholeRange {
  const sema::Spec& spec;
  const Rational& period;
  Zones& zones;

  Span of(const sema::ExprPtr& operand) const { return std::visit(*this, operand->node); }
  std::vector<Span> all(const std::vector<sema::ExprPtr>& operands) const {
    std::vector<Span> spans;
    for (const sema::ExprPtr& operand : operands) spans.push_back(of(operand));
    return spans;
  }

  Span operator()(const sema::Constant& node) const { return exactly(node.value); }
  Span operator()(const sema::ParamRef& node) const {
    const sema::Param& param = spec[node.param];
    return between(param.least.value, param.most.value);
  }
  Span operator()(const sema::InputRef& node) const {
    return declared_range(spec, node.input, node.component);
  }
  Span operator()(const sema::Arithmetic& node) const {
    if (is_square(node)) return square(of(node.operands.front()));
    return arithmetic(node.op, all(node.operands));
  }
  Span operator()(const sema::Math& node) const { return math(node.op, all(node.operands)); }
  Span operator()(const sema::Choice& node) const {
    return hull(of(node.then_value), of(node.else_value));
  }
  Span operator()(const sema::PointClearance& node) const {
    Whereabouts anywhere{of(node.x), of(node.y), std::nullopt};
    if (node.z) anywhere.z = of(node.z);
    return zones.range(node.zone, anywhere);
  }
  Span operator()(const sema::ZoneDistance& node) const {
    return zones.apart(node.zone, node.other);
  }
  Span operator()(const sema::Aggregate& node) const {
    switch (node.op) {
      case sema::AggregateOp::minimum:
      case sema::AggregateOp::maximum:
      case sema::AggregateOp::mean:
        return of(node.operand);
      case sema::AggregateOp::count:
        return times_ticks(between(Rational(0), Rational(1)), node);
      case sema::AggregateOp::sum:
        return times_ticks(of(node.operand), node);
      case sema::AggregateOp::rate:
        break;
    }
    if (!node.interval.to || node.interval.to->value <= node.interval.from.value) {
      return unknown(std::nullopt);
    }
    const Span value = of(node.operand);
    return divide(subtract(value, value),
                  exactly(node.interval.to->value - node.interval.from.value));
  }
  // The age has no bound; the others are of robots, or no quantities.
  template <class Other>
  Span operator()(const Other&) const {
    return unknown(std::nullopt);
  }

  // Of none up to all ticks of the window.
  Span times_ticks(const Span& one, const sema::Aggregate& node) const {
    if (!node.interval.to) return unknown(std::nullopt);
    const Rational ticks = (node.interval.to->value - node.interval.from.value) / period + 1;
    return multiply(one, between(Rational(0), ticks));
  }
};

}  // namespace

bool is_square(const sema::Arithmetic& node) {
  return node.op == sema::ArithmeticOp::multiply && node.operands.size() == 2 &&
         sema::same_value(*node.operands[0], *node.operands[1]);
}

Span arithmetic(sema::ArithmeticOp op, const std::vector<Span>& operands) {
  switch (op) {
    case sema::ArithmeticOp::add:
      return folded(operands, add);
    case sema::ArithmeticOp::subtract:
      return folded(operands, subtract);
    case sema::ArithmeticOp::multiply:
      return folded(operands, multiply);
    case sema::ArithmeticOp::divide:
      return folded(operands, divide);
    case sema::ArithmeticOp::negate:
      break;
  }
  return negate(operands.front());
}

Span math(sema::MathOp op, const std::vector<Span>& operands) {
  switch (op) {
    case sema::MathOp::minimum:
      return folded(operands, minimum);
    case sema::MathOp::maximum:
      return folded(operands, maximum);
    case sema::MathOp::absolute:
      return absolute(operands.front());
    case sema::MathOp::square_root:
      return square_root(operands.front());
    case sema::MathOp::sine:
      return sine(operands.front());
    case sema::MathOp::cosine:
      return cosine(operands.front());
    case sema::MathOp::norm:
      break;
  }
  std::vector<Span> squares;
  for (const Span& operand : operands) squares.push_back(square(operand));
  return square_root(folded(squares, add));
}

Span whole_range(const sema::Expr& expr, const sema::Spec& spec, const Rational& period,
                 Zones& zones) {
  return std::visit(WholeRange{spec, period, zones}, expr.node);
}

}  // namespace rtac::interp
