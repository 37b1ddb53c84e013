#include "compiler/analysis/standoffs.h"

#include <algorithm>
#include <optional>

#include "compiler/analysis/visit_expr.h"
#include "compiler/support/rational.h"

namespace rtac::analysis {
namespace {

// clearance * (the clearance) + distance * (the distance) + constant, in SI.
struct Linear {
  Rational clearance, distance, constant;
  [[nodiscard]] bool is_constant() const { return sgn(clearance) == 0 && sgn(distance) == 0; }
};

Linear scaled(const Linear& a, const Rational& k) {
  return {a.clearance * k, a.distance * k, a.constant * k};
}
Linear sum(const Linear& a, const Linear& b) {
  return {a.clearance + b.clearance, a.distance + b.distance, a.constant + b.constant};
}

std::optional<Linear> linear(const sema::Expr& e);

// nullopt for what is not linear.
std::optional<Linear> linear(const sema::Arithmetic& v) {
  const auto a = linear(*v.operands[0]);
  const auto b = v.operands.size() > 1 ? linear(*v.operands[1]) : Linear{};
  if (!a || !b) return std::nullopt;
  switch (v.op) {
    case sema::ArithmeticOp::add:
      return sum(*a, *b);
    case sema::ArithmeticOp::subtract:
      return sum(*a, scaled(*b, -1));
    case sema::ArithmeticOp::negate:
      return scaled(*a, -1);
    case sema::ArithmeticOp::multiply:
      if (a->is_constant()) return scaled(*b, a->constant);
      if (b->is_constant()) return scaled(*a, b->constant);
      return std::nullopt;
    case sema::ArithmeticOp::divide:
      if (!b->is_constant() || sgn(b->constant) == 0) return std::nullopt;
      return scaled(*a, 1 / b->constant);
  }
  return std::nullopt;
}

std::optional<Linear> linear(const sema::Expr& e) {
  if (const auto* c = std::get_if<sema::Constant>(&e.node)) return Linear{0, 0, c->value};
  if (std::holds_alternative<sema::Clearance>(e.node)) return Linear{1, 0, 0};
  if (std::holds_alternative<sema::Distance>(e.node)) return Linear{0, 1, 0};
  if (const auto* a = std::get_if<sema::Arithmetic>(&e.node)) return linear(*a);
  return std::nullopt;
}

void raise(std::int64_t& most_mm, const Rational& metres) {
  // beyond the grid nothing is clear any more
  const Rational mm = std::min(Rational(metres * 1000), Rational(1 << 30));
  most_mm = std::max(most_mm, ceil_to_int(std::max(mm, Rational(0))));
}

}  // namespace

void ask_for_standoffs(const sema::Expr& property, Standoffs& wanted) {
  visit_expr(property, [&](const sema::Expr& e) {
    const auto* compare = std::get_if<sema::Compare>(&e.node);
    if (!compare) return;
    const auto left = linear(*compare->left), right = linear(*compare->right);
    if (!left || !right) return;
    const bool at_least =
        compare->op == sema::CompareOp::greater || compare->op == sema::CompareOp::greater_equal;
    // ... >= 0
    const Linear form = at_least ? sum(*left, scaled(*right, -1)) : sum(*right, scaled(*left, -1));
    if (sgn(form.clearance) > 0) raise(wanted.fence_mm, Rational(-form.constant / form.clearance));
    if (sgn(form.distance) > 0) {
      raise(wanted.separation_mm, Rational(-form.constant / form.distance));
    }
  });
}

}  // namespace rtac::analysis
