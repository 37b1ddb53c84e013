#include "compiler/sema/property.h"

#include "compiler/sema/property_checker.h"

namespace rtac::sema {

using syntax::BinaryOp;

ExprPtr make_quantity(const SourceRange& range, const Dimension& dimension,
                      decltype(Expr::node) node) {
  return std::make_unique<Expr>(Expr{range, false, dimension, std::move(node)});
}

ExprPtr make_condition(const SourceRange& range, decltype(Expr::node) node) {
  return std::make_unique<Expr>(Expr{range, true, dims::number, std::move(node)});
}

ExprPtr check_property(Context& context, const syntax::Expr& expr, const PropertyScope& scope) {
  return PropertyChecker(context, scope).condition(expr);
}

namespace {

std::optional<Rational> constant_of(const Expr& expr) {
  const auto* constant = std::get_if<Constant>(&expr.node);
  return constant != nullptr ? std::optional(constant->value) : std::nullopt;
}

std::vector<ExprPtr> list(ExprPtr first, ExprPtr second = nullptr) {
  std::vector<ExprPtr> operands;
  operands.push_back(std::move(first));
  if (second) operands.push_back(std::move(second));
  return operands;
}

}  // namespace

ExprPtr PropertyChecker::infer(const syntax::Expr& expr, const std::optional<Dimension>& due) {
  if (const auto* number = std::get_if<syntax::NumberLit>(&expr.node)) {
    return constant(expr, *number, due);
  }
  return std::visit([&](const auto& node) { return form(expr, node); }, expr.node);
}

ExprPtr PropertyChecker::condition(const syntax::Expr& expr) {
  ExprPtr typed = infer(expr);
  if (!typed || typed->boolean) return typed;
  context_.report(Finding(Code::truth_expected, expr.range,
                          "a condition is due, this is " + describe(typed->dimension))
                      .label("not true or false")
                      .help("compare it with a limit by `>=` or `<=`"));
  return nullptr;
}

ExprPtr PropertyChecker::quantity_of(const syntax::Expr& expr,
                                     const std::optional<Dimension>& due) {
  ExprPtr typed = infer(expr, due);
  if (!typed || !typed->boolean) return typed;
  return not_a_quantity(expr, "a condition");
}

ExprPtr PropertyChecker::not_a_quantity(const syntax::Expr& expr, const std::string& what) {
  const bool zone = what == "a zone";
  context_.report(Finding(Code::quantity_expected, expr.range, "a quantity is due, this is " + what)
                      .label("this is " + what)
                      .help(zone ? "write `" + scope_.self.text + " inside ...` or `clearance(" +
                                       scope_.self.text + ", ...)` with the zone"
                                 : "write a number with its unit, or a quantity such as "
                                   "`clearance(" +
                                       scope_.self.text + ", zone)`"));
  return nullptr;
}

ExprPtr PropertyChecker::constant(const syntax::Expr& expr, const syntax::NumberLit& number,
                                  const std::optional<Dimension>& due) {
  const auto measure = literal(context_, number, due);
  if (!measure) return nullptr;
  return make_quantity(expr.range, measure->dimension, Constant{measure->value});
}

ExprPtr PropertyChecker::form(const syntax::Expr& expr, const syntax::NumberLit& number) {
  return constant(expr, number, std::nullopt);
}

ExprPtr PropertyChecker::form(const syntax::Expr& expr, const syntax::BoolLit& truth) {
  return make_condition(expr.range, Truth{truth.value});
}

ExprPtr PropertyChecker::form(const syntax::Expr&, const syntax::ErrorExpr&) {
  return nullptr;
}

ExprPtr PropertyChecker::form(const syntax::Expr& expr, const syntax::Unary& unary) {
  if (unary.op == syntax::UnaryOp::logical_not) {
    ExprPtr operand = condition(*unary.operand);
    if (!operand) return nullptr;
    return make_condition(expr.range, Logic{LogicOp::logical_not, list(std::move(operand))});
  }
  ExprPtr operand = quantity_of(*unary.operand);
  if (!operand) return nullptr;
  const Dimension dimension = operand->dimension;
  if (const auto value = constant_of(*operand)) {
    return make_quantity(expr.range, dimension, Constant{Rational(-*value)});
  }
  return make_quantity(expr.range, dimension,
                       Arithmetic{ArithmeticOp::negate, list(std::move(operand))});
}

ExprPtr PropertyChecker::form(const syntax::Expr& expr, const syntax::Binary& binary) {
  switch (binary.op) {
    case BinaryOp::iff:
      return logic(expr, binary, LogicOp::iff);
    case BinaryOp::implies:
      return logic(expr, binary, LogicOp::implies);
    case BinaryOp::logical_xor:
      return logic(expr, binary, LogicOp::logical_xor);
    case BinaryOp::logical_or:
      return logic(expr, binary, LogicOp::logical_or);
    case BinaryOp::logical_and:
      return logic(expr, binary, LogicOp::logical_and);
    case BinaryOp::less:
      return comparison(expr, binary, CompareOp::less);
    case BinaryOp::less_equal:
      return comparison(expr, binary, CompareOp::less_equal);
    case BinaryOp::greater:
      return comparison(expr, binary, CompareOp::greater);
    case BinaryOp::greater_equal:
      return comparison(expr, binary, CompareOp::greater_equal);
    case BinaryOp::equal:
    case BinaryOp::not_equal:
      return equality(expr, binary);
    case BinaryOp::inside:
      return inside(expr, binary);
    case BinaryOp::zone_union:
    case BinaryOp::zone_intersection:
      return not_a_quantity(expr, "a zone");
    case BinaryOp::add:
      return arithmetic(expr, binary, ArithmeticOp::add);
    case BinaryOp::subtract:
      return arithmetic(expr, binary, ArithmeticOp::subtract);
    case BinaryOp::multiply:
      return arithmetic(expr, binary, ArithmeticOp::multiply);
    case BinaryOp::divide:
      return arithmetic(expr, binary, ArithmeticOp::divide);
  }
  return nullptr;
}

ExprPtr PropertyChecker::logic(const syntax::Expr& expr, const syntax::Binary& binary, LogicOp op) {
  ExprPtr left = condition(*binary.left);
  ExprPtr right = condition(*binary.right);
  if (!left || !right) return nullptr;
  return make_condition(expr.range, Logic{op, list(std::move(left), std::move(right))});
}

ExprPtr PropertyChecker::comparison(const syntax::Expr& expr, const syntax::Binary& binary,
                                    CompareOp op) {
  ExprPtr left = quantity_of(*binary.left);
  ExprPtr right =
      quantity_of(*binary.right, left ? std::optional<Dimension>(left->dimension) : std::nullopt);
  if (!left || !right) return nullptr;
  if (!combine(context_, binary.op, {binary.left.get(), left->dimension, constant_of(*left)},
               {binary.right.get(), right->dimension, constant_of(*right)}, binary.op_range)) {
    return nullptr;
  }
  return make_condition(expr.range, Compare{op, std::move(left), std::move(right)});
}

ExprPtr PropertyChecker::equality(const syntax::Expr& expr, const syntax::Binary& binary) {
  const std::string written = binary.op == BinaryOp::equal ? "==" : "!=";
  if (subject(*binary.left) || subject(*binary.right)) {
    context_.report(
        Finding(Code::equality_not_allowed, expr.range,
                "robots are compared only in the guard of `forall` and `exists`")
            .label("not a condition on its own")
            .help("write `forall q : " + kind_name() + ", q != " + scope_.self.text + " : ...`"));
    return nullptr;
  }
  ExprPtr left = infer(*binary.left);
  ExprPtr right = infer(*binary.right);
  if (!left || !right) return nullptr;
  const bool conditions = left->boolean && right->boolean;
  const std::string instead = binary.op == BinaryOp::equal ? "iff" : "xor";
  Finding finding(Code::equality_not_allowed, binary.op_range,
                  conditions ? "conditions are not compared with `" + written + "`"
                             : "a measured quantity never equals another one exactly");
  finding.label("`" + written + "` says nothing here");
  if (conditions) {
    finding.help("write `" + instead + "`").replace(binary.op_range, instead);
  } else {
    finding.help("write `>=` or `<=`, with the margin that is meant");
  }
  context_.report(finding);
  return nullptr;
}

ExprPtr PropertyChecker::arithmetic(const syntax::Expr& expr, const syntax::Binary& binary,
                                    ArithmeticOp op) {
  const bool sum = op == ArithmeticOp::add || op == ArithmeticOp::subtract;
  ExprPtr left = quantity_of(*binary.left);
  ExprPtr right = quantity_of(
      *binary.right, left && sum ? std::optional<Dimension>(left->dimension) : std::nullopt);
  if (!left || !right) return nullptr;
  const auto left_value = constant_of(*left);
  const auto right_value = constant_of(*right);
  const auto dimension =
      combine(context_, binary.op, {binary.left.get(), left->dimension, left_value},
              {binary.right.get(), right->dimension, right_value}, binary.op_range);
  if (!dimension) return nullptr;
  if (left_value && right_value) {
    return make_quantity(expr.range, *dimension,
                         Constant{fold(binary.op, *left_value, *right_value)});
  }
  return make_quantity(expr.range, *dimension,
                       Arithmetic{op, list(std::move(left), std::move(right))});
}

ExprPtr PropertyChecker::form(const syntax::Expr& expr, const syntax::Held& held) {
  if (!scope_.held_allowed || other_ != nullptr) {
    context_.report(Finding(Code::held_misplaced, expr.range,
                            std::string("`for` with a duration cannot stand ") +
                                (other_ != nullptr ? "inside `forall` or `exists`" : "in `always`"))
                        .label("only in `return when`")
                        .help(other_ != nullptr
                                  ? "write it around the quantifier: `(forall ...) for 1 s`"
                                  : "judge the present state here, and write `return when ... "
                                    "for 1 s`"));
    return nullptr;
  }
  ExprPtr operand = condition(*held.operand);
  const auto duration =
      quantity(context_, *held.duration, {dims::time, "the duration of `for`", Limit::positive});
  if (!operand || !duration) return nullptr;
  return make_condition(expr.range, HeldFor{std::move(operand), *duration});
}

ExprPtr PropertyChecker::form(const syntax::Expr& expr, const syntax::Quantified& quantified) {
  if (other_ != nullptr) {
    context_.report(
        Finding(Code::nested_quantifier, expr.range, "a quantifier stands inside another one")
            .label("the inner one")
            .note(other_->range, "the outer one binds `" + other_->text + "` here")
            .help("judge pairs of the monitored robot and one other robot"));
    return nullptr;
  }
  if (!quantifier_fits(quantified)) return nullptr;
  other_ = &quantified.variable;
  ExprPtr body = condition(*quantified.body);
  other_ = nullptr;
  if (!body) return nullptr;
  const bool universal = quantified.quantifier == syntax::Quantifier::forall;
  return make_condition(expr.range, ForOthers{universal, std::move(body)});
}

bool PropertyChecker::quantifier_fits(const syntax::Quantified& quantified) {
  const syntax::Name& variable = quantified.variable;
  const Symbol* hidden = context_.symbols.find(variable.text);
  if (variable.text == scope_.self.text || hidden != nullptr) {
    context_.report(
        Finding(Code::duplicate_name, variable.range, "the name `" + variable.text + "` is taken")
            .label("the second meaning")
            .note(hidden != nullptr ? hidden->range : scope_.self.range,
                  "`" + variable.text + "` is declared here")
            .help("give the other robot a name of its own, such as `q`"));
    return false;
  }
  const auto kind = context_.resolve<KindId>(quantified.kind, Sort::robot_kind);
  if (kind && scope_.kind && *kind != *scope_.kind) {
    const std::string& due = context_.spec[*scope_.kind].name;
    context_.report(Finding(Code::wrong_kind, quantified.kind.range,
                            "the monitored robot is a `" + due + "`, the other one a `" +
                                quantified.kind.text + "`")
                        .label("must be `" + due + "`")
                        .help("a property relates robots of one kind: write `" + due + "`"));
    return false;
  }
  return guard_fits(quantified) && kind.has_value();
}

bool PropertyChecker::guard_fits(const syntax::Quantified& quantified) {
  const std::string& other = quantified.variable.text;
  const std::string& self = scope_.self.text;
  const std::string due = other + " != " + self;
  if (!quantified.guard) {
    context_.report(Finding(Code::guard_missing, quantified.kind.range,
                            "`" + other + "` may be `" + self + "` itself")
                        .label("no guard")
                        .help("write `" + quantified.kind.text + ", " + due + "`")
                        .insert_after(quantified.kind.range, ", " + due));
    return false;
  }
  if (is_error(*quantified.guard)) return false;
  const auto names = [](const syntax::Expr& expr, const std::string& name) {
    const auto* reference = std::get_if<syntax::NameRef>(&expr.node);
    return reference != nullptr && reference->name.text == name;
  };
  const auto* binary = std::get_if<syntax::Binary>(&quantified.guard->node);
  if (binary != nullptr && binary->op == BinaryOp::not_equal &&
      ((names(*binary->left, other) && names(*binary->right, self)) ||
       (names(*binary->left, self) && names(*binary->right, other)))) {
    return true;
  }
  context_.report(Finding(Code::guard_missing, quantified.guard->range,
                          "the guard does not leave out `" + self + "` itself")
                      .label("must be `" + due + "`")
                      .help("write `" + due + "` and join other conditions by `implies`")
                      .replace(quantified.guard->range, due));
  return false;
}

}  // namespace rtac::sema
