// What inputs that are told within a box, as old as they may be, make of a property: true, false,
// or either; and of a number, between what it lies.
#pragma once

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "compiler/analysis/told.h"
#include "compiler/sema/visit.h"

namespace rtac::analysis::reading {

// Beyond what an input without a range may be, in SI units.
inline const Rational endless = 1'000'000'000;
inline const Rational age_step(1, 1'000'000);  // s: stamps are whole microseconds

enum class Truth3 { no, open, yes };
inline Truth3 negated(Truth3 t) {
  return t == Truth3::open ? t : t == Truth3::yes ? Truth3::no : Truth3::yes;
}
inline Truth3 from(bool yes) {
  return yes ? Truth3::yes : Truth3::no;
}

struct Span {
  Rational lo, hi;
};
using Number = std::optional<Span>;  // none: nobody knows

inline Span hull(std::initializer_list<Rational> ends) {
  return {*std::ranges::min_element(ends), *std::ranges::max_element(ends)};
}

// Of what stays as it is.
inline bool is_of_its_values(sema::AggregateOp op) {
  return op == sema::AggregateOp::minimum || op == sema::AggregateOp::maximum ||
         op == sema::AggregateOp::mean;
}

// What is told: a component of an input, how old it is, or how old is what the robot senses; or a
// parameter.
struct Name {
  enum class Of { input, age, sensed, param } of = Of::input;
  std::uint32_t index = 0, component = 0;
  auto operator<=>(const Name&) const = default;
};
inline Name age_of(sema::InputId id) {
  return {Name::Of::age, static_cast<std::uint32_t>(id), 0};
}
inline Name age_of(sema::Sensed signal) {
  return {Name::Of::sensed, static_cast<std::uint32_t>(signal), 0};
}
inline Name param_of(sema::ParamId id) {
  return {Name::Of::param, static_cast<std::uint32_t>(id), 0};
}
struct Variable {
  Span span;
  Rational error, step;  // of what is measured; 0: any value
  bool is_whole = false;
  // Of an age: what is older counts no more; none: for ever, or nobody says how long.
  std::optional<Rational> counts = std::nullopt;
};
using Variables = std::map<Name, Variable>;
using Spans = std::map<Name, Span>;

template <class Node, class... Of>
constexpr bool is_one_of = (std::is_same_v<Node, Of> || ...);

inline bool is_sensed(const sema::Input& input) {
  return input.robot || input.agent;
}
// Whether a part of it is what robots sense, of themselves or of agents.
inline bool speaks_of_sensed(const sema::Spec& spec, const sema::Expr& e) {
  bool found = sema::speaks_of_robot(e);
  sema::for_each_expr(e, [&](const sema::Expr& part) {
    const auto look = [&](sema::InputId id) { found = found || is_sensed(spec[id]); };
    if (const auto* v = std::get_if<sema::InputRef>(&part.node)) look(v->input);
    if (const auto* v = std::get_if<sema::IsValue>(&part.node)) look(v->input);
    if (const auto* v = std::get_if<sema::SameValue>(&part.node)) {
      look(v->left.input);
      look(v->right.input);
    }
  });
  return found;
}
// What of itself a robot has to have sensed to know it.
inline std::optional<sema::Sensed> sensed_for(const sema::Expr& e) {
  if (const auto* v = std::get_if<sema::SignalRef>(&e.node)) {
    if (v->subject == sema::Subject::other) return std::nullopt;
    if (v->signal == sema::Signal::speed) return sema::Sensed::velocity;
    return v->signal == sema::Signal::battery ? sema::Sensed::battery : sema::Sensed::position;
  }
  const bool by_place = std::holds_alternative<sema::Clearance>(e.node) ||
                        std::holds_alternative<sema::InsideZone>(e.node) ||
                        std::holds_alternative<sema::Distance>(e.node) ||
                        std::holds_alternative<sema::AgentDistance>(e.node) ||
                        std::holds_alternative<sema::EnergyTo>(e.node);
  return by_place ? std::optional(sema::Sensed::position) : std::nullopt;
}

// A property in a box.
class Reader {
 public:
  // `stays`: inputs are what they are for ever, so that the past is as now; else they have been
  // anything in `ever`. `rest`: of a robot that rests; null: it does as suits.
  Reader(const sema::Spec& spec, const Variables& variables, const Spans& box, const Spans& ever,
         bool stays, const SeenAtRest* rest)
      : spec_(spec), variables_(variables), box_(box), ever_(ever), stays_(stays), rest_(rest) {}

