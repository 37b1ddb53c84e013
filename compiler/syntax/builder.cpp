#include "compiler/syntax/builder.h"

#include <algorithm>
#include <utility>

#include "compiler/syntax/token.h"

namespace rtac::syntax {

void push(Operands& list, Operand operand) {
  list.height = std::max(list.height, operand.height);
  list.list.push_back(std::move(operand.expr));
}

PolygonParts ring_of(Operands points, const SourceRange& range) {
  PolygonParts parts;
  parts.node.outer = {std::move(points.list), range};
  parts.height = points.height;
  return parts;
}

PolygonParts with_hole(PolygonParts polygon, PolygonParts hole) {
  polygon.node.holes.push_back(std::move(hole.node.outer));
  polygon.height = std::max(polygon.height, hole.height);
  return polygon;
}

RobotItem with_name(RobotItem robot, Name name) {
  robot.name = std::move(name);
  return robot;
}

ControllerItem with_header(ControllerItem controller, Name name, Role role, Name kind) {
  controller.name = std::move(name);
  controller.role = role;
  controller.kind = std::move(kind);
  return controller;
}

MonitorItem with_header(MonitorItem monitor, Name name, MonitorItem subject) {
  monitor.name = std::move(name);
  monitor.variable = std::move(subject.variable);
  monitor.kind = std::move(subject.kind);
  return monitor;
}

DecisionItem with_header(DecisionItem decision, Name name, Name kind) {
  decision.name = std::move(name);
  decision.kind = std::move(kind);
  return decision;
}

const Token& Builder::next_token() {
  const Token& token = tokens_[std::min(next_, tokens_.size() - 1)];
  ++next_;
  return token;
}

void Builder::fail(std::vector<int> expected_symbols) {
  failed_ = true;
  expected_symbols_ = std::move(expected_symbols);
}

Name Builder::name(const SourceRange& range) const {
  return {std::string{sources_.text(range)}, range};
}

Operand Builder::number(const SourceRange& range, NumberValue value, std::optional<Unit> unit) {
  if (value.bad) return leaf(range, ErrorExpr{});
  return leaf(range, NumberLit{std::move(value.value), std::move(value.text), std::move(unit)});
}

Operand Builder::unary(const SourceRange& range, UnaryOp op, Operand operand) {
  return grow(range, operand.height, Unary{op, std::move(operand.expr)});
}

Operand Builder::binary(const SourceRange& range, BinaryOp op, Operand left, Operand right,
                        const SourceRange& op_range) {
  return grow(range, std::max(left.height, right.height),
              Binary{op, std::move(left.expr), std::move(right.expr), op_range});
}

Operand Builder::held(const SourceRange& range, Operand operand, Operand duration) {
  return grow(range, std::max(operand.height, duration.height),
              Held{std::move(operand.expr), std::move(duration.expr)});
}

Operand Builder::quantified(const SourceRange& range, Quantified head, Operand guard,
                            Operand body) {
  head.guard = std::move(guard.expr);
  head.body = std::move(body.expr);
  return grow(range, std::max(guard.height, body.height), std::move(head));
}

Operand Builder::call(const SourceRange& range, Name callee, Operands arguments) {
  return grow(range, arguments.height, Call{std::move(callee), std::move(arguments.list)});
}

Operand Builder::member(const SourceRange& range, Operand base, Name field) {
  return grow(range, base.height, Member{std::move(base.expr), std::move(field)});
}

Operand Builder::point(const SourceRange& range, Operand first, Operands rest) {
  rest.list.insert(rest.list.begin(), std::move(first.expr));
  return grow(range, std::max(first.height, rest.height), PointLit{std::move(rest.list)});
}

Operand Builder::rectangle(const SourceRange& range, Operand from, Operand to) {
  return grow(range, std::max(from.height, to.height),
              RectangleLit{std::move(from.expr), std::move(to.expr)});
}

Operand Builder::circle(const SourceRange& range, Operand centre, Operand radius) {
  return grow(range, std::max(centre.height, radius.height),
              CircleLit{std::move(centre.expr), std::move(radius.expr)});
}

Operand Builder::polygon(const SourceRange& range, PolygonParts parts) {
  return grow(range, parts.height, std::move(parts.node));
}

}  // namespace rtac::syntax
