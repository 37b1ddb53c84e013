// In which direction a parameter tightens: it may only move there at run time, so that what was
// true of the whole range stays true. A trend is found for every expression from those of its
// operands; ranges of inputs decide about products and absolute values.
#include <algorithm>

#include "compiler/sema/watches.h"
#include "compiler/support/overloaded.h"

namespace rtac::sema {

namespace {

// Raising the parameter raises a quantity, or makes a condition true, because of `rising`; it
// lowers it, or makes it false, because of `falling`. Neither: it has no influence.
struct Trend {
  std::optional<SourceRange> rising, falling;
  [[nodiscard]] bool none() const { return !rising && !falling; }
};

Trend flipped(const Trend& trend) {
  return {trend.falling, trend.rising};
}
Trend joined(const Trend& a, const Trend& b) {
  return {a.rising ? a.rising : b.rising, a.falling ? a.falling : b.falling};
}
// Influenced in a way that nothing is known about.
Trend either_way(const Trend& trend) {
  const auto place = trend.rising ? trend.rising : trend.falling;
  return {place, place};
}

// Ends of a quantity; none: unbounded.
struct Ends {
  std::optional<Rational> least, most;
};
Ends negated(const Ends& ends) {
  const auto minus = [](const std::optional<Rational>& end) {
    return end ? std::optional<Rational>(Rational(-*end)) : std::nullopt;
  };
  return {minus(ends.most), minus(ends.least)};
}
std::optional<Rational> sum(const std::optional<Rational>& a, const std::optional<Rational>& b) {
  return a && b ? std::optional<Rational>(Rational(*a + *b)) : std::nullopt;
}
// The sign that is certain: +1 for 0 or more, -1 for 0 or less, 0 when it is not known.
int sign_of(const Ends& ends) {
  if (ends.least && *ends.least >= 0) return 1;
  return ends.most && *ends.most <= 0 ? -1 : 0;
}

class TrendFinder {
 public:
  TrendFinder(const Spec& spec, ParamId param) : spec_(spec), param_(param) {}

  [[nodiscard]] Trend of(const Expr& expr) const {
    return std::visit(
        Overloaded{
            [&](const ParamRef& reference) {
              return reference.param == param_ ? Trend{expr.range, std::nullopt} : Trend{};
            },
            [&](const Arithmetic& node) { return arithmetic(node); },
            [&](const Math& node) { return math(node); },
            [&](const Choice& choice) {
              const Trend values = joined(of(*choice.then_value), of(*choice.else_value));
              return joined(values, either_way(of(*choice.condition)));
            },
            [&](const Aggregate& aggregate) {
              const Trend trend = of(*aggregate.operand);
              return aggregate.op == AggregateOp::rate ? either_way(trend) : trend;
            },
            [&](const Compare& compare) {
              const bool above =
                  compare.op == CompareOp::greater || compare.op == CompareOp::greater_equal;
              const Trend left = of(*compare.left);
              const Trend right = of(*compare.right);
              return above ? joined(left, flipped(right)) : joined(flipped(left), right);
            },
            [&](const Logic& node) { return logic(node); },
            [&](const HeldFor& held) { return of(*held.operand); },
            [&](const Previously& previously) { return of(*previously.operand); },
            [&](const Past& past) { return of(*past.operand); },
            [&](const Since& since) { return joined(of(*since.left), of(*since.right)); },
            // not ((not a) since (b and not a)): a helps, b asks for more
            [&](const WithinOf& within) {
              return joined(of(*within.operand), flipped(of(*within.trigger)));
            },
            [&](const ForOthers& others) { return of(*others.body); },
            [&](const CountOthers& others) { return of(*others.body); },
            // a place that moves may come nearer to the boundary, and leave it
            [&](const PointInside& node) { return either_way(of_place(node)); },
            [&](const PointClearance& node) { return either_way(of_place(node)); },
            [&](const TrailInside& node) { return either_way(all(node.trail.own)); },
            [&](const TrailClearance& node) { return either_way(all(node.trail.own)); },
            [&](const TrailDistance& node) {
              return either_way(joined(all(node.trail.own), all(node.other.own)));
            },
            [](const auto&) { return Trend{}; },  // speaks of no parameter
        },
        expr.node);
  }

