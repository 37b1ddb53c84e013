// Quantities known at compile time: literals and their arithmetic, exact, with dimensions.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "compiler/sema/context.h"
#include "compiler/sema/dimension.h"

namespace rtac::sema {

struct Measure {
  Rational value;  // SI
  Dimension dimension;
};

// What may stand in a place.
enum class Limit { any, not_negative, positive, share };  // share: 0 % to 100 %
struct Due {
  Dimension dimension;
  std::string what;  // "the radius of the body"
  Limit limit = Limit::any;
  std::string works{};  // the help, where the limit alone is not what works
  std::string type{};   // of the value, where it is one that may have a unit and has none
};

// The unit that an expression is instead of a number with one: `m/s`; "" where it is none. Names
// that `is_value` knows are no units.
std::string unit_alone(const syntax::Expr& expr,
                       const std::function<bool(const std::string&)>& is_value);
void report_number_missing(Context& context, const SourceRange& range, const std::string& unit);

// A number with its unit. `due` only improves the suggestion for an unknown unit.
std::optional<Measure> literal(Context& context, const syntax::NumberLit& number,
                               const std::optional<Dimension>& due);

// The operands of an arithmetic operation or a comparison, typed.
struct Operand {
  const syntax::Expr* expr;
  Dimension dimension;
  std::optional<Rational> constant;
};
// The dimension of `left op right` (of either side when op compares); reports and returns nullopt
// when the dimensions do not fit or the divisor is the constant 0.
std::optional<Dimension> combine(Context& context, syntax::BinaryOp op, const Operand& left,
                                 const Operand& right, const SourceRange& op_range);
// The value of `left op right`; `op` is one of + - * / and a divisor is not 0.
Rational fold(syntax::BinaryOp op, const Rational& left, const Rational& right);

// Is the whole expression one number without a unit, a minus apart? The one that lacks its unit.
const syntax::Expr* bare_number(const syntax::Expr& expr);
// Reports that `number` lacks the unit of `due`; `what` says what is due there.
void report_unit_missing(Context& context, const syntax::Expr& number, const Dimension& due,
                         const std::string& what);

// The constant value of an expression of the dimension and within the limit that are due.
std::optional<Quantity> quantity(Context& context, const syntax::Expr& expr, const Due& due);
// The value of a constant of any dimension, more than 0.
std::optional<Measure> positive_constant(Context& context, const syntax::Expr& expr,
                                         const std::string& what);
// A whole number in low..high.
std::optional<int> count(Context& context, const syntax::Expr& expr, const std::string& what,
                         int low, int high);

// "a zone", "a point": what an expression is by its form; empty for what may be a quantity.
std::string form_of(const syntax::Expr& expr);

}  // namespace rtac::sema
