// `min` and `max` over the robots of a fleet. What is compared with them is compared with every
// member: min(x) >= c says that all x >= c. So a member that is too near decides, whatever is known
// of the others.
#include "compiler/sema/property_checker.h"

namespace rtac::sema {

namespace {

// A `min` or `max` in a quantity, or a choice that has one in a branch. `sign`: what a larger value
// does to the quantity, +1 or -1; 0: not known.
struct Found {
  ExprPtr* place;
  int sign;
};

bool is_over_members(const Expr& expr) {
  bool found = false;
  for_each_expr(expr, [&](const Expr& each) {
    found = found || std::holds_alternative<OverMembers>(each.node);
  });
  return found;
}
bool chooses_members(const Expr& expr) {
  const auto* choice = std::get_if<Choice>(&expr.node);
  return choice != nullptr &&
         (is_over_members(*choice->then_value) || is_over_members(*choice->else_value));
}

int sign_of(const Expr& factor) {
  const auto value = constant_of(factor);
  return value ? sgn(*value) : 0;
}

// Visits operands with what a larger value of them does, where `expr` has this sign.
template <class Visit>
void for_each_signed_operand(ExprPtr& expr, int sign, const Visit& visit) {
  auto* node = std::get_if<Arithmetic>(&expr->node);
  if (node == nullptr) {
    for_each_operand(*expr, [&](ExprPtr& operand) { visit(operand, 0); });
    return;
  }
  auto& operands = node->operands;
  switch (node->op) {
    case ArithmeticOp::add:
      visit(operands[0], sign);
      return visit(operands[1], sign);
    case ArithmeticOp::subtract:
      visit(operands[0], sign);
      return visit(operands[1], -sign);
    case ArithmeticOp::negate:
      return visit(operands[0], -sign);
    case ArithmeticOp::multiply:
      visit(operands[0], sign * sign_of(*operands[1]));
      return visit(operands[1], sign * sign_of(*operands[0]));
    case ArithmeticOp::divide:
      return visit(operands[0], sign * sign_of(*operands[1]));
  }
}

// The least or greatest of what may be endless is not always that.
void find_while_open(ExprPtr& expr, int sign, std::vector<Found>& out) {
  if (std::holds_alternative<WhileOpen>(expr->node)) {
    out.push_back({&expr, sign});
    return;
  }
  for_each_signed_operand(expr, sign,
                          [&](ExprPtr& operand, int its) { find_while_open(operand, its, out); });
}

void find(ExprPtr& expr, int sign, std::vector<Found>& out) {
  if (std::holds_alternative<OverMembers>(expr->node) || (sign != 0 && chooses_members(*expr))) {
    out.push_back({&expr, sign});
    return;
  }
  if (const auto* math = std::get_if<Math>(&expr->node)) {
    const bool keeps = math->op == MathOp::minimum || math->op == MathOp::maximum;
    for_each_operand(*expr, [&](ExprPtr& operand) { find(operand, keeps ? sign : 0, out); });
    return;
  }
  for_each_signed_operand(expr, sign, [&](ExprPtr& operand, int its) { find(operand, its, out); });
}

}  // namespace

void resolve_members(ExprPtr& expr) {
  for_each_operand(*expr, [](ExprPtr& operand) { resolve_members(operand); });
  auto* members = std::get_if<OverMembers>(&expr->node);
  if (members == nullptr) return;
  std::vector<ExprPtr> operands = std::move(members->operands);
  if (operands.size() == 1) {
    expr = std::move(operands.front());
    return;
  }
  const MathOp op = members->maximum ? MathOp::maximum : MathOp::minimum;
  expr->node = Math{op, std::move(operands)};
}

ExprPtr PropertyChecker::compare(const SourceRange& range, CompareOp op, ExprPtr left,
                                 ExprPtr right) {
  std::vector<Found> found;
  find(left, 1, found);
  find(right, -1, found);
  for (const Found& each : found) {
    if (chooses_members(**each.place) && each.sign != 0) {
      return compare_choice(range, op, left, right, *each.place);
    }
  }
  const bool of_robot = scope_.of_robot();
  for (const Found& each : found) {
    // A monitor of a robot knows its others by a loop: one of them at a time.
    if (each.sign == 0 ? !of_robot : !of_robot || found.size() == 1) continue;
    wrong_operand((*each.place)->range,
                  each.sign == 0 ? "`min` and `max` over robots stand in a sum here, or alone"
                                 : "two `min` or `max` over robots stand in one comparison",
                  "compare each with a limit of its own, and join the comparisons by `and`");
    return nullptr;
  }
  for (const Found& each : found) {
    if (each.sign == 0) continue;
    const bool above = op == CompareOp::greater || op == CompareOp::greater_equal;
    const bool rising = (each.sign > 0) == above;
    return compare_members(range, op, left, right, *each.place, rising);
  }
  return compare_while_open(range, op, std::move(left), std::move(right));
}

// What is endless while a zone is not open, or a path is empty, decides the comparison then,
// whatever the other side is.
ExprPtr PropertyChecker::compare_while_open(const SourceRange& range, CompareOp op, ExprPtr left,
                                            ExprPtr right) {
  std::vector<Found> found;
  find_while_open(left, 1, found);
  find_while_open(right, -1, found);
  if (found.size() != 1 || found.front().sign == 0) {
    return comparison(range, op, std::move(left), std::move(right));
  }
  ExprPtr& place = *found.front().place;
  WhileOpen taken = std::move(std::get<WhileOpen>(place->node));
  place = std::move(taken.operand);
  const bool above = op == CompareOp::greater || op == CompareOp::greater_equal;
  const bool rising = (found.front().sign > 0) == above;
  const auto* zone = std::get_if<ZoneId>(&taken.what);
  ExprPtr open = zone != nullptr ? make_condition(range, ZoneOpen{*zone})
                                 : make_condition(range, PathGiven{std::get<InputId>(taken.what)});
  ExprPtr meanwhile = compare_while_open(range, op, std::move(left), std::move(right));
  const bool holds_otherwise = rising == taken.endless;
  const LogicOp joins = holds_otherwise ? LogicOp::implies : LogicOp::logical_and;
  return make_condition(range, Logic{joins, operands_of(std::move(open), std::move(meanwhile))});
}

// Counts the copies of what is compared; false: reported.
bool PropertyChecker::afford_copy(const SourceRange& range, const ExprPtr& left,
                                  const ExprPtr& right) {
  size_ += size_of(Value(clone(*left))) + size_of(Value(clone(*right)));
  if (size_ <= max_size) return true;
  report_limit(range, "the property is too large, all members of the fleet put in their places",
               std::to_string(max_size) + " operators and operands");
  return false;
}

// `place` lies within `left` or `right` and holds a choice: the comparisons of both of its values
// are chosen between. Where its condition is not decided, what holds of both holds of either.
ExprPtr PropertyChecker::compare_choice(const SourceRange& range, CompareOp op, const ExprPtr& left,
                                        const ExprPtr& right, ExprPtr& place) {
  Choice choice = std::move(std::get<Choice>(place->node));
  const auto of = [&](ExprPtr value) -> ExprPtr {
    place = std::move(value);
    if (!afford_copy(range, left, right)) return nullptr;
    return compare(range, op, clone(*left), clone(*right));
  };
  ExprPtr first = of(std::move(choice.then_value));
  ExprPtr second = first ? of(std::move(choice.else_value)) : nullptr;
  if (!second) return nullptr;
  const auto both = [&](ExprPtr a, ExprPtr b) {
    return make_condition(range,
                          Logic{LogicOp::logical_and, operands_of(std::move(a), std::move(b))});
  };
  ExprPtr other =
      make_condition(range, Logic{LogicOp::logical_not, operands_of(clone(*choice.condition))});
  ExprPtr either = both(clone(*first), clone(*second));
  std::vector<ExprPtr> parts;
  parts.push_back(both(std::move(choice.condition), std::move(first)));
  parts.push_back(both(std::move(other), std::move(second)));
  parts.push_back(std::move(either));
  return joined(range, LogicOp::logical_or, std::move(parts));
}

// `place` lies within `left` or `right`. `rising`: a larger member makes the comparison truer.
ExprPtr PropertyChecker::compare_members(const SourceRange& range, CompareOp op,
                                         const ExprPtr& left, const ExprPtr& right, ExprPtr& place,
                                         bool rising) {
  OverMembers members = std::move(std::get<OverMembers>(place->node));
  const bool universal = rising != members.maximum;
  std::vector<ExprPtr> parts;
  for (ExprPtr& member : members.operands) {
    place = std::move(member);
    if (!afford_copy(range, left, right)) return nullptr;
    ExprPtr part = compare(range, op, clone(*left), clone(*right));
    if (!part) return nullptr;
    parts.push_back(std::move(part));
  }
  if (scope_.of_robot()) {
    return make_condition(range, ForOthers{universal, std::move(parts.front())});
  }
  return joined(range, universal ? LogicOp::logical_and : LogicOp::logical_or, std::move(parts));
}

}  // namespace rtac::sema
