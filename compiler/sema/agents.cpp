#include "compiler/sema/agents.h"

#include <utility>

#include "compiler/sema/fleets.h"
#include "compiler/sema/inputs.h"
#include "compiler/sema/limits.h"
#include "compiler/sema/property_checker.h"
#include "compiler/sema/quantity.h"

namespace rtac::sema {
namespace {

// Farther away an agent is unknown: differences of two places have squares that fit the kernel.
constexpr long far_m = 100'000;

InputId add_input(Context& context, AgentId id, const std::string& what, const ValueType& type) {
  const Agent& agent = context.spec[id];
  Input input{};
  input.name = agent.name + "." + what;
  input.name_range = agent.name_range;
  shape(input, type);
  input.max_age = agent.position.max_age;
  input.agent = id;
  if (type.kind == TypeKind::point) {
    input.least = Quantity{Rational(-far_m), agent.name_range};
    input.most = Quantity{Rational(far_m), agent.name_range};
    input.resolution = Rational(1, 1000);
    round_limits(input);
  }
  context.spec.inputs.push_back(std::move(input));
  context.input_types.push_back(type);
  return InputId{static_cast<std::uint32_t>(context.spec.inputs.size() - 1)};
}

void check_agent(Context& context, AgentId id, const syntax::AgentItem& written) {
  const auto value = [&](const syntax::ExprPtr& expr, const Due& due) {
    if (is_error(*expr)) return Quantity{0, expr->range};
    return quantity(context, *expr, due).value_or(Quantity{0, expr->range});
  };
  Agent& agent = context.spec.agents[index_of(id)];
  if (written.type) {
    agent.in_space = written.type->text == "point3";
    if (!agent.in_space && written.type->text != "point") {
      context.unknown_word(*written.type, "the type of an agent's position", {"point", "point3"});
    }
  }
  agent.radius = value(written.radius, {dims::length, "the radius of an agent", Limit::positive});
  agent.speed = value(written.speed, {dims::speed, "the speed of an agent", Limit::not_negative});
  agent.position.error =
      value(written.error, {dims::length, "the error of a position", Limit::not_negative});
  agent.position.max_age =
      value(written.max_age, {dims::time, "the age of a position", Limit::positive});
}

}  // namespace

void check_agents(Context& context) {
  for (std::uint32_t i = 0; i < context.agents.size(); ++i) {
    const AgentId id{i};
    const syntax::AgentItem& written = *context.agents[i].node;
    Agent& agent = context.spec.agents[i];
    if (i > 0 && context.agents[i - 1].node == &written) {  // one report stands for all of an item
      const Agent& first = context.spec.agents[i - 1];
      agent.radius = first.radius;
      agent.speed = first.speed;
      agent.position = first.position;
      agent.in_space = first.in_space;
    } else {
      check_agent(context, id, written);
    }
    ValueType place{TypeKind::point, dims::length, std::nullopt, std::nullopt};
    place.space = agent.in_space;
    const InputId seen = add_input(context, id, "position", place);
    agent.seen = seen;
    if (!written.present) continue;
    agent.present =
        add_input(context, id, "present", {TypeKind::boolean, {}, std::nullopt, std::nullopt});
  }
}

std::optional<AgentId> resolve_agent(Context& context, const syntax::Name& name,
                                     const syntax::Expr* number) {
  const auto found = resolve_numbered(
      context, name, number,
      {Sort::agent, Sort::agents, context.agent_groups, "one agent, not a group",
       "a group, not one agent", "member", ", or `forall p : " + name.text + " : ...`"});
  return found ? std::optional<AgentId>(AgentId{*found}) : std::nullopt;
}

// ---- in properties of robots

bool PropertyChecker::names_agent(const syntax::Expr& expr) const {
  const auto* index = std::get_if<syntax::Index>(&expr.node);
  const syntax::Name* name = name_in(index != nullptr ? *index->base : expr);
  if (name == nullptr || local(name->text) != nullptr) return false;
  if (index == nullptr && agent_ && agent_->first->text == name->text) return true;
  const Symbol* symbol = context_.symbols.find(name->text);
  return symbol != nullptr && (symbol->sort == Sort::agent || symbol->sort == Sort::agents);
}

// Where an agent is, only monitors of robots say: their decision is told of it.
ExprPtr PropertyChecker::agent_as_value(const syntax::Expr& expr, const syntax::Name& name) {
  if (sees_robot()) return not_a_quantity(expr, "an agent");
  const bool is_group = context_.symbols.find(name.text)->sort == Sort::agents;
  context_.report(Finding(Code::quantity_expected, expr.range,
                          "`" + name.text + "` is " +
                              (is_group ? "a group of agents" : "an agent") +
                              ", which only monitors of robots speak of")
                      .label("in a monitor without a robot")
                      .help("write `distance(r, " + name.text + (is_group ? "[0]" : "") +
                            ") >= 1 m` behind `monitor m for r : Kind`, or declare its place once "
                            "more, `input " +
                            name.text +
                            "_at : point error 5 cm max_age 200 ms;`, and take its "
                            "radius off the distance"));
  return nullptr;
}

ExprPtr PropertyChecker::distance_from_agent(const syntax::Expr& expr,
                                             const syntax::Expr& written) {
  const auto* index = std::get_if<syntax::Index>(&written.node);
  const syntax::Name* name = name_in(index != nullptr ? *index->base : written);
  const bool bound = index == nullptr && agent_ && agent_->first->text == name->text;
  const auto agent =
      bound ? std::optional<AgentId>(agent_->second)
            : resolve_agent(context_, *name, index != nullptr ? index->index.get() : nullptr);
  if (!agent) return nullptr;
  require_motion(expr.range, "`distance`");
  const Agent& of = context_.spec[*agent];
  if (of.in_space && !in_space()) {
    context_.report(
        Finding(Code::spaces_differ, expr.range,
                "`" + of.name + "` moves in space, `" + kind_name() + "` in the plane")
            .label("the robot has no height")
            .note(of.name_range, "the agent is declared here")
            .help("an agent of the plane works, without `point3`: it is near whatever its height "
                  "is; or declare `sense position : point3 ...` and `sense velocity : vector3 ...` "
                  "of `" +
                  kind_name() + "`"));
    return nullptr;
  }
  context_.used_inputs.insert(of.seen);
  if (of.present) context_.used_inputs.insert(*of.present);
  return make_quantity(expr.range, dims::length, AgentDistance{*agent, of.seen, of.present});
}

Value PropertyChecker::quantified_agents(const syntax::Expr& expr,
                                         const syntax::Quantified& quantified) {
  const Head head{expr.range, quantified.variable, quantified.kind, quantified.guard};
  if (!variable_fits(head)) return nullptr;
  if (quantified.guard) {
    context_.report(Finding(Code::guard_missing, quantified.guard->range,
                            "agents are none of the robots: no guard is needed")
                        .label("leaves nobody out")
                        .help("leave it out, and join other conditions by `implies`"));
    return nullptr;
  }
  const Symbol& symbol = *context_.symbols.find(quantified.kind.text);
  const NumberedFleet group = symbol.sort == Sort::agent ? NumberedFleet{symbol.index, 1}
                                                         : context_.agent_groups[symbol.index];
  std::vector<ExprPtr> parts;
  for (std::uint32_t i = 0; i < group.count; ++i) {
    const auto outer =
        std::exchange(agent_, std::pair(&quantified.variable, AgentId{group.first + i}));
    ExprPtr part = condition(*quantified.body);
    agent_ = outer;
    if (!part) return nullptr;  // one report stands for all agents
    parts.push_back(std::move(part));
  }
  const bool universal = quantified.quantifier == syntax::Quantifier::forall;
  return joined(expr.range, universal ? LogicOp::logical_and : LogicOp::logical_or,
                std::move(parts));
}

}  // namespace rtac::sema
