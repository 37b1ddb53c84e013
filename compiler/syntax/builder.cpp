#include "compiler/syntax/builder.h"

#include <algorithm>
#include <utility>

#include "compiler/syntax/token.h"

namespace rtac::syntax {
namespace {

bool is_inf(const ExprPtr& expr) {
  const auto* ref = expr ? std::get_if<NameRef>(&expr->node) : nullptr;
  return ref && ref->name.text == "inf";
}

int height_of(const std::optional<IntervalParts>& interval) {
  return interval ? interval->height : 0;
}

std::optional<Interval> node_of(std::optional<IntervalParts> interval) {
  if (!interval) return std::nullopt;
  return std::move(interval->node);
}

}  // namespace

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

IntervalParts interval_of(Operand from, Operand to, const SourceRange& range) {
  IntervalParts parts;
  parts.height = std::max(from.height, to.height);
  parts.node = {std::move(from.expr), is_inf(to.expr) ? nullptr : std::move(to.expr), range};
  return parts;
}

InputItem input_of(std::vector<Name> names, TypeRef type, std::vector<Limits> limits,
                   Operands error, ExprPtr max_age, Operands resolution) {
  InputItem input;
  input.names = std::move(names);
  input.type = std::move(type);
  input.limits = std::move(limits);
  input.error = std::move(error.list);
  input.max_age_inf = is_inf(max_age);
  if (!input.max_age_inf) input.max_age = std::move(max_age);
  input.resolution = std::move(resolution.list);
  return input;
}

ParamItem param_of(Name name, TypeRef type, Limits limits, Operand value) {
  return {std::move(name), std::move(type), std::move(limits.least), std::move(limits.most),
          std::move(value.expr)};
}

RobotItem with_name(RobotItem robot, Name name) {
  robot.name = std::move(name);
  return robot;
}

SequenceTemplate with_step(SequenceTemplate sequence, SequenceStep step) {
  sequence.steps.push_back(std::move(step));
  return sequence;
}
ControllerItem implemented_by(SafeTemplate implementation, const SourceRange& range) {
  return std::visit([&](auto& node) { return implemented(std::move(node), range); },
                    implementation);
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

Operand Builder::previously(const SourceRange& range, Operand operand) {
  return grow(range, operand.height, Previously{std::move(operand.expr)});
}

Operand Builder::past(const SourceRange& range, PastOp op, std::optional<IntervalParts> interval,
                      Operand operand) {
  const int height = std::max(height_of(interval), operand.height);
  return grow(range, height, Past{op, node_of(std::move(interval)), std::move(operand.expr)});
}

Operand Builder::since(const SourceRange& range, std::optional<IntervalParts> interval,
                       Operand left, Operand right) {
  const int height = std::max({height_of(interval), left.height, right.height});
  return grow(range, height,
              Since{node_of(std::move(interval)), std::move(left.expr), std::move(right.expr)});
}

Operand Builder::within_of(const SourceRange& range, Operand operand, Operand duration,
                           Operand trigger) {
  return grow(range, std::max({operand.height, duration.height, trigger.height}),
              WithinOf{std::move(operand.expr), std::move(duration.expr), std::move(trigger.expr)});
}

Operand Builder::aggregate(const SourceRange& range, Name name, IntervalParts interval,
                           Operand operand) {
  return grow(range, std::max(interval.height, operand.height),
              Aggregate{std::move(name), std::move(interval.node), std::move(operand.expr)});
}

Operand Builder::conditional(const SourceRange& range, Operand condition, Operand then_value,
                             Operand else_value) {
  return grow(range, std::max({condition.height, then_value.height, else_value.height}),
              Conditional{std::move(condition.expr), std::move(then_value.expr),
                          std::move(else_value.expr)});
}

Operand Builder::let(const SourceRange& range, Name name, Operand value, Operand body) {
  return grow(range, std::max(value.height, body.height),
              Let{std::move(name), std::move(value.expr), std::move(body.expr)});
}

Operand Builder::index(const SourceRange& range, Operand base, Operand index) {
  return grow(range, std::max(base.height, index.height),
              Index{std::move(base.expr), std::move(index.expr)});
}

Operand Builder::quantified(const SourceRange& range, Quantified head, Operand guard,
                            Operand body) {
  head.guard = std::move(guard.expr);
  head.body = std::move(body.expr);
  return grow(range, std::max(guard.height, body.height), std::move(head));
}

Operand Builder::over_fleet(const SourceRange& range, OverFleet head, Operand guard, Operand body) {
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

Operand Builder::box(const SourceRange& range, Operand from, Operand to) {
  return grow(range, std::max(from.height, to.height),
              RectangleLit{std::move(from.expr), std::move(to.expr), true});
}

Operand Builder::circle(const SourceRange& range, Operand centre, Operand radius) {
  return grow(range, std::max(centre.height, radius.height),
              CircleLit{std::move(centre.expr), std::move(radius.expr)});
}

Operand Builder::prism(const SourceRange& range, Operand base, Operand floor, Operand ceiling) {
  return grow(range, std::max({base.height, floor.height, ceiling.height}),
              PrismLit{std::move(base.expr), std::move(floor.expr), std::move(ceiling.expr)});
}

Operand Builder::polygon(const SourceRange& range, PolygonParts parts) {
  return grow(range, parts.height, std::move(parts.node));
}

ImportLit Builder::zone_file(Text path) {
  zone_files_.push_back(path);
  return {std::move(path), {}};
}

}  // namespace rtac::syntax
