#include "compiler/sema/quantity.h"

#include "compiler/sema/units.h"

namespace rtac::sema {

using syntax::BinaryOp;

namespace {

// Beyond both, no quantity means anything; below, everything is computed at once.
constexpr int exponent_max = 32;
constexpr std::size_t constant_bits_max = 8192;

bool is_sum(BinaryOp op) {
  return op == BinaryOp::add || op == BinaryOp::subtract;
}
bool is_product(BinaryOp op) {
  return op == BinaryOp::multiply || op == BinaryOp::divide;
}

void report_not_constant(Context& context, const syntax::Expr& expr) {
  const std::string form = form_of(expr);
  if (!form.empty()) {
    context.report(
        Finding(Code::quantity_expected, expr.range, form + " stands where a quantity is due")
            .label("this is " + form)
            .help("write a number with its unit, such as `0.2 m`"));
    return;
  }
  std::string help = "write a number with its unit; constants may be joined by + - * /";
  if (const auto* reference = std::get_if<syntax::NameRef>(&expr.node)) {
    const std::string& name = reference->name.text;
    if (name == "inf")
      help = "`inf` stands as the upper end of an interval and as the `max_age` of an input only";
    const Symbol* symbol = context.symbols.find(name);
    const bool is_param = symbol != nullptr && symbol->sort == Sort::parameter;
    if (is_param || (symbol != nullptr && symbol->sort == Sort::input)) {
      help = "`" + name + "` is " +
             (is_param ? "a `param`, which may move" : "an input, which is known") +
             " at run time" + (is_param ? "" : " only") + ": write a number here";
    }
    if (name == "infinity" || name == "Inf" || name == "INF") help = "write `inf`";
  }
  context.report(Finding(Code::not_constant, expr.range, "this value must be known at compile time")
                     .label("not a constant")
                     .help(help));
}

// What may stand for a value.
bool is_value(const Context& context, const std::string& name) {
  const Symbol* symbol = context.symbols.find(name);
  return symbol != nullptr && (symbol->sort == Sort::input || symbol->sort == Sort::parameter ||
                               symbol->sort == Sort::enum_value);
}

std::optional<Measure> evaluate(Context& context, const syntax::Expr& expr,
                                const std::optional<Dimension>& due);

std::optional<Measure> evaluate_binary(Context& context, const syntax::Expr& expr,
                                       const syntax::Binary& binary,
                                       const std::optional<Dimension>& due) {
  if (!is_sum(binary.op) && !is_product(binary.op)) {
    report_not_constant(context, expr);
    return std::nullopt;
  }
  const auto inner = is_sum(binary.op) ? due : std::nullopt;
  const auto left = evaluate(context, *binary.left, inner);
  const auto right = evaluate(context, *binary.right, inner);
  if (!left || !right) return std::nullopt;
  const auto dimension =
      combine(context, binary.op, {binary.left.get(), left->dimension, left->value},
              {binary.right.get(), right->dimension, right->value}, binary.op_range);
  if (!dimension) return std::nullopt;
  return Measure{fold(binary.op, left->value, right->value), *dimension};
}

std::optional<Measure> evaluate(Context& context, const syntax::Expr& expr,
                                const std::optional<Dimension>& due) {
  if (is_error(expr)) return std::nullopt;
  if (const auto* number = std::get_if<syntax::NumberLit>(&expr.node)) {
    return literal(context, *number, due);
  }
  const auto known = [&](const std::string& name) { return is_value(context, name); };
  if (const std::string unit = unit_alone(expr, known); !unit.empty()) {
    report_number_missing(context, expr.range, unit);
    return std::nullopt;
  }
  if (const auto* unary = std::get_if<syntax::Unary>(&expr.node);
      unary != nullptr && unary->op == syntax::UnaryOp::negate) {
    auto operand = evaluate(context, *unary->operand, due);
    if (operand) operand->value = -operand->value;
    return operand;
  }
  if (const auto* binary = std::get_if<syntax::Binary>(&expr.node)) {
    return evaluate_binary(context, expr, *binary, due);
  }
  report_not_constant(context, expr);
  return std::nullopt;
}

bool within(const Rational& value, Limit limit) {
  switch (limit) {
    case Limit::any:
      return true;
    case Limit::not_negative:
      return value >= 0;
    case Limit::positive:
      return value > 0;
    case Limit::share:
      return value >= 0 && value <= 1;
  }
  return true;
}

const char* words_for(Limit limit) {
  switch (limit) {
    case Limit::any:
      return "any value";
    case Limit::not_negative:
      return "0 or more";
    case Limit::positive:
      return "more than 0";
    case Limit::share:
      return "0 % to 100 %";
  }
  return "";
}

std::size_t bits_of(const Rational& value) {
  return mpz_sizeinbase(value.get_num_mpz_t(), 2) + mpz_sizeinbase(value.get_den_mpz_t(), 2);
}

void report_too_large(Context& context, const SourceRange& range, const std::string& what,
                      const std::string& limit) {
  context.report(Finding(Code::limit_exceeded, range, what)
                     .label("at most " + limit)
                     .help("up to " + limit + " work; write the result as a number"));
}

// `let` and functions can square a value again and again: a short text would fill the memory, and
// the exponents of its unit would overflow.
bool product_fits(Context& context, BinaryOp op, const Operand& left, const Operand& right,
                  const SourceRange& op_range) {
  const Dimension dimension = op == BinaryOp::multiply ? left.dimension * right.dimension
                                                       : left.dimension / right.dimension;
  if (largest_exponent(dimension) > exponent_max) {
    report_too_large(context, op_range,
                     "the unit of this product has an exponent that is too large",
                     std::to_string(exponent_max));
    return false;
  }
  const bool constant = left.constant && right.constant;
  if (!constant || bits_of(*left.constant) + bits_of(*right.constant) <= constant_bits_max) {
    return true;
  }
  report_too_large(context, op_range, "this constant is too long",
                   std::to_string(constant_bits_max) + " bits");
  return false;
}

}  // namespace

std::string unit_alone(const syntax::Expr& expr,
                       const std::function<bool(const std::string&)>& is_value) {
  if (const auto* reference = std::get_if<syntax::NameRef>(&expr.node)) {
    const std::string& name = reference->name.text;
    return parse_unit(name) && !is_value(name) ? name : "";
  }
  const auto* binary = std::get_if<syntax::Binary>(&expr.node);
  if (binary == nullptr || !is_product(binary->op)) return "";
  const std::string left = unit_alone(*binary->left, is_value);
  const std::string right = unit_alone(*binary->right, is_value);
  if (left.empty() || right.empty()) return "";
  return left + (binary->op == BinaryOp::divide ? "/" : "*") + right;
}

void report_number_missing(Context& context, const SourceRange& range, const std::string& unit) {
  context.report(Finding(Code::quantity_expected, range,
                         "a number is missing in front of the unit `" + unit + "`")
                     .label("a unit alone")
                     .help("write the number that is meant, such as `3 " + unit + "`"));
}

std::optional<Measure> literal(Context& context, const syntax::NumberLit& number,
                               const std::optional<Dimension>& due) {
  if (!number.unit) return Measure{number.value, dims::number};
  const auto meaning = parse_unit(number.unit->text);
  if (meaning) return Measure{Rational(number.value * meaning->factor), meaning->dimension};
  Finding finding(Code::unknown_unit, number.unit->range,
                  "the unit `" + number.unit->text + "` is not known");
  finding.label("not a unit");
  if (is_celsius(number.unit->text)) {
    const Rational kelvin = number.value + Rational(27315, 100);
    finding.help("temperatures are in K, 273.15 more than in degrees Celsius: `" +
                 to_decimal(kelvin) + " K`");
  } else if (const auto likely = suggest_unit(number.unit->text, due)) {
    finding.help("did you mean `" + *likely + "`?").replace(number.unit->range, *likely);
  } else if (due && *due != dims::number) {
    finding.help(describe(*due) + " is due here, for example `" + number.text + " " +
                 unit_of(*due) + "`");
  } else {
    finding.help("units are products of m, s, rad, %, kg, A, K and the like: `m/s^2`, `%/m`");
  }
  context.report(finding);
  return std::nullopt;
}

std::optional<Dimension> combine(Context& context, BinaryOp op, const Operand& left,
                                 const Operand& right, const SourceRange& op_range) {
  if (is_product(op) && !product_fits(context, op, left, right, op_range)) return std::nullopt;
  if (op == BinaryOp::multiply) return left.dimension * right.dimension;
  if (op == BinaryOp::divide) {
    if (!right.constant || *right.constant != 0) return left.dimension / right.dimension;
    context.report(Finding(Code::division_by_zero, right.expr->range, "a division by zero")
                       .label("this is 0")
                       .help("divide by a value other than 0"));
    return std::nullopt;
  }
  if (left.dimension == right.dimension) return left.dimension;
  const std::string action =
      op == BinaryOp::add ? "added" : (op == BinaryOp::subtract ? "subtracted" : "compared");
  for (const auto& [bare, other] : {std::pair(left, right), std::pair(right, left)}) {
    const syntax::Expr* number = bare_number(*bare.expr);
    if (number == nullptr || bare.dimension != dims::number) continue;
    report_unit_missing(context, *number, other.dimension,
                        "the other side is " + describe(other.dimension));
    return std::nullopt;
  }
  context.report(Finding(Code::dimensions_differ, op_range,
                         describe(left.dimension) + " and " + describe(right.dimension) +
                             " cannot be " + action)
                     .label("the two sides differ")
                     .note(left.expr->range, "this is " + describe(left.dimension))
                     .note(right.expr->range, "this is " + describe(right.dimension))
                     .help("bring both sides to one dimension"));
  return std::nullopt;
}

Rational fold(BinaryOp op, const Rational& left, const Rational& right) {
  if (op == BinaryOp::add) return left + right;
  if (op == BinaryOp::subtract) return left - right;
  if (op == BinaryOp::multiply) return left * right;
  return left / right;
}

const syntax::Expr* bare_number(const syntax::Expr& expr) {
  if (const auto* number = std::get_if<syntax::NumberLit>(&expr.node)) {
    return number->unit ? nullptr : &expr;
  }
  const auto* unary = std::get_if<syntax::Unary>(&expr.node);
  if (unary == nullptr || unary->op != syntax::UnaryOp::negate) return nullptr;
  return bare_number(*unary->operand);
}

void report_unit_missing(Context& context, const syntax::Expr& expr, const Dimension& due,
                         const std::string& what) {
  const auto& number = std::get<syntax::NumberLit>(expr.node);
  Finding finding(Code::unit_missing, expr.range,
                  "`" + number.text + "` has no unit where " + describe(due) + " is due");
  finding.label(what);
  // 0.9 may be a share of one or nine tenths of a per cent: the author decides.
  if (due == dims::ratio && sgn(number.value) != 0 && number.value <= 1) {
    finding.help("write `" + to_decimal(Rational(number.value * 100)) + " %` or `" + number.text +
                 " %`, whichever is meant");
  } else if (due == dims::angle && sgn(number.value) != 0) {
    // an author thinks in degrees, the dimension is in radians
    finding.help("write `" + number.text + " deg` or `" + number.text +
                 " rad`, whichever is meant");
  } else {
    const std::string unit = likely_unit(due, number.value);
    finding.help("write `" + number.text + " " + unit + "`").insert_after(expr.range, " " + unit);
  }
  context.report(finding);
}

std::optional<Quantity> quantity(Context& context, const syntax::Expr& expr, const Due& due) {
  const auto measure = evaluate(context, expr, due.dimension);
  if (!measure) return std::nullopt;
  if (measure->dimension != due.dimension) {
    const syntax::Expr* number = bare_number(expr);
    if (number != nullptr) {
      report_unit_missing(context, *number, due.dimension,
                          due.what + " is " + describe(due.dimension));
    } else {
      std::string help = due.dimension == dims::number
                             ? "write a number without a unit"
                             : "write a value in " + unit_of(due.dimension);
      const auto* literal = std::get_if<syntax::NumberLit>(&expr.node);
      const bool has_unit = literal != nullptr && literal->unit;
      if (due.dimension == dims::number && has_unit) help = "write `" + literal->text + "`";
      // a rate for a period, or the reverse
      if (due.dimension == dims::time && measure->dimension == dims::number / dims::time &&
          sgn(measure->value) != 0) {
        help = "write `" + show(Rational(1 / measure->value), dims::time) +
               "`, the period of that rate";
      }
      if (!due.type.empty()) {
        help = "a type takes its unit in brackets: `" + due.type + " [" +
               unit_of(measure->dimension) + "]`";
      }
      // `162 deg` for `162 deg/s`
      if (has_unit && measure->dimension / dims::time == due.dimension) {
        help = "write `" + literal->text + " " + literal->unit->text + "/s` for a rate";
      }
      context.report(
          Finding(Code::wrong_dimension, expr.range,
                  describe(due.dimension) + " is due, this is " + describe(measure->dimension))
              .label(due.what + " is " + describe(due.dimension))
              .help(std::move(help)));
    }
    return std::nullopt;
  }
  if (!within(measure->value, due.limit)) {
    context.report(Finding(Code::quantity_out_of_range, expr.range,
                           due.what + " cannot be " + show(measure->value, due.dimension))
                       .label("must be " + std::string(words_for(due.limit)))
                       .help(due.works.empty()
                                 ? "a value of " + std::string(words_for(due.limit)) + " works"
                                 : due.works));
    return std::nullopt;
  }
  return Quantity{measure->value, expr.range};
}

std::optional<Measure> positive_constant(Context& context, const syntax::Expr& expr,
                                         const std::string& what) {
  const auto measure = evaluate(context, expr, std::nullopt);
  if (!measure || measure->value > 0) return measure;
  context.report(Finding(Code::quantity_out_of_range, expr.range,
                         what + " cannot be " + show(measure->value, measure->dimension))
                     .label("must be more than 0")
                     .help("a value of more than 0 works"));
  return std::nullopt;
}

std::optional<int> count(Context& context, const syntax::Expr& expr, const std::string& what,
                         int low, int high) {
  const auto number = quantity(context, expr, {dims::number, what, Limit::any});
  if (!number) return std::nullopt;
  if (number->value.get_den() == 1 && number->value >= low && number->value <= high) {
    return static_cast<int>(floor_to_int(number->value));
  }
  const std::string range = std::to_string(low) + " to " + std::to_string(high);
  context.report(Finding(Code::quantity_out_of_range, expr.range,
                         what + " cannot be " + show(number->value, dims::number))
                     .label("must be a whole number from " + range)
                     .help("a whole number from " + range + " works"));
  return std::nullopt;
}

std::string form_of(const syntax::Expr& expr) {
  if (std::holds_alternative<syntax::PointLit>(expr.node)) return "a point";
  if (std::holds_alternative<syntax::RectangleLit>(expr.node) ||
      std::holds_alternative<syntax::CircleLit>(expr.node) ||
      std::holds_alternative<syntax::PolygonLit>(expr.node) ||
      std::holds_alternative<syntax::PrismLit>(expr.node) ||
      std::holds_alternative<syntax::ImportLit>(expr.node)) {
    return "a zone";
  }
  if (std::holds_alternative<syntax::BoolLit>(expr.node) ||
      std::holds_alternative<syntax::Held>(expr.node) ||
      std::holds_alternative<syntax::Quantified>(expr.node) ||
      std::holds_alternative<syntax::Previously>(expr.node) ||
      std::holds_alternative<syntax::Past>(expr.node) ||
      std::holds_alternative<syntax::Since>(expr.node) ||
      std::holds_alternative<syntax::WithinOf>(expr.node)) {
    return "a condition";
  }
  if (const auto* unary = std::get_if<syntax::Unary>(&expr.node)) {
    return unary->op == syntax::UnaryOp::logical_not ? "a condition" : "";
  }
  const auto* binary = std::get_if<syntax::Binary>(&expr.node);
  if (binary == nullptr || is_sum(binary->op) || is_product(binary->op)) return "";
  const bool zone = binary->op == BinaryOp::zone_union || binary->op == BinaryOp::zone_intersection;
  return zone ? "a zone" : "a condition";
}

}  // namespace rtac::sema
