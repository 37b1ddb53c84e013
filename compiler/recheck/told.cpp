#include "compiler/recheck/told.h"

#include <algorithm>
#include <type_traits>
#include <variant>
#include <vector>

#include "compiler/recheck/claims.h"
#include "compiler/recheck/numbers.h"
#include "compiler/recheck/return_when.h"
#include "compiler/recheck/sides.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

struct Bounds {
  Rational lo, hi;
};
using Known = std::optional<Bounds>;

template <class Node, class... Of>
constexpr bool is_one_of = (std::is_same_v<Node, Of> || ...);

// How old is what the robot senses, in s.
using SensedAges = std::map<sema::Sensed, Rational>;

std::uint32_t age_component(const sema::Input& input) {
  return static_cast<std::uint32_t>(input.components.size());
}
bool is_sensed(const sema::Input& input) {
  return input.robot || input.agent;
}
// Whether robots have a say in it, or what is seen of agents.
bool senses(const sema::Spec& spec, const sema::Expr& e) {
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

class Reader {
 public:
  // `anyhow`: what robots sense may be anything, and else is as it suits, but for `may_be`.
  // `rest`: of a robot that rests; else it does as suits.
  Reader(const sema::Spec& spec, const ToldInputs& inputs, bool with_errors, bool anyhow = false,
         MayBe may_be = {}, SensedAges ages = {}, std::optional<SeenAtRest> rest = {})
      : spec_(spec),
        inputs_(inputs),
        with_errors_(with_errors),
        anyhow_(anyhow),
        may_be_(std::move(may_be)),
        ages_(std::move(ages)),
        rest_(std::move(rest)) {}

  // Whether it can be so in spite of what suits, while inputs stay.
  [[nodiscard]] bool can_be(const sema::Expr& e, bool value) const {
    const auto [at, is_new] = found_.try_emplace({&e, value}, false);
    if (is_new) {
      at->second = std::visit([&](const auto& node) { return can(node, e, value); }, e.node);
    }
    return at->second;
  }

 private:
  static bool can(const sema::Truth& v, const sema::Expr&, bool value) { return v.value == value; }
  [[nodiscard]] bool can(const sema::Logic& v, const sema::Expr&, bool value) const {
    return logic(v, value);
  }
  [[nodiscard]] bool can(const sema::Compare& v, const sema::Expr& e, bool value) const {
    const Known a = number(*v.left), b = number(*v.right);
    if (a && b) return is_between(v.op, *a, *b, value);
    // a side of which robots say nothing is for inputs to say
    const bool unread = (!a && !senses(spec_, *v.left)) || (!b && !senses(spec_, *v.right));
    if (unread) return true;
    return rest_ && !charge_ ? charged(v, e, value) : unknown(e, value);
  }
  // Neither an empty battery nor one that is seen to be full suits.
  [[nodiscard]] bool charged(const sema::Compare& v, const sema::Expr& e, bool value) const {
    for (const Rational& charge : {Rational(0), rest_->charge}) {
      Reader at(spec_, inputs_, with_errors_, anyhow_, may_be_, ages_, rest_);
      at.charge_ = charge;
      const Known a = at.number(*v.left), b = at.number(*v.right);
      if (!a || !b || !is_between(v.op, *a, *b, value)) return unknown(e, value);
    }
    return true;
  }
  [[nodiscard]] bool can(const sema::HeldFor& v, const sema::Expr&, bool value) const {
    return can_be(*v.operand, value);
  }
  [[nodiscard]] bool can(const sema::Previously& v, const sema::Expr&, bool value) const {
    return can_be(*v.operand, value);
  }
  [[nodiscard]] bool can(const sema::Past& v, const sema::Expr&, bool value) const {
    return can_be(*v.operand, value);
  }
  // Where the window begins now, what it is since is enough.
  [[nodiscard]] bool can(const sema::Since& v, const sema::Expr&, bool value) const {
    const bool right = can_be(*v.right, value);
    if (sgn(v.interval.from.value) == 0) return right;
    const bool left = can_be(*v.left, value);
    return value ? left && right : left || right;
  }
  // It is, or nothing has asked for it.
  [[nodiscard]] bool can(const sema::WithinOf& v, const sema::Expr&, bool value) const {
    const bool is = can_be(*v.operand, value), asked = can_be(*v.trigger, !value);
    return value ? is || asked : is && asked;
  }
  [[nodiscard]] bool can(const sema::InputRef& v, const sema::Expr& e, bool value) const {
    const Known at = measured(v.input, v.component);
    return at ? (sgn(at->lo) != 0) == value : unknown(e, value);
  }
  [[nodiscard]] bool can(const sema::IsValue& v, const sema::Expr& e, bool value) const {
    const Known at = measured(v.input, v.component);
    return at ? (at->lo == static_cast<unsigned long>(v.value)) == value : unknown(e, value);
  }
  [[nodiscard]] bool can(const sema::SameValue& v, const sema::Expr& e, bool value) const {
    const Known a = measured(v.left.input, v.left.component);
    const Known b = measured(v.right.input, v.right.component);
    return a && b ? (a->lo == b->lo) == value : unknown(e, value);
  }
  // Of other robots what suits is for them, and what inputs say is not.
  [[nodiscard]] bool can(const sema::ForOthers& v, const sema::Expr& e, bool value) const {
    return otherwise(e, value) || can_be(*v.body, value);
  }
  [[nodiscard]] bool can(const sema::InsideZone&, const sema::Expr& e, bool value) const {
    return otherwise(e, value);
  }
  [[nodiscard]] bool can(const sema::PlanInside&, const sema::Expr& e, bool value) const {
    return otherwise(e, value);
  }
  [[nodiscard]] bool can(const sema::ZoneOpen&, const sema::Expr& e, bool value) const {
    return otherwise(e, value);  // at some time
  }
  template <class Node>
  [[nodiscard]] bool can(const Node&, const sema::Expr& e, bool value) const {
    // The conditions that are left are of places and paths; the others are no conditions.
    static_assert(
        is_one_of<Node, sema::PointInside, sema::TrailInside, sema::PathGiven> ||
        is_one_of<Node, sema::Constant, sema::SignalRef, sema::Clearance, sema::Distance,
                  sema::EnergyTo, sema::Arithmetic, sema::CountOthers, sema::OverMembers,
                  sema::AgeOf, sema::SensedAge, sema::ParamRef, sema::PointClearance,
                  sema::WhileOpen, sema::TrailClearance, sema::TrailDistance, sema::ZoneDistance,
                  sema::Math, sema::Choice, sema::Aggregate, sema::AgentDistance>);
    return unknown(e, value);
  }
  // What nobody has read suits nobody, nor of how many robots inputs may say something.
  [[nodiscard]] bool unknown(const sema::Expr& e, bool value) const {
    bool counts_told = false;
    sema::for_each_expr(e, [&](const sema::Expr& part) {
      const auto* const count = std::get_if<sema::CountOthers>(&part.node);
      counts_told =
          counts_told || (count != nullptr && (!spoken_of(spec_, *count->body).empty() ||
                                               sema::speaks_of<sema::SensedAge>(*count->body)));
    });
    return counts_told || !senses(spec_, e) || otherwise(e, value);
  }
  [[nodiscard]] bool otherwise(const sema::Expr& e, bool value) const {
    return anyhow_ || (may_be_ && may_be_(e, value));
  }
  [[nodiscard]] bool logic(const sema::Logic& v, bool value) const {
    const auto any = [&](bool wanted) {
      return std::ranges::any_of(v.operands,
                                 [&](const auto& operand) { return can_be(*operand, wanted); });
    };
    const auto all = [&](bool wanted) {
      return std::ranges::all_of(v.operands,
                                 [&](const auto& operand) { return can_be(*operand, wanted); });
    };
    switch (v.op) {
      case sema::LogicOp::logical_not:
        return can_be(*v.operands[0], !value);
      case sema::LogicOp::logical_and:
        return value ? all(true) : any(false);
      case sema::LogicOp::logical_or:
        return value ? any(true) : all(false);
      case sema::LogicOp::implies: {
        const bool unless = can_be(*v.operands[0], !value);
        const bool then = can_be(*v.operands[1], value);
        return value ? unless || then : unless && then;
      }
      case sema::LogicOp::iff:
      case sema::LogicOp::logical_xor: {
        const bool same = (v.op == sema::LogicOp::iff) == value;
        const auto both = [&](bool left, bool right) {
          return can_be(*v.operands[0], left) && can_be(*v.operands[1], right);
        };
        return both(true, same) || both(false, !same);
      }
    }
    return true;
  }
  static bool is_between(sema::CompareOp op, const Bounds& a, const Bounds& b, bool value) {
    switch (op) {
      case sema::CompareOp::less:
        return value ? a.lo < b.hi : a.hi >= b.lo;
      case sema::CompareOp::less_equal:
        return value ? a.lo <= b.hi : a.hi > b.lo;
      case sema::CompareOp::greater:
        return value ? a.hi > b.lo : a.lo <= b.hi;
      case sema::CompareOp::greater_equal:
        return value ? a.hi >= b.lo : a.lo < b.hi;
    }
    return true;
  }
  // Within its error, and a step of its grid, which is what is rounded.
  [[nodiscard]] Known measured(sema::InputId id, std::uint32_t component) const {
    const auto at = inputs_.find({id, component});
    if (at == inputs_.end()) return std::nullopt;
    const sema::Input& input = spec_[id];
    // what has to come every tick counts for sure when it is new
    const auto age = inputs_.find({id, age_component(input)});
    if (!input.max_age && !input.held && age != inputs_.end() && sgn(age->second) > 0) {
      return std::nullopt;
    }
    const bool is_number =
        input.type == sema::InputType::real || input.type == sema::InputType::integer;
    Rational by = 0;
    if (with_errors_ && is_number) {
      const sema::Measurement& m = input.measurement(component);
      if (m.error) by += m.error->value;
      if (input.type == sema::InputType::real) by += m.resolution;
    }
    return Bounds{Rational(at->second - by), Rational(at->second + by)};
  }
  [[nodiscard]] Known number(const sema::Expr& e) const {
    const auto [at, is_new] = numbers_.try_emplace(&e);
    if (is_new) at->second = std::visit([&](const auto& node) { return known(node); }, e.node);
    return at->second;
  }
  static Known known(const sema::Constant& v) { return Bounds{v.value, v.value}; }
  [[nodiscard]] Known known(const sema::InputRef& v) const {
    return measured(v.input, v.component);
  }
  [[nodiscard]] Known known(const sema::AgeOf& v) const {
    const auto at = inputs_.find({v.input, age_component(spec_[v.input])});
    return at == inputs_.end() ? Known() : Bounds{at->second, at->second};
  }
  [[nodiscard]] Known known(const sema::SensedAge& v) const {
    const auto at = ages_.find(v.signal);
    return at == ages_.end() ? Known() : Bounds{at->second, at->second};
  }
  [[nodiscard]] Known known(const sema::ParamRef& v) const {
    const sema::Param& param = spec_[v.param];
    return Bounds{param.least.value, param.most.value};
  }
  // It stays as it is.
  [[nodiscard]] Known known(const sema::Aggregate& v) const {
    const bool of_values = v.op == sema::AggregateOp::minimum ||
                           v.op == sema::AggregateOp::maximum || v.op == sema::AggregateOp::mean;
    return of_values ? number(*v.operand) : std::nullopt;
  }
  [[nodiscard]] Known known(const sema::Choice& v) const {
    const Known yes = number(*v.then_value), no = number(*v.else_value);
    if (!yes || !no || senses(spec_, *v.condition)) return std::nullopt;
    const bool may_be = can_be(*v.condition, true), need_not = can_be(*v.condition, false);
    if (may_be != need_not) return may_be ? yes : no;
    return Bounds{std::min(yes->lo, no->lo), std::max(yes->hi, no->hi)};
  }
  [[nodiscard]] Known known(const sema::Arithmetic& v) const {
    const auto of = numbers(v.operands);
    return of ? arithmetic(v, *of) : std::nullopt;
  }
  [[nodiscard]] Known known(const sema::Math& v) const {
    const auto of = numbers(v.operands);
    return of ? extreme(v.op, *of) : std::nullopt;
  }
  [[nodiscard]] Known known(const sema::SignalRef& v) const {
    const bool own = rest_ && v.subject == sema::Subject::self;
    if (own && v.signal == sema::Signal::speed) return Bounds{0, rest_->speed};
    if (!own || v.signal != sema::Signal::battery || !charge_) return std::nullopt;
    return Bounds{*charge_, *charge_};
  }
  // No way takes less than nothing.
  [[nodiscard]] Known known(const sema::EnergyTo&) const {
    return charge_ ? Known(Bounds{0, 0}) : std::nullopt;
  }
  template <class Node>
  static Known known(const Node&) {
    // The quantities that are left are of places and robots; the others are conditions.
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
  [[nodiscard]] std::optional<std::vector<Bounds>> numbers(
      const std::vector<sema::ExprPtr>& operands) const {
    std::vector<Bounds> all;
    for (const auto& operand : operands) {
      const Known each = number(*operand);
      if (!each) return std::nullopt;
      all.push_back(*each);
    }
    return all;
  }
  static Known arithmetic(const sema::Arithmetic& v, const std::vector<Bounds>& of) {
    Bounds all = of.front();
    if (v.op == sema::ArithmeticOp::negate) return Bounds{Rational(-all.hi), Rational(-all.lo)};
    for (std::size_t k = 1; k < of.size(); ++k) {
      const Bounds& b = of[k];
      if (v.op == sema::ArithmeticOp::add) {
        all = {Rational(all.lo + b.lo), Rational(all.hi + b.hi)};
        continue;
      }
      if (v.op == sema::ArithmeticOp::subtract) {
        all = {Rational(all.lo - b.hi), Rational(all.hi - b.lo)};
        continue;
      }
      const bool divides = v.op == sema::ArithmeticOp::divide;
      if (divides && sgn(b.lo) <= 0 && sgn(b.hi) >= 0) return std::nullopt;
      std::vector<Rational> ends;
      for (const Rational& x : {all.lo, all.hi}) {
        for (const Rational& y : {b.lo, b.hi}) {
          ends.emplace_back(divides ? Rational(x / y) : Rational(x * y));
        }
      }
      all = {std::ranges::min(ends), std::ranges::max(ends)};
    }
    return all;
  }
  static Known extreme(sema::MathOp op, const std::vector<Bounds>& of) {
    Bounds all = of.front();
    if (op == sema::MathOp::absolute) {
      const Rational a = abs(all.lo), b = abs(all.hi);
      const bool spans = sgn(all.lo) < 0 && sgn(all.hi) > 0;
      return Bounds{spans ? Rational(0) : std::min(a, b), std::max(a, b)};
    }
    if (op != sema::MathOp::minimum && op != sema::MathOp::maximum) return std::nullopt;
    for (const Bounds& each : of) {
      const bool least = op == sema::MathOp::minimum;
      all.lo = least ? std::min(all.lo, each.lo) : std::max(all.lo, each.lo);
      all.hi = least ? std::min(all.hi, each.hi) : std::max(all.hi, each.hi);
    }
    return all;
  }

  const sema::Spec& spec_;
  const ToldInputs& inputs_;
  bool with_errors_, anyhow_;
  MayBe may_be_;
  SensedAges ages_;
  std::optional<SeenAtRest> rest_;
  std::optional<Rational> charge_{};  // that is tried
  // What has been found of conditions and of numbers, which others may ask for several times.
  mutable std::map<std::pair<const sema::Expr*, bool>, bool> found_{};
  mutable std::map<const sema::Expr*, Known> numbers_{};
};

struct ToHold {
  const sema::Expr* property;
  std::optional<SeenAtRest> at_rest{};
};

bool can_measure(const sema::Spec& spec, const sema::Input& input, std::uint32_t component,
                 const Rational& value) {
  if (component == age_component(input)) {
    return sgn(value) >= 0 && (!input.max_age || value <= input.max_age->value);
  }
  if (component > input.components.size()) return false;
  if (input.type == sema::InputType::boolean) return value == 0 || value == 1;
  if (input.type == sema::InputType::enumeration) {
    return value.get_den() == 1 && sgn(value) >= 0 &&
           value < static_cast<unsigned long>(spec[*input.enumeration].values.size());
  }
  if (input.type != sema::InputType::integer && input.type != sema::InputType::real) return false;
  const sema::Measurement& m = input.measurement(component);
  const Rational step = input.type == sema::InputType::integer ? Rational(1) : m.resolution;
  return (!m.least || value >= m.least->value) && (!m.most || value <= m.most->value) &&
         Rational(value / step).get_den() == 1;
}

const sema::RobotKind* kind_of(const sema::Spec& spec, const sema::Expr& said) {
  for (const sema::Monitor& m : spec.monitors) {
    if (m.always.get() == &said || m.return_when.get() == &said) return &spec[m.kind];
  }
  return nullptr;
}
// How old a signal may be to make a difference: what its age is compared with, what lies between
// two such, and some of all that it may be.
std::vector<Rational> ages_to_try(const std::vector<const sema::Expr*>& said, sema::Sensed signal,
                                  const Rational& most) {
  std::set<Rational> all;
  for (int k = 0; k <= 8; ++k) all.insert(Rational(most * k / 8));
  for (const sema::Expr* each : said) {
    sema::for_each_expr(*each, [&](const sema::Expr& part) {
      if (!std::holds_alternative<sema::Compare>(part.node)) return;
      bool is_of_it = false;
      sema::for_each_expr(part, [&](const sema::Expr& of) {
        const auto* const v = std::get_if<sema::SensedAge>(&of.node);
        is_of_it = is_of_it || (v != nullptr && v->signal == signal);
      });
      if (!is_of_it) return;
      sema::for_each_expr(part, [&](const sema::Expr& of) {
        const auto* const v = std::get_if<sema::Constant>(&of.node);
        if (v != nullptr && sgn(v->value) >= 0 && v->value <= most) all.insert(v->value);
      });
    });
  }
  std::vector<Rational> ages;
  for (const Rational& each : all) {
    if (!ages.empty()) ages.emplace_back((ages.back() + each) / 2);
    ages.push_back(each);
  }
  return ages;
}
// All that is said of one kind of robot, with one age of each signal that it speaks of.
template <class Visit>
bool is_at_some_ages(const sema::Spec& spec, const std::vector<const sema::Expr*>& said,
                     const Visit& visit) {
  std::set<sema::Sensed> left;
  const sema::RobotKind* kind = nullptr;
  for (const sema::Expr* each : said) {
    sema::for_each_expr(*each, [&](const sema::Expr& part) {
      const auto* const v = std::get_if<sema::SensedAge>(&part.node);
      if (v != nullptr) left.insert(v->signal);
    });
    if (kind == nullptr) kind = kind_of(spec, *each);
  }
  std::vector<SensedAges> all{{}};
  for (const sema::Sensed signal : left) {
    if (kind == nullptr) break;
    const auto& sense = signal == sema::Sensed::position   ? kind->position
                        : signal == sema::Sensed::velocity ? kind->velocity
                                                           : kind->battery;
    if (!sense) continue;
    std::vector<SensedAges> more;
    for (const Rational& age : ages_to_try(said, signal, sense->max_age.value)) {
      for (SensedAges with : all) {
        with[signal] = age;
        more.push_back(std::move(with));
      }
    }
    all = std::move(more);
  }
  return std::ranges::any_of(all, visit);
}

std::set<ToldInput> inputs_told(const sema::Spec& spec, const sema::Expr& e) {
  std::set<ToldInput> all;
  const auto add = [&](sema::InputId id, std::uint32_t component) {
    const sema::Input& input = spec[id];
    const bool is_place =
        input.type == sema::InputType::zone || input.type == sema::InputType::path;
    if (!is_sensed(input) && !is_place) all.insert({id, component});
  };
  if (const auto* v = std::get_if<sema::InputRef>(&e.node)) add(v->input, v->component);
  if (const auto* v = std::get_if<sema::IsValue>(&e.node)) add(v->input, v->component);
  if (const auto* v = std::get_if<sema::SameValue>(&e.node)) {
    add(v->left.input, v->left.component);
    add(v->right.input, v->right.component);
  }
  if (const auto* v = std::get_if<sema::AgeOf>(&e.node)) {
    add(v->input, age_component(spec[v->input]));
  }
  sema::for_each_operand(e, [&](const auto& operand) { all.merge(inputs_told(spec, *operand)); });
  return all;
}
// All of these at once.
bool told_make(const sema::Spec& spec, const std::vector<ToHold>& all, const ToldInputs& inputs,
               bool value) {
  std::vector<const sema::Expr*> said;
  for (const ToHold& each : all) said.push_back(each.property);
  for (const sema::Expr* each : said) {
    for (const ToldInput& told : inputs_told(spec, *each)) {
      if (!inputs.contains(told)) return false;
    }
  }
  return is_at_some_ages(spec, said, [&](const SensedAges& ages) {
    return std::ranges::none_of(all, [&](const ToHold& each) {
      const Reader reader(spec, inputs, value, false, {}, ages, each.at_rest);
      return reader.can_be(*each.property, !value);
    });
  });
}

}  // namespace

bool is_told(const sema::Spec& spec, const sema::Expr& e) {
  return !spoken_of(spec, e).empty() || sema::speaks_of<sema::SensedAge>(e) ||
         sema::speaks_of<sema::ParamRef>(e);
}

std::optional<ToldInputs> told_inputs(const sema::Spec& spec, const std::string& text) {
  ToldInputs all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(';', at), text.size());
    const std::string each = text.substr(at, end - at);
    at = end + 1;
    const std::size_t is = each.find('='), dot = each.rfind('.', is);
    if (is == std::string::npos || dot == std::string::npos) return std::nullopt;
    const auto input = std::ranges::find(spec.inputs, each.substr(0, dot), &sema::Input::name);
    const std::string number = each.substr(dot + 1, is - dot - 1);
    Rational value;
    if (input == spec.inputs.end() || number.empty() || number.size() > 4 ||
        number.find_first_not_of("0123456789") != std::string::npos ||
        value.set_str(each.substr(is + 1), 10) != 0 || sgn(value.get_den()) == 0) {
      return std::nullopt;
    }
    value.canonicalize();
    const auto component = static_cast<std::uint32_t>(std::stoul(number));
    if (!can_measure(spec, *input, component, value)) return std::nullopt;
    all[{sema::InputId(input - spec.inputs.begin()), component}] = value;
  }
  return all;
}

