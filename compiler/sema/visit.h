// Walks over checked expressions.
#pragma once

#include <type_traits>
#include <utility>
#include <variant>

#include "compiler/sema/spec.h"

namespace rtac::sema {

// Calls `visit` for the operands of `expr`, in the order in which they are written; `Tree` is
// `Expr` or `const Expr`, and `visit` takes the pointers, which it may replace.
template <class Tree, class Visit>
void for_each_operand(Tree& expr, Visit&& visit) {
  std::visit(
      [&](auto& node) {
        using Node = std::decay_t<decltype(node)>;
        if constexpr (std::is_same_v<Node, Arithmetic> || std::is_same_v<Node, Logic> ||
                      std::is_same_v<Node, Math> || std::is_same_v<Node, OverMembers>) {
          for (auto& operand : node.operands) visit(operand);
        } else if constexpr (std::is_same_v<Node, Compare> || std::is_same_v<Node, Since>) {
          visit(node.left);
          visit(node.right);
        } else if constexpr (std::is_same_v<Node, HeldFor> || std::is_same_v<Node, Previously> ||
                             std::is_same_v<Node, Past> || std::is_same_v<Node, Aggregate> ||
                             std::is_same_v<Node, WhileOpen>) {
          visit(node.operand);
        } else if constexpr (std::is_same_v<Node, ForOthers> || std::is_same_v<Node, CountOthers>) {
          visit(node.body);
        } else if constexpr (std::is_same_v<Node, Choice>) {
          visit(node.condition);
          visit(node.then_value);
          visit(node.else_value);
        } else if constexpr (std::is_same_v<Node, PointInside> ||
                             std::is_same_v<Node, PointClearance>) {
          visit(node.x);
          visit(node.y);
          if (node.z) visit(node.z);
        } else if constexpr (std::is_same_v<Node, TrailInside> ||
                             std::is_same_v<Node, TrailClearance>) {
          for (auto& coordinate : node.trail.own) visit(coordinate);
        } else if constexpr (std::is_same_v<Node, TrailDistance>) {
          for (auto& coordinate : node.trail.own) visit(coordinate);
          for (auto& coordinate : node.other.own) visit(coordinate);
        } else if constexpr (std::is_same_v<Node, WithinOf>) {
          visit(node.operand);
          visit(node.trigger);
        } else {
          // Every node with an operand is named above: this list is what has none.
          static_assert(std::is_same_v<Node, Constant> || std::is_same_v<Node, Truth> ||
                        std::is_same_v<Node, SignalRef> || std::is_same_v<Node, Clearance> ||
                        std::is_same_v<Node, Distance> || std::is_same_v<Node, EnergyTo> ||
                        std::is_same_v<Node, InsideZone> || std::is_same_v<Node, PlanInside> ||
                        std::is_same_v<Node, InputRef> || std::is_same_v<Node, AgeOf> ||
                        std::is_same_v<Node, SensedAge> || std::is_same_v<Node, ParamRef> ||
                        std::is_same_v<Node, ZoneOpen> || std::is_same_v<Node, IsValue> ||
                        std::is_same_v<Node, SameValue> || std::is_same_v<Node, AgentDistance> ||
                        std::is_same_v<Node, ZoneDistance> || std::is_same_v<Node, PathGiven>);
        }
      },
      expr.node);
}

// Calls `visit` for every expression below and including `expr`, outermost first.
template <class Visit>
void for_each_expr(const Expr& expr, Visit&& visit) {
  visit(expr);
  for_each_operand(expr, [&](const ExprPtr& operand) { for_each_expr(*operand, visit); });
}

// Says something of a robot or of its plan: what changes while the robot moves.
inline bool is_robot_state(const Expr& expr) {
  return std::holds_alternative<SignalRef>(expr.node) ||
         std::holds_alternative<Clearance>(expr.node) ||
         std::holds_alternative<Distance>(expr.node) ||
         std::holds_alternative<AgentDistance>(expr.node) ||
         std::holds_alternative<EnergyTo>(expr.node) ||
         std::holds_alternative<InsideZone>(expr.node) ||
         std::holds_alternative<PlanInside>(expr.node) ||
         std::holds_alternative<ForOthers>(expr.node) ||
         std::holds_alternative<CountOthers>(expr.node) ||
         std::holds_alternative<OverMembers>(expr.node);
}
// Whether the expression or a part of it does.
inline bool speaks_of_robot(const Expr& expr) {
  bool found = false;
  for_each_expr(expr, [&](const Expr& each) { found = found || is_robot_state(each); });
  return found;
}

// Whether a part of it is such a node.
template <class Node>
bool speaks_of(const Expr& expr) {
  bool found = false;
  for_each_expr(
      expr, [&](const Expr& each) { found = found || std::holds_alternative<Node>(each.node); });
  return found;
}
// Whether a part of it is such a signal.
inline bool speaks_of_signal(const Expr& expr, Signal signal) {
  bool found = false;
  for_each_expr(expr, [&](const Expr& each) {
    const auto* ref = std::get_if<SignalRef>(&each.node);
    found = found || (ref != nullptr && ref->signal == signal);
  });
  return found;
}
inline bool speaks_of_speed(const Expr& expr) {
  return speaks_of_signal(expr, Signal::speed);
}
inline bool speaks_of_height(const Expr& expr) {
  return speaks_of_signal(expr, Signal::altitude);
}
inline bool speaks_of_charge(const Expr& expr) {
  return speaks_of_signal(expr, Signal::battery);
}
// Always, or to give control back.
inline bool asks_for_charge(const Monitor& monitor) {
  return speaks_of_charge(*monitor.always) ||
         (monitor.return_when && speaks_of_charge(*monitor.return_when));
}

}  // namespace rtac::sema
