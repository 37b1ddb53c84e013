#include "compiler/analysis/told.h"

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

#include "compiler/analysis/told_reader.h"
#include "compiler/sema/visit.h"

namespace rtac::analysis {
namespace {

using namespace reading;

constexpr int boxes_most = 4'000;  // of one with n inputs the (n + 1)th part

struct Said {
  const sema::Expr* property;
  bool suits;             // what anything is that robots sense
  bool whatever = false;  // however old that is
  std::optional<SeenAtRest> at_rest{};
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
      const Spans none;
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
    Spans all;
    for (const auto& [name, variable] : variables_) all[name] = variable.span;
    std::vector<Spans> left{std::move(all)};
    bool open = false;
    const int most = boxes_most / (1 + static_cast<int>(variables_.size()));
    for (int looked = 0; !left.empty(); ++looked) {
      if (looked >= most) return {CanBeTold::open, {}};
      const Spans box = std::move(left.back());
      left.pop_back();
      if (is_out(box, stays)) continue;
      for (const Rational& share : {Rational(1, 2), Rational(0), Rational(1)}) {
        const Spans point = point_of(box, share);
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
  [[nodiscard]] bool is_out(const Spans& box, bool stays) const {
    const Truth3 other = from(!value_);
    const auto reads = [&](const Spans& of) { return truth(of, stays ? of : ever_, stays); };
    if (reads(box) == other) return true;
    if (how_ == ToldHow::exactly) return false;
    for (const auto& [name, variable] : variables_) {
      if (sgn(variable.error) == 0) continue;
      for (const Rational& by : {variable.error, Rational(-variable.error)}) {
        Spans moved = box;
        Span& span = moved[name];
        span = {Rational(span.lo + by), Rational(span.hi + by)};
        if (reads(moved) == other) return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool is_found(const Spans& point) const {
    Spans seen = point;
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
  [[nodiscard]] Truth3 truth(const Spans& box, const Spans& ever, bool stays) const {
    Truth3 found = from(value_);
    for (const Said& each : all_) {
      const Spans told = each.whatever ? without_sensed(box) : Spans();
      const SeenAtRest* const rest = each.at_rest ? &*each.at_rest : nullptr;
      const Reader reader(spec_, variables_, each.whatever ? told : box, ever, stays, rest);
      const Truth3 is = reader.truth(*each.property, each.suits);
      if (is == from(!value_)) return is;
      if (is == Truth3::open) found = is;
    }
    return found;
  }
  // Whose ages nobody knows then.
  static Spans without_sensed(Spans box) {
    std::erase_if(box, [](const auto& each) { return each.first.of == Name::Of::sensed; });
    return box;
  }
  // On the grid, where it has one.
  [[nodiscard]] Spans point_of(const Spans& box, const Rational& share) const {
    Spans point;
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
  bool split(const Spans& box, std::vector<Spans>& to) const {
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
    Spans low = box, high = box;
    low[*longest].hi = middle;
    high[*longest].lo = next;
    to.push_back(std::move(high));
    to.push_back(std::move(low));
    return true;
  }
  [[nodiscard]] std::vector<ToldInput> inputs_of(const Spans& point) const {
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
  Spans ever_;  // whatever is measured
  bool looks_back_ = false;
  Variables variables_;
};

}  // namespace

Told told_to_be(const sema::Spec& spec, const sema::Expr& property, bool value, ToldHow how,
                const std::optional<SeenAtRest>& at_rest) {
  return Search(spec, {{&property, value, false, at_rest}}, value, how).run();
}
Told told_at_once(const sema::Spec& spec, const std::vector<ToHold>& all,
                  const std::vector<const sema::Expr*>& whatever_is_sensed) {
  std::vector<Said> asked;
  for (const ToHold& each : all) asked.push_back({each.property, true, false, each.at_rest});
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

// A choice between what inputs say and what robots sense; of an `and` that is denied, one side is
// not so if another one is not.
bool is_choice(const sema::Spec& spec, const sema::Expr& e) {
  const auto* const logic = std::get_if<sema::Logic>(&e.node);
  return logic != nullptr && logic->op != sema::LogicOp::logical_and && sema::speaks_of_robot(e) &&
         is_told(spec, e);
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

bool is_told(const sema::Spec& spec, const sema::Expr& e) {
  return !inputs_in(spec, e).empty() || sema::speaks_of<sema::SensedAge>(e) ||
         sema::speaks_of<sema::ParamRef>(e);
}

std::vector<const sema::Expr*> torn_parts(const sema::Spec& spec, const sema::Expr& e,
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
      const auto more = torn_parts(spec, *side, always);
      torn.insert(torn.end(), more.begin(), more.end());
    });
    return torn;
  }
  bool chooses = false;
  sema::for_each_expr(e,
                      [&](const sema::Expr& part) { chooses = chooses || is_choice(spec, part); });
  if (chooses) torn.push_back(&e);
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
