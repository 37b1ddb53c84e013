#include "compiler/recheck/at_worst.h"

#include <algorithm>
#include <variant>

#include "compiler/recheck/sums.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

// The limit of a comparison, or of being in a zone.
std::optional<Limit> limit_of(const sema::Spec& spec, const sema::Expr& e) {
  if (const auto* in = std::get_if<sema::InsideZone>(&e.node)) return Limit{in->zone, 0};
  const auto* compare = std::get_if<sema::Compare>(&e.node);
  if (compare == nullptr) return std::nullopt;
  using Op = sema::CompareOp;
  const bool at_least = compare->op == Op::greater || compare->op == Op::greater_equal;
  const auto sum = at_least ? difference(spec, *compare->left, *compare->right)
                            : difference(spec, *compare->right, *compare->left);
  if (!sum || sum->terms.size() != 1) return std::nullopt;
  const auto& [of, by] = *sum->terms.begin();
  if (of.kind != Measured::Kind::clearance || by <= 0) return std::nullopt;
  return Limit{sema::ZoneId{of.index}, std::max(Rational(0), Rational(-sum->least / by))};
}

class Worst {
 public:
  explicit Worst(const sema::Spec& spec) : spec_(spec) {}

  [[nodiscard]] AtWorst of(const sema::Expr& e, bool value) const {
    using Kind = AtWorst::Kind;
    if (std::holds_alternative<sema::ZoneOpen>(e.node)) return {Kind::fails, {}};
    if (const auto* truth = std::get_if<sema::Truth>(&e.node)) {
      return {truth->value == value ? Kind::holds : Kind::fails, {}};
    }
    const auto* logic = std::get_if<sema::Logic>(&e.node);
    if (logic == nullptr) {
      const auto limit = value ? limit_of(spec_, e) : std::nullopt;
      return limit ? AtWorst{Kind::limit, limit} : AtWorst{};
    }
    using Op = sema::LogicOp;
    const auto& sides = logic->operands;
    if (logic->op == Op::logical_not) return of(*sides[0], !value);
    if (logic->op == Op::implies) {
      return joined({of(*sides[0], !value), of(*sides[1], value)}, !value);
    }
    if (logic->op != Op::logical_and && logic->op != Op::logical_or) return {};
    std::vector<AtWorst> all;
    for (const sema::ExprPtr& side : sides) all.push_back(of(*side, value));
    return joined(all, (logic->op == Op::logical_and) == value);
  }

 private:
  // Of parts that all have to hold, or of which one has to.
  static AtWorst joined(const std::vector<AtWorst>& parts, bool all) {
    using Kind = AtWorst::Kind;
    const Kind decides = all ? Kind::fails : Kind::holds, nothing = all ? Kind::holds : Kind::fails;
    AtWorst left{nothing, {}};
    int others = 0;
    for (const AtWorst& part : parts) {
      if (part.kind == decides) return {decides, {}};
      if (part.kind == nothing) continue;
      left = part;
      ++others;
    }
    return others > 1 ? AtWorst{} : left;
  }

  const sema::Spec& spec_;
};

void collect(const sema::Expr& e, std::vector<const sema::Expr*>& parts) {
  if (!speaks_of_windows(e)) return;
  const auto* logic = std::get_if<sema::Logic>(&e.node);
  if (logic == nullptr || logic->op != sema::LogicOp::logical_and) return parts.push_back(&e);
  for (const sema::ExprPtr& each : logic->operands) collect(*each, parts);
}
bool asks_for_gate(const sema::Expr& e, bool value) {
  if (std::holds_alternative<sema::ZoneOpen>(e.node)) return value;
  const auto* logic = std::get_if<sema::Logic>(&e.node);
  if (logic == nullptr) return false;
  for (std::size_t k = 0; k < logic->operands.size(); ++k) {
    const bool turned =
        logic->op == sema::LogicOp::logical_not || (logic->op == sema::LogicOp::implies && k == 0);
    if (asks_for_gate(*logic->operands[k], value != turned)) return true;
  }
  return false;
}
bool collect_gates(const sema::Spec& spec, const sema::Expr& e, std::vector<sema::ZoneId>& zones) {
  if (std::holds_alternative<sema::ZoneOpen>(e.node)) return true;
  const auto* logic = std::get_if<sema::Logic>(&e.node);
  if (logic == nullptr) {
    const auto limit = limit_of(spec, e);
    if (!limit || limit->gap != 0) return false;
    zones.push_back(limit->zone);
    return true;
  }
  const bool all = logic->op == sema::LogicOp::logical_and;
  if (!all && logic->op != sema::LogicOp::logical_or) return false;
  const std::size_t before = zones.size();
  for (const sema::ExprPtr& each : logic->operands) {
    if (!collect_gates(spec, *each, zones)) return false;
  }
  return !all || zones.size() <= before + 1;
}

}  // namespace

bool speaks_of_windows(const sema::Expr& e) {
  bool found = false;
  sema::for_each_expr(e, [&](const sema::Expr& part) {
    found = found || std::holds_alternative<sema::ZoneOpen>(part.node) ||
            std::holds_alternative<sema::WhileOpen>(part.node);
  });
  return found;
}

AtWorst at_worst(const sema::Spec& spec, const sema::Expr& e) {
  return Worst(spec).of(e, true);
}

std::vector<const sema::Expr*> parts_of(const sema::Expr& property) {
  std::vector<const sema::Expr*> parts;
  collect(property, parts);
  return parts;
}

bool waits_for_gates(const sema::Expr& e) {
  return asks_for_gate(e, true);
}

std::optional<std::vector<sema::ZoneId>> gates_of(const sema::Spec& spec, const sema::Expr& e) {
  std::vector<sema::ZoneId> zones;
  return collect_gates(spec, e, zones) ? std::optional(std::move(zones)) : std::nullopt;
}

}  // namespace rtac::recheck
