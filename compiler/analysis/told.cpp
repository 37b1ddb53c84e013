#include "compiler/analysis/told.h"

#include <algorithm>
#include <map>
#include <type_traits>
#include <utility>
#include <variant>

#include "compiler/sema/visit.h"

namespace rtac::analysis {
namespace {

constexpr int boxes_most = 4'000;  // of one with n inputs the (n + 1)th part
// Beyond what an input without a range may be, in SI units.
const Rational endless = 1'000'000'000;
const Rational age_step(1, 1'000'000);  // s: stamps are whole microseconds

enum class Truth3 { no, open, yes };
Truth3 negated(Truth3 t) {
  return t == Truth3::open ? t : t == Truth3::yes ? Truth3::no : Truth3::yes;
}
Truth3 from(bool yes) {
  return yes ? Truth3::yes : Truth3::no;
}

struct Span {
  Rational lo, hi;
};
using Number = std::optional<Span>;  // none: nobody knows

Span hull(std::initializer_list<Rational> ends) {
  return {*std::ranges::min_element(ends), *std::ranges::max_element(ends)};
}

// Of what stays as it is.
bool is_of_its_values(sema::AggregateOp op) {
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
Name age_of(sema::InputId id) {
  return {Name::Of::age, static_cast<std::uint32_t>(id), 0};
}
Name age_of(sema::Sensed signal) {
  return {Name::Of::sensed, static_cast<std::uint32_t>(signal), 0};
}
Name param_of(sema::ParamId id) {
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
using Box = std::map<Name, Span>;

template <class Node, class... Of>
constexpr bool is_one_of = (std::is_same_v<Node, Of> || ...);

bool is_sensed(const sema::Input& input) {
  return input.robot || input.agent;
}
// Whether a part of it is what robots sense, of themselves or of agents.
bool speaks_of_sensed(const sema::Spec& spec, const sema::Expr& e) {
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
std::optional<sema::Sensed> sensed_for(const sema::Expr& e) {
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
  // anything in `ever`.
  Reader(const sema::Spec& spec, const Variables& variables, const Box& box, const Box& ever,
         bool stays)
      : spec_(spec), variables_(variables), box_(box), ever_(ever), stays_(stays) {}

  // `suits`: what anything is that robots sense. Of what nobody knows it is open.
  [[nodiscard]] Truth3 truth(const sema::Expr& e, bool suits) const {
    return std::visit([&](const auto& node) { return says(node, e, suits); }, e.node);
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
    if (!a || !b) return unknown(e, suits);
    if (is_old(*v.left) || is_old(*v.right)) return from(!suits);
    const bool strictly = v.op == sema::CompareOp::less || v.op == sema::CompareOp::greater;
    const bool is_least = v.op == sema::CompareOp::less || v.op == sema::CompareOp::less_equal;
    return is_least ? ordered(*a, *b, strictly) : ordered(*b, *a, strictly);
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
    return &box_ == &ever_ ? now : Reader(spec_, variables_, ever_, ever_, false).truth(e, suits);
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
    return std::visit([&](const auto& node) { return value(node); }, e.node);
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
    const Reader before(spec_, variables_, ever_, ever_, false);
    return stays_ ? number(*v.operand) : before.number(*v.operand);
  }
  [[nodiscard]] Number value(const sema::Choice& v) const {
    const Number a = number(*v.then_value), b = number(*v.else_value);
    const Truth3 when = truth(*v.condition, true);
    if (when != truth(*v.condition, false) || !a || !b) return std::nullopt;
    if (when != Truth3::open) return when == Truth3::yes ? a : b;
    return hull({a->lo, a->hi, b->lo, b->hi});
  }
  template <class Node>
  static Number value(const Node&) {
    // Every quantity is named above but these, of places and of what robots sense; the others are
    // conditions.
    static_assert(
        is_one_of<Node, sema::SignalRef, sema::Clearance, sema::Distance, sema::EnergyTo,
                  sema::CountOthers, sema::OverMembers, sema::PointClearance, sema::WhileOpen,
                  sema::TrailClearance, sema::TrailDistance, sema::ZoneDistance,
                  sema::AgentDistance> ||
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
  const Box& box_;
  const Box& ever_;
  bool stays_;
};

struct Said {
  const sema::Expr* property;
  bool suits;             // what anything is that robots sense
  bool whatever = false;  // however old that is
};

// The kind of robot of whose monitor it is a part.
const sema::RobotKind* kind_of(const sema::Spec& spec, const sema::Expr& e) {
  for (const sema::Monitor& m : spec.monitors) {
    bool found = false;
    const auto look = [&](const sema::Expr& part) { found = found || &part == &e; };
    sema::for_each_expr(*m.always, look);
    if (m.return_when) sema::for_each_expr(*m.return_when, look);
    if (found) return &spec[m.kind];
  }
  return nullptr;
}

class Search {
 public:
  Search(const sema::Spec& spec, std::vector<Said> all, bool value, ToldHow how)
      : spec_(spec), all_(std::move(all)), value_(value), how_(how) {
    for (const Said& each : all_) collect(*each.property);
  }

  Told run() {
    if (variables_.empty()) {
      const Box none;
      const bool is = truth(none, none, true) == from(value_);
      return {is ? CanBeTold::yes : CanBeTold::open, {}};
    }
    for (const auto& [name, variable] : variables_) {
      ever_[name] = {Rational(variable.span.lo - variable.error),
                     Rational(variable.span.hi + variable.error)};
    }
    // what can be for ever is found sooner among what stays; that nothing can be, is not
    const Told lasting = search(true);
    return lasting.can == CanBeTold::yes || !looks_back_ ? lasting : search(false);
  }

 private:
  Told search(bool stays) const {
    Box all;
    for (const auto& [name, variable] : variables_) all[name] = variable.span;
    std::vector<Box> left{std::move(all)};
    bool open = false;
    const int most = boxes_most / (1 + static_cast<int>(variables_.size()));
    for (int looked = 0; !left.empty(); ++looked) {
      if (looked >= most) return {CanBeTold::open, {}};
      const Box box = std::move(left.back());
      left.pop_back();
      if (is_out(box, stays)) continue;
      for (const Rational& share : {Rational(1, 2), Rational(0), Rational(1)}) {
        const Box point = point_of(box, share);
        if (is_found(point)) return {CanBeTold::yes, inputs_of(point)};
      }
      if (!split(box, left)) open = true;
    }
    return {open ? CanBeTold::open : CanBeTold::no, {}};
  }

  void collect(const sema::Expr& e) {
    if (const auto* v = std::get_if<sema::InputRef>(&e.node)) add(v->input, v->component);
    if (const auto* v = std::get_if<sema::IsValue>(&e.node)) add(v->input, v->component);
    if (const auto* v = std::get_if<sema::SameValue>(&e.node)) {
      add(v->left.input, v->left.component);
      add(v->right.input, v->right.component);
    }
    looks_back_ = looks_back_ || std::holds_alternative<sema::HeldFor>(e.node) ||
                  std::holds_alternative<sema::Previously>(e.node) ||
                  std::holds_alternative<sema::Past>(e.node) ||
                  std::holds_alternative<sema::Since>(e.node) ||
                  std::holds_alternative<sema::WithinOf>(e.node) ||
                  std::holds_alternative<sema::Aggregate>(e.node);
    if (const auto* v = std::get_if<sema::AgeOf>(&e.node); v && !is_sensed(spec_[v->input])) {
      const auto& most = spec_[v->input].max_age;
      add_age(age_of(v->input), most ? std::optional(most->value) : std::nullopt);
    }
    if (const auto* v = std::get_if<sema::SensedAge>(&e.node)) add_age(e, v->signal);
    if (const auto* v = std::get_if<sema::ParamRef>(&e.node)) {
      const sema::Param& p = spec_[v->param];
      variables_[param_of(v->param)] = {
          {p.least.value, p.most.value}, 0, p.resolution, false, std::nullopt};
    }
    sema::for_each_operand(e, [&](const auto& operand) { collect(*operand); });
  }
  // Of the newest sample, also of one that is too old to count.
  void add_age(const Name& name, const std::optional<Rational>& counts) {
    variables_[name] = {{0, endless}, 0, age_step, true, counts};
  }
  void add_age(const sema::Expr& e, sema::Sensed signal) {
    const sema::RobotKind* const kind = kind_of(spec_, e);
    if (kind == nullptr) return;
    const auto& sense = signal == sema::Sensed::position   ? kind->position
                        : signal == sema::Sensed::velocity ? kind->velocity
                                                           : kind->battery;
    if (sense) add_age(age_of(signal), sense->max_age.value);
  }
  void add(sema::InputId id, std::uint32_t component) {
    const sema::Input& input = spec_[id];
    if (is_sensed(input)) return;  // as it suits
    const Name name{Name::Of::input, static_cast<std::uint32_t>(id), component};
    if (input.type == sema::InputType::boolean) {
      variables_[name] = {{0, 1}, 0, 1, true, std::nullopt};
    } else if (input.type == sema::InputType::enumeration) {
      const auto values = spec_[*input.enumeration].values.size();
      const Rational last = Rational(static_cast<unsigned long>(values)) - 1;
      variables_[name] = {{0, last}, 0, 1, true, std::nullopt};
    } else if (input.type == sema::InputType::integer || input.type == sema::InputType::real) {
      const sema::Measurement& m = input.measurement(component);
      const bool whole = input.type == sema::InputType::integer;
      variables_[name] = {
          {m.least ? m.least->value : Rational(-endless), m.most ? m.most->value : endless},
          m.error ? m.error->value : Rational(0),
          whole ? Rational(1) : m.resolution,
          whole,
          std::nullopt};
    }
  }

  // Wherever in the box the property is not as it is asked to be. What is seen has to hold with
  // every error, so with the largest ones, too.
  [[nodiscard]] bool is_out(const Box& box, bool stays) const {
    const Truth3 other = from(!value_);
    const auto reads = [&](const Box& of) { return truth(of, stays ? of : ever_, stays); };
    if (reads(box) == other) return true;
    if (how_ == ToldHow::exactly) return false;
    for (const auto& [name, variable] : variables_) {
      if (sgn(variable.error) == 0) continue;
      for (const Rational& by : {variable.error, Rational(-variable.error)}) {
        Box moved = box;
        Span& span = moved[name];
        span = {Rational(span.lo + by), Rational(span.hi + by)};
        if (reads(moved) == other) return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool is_found(const Box& point) const {
    Box seen = point;
    for (auto& [name, span] : seen) {
      const Variable& variable = variables_.at(name);
      const bool is_param = name.of == Name::Of::param;
      if (is_param) span = variable.span;
      if (!is_new_enough(name, span.lo)) return false;
      if (how_ == ToldHow::exactly || is_param) continue;
      // the kernel rounds what it computes to the grid
      const Rational by = variable.is_whole ? variable.error : variable.error + variable.step;
      span = {Rational(span.lo - by), Rational(span.hi + by)};
    }
    return truth(seen, seen, true) == from(value_);
  }
  // No older than is declared; what has to come every tick counts for sure when it is new.
  [[nodiscard]] bool is_new_enough(const Name& name, const Rational& age) const {
    if (name.of != Name::Of::age && name.of != Name::Of::sensed) return true;
    const auto& counts = variables_.at(name).counts;
    if (counts) return age <= *counts;
    const bool is_read = std::ranges::any_of(variables_, [&](const auto& each) {
      return each.first.of == Name::Of::input && each.first.index == name.index;
    });
    return spec_[sema::InputId(name.index)].held || !is_read || sgn(age) == 0;
  }
  // Of several, that each of them is as it is asked to be.
  [[nodiscard]] Truth3 truth(const Box& box, const Box& ever, bool stays) const {
    Truth3 found = from(value_);
    for (const Said& each : all_) {
      const Box told = each.whatever ? without_sensed(box) : Box();
      const Reader reader(spec_, variables_, each.whatever ? told : box, ever, stays);
      const Truth3 is = reader.truth(*each.property, each.suits);
      if (is == from(!value_)) return is;
      if (is == Truth3::open) found = is;
    }
    return found;
  }
  // Whose ages nobody knows then.
  static Box without_sensed(Box box) {
    std::erase_if(box, [](const auto& each) { return each.first.of == Name::Of::sensed; });
    return box;
  }
  // On the grid, where it has one.
  [[nodiscard]] Box point_of(const Box& box, const Rational& share) const {
    Box point;
    for (const auto& [name, span] : box) {
      const Rational at =
          on_grid(variables_.at(name), Rational(span.lo + share * (span.hi - span.lo)));
      point[name] = {std::clamp(at, span.lo, span.hi), std::clamp(at, span.lo, span.hi)};
    }
    return point;
  }
  static Rational on_grid(const Variable& variable, const Rational& value) {
    if (sgn(variable.step) == 0) return value;
    const Rational steps = value / variable.step;  // of a fine grid more than fit 64 bits
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), steps.get_num_mpz_t(), steps.get_den_mpz_t());
    return Rational(whole) * variable.step;
  }
  // Of an age first where it ceases to count, and then beside what counts.
  static Rational length_beside(const Variable& variable, const Span& span) {
    const auto& counts = variable.counts;
    if (!counts || span.lo > *counts) return variable.span.hi - variable.span.lo;
    return span.hi > *counts ? Rational((span.hi - span.lo) / 2) : *counts;
  }
  // In two, across the side that is longest beside what it may be. false: it is one point.
  bool split(const Box& box, std::vector<Box>& to) const {
    const Name* longest = nullptr;
    Rational most = 0;
    for (const auto& [name, span] : box) {
      const Variable& variable = variables_.at(name);
      if (span.hi - span.lo < variable.step || span.hi == span.lo) continue;
      const Rational share = (span.hi - span.lo) / length_beside(variable, span);
      if (share > most) {
        most = share;
        longest = &name;
      }
    }
    if (longest == nullptr) return false;
    const Variable& variable = variables_.at(*longest);
    const Span& span = box.at(*longest);
    const bool ceases =
        variable.counts && span.lo <= *variable.counts && span.hi > *variable.counts;
    Rational middle =
        on_grid(variable, ceases ? *variable.counts : Rational((span.lo + span.hi) / 2));
    if (middle < span.lo) middle = span.lo;
    Rational next = middle + variable.step;  // nothing lies between two steps
    if (next > span.hi) next = span.hi;
    Box low = box, high = box;
    low[*longest].hi = middle;
    high[*longest].lo = next;
    to.push_back(std::move(high));
    to.push_back(std::move(low));
    return true;
  }
  [[nodiscard]] std::vector<ToldInput> inputs_of(const Box& point) const {
    std::vector<ToldInput> all;
    for (const auto& [name, span] : point) {
      const sema::InputId id{name.index};
      if (name.of == Name::Of::input) all.push_back({id, name.component, span.lo});
      if (name.of == Name::Of::age) all.push_back({id, age_component(spec_[id]), span.lo});
    }
    return all;
  }

  const sema::Spec& spec_;
  const std::vector<Said> all_;
  bool value_;
  ToldHow how_;
  Box ever_;  // whatever is measured
  bool looks_back_ = false;
  Variables variables_;
};

}  // namespace

Told told_to_be(const sema::Spec& spec, const sema::Expr& property, bool value, ToldHow how) {
  return Search(spec, {{&property, value, false}}, value, how).run();
}
Told told_at_once(const sema::Spec& spec, const std::vector<const sema::Expr*>& all,
                  const std::vector<const sema::Expr*>& whatever_is_sensed) {
  std::vector<Said> asked;
  for (const sema::Expr* each : all) asked.push_back({each, true, false});
  for (const sema::Expr* each : whatever_is_sensed) asked.push_back({each, false, true});
  return Search(spec, std::move(asked), true, ToldHow::seen).run();
}
std::set<sema::InputId> inputs_in(const sema::Spec& spec, const sema::Expr& e) {
  std::set<sema::InputId> all;
  const auto add = [&](sema::InputId id) {
    if (!spec[id].robot && !spec[id].agent) all.insert(id);
  };
  sema::for_each_expr(e, [&](const sema::Expr& part) {
    if (const auto* v = std::get_if<sema::InputRef>(&part.node)) add(v->input);
    if (const auto* v = std::get_if<sema::IsValue>(&part.node)) add(v->input);
    if (const auto* v = std::get_if<sema::AgeOf>(&part.node)) add(v->input);
    if (const auto* v = std::get_if<sema::SameValue>(&part.node)) {
      add(v->left.input);
      add(v->right.input);
    }
  });
  return all;
}

std::string told_text(const sema::Spec& spec, const std::vector<ToldInput>& inputs) {
  std::string all;
  for (const ToldInput& told : inputs) {
    const sema::Input& input = spec[told.input];
    if (!all.empty()) all += ", ";
    if (told.component == age_component(input)) {
      all += "age(" + input.name + ") = " + to_decimal(told.value) + " s";
      continue;
    }
    const std::string& component = input.components[told.component];
    const std::string name = input.name + (component.empty() ? "" : "." + component);
    if (input.type == sema::InputType::boolean) {
      all += (sgn(told.value) == 0 ? "not " : "") + name;
    } else if (input.type == sema::InputType::enumeration) {
      all += name + " == " +
             spec[*input.enumeration].values[static_cast<std::size_t>(floor_to_int(told.value))];
    } else {
      all += name + " = " + to_decimal(told.value);
    }
  }
  return all;
}

namespace {

// Of what is said besides robots: inputs, and how old is what a robot senses.
std::set<Name> spoken_of(const sema::Spec& spec, const sema::Expr& e) {
  std::set<Name> all;
  for (const sema::InputId id : inputs_in(spec, e)) all.insert(age_of(id));
  sema::for_each_expr(e, [&](const sema::Expr& part) {
    if (const auto* v = std::get_if<sema::SensedAge>(&part.node)) all.insert(age_of(v->signal));
  });
  return all;
}
bool is_said_once(const sema::Spec& spec, const std::vector<const sema::Expr*>& all,
                  const Name& name) {
  int times = 0;
  for (const sema::Expr* each : all) {
    sema::for_each_expr(*each, [&](const sema::Expr& part) {
      bool has_operands = false;
      sema::for_each_operand(part, [&](const auto&) { has_operands = true; });
      if (!has_operands && spoken_of(spec, part).contains(name)) ++times;
    });
  }
  return times <= 1;
}

// A choice between what inputs say and what robots sense; of an `and` that is denied, one side is
// not so if another one is not.
bool is_choice(const sema::Spec& spec, const sema::Expr& e) {
  const auto* const logic = std::get_if<sema::Logic>(&e.node);
  return logic != nullptr && logic->op != sema::LogicOp::logical_and && sema::speaks_of_robot(e) &&
         !spoken_of(spec, e).empty();
}
// What has to be true for `e` to be, where all of its operands have to be.
bool asks_for_all(const sema::Expr& e) {
  if (const auto* const v = std::get_if<sema::Logic>(&e.node)) {
    return v->op == sema::LogicOp::logical_and;
  }
  if (const auto* const v = std::get_if<sema::ForOthers>(&e.node)) return v->universal;
  return std::holds_alternative<sema::HeldFor>(e.node) ||
         std::holds_alternative<sema::Previously>(e.node) ||
         std::holds_alternative<sema::Past>(e.node);
}

}  // namespace

std::vector<const sema::Expr*> torn_parts(const sema::Spec& spec, const sema::Expr& e,
                                          const std::vector<const sema::Expr*>& all,
                                          const std::function<bool(const sema::Expr&)>& always) {
  const auto* const logic = std::get_if<sema::Logic>(&e.node);
  const auto is_always = [&](const sema::ExprPtr& side) { return always(*side); };
  if (logic != nullptr && logic->op == sema::LogicOp::logical_or &&
      std::ranges::any_of(logic->operands, is_always)) {
    return {};
  }
  std::vector<const sema::Expr*> torn;
  if (asks_for_all(e)) {
    sema::for_each_operand(e, [&](const sema::ExprPtr& side) {
      const auto more = torn_parts(spec, *side, all, always);
      torn.insert(torn.end(), more.begin(), more.end());
    });
    return torn;
  }
  bool chooses = false;
  sema::for_each_expr(e,
                      [&](const sema::Expr& part) { chooses = chooses || is_choice(spec, part); });
  const bool is_torn = chooses && std::ranges::any_of(spoken_of(spec, e), [&](const Name& name) {
                         return !is_said_once(spec, all, name);
                       });
  if (is_torn) torn.push_back(&e);
  return torn;
}

bool share_inputs(const sema::Spec& spec, const std::vector<const sema::Expr*>& all) {
  std::set<sema::InputId> known;
  for (const sema::Expr* each : all) {
    const bool ages = sema::speaks_of<sema::SensedAge>(*each);
    if (ages || told_to_be(spec, *each, true, ToldHow::seen).can != CanBeTold::yes) return true;
    for (const sema::InputId id : inputs_in(spec, *each)) {
      if (!known.insert(id).second) return true;
    }
  }
  return false;
}

}  // namespace rtac::analysis