std::set<ToldInput> told_in(const sema::Spec& spec, const sema::Expr& e) {
  return inputs_told(spec, e);
}

std::set<sema::InputId> spoken_of(const sema::Spec& spec, const sema::Expr& e) {
  std::set<sema::InputId> all;
  for (const ToldInput& each : inputs_told(spec, e)) all.insert(each.first);
  sema::for_each_expr(e, [&](const sema::Expr& part) {
    const auto* v = std::get_if<sema::AgeOf>(&part.node);
    if (v != nullptr && !spec[v->input].robot && !spec[v->input].agent) all.insert(v->input);
  });
  return all;
}

bool told_makes(const sema::Spec& spec, const sema::Expr& property, const ToldInputs& inputs,
                bool value, const std::optional<SeenAtRest>& at_rest) {
  return told_make(spec, {{&property, at_rest}}, inputs, value);
}

bool told_makes_true_but(const sema::Spec& spec, const sema::Expr& property,
                         const ToldInputs& inputs, const MayBe& may_be) {
  return is_at_some_ages(spec, {&property}, [&](const SensedAges& ages) {
    return !Reader(spec, inputs, true, false, may_be, ages).can_be(property, false);
  });
}

std::vector<const sema::Expr*> torn_parts(const sema::Spec& spec, const sema::Expr& wanted,
                                          const std::function<bool(const sema::Expr&)>& always) {
  // of a `not`, too: it may turn an `and` within it into an `or`
  const auto may_choose = [&](const sema::Expr& e) {
    bool found = false;
    sema::for_each_expr(e, [&](const sema::Expr& part) {
      const auto* const logic = std::get_if<sema::Logic>(&part.node);
      found = found || (logic != nullptr && logic->op != sema::LogicOp::logical_and &&
                        sema::speaks_of_robot(part) && is_told(spec, part));
    });
    return found;
  };
  std::vector<const sema::Expr*> torn, left{&wanted};
  while (!left.empty()) {
    const sema::Expr& e = *left.back();
    left.pop_back();
    const auto* const logic = std::get_if<sema::Logic>(&e.node);
    const auto* const others = std::get_if<sema::ForOthers>(&e.node);
    const bool either = logic != nullptr && logic->op == sema::LogicOp::logical_or;
    if (either && std::ranges::any_of(logic->operands, [&](const auto& x) { return always(*x); })) {
      continue;
    }
    const bool both = (logic != nullptr && logic->op == sema::LogicOp::logical_and) ||
                      (others != nullptr && others->universal) ||
                      std::holds_alternative<sema::HeldFor>(e.node) ||
                      std::holds_alternative<sema::Previously>(e.node) ||
                      std::holds_alternative<sema::Past>(e.node);
    if (both) {
      sema::for_each_operand(e, [&](const sema::ExprPtr& x) { left.push_back(x.get()); });
    } else if (may_choose(e)) {
      torn.push_back(&e);
    }
  }
  return torn;
}