  // `suits`: what anything is that robots sense. Of what nobody knows it is open.
  [[nodiscard]] Truth3 truth(const sema::Expr& e, bool suits) const {
    const auto [at, is_new] = truths_.try_emplace({&e, suits}, Truth3::open);
    if (is_new) {
      at->second = std::visit([&](const auto& node) { return says(node, e, suits); }, e.node);
    }
    return at->second;
  }

 private:
  static Truth3 says(const sema::Truth& v, const sema::Expr&, bool) { return from(v.value); }
  [[nodiscard]] Truth3 says(const sema::Logic& v, const sema::Expr&, bool suits) const {
    return logic(v, suits);
  }
  [[nodiscard]] Truth3 says(const sema::HeldFor& v, const sema::Expr&, bool suits) const {
    return held(*v.operand, suits);
  }
  [[nodiscard]] Truth3 says(const sema::Previously& v, const sema::Expr&, bool suits) const {
    return past(*v.operand, suits, false, false);
  }
  [[nodiscard]] Truth3 says(const sema::Past& v, const sema::Expr&, bool suits) const {
    return past(*v.operand, suits, sgn(v.interval.from.value) == 0,
                v.op == sema::PastOp::historically);
  }
  [[nodiscard]] Truth3 says(const sema::Since& v, const sema::Expr&, bool suits) const {
    const bool with_now = sgn(v.interval.from.value) == 0;
    const Truth3 left = truth(*v.left, suits), right = truth(*v.right, suits);
    return since(left, right, ever(*v.right, suits, right), with_now);
  }
  // not ((not φ) since (ψ and not φ)), which begins in the past.
  [[nodiscard]] Truth3 says(const sema::WithinOf& v, const sema::Expr&, bool suits) const {
    const Truth3 is = truth(*v.operand, suits), asked = truth(*v.trigger, !suits);
    const Truth3 ever_missed =
        both(ever(*v.trigger, !suits, asked), negated(ever(*v.operand, suits, is)));
    return negated(since(negated(is), both(asked, negated(is)), ever_missed, false));
  }
  // Of no others it may be so whatever its body says.
  [[nodiscard]] Truth3 says(const sema::ForOthers& v, const sema::Expr&, bool suits) const {
    return truth(*v.body, suits) == from(suits) ? from(suits) : Truth3::open;
  }
  [[nodiscard]] Truth3 says(const sema::InputRef& v, const sema::Expr& e, bool suits) const {
    const Number n = of(v);
    if (!n) return unknown(e, suits);
    if (is_old(age_of(v.input))) return from(!suits);
    return n->lo == n->hi ? from(sgn(n->lo) != 0) : Truth3::open;
  }
  [[nodiscard]] Truth3 says(const sema::IsValue& v, const sema::Expr& e, bool suits) const {
    const Number n = of({v.input, v.component});
    if (!n) return unknown(e, suits);
    if (is_old(age_of(v.input))) return from(!suits);
    const Rational value = static_cast<unsigned long>(v.value);
    if (n->lo == n->hi) return from(n->lo == value);
    return value < n->lo || value > n->hi ? Truth3::no : Truth3::open;
  }
  [[nodiscard]] Truth3 says(const sema::SameValue& v, const sema::Expr& e, bool suits) const {
    const Number a = of(v.left), b = of(v.right);
    if (!a || !b) return unknown(e, suits);
    if (is_old(age_of(v.left.input)) || is_old(age_of(v.right.input))) return from(!suits);
    if (a->hi < b->lo || b->hi < a->lo) return Truth3::no;
    return a->lo == a->hi && b->lo == b->hi ? Truth3::yes : Truth3::open;
  }
  [[nodiscard]] Truth3 says(const sema::Compare& v, const sema::Expr& e, bool suits) const {
    const Number a = number(*v.left), b = number(*v.right);
    // a side of which robots say nothing is for inputs to say
    if (!a && !speaks_of_sensed(spec_, *v.left)) return Truth3::open;
    if (!b && !speaks_of_sensed(spec_, *v.right)) return Truth3::open;
    if (!a || !b) return rest_ != nullptr && !charge_ ? charged(v, e, suits) : unknown(e, suits);
    if (is_old(*v.left) || is_old(*v.right)) return from(!suits);
    return compared(v.op, *a, *b);
  }
  static Truth3 compared(sema::CompareOp op, const Span& a, const Span& b) {
    const bool strictly = op == sema::CompareOp::less || op == sema::CompareOp::greater;
    const bool is_least = op == sema::CompareOp::less || op == sema::CompareOp::less_equal;
    return is_least ? ordered(a, b, strictly) : ordered(b, a, strictly);
  }
  // Of charge what suits is none, or as much as a full battery is seen with, and a way that takes
  // none; where neither of these does, nothing else does.
  [[nodiscard]] Truth3 charged(const sema::Compare& v, const sema::Expr& e, bool suits) const {
    bool open = false;
    for (const Rational& charge : {Rational(0), rest_->charge}) {
      Reader best(spec_, variables_, box_, ever_, stays_, rest_);
      best.charge_ = charge;
      const Number a = best.number(*v.left), b = best.number(*v.right);
      if (!a || !b) return unknown(e, suits);
      const Truth3 is = compared(v.op, *a, *b);
      if (is == from(suits)) return unknown(e, suits);
      open = open || is == Truth3::open;
    }
    return open ? Truth3::open : from(!suits);
  }
  // What time it is suits.
  static Truth3 says(const sema::ZoneOpen&, const sema::Expr&, bool suits) { return from(suits); }
  template <class Node>
  [[nodiscard]] Truth3 says(const Node&, const sema::Expr& e, bool suits) const {
    // Every condition is named above but these, of places; the others are quantities.
    static_assert(
        is_one_of<Node, sema::InsideZone, sema::PlanInside, sema::PointInside, sema::TrailInside,
                  sema::PathGiven> ||
        is_one_of<Node, sema::Constant, sema::SignalRef, sema::Clearance, sema::Distance,
                  sema::EnergyTo, sema::Arithmetic, sema::CountOthers, sema::OverMembers,
                  sema::AgeOf, sema::SensedAge, sema::ParamRef, sema::PointClearance,
                  sema::WhileOpen, sema::TrailClearance, sema::TrailDistance, sema::ZoneDistance,
                  sema::Math, sema::Choice, sema::Aggregate, sema::AgentDistance>);
    return unknown(e, suits);
  }

