#include "compiler/recheck/seen.h"

#include <algorithm>
#include <optional>

#include "compiler/recheck/claims.h"
#include "compiler/recheck/sums.h"

namespace rtac::recheck {
namespace {

// Each part that one connective joins: `a or b or c` is an `or` within another.
template <class Visit>
void for_each_of(sema::LogicOp op, const sema::Expr& e, const Visit& visit) {
  const auto* logic = std::get_if<sema::Logic>(&e.node);
  if (logic == nullptr || logic->op != op) {
    visit(e);
    return;
  }
  for (const sema::ExprPtr& each : logic->operands) for_each_of(op, *each, visit);
}
// Each part that has to hold.
template <class Visit>
void for_each_conjunct(const sema::Expr& e, const Visit& visit) {
  for_each_of(sema::LogicOp::logical_and, e, visit);
}

struct Limits {
  std::optional<Rational> speed, charge, low, high;
};
void tighten(std::optional<Rational>& limit, const Rational& to, bool from_above) {
  const bool stricter = !limit || (from_above ? to < *limit : to > *limit);
  if (stricter) limit = to;
}
Limits limits_of(const sema::Spec& spec, const sema::Expr& property) {
  Limits all;
  for_each_conjunct(property, [&](const sema::Expr& e) {
    const auto sum = excess(spec, e);
    if (!sum) return;
    using Kind = Measured::Kind;
    const auto way = std::ranges::find_if(
        sum->terms, [](const auto& t) { return t.first.kind == Kind::energy_to && t.second < 0; });
    const auto charge = sum->terms.find({Kind::battery, 0});
    if (sum->terms.size() == 2 && way != sum->terms.end() && charge != sum->terms.end() &&
        charge->second > 0) {
      tighten(all.charge, Rational(-sum->least / charge->second),
              false);  // no way takes less than 0
    }
    if (sum->terms.size() != 1) return;
    const auto& [of, times] = *sum->terms.begin();
    const Rational limit = -sum->least / times;
    if (of.kind == Kind::speed && times < 0) tighten(all.speed, limit, true);
    if (of.kind == Kind::battery && times > 0) tighten(all.charge, limit, false);
    if (of.kind == Kind::altitude) tighten(times > 0 ? all.low : all.high, limit, times < 0);
  });
  return all;
}

}  // namespace

std::vector<std::vector<sema::ZoneId>> sides_at_once(const sema::Expr& property) {
  std::vector<std::vector<sema::ZoneId>> all;
  for_each_conjunct(property, [&](const sema::Expr& e) {
    const auto* logic = std::get_if<sema::Logic>(&e.node);
    if (logic == nullptr || logic->op != sema::LogicOp::logical_or) return;
    std::vector<sema::ZoneId> zones;
    bool of_zones = true;
    for_each_of(sema::LogicOp::logical_or, e, [&](const sema::Expr& side) {
      const auto of_side = all_zones(side);
      of_zones = of_zones && !of_side.empty();
      zones.insert(zones.end(), of_side.begin(), of_side.end());
    });
    if (of_zones) all.push_back(std::move(zones));
  });
  return all;
}

// A measurement may be off by its error to either side, and what it shows is as far off again.
std::string limit_unseen(const sema::Spec& spec, const sema::Decision& decision,
                         const sema::Expr& property) {
  const sema::RobotKind& kind = spec[decision.kind];
  const auto error_of = [](const auto& sense) { return sense ? sense->error.value : Rational(0); };
  const Limits limits = limits_of(spec, property);
  if (limits.speed && *limits.speed < 2 * error_of(kind.velocity)) {
    return "no speed is seen to be so low";
  }
  if (limits.charge && *limits.charge > 1 - 2 * error_of(kind.battery)) {
    return "no charge is seen to be so high";
  }
  if (limits.low && limits.high && *limits.high - *limits.low < 2 * error_of(kind.position)) {
    return "no height is seen to be within its limits";
  }
  return "";
}

bool is_on_each_side(const NamedZones& named, const sema::Expr& property,
                     const std::set<std::string>& zones) {
  return std::ranges::all_of(sides_at_once(property), [&](const auto& sides) {
    return std::ranges::any_of(sides,
                               [&](sema::ZoneId zone) { return zones.contains(named.name(zone)); });
  });
}

}  // namespace rtac::recheck
