// Checked properties, evaluated as the semantic rules say it, on exact numbers (rules 2, 3, 4 and
// 7). Every operator is evaluated at every tick.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>

#include "compiler/interp/margin.h"
#include "compiler/interp/past.h"
#include "compiler/interp/robots.h"
#include "compiler/interp/signals.h"
#include "compiler/interp/span.h"
#include "compiler/interp/zones.h"
#include "compiler/sema/spec.h"

namespace rtac::interp {

class Evaluator {
 public:
  struct World {
    const sema::Spec& spec;
    const Signals& signals;
    const std::vector<Rational>& params;  // the present values, by ParamId
    Zones& zones;
    const Robots* robots;  // null: of monitors without a robot
  };
  // What the world refers to outlives the evaluator. `period`: of its ticks, s.
  Evaluator(const World& world, const Rational& period)
      : spec_(world.spec),
        period_(period),
        signals_(world.signals),
        params_(world.params),
        zones_(world.zones),
        robots_(world.robots) {}
  // Ticks come in order, each once for every property. `now_us`: of its step; none: it was missed.
  void start(Tick now, std::optional<std::int64_t> now_us = std::nullopt) {
    now_ = now;
    now_us_ = now_us;
  }
  Margin condition(const sema::Expr& expr);
  // All ticks up to `last` are no longer known.
  void forget(Tick last);
  // In SI, of the margins of one dimension.
  [[nodiscard]] Rational scale(const sema::Dimension& dimension) const;

 private:
  friend struct ConditionOf;
  friend struct QuantityOf;
  Span quantity(const sema::Expr& expr);
  // What a condition finds for each other robot, joined to what `start` is.
  template <class T, class Join>
  T over_others(const sema::Expr& body, T start, const Join& join);
  Span clearance_of_body(sema::ZoneId zone);
  Span distance_from_agent(const sema::AgentDistance& node);
  Margin plan_inside(sema::ZoneId zone);
  // Of a node that holds a place, coordinates `x`, `y` and perhaps `z`, against a zone.
  template <class Node>
  Whereabouts whereabouts(const Node& node);
  template <class Node>
  Span clearance_of_place(const sema::Expr& expr, const Node& node, const Whereabouts& place);
  Trail trail(const sema::Trail& node);
  Span aggregate(const sema::Expr& expr, const sema::Aggregate& node);
  // Whatever the quantity may be at any tick.
  Span anything(const sema::Expr& expr);
  [[nodiscard]] Window ticks(const sema::Interval& interval) const;
  [[nodiscard]] Tick ticks(const Rational& seconds) const;

  // What the operator remembers; made when it is met for the first time.
  template <class M, class Make>
  M& memory(const sema::Expr& expr, const Make& make);

  const sema::Spec& spec_;
  Rational period_;
  const Signals& signals_;
  const std::vector<Rational>& params_;
  Zones& zones_;
  const Robots* robots_;
  sema::RobotId other_{};  // of the quantifier around
  Tick now_ = 0;
  std::optional<std::int64_t> now_us_;
  std::unordered_map<const sema::Expr*, std::unique_ptr<Memory>> memories_;
};

}  // namespace rtac::interp