  // What robots sense is as it suits, unless that is too old to count; of anything else nobody
  // knows, nor of how many robots it is so where inputs have a say.
  [[nodiscard]] Truth3 unknown(const sema::Expr& e, bool suits) const {
    if (!speaks_of_sensed(spec_, e)) return Truth3::open;
    bool is_told = false, old = false;
    sema::for_each_expr(e, [&](const sema::Expr& part) {
      const auto* const count = std::get_if<sema::CountOthers>(&part.node);
      is_told = is_told || (count != nullptr && (!inputs_in(spec_, *count->body).empty() ||
                                                 sema::speaks_of<sema::SensedAge>(*count->body)));
      const auto signal = sensed_for(part);
      old = old || (signal && is_old(age_of(*signal)));
    });
    if (is_told) return Truth3::open;
    return from(old ? !suits : suits);
  }
  // Wherever in the box, older than what counts.
  [[nodiscard]] bool is_old(const Name& age) const {
    const auto at = box_.find(age);
    if (at == box_.end()) return false;
    const auto& counts = variables_.at(age).counts;
    return counts && at->second.lo > *counts;
  }
  // A number that nobody knows then, within any bounds.
  [[nodiscard]] bool is_old(const sema::Expr& e) const {
    if (const auto* v = std::get_if<sema::InputRef>(&e.node)) return is_old(age_of(v->input));
    const auto* const sum = std::get_if<sema::Arithmetic>(&e.node);
    return sum != nullptr && sum->op != sema::ArithmeticOp::multiply &&
           sum->op != sema::ArithmeticOp::divide &&
           std::ranges::any_of(sum->operands, [&](const auto& each) { return is_old(*each); });
  }
  [[nodiscard]] Truth3 all(const sema::Logic& v, bool suits, bool conjunction) const {
    const Truth3 end = conjunction ? Truth3::no : Truth3::yes;
    Truth3 found = negated(end);
    for (const auto& operand : v.operands) {
      const Truth3 each = truth(*operand, suits);
      if (each == end) return end;
      if (each == Truth3::open) found = Truth3::open;
    }
    return found;
  }
  [[nodiscard]] Truth3 logic(const sema::Logic& v, bool suits) const {
    switch (v.op) {
      case sema::LogicOp::logical_not:
        return negated(truth(*v.operands[0], !suits));
      case sema::LogicOp::logical_and:
        return all(v, suits, true);
      case sema::LogicOp::logical_or:
        return all(v, suits, false);
      case sema::LogicOp::implies: {
        const Truth3 unless = negated(truth(*v.operands[0], !suits));
        const Truth3 then = truth(*v.operands[1], suits);
        if (unless == Truth3::yes || then == Truth3::yes) return Truth3::yes;
        return unless == Truth3::no && then == Truth3::no ? Truth3::no : Truth3::open;
      }
      case sema::LogicOp::iff:
      case sema::LogicOp::logical_xor:
        return same_truth(v, suits);
    }
    return Truth3::open;
  }
  // Two sides that are to be equal, or to differ: either way round.
  [[nodiscard]] Truth3 same_truth(const sema::Logic& v, bool suits) const {
    const auto can_be = [&](std::size_t k, bool value) {
      const Truth3 t = truth(*v.operands[k], value);
      return value ? t : negated(t);
    };
    const bool same = (v.op == sema::LogicOp::iff) == suits;
    const Truth3 one = both(can_be(0, true), can_be(1, same));
    const Truth3 other = both(can_be(0, false), can_be(1, !same));
    const Truth3 can = negated(both(negated(one), negated(other)));
    return suits ? can : negated(can);
  }
  static Truth3 both(Truth3 a, Truth3 b) {
    if (a == Truth3::no || b == Truth3::no) return Truth3::no;
    return a == Truth3::yes && b == Truth3::yes ? Truth3::yes : Truth3::open;
  }
  // It is so now, or else it has not been so for a while; at first it is not.
  [[nodiscard]] Truth3 held(const sema::Expr& e, bool suits) const {
    const Truth3 now = truth(e, suits);
    if (stays_) return now;
    if (!suits) return Truth3::no;
    return now == Truth3::no ? now : Truth3::open;
  }
  // All of what has been so, or some of it, now included or not; at first there is nothing of it.
  [[nodiscard]] Truth3 past(const sema::Expr& e, bool suits, bool with_now, bool all) const {
    const Truth3 now = truth(e, suits);
    if (stays_) return now;
    const Truth3 end = all ? Truth3::yes : Truth3::no;  // what nothing is, too
    if (ever(e, suits, now) == end) return end;
    return with_now && now == negated(end) ? now : Truth3::open;
  }
  // φ since ψ: ψ now will do if the window begins now, and else φ has to be so now. Of what stays,
  // ψ has been so wherever the window begins.
  [[nodiscard]] Truth3 since(Truth3 left, Truth3 right, Truth3 ever_right, bool with_now) const {
    if (stays_) return with_now ? right : both(left, right);
    if (with_now && right == Truth3::yes) return right;
    if (ever_right == Truth3::no) return ever_right;
    const bool not_now = !with_now || right == Truth3::no;
    return not_now && left == Truth3::no ? left : Truth3::open;
  }
  [[nodiscard]] Truth3 ever(const sema::Expr& e, bool suits, Truth3 now) const {
    return &box_ == &ever_ ? now
                           : Reader(spec_, variables_, ever_, ever_, false, rest_).truth(e, suits);
  }

