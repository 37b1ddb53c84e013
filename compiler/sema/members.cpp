// Robots by name, in monitors without a robot: what they sense are inputs with the errors and ages
// that their kind declares. A quantifier goes through the robots of a kind one by one.
#include <algorithm>

#include "compiler/sema/fleets.h"
#include "compiler/sema/inputs.h"
#include "compiler/sema/limits.h"
#include "compiler/sema/property_checker.h"
#include "compiler/sema/suggest.h"

namespace rtac::sema {

using syntax::BinaryOp;

namespace {

// Farther away a position is unknown: differences of two have squares that fit the kernel.
constexpr long far_m = 100'000;
// Headings that are counted on and on, about a hundred turns of them.
constexpr long far_rad = 600;

struct RobotSignal {
  const char* name;
  Need need;
  TypeKind type;
  const Dimension& dimension;
  std::optional<Sense> RobotKind::*sense;
};
const RobotSignal signals[] = {
    {"position", Need::position, TypeKind::point, dims::length, &RobotKind::position},
    {"velocity", Need::velocity, TypeKind::vector, dims::speed, &RobotKind::velocity},
    {"heading", Need::heading, TypeKind::real, dims::angle, &RobotKind::heading},
    {"battery", Need::battery, TypeKind::real, dims::ratio, &RobotKind::battery},
};

const RobotSignal* signal_named(const std::string& name) {
  const auto* found = std::find_if(std::begin(signals), std::end(signals),
                                   [&](const RobotSignal& each) { return each.name == name; });
  return found == std::end(signals) ? nullptr : found;
}

// language rule 13: positions, the declared speed, and an empty or full battery; each by as much
// more as the measurement may be wrong.
Rational most_of(const RobotSignal& signal, const RobotKind& kind) {
  const Rational error = (kind.*signal.sense)->error.value;
  if (signal.need == Need::position) return Rational(far_m);
  if (signal.need == Need::heading) return Rational(far_rad);
  if (signal.need == Need::velocity) return Rational(kind.motion.speed.value + error);
  return Rational(1 + error);
}
Rational least_of(const RobotSignal& signal, const RobotKind& kind) {
  const Rational error = (kind.*signal.sense)->error.value;
  return signal.need == Need::battery ? Rational(-error) : Rational(-most_of(signal, kind));
}

}  // namespace

bool PropertyChecker::names_robot(const syntax::Expr& expr) const {
  const auto* index = std::get_if<syntax::Index>(&expr.node);
  const syntax::Name* name = name_in(index != nullptr ? *index->base : expr);
  if (name == nullptr || local(name->text) != nullptr) return false;
  const bool bound = std::any_of(members_.begin(), members_.end(),
                                 [&](const auto& each) { return each.first->text == name->text; });
  const Symbol* symbol = context_.symbols.find(name->text);
  return bound || (symbol != nullptr && (symbol->sort == Sort::fleet ||
                                         (symbol->sort == Sort::robot && index == nullptr)));
}

bool PropertyChecker::says_robot(const syntax::Expr& expr) const {
  return subject(expr).has_value() || names_robot(expr);
}

std::pair<Value, Value> PropertyChecker::both(const syntax::Expr& left, const syntax::Expr& right) {
  Value one = infer(left);
  const bool robots = says_robot(left) && says_robot(right);
  Value other = robots ? Value() : infer(right);
  return {std::move(one), std::move(other)};
}

std::optional<RobotId> PropertyChecker::robot_named(const syntax::Expr& expr) {
  const auto* index = std::get_if<syntax::Index>(&expr.node);
  const syntax::Name* name = name_in(index != nullptr ? *index->base : expr);
  for (const auto& [variable, robot] : members_) {
    if (index == nullptr && variable->text == name->text) return robot;
  }
  const auto robot =
      resolve_robot(context_, *name, index != nullptr ? index->index.get() : nullptr);
  // A kind that is not known was reported.
  const bool known = robot && index_of(context_.spec[*robot].kind) < context_.spec.kinds.size();
  return known ? robot : std::nullopt;
}

std::optional<InputId> PropertyChecker::robot_input(RobotId robot, const std::string& signal,
                                                    const SourceRange& range) {
  const RobotSignal* known = signal_named(signal);
  if (known == nullptr) return std::nullopt;
  const Robot& owner = context_.spec[robot];
  const RobotKind& kind = context_.spec[owner.kind];
  context_.require(owner.kind, known->need, range, "`" + signal + "`");
  const auto& sense = kind.*known->sense;
  if (!sense) return std::nullopt;
  const InputId next{static_cast<std::uint32_t>(context_.spec.inputs.size())};
  const auto [place, added] = context_.robot_inputs.emplace(std::pair(robot, signal), next);
  context_.used_inputs.insert(place->second);
  if (!added) return place->second;
  const bool in_space = kind.in_space && known->type != TypeKind::real;
  const ValueType type{known->type, known->dimension, std::nullopt, std::nullopt, in_space};
  Input input{};
  input.name = owner.name + "." + signal;
  input.name_range = owner.name_range;
  shape(input, type);
  input.least = Quantity{least_of(*known, kind), sense->error.range};
  input.most = Quantity{most_of(*known, kind), sense->error.range};
  input.resolution = known->dimension == dims::ratio ? Rational(1, 1'000'000) : Rational(1, 1000);
  input.error = sense->error;
  input.max_age = sense->max_age;
  input.robot = robot;
  round_limits(input);
  context_.spec.inputs.push_back(std::move(input));
  context_.input_types.push_back(type);
  return next;
}

// The plan of a robot counts until another one comes.
std::optional<InputId> PropertyChecker::robot_plan(RobotId robot, const SourceRange& range) {
  const Robot& owner = context_.spec[robot];
  const RobotKind& kind = context_.spec[owner.kind];
  context_.require(owner.kind, Need::plan, range, "`plan`");
  if (!kind.plan) return std::nullopt;
  const InputId next{static_cast<std::uint32_t>(context_.spec.inputs.size())};
  const auto [place, added] = context_.robot_inputs.emplace(std::pair(robot, "plan"), next);
  context_.used_inputs.insert(place->second);
  if (!added) return place->second;
  ValueType type;
  type.kind = TypeKind::path;
  type.dimension = dims::length;
  type.length = static_cast<std::uint32_t>(kind.plan->capacity);
  Input input{};
  input.name = owner.name + ".plan";
  input.name_range = owner.name_range;
  shape(input, type);
  input.held = true;
  input.robot = robot;
  context_.spec.inputs.push_back(std::move(input));
  context_.input_types.push_back(type);
  return next;
}

Value PropertyChecker::robot_signal(const syntax::Expr& expr, const syntax::Member& member) {
  const std::string& field = member.field.text;
  const auto robot = robot_named(*member.base);
  if (!robot || field.empty()) return nullptr;
  if (signal_named(field) != nullptr) {
    const auto input = robot_input(*robot, field, expr.range);
    return input ? input_value(expr.range, *input) : nullptr;
  }
  if (field == "plan") {
    const auto input = robot_plan(*robot, expr.range);
    return input ? input_value(expr.range, *input) : nullptr;
  }
  if (field == "speed") {
    const auto input = robot_input(*robot, "velocity", expr.range);
    Value velocity = input ? input_value(expr.range, *input) : nullptr;
    auto* pair = std::get_if<Pair>(&velocity.node);
    if (pair == nullptr) return nullptr;
    auto parts = operands_of(std::move(pair->x), std::move(pair->y));
    if (pair->z) parts.push_back(std::move(pair->z));
    return math(expr, MathOp::norm, dims::speed, std::move(parts));
  }
  context_.report(
      Finding(Code::unknown_signal, member.field.range,
              "a monitor without a robot sees no signal `" + field + "` of a robot")
          .label("not a signal")
          .help(did_you_mean(field, {"position", "velocity", "speed", "heading", "battery", "plan"},
                             "signals of robots")));
  return nullptr;
}

// Bodies: the gap between two discs, or of a disc and a point.
Value PropertyChecker::distance_of_bodies(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 2, "distance(r1, r2)")) return nullptr;
  Rational bodies = 0;
  std::vector<Pair> centres;
  std::vector<RobotId> robots;
  for (const syntax::ExprPtr& argument : call.arguments) {
    if (!names_robot(*argument)) {
      auto point = pair_of(*argument, Pair::Kind::point, "distance");
      if (!point) return nullptr;
      centres.push_back(std::move(*point));
      continue;
    }
    const auto robot = robot_named(*argument);
    const auto input = robot ? robot_input(*robot, "position", expr.range) : std::nullopt;
    if (!input) return nullptr;
    Value centre = input_value(argument->range, *input);
    centres.push_back(std::move(std::get<Pair>(centre.node)));
    robots.push_back(*robot);
    bodies += context_.spec[context_.spec[*robot].kind].radius.value;
  }
  if (robots.size() == 2 && robots[0] == robots[1]) {
    const std::string& name = context_.spec[robots[0]].name;
    context_.report(
        Finding(Code::guard_missing, expr.range, "this is the distance of `" + name + "` to itself")
            .label("two robots are due")
            .help("name two robots, or leave one out: `forall q : Kind, q != r : ...`"));
    return nullptr;
  }
  const auto difference = [&](ExprPtr a, ExprPtr b) {
    return make_quantity(
        expr.range, dims::length,
        Arithmetic{ArithmeticOp::subtract, operands_of(std::move(a), std::move(b))});
  };
  if (!agree(expr.range, "`distance`", centres[0], centres[1])) return nullptr;
  auto parts = operands_of(difference(std::move(centres[0].x), std::move(centres[1].x)),
                           difference(std::move(centres[0].y), std::move(centres[1].y)));
  if (centres[0].z) parts.push_back(difference(std::move(centres[0].z), std::move(centres[1].z)));
  ExprPtr gap = make_quantity(expr.range, dims::length, Math{MathOp::norm, std::move(parts)});
  return difference(std::move(gap),
                    make_quantity(expr.range, dims::length, Constant{bodies, true}));
}