bool told_alone_makes(const sema::Spec& spec, const sema::Expr& property,
                      const ToldInputs& inputs) {
  return !Reader(spec, inputs, true, true).can_be(property, false);
}

std::optional<SeenAtRest> shown_at_rest(const sema::Spec& spec, const sema::Decision& d) {
  if (d.on_plan) return std::nullopt;
  const Numbers numbers = numbers_of(spec, d, jitter_of(spec, d));
  return SeenAtRest{seen_at_rest(numbers), shown_full(spec[d.kind])};
}

std::optional<Doubt> Claims::told(const Values& v) {
  const sema::Decision* const d = decision(v);
  const sema::Monitor* const m = d ? monitor_of(spec_, *d, text(v, "monitor")) : nullptr;
  if (m == nullptr) return wrong("no such monitor");
  const auto inputs = told_inputs(spec_, text(v, "inputs"));
  const std::string value = text(v, "value");
  if (!inputs || (value != "true" && value != "false")) {
    return wrong("the inputs cannot be measured so");
  }
  const auto rest = value == "true" ? shown_at_rest(spec_, *d) : std::nullopt;
  if (!told_makes(spec_, *m->always, *inputs, value == "true", rest)) {
    return wrong("with those inputs the property need not be " + value);
  }
  return std::nullopt;
}

