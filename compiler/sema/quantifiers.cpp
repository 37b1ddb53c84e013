// The quantifiers over other robots, `count`, `min` and `max` over them: who is bound, and that it
// is another one.
#include "compiler/sema/property_checker.h"
#include "compiler/sema/suggest.h"

namespace rtac::sema {

using syntax::BinaryOp;

bool PropertyChecker::not_nested(const Head& head) {
  if (other_ == nullptr) return true;
  context_.report(
      Finding(Code::nested_quantifier, head.range, "a quantifier stands inside another one")
          .label("the inner one")
          .note(other_->range, "the outer one binds `" + other_->text + "` here")
          .help("judge pairs of the monitored robot and one other robot"));
  return false;
}

// Where a name has a meaning already; null: nowhere.
const SourceRange* PropertyChecker::taken_at(std::string_view name) const {
  const Symbol* hidden = context_.symbols.find(name);
  const SourceRange* taken = hidden != nullptr ? &hidden->range : nullptr;
  if (const Local* bound = local(name)) taken = &bound->range;
  for (const auto& [member, robot] : members_) {
    if (member->text == name) taken = &member->range;
  }
  if (scope_.of_robot() && name == scope_.self.text) taken = &scope_.self.range;
  return taken;
}

// Is the name of the variable free?
bool PropertyChecker::variable_fits(const Head& head) {
  const syntax::Name& variable = head.variable;
  const SourceRange* const taken = taken_at(variable.text);
  if (taken == nullptr) return true;
  std::string free = variable.text + "_2";
  for (const char* const name : {"mate", "other", "q"}) {
    if (taken_at(name) == nullptr) free = name;
  }
  context_.report(
      Finding(Code::duplicate_name, variable.range, "the name `" + variable.text + "` is taken")
          .label("the second meaning")
          .note(*taken, "`" + variable.text + "` is declared here")
          .help("give the other robot a name of its own, such as `" + free + "`"));
  return false;
}

// A name that nobody has declared, and that is nearly the one of agents, is reported as that.
bool PropertyChecker::may_be_agents(const syntax::Name& name) {
  if (context_.symbols.find(name.text) != nullptr) return false;
  for (const Sort sort : {Sort::agents, Sort::agent}) {
    if (!nearest(name.text, context_.symbols.names_of(sort))) continue;
    (void)context_.resolve(name, sort);
    return true;
  }
  return false;
}

bool PropertyChecker::quantifier_fits(const Head& head) {
  if (!variable_fits(head) || may_be_agents(head.kind)) return false;
  const auto kind = context_.resolve<KindId>(head.kind, Sort::robot_kind);
  if (kind && scope_.kind && *kind != *scope_.kind) {
    const std::string& due = context_.spec[*scope_.kind].name;
    context_.report(
        Finding(Code::wrong_kind, head.kind.range,
                "the monitored robot is a `" + due + "`, the other one a `" + head.kind.text + "`")
            .label("must be `" + due + "`")
            .help("a property relates robots of one kind: write `" + due + "`"));
    return false;
  }
  return kind && guard_fits(head);
}

bool PropertyChecker::guard_fits(const Head& head) {
  const std::string& other = head.variable.text;
  const std::string& self = scope_.self.text;
  const std::string due = other + " != " + self;
  if (!head.guard) {
    context_.report(Finding(Code::guard_missing, head.kind.range,
                            "`" + other + "` may be `" + self + "` itself")
                        .label("no guard")
                        .help("write `" + head.kind.text + ", " + due + "`")
                        .insert_after(head.kind.range, ", " + due));
    return false;
  }
  if (is_error(*head.guard)) return false;
  const auto names = [](const syntax::Expr& expr, const std::string& name) {
    const auto* reference = std::get_if<syntax::NameRef>(&expr.node);
    return reference != nullptr && reference->name.text == name;
  };
  const auto* binary = std::get_if<syntax::Binary>(&head.guard->node);
  if (binary != nullptr && binary->op == BinaryOp::not_equal &&
      ((names(*binary->left, other) && names(*binary->right, self)) ||
       (names(*binary->left, self) && names(*binary->right, other)))) {
    return true;
  }
  context_.report(Finding(Code::guard_missing, head.guard->range,
                          "the guard does not leave out `" + self + "` itself")
                      .label("must be `" + due + "`")
                      .help("write `" + due + "` and join other conditions by `implies`")
                      .replace(head.guard->range, due));
  return false;
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::OverFleet& over) {
  const std::string& name = over.name.text;
  if (name == "count" || name == "min" || name == "max") {
    if (sees_fleets()) return over_members(expr, over);
    return robot_allowed(expr.range, "`" + name + "` over robots") ? over_others(expr, over)
                                                                   : nullptr;
  }
  context_.report(Finding(Code::unknown_function, over.name.range,
                          "`" + name + "` is not computed over the robots of a fleet")
                      .label("not a function of fleets")
                      .help("possible are `count`, `min` and `max`"));
  return nullptr;
}

Value PropertyChecker::over_others(const syntax::Expr& expr, const syntax::OverFleet& over) {
  const Head head{expr.range, over.variable, over.kind, over.guard};
  if (!not_nested(head) || !quantifier_fits(head)) return nullptr;
  const bool counts = over.name.text == "count";
  const int outer = polarity_;
  polarity_ = 0;
  other_ = &over.variable;
  ExprPtr body = counts ? condition(*over.body) : quantity_of(*over.body);
  other_ = nullptr;
  polarity_ = outer;
  if (!body) return nullptr;
  const Dimension dimension = body->dimension;
  if (counts) return make_quantity(expr.range, dims::number, CountOthers{std::move(body)});
  return make_quantity(expr.range, dimension,
                       OverMembers{over.name.text == "max", operands_of(std::move(body))});
}

}  // namespace rtac::sema
