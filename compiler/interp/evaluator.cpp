#include "compiler/interp/evaluator.h"

#include <algorithm>
#include <utility>

#include "compiler/interp/aggregate.h"
#include "compiler/interp/arithmetic.h"
#include "compiler/interp/openings.h"
#include "compiler/sema/dimension.h"

namespace rtac::interp {

template <class M, class Make>
M& Evaluator::memory(const sema::Expr& expr, const Make& make) {
  std::unique_ptr<Memory>& place = memories_[&expr];
  if (!place) place = std::make_unique<M>(make());
  return static_cast<M&>(*place);
}

Tick Evaluator::ticks(const Rational& seconds) const {
  return floor_to_int(seconds / period_);
}

Window Evaluator::ticks(const sema::Interval& interval) const {
  Window window{ticks(interval.from.value), std::nullopt};
  if (interval.to) window.to = ticks(interval.to->value);
  return window;
}

// Rule 4: one scale per dimension: 1 in SI, 1 % of ratios, or what the specification says.
Rational Evaluator::scale(const sema::Dimension& dimension) const {
  for (const sema::MarginScale& s : spec_.scales) {
    if (s.dimension == dimension) return s.value.value;
  }
  return dimension == sema::dims::ratio ? Rational(1, 100) : Rational(1);
}

void Evaluator::forget(Tick last) {
  for (auto& [expr, memory] : memories_) memory->forget(last);
}

// ---- conditions -------------------------------------------------------------------------------

struct ConditionOf {
  Evaluator& self;
  const sema::Expr& expr;

  Margin of(const sema::ExprPtr& operand) const { return self.condition(*operand); }
  Margin missing(sema::InputId input) const { return unknown_margin({true, input}); }

  Margin operator()(const sema::Truth& node) const { return truth(node.value); }

  // Rule 4: x >= c has the margin x - c; x <= c has c - x.
  Margin operator()(const sema::Compare& node) const {
    const Span left = self.quantity(*node.left);
    const Span right = self.quantity(*node.right);
    const sema::Dimension& dimension = node.left->dimension;
    const Rational scale = self.scale(dimension);
    switch (node.op) {
      case sema::CompareOp::greater_equal:
        return at_least(left, right, false, dimension, scale);
      case sema::CompareOp::greater:
        return at_least(left, right, true, dimension, scale);
      case sema::CompareOp::less_equal:
        return at_least(right, left, false, dimension, scale);
      case sema::CompareOp::less:
        return at_least(right, left, true, dimension, scale);
    }
    return unknown_margin({});
  }

  // Rule 4: `not` swaps and negates; `and`, `or` take minima and maxima; the others follow.
  Margin operator()(const sema::Logic& node) const {
    const Margin first = of(node.operands.front());
    if (node.op == sema::LogicOp::logical_not) return negate(first);
    Margin result = first;
    for (std::size_t i = 1; i < node.operands.size(); ++i) {
      result = joined(node.op, result, of(node.operands[i]));
    }
    return result;
  }
  static Margin joined(sema::LogicOp op, const Margin& a, const Margin& b) {
    switch (op) {
      case sema::LogicOp::logical_not:
        break;
      case sema::LogicOp::logical_and:
        return both(a, b);
      case sema::LogicOp::logical_or:
        return either(a, b);
      case sema::LogicOp::implies:
        return either(negate(a), b);
      case sema::LogicOp::iff:
        return both(either(negate(a), b), either(negate(b), a));
      case sema::LogicOp::logical_xor:
        return both(either(a, b), either(negate(a), negate(b)));
    }
    return unknown_margin({});
  }

  // Rule 4: atoms without a quantity are +-inf.
  Margin operator()(const sema::InputRef& node) const {
    const auto& value = self.signals_.measured(node.input, node.component);
    return value ? truth(*value != 0) : missing(node.input);
  }
  Margin operator()(const sema::IsValue& node) const {
    const auto& value = self.signals_.measured(node.input, node.component);
    return value ? truth(*value == node.value) : missing(node.input);
  }
  Margin operator()(const sema::SameValue& node) const {
    const auto& left = self.signals_.measured(node.left.input, node.left.component);
    const auto& right = self.signals_.measured(node.right.input, node.right.component);
    if (!left || !right) return missing(left ? node.right.input : node.left.input);
    return truth(*left == *right);
  }