namespace {

// What the monitors of a decision say, and ask for to return; or `only` one of them.
std::vector<const sema::Expr*> said_by(const sema::Spec& spec, const sema::Decision& d,
                                       const std::string& only) {
  std::vector<const sema::Expr*> all;
  for (const sema::MonitorId id : d.priority) {
    const sema::Monitor& m = spec[id];
    if (!only.empty() && m.name != only) continue;
    all.push_back(m.always.get());
    if (m.return_when) all.push_back(m.return_when.get());
  }
  return all;
}

}  // namespace

bool asks_at_once(const sema::Spec& spec, const sema::Decision& d, const std::string& only) {
  for (const sema::MonitorId id : d.priority) {
    const sema::Monitor& m = spec[id];
    if (!only.empty() && m.name != only) continue;
    if (m.return_when && is_told(spec, *m.return_when)) return true;
    const bool of_rest = sema::speaks_of_speed(*m.always) || sema::speaks_of_charge(*m.always);
    if (of_rest && is_told(spec, *m.always)) return true;
  }
  std::set<sema::InputId> known;
  for (const sema::Expr* each : said_by(spec, d, only)) {
    if (sema::speaks_of<sema::SensedAge>(*each)) return true;
    for (const sema::InputId id : spoken_of(spec, *each)) {
      if (!known.insert(id).second) return true;
    }
  }
  return false;
}
std::optional<Doubt> Claims::at_once(const Values& v) {
  const sema::Decision* const d = decision(v);
  const auto inputs = told_inputs(spec_, text(v, "inputs"));
  if (d == nullptr || !inputs) return wrong("the inputs cannot be measured so");
  const std::set<std::string> alone = names_in(text(v, "alone"));
  const std::string only = text(v, "monitor");
  const Numbers numbers = numbers_of(spec_, *d, jitter_of(spec_, *d));
  const Rational full = shown_full(spec_[d->kind]), extra = return_extra(spec_, *d);
  std::vector<ToHold> said;
  for (const sema::MonitorId id : d->priority) {
    const sema::Monitor& m = spec_[id];
    if (!only.empty() && m.name != only) continue;
    std::optional<SeenAtRest> ahead;
    if (!d->on_plan && !m.ahead.waypoints_only && !alone.contains(m.name)) {
      ahead = {Sides(spec_, *d, *this).from_rest(m, extra), full};
    }
    said.push_back({m.always.get(), ahead});
    if (!m.return_when) continue;
    said.push_back({m.return_when.get(), SeenAtRest{shown_at_rest(spec_, numbers, m), full}});
  }
  if (!told_make(spec_, said, *inputs, true)) {
    return wrong("with those inputs not all that is asked for need be true");
  }
  for (const std::string& name : alone) {
    const sema::Monitor* const m = monitor_of(spec_, *d, name);
    const bool is = m != nullptr && !m->return_when && told_alone_makes(spec_, *m->always, *inputs);
    if (is) continue;
    return wrong("with those inputs alone the property of `" + name + "` need not be true");
  }
  return std::nullopt;
}

}  // namespace rtac::recheck
