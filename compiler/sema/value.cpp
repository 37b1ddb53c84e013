#include "compiler/sema/value.h"

#include <algorithm>

#include "compiler/sema/dimension.h"
#include "compiler/sema/visit.h"
#include "compiler/support/overloaded.h"

namespace rtac::sema {

namespace {

std::vector<Value> clone_all(const std::vector<Value>& values);

std::vector<ExprPtr> clone_all(const std::vector<ExprPtr>& operands) {
  std::vector<ExprPtr> copies;
  copies.reserve(operands.size());
  for (const ExprPtr& operand : operands) copies.push_back(clone(*operand));
  return copies;
}

ExprPtr cloned(const ExprPtr& expr) {
  return expr ? clone(*expr) : nullptr;
}

decltype(Expr::node) clone_node(const decltype(Expr::node)& written) {
  using Node = decltype(Expr::node);
  return std::visit(
      Overloaded{
          [](const Arithmetic& node) {
            return Node(Arithmetic{node.op, clone_all(node.operands)});
          },
          [](const Logic& node) {
            return Node(Logic{node.op, clone_all(node.operands)});
          },
          [](const Math& node) {
            return Node(Math{node.op, clone_all(node.operands)});
          },
          [](const Compare& node) {
            return Node(Compare{node.op, clone(*node.left), clone(*node.right)});
          },
          [](const Since& node) {
            return Node(Since{node.interval, clone(*node.left), clone(*node.right)});
          },
          [](const HeldFor& node) {
            return Node(HeldFor{clone(*node.operand), node.duration});
          },
          [](const Previously& node) { return Node(Previously{clone(*node.operand)}); },
          [](const Past& node) {
            return Node(Past{node.op, node.interval, clone(*node.operand)});
          },
          [](const Aggregate& node) {
            return Node(Aggregate{node.op, node.interval, clone(*node.operand)});
          },
          [](const ForOthers& node) {
            return Node(ForOthers{node.universal, clone(*node.body)});
          },
          [](const CountOthers& node) { return Node(CountOthers{clone(*node.body)}); },
          [](const OverMembers& node) {
            return Node(OverMembers{node.maximum, clone_all(node.operands)});
          },
          [](const Choice& node) {
            return Node(
                Choice{clone(*node.condition), clone(*node.then_value), clone(*node.else_value)});
          },
          [](const WithinOf& node) {
            return Node(WithinOf{clone(*node.operand), clone(*node.trigger), node.duration});
          },
          [](const PointInside& node) {
            return Node(PointInside{clone(*node.x), clone(*node.y), cloned(node.z), node.zone});
          },
          [](const PointClearance& node) {
            return Node(PointClearance{clone(*node.x), clone(*node.y), cloned(node.z), node.zone});
          },
          [](const WhileOpen& node) {
            return Node(WhileOpen{node.what, node.endless, clone(*node.operand)});
          },
          [](const TrailInside& node) {
            return Node(TrailInside{clone(node.trail), node.zone, node.outside});
          },
          [](const TrailClearance& node) {
            return Node(TrailClearance{clone(node.trail), node.zone, node.greatest});
          },
          [](const TrailDistance& node) {
            return Node(TrailDistance{clone(node.trail), clone(node.other)});
          },
          [](const auto& leaf) { return Node(leaf); },
      },
      written);
}

template <class Measure, class Join>
std::size_t over_parts(const Value& value, Measure&& measure, Join&& join) {
  std::size_t all = 0;
  if (const auto* expr = std::get_if<ExprPtr>(&value.node)) all = measure(**expr);
  const auto add = [&](const ExprPtr& expr) {
    if (expr) all = join(all, measure(*expr));
  };
  const auto add_pair = [&](const Pair& pair) {
    for (const ExprPtr* part : {&pair.x, &pair.y, &pair.z}) add(*part);
  };
  if (const auto* pair = std::get_if<Pair>(&value.node)) add_pair(*pair);
  if (const auto* pose = std::get_if<Pose>(&value.node)) {
    add_pair(pose->position);
    add(pose->heading);
  }
  if (const auto* way = std::get_if<Way>(&value.node)) {
    for (const Pair& place : way->places) add_pair(place);
  }
  if (const auto* twist = std::get_if<Twist>(&value.node)) {
    add(twist->linear);
    add(twist->angular);
  }
  if (const auto* choice = std::get_if<EnumChoice>(&value.node)) {
    add(choice->condition);
    for (const Value& option : choice->options) {
      all = join(all, over_parts(option, measure, join));
    }
  }
  if (const auto* array = std::get_if<Array>(&value.node)) {
    for (const Value& element : array->elements) {
      all = join(all, over_parts(element, measure, join));
    }
  }
  return all;
}

std::size_t depth_of(const Expr& expr) {
  std::size_t deepest = 0;
  for_each_operand(
      expr, [&](const ExprPtr& operand) { deepest = std::max(deepest, depth_of(*operand)); });
  return deepest + 1;
}

}  // namespace

Trail clone(const Trail& trail) {
  Trail copy{{}, trail.path, trail.next_only};
  for (const ExprPtr& coordinate : trail.own) copy.own.push_back(clone(*coordinate));
  return copy;
}
Pair clone(const Pair& pair) {
  return {pair.kind, clone(*pair.x), clone(*pair.y), pair.z ? clone(*pair.z) : nullptr, pair.frame};
}

namespace {

std::vector<Value> clone_all(const std::vector<Value>& values) {
  std::vector<Value> copies;
  copies.reserve(values.size());
  for (const Value& value : values) copies.push_back(clone(value));
  return copies;
}

}  // namespace

std::optional<EnumId> enumeration_of(const Value& value) {
  if (const auto* constant = std::get_if<EnumValue>(&value.node)) return constant->type;
  if (const auto* signal = std::get_if<EnumSignal>(&value.node)) return signal->type;
  const auto* choice = std::get_if<EnumChoice>(&value.node);
  return choice != nullptr ? enumeration_of(choice->options.front()) : std::nullopt;
}

ExprPtr clone(const Expr& expr) {
  return std::make_unique<Expr>(
      Expr{expr.range, expr.boolean, expr.dimension, clone_node(expr.node)});
}

Value clone(const Value& value) {
  return std::visit(
      Overloaded{
          [](std::monostate) { return Value(); },
          [](const ExprPtr& expr) { return Value(clone(*expr)); },
          [](const EnumValue& constant) { return Value(constant); },
          [](const EnumSignal& signal) { return Value(signal); },
          [](const Pair& pair) { return Value(clone(pair)); },
          [](const Array& array) { return Value(Array{clone_all(array.elements)}); },
          [](const Pose& pose) {
            return Value(Pose{clone(pose.position), clone(*pose.heading), pose.of});
          },
          [](const Twist& twist) {
            return Value(Twist{clone(*twist.linear), clone(*twist.angular)});
          },
          [](const EnumChoice& choice) {
            return Value(EnumChoice{clone(*choice.condition), clone_all(choice.options)});
          },
          [](const Way& way) {
            Way copy{{}, way.path, way.next_only, way.frame};
            for (const Pair& place : way.places) copy.places.push_back(clone(place));
            return Value(std::move(copy));
          },
      },
      value.node);
}

std::size_t size_of(const Value& value) {
  const auto count = [](const Expr& expr) {
    std::size_t nodes = 0;
    for_each_expr(expr, [&](const Expr&) { ++nodes; });
    return nodes;
  };
  return over_parts(value, count, [](std::size_t a, std::size_t b) { return a + b; });
}

std::size_t depth_of(const Value& value) {
  return over_parts(
      value, [](const Expr& expr) { return depth_of(expr); },
      [](std::size_t a, std::size_t b) { return std::max(a, b); });
}

bool is_integer(const Spec& spec, const Expr& expr) {
  if (expr.boolean || expr.dimension != dims::number) return false;
  const auto all = [&](const std::vector<ExprPtr>& operands) {
    return std::all_of(operands.begin(), operands.end(),
                       [&](const ExprPtr& operand) { return is_integer(spec, *operand); });
  };
  return std::visit(
      Overloaded{
          [](const Constant& constant) { return constant.value.get_den() == 1; },
          [](const CountOthers&) { return true; },
          [&](const InputRef& reference) {
            return spec[reference.input].type == InputType::integer;
          },
          [&](const ParamRef& reference) { return spec[reference.param].resolution == 1; },
          [&](const Arithmetic& node) {
            return node.op != ArithmeticOp::divide && all(node.operands);
          },
          [&](const Math& node) {
            const bool keeps = node.op == MathOp::minimum || node.op == MathOp::maximum ||
                               node.op == MathOp::absolute;
            return keeps && all(node.operands);
          },
          [&](const Choice& choice) {
            return is_integer(spec, *choice.then_value) && is_integer(spec, *choice.else_value);
          },
          [&](const Aggregate& aggregate) {
            if (aggregate.op == AggregateOp::count) return true;
            const bool keeps = aggregate.op == AggregateOp::minimum ||
                               aggregate.op == AggregateOp::maximum ||
                               aggregate.op == AggregateOp::sum;
            return keeps && is_integer(spec, *aggregate.operand);
          },
          [](const auto&) { return false; },
      },
      expr.node);
}

namespace {

std::string describe_pair(Pair::Kind kind, const Dimension& dimension, bool space) {
  if (kind == Pair::Kind::literal) return space ? "a triple" : "a pair";
  const std::string where = space ? " in space" : "";
  if (kind == Pair::Kind::point) return "a point" + where;
  const std::string unit = unit_of(dimension);
  return "a vector" + where + (unit.empty() ? "" : " (" + unit + ")");
}

std::string enumeration_text(const Spec& spec, EnumId type) {
  return "a value of `" + spec[type].name + "`";
}

}  // namespace

std::string describe(const Spec& spec, const Value& value) {
  return std::visit(
      Overloaded{
          [](std::monostate) { return std::string("a mistake"); },
          [](const ExprPtr& expr) {
            return expr->boolean ? std::string("a condition") : describe(expr->dimension);
          },
          [&](const EnumValue& constant) { return enumeration_text(spec, constant.type); },
          [&](const EnumSignal& signal) { return enumeration_text(spec, signal.type); },
          [](const Pair& pair) {
            return describe_pair(pair.kind, pair.x->dimension, pair.z != nullptr);
          },
          [&](const Pose& pose) { return "a pose of `" + spec[pose.of].name + "`"; },
          [](const Twist&) { return std::string("a twist"); },
          [](const Way& way) { return std::string(way.is_leg() ? "a leg" : "a path"); },
          [&](const EnumChoice&) { return enumeration_text(spec, *enumeration_of(value)); },
          [](const Array& array) {
            const std::size_t length = array.elements.size();
            return "an array of " + std::to_string(length) +
                   (length == 1 ? " element" : " elements");
          },
      },
      value.node);
}

std::string describe(const Spec& spec, const ValueType& type) {
  const auto element = [&]() -> std::string {
    switch (type.kind) {
      case TypeKind::boolean:
        return "a condition";
      case TypeKind::integer:
        return "a whole number";
      case TypeKind::real:
        return describe(type.dimension);
      case TypeKind::enumeration:
        return enumeration_text(spec, *type.enumeration);
      case TypeKind::point:
        return describe_pair(Pair::Kind::point, type.dimension, type.space);
      case TypeKind::vector:
        return describe_pair(Pair::Kind::vector, type.dimension, type.space);
      case TypeKind::pose:
        return "a pose of `" + spec[type.of].name + "`";
      case TypeKind::twist:
        return "a twist";
      case TypeKind::zone:
        return "a zone";
      case TypeKind::path:
        return "a path";
    }
    return "";
  }();
  const bool is_whole = type.kind == TypeKind::zone || type.kind == TypeKind::path;
  if (!type.length || is_whole) return element;
  return "an array of " + std::to_string(*type.length) + ", each " + element;
}

namespace {

bool fits(const Pair& pair, const ValueType& type) {
  const Pair::Kind other = type.kind == TypeKind::point ? Pair::Kind::vector : Pair::Kind::point;
  return pair.kind != other && pair.x->dimension == type.dimension &&
         (pair.z != nullptr) == type.space && pair.frame.value_or(type.frame) == type.frame;
}

}  // namespace

bool fits(const Spec& spec, const Value& value, const ValueType& type) {
  if (const auto* array = std::get_if<Array>(&value.node)) {
    ValueType element = type;
    element.length.reset();
    return type.length == array->elements.size() &&
           std::all_of(array->elements.begin(), array->elements.end(),
                       [&](const Value& each) { return fits(spec, each, element); });
  }
  if (type.length) return false;
  const auto* expr = std::get_if<ExprPtr>(&value.node);
  switch (type.kind) {
    case TypeKind::boolean:
      return expr != nullptr && (*expr)->boolean;
    case TypeKind::integer:
      return expr != nullptr && is_integer(spec, **expr);
    case TypeKind::real:
      return expr != nullptr && !(*expr)->boolean && (*expr)->dimension == type.dimension;
    case TypeKind::point:
    case TypeKind::vector: {
      const auto* pair = std::get_if<Pair>(&value.node);
      return pair != nullptr && fits(*pair, type);
    }
    case TypeKind::pose: {
      const auto* pose = std::get_if<Pose>(&value.node);
      return pose != nullptr && pose->of == type.of && pose->position.frame == type.frame;
    }
    case TypeKind::twist:
      return std::holds_alternative<Twist>(value.node);
    case TypeKind::zone:
    case TypeKind::path:
      return false;
    case TypeKind::enumeration:
      break;
  }
  return enumeration_of(value) == type.enumeration;
}

}  // namespace rtac::sema