  // Rule 7: a window holds its first instant and not its last; nobody knows when a missed tick was.
  Margin operator()(const sema::ZoneOpen& node) const {
    if (!self.now_us_) return unknown_margin({true, std::nullopt});
    return truth(is_open(self.spec_[node.zone].openings, *self.now_us_));
  }

  // Rule 7: p inside Z has the margin of clearance(p, Z) >= 0; which places lie in Z is exact.
  Margin operator()(const sema::PointInside& node) const {
    const Whereabouts at = self.whereabouts(node);
    const Span gap = self.clearance_of_place(expr, node, at);
    static const sema::Dimension& length = sema::dims::length;
    Margin margin = at_least(gap, exactly(Rational(0)), false, length, self.scale(length));
    // a distance too small for its root
    if (margin.hi.value.sign() == 0 && self.zones_.outside(node.zone, at)) margin.hi.below = true;
    return margin;
  }

  // Rule 8.1: that of the least clearance that is at least 0, or of the greatest that is below.
  Margin operator()(const sema::TrailInside& node) const {
    static const sema::Dimension& length = sema::dims::length;
    const Trail trail = self.trail(node.trail);
    const Span gap = self.zones_.clearance(node.zone, trail, node.outside);
    const Span none = exactly(Rational(0));
    Margin margin = node.outside ? at_least(none, gap, true, length, self.scale(length))
                                 : at_least(gap, none, false, length, self.scale(length));
    // however little of it is there
    const bool leaves = self.zones_.surely_leaves(node.zone, trail, node.outside);
    if (margin.hi.value.sign() == 0 && leaves) margin.hi.below = true;
    return margin;
  }
  Margin operator()(const sema::PathGiven& node) const {
    const auto path = self.signals_.path(node.input);
    return path ? truth(!path->points.empty()) : missing(node.input);
  }

  // Rule 7: r inside Z, of a body, is clearance(r, Z) >= 0.
  Margin operator()(const sema::InsideZone& node) const {
    static const sema::Dimension& length = sema::dims::length;
    return at_least(self.clearance_of_body(node.zone), exactly(Rational(0)), false, length,
                    self.scale(length));
  }
  Margin operator()(const sema::PlanInside& node) const { return self.plan_inside(node.zone); }
  Margin operator()(const sema::ForOthers& node) const {
    return self.over_others(*node.body, truth(node.universal),
                            [&](const Margin& all, const Margin& each) {
                              return node.universal ? both(all, each) : either(all, each);
                            });
  }

  // Rule 2: f for d: f on all of [0, d], and d has passed since the start.
  Margin operator()(const sema::HeldFor& node) const {
    const Tick d = self.ticks(node.duration.value);
    PastMemory& memory = self.memory<PastMemory>(expr, [&] { return PastMemory(false, {0, d}); });
    return both(memory.step(self.now_, of(node.operand)), truth(self.now_ >= d));
  }
  Margin operator()(const sema::Previously& node) const {
    const Margin operand = of(node.operand);
    return self.memory<PreviouslyMemory>(expr, [] { return PreviouslyMemory(); })
        .step(self.now_, operand);
  }
  Margin operator()(const sema::Past& node) const {
    const Margin operand = of(node.operand);
    const auto make = [&] {
      return PastMemory(node.op == sema::PastOp::once, self.ticks(node.interval));
    };
    return self.memory<PastMemory>(expr, make).step(self.now_, operand);
  }
  Margin operator()(const sema::Since& node) const {
    const Margin left = of(node.left);
    const Margin right = of(node.right);
    return self.memory<SinceMemory>(expr, [&] { return SinceMemory(self.ticks(node.interval)); })
        .step(self.now_, left, right);
  }
  // Rule 2: f within d of g: not ((not f) since[d, inf] (g and not f)).
  Margin operator()(const sema::WithinOf& node) const {
    const Margin miss = negate(of(node.operand));
    const Margin trigger = both(of(node.trigger), miss);
    const auto make = [&] { return SinceMemory({self.ticks(node.duration.value), std::nullopt}); };
    return negate(self.memory<SinceMemory>(expr, make).step(self.now_, miss, trigger));
  }