 private:
  template <class Node>
  [[nodiscard]] Trend of_place(const Node& node) const {
    const Trend flat = joined(of(*node.x), of(*node.y));
    return node.z ? joined(flat, of(*node.z)) : flat;
  }
  [[nodiscard]] Trend all(const std::vector<ExprPtr>& operands) const {
    Trend trend;
    for (const ExprPtr& operand : operands) trend = joined(trend, of(*operand));
    return trend;
  }

  // Multiplied by something of this sign.
  static Trend scaled(const Trend& trend, int sign) {
    if (sign == 0) return either_way(trend);
    return sign > 0 ? trend : flipped(trend);
  }

  [[nodiscard]] Trend arithmetic(const Arithmetic& node) const {
    const Expr& first = *node.operands.front();
    switch (node.op) {
      case ArithmeticOp::add:
        return all(node.operands);
      case ArithmeticOp::subtract:
        return joined(of(first), flipped(of(*node.operands[1])));
      case ArithmeticOp::negate:
        return flipped(of(first));
      case ArithmeticOp::multiply:
        return joined(scaled(of(first), sign_of(ends(*node.operands[1]))),
                      scaled(of(*node.operands[1]), sign_of(ends(first))));
      case ArithmeticOp::divide:  // by a constant
        return scaled(of(first), sign_of(ends(*node.operands[1])));
    }
    return {};
  }

  [[nodiscard]] Trend math(const Math& node) const {
    const bool waves = node.op == MathOp::sine || node.op == MathOp::cosine;
    if (waves) return either_way(all(node.operands));
    const bool folds = node.op == MathOp::absolute || node.op == MathOp::norm;
    if (!folds) return all(node.operands);
    Trend trend;
    for (const ExprPtr& operand : node.operands) {
      trend = joined(trend, scaled(of(*operand), sign_of(ends(*operand))));
    }
    return trend;
  }

  [[nodiscard]] Trend logic(const Logic& node) const {
    switch (node.op) {
      case LogicOp::logical_not:
        return flipped(of(*node.operands.front()));
      case LogicOp::logical_and:
      case LogicOp::logical_or:
        return all(node.operands);
      case LogicOp::implies:
        return joined(flipped(of(*node.operands[0])), of(*node.operands[1]));
      case LogicOp::iff:
      case LogicOp::logical_xor:
        return either_way(all(node.operands));
    }
    return {};
  }

  // A safe guess of the ends: it matters for signs only.
  [[nodiscard]] Ends ends(const Expr& expr) const {
    return std::visit(Overloaded{
                          [](const Constant& constant) {
                            return Ends{constant.value, constant.value};
                          },
                          [&](const InputRef& reference) {
                            return ends_of(spec_[reference.input].measurement(reference.component));
                          },
                          [&](const ParamRef& reference) {
                            const Param& param = spec_[reference.param];
                            return Ends{param.least.value, param.most.value};
                          },
                          [](const AgeOf&) {
                            return Ends{Rational(0), std::nullopt};
                          },
                          [](const SensedAge&) {
                            return Ends{Rational(0), std::nullopt};
                          },
                          [&](const Arithmetic& node) { return ends_of(node); },
                          [&](const Math& node) { return ends_of(node); },
                          [&](const Choice& choice) {
                            return hull(ends(*choice.then_value), ends(*choice.else_value));
                          },
                          [&](const Aggregate& aggregate) { return ends_of(aggregate); },
                          [](const auto&) { return Ends{}; },
                      },
                      expr.node);
  }

  // The true value lies within the error of a sample that lies within the range.
  static Ends ends_of(const Measurement& input) {
    if (!input.least || !input.most) return {};
    const Rational error = input.error ? input.error->value : Rational(0);
    return {Rational(input.least->value - error), Rational(input.most->value + error)};
  }

