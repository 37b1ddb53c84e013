// Properties: the expressions of `always` and `return when`, typed.
#pragma once

#include <optional>
#include <string>

#include "compiler/sema/context.h"

namespace rtac::sema {

// Where a property stands.
struct PropertyScope {
  std::optional<KindId> kind;  // none: unknown, reported
  syntax::Name self;           // the variable of the monitored robot
  bool held_allowed;           // `φ for d`: only in `return when`
};

// The condition that `expr` says; nullptr when it has a mistake, which is then reported.
ExprPtr check_property(Context& context, const syntax::Expr& expr, const PropertyScope& scope);

// Calls `visit` for every expression below and including `expr`, outermost first.
template <class Visit>
void for_each_expr(const Expr& expr, Visit&& visit) {
  visit(expr);
  const auto descend = [&](const ExprPtr& operand) { for_each_expr(*operand, visit); };
  if (const auto* arithmetic = std::get_if<Arithmetic>(&expr.node)) {
    for (const ExprPtr& operand : arithmetic->operands) descend(operand);
  } else if (const auto* logic = std::get_if<Logic>(&expr.node)) {
    for (const ExprPtr& operand : logic->operands) descend(operand);
  } else if (const auto* compare = std::get_if<Compare>(&expr.node)) {
    descend(compare->left);
    descend(compare->right);
  } else if (const auto* held = std::get_if<HeldFor>(&expr.node)) {
    descend(held->operand);
  } else if (const auto* others = std::get_if<ForOthers>(&expr.node)) {
    descend(others->body);
  }
}

}  // namespace rtac::sema
