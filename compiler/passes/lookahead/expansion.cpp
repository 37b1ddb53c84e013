#include "compiler/passes/lookahead/expansion.h"

#include <algorithm>

#include "compiler/passes/lookahead/atoms.h"
#include "compiler/passes/lookahead/registry.h"

namespace rtac::passes::lookahead {

using namespace ir;

ValueId add(Block& to, Op op, const SourceRange& source) {
  to.values.push_back({std::move(op), std::nullopt, std::nullopt, source});
  return ValueId(to.values.size() - 1);
}

ValueId add_quantity(Block& to, Op op, const Unit& unit, const SourceRange& source) {
  to.values.push_back({std::move(op), unit, std::nullopt, source});
  return ValueId(to.values.size() - 1);
}

Block Expansion::run() {
  monitor_.unit.reset();
  Block ahead = transformed(monitor_.property);
  if (judges_legs_) on_track(*this, ahead);
  if (units_differ_) monitor_.unit.reset();
  tell_of_idle_waypoints();
  if (look().command && !commands_judged_ && !decision_.on_plan) {
    report_idle_command(ahead);
  }
  return ahead;
}

void Expansion::report_idle_command(const Block& ahead) {
  const bool is_about_agents =
      std::any_of(ahead.values.begin(), ahead.values.end(),
                  [](const Value& value) { return std::holds_alternative<AgentReach>(value.op); });
  without_effect(
      "`command` has no effect on monitor `" + monitor_.name + "`",
      is_about_agents
          ? "no command tells where an agent will be: the `distance` from one is judged under any "
            "control, whatever the robot is told; leave `command` out"
          : "commands tell where a robot will be: `inside`, `clearance` and the `distance` from "
            "other robots are judged under them; leave `command` out");
}

Block Expansion::transformed(const Block& property) {
  Block ahead;
  ahead.result = margin(property, property.result, ahead);
  return ahead;
}

// Look-ahead distributes over `and` and the quantifiers; of an `or` one disjunct must hold on
// the whole tube.
ValueId Expansion::margin(const Block& from, ValueId id, Block& to) {
  const Value& value = from[id];
  const auto both = [&](auto make, ValueId a, ValueId b) {
    const ValueId left = margin(from, a, to);
    const ValueId right = margin(from, b, to);
    return add(to, make(left, right), value.source);
  };
  if (const auto* v = std::get_if<And>(&value.op)) {
    return both([](ValueId a, ValueId b) { return Op(And{a, b}); }, v->a, v->b);
  }
  if (const auto* v = std::get_if<Or>(&value.op)) {
    return both([](ValueId a, ValueId b) { return Op(Or{a, b}); }, v->a, v->b);
  }
  if (const auto* v = std::get_if<ForOthers>(&value.op)) {
    auto body = std::make_unique<Block>(transformed(*v->body));
    return add(to, ForOthers{v->universal, std::move(body)}, value.source);
  }
  if (const auto* v = std::get_if<Truth>(&value.op)) return add(to, *v, value.source);
  if (const auto* v = std::get_if<PlanInZone>(&value.op)) return add(to, *v, value.source);
  if (const auto* v = std::get_if<AtLeast>(&value.op)) {
    return transform(*this, {from, *v, value.source, to});
  }
  // judged now, whatever lies ahead
  if (const auto* v = std::get_if<Fact>(&value.op)) return add(to, *v, value.source);
  if (const auto* v = std::get_if<Not>(&value.op)) {
    if (const auto* fact = std::get_if<Fact>(&from[v->a].op)) {
      return add(to, Not{add(to, *fact, value.source)}, value.source);
    }
    if (const auto* there = std::get_if<ZoneThere>(&from[v->a].op)) {
      return window(*this, *there, false, value.source, to);
    }
  }
  if (const auto* v = std::get_if<ZoneThere>(&value.op)) {
    return window(*this, *v, true, value.source, to);
  }
  if (const auto* v = std::get_if<Not>(&value.op)) {
    const auto* others = std::get_if<ForOthers>(&from[v->a].op);
    if (others != nullptr) return refuse_quantifier(others->universal, value.source, to);
  }
  return refuse_negation(value.source, to);
}

ValueId Expansion::negated(const Block& from, ValueId id, Block& to) {
  const Value& value = from[id];
  const auto both = [&](auto make, ValueId a, ValueId b) {
    const ValueId left = negated(from, a, to);
    const ValueId right = negated(from, b, to);
    return add(to, make(left, right), value.source);
  };
  if (const auto* v = std::get_if<And>(&value.op)) {
    return both([](ValueId a, ValueId b) { return Op(Or{a, b}); }, v->a, v->b);
  }
  if (const auto* v = std::get_if<Or>(&value.op)) {
    return both([](ValueId a, ValueId b) { return Op(And{a, b}); }, v->a, v->b);
  }
  if (const auto* v = std::get_if<Not>(&value.op)) return margin(from, v->a, to);
  if (const auto* v = std::get_if<Truth>(&value.op)) {
    return add(to, Truth{!v->value}, value.source);
  }
  if (const auto* v = std::get_if<Fact>(&value.op)) {
    return add(to, Not{add(to, *v, value.source)}, value.source);
  }
  if (const auto* v = std::get_if<ZoneThere>(&value.op)) {
    return window(*this, *v, false, value.source, to);
  }
  if (const auto* v = std::get_if<AtLeast>(&value.op)) {
    return transform(*this, {from, AtLeast{v->b, v->a, !v->strict}, value.source, to});
  }
  return refuse_negation(value.source, to);
}

std::optional<ValueId> Expansion::more_of(const Need& need, const Unit& unit,
                                          const SourceRange& source, Block& to) const {
  std::optional<ValueId> sum;
  for (const auto& [param, k] : need.params) {
    const Unit& own = decision_.facts.params[param].unit;
    ValueId term = add_quantity(to, ParamValue{param}, own, source);
    if (k != 1 || own != unit) {
      term =
          add_quantity(to, Scale{term, k.get_num().get_si(), k.get_den().get_si()}, unit, source);
    }
    sum = sum ? add_quantity(to, Add{*sum, term}, unit, source) : term;
  }
  return sum;
}

void Expansion::decides_in(const Unit& unit) {
  if (counting_) return;  // the number decides, not the atoms of the members
  if (monitor_.unit && *monitor_.unit != unit) units_differ_ = true;
  monitor_.unit = unit;
}

void Expansion::keeps_apart(std::int64_t least_mm) {
  // What is only counted may be as near as it likes: it gates no recovery.
  if (counting_) return;
  monitor_.separation_mm = std::max(monitor_.separation_mm.value_or(least_mm), least_mm);
}

void Expansion::judges_waypoints(bool on_legs) {
  waypoints_judged_ = true;
  judges_legs_ = judges_legs_ || on_legs;
}

void Expansion::without_effect(std::string what, std::string help) {
  diagnostics_.report({diag::Code::clause_without_effect,
                       monitor_.lookahead_source,
                       std::move(what),
                       "would be ignored",
                       {},
                       std::move(help),
                       {}});
}

// The duration check asks for the way home from everywhere within reach, at every tick: each
// way-point is covered before it is reached.
void Expansion::tell_of_idle_waypoints() {
  if (decision_.on_plan || !look().duration || look().waypoints == 0 || waypoints_judged_) return;
  diagnostics_.report({diag::Code::waypoints_not_needed,
                       monitor_.lookahead_source,
                       "`waypoints` adds nothing to monitor `" + monitor_.name + "`",
                       "the duration alone decides",
                       {},
                       "a charge is judged at every tick from everywhere within reach, and so at "
                       "each way-point before the robot is there; `waypoints` can be left out",
                       {}});
}

ValueId Expansion::refuse_negation(const SourceRange& source, Block& to) {
  return refuse(source,
                decision_.on_plan ? "a negated property of a plan cannot be judged"
                                  : "a negated or temporal property cannot be looked ahead",
                to);
}

ValueId Expansion::refuse_quantifier(bool universal, const SourceRange& source, Block& to) {
  const std::string is = universal ? "`forall`" : "`exists`";
  const std::string says_the_same = universal ? "`exists`" : "`forall`";
  diagnostics_.report({diag::Code::atom_without_transformer,
                       source,
                       "a negated " + is + " cannot be looked ahead",
                       "denied as a whole",
                       {},
                       says_the_same + " with the negated comparison says the same: `" +
                           (universal ? "not (forall q : Kind, q != r : distance(r, q) <= c)` is "
                                        "`exists q : Kind, q != r : distance(r, q) > c`"
                                      : "not (exists q : Kind, q != r : distance(r, q) < c)` is "
                                        "`forall q : Kind, q != r : distance(r, q) >= c`"),
                       {}});
  return add(to, Truth{false}, source);
}

ValueId Expansion::refuse(const SourceRange& source, const std::string& what, Block& to,
                          const std::string& first) {
  diagnostics_.report({diag::Code::atom_without_transformer,
                       source,
                       what,
                       "",
                       {},
                       decision_.on_plan
                           ? "`r.plan inside zone` works, also with a zone `a - b`"
                           : first + registered_forms() + " work, joined by `and` and `or`",
                       {}});
  return add(to, Truth{false}, source);
}

}  // namespace rtac::passes::lookahead
