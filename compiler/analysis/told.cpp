#include "compiler/analysis/told.h"

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

#include "compiler/sema/visit.h"

namespace rtac::analysis {
namespace {

constexpr int boxes_most = 4'000;  // of one with n inputs the (n + 1)th part
// Beyond what an input without a range may be, in SI units.
const Rational endless = 1'000'000'000;

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

// What is told: a component of an input, or a parameter.
struct Name {
  bool is_param = false;
  std::uint32_t index = 0, component = 0;
  auto operator<=>(const Name&) const = default;
};
struct Variable {
  Span span;
  Rational error, step;  // of what is measured; 0: any value
  bool is_whole = false;
};
using Variables = std::map<Name, Variable>;
using Box = std::map<Name, Span>;

// A property in a box.
class Reader {
 public:
  // `stays`: inputs are what they are for ever, so that the past is as now; else they have been
  // anything in `ever`.
  Reader(const sema::Spec& spec, const Box& box, const Box& ever, bool stays)
      : spec_(spec), box_(box), ever_(ever), stays_(stays) {}

  // `suits`: what anything is that inputs do not decide.
  [[nodiscard]] Truth3 truth(const sema::Expr& e, bool suits) const {
    if (const auto* v = std::get_if<sema::Truth>(&e.node)) return from(v->value);
    if (const auto* v = std::get_if<sema::Logic>(&e.node)) return logic(*v, suits);
    if (const auto* v = std::get_if<sema::Compare>(&e.node)) return compare(*v, suits);
    if (const auto* v = std::get_if<sema::InputRef>(&e.node)) return told(*v, suits);
    if (const auto* v = std::get_if<sema::IsValue>(&e.node)) return is_value(*v, suits);
    if (const auto* v = std::get_if<sema::SameValue>(&e.node)) return same(*v, suits);
    if (const auto* v = std::get_if<sema::HeldFor>(&e.node)) return held(*v->operand, suits);
    if (const auto* v = std::get_if<sema::Previously>(&e.node)) {
      return past(*v->operand, suits, false, false);
    }
    if (const auto* v = std::get_if<sema::Past>(&e.node)) {
      return past(*v->operand, suits, sgn(v->interval.from.value) == 0,
                  v->op == sema::PastOp::historically);
    }
    return from(suits);
  }

 private:
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
  [[nodiscard]] Truth3 same_truth(const sema::Logic& v, bool suits) const {
    Truth3 sides[2];
    for (int k = 0; k < 2; ++k) {
      const sema::Expr& side = *v.operands[static_cast<std::size_t>(k)];
      sides[k] = truth(side, true);
      if (sides[k] != truth(side, false)) return from(suits);
    }
    if (sides[0] == Truth3::open || sides[1] == Truth3::open) return Truth3::open;
    return from((sides[0] == sides[1]) == (v.op == sema::LogicOp::iff));
  }
  // It is so now, or else it has not been so for a while; at first it is not.
  [[nodiscard]] Truth3 held(const sema::Expr& e, bool suits) const {
    if (!suits) return Truth3::no;
    const Truth3 now = truth(e, suits);
    return stays_ || now == Truth3::no ? now : Truth3::open;
  }
  // All of what has been so, or some of it, now included or not; at first there is nothing of it.
  [[nodiscard]] Truth3 past(const sema::Expr& e, bool suits, bool with_now, bool all) const {
    const Truth3 now = truth(e, suits);
    if (stays_) return now;
    const Truth3 end = all ? Truth3::yes : Truth3::no;  // what nothing is, too
    if (Reader(spec_, ever_, ever_, false).truth(e, suits) == end) return end;
    return with_now && now == negated(end) ? now : Truth3::open;
  }

