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

std::vector<ExprPtr> operands_of(ExprPtr first, ExprPtr second) {
  std::vector<ExprPtr> operands;
  operands.push_back(std::move(first));
  if (second) operands.push_back(std::move(second));
  return operands;
}

std::optional<Rational> constant_of(const Expr& expr) {
  const auto* constant = std::get_if<Constant>(&expr.node);
  return constant != nullptr ? std::optional(constant->value) : std::nullopt;
}

// Reports a distance from a zone that is not always there, or of a path that may be empty, where no
// comparison has taken it apart.
static bool counts_while_open(Context& context, const Expr& checked) {
  const Expr* found = nullptr;
  for_each_expr(checked, [&](const Expr& each) {
    if (found == nullptr && std::holds_alternative<WhileOpen>(each.node)) found = &each;
  });
  if (found == nullptr) return false;
  const auto& what = std::get<WhileOpen>(found->node).what;
  if (const auto* path = std::get_if<InputId>(&what)) {
    const std::string& name = context.spec[*path].name;
    context.report(Finding(Code::expression_not_supported, found->range,
                           "`" + name + "` is endlessly far from everything while it is empty")
                       .label("compared with nothing by itself")
                       .note(context.spec[*path].name_range, "`" + name + "` may have no way-point")
                       .help("compare distances and clearances of it where they stand, alone or in "
                             "a sum, as in `distance(" +
                             name + ", p) >= 5 m`, and join such comparisons by `and`"));
    return true;
  }
  const ZoneId zone_id = std::get<ZoneId>(what);
  const std::string& zone = context.spec[zone_id].name;
  context.report(
      Finding(Code::zone_not_fixed, found->range,
              "the distance from `" + zone + "` is endless while that zone is not there")
          .label("compared with nothing by itself")
          .note(context.spec[zone_id].name_range, "`" + zone + "` is there at certain times only")
          .help("compare it where it stands, alone or in a sum, as in `distance(p, " + zone +
                ") >= 5 m`, and join such comparisons by `and`; their past is that of `once` and "
                "`historically`"));
  return true;
}

ExprPtr check_property(Context& context, const syntax::Expr& expr, const PropertyScope& scope) {
  ExprPtr checked = PropertyChecker(context, scope).condition(expr);
  if (checked) resolve_members(checked);
  if (checked && counts_while_open(context, *checked)) checked = nullptr;
  if (!checked) context.must_have_said();
  return checked;
}

void PropertyChecker::report_limit(const SourceRange& range, const std::string& what,
                                   const std::string& limit) {
  if (exhausted_) return;
  exhausted_ = true;
  context_.report(Finding(Code::limit_exceeded, range, what)
                      .label("at most " + limit)
                      .help("up to " + limit +
                            " work; split the property, or compute a part of it outside and pass "
                            "it as an input"));
}

// Functions and `let` can make a short text stand for a huge expression, and so can conditions that
// are compared with each other, as either of them matters in two ways.
bool PropertyChecker::affordable(const syntax::Expr& expr, std::size_t nodes) {
  size_ += nodes;
  if (size_ > max_size) {
    report_limit(expr.range,
                 asked_twice_ > 0
                     ? "the property is too large: what `iff`, `xor` and `==` compare counts twice"
                     : "the property is too large, functions and `let` put in their places",
                 std::to_string(max_size) + " operators and operands");
  } else if (depth_ > max_depth) {
    report_limit(expr.range, "the property is nested too deeply, functions put in their places",
                 std::to_string(max_depth) + " levels");
  }
  return !exhausted_;
}

Value PropertyChecker::infer(const syntax::Expr& expr, const std::optional<Dimension>& due) {
  ++depth_;
  Value value = affordable(expr, std::size_t{1} << asked_twice_) ? infer_node(expr, due) : nullptr;
  --depth_;
  return value;
}

Value PropertyChecker::infer_node(const syntax::Expr& expr, const std::optional<Dimension>& due) {
  if (const auto* number = std::get_if<syntax::NumberLit>(&expr.node)) {
    return constant(expr, *number, due);
  }
  return std::visit([&](const auto& node) -> Value { return form(expr, node); }, expr.node);
}

