// Arithmetic: of quantities, and of points and vectors by components.
#include <algorithm>

#include "compiler/sema/property_checker.h"
#include "compiler/syntax/print_expr.h"

namespace rtac::sema {

using syntax::BinaryOp;

Value PropertyChecker::wrong_operand(const SourceRange& range, const std::string& message,
                                     const std::string& help) {
  context_.report(
      Finding(Code::wrong_operand, range, message).label("these do not fit").help(help));
  return nullptr;
}

Value PropertyChecker::negated(const syntax::Expr& expr, Value operand) {
  if (!operand) return nullptr;
  const auto negate = [&](ExprPtr part) {
    const Dimension dimension = part->dimension;
    if (const auto value = constant_of(*part)) {
      return make_quantity(expr.range, dimension, Constant{Rational(-*value)});
    }
    return make_quantity(expr.range, dimension,
                         Arithmetic{ArithmeticOp::negate, operands_of(std::move(part))});
  };
  auto* typed = std::get_if<ExprPtr>(&operand.node);
  if (typed != nullptr && !(*typed)->boolean) return negate(std::move(*typed));
  auto* pair = std::get_if<Pair>(&operand.node);
  if (pair != nullptr && pair->kind != Pair::Kind::point) {
    return Pair{pair->kind, negate(std::move(pair->x)), negate(std::move(pair->y)),
                pair->z ? negate(std::move(pair->z)) : nullptr, pair->frame};
  }
  const auto& unary = std::get<syntax::Unary>(expr.node);
  return not_a_quantity(*unary.operand, describe(context_.spec, operand));
}

Value PropertyChecker::arithmetic(const syntax::Expr& expr, const syntax::Binary& binary,
                                  ArithmeticOp op) {
  const bool sum = op == ArithmeticOp::add || op == ArithmeticOp::subtract;
  if (!sum && (unit_with_blanks(binary) || unit_without_number(expr))) return nullptr;
  if (says_robot(*binary.left) && says_robot(*binary.right)) return infer(*binary.left);
  Value left = infer(*binary.left);
  const auto* first = std::get_if<ExprPtr>(&left.node);
  const bool typed = sum && first != nullptr && !(*first)->boolean;
  Value right =
      infer(*binary.right, typed ? std::optional<Dimension>((*first)->dimension) : std::nullopt);
  if (!left || !right) return nullptr;
  auto* one = std::get_if<ExprPtr>(&left.node);
  auto* other = std::get_if<ExprPtr>(&right.node);
  auto* one_pair = std::get_if<Pair>(&left.node);
  auto* other_pair = std::get_if<Pair>(&right.node);
  for (const auto& [value, written] :
       {std::pair(&left, binary.left.get()), std::pair(&right, binary.right.get())}) {
    const auto* scalar = std::get_if<ExprPtr>(&value->node);
    const bool usable =
        scalar != nullptr ? !(*scalar)->boolean : std::holds_alternative<Pair>(value->node);
    if (usable) continue;
    const auto* held = std::get_if<syntax::Held>(&binary.left->node);
    if (held != nullptr && written == binary.left.get()) return computed_duration(*held, binary);
    return not_a_quantity(*written, describe(context_.spec, *value));
  }
  if (one != nullptr && other != nullptr) {
    return scalars(expr, binary, op, std::move(*one), std::move(*other));
  }
  if (one_pair != nullptr && other_pair != nullptr) {
    return pairs(expr, binary, op, std::move(*one_pair), std::move(*other_pair));
  }
  if (one_pair != nullptr && !sum) {
    return scaled(expr, binary, op, std::move(*one_pair), std::move(*other));
  }
  if (other_pair != nullptr && op == ArithmeticOp::multiply) {
    return scaled(expr, binary, op, std::move(*other_pair), std::move(*one));
  }
  return wrong_operand(binary.op_range,
                       describe(context_.spec, left) + " and " + describe(context_.spec, right) +
                           " cannot be joined by `" +
                           (sum ? (op == ArithmeticOp::add ? "+" : "-") : "/") + "`",
                       "a vector is scaled by `*` and `/`, and added to a point or a vector");
}

// The kernel divides by constants only: see the help.
bool PropertyChecker::divisor_fits(const syntax::Expr& divisor, const Expr& typed) {
  if (constant_of(typed) || generic_ || sees_robot()) return true;
  Finding finding(Code::not_constant, divisor.range, "a divisor must be known at compile time");
  finding.label("not a constant")
      .help(
          "multiply the other side instead, as in `a >= 2 * b` for `a / b >= 2`, or compute the "
          "quotient outside and pass it as `input ... error e`");
  if (function_ != nullptr) finding.note(call_, "it is not a constant in this call");
  context_.report(finding);
  return false;
}

ExprPtr PropertyChecker::scalars(const syntax::Expr& expr, const syntax::Binary& binary,
                                 ArithmeticOp op, ExprPtr left, ExprPtr right) {
  const auto left_value = constant_of(*left);
  const auto right_value = constant_of(*right);
  const auto dimension =
      combine(context_, binary.op, {binary.left.get(), left->dimension, left_value},
              {binary.right.get(), right->dimension, right_value}, binary.op_range);
  if (!dimension) return nullptr;
  if (op == ArithmeticOp::divide && !divisor_fits(*binary.right, *right)) return nullptr;
  if (left_value && right_value) {
    return make_quantity(expr.range, *dimension,
                         Constant{fold(binary.op, *left_value, *right_value)});
  }
  return make_quantity(expr.range, *dimension,
                       Arithmetic{op, operands_of(std::move(left), std::move(right))});
}

Value PropertyChecker::pairs(const syntax::Expr& expr, const syntax::Binary& binary,
                             ArithmeticOp op, Pair left, Pair right) {
  using Kind = Pair::Kind;
  const bool minus = op == ArithmeticOp::subtract;
  std::optional<Kind> kind;
  if (op == ArithmeticOp::add || minus) {
    const bool one = left.kind == Kind::point;
    const bool other = right.kind == Kind::point;
    if (one && other) {
      if (minus) kind = Kind::vector;
    } else if (one) {
      kind = minus && right.kind == Kind::literal ? Kind::vector : Kind::point;
    } else if (other) {
      // point + vector; a literal minus a point is the vector between two points
      if (!minus) kind = Kind::point;
      if (minus && left.kind == Kind::literal) kind = Kind::vector;
    } else {
      kind = left.kind == Kind::literal ? right.kind : left.kind;
    }
  }
  if (!kind) {
    const bool product = op == ArithmeticOp::multiply || op == ArithmeticOp::divide;
    const Value one(std::move(left));
    const Value other(std::move(right));
    return wrong_operand(
        binary.op_range,
        describe(context_.spec, one) + " and " + describe(context_.spec, other) + " cannot be " +
            (product ? (op == ArithmeticOp::divide ? "divided" : "multiplied")
                     : (minus ? "subtracted" : "added")),
        product ? "write `dot(v, w)` or `cross(v, w)` for the product of two vectors"
                : "subtract two points, or add a vector to a point");
  }
  if (!agree(binary.op_range, minus ? "`-`" : "`+`", left, right) ||
      !combine(context_, binary.op, {binary.left.get(), left.x->dimension, std::nullopt},
               {binary.right.get(), right.x->dimension, std::nullopt}, binary.op_range)) {
    return nullptr;
  }
  ExprPtr x = scalars(expr, binary, op, std::move(left.x), std::move(right.x));
  ExprPtr y = scalars(expr, binary, op, std::move(left.y), std::move(right.y));
  ExprPtr z = left.z ? scalars(expr, binary, op, std::move(left.z), std::move(right.z)) : nullptr;
  return Pair{*kind, std::move(x), std::move(y), std::move(z),
              left.frame ? left.frame : right.frame};
}

Value PropertyChecker::scaled(const syntax::Expr& expr, const syntax::Binary& binary,
                              ArithmeticOp op, Pair pair, ExprPtr factor) {
  if (pair.kind == Pair::Kind::point) {
    return wrong_operand(binary.op_range, "a point cannot be scaled",
                         "scale a vector, such as the difference of two points");
  }
  if (!affordable(expr, size_of(Value(clone(*factor))) * (pair.z ? 2 : 1))) return nullptr;
  ExprPtr x = scalars(expr, binary, op, std::move(pair.x), clone(*factor));
  ExprPtr y = x ? scalars(expr, binary, op, std::move(pair.y), clone(*factor)) : nullptr;
  if (!x || !y) return nullptr;
  ExprPtr z = pair.z ? scalars(expr, binary, op, std::move(pair.z), std::move(factor)) : nullptr;
  return Pair{Pair::Kind::vector, std::move(x), std::move(y), std::move(z), pair.frame};
}

// `(p, room) >= 5 cm`: the arguments of a function whose name is missing.
bool PropertyChecker::lacks_callee(const syntax::Expr& expr, const syntax::PointLit& point) {
  const auto any = [&](const auto& is) {
    return std::any_of(point.coordinates.begin(), point.coordinates.end(), is);
  };
  const bool zone = any([&](const syntax::ExprPtr& each) { return says_zone(*each); });
  const bool place = any([&](const syntax::ExprPtr& each) {
    const syntax::Name* name = name_in(*each);
    const bool is_local = name != nullptr && local(name->text) != nullptr;
    return !is_local && (says_robot(*each) || speaks_of_points(*each));
  });
  if (!zone && !place) return false;
  const std::string written = print_expr(expr);
  context_.report(Finding(Code::point_expected, expr.range,
                          std::string("the coordinates of a point are quantities, and there is ") +
                              (zone ? "a zone" : "a place") + " among them")
                      .label("is the name of a function missing?")
                      .help("write `distance" + written + "`" +
                            (zone ? " or `clearance" + written + "`" : "")));
  return true;
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::PointLit& point) {
  if (lacks_callee(expr, point)) return nullptr;
  const std::size_t count = point.coordinates.size();
  if (count != 2 && count != 3) {
    context_.report(Finding(Code::point_expected, expr.range,
                            "points and vectors have two coordinates, or three in space")
                        .label(std::to_string(count) + " coordinates")
                        .help("write `(1 m, 2 m)` or `(1 m, 2 m, 3 m)`"));
    return nullptr;
  }
  auto parts = quantities(point.coordinates, count == 2 ? "a pair" : "a triple");
  if (!parts) return nullptr;
  return Pair{Pair::Kind::literal, std::move((*parts)[0]), std::move((*parts)[1]),
              count == 3 ? std::move((*parts)[2]) : nullptr, std::nullopt};
}

}  // namespace rtac::sema
