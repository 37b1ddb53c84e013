// Habits of other languages that only types tell from a mistake in a name: `open & moving`,
// `5 m / s`, `5 [m]`.
#include "compiler/sema/property_checker.h"
#include "compiler/sema/units.h"
#include "compiler/syntax/print_expr.h"

namespace rtac::sema {

using syntax::BinaryOp;

Value PropertyChecker::zones_or_conditions(const syntax::Expr& expr, const syntax::Binary& binary) {
  const auto is_signal = [&](const syntax::Expr& operand) {
    const syntax::Name* name = name_in(operand);
    const Symbol* symbol = name != nullptr ? context_.symbols.find(name->text) : nullptr;
    return symbol == nullptr || symbol->sort != Sort::zone;
  };
  if (sees_robot() || (!is_signal(*binary.left) && !is_signal(*binary.right))) {
    return not_a_quantity(expr, "a zone");
  }
  const bool both = binary.op == BinaryOp::zone_intersection;
  const std::string sign = both ? "`&`" : "`|`";
  const std::string word = both ? "and" : "or";
  context_.report(Finding(Code::wrong_operand, binary.op_range, sign + " joins zones")
                      .label("conditions are joined by `" + word + "`")
                      .help("write `" + word + "`")
                      .replace(binary.op_range, word));
  return nullptr;
}

// `5 m / s` divides by something called `s`; the unit `m/s` has no blanks inside.
bool PropertyChecker::unit_with_blanks(const syntax::Binary& binary) {
  const auto* number = std::get_if<syntax::NumberLit>(&binary.left->node);
  const syntax::Name* name = name_in(*binary.right);
  if (number == nullptr || name == nullptr || !number->unit) return false;
  if (local(name->text) != nullptr || context_.symbols.find(name->text) != nullptr) return false;
  const char* const sign = binary.op == BinaryOp::divide ? "/" : "*";
  const std::string unit = number->unit->text + sign + name->text;
  if (!parse_unit(unit)) return false;
  const SourceRange& written = number->unit->range;
  if (!context_.first_unknown(*name)) return true;
  context_.report(
      Finding(Code::unknown_name, name->range, "the name `" + name->text + "` is not declared")
          .label("no unit: a blank stands in front of it")
          .help("a unit is written without blanks: `" + unit + "`")
          .replace({written.file, written.begin, name->range.end}, unit));
  return true;
}

// `x <= m/s`
bool PropertyChecker::unit_without_number(const syntax::Expr& expr) {
  const auto is_value = [&](const std::string& name) {
    const Symbol* symbol = context_.symbols.find(name);
    const bool is_monitor =
        symbol != nullptr && (symbol->sort == Sort::watch || symbol->sort == Sort::monitor);
    return local(name) != nullptr || (symbol != nullptr && !is_monitor);
  };
  const std::string unit = unit_alone(expr, is_value);
  if (unit.empty()) return false;
  report_number_missing(context_, expr.range, unit);
  return true;
}

bool PropertyChecker::unit_in_brackets(const syntax::Expr& expr, const syntax::Index& index) {
  const auto* number = std::get_if<syntax::NumberLit>(&index.base->node);
  const syntax::Name* name = name_in(*index.index);
  if (number == nullptr || number->unit || name == nullptr || !parse_unit(name->text)) return false;
  const SourceRange brackets{expr.range.file, index.base->range.end, expr.range.end};
  context_.report(Finding(Code::wrong_operand, brackets, "a number has no elements to choose from")
                      .label("a unit stands without brackets")
                      .help("write ` " + name->text + "` behind the number")
                      .replace(brackets, " " + name->text));
  return true;
}

// `p for 1 s + 1 s` adds to `p for 1 s`.
ExprPtr PropertyChecker::computed_duration(const syntax::Held& held, const syntax::Binary& sum) {
  const std::string sign = sum.op == BinaryOp::add        ? " + "
                           : sum.op == BinaryOp::subtract ? " - "
                           : sum.op == BinaryOp::multiply ? " * "
                                                          : " / ";
  const std::string whole =
      "(" + syntax::print_expr(*held.duration) + sign + syntax::print_expr(*sum.right) + ")";
  const SourceRange& duration = held.duration->range;
  context_.report(Finding(Code::quantity_expected, sum.op_range, "the duration of `for` ends here")
                      .label("joins a condition to a quantity")
                      .help("a duration that is computed stands in brackets: `for " + whole + "`")
                      .replace({duration.file, duration.begin, sum.right->range.end}, whole));
  return nullptr;
}

}  // namespace rtac::sema