ExprPtr PropertyChecker::condition(const syntax::Expr& expr) {
  Value value = infer(expr);
  if (!value) return nullptr;
  auto* typed = std::get_if<ExprPtr>(&value.node);
  if (typed != nullptr && (*typed)->boolean) return std::move(*typed);
  const bool enumeration = enumeration_of(value).has_value();
  context_.report(Finding(Code::truth_expected, expr.range,
                          "a condition is due, this is " + describe(context_.spec, value))
                      .label("not true or false")
                      .help(enumeration ? "compare it with a value by `==`"
                                        : "compare it with a limit by `>=` or `<=`"));
  return nullptr;
}

ExprPtr PropertyChecker::quantity_of(const syntax::Expr& expr,
                                     const std::optional<Dimension>& due) {
  return as_quantity(expr, infer(expr, due));
}

ExprPtr PropertyChecker::as_quantity(const syntax::Expr& expr, Value value) {
  if (!value) return nullptr;
  auto* typed = std::get_if<ExprPtr>(&value.node);
  if (typed != nullptr && !(*typed)->boolean) return std::move(*typed);
  return not_a_quantity(expr, describe(context_.spec, value));
}

ExprPtr PropertyChecker::not_a_quantity(const syntax::Expr& expr, const std::string& what) {
  const std::string& self = scope_.self.text;
  std::string help = "write a number with its unit, or the name of an input of quantities";
  if (what == a_name_of(Sort::site)) {
    help = "a place is written as a point, `(1 m, 1 m)`; sites are for `energy_to` and `route to`";
  } else if (sees_robot()) {
    help =
        what == "a zone"
            ? "write `" + self + " inside ...` or `clearance(" + self + ", ...)` with the zone"
            : "write a number with its unit, or a quantity such as `clearance(" + self + ", zone)`";
  } else if (what == "a zone") {
    help = "write `p inside Z`, `clearance(p, Z)` or `distance(p, Z)` with a point and the zone";
  } else if (what.rfind("a point", 0) == 0 || what.rfind("a vector", 0) == 0) {
    help =
        "write one of its components, as in `p.x`, or its length, `norm(v)` or "
        "`distance(p, q)`";
  } else if (what == "a condition" && std::holds_alternative<syntax::Previously>(expr.node)) {
    help = "the change of a quantity is `rate[0 s, 1 s](x)`, per second over that time";
  } else if (what.rfind("a pose", 0) == 0 || what == "a twist") {
    help = what == "a twist" ? "write one of its components, `.linear` or `.angular`"
                             : "write one of its components, as in `at.position.x` or `at.heading`";
  } else if (what == "a condition") {
    help =
        "a condition stands alone or behind `not`, without a number; `count[0 s, 1 s](...)` counts "
        "its ticks";
  } else if (what == "a path" || what == "a leg") {
    help = "write `X inside Z`, `clearance(X, Z)` or `distance(X, p)` with it";
  } else if (what.rfind("an array", 0) == 0) {
    help = "write one of its elements, as in `a[0]`";
  } else if (what.rfind("a value of", 0) == 0) {
    help = "values of an enumeration have no order: compare them by `==` and `!=`";
  } else if (what == a_name_of(Sort::watch) || what == a_name_of(Sort::monitor)) {
    help = "a property speaks of signals: put what both monitors need into a `fun`";
  }
  context_.report(Finding(Code::quantity_expected, expr.range, "a quantity is due, this is " + what)
                      .label("this is " + what)
                      .help(help));
  return nullptr;
}

ExprPtr PropertyChecker::constant(const syntax::Expr& expr, const syntax::NumberLit& number,
                                  const std::optional<Dimension>& due) {
  const auto measure = literal(context_, number, due);
  if (!measure) return nullptr;
  return make_quantity(expr.range, measure->dimension, Constant{measure->value});
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::NumberLit& number) {
  return constant(expr, number, std::nullopt);
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::BoolLit& truth) {
  return make_condition(expr.range, Truth{truth.value});
}

