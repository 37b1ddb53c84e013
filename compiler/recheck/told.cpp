#include "compiler/recheck/told.h"

#include <algorithm>
#include <variant>
#include <vector>

#include "compiler/recheck/claims.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

struct Bounds {
  Rational lo, hi;
};
using Known = std::optional<Bounds>;

class Reader {
 public:
  // `anyhow`: what no input decides may be anything, and else is as it suits, but for `may_be`.
  Reader(const sema::Spec& spec, const ToldInputs& inputs, bool with_errors, bool anyhow = false,
         MayBe may_be = {})
      : spec_(spec),
        inputs_(inputs),
        with_errors_(with_errors),
        anyhow_(anyhow),
        may_be_(std::move(may_be)) {}

  // Whether it can be so in spite of what suits.
  [[nodiscard]] bool can_be(const sema::Expr& e, bool value, bool suits) const {
    if (const auto* v = std::get_if<sema::Truth>(&e.node)) return v->value == value;
    if (const auto* v = std::get_if<sema::Logic>(&e.node)) return logic(*v, value, suits);
    if (const auto* v = std::get_if<sema::Compare>(&e.node)) return compare(*v, e, value);
    if (const auto* v = std::get_if<sema::HeldFor>(&e.node)) {
      // at first it is not
      return anyhow_ || (suits && can_be(*v->operand, value, suits));
    }
    if (const auto* v = std::get_if<sema::Previously>(&e.node)) {
      return can_be(*v->operand, value, suits);
    }
    if (const auto* v = std::get_if<sema::Past>(&e.node)) return can_be(*v->operand, value, suits);
    if (const auto* v = std::get_if<sema::InputRef>(&e.node)) {
      const Known at = measured(v->input, v->component);
      return at ? (sgn(at->lo) != 0) == value : otherwise(e, value);
    }
    if (const auto* v = std::get_if<sema::IsValue>(&e.node)) {
      const Known at = measured(v->input, v->component);
      return at ? (at->lo == static_cast<unsigned long>(v->value)) == value : otherwise(e, value);
    }
    if (const auto* v = std::get_if<sema::SameValue>(&e.node)) {
      const Known a = measured(v->left.input, v->left.component);
      const Known b = measured(v->right.input, v->right.component);
      return a && b ? (a->lo == b->lo) == value : otherwise(e, value);
    }
    return otherwise(e, value);
  }