  static Ends hull(const Ends& a, const Ends& b) {
    Ends both;
    if (a.least && b.least) both.least = std::min(*a.least, *b.least);
    if (a.most && b.most) both.most = std::max(*a.most, *b.most);
    return both;
  }

  [[nodiscard]] Ends ends_of(const Arithmetic& node) const {
    const Ends first = ends(*node.operands.front());
    if (node.op == ArithmeticOp::negate) return negated(first);
    const Ends second = ends(*node.operands[1]);
    switch (node.op) {
      case ArithmeticOp::add:
        return {sum(first.least, second.least), sum(first.most, second.most)};
      case ArithmeticOp::subtract: {
        const Ends minus = negated(second);
        return {sum(first.least, minus.least), sum(first.most, minus.most)};
      }
      case ArithmeticOp::multiply:
      case ArithmeticOp::divide: {
        const int sign = sign_of(first) * sign_of(second);
        if (sign > 0) return {Rational(0), std::nullopt};
        return sign < 0 ? Ends{std::nullopt, Rational(0)} : Ends{};
      }
      case ArithmeticOp::negate:
        break;
    }
    return {};
  }

  [[nodiscard]] Ends ends_of(const Math& node) const {
    if (node.op == MathOp::sine || node.op == MathOp::cosine) return {Rational(-1), Rational(1)};
    if (node.op != MathOp::minimum && node.op != MathOp::maximum) {
      return {Rational(0), std::nullopt};  // absolute values, roots and lengths
    }
    Ends all = ends(*node.operands.front());
    for (const ExprPtr& operand : node.operands) {
      const Ends one = ends(*operand);
      const bool least = node.op == MathOp::minimum;
      Ends next = hull(all, one);
      // The smaller of two is below either upper end; the larger above either lower end.
      if (least) next.most = one.most && (!all.most || *one.most < *all.most) ? one.most : all.most;
      if (!least) {
        next.least = one.least && (!all.least || *one.least > *all.least) ? one.least : all.least;
      }
      all = next;
    }
    return all;
  }

  [[nodiscard]] Ends ends_of(const Aggregate& aggregate) const {
    if (aggregate.op == AggregateOp::count) return {Rational(0), std::nullopt};
    if (aggregate.op == AggregateOp::rate) return {};
    const Ends operand = ends(*aggregate.operand);
    if (aggregate.op != AggregateOp::sum) return operand;
    const int sign = sign_of(operand);
    if (sign > 0) return {Rational(0), std::nullopt};
    return sign < 0 ? Ends{std::nullopt, Rational(0)} : Ends{};
  }

  const Spec& spec_;
  ParamId param_;
};

void report_directions(Context& context, const Param& param, const Trend& trend) {
  Finding finding(Code::param_not_monotone, param.name_range,
                  "no direction of `" + param.name + "` is sure to tighten every monitor");
  finding.label("must tighten in one direction");
  if (*trend.rising == *trend.falling) {
    finding.note(*trend.rising, "here raising and lowering it may both loosen a monitor");
  } else {
    finding.note(*trend.rising, "here only lowering it tightens");
    finding.note(*trend.falling, "here only raising it tightens");
  }
  finding.help("use two parameters, one for each direction, or write the value as a constant");
  context.report(finding);
}

}  // namespace

void check_directions(Context& context) {
  for (std::uint32_t i = 0; i < context.spec.params.size(); ++i) {
    if (context.faulty_params.count(ParamId{i}) > 0) continue;
    Trend trend;
    const auto join = [&](const ExprPtr& condition) {
      if (condition) trend = joined(trend, TrendFinder(context.spec, ParamId{i}).of(*condition));
    };
    for (const Watch& watch : context.spec.watches) join(watch.always);
    for (const Monitor& monitor : context.spec.monitors) {
      join(monitor.always);
      join(monitor.return_when);  // who hands control back later is stricter
    }
    Param& param = context.spec.params[i];
    if (trend.rising && trend.falling) {
      report_directions(context, param, trend);
    } else if (!trend.none()) {
      param.tightens = trend.rising ? -1 : 1;
    }
  }
}

}  // namespace rtac::sema