// `q != r`, several of them joined by `and`.
bool PropertyChecker::excludes(const syntax::Expr& guard, const Head& head,
                               std::vector<RobotId>& out) {
  if (is_error(guard)) return false;
  const auto* binary = std::get_if<syntax::Binary>(&guard.node);
  if (binary != nullptr && binary->op == BinaryOp::logical_and) {
    return excludes(*binary->left, head, out) && excludes(*binary->right, head, out);
  }
  const auto is_variable = [&](const syntax::Expr& side) {
    const syntax::Name* name = name_in(side);
    return name != nullptr && name->text == head.variable.text;
  };
  if (binary != nullptr && binary->op == BinaryOp::not_equal) {
    const bool left = is_variable(*binary->left);
    const syntax::Expr& other = left ? *binary->right : *binary->left;
    if ((left || is_variable(*binary->right)) && names_robot(other)) {
      const auto robot = robot_named(other);
      if (robot) out.push_back(*robot);
      return robot.has_value();
    }
    const syntax::Name* name = left ? name_in(other) : nullptr;
    if (name != nullptr && context_.symbols.find(name->text) == nullptr) {
      (void)context_.resolve(*name, Sort::robot);
      return false;
    }
  }
  context_.report(Finding(Code::guard_missing, guard.range, "the guard does not leave out a robot")
                      .label("must be like `" + head.variable.text + " != r1`")
                      .help("write the robots that are left out, and join other conditions by "
                            "`implies`"));
  return false;
}