 private:
  [[nodiscard]] bool logic(const sema::Logic& v, bool value, bool suits) const {
    const auto any = [&](bool wanted) {
      return std::ranges::any_of(
          v.operands, [&](const auto& operand) { return can_be(*operand, wanted, suits); });
    };
    const auto all = [&](bool wanted) {
      return std::ranges::all_of(
          v.operands, [&](const auto& operand) { return can_be(*operand, wanted, suits); });
    };
    switch (v.op) {
      case sema::LogicOp::logical_not:
        return can_be(*v.operands[0], !value, !suits);
      case sema::LogicOp::logical_and:
        return value ? all(true) : any(false);
      case sema::LogicOp::logical_or:
        return value ? any(true) : all(false);
      case sema::LogicOp::implies: {
        const bool unless = can_be(*v.operands[0], !value, !suits);
        const bool then = can_be(*v.operands[1], value, suits);
        return value ? unless || then : unless && then;
      }
      case sema::LogicOp::iff:
      case sema::LogicOp::logical_xor: {
        const bool same = (v.op == sema::LogicOp::iff) == value;
        const auto both = [&](bool left, bool right) {
          return can_be(*v.operands[0], left, true) && can_be(*v.operands[1], right, true);
        };
        return both(true, same) || both(false, !same);
      }
    }
    return true;
  }
  [[nodiscard]] bool otherwise(const sema::Expr& e, bool value) const {
    return anyhow_ || (may_be_ && may_be_(e, value));
  }
  [[nodiscard]] bool compare(const sema::Compare& v, const sema::Expr& e, bool value) const {
    const Known a = number(*v.left), b = number(*v.right);
    // what inputs decide, and nobody has read, suits nobody
    if ((!a || !b) && !sema::speaks_of_robot(e) && !told_in(spec_, e).empty()) return true;
    if (!a || !b) return otherwise(e, value);
    const auto is_age = [](const sema::Expr& side) {
      return std::holds_alternative<sema::AgeOf>(side.node);
    };
    const bool of_age = is_age(*v.left) || is_age(*v.right);
    // how old it is, within what is declared, is as it suits
    if (of_age && is_between(v.op, *a, *b, !value) && is_between(v.op, *a, *b, value)) {
      return anyhow_;
    }
    return is_between(v.op, *a, *b, value);
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
    if (const auto* v = std::get_if<sema::Constant>(&e.node)) return Bounds{v->value, v->value};
    if (const auto* v = std::get_if<sema::InputRef>(&e.node)) {
      return measured(v->input, v->component);
    }
    if (const auto* v = std::get_if<sema::AgeOf>(&e.node)) {
      const auto& most = spec_[v->input].max_age;
      return most ? Known(Bounds{0, most->value}) : std::nullopt;
    }
    if (const auto* v = std::get_if<sema::ParamRef>(&e.node)) {
      const sema::Param& param = spec_[v->param];
      return Bounds{param.least.value, param.most.value};
    }
    if (const auto* v = std::get_if<sema::Aggregate>(&e.node)) {
      // it stays as it is
      const bool of_values = v->op == sema::AggregateOp::minimum ||
                             v->op == sema::AggregateOp::maximum ||
                             v->op == sema::AggregateOp::mean;
      return of_values ? number(*v->operand) : std::nullopt;
    }
    if (const auto* v = std::get_if<sema::Choice>(&e.node)) return choice(*v);
    std::vector<Bounds> of;
    const auto* const sum = std::get_if<sema::Arithmetic>(&e.node);
    const auto* const math = std::get_if<sema::Math>(&e.node);
    if (sum == nullptr && math == nullptr) return std::nullopt;
    for (const auto& operand : sum != nullptr ? sum->operands : math->operands) {
      const Known each = number(*operand);
      if (!each) return std::nullopt;
      of.push_back(*each);
    }
    return sum != nullptr ? arithmetic(*sum, of) : extreme(math->op, of);
  }
  [[nodiscard]] Known choice(const sema::Choice& v) const {
    const Known yes = number(*v.then_value), no = number(*v.else_value);
    if (!yes || !no || sema::speaks_of_robot(*v.condition)) return std::nullopt;
    const bool may_be = can_be(*v.condition, true, true),
               need_not = can_be(*v.condition, false, true);
    if (may_be != need_not) return may_be ? yes : no;
    return Bounds{std::min(yes->lo, no->lo), std::max(yes->hi, no->hi)};
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
};

bool can_measure(const sema::Spec& spec, const sema::Input& input, std::uint32_t component,
                 const Rational& value) {
  if (component >= input.components.size()) return false;
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

}  // namespace

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
  std::set<ToldInput> all;
  const auto add = [&](sema::InputId id, std::uint32_t component) {
    const sema::Input& input = spec[id];
    const bool is_place =
        input.type == sema::InputType::zone || input.type == sema::InputType::path;
    if (!input.robot && !input.agent && !is_place) all.insert({id, component});
  };
  if (const auto* v = std::get_if<sema::InputRef>(&e.node)) add(v->input, v->component);
  if (const auto* v = std::get_if<sema::IsValue>(&e.node)) add(v->input, v->component);
  if (const auto* v = std::get_if<sema::SameValue>(&e.node)) {
    add(v->left.input, v->left.component);
    add(v->right.input, v->right.component);
  }
  sema::for_each_operand(e, [&](const auto& operand) { all.merge(told_in(spec, *operand)); });
  return all;
}