Value PropertyChecker::form(const syntax::Expr&, const syntax::ErrorExpr&) {
  return nullptr;
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::Unary& unary) {
  if (unary.op == syntax::UnaryOp::logical_not) {
    polarity_ = -polarity_;
    ExprPtr operand = condition(*unary.operand);
    polarity_ = -polarity_;
    if (!operand) return nullptr;
    return make_condition(expr.range, Logic{LogicOp::logical_not, operands_of(std::move(operand))});
  }
  return negated(expr, infer(*unary.operand));
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::Binary& binary) {
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
      return zones_or_conditions(expr, binary);
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
  const int outer = polarity_;
  const bool both_ways = op == LogicOp::iff || op == LogicOp::logical_xor;
  asked_twice_ += both_ways ? 1 : 0;
  polarity_ = both_ways ? 0 : (op == LogicOp::implies ? -outer : outer);
  ExprPtr left = condition(*binary.left);
  polarity_ = both_ways ? 0 : outer;
  ExprPtr right = condition(*binary.right);
  polarity_ = outer;
  asked_twice_ -= both_ways ? 1 : 0;
  if (!left || !right) return nullptr;
  return make_condition(expr.range, Logic{op, operands_of(std::move(left), std::move(right))});
}

ExprPtr PropertyChecker::comparison(const syntax::Expr& expr, const syntax::Binary& binary,
                                    CompareOp op) {
  if (says_robot(*binary.left) && says_robot(*binary.right)) {
    return as_quantity(*binary.left, infer(*binary.left));
  }
  Value one = infer(*binary.left);
  auto* typed = std::get_if<ExprPtr>(&one.node);
  ExprPtr left = typed != nullptr && !(*typed)->boolean ? std::move(*typed) : nullptr;
  if (one && !left) {
    // The other side is probably of the same kind: one report says it for both.
    return not_a_quantity(*binary.left, describe(context_.spec, one));
  }
  ExprPtr right =
      quantity_of(*binary.right, left ? std::optional<Dimension>(left->dimension) : std::nullopt);
  if (!left || !right) return nullptr;
  if (!combine(context_, binary.op, {binary.left.get(), left->dimension, constant_of(*left)},
               {binary.right.get(), right->dimension, constant_of(*right)}, binary.op_range)) {
    return nullptr;
  }
  return compare(expr.range, op, std::move(left), std::move(right));
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::Conditional& conditional) {
  const int outer = polarity_;
  polarity_ = 0;
  ExprPtr condition = this->condition(*conditional.condition);
  polarity_ = outer;
  auto [then_value, else_value] = both(*conditional.then_value, *conditional.else_value);
  if (!condition || !then_value || !else_value) return nullptr;
  return choice(expr, *condition, std::move(then_value), std::move(else_value));
}

ExprPtr PropertyChecker::chosen_condition(const syntax::Expr& expr, const Expr& condition,
                                          ExprPtr then_value, ExprPtr else_value) {
  ExprPtr negation =
      make_condition(condition.range, Logic{LogicOp::logical_not, operands_of(clone(condition))});
  ExprPtr yes = make_condition(
      expr.range,
      Logic{LogicOp::logical_and, operands_of(clone(condition), std::move(then_value))});
  ExprPtr no = make_condition(
      expr.range,
      Logic{LogicOp::logical_and, operands_of(std::move(negation), std::move(else_value))});
  return make_condition(expr.range,
                        Logic{LogicOp::logical_or, operands_of(std::move(yes), std::move(no))});
}

Value PropertyChecker::choice(const syntax::Expr& expr, const Expr& condition, Value then_value,
                              Value else_value) {
  if (!affordable(expr, 3 * size_of(Value(clone(condition))))) return nullptr;
  auto* one = std::get_if<ExprPtr>(&then_value.node);
  auto* other = std::get_if<ExprPtr>(&else_value.node);
  if (one != nullptr && other != nullptr && (*one)->boolean && (*other)->boolean) {
    return chosen_condition(expr, condition, std::move(*one), std::move(*other));
  }
  const auto type = enumeration_of(then_value);
  if (type && type == enumeration_of(else_value)) {
    EnumChoice chosen{clone(condition), {}};
    chosen.options.push_back(std::move(then_value));
    chosen.options.push_back(std::move(else_value));
    return chosen;
  }
  const std::string kinds = "`if` chooses between " + describe(context_.spec, then_value) +
                            " and " + describe(context_.spec, else_value);
  if (Value chosen = chosen_parts(expr, condition, then_value, else_value)) return chosen;
  if (!then_value) return nullptr;  // reported
  return wrong_operand(expr.range, kinds,
                       "both must be conditions, values of one enumeration, or quantities, points, "
                       "vectors, poses or twists of one dimension");
}