std::optional<std::vector<RobotId>> PropertyChecker::members(const Head& head) {
  if (!variable_fits(head)) return std::nullopt;
  const auto kind = context_.resolve<KindId>(head.kind, Sort::robot_kind);
  std::vector<RobotId> left_out, found;
  if (!kind || (head.guard && !excludes(*head.guard, head, left_out))) return std::nullopt;
  for (std::uint32_t i = 0; i < context_.spec.robots.size(); ++i) {
    const RobotId robot{i};
    const bool is_out = std::find(left_out.begin(), left_out.end(), robot) != left_out.end();
    if (context_.spec[robot].kind == *kind && !is_out) found.push_back(robot);
  }
  return found;
}

// A balanced tree, so that a large fleet does not nest deeply.
ExprPtr PropertyChecker::joined(const SourceRange& range, LogicOp op, std::vector<ExprPtr> parts) {
  if (parts.empty()) return make_condition(range, Truth{op == LogicOp::logical_and});
  while (parts.size() > 1) {
    std::vector<ExprPtr> next;
    for (std::size_t i = 0; i + 1 < parts.size(); i += 2) {
      next.push_back(make_condition(
          range, Logic{op, operands_of(std::move(parts[i]), std::move(parts[i + 1]))}));
    }
    if (parts.size() % 2 == 1) next.push_back(std::move(parts.back()));
    parts = std::move(next);
  }
  return std::move(parts.front());
}