std::set<sema::InputId> spoken_of(const sema::Spec& spec, const sema::Expr& e) {
  std::set<sema::InputId> all;
  for (const ToldInput& each : told_in(spec, e)) all.insert(each.first);
  sema::for_each_expr(e, [&](const sema::Expr& part) {
    const auto* v = std::get_if<sema::AgeOf>(&part.node);
    if (v != nullptr && !spec[v->input].robot && !spec[v->input].agent) all.insert(v->input);
  });
  return all;
}

bool told_makes(const sema::Spec& spec, const sema::Expr& property, const ToldInputs& inputs,
                bool value) {
  const auto all = told_in(spec, property);
  return std::ranges::all_of(all, [&](const ToldInput& each) { return inputs.contains(each); }) &&
         !Reader(spec, inputs, value).can_be(property, !value, value);
}

bool told_makes_true_but(const sema::Spec& spec, const sema::Expr& property,
                         const ToldInputs& inputs, const MayBe& may_be) {
  return !Reader(spec, inputs, true, false, may_be).can_be(property, false, true);
}

std::vector<const sema::Expr*> torn_parts(const sema::Spec& spec, const sema::Expr& wanted,
                                          const std::vector<const sema::Expr*>& all,
                                          const std::function<bool(const sema::Expr&)>& always) {
  const auto times = [&](sema::InputId input) {
    int count = 0;
    for (const sema::Expr* each : all) {
      sema::for_each_expr(*each, [&](const sema::Expr& part) {
        bool whole = false;
        sema::for_each_operand(part, [&](const auto&) { whole = true; });
        count += !whole && spoken_of(spec, part).contains(input) ? 1 : 0;
      });
    }
    return count;
  };
  // of a `not`, too: it may turn an `and` within it into an `or`
  const auto may_choose = [&](const sema::Expr& e) {
    bool found = false;
    sema::for_each_expr(e, [&](const sema::Expr& part) {
      const auto* const logic = std::get_if<sema::Logic>(&part.node);
      found = found || (logic != nullptr && logic->op != sema::LogicOp::logical_and &&
                        sema::speaks_of_robot(part) && !spoken_of(spec, part).empty());
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
    } else if (may_choose(e) &&
               std::ranges::any_of(spoken_of(spec, e), [&](auto x) { return times(x) > 1; })) {
      torn.push_back(&e);
    }
  }
  return torn;
}

bool told_alone_makes(const sema::Spec& spec, const sema::Expr& property,
                      const ToldInputs& inputs) {
  return !inputs.empty() && !Reader(spec, inputs, true, true).can_be(property, false, false);
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
  if (!told_makes(spec_, *m->always, *inputs, value == "true")) {
    return wrong("with those inputs the property need not be " + value);
  }
  return std::nullopt;
}

bool asks_at_once(const sema::Spec& spec, const sema::Decision& d, const std::string& only) {
  for (const sema::MonitorId id : d.priority) {
    const sema::Monitor& m = spec[id];
    if (!only.empty() && m.name != only) continue;
    if (m.return_when && !spoken_of(spec, *m.return_when).empty()) return true;
  }
  std::set<sema::InputId> known;
  for (const sema::Expr* each : said_by(spec, d, only)) {
    for (const sema::InputId id : spoken_of(spec, *each)) {
      if (!known.insert(id).second) return true;
    }
  }
  return false;
}
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

std::optional<Doubt> Claims::at_once(const Values& v) {
  const sema::Decision* const d = decision(v);
  const auto inputs = told_inputs(spec_, text(v, "inputs"));
  if (d == nullptr || !inputs) return wrong("the inputs cannot be measured so");
  for (const sema::Expr* each : said_by(spec_, *d, text(v, "monitor"))) {
    if (told_makes(spec_, *each, *inputs, true)) continue;
    return wrong("with those inputs not all that is asked for need be true");
  }
  for (const std::string& name : names_in(text(v, "alone"))) {
    const sema::Monitor* const m = monitor_of(spec_, *d, name);
    const bool is = m != nullptr && !m->return_when && told_alone_makes(spec_, *m->always, *inputs);
    if (is) continue;
    return wrong("with those inputs alone the property of `" + name + "` need not be true");
  }
  return std::nullopt;
}

}  // namespace rtac::recheck
