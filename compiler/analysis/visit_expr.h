// Visits a checked expression and everything in it, from the outside in.
#pragma once

#include <variant>

#include "compiler/sema/spec.h"

namespace rtac::analysis {

template <class Visit>
void visit_expr(const sema::Expr& e, const Visit& visit) {
  visit(e);
  const auto go = [&](const sema::ExprPtr& child) { visit_expr(*child, visit); };
  if (const auto* v = std::get_if<sema::Arithmetic>(&e.node)) {
    for (const auto& operand : v->operands) go(operand);
  } else if (const auto* l = std::get_if<sema::Logic>(&e.node)) {
    for (const auto& operand : l->operands) go(operand);
  } else if (const auto* c = std::get_if<sema::Compare>(&e.node)) {
    go(c->left);
    go(c->right);
  } else if (const auto* h = std::get_if<sema::HeldFor>(&e.node)) {
    go(h->operand);
  } else if (const auto* f = std::get_if<sema::ForOthers>(&e.node)) {
    go(f->body);
  }
}

}  // namespace rtac::analysis