Value PropertyChecker::quantified_members(const syntax::Expr& expr,
                                          const syntax::Quantified& quantified) {
  const auto robots = members({expr.range, quantified.variable, quantified.kind, quantified.guard});
  if (!robots) return nullptr;
  std::vector<ExprPtr> parts;
  for (const RobotId robot : *robots) {
    members_.emplace_back(&quantified.variable, robot);
    ExprPtr part = condition(*quantified.body);
    members_.pop_back();
    if (!part) return nullptr;  // one report stands for all robots
    parts.push_back(std::move(part));
  }
  const bool universal = quantified.quantifier == syntax::Quantifier::forall;
  return joined(expr.range, universal ? LogicOp::logical_and : LogicOp::logical_or,
                std::move(parts));
}

// One for each condition that holds: what is undecided counts as between 0 and 1.
ExprPtr PropertyChecker::counted(const SourceRange& range, std::vector<ExprPtr> conditions) {
  const auto number = [&](int value) {
    return make_quantity(range, dims::number, Constant{Rational(value)});
  };
  std::vector<ExprPtr> parts;
  for (ExprPtr& condition : conditions) {
    parts.push_back(
        make_quantity(range, dims::number, Choice{std::move(condition), number(1), number(0)}));
  }
  if (parts.empty()) return number(0);
  while (parts.size() > 1) {
    std::vector<ExprPtr> next;
    for (std::size_t i = 0; i + 1 < parts.size(); i += 2) {
      next.push_back(
          make_quantity(range, dims::number,
                        Arithmetic{ArithmeticOp::add,
                                   operands_of(std::move(parts[i]), std::move(parts[i + 1]))}));
    }
    if (parts.size() % 2 == 1) next.push_back(std::move(parts.back()));
    parts = std::move(next);
  }
  return std::move(parts.front());
}

Value PropertyChecker::over_members(const syntax::Expr& expr, const syntax::OverFleet& over) {
  const auto robots = members({expr.range, over.variable, over.kind, over.guard});
  if (!robots) return nullptr;
  const bool counts = over.name.text == "count";
  const int outer = polarity_;
  polarity_ = 0;
  std::vector<ExprPtr> parts;
  for (const RobotId robot : *robots) {
    members_.emplace_back(&over.variable, robot);
    ExprPtr part = counts ? condition(*over.body) : quantity_of(*over.body);
    members_.pop_back();
    if (!part) break;  // one report stands for all robots
    parts.push_back(std::move(part));
  }
  polarity_ = outer;
  if (parts.size() < robots->size()) return nullptr;
  if (counts) return counted(expr.range, std::move(parts));
  if (parts.empty()) {
    return wrong_operand(expr.range, "there is no robot to take the `" + over.name.text + "` of",
                         "declare a fleet of `" + over.kind.text + "`");
  }
  const Dimension dimension = parts.front()->dimension;
  return make_quantity(expr.range, dimension,
                       OverMembers{over.name.text == "max", std::move(parts)});
}

}  // namespace rtac::sema