  [[nodiscard]] Truth3 compare(const sema::Compare& v, bool suits) const {
    const Number a = number(*v.left), b = number(*v.right);
    if (!a || !b) return from(suits);
    const bool strictly = v.op == sema::CompareOp::less || v.op == sema::CompareOp::greater;
    const bool is_least = v.op == sema::CompareOp::less || v.op == sema::CompareOp::less_equal;
    const Truth3 found = is_least ? ordered(*a, *b, strictly) : ordered(*b, *a, strictly);
    // how old it is, within what is declared, is as it suits
    return found == Truth3::open && (is_age(*v.left) || is_age(*v.right)) ? from(suits) : found;
  }
  static bool is_age(const sema::Expr& e) { return std::holds_alternative<sema::AgeOf>(e.node); }
  static Truth3 ordered(const Span& a, const Span& b, bool strictly) {
    if (strictly ? a.hi < b.lo : a.hi <= b.lo) return Truth3::yes;
    return (strictly ? a.lo >= b.hi : a.lo > b.hi) ? Truth3::no : Truth3::open;
  }
  [[nodiscard]] Number of(const sema::InputRef& v) const {
    const auto at = box_.find({false, static_cast<std::uint32_t>(v.input), v.component});
    return at == box_.end() ? Number() : at->second;
  }
  [[nodiscard]] Truth3 told(const sema::InputRef& v, bool suits) const {
    const Number n = of(v);
    if (!n) return from(suits);
    return n->lo == n->hi ? from(sgn(n->lo) != 0) : Truth3::open;
  }
  [[nodiscard]] Truth3 is_value(const sema::IsValue& v, bool suits) const {
    const Number n = of({v.input, v.component});
    if (!n) return from(suits);
    const Rational value = static_cast<unsigned long>(v.value);
    if (n->lo == n->hi) return from(n->lo == value);
    return value < n->lo || value > n->hi ? Truth3::no : Truth3::open;
  }
  [[nodiscard]] Truth3 same(const sema::SameValue& v, bool suits) const {
    const Number a = of(v.left), b = of(v.right);
    if (!a || !b) return from(suits);
    if (a->hi < b->lo || b->hi < a->lo) return Truth3::no;
    return a->lo == a->hi && b->lo == b->hi ? Truth3::yes : Truth3::open;
  }

  [[nodiscard]] Number number(const sema::Expr& e) const {
    if (const auto* v = std::get_if<sema::Constant>(&e.node)) return Span{v->value, v->value};
    if (const auto* v = std::get_if<sema::InputRef>(&e.node)) return of(*v);
    if (const auto* v = std::get_if<sema::AgeOf>(&e.node)) {
      const auto& most = spec_[v->input].max_age;
      return most ? Number(Span{0, most->value}) : std::nullopt;
    }
    if (const auto* v = std::get_if<sema::ParamRef>(&e.node)) {
      return box_.at({true, static_cast<std::uint32_t>(v->param), 0});
    }
    if (const auto* v = std::get_if<sema::Arithmetic>(&e.node)) return arithmetic(*v);
    if (const auto* v = std::get_if<sema::Math>(&e.node)) return math(*v);
    if (const auto* v = std::get_if<sema::Aggregate>(&e.node)) {
      return stays_ && is_of_its_values(v->op) ? number(*v->operand) : std::nullopt;
    }
    if (const auto* v = std::get_if<sema::Choice>(&e.node)) {
      const Number a = number(*v->then_value), b = number(*v->else_value);
      const Truth3 when = truth(*v->condition, true);
      if (when != truth(*v->condition, false) || !a || !b) return std::nullopt;
      if (when != Truth3::open) return when == Truth3::yes ? a : b;
      return hull({a->lo, a->hi, b->lo, b->hi});
    }
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
  const Box& box_;
  const Box& ever_;
  bool stays_;
};

struct Said {
  const sema::Expr* property;
  bool suits;  // what anything is that inputs do not decide
};

class Search {
 public:
  Search(const sema::Spec& spec, std::vector<Said> all, bool value, ToldHow how)
      : spec_(spec), all_(std::move(all)), value_(value), how_(how) {
    for (const Said& each : all_) collect(*each.property);
  }

