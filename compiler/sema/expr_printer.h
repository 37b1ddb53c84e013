// Expressions and zones of a checked specification as text. Internal to spec_printer.h.
#pragma once

#include <string>
#include <vector>

#include "compiler/sema/spec.h"

namespace rtac::sema {

// SI throughout, so that equal quantities read the same however they were written.
std::string si_text(const Rational& value, const Dimension& dimension);
std::string si_text(const Quantity& quantity, const Dimension& dimension);

// "(1, 2)", in m.
std::string point_text(const Point& point);

class ExprPrinter {
 public:
  explicit ExprPrinter(const Spec& spec) : spec_(spec) {}

  [[nodiscard]] std::string zone(ZoneId id) const;
  [[nodiscard]] std::string zone(const ZoneExpr& expr) const;
  [[nodiscard]] std::string expr(const Expr& expr) const;

 private:
  [[nodiscard]] std::string input(const InputRef& reference) const;
  [[nodiscard]] std::string point(const Expr& x, const Expr& y, const Expr* z) const;
  [[nodiscard]] std::string trail(const Trail& trail) const;
  [[nodiscard]] std::string listed(const std::vector<ExprPtr>& operands) const;
  [[nodiscard]] std::string joined(const std::vector<ExprPtr>& operands, const char* symbol) const;

  const Spec& spec_;
};

}  // namespace rtac::sema