  // No conditions: nothing is known of them.
  template <class Other>
  Margin operator()(const Other&) const {
    return unknown_margin({});
  }
};

Margin Evaluator::condition(const sema::Expr& expr) {
  return std::visit(ConditionOf{*this, expr}, expr.node);
}

template <class T, class Join>
T Evaluator::over_others(const sema::Expr& body, T start, const Join& join) {
  if (robots_ == nullptr) return join(start, unknown_margin({true, std::nullopt}));
  for (const sema::RobotId other : robots_->others()) {
    other_ = other;
    start = join(start, condition(body));
  }
  return start;
}

// Rule 7: the gap between the disc, in space the ball, and the boundary.
Span Evaluator::clearance_of_body(sema::ZoneId zone) {
  const auto centre = robots_ == nullptr ? std::nullopt : robots_->place(robots_->self());
  if (!centre) return unknown(std::nullopt);
  const Rational error = robots_->place_error();
  const Span body = exactly(robots_->kind().radius.value);
  const std::optional<Rational> height = robots_->height(robots_->self());
  const Span gap = subtract(zones_.clearance_of_robots(zone, *centre, height), body);
  return add(gap, between(Rational(-error), error));
}

// Rule 9.8: the gap between two discs, of an agent in space between two balls, and of one of the
// plane on the map; an agent that is known to be absent is farther than anything.
Span Evaluator::distance_from_agent(const sema::AgentDistance& node) {
  if (node.present) {
    const auto& present = signals_.measured(*node.present, 0);
    if (present && *present == 0) {
      return between(Extended::infinity(1), Extended::infinity(1));
    }
  }
  const auto centre = robots_ == nullptr ? std::nullopt : robots_->place(robots_->self());
  const auto& x = signals_.measured(node.seen, 0);
  const auto& y = signals_.measured(node.seen, 1);
  if (!centre) return unknown(std::nullopt);
  if (!x || !y) return unknown(node.seen);
  const Rational dx = *x - centre->x, dy = *y - centre->y;
  const sema::Agent& agent = spec_[node.agent];
  Rational dz = 0;
  if (agent.in_space) {
    const auto& z = signals_.measured(node.seen, 2);
    const auto own = robots_->height(robots_->self());
    if (!z || !own) return unknown(node.seen);
    dz = *z - *own;
  }
  const Root apart = square_root(Rational(dx * dx + dy * dy + dz * dz));
  const Rational bodies = robots_->kind().radius.value + agent.radius.value;
  const Rational error = robots_->place_error() + agent.position.error.value;
  return between(Rational(apart.below - bodies - error), Rational(apart.above - bodies + error));
}

// Rule 8: every way-point and every leg; without any of them there is nothing to object.
Margin Evaluator::plan_inside(sema::ZoneId zone) {
  static const sema::Dimension& length = sema::dims::length;
  const auto margin = [&](const Span& gap) {
    return at_least(gap, exactly(Rational(0)), false, length, scale(length));
  };
  if (robots_ == nullptr || !robots_->plan()) return margin(unknown(std::nullopt));
  const std::vector<Place>& points = robots_->plan()->points;
  Margin worst = margin(between(Extended::infinity(1), Extended::infinity(1)));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto way = zones_.clearance_of_way(zone, points[k == 0 ? 0 : k - 1], points[k]);
    Margin leg = margin(way.gap);
    if (way.leaves) leg.lo.below = leg.hi.below = true;
    worst = both(worst, leg);
  }
  return worst;
}

namespace {

// What never changes, computed once.
struct Bounds : Memory {
  explicit Bounds(Span whole) : span(std::move(whole)) {}
  void forget(Tick) override {}
  Span span;
};

}  // namespace

