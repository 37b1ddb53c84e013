// `==` and `!=`: on whole numbers, conditions and values of enumerations; what is measured is never
// exactly equal to anything.
#include "compiler/sema/property_checker.h"
#include "compiler/syntax/print_expr.h"

namespace rtac::sema {

using syntax::BinaryOp;

ExprPtr PropertyChecker::equality(const syntax::Expr& expr, const syntax::Binary& binary) {
  if (says_robot(*binary.left) || says_robot(*binary.right)) {
    const std::string self = sees_robot() ? scope_.self.text : "r";
    context_.report(Finding(Code::equality_not_allowed, expr.range,
                            "robots are compared only in the guard of `forall` and `exists`")
                        .label("not a condition on its own")
                        .help("write `forall q : " + kind_name() + ", q != " + self + " : ...`"));
    return nullptr;
  }
  const int outer = polarity_;
  polarity_ = 0;
  ++asked_twice_;
  Value left = infer(*binary.left);
  Value right = infer(*binary.right);
  --asked_twice_;
  polarity_ = outer;
  if (!left || !right) return nullptr;
  auto* one = std::get_if<ExprPtr>(&left.node);
  auto* other = std::get_if<ExprPtr>(&right.node);
  if (one != nullptr && other != nullptr && (*one)->boolean && (*other)->boolean) {
    const LogicOp op = binary.op == BinaryOp::equal ? LogicOp::iff : LogicOp::logical_xor;
    return make_condition(expr.range, Logic{op, operands_of(std::move(*one), std::move(*other))});
  }
  if (one != nullptr && other != nullptr && !(*one)->boolean && !(*other)->boolean) {
    return same_numbers(expr, binary, std::move(*one), std::move(*other));
  }
  return same_values(expr, binary, left, right);
}

ExprPtr PropertyChecker::same_numbers(const syntax::Expr& expr, const syntax::Binary& binary,
                                      ExprPtr left, ExprPtr right) {
  if (!is_integer(context_.spec, *left) || !is_integer(context_.spec, *right)) {
    if (!combine(context_, BinaryOp::less, {binary.left.get(), left->dimension, std::nullopt},
                 {binary.right.get(), right->dimension, std::nullopt}, binary.op_range)) {
      return nullptr;
    }
    const std::string written = binary.op == BinaryOp::equal ? "==" : "!=";
    const bool one_whole = is_integer(context_.spec, *left) || is_integer(context_.spec, *right);
    const auto value = constant_of(is_integer(context_.spec, *left) ? *right : *left);
    if (one_whole && value) {
      context_.report(Finding(Code::equality_not_allowed, binary.op_range,
                              "a whole number is never " + to_decimal(*value))
                          .label("`" + written + "` says nothing here")
                          .help("compare it with a whole number, or write `>=` or `<=`"));
      return nullptr;
    }
    context_.report(Finding(Code::equality_not_allowed, binary.op_range,
                            "a measured quantity never equals another one exactly")
                        .label("`" + written + "` says nothing here")
                        .help("write `>=` or `<=`, with the margin that is meant"));
    return nullptr;
  }
  const std::size_t copies = size_of(Value(clone(*left))) + size_of(Value(clone(*right)));
  if (!affordable(expr, copies)) return nullptr;
  const bool equal = binary.op == BinaryOp::equal;
  ExprPtr below = compare(expr.range, equal ? CompareOp::less_equal : CompareOp::less, clone(*left),
                          clone(*right));
  ExprPtr above = compare(expr.range, equal ? CompareOp::greater_equal : CompareOp::greater,
                          std::move(left), std::move(right));
  if (!below || !above) return nullptr;
  return make_condition(expr.range, Logic{equal ? LogicOp::logical_and : LogicOp::logical_or,
                                          operands_of(std::move(below), std::move(above))});
}

ExprPtr PropertyChecker::same_values(const syntax::Expr& expr, const syntax::Binary& binary,
                                     const Value& left, const Value& right) {
  const auto type = enumeration_of(left);
  if (!type || type != enumeration_of(right)) return not_comparable(binary, left, right);
  ExprPtr same = same_value(expr, left, right);
  if (binary.op == BinaryOp::equal || !same) return same;
  return make_condition(expr.range, Logic{LogicOp::logical_not, operands_of(std::move(same))});
}

// (if c then a else b) == v is `if c then a == v else b == v`.
ExprPtr PropertyChecker::same_value(const syntax::Expr& expr, const Value& left,
                                    const Value& right) {
  for (const auto& [choice, value] : {std::pair(&left, &right), std::pair(&right, &left)}) {
    const auto* chosen = std::get_if<EnumChoice>(&choice->node);
    if (chosen == nullptr) continue;
    if (!affordable(expr, 2 * size_of(Value(clone(*chosen->condition))) + 1)) return nullptr;
    ExprPtr yes = same_value(expr, chosen->options[0], *value);
    ExprPtr no = yes ? same_value(expr, chosen->options[1], *value) : nullptr;
    return no ? chosen_condition(expr, *chosen->condition, std::move(yes), std::move(no)) : nullptr;
  }
  const auto* one = std::get_if<EnumSignal>(&left.node);
  const auto* other = std::get_if<EnumSignal>(&right.node);
  const auto* value = std::get_if<EnumValue>(one != nullptr ? &right.node : &left.node);
  const auto* two = std::get_if<EnumValue>(&right.node);
  const EnumSignal* component = one != nullptr ? one : other;
  if (one != nullptr && other != nullptr) {
    return make_condition(expr.range, SameValue{one->signal, other->signal});
  }
  if (component != nullptr) {
    return make_condition(
        expr.range, IsValue{component->signal.input, component->signal.component, value->value});
  }
  return make_condition(expr.range, Truth{value->value == two->value});
}

ExprPtr PropertyChecker::not_comparable(const syntax::Binary& binary, const Value& left,
                                        const Value& right) {
  const bool pair =
      std::holds_alternative<Pair>(left.node) || std::holds_alternative<Pair>(right.node);
  const std::string one = describe(context_.spec, left);
  const std::string other = describe(context_.spec, right);
  // `open == 1`, as in languages where conditions are numbers
  const auto* a = std::get_if<ExprPtr>(&left.node);
  const auto* b = std::get_if<ExprPtr>(&right.node);
  if (a != nullptr && b != nullptr && (*a)->boolean != (*b)->boolean) {
    const std::string condition = syntax::print_expr((*a)->boolean ? *binary.left : *binary.right);
    const bool is_one_word = condition.find(' ') == std::string::npos;
    const std::string negated = is_one_word ? condition : "(" + condition + ")";
    wrong_operand(binary.op_range, one + " and " + other + " are not compared",
                  "a condition stands alone: `" + condition + "`, or `not " + negated + "`");
    return nullptr;
  }
  wrong_operand(binary.op_range,
                one == other ? one + " is not compared with another one"
                             : one + " and " + other + " are not compared",
                pair ? "write `distance(p, q) <= 1 cm` for points, `norm(v - w) <= 1 cm/s` for "
                       "vectors, with the margin that is meant"
                     : "compare whole numbers, conditions, or values of one enumeration");
  return nullptr;
}

}  // namespace rtac::sema