  static Truth3 ordered(const Span& a, const Span& b, bool strictly) {
    if (strictly ? a.hi < b.lo : a.hi <= b.lo) return Truth3::yes;
    return (strictly ? a.lo >= b.hi : a.lo > b.hi) ? Truth3::no : Truth3::open;
  }
  [[nodiscard]] Number of(const Name& name) const {
    const auto at = box_.find(name);
    return at == box_.end() ? Number() : at->second;
  }
  [[nodiscard]] Number of(const sema::InputRef& v) const {
    return of({Name::Of::input, static_cast<std::uint32_t>(v.input), v.component});
  }

  [[nodiscard]] Number number(const sema::Expr& e) const {
    const auto [at, is_new] = numbers_.try_emplace(&e);
    if (is_new) at->second = std::visit([&](const auto& node) { return value(node); }, e.node);
    return at->second;
  }
  static Number value(const sema::Constant& v) { return Span{v.value, v.value}; }
  [[nodiscard]] Number value(const sema::InputRef& v) const { return of(v); }
  [[nodiscard]] Number value(const sema::AgeOf& v) const { return of(age_of(v.input)); }
  [[nodiscard]] Number value(const sema::SensedAge& v) const { return of(age_of(v.signal)); }
  [[nodiscard]] Number value(const sema::ParamRef& v) const { return of(param_of(v.param)); }
  [[nodiscard]] Number value(const sema::Arithmetic& v) const { return arithmetic(v); }
  [[nodiscard]] Number value(const sema::Math& v) const { return math(v); }
  [[nodiscard]] Number value(const sema::Aggregate& v) const {
    if (!is_of_its_values(v.op)) return std::nullopt;
    const Reader before(spec_, variables_, ever_, ever_, false, rest_);
    return stays_ ? number(*v.operand) : before.number(*v.operand);
  }
  [[nodiscard]] Number value(const sema::Choice& v) const {
    const Number a = number(*v.then_value), b = number(*v.else_value);
    const Truth3 when = truth(*v.condition, true);
    if (when != truth(*v.condition, false) || !a || !b) return std::nullopt;
    if (when != Truth3::open) return when == Truth3::yes ? a : b;
    return hull({a->lo, a->hi, b->lo, b->hi});
  }
  [[nodiscard]] Number value(const sema::SignalRef& v) const {
    if (rest_ == nullptr || v.subject != sema::Subject::self) return std::nullopt;
    if (v.signal == sema::Signal::speed) return Span{0, rest_->speed};
    return v.signal == sema::Signal::battery && charge_ ? Number(Span{*charge_, *charge_})
                                                        : std::nullopt;
  }
  [[nodiscard]] Number value(const sema::EnergyTo&) const {
    return charge_ ? Number(Span{0, 0}) : std::nullopt;
  }
  template <class Node>
  static Number value(const Node&) {
    // Every quantity is named above but these, of places and of what robots sense; the others are
    // conditions.
    static_assert(
        is_one_of<Node, sema::Clearance, sema::Distance, sema::CountOthers, sema::OverMembers,
                  sema::PointClearance, sema::WhileOpen, sema::TrailClearance, sema::TrailDistance,
                  sema::ZoneDistance, sema::AgentDistance> ||
        is_one_of<Node, sema::Truth, sema::InsideZone, sema::PlanInside, sema::Compare, sema::Logic,
                  sema::HeldFor, sema::ForOthers, sema::PointInside, sema::ZoneOpen,
                  sema::TrailInside, sema::PathGiven, sema::IsValue, sema::SameValue,
                  sema::Previously, sema::Past, sema::Since, sema::WithinOf>);
    return std::nullopt;
  }
  [[nodiscard]] Number arithmetic(const sema::Arithmetic& v) const {
    const Number a = number(*v.operands[0]);
    if (!a) return std::nullopt;
    if (v.op == sema::ArithmeticOp::negate) return Span{Rational(-a->hi), Rational(-a->lo)};
    Span all = *a;
    for (std::size_t k = 1; k < v.operands.size(); ++k) {
      const Number b = number(*v.operands[k]);
      if (!b) return std::nullopt;
      switch (v.op) {
        case sema::ArithmeticOp::add:
          all = {Rational(all.lo + b->lo), Rational(all.hi + b->hi)};
          break;
        case sema::ArithmeticOp::subtract:
          all = {Rational(all.lo - b->hi), Rational(all.hi - b->lo)};
          break;
        case sema::ArithmeticOp::multiply:
          all = hull({Rational(all.lo * b->lo), Rational(all.lo * b->hi), Rational(all.hi * b->lo),
                      Rational(all.hi * b->hi)});
          break;
        default:
          if (sgn(b->lo) <= 0 && sgn(b->hi) >= 0) return std::nullopt;
          all = hull({Rational(all.lo / b->lo), Rational(all.lo / b->hi), Rational(all.hi / b->lo),
                      Rational(all.hi / b->hi)});
      }
    }
    return all;
  }
  [[nodiscard]] Number math(const sema::Math& v) const {
    const Number first = number(*v.operands[0]);
    if (!first) return std::nullopt;
    Span all = *first;
    if (v.op == sema::MathOp::absolute) {
      const Span ends = hull({Rational(abs(all.lo)), Rational(abs(all.hi))});
      return sgn(all.lo) < 0 && sgn(all.hi) > 0 ? Span{0, ends.hi} : ends;
    }
    const bool least = v.op == sema::MathOp::minimum;
    if (!least && v.op != sema::MathOp::maximum) return std::nullopt;
    for (const auto& operand : v.operands) {
      const Number b = number(*operand);
      if (!b) return std::nullopt;
      all = least ? Span{std::min(all.lo, b->lo), std::min(all.hi, b->hi)}
                  : Span{std::max(all.lo, b->lo), std::max(all.hi, b->hi)};
    }
    return all;
  }

  const sema::Spec& spec_;
  const Variables& variables_;
  const Spans& box_;
  const Spans& ever_;
  bool stays_;
  const SeenAtRest* rest_;
  std::optional<Rational> charge_{};  // that is tried
  // What has been found: a condition may be asked about several times by each one around it.
  mutable std::map<std::pair<const sema::Expr*, bool>, Truth3> truths_{};
  mutable std::map<const sema::Expr*, Number> numbers_{};
};

}  // namespace rtac::analysis::reading