// Rule 7: that of the measured place, less and more the error, but never more or less than a place
// has anywhere in its declared range.
template <class Node>
Span Evaluator::clearance_of_place(const sema::Expr& expr, const Node& node,
                                   const Whereabouts& place) {
  Span gap = zones_.clearance(node.zone, place);
  const Bounds& anywhere = memory<Bounds>(expr, [&] {
    Whereabouts any{anything(*node.x), anything(*node.y), std::nullopt};
    if (node.z) any.z = anything(*node.z);
    return Bounds(zones_.range(node.zone, any));
  });
  if (gap.missing.missing || anywhere.span.missing.missing) return gap;
  gap.lo = std::max(gap.lo, anywhere.span.lo);
  gap.hi = std::min(gap.hi, anywhere.span.hi);
  return gap;
}

template <class Node>
Whereabouts Evaluator::whereabouts(const Node& node) {
  Whereabouts at{quantity(*node.x), quantity(*node.y), std::nullopt};
  if (node.z) at.z = quantity(*node.z);
  return at;
}

// Rule 8.1: places of its own, then all of a path or, behind such places, what is left of it.
Trail Evaluator::trail(const sema::Trail& node) {
  Trail trail;
  for (std::size_t i = 0; i + 1 < node.own.size(); i += 2) {
    lead_on(trail, quantity(*node.own[i]), quantity(*node.own[i + 1]));
  }
  if (!node.path) return trail;
  const auto path = signals_.path(*node.path);
  if (!path) {
    if (!trail.missing.missing) trail.missing = {true, *node.path};
    return trail;
  }
  std::size_t from = node.own.empty() ? 0 : path->next;
  const std::size_t end =
      node.next_only ? std::min(from + 1, path->points.size()) : path->points.size();
  for (; from < end; ++from) lead_on(trail, path->points[from]);
  return trail;
}

// ---- quantities -------------------------------------------------------------------------------

namespace {

// Rule 2: `count` counts for its lower end where the condition is true, for its upper end where it
// is not false.
Span counted(const Margin& condition) {
  return between(Rational(not_negative(condition.lo) ? 1 : 0),
                 Rational(not_negative(condition.hi) ? 1 : 0));
}

}  // namespace

struct QuantityOf {
  Evaluator& self;
  const sema::Expr& expr;

  Span of(const sema::ExprPtr& operand) const { return self.quantity(*operand); }
  std::vector<Span> all(const std::vector<sema::ExprPtr>& operands) const {
    std::vector<Span> spans;
    for (const sema::ExprPtr& operand : operands) spans.push_back(of(operand));
    return spans;
  }

  Span operator()(const sema::Constant& node) const { return exactly(node.value); }
  Span operator()(const sema::ParamRef& node) const {
    return exactly(self.params_[static_cast<std::size_t>(node.param)]);
  }
  Span operator()(const sema::InputRef& node) const {
    return self.signals_.quantity(node.input, node.component);
  }
  Span operator()(const sema::AgeOf& node) const { return self.signals_.age(node.input); }
  Span operator()(const sema::SensedAge& node) const {
    return self.robots_ == nullptr ? unknown(std::nullopt) : self.robots_->age(node.signal);
  }
  Span operator()(const sema::PointClearance& node) const {
    return self.clearance_of_place(expr, node, self.whereabouts(node));
  }
  Span operator()(const sema::TrailClearance& node) const {
    return self.zones_.clearance(node.zone, self.trail(node.trail), node.greatest);
  }
  Span operator()(const sema::TrailDistance& node) const {
    return distance_of(self.trail(node.trail), self.trail(node.other));
  }
  Span operator()(const sema::ZoneDistance& node) const {
    return self.zones_.apart(node.zone, node.other);
  }
  Span operator()(const sema::Arithmetic& node) const {
    if (is_square(node)) return square(of(node.operands.front()));
    return arithmetic(node.op, all(node.operands));
  }
  Span operator()(const sema::Math& node) const { return math(node.op, all(node.operands)); }