  Told run() {
    if (variables_.empty()) {
      const Box none;
      const bool is = truth(Reader(spec_, none, none, true)) == from(value_);
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
                  std::holds_alternative<sema::Past>(e.node);
    if (const auto* v = std::get_if<sema::ParamRef>(&e.node)) {
      const sema::Param& p = spec_[v->param];
      variables_[{true, static_cast<std::uint32_t>(v->param), 0}] = {
          {p.least.value, p.most.value}, 0, p.resolution, false};
    }
    sema::for_each_operand(e, [&](const auto& operand) { collect(*operand); });
  }
  void add(sema::InputId id, std::uint32_t component) {
    const sema::Input& input = spec_[id];
    if (input.robot || input.agent) return;  // sensed: as it suits
    const Name name{false, static_cast<std::uint32_t>(id), component};
    if (input.type == sema::InputType::boolean) {
      variables_[name] = {{0, 1}, 0, 1, true};
    } else if (input.type == sema::InputType::enumeration) {
      const auto values = spec_[*input.enumeration].values.size();
      variables_[name] = {{0, Rational(static_cast<unsigned long>(values)) - 1}, 0, 1, true};
    } else if (input.type == sema::InputType::integer || input.type == sema::InputType::real) {
      const sema::Measurement& m = input.measurement(component);
      const bool whole = input.type == sema::InputType::integer;
      variables_[name] = {
          {m.least ? m.least->value : Rational(-endless), m.most ? m.most->value : endless},
          m.error ? m.error->value : Rational(0),
          whole ? Rational(1) : m.resolution,
          whole};
    }
  }

  // Wherever in the box the property is not as it is asked to be. What is seen has to hold with
  // every error, so with the largest ones, too.
  [[nodiscard]] bool is_out(const Box& box, bool stays) const {
    const Truth3 other = from(!value_);
    const auto reads = [&](const Box& of) {
      return truth(Reader(spec_, of, stays ? of : ever_, stays));
    };
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
      if (name.is_param) span = variable.span;
      if (how_ == ToldHow::exactly || name.is_param) continue;
      // the kernel rounds what it computes to the grid
      const Rational by = variable.is_whole ? variable.error : variable.error + variable.step;
      span = {Rational(span.lo - by), Rational(span.hi + by)};
    }
    return truth(Reader(spec_, seen, seen, true)) == from(value_);
  }
  // Of several, that each of them is as it is asked to be.
  [[nodiscard]] Truth3 truth(const Reader& reader) const {
    Truth3 found = from(value_);
    for (const Said& each : all_) {
      const Truth3 is = reader.truth(*each.property, each.suits);
      if (is == from(!value_)) return is;
      if (is == Truth3::open) found = is;
    }
    return found;
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
  // In two, across the side that is longest beside what it may be. false: it is one point.
  bool split(const Box& box, std::vector<Box>& to) const {
    const Name* longest = nullptr;
    Rational most = 0;
    for (const auto& [name, span] : box) {
      const Variable& variable = variables_.at(name);
      if (span.hi - span.lo < variable.step || span.hi == span.lo) continue;
      const Rational share = (span.hi - span.lo) / (variable.span.hi - variable.span.lo);
      if (share > most) {
        most = share;
        longest = &name;
      }
    }
    if (longest == nullptr) return false;
    const Variable& variable = variables_.at(*longest);
    const Span& span = box.at(*longest);
    Rational middle = on_grid(variable, Rational((span.lo + span.hi) / 2));
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
  [[nodiscard]] static std::vector<ToldInput> inputs_of(const Box& point) {
    std::vector<ToldInput> all;
    for (const auto& [name, span] : point) {
      if (!name.is_param) all.push_back({sema::InputId(name.index), name.component, span.lo});
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
  return Search(spec, {{&property, value}}, value, how).run();
}
Told told_at_once(const sema::Spec& spec, const std::vector<const sema::Expr*>& all,
                  const std::vector<const sema::Expr*>& whatever_is_sensed) {
  std::vector<Said> asked;
  for (const sema::Expr* each : all) asked.push_back({each, true});
  for (const sema::Expr* each : whatever_is_sensed) asked.push_back({each, false});
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
    const std::string& component = input.components[told.component];
    const std::string name = input.name + (component.empty() ? "" : "." + component);
    if (!all.empty()) all += ", ";
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

bool is_said_once(const sema::Spec& spec, const std::vector<const sema::Expr*>& all,
                  sema::InputId input) {
  int times = 0;
  for (const sema::Expr* each : all) {
    sema::for_each_expr(*each, [&](const sema::Expr& part) {
      bool has_operands = false;
      sema::for_each_operand(part, [&](const auto&) { has_operands = true; });
      if (!has_operands && inputs_in(spec, part).contains(input)) ++times;
    });
  }
  return times <= 1;
}

// A choice between what inputs say and what robots sense; of an `and` that is denied, one side is
// not so if another one is not.
bool is_choice(const sema::Spec& spec, const sema::Expr& e) {
  const auto* const logic = std::get_if<sema::Logic>(&e.node);
  return logic != nullptr && logic->op != sema::LogicOp::logical_and && sema::speaks_of_robot(e) &&
         !inputs_in(spec, e).empty();
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
  const auto inputs = inputs_in(spec, e);
  const bool is_torn = chooses && std::ranges::any_of(inputs, [&](sema::InputId input) {
                         return !is_said_once(spec, all, input);
                       });
  if (is_torn) torn.push_back(&e);
  return torn;
}

bool share_inputs(const sema::Spec& spec, const std::vector<const sema::Expr*>& all) {
  std::set<sema::InputId> known;
  for (const sema::Expr* each : all) {
    for (const sema::InputId id : inputs_in(spec, *each)) {
      if (!known.insert(id).second) return true;
    }
  }
  return false;
}

}  // namespace rtac::analysis
