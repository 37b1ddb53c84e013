#include "compiler/syntax/print_expr.h"

#include <optional>
#include <vector>

#include "compiler/support/overloaded.h"
#include "compiler/syntax/spelling.h"

namespace rtac::syntax {
namespace {

// How strongly an expression binds: the precedence table of parser.yy, weakest first.
enum Strength {
  open_level,  // quantifiers, let, if: they reach as far right as they can
  iff_level,
  implies_level,
  xor_level,
  or_level,
  and_level,
  temporal_level,  // for, since, within .. of
  not_level,       // not, previously, once, historically
  comparison_level,
  union_level,
  intersection_level,
  sum_level,
  product_level,
  negation_level,
  zone_level,  // rectangle, circle, polygon, prism: operands, but `.` cannot follow them
  primary_level
};

Strength next_above(Strength strength) {
  return static_cast<Strength>(strength + 1);
}

Strength strength_of(BinaryOp op) {
  switch (op) {
    case BinaryOp::iff:
      return iff_level;
    case BinaryOp::implies:
      return implies_level;
    case BinaryOp::logical_xor:
      return xor_level;
    case BinaryOp::logical_or:
      return or_level;
    case BinaryOp::logical_and:
      return and_level;
    case BinaryOp::less:
    case BinaryOp::less_equal:
    case BinaryOp::greater:
    case BinaryOp::greater_equal:
    case BinaryOp::equal:
    case BinaryOp::not_equal:
    case BinaryOp::inside:
      return comparison_level;
    case BinaryOp::zone_union:
      return union_level;
    case BinaryOp::zone_intersection:
      return intersection_level;
    case BinaryOp::add:
    case BinaryOp::subtract:
      return sum_level;
    case BinaryOp::multiply:
    case BinaryOp::divide:
      return product_level;
  }
  return primary_level;
}

Strength strength_of(const Expr& expr) {
  return std::visit(
      Overloaded{
          [](const Binary& node) { return strength_of(node.op); },
          [](const Unary& node) { return node.op == UnaryOp::negate ? negation_level : not_level; },
          [](const Held&) { return temporal_level; },
          [](const Since&) { return temporal_level; },
          [](const WithinOf&) { return temporal_level; },
          [](const Previously&) { return not_level; },
          [](const Past&) { return not_level; },
          [](const Quantified&) { return open_level; },
          [](const Conditional&) { return open_level; },
          [](const Let&) { return open_level; },
          [](const RectangleLit&) { return zone_level; },
          [](const CircleLit&) { return zone_level; },
          [](const PolygonLit&) { return zone_level; },
          [](const PrismLit&) { return zone_level; },
          [](const ImportLit&) { return zone_level; },
          [](const NumberLit&) { return primary_level; },
          [](const BoolLit&) { return primary_level; },
          [](const NameRef&) { return primary_level; },
          [](const Member&) { return primary_level; },
          [](const Call&) { return primary_level; },
          [](const Aggregate&) { return primary_level; },
          [](const OverFleet&) { return primary_level; },
          [](const Index&) { return primary_level; },
          [](const PointLit&) { return primary_level; },
          [](const ErrorExpr&) { return primary_level; },
      },
      expr.node);
}

// In brackets when it binds more weakly than its place needs.
std::string operand(const ExprPtr& expr, Strength needed) {
  std::string text = print_expr(*expr);
  return strength_of(*expr) < needed ? '(' + text + ')' : text;
}

std::string print_list(const std::vector<ExprPtr>& list) {
  std::string result;
  for (const ExprPtr& expr : list) {
    if (!result.empty()) result += ", ";
    result += print_expr(*expr);
  }
  return result;
}

std::string print_node(const NumberLit& node) {
  return node.unit ? node.text + ' ' + node.unit->text : node.text;
}
std::string print_node(const BoolLit& node) {
  return node.value ? "true" : "false";
}
std::string print_node(const NameRef& node) {
  return node.name.text;
}
std::string print_node(const Member& node) {
  return operand(node.base, primary_level) + '.' + node.field.text;
}
std::string print_node(const Call& node) {
  return node.callee.text + '(' + print_list(node.arguments) + ')';
}
std::string print_node(const Unary& node) {
  if (node.op == UnaryOp::negate) return '-' + operand(node.operand, negation_level);
  return "not " + operand(node.operand, not_level);
}
std::string print_node(const Binary& node) {
  const Strength own = strength_of(node.op);
  // `implies` groups to the right, comparisons not at all, everything else to the left.
  const bool left_may_repeat = own != implies_level && own != comparison_level;
  const bool right_may_repeat = own == implies_level;
  return operand(node.left, left_may_repeat ? own : next_above(own)) + ' ' +
         std::string{spell(node.op)} + ' ' +
         operand(node.right, right_may_repeat ? own : next_above(own));
}
// Heights, radii and durations may have a sign without brackets.
std::string print_signed(const ExprPtr& value) {
  const auto* sign = std::get_if<Unary>(&value->node);
  const bool is_signed = sign != nullptr && sign->op == UnaryOp::negate;
  return is_signed ? '-' + print_signed(sign->operand) : operand(value, primary_level);
}
std::string print_node(const Held& node) {
  return operand(node.operand, temporal_level) + " for " + print_signed(node.duration);
}
std::string print_interval(const Interval& interval) {
  return '[' + print_expr(*interval.from) + ", " +
         (interval.to ? print_expr(*interval.to) : std::string{"inf"}) + ']';
}
std::string print_interval(const std::optional<Interval>& interval) {
  return interval ? print_interval(*interval) : std::string{};
}
std::string print_node(const Previously& node) {
  return "previously " + operand(node.operand, not_level);
}
std::string print_node(const Past& node) {
  return std::string{spell(node.op)} + print_interval(node.interval) + ' ' +
         operand(node.operand, not_level);
}
std::string print_node(const Since& node) {
  return operand(node.left, temporal_level) + " since" + print_interval(node.interval) + ' ' +
         operand(node.right, next_above(temporal_level));
}
std::string print_node(const WithinOf& node) {
  return operand(node.operand, temporal_level) + " within " + print_signed(node.duration) + " of " +
         operand(node.trigger, next_above(temporal_level));
}
std::string print_node(const Aggregate& node) {
  return node.name.text + print_interval(node.interval) + '(' + print_expr(*node.operand) + ')';
}
std::string print_node(const Conditional& node) {
  return "if " + print_expr(*node.condition) + " then " + print_expr(*node.then_value) + " else " +
         print_expr(*node.else_value);
}
std::string print_node(const Let& node) {
  return "let " + node.name.text + " = " + print_expr(*node.value) + " in " +
         print_expr(*node.body);
}
std::string print_node(const Index& node) {
  return operand(node.base, primary_level) + '[' + print_expr(*node.index) + ']';
}
std::string print_node(const Quantified& node) {
  std::string head =
      std::string{spell(node.quantifier)} + ' ' + node.variable.text + " : " + node.kind.text;
  if (node.guard) head += ", " + print_expr(*node.guard);
  return head + " : " + print_expr(*node.body);
}
std::string print_node(const OverFleet& node) {
  std::string head = node.name.text + '(' + node.variable.text + " : " + node.kind.text;
  if (node.guard) head += ", " + print_expr(*node.guard);
  return head + " : " + print_expr(*node.body) + ')';
}
std::string print_node(const PointLit& node) {
  return '(' + print_list(node.coordinates) + ')';
}
std::string print_node(const RectangleLit& node) {
  return (node.says_box ? "box " : "rectangle ") + print_expr(*node.from) + " to " +
         print_expr(*node.to);
}
std::string print_node(const CircleLit& node) {
  return "circle " + print_expr(*node.centre) + " radius " + print_signed(node.radius);
}
std::string print_node(const PolygonLit& node) {
  std::string result = "polygon [" + print_list(node.outer.points) + ']';
  for (const PolygonLit::Ring& hole : node.holes)
    result += " hole [" + print_list(hole.points) + ']';
  return result;
}
std::string print_node(const PrismLit& node) {
  return "prism " + operand(node.base, primary_level) + " from " + print_signed(node.floor) +
         " to " + print_signed(node.ceiling);
}
std::string print_option(const ImportOption& option) {
  std::string result{spell(option.word)};
  if (option.text) result += ' ' + spell_text(option.text->text);
  for (const Name& name : option.names) result += ' ' + name.text;
  if (option.level) result += " at " + print_signed(option.level);
  return result;
}
std::string print_node(const ImportLit& node) {
  std::string result = "import " + spell_text(node.path.text);
  for (const ImportOption& option : node.options) result += ' ' + print_option(option);
  return result;
}
// Not specification text: a tree with errors is printed only to be looked at.
std::string print_node(const ErrorExpr&) {
  return "<error>";
}

}  // namespace

std::string print_expr(const Expr& expr) {
  return std::visit([](const auto& node) { return print_node(node); }, expr.node);
}

}  // namespace rtac::syntax