  // Rule 4: the hull of both when the condition is not decided.
  Span operator()(const sema::Choice& node) const {
    const Margin condition = self.condition(*node.condition);
    const Span then_value = of(node.then_value);
    const Span else_value = of(node.else_value);
    switch (verdict(condition)) {
      case Verdict::yes:
        return then_value;
      case Verdict::no:
        return else_value;
      case Verdict::unknown:
        break;
    }
    return hull(then_value, else_value);
  }
  Span operator()(const sema::Aggregate& node) const { return self.aggregate(expr, node); }

  Span operator()(const sema::SignalRef& node) const {
    if (self.robots_ == nullptr) return unknown(std::nullopt);
    const bool own = node.subject == sema::Subject::self;
    const sema::RobotId robot = own ? self.robots_->self() : self.other_;
    if (node.signal == sema::Signal::altitude) return self.robots_->altitude();
    return node.signal == sema::Signal::battery ? self.robots_->battery(robot)
                                                : self.robots_->speed(robot);
  }
  Span operator()(const sema::Clearance& node) const { return self.clearance_of_body(node.zone); }
  Span operator()(const sema::Distance&) const {
    return self.robots_ == nullptr ? unknown(std::nullopt) : self.robots_->distance(self.other_);
  }
  Span operator()(const sema::AgentDistance& node) const { return self.distance_from_agent(node); }
  Span operator()(const sema::EnergyTo& node) const {
    return self.robots_ == nullptr ? unknown(std::nullopt) : self.robots_->energy_to(node.site);
  }
  // Rule 4.6: at least who surely does, at most who does not surely fail.
  Span operator()(const sema::CountOthers& node) const {
    return self.over_others(
        *node.body, exactly(Rational(0)),
        [](const Span& count, const Margin& each) { return add(count, counted(each)); });
  }

  // No quantities, or none that a checked property has: nothing is known of them.
  template <class Other>
  Span operator()(const Other&) const {
    return unknown(std::nullopt);
  }
};

Span Evaluator::quantity(const sema::Expr& expr) {
  return std::visit(QuantityOf{*this, expr}, expr.node);
}

namespace {

Span mean(const SumMemory::Sum& sum) {
  if (sum.ticks == 0) return unknown(std::nullopt);
  return divide(sum.total, exactly(Rational(static_cast<long>(sum.ticks))));
}

}  // namespace

// Rule 2: aggregates range over the ticks of the window that exist; at an unknown tick the operand
// counts as the whole range that it has by declaration, or as unknown without one.
Span Evaluator::aggregate(const sema::Expr& expr, const sema::Aggregate& node) {
  const bool counts = node.op == sema::AggregateOp::count;
  const Window window = ticks(node.interval);
  const auto any = [&] {
    return counts ? between(Rational(0), Rational(1)) : anything(*node.operand);
  };
  Span operand = counts ? counted(condition(*node.operand)) : quantity(*node.operand);
  if (operand.missing.missing) {
    if (const Span range = any(); !range.missing.missing) operand = range;
  }
  const auto sum = [&] {
    return memory<SumMemory>(expr, [&] { return SumMemory(window, any()); }).step(now_, operand);
  };
  const auto extreme = [&](bool greatest) {
    return memory<ExtremeMemory>(expr, [&] { return ExtremeMemory(greatest, window, any()); })
        .step(now_, operand);
  };
  switch (node.op) {
    case sema::AggregateOp::minimum:
      return extreme(false);
    case sema::AggregateOp::maximum:
      return extreme(true);
    case sema::AggregateOp::mean:
      return mean(sum());
    case sema::AggregateOp::sum:
    case sema::AggregateOp::count:
      return sum().total;
    case sema::AggregateOp::rate:
      break;
  }
  const auto make = [&] { return RateMemory(window, period_, any()); };
  return memory<RateMemory>(expr, make).step(now_, operand);
}

Span Evaluator::anything(const sema::Expr& expr) {
  return whole_range(expr, spec_, period_, zones_);
}

}  // namespace rtac::interp