// Of quantities, and of what consists of them; the first is emptied when a mistake was reported.
Value PropertyChecker::chosen_parts(const syntax::Expr& expr, const Expr& condition,
                                    Value& then_value, Value& else_value) {
  const auto pick = [&](ExprPtr& a, ExprPtr& b) {
    const Dimension dimension = a->dimension;
    return make_quantity(expr.range, dimension,
                         Choice{clone(condition), std::move(a), std::move(b)});
  };
  const auto allowed = [&](bool good) {
    if (!good) then_value = nullptr;
    return good;
  };
  const auto pick_pair = [&](Pair& a, Pair& b) {
    const Pair::Kind kind = a.kind == Pair::Kind::literal ? b.kind : a.kind;
    ExprPtr z = a.z ? pick(a.z, b.z) : nullptr;
    return Pair{kind, pick(a.x, b.x), pick(a.y, b.y), std::move(z), a.frame ? a.frame : b.frame};
  };
  auto* one = std::get_if<ExprPtr>(&then_value.node);
  auto* other = std::get_if<ExprPtr>(&else_value.node);
  if (one != nullptr && other != nullptr && !(*one)->boolean && !(*other)->boolean &&
      (*one)->dimension == (*other)->dimension) {
    // nothing is chosen: the value itself, also where a choice could not stand
    if (const auto* fixed = std::get_if<Truth>(&condition.node)) {
      return std::move(fixed->value ? *one : *other);
    }
    Value chosen = judged_now(pick(*one, *other), "`if` between quantities");
    allowed(static_cast<bool>(chosen));
    return chosen;
  }
  auto* left = std::get_if<Pair>(&then_value.node);
  auto* right = std::get_if<Pair>(&else_value.node);
  if (left != nullptr && right != nullptr && left->x->dimension == right->x->dimension &&
      (left->kind == right->kind || left->kind == Pair::Kind::literal ||
       right->kind == Pair::Kind::literal)) {
    if (!allowed(agree(expr.range, "`if`", *left, *right))) return nullptr;
    return pick_pair(*left, *right);
  }
  auto* here = std::get_if<Pose>(&then_value.node);
  auto* there = std::get_if<Pose>(&else_value.node);
  if (here != nullptr && there != nullptr) {
    const bool good = agree(expr.range, "`if`", here->position, there->position) &&
                      frames_agree(expr.range, "`if` between poses", here->of, there->of);
    if (!allowed(good)) return nullptr;
    Pair position = pick_pair(here->position, there->position);
    return Pose{std::move(position), pick(here->heading, there->heading), here->of};
  }
  auto* slow = std::get_if<Twist>(&then_value.node);
  auto* fast = std::get_if<Twist>(&else_value.node);
  if (slow == nullptr || fast == nullptr) return nullptr;
  ExprPtr linear = pick(slow->linear, fast->linear);
  return Twist{std::move(linear), pick(slow->angular, fast->angular)};
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::Quantified& quantified) {
  if (sees_fleets()) return quantified_members(expr, quantified);
  if (!robot_allowed(expr.range, "a quantifier over robots")) return nullptr;
  if (const Symbol* named = context_.symbols.find(quantified.kind.text);
      named != nullptr && (named->sort == Sort::agent || named->sort == Sort::agents)) {
    return quantified_agents(expr, quantified);
  }
  const Head head{expr.range, quantified.variable, quantified.kind, quantified.guard};
  if (!not_nested(head) || !quantifier_fits(head)) return nullptr;
  other_ = &quantified.variable;
  ExprPtr body = condition(*quantified.body);
  other_ = nullptr;
  if (!body) return nullptr;
  const bool universal = quantified.quantifier == syntax::Quantifier::forall;
  return make_condition(expr.range, ForOthers{universal, std::move(body)});
}

}  // namespace rtac::sema
