#include "compiler/sema/same.h"

#include <variant>

#include "compiler/sema/visit.h"

namespace rtac::sema {
namespace {

bool same(const InputRef& a, const InputRef& b) {
  return a.input == b.input && a.component == b.component;
}
bool same(const Trail& a, const Trail& b) {
  return a.own.size() == b.own.size() && a.path == b.path && a.next_only == b.next_only;
}
bool same(const Interval& a, const Interval& b) {
  if (a.from.value != b.from.value || a.to.has_value() != b.to.has_value()) return false;
  return !a.to || a.to->value == b.to->value;
}

// What two nodes of one kind say besides their operands.
struct SameNode {
  const Expr& other;

  template <class Node>
  const Node& that() const {
    return std::get<Node>(other.node);
  }
  bool operator()(const Constant& a) const { return a.value == that<Constant>().value; }
  bool operator()(const Truth& a) const { return a.value == that<Truth>().value; }
  bool operator()(const InputRef& a) const { return same(a, that<InputRef>()); }
  bool operator()(const AgeOf& a) const { return a.input == that<AgeOf>().input; }
  bool operator()(const SensedAge& a) const { return a.signal == that<SensedAge>().signal; }
  bool operator()(const ParamRef& a) const { return a.param == that<ParamRef>().param; }
  bool operator()(const PointInside& a) const { return a.zone == that<PointInside>().zone; }
  bool operator()(const PointClearance& a) const { return a.zone == that<PointClearance>().zone; }
  bool operator()(const ZoneOpen& a) const { return a.zone == that<ZoneOpen>().zone; }
  bool operator()(const WhileOpen& a) const { return a.what == that<WhileOpen>().what; }
  bool operator()(const PathGiven& a) const { return a.input == that<PathGiven>().input; }
  bool operator()(const TrailInside& a) const {
    const auto& b = that<TrailInside>();
    return same(a.trail, b.trail) && a.zone == b.zone && a.outside == b.outside;
  }
  bool operator()(const TrailClearance& a) const {
    const auto& b = that<TrailClearance>();
    return same(a.trail, b.trail) && a.zone == b.zone && a.greatest == b.greatest;
  }
  bool operator()(const TrailDistance& a) const {
    const auto& b = that<TrailDistance>();
    return same(a.trail, b.trail) && same(a.other, b.other);
  }
  bool operator()(const ZoneDistance& a) const {
    const auto& b = that<ZoneDistance>();
    return a.zone == b.zone && a.other == b.other;
  }
  bool operator()(const IsValue& a) const {
    const auto& b = that<IsValue>();
    return same({a.input, a.component}, {b.input, b.component}) && a.value == b.value;
  }
  bool operator()(const SameValue& a) const {
    const auto& b = that<SameValue>();
    return same(a.left, b.left) && same(a.right, b.right);
  }
  bool operator()(const Arithmetic& a) const { return a.op == that<Arithmetic>().op; }
  bool operator()(const Compare& a) const { return a.op == that<Compare>().op; }
  bool operator()(const Logic& a) const { return a.op == that<Logic>().op; }
  bool operator()(const Math& a) const { return a.op == that<Math>().op; }
  bool operator()(const Choice&) const { return true; }
  bool operator()(const Previously&) const { return true; }
  bool operator()(const HeldFor& a) const {
    return a.duration.value == that<HeldFor>().duration.value;
  }
  bool operator()(const WithinOf& a) const {
    return a.duration.value == that<WithinOf>().duration.value;
  }
  bool operator()(const Past& a) const {
    const auto& b = that<Past>();
    return a.op == b.op && same(a.interval, b.interval);
  }
  bool operator()(const Since& a) const { return same(a.interval, that<Since>().interval); }
  bool operator()(const Aggregate& a) const {
    const auto& b = that<Aggregate>();
    return a.op == b.op && same(a.interval, b.interval);
  }
  template <class OfRobots>
  bool operator()(const OfRobots&) const {
    return false;
  }
};

}  // namespace

bool same_value(const Expr& a, const Expr& b) {
  if (a.node.index() != b.node.index() || !std::visit(SameNode{b}, a.node)) return false;
  std::vector<const Expr*> left, right;
  for_each_operand(a, [&](const ExprPtr& operand) { left.push_back(operand.get()); });
  for_each_operand(b, [&](const ExprPtr& operand) { right.push_back(operand.get()); });
  if (left.size() != right.size()) return false;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (!same_value(*left[i], *right[i])) return false;
  }
  return true;
}

}  // namespace rtac::sema
