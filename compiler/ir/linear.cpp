#include "compiler/ir/linear.h"

#include <algorithm>

namespace rtac::ir {
namespace {

// Beyond any grid: nothing is as large.
constexpr std::int64_t beyond_grid = std::int64_t{1} << 48;

template <class Key>
void add_terms(std::map<Key, Rational>& to, const Rational& k,
               const std::map<Key, Rational>& from) {
  for (const auto& [key, coefficient] : from) {
    Rational& slot = to[key];
    slot += k * coefficient;
    if (sgn(slot) == 0) to.erase(key);
  }
}
Linear combine(const Linear& a, const Rational& k, const Linear& b) {
  Linear sum = a;
  add_terms(sum.terms, k, b.terms);
  add_terms(sum.rest.params, k, b.rest.params);
  sum.rest.constant += k * b.rest.constant;
  return sum;
}

Linear leaf_of(Leaf::Kind kind, std::uint32_t table) {
  Linear form;
  form.terms[{kind, table}] = 1;
  return form;
}

// Of a quantity; margins never occur here (verified IR).
Linear quantity_form(const Block& block, ValueId id) {
  const Op& op = block[id].op;
  if (const auto* v = std::get_if<Const>(&op)) {
    return {{}, {Rational(static_cast<long>(v->value)), {}}};
  }
  if (const auto* v = std::get_if<ParamValue>(&op)) return {{}, {0, {{v->param, 1}}}};
  if (std::holds_alternative<Battery>(op)) return leaf_of(Leaf::Kind::battery, 0);
  if (const auto* v = std::get_if<Clearance>(&op)) {
    return leaf_of(Leaf::Kind::clearance, static_cast<std::uint32_t>(v->zone));
  }
  if (std::holds_alternative<Distance>(op)) return leaf_of(Leaf::Kind::distance, 0);
  if (std::holds_alternative<Speed>(op)) return leaf_of(Leaf::Kind::speed, 0);
  if (std::holds_alternative<Altitude>(op)) return leaf_of(Leaf::Kind::altitude, 0);
  if (const auto* v = std::get_if<EnergyTo>(&op)) {
    return leaf_of(Leaf::Kind::energy_to, static_cast<std::uint32_t>(v->site));
  }
  if (const auto* v = std::get_if<AgentDistance>(&op)) {
    return leaf_of(Leaf::Kind::agent, static_cast<std::uint32_t>(v->agent));
  }
  if (const auto* v = std::get_if<ReceivedClearance>(&op)) {
    return leaf_of(Leaf::Kind::received, static_cast<std::uint32_t>(v->received));
  }
  if (const auto* v = std::get_if<Add>(&op)) {
    return combine(quantity_form(block, v->a), 1, quantity_form(block, v->b));
  }
  if (const auto* v = std::get_if<Negate>(&op)) {
    return combine({}, -1, quantity_form(block, v->a));
  }
  if (std::holds_alternative<CountOthers>(op)) {
    return leaf_of(Leaf::Kind::count, static_cast<std::uint32_t>(id));
  }
  const auto& scale = std::get<Scale>(op);
  return combine({}, Rational(static_cast<long>(scale.num), static_cast<long>(scale.den)),
                 quantity_form(block, scale.a));
}

bool has_form(const Block& block, ValueId id) {
  const Op& op = block[id].op;
  if (const auto* v = std::get_if<Add>(&op)) return has_form(block, v->a) && has_form(block, v->b);
  if (const auto* v = std::get_if<Negate>(&op)) return has_form(block, v->a);
  if (const auto* v = std::get_if<Scale>(&op)) return has_form(block, v->a);
  return std::holds_alternative<Const>(op) || std::holds_alternative<ParamValue>(op) ||
         std::holds_alternative<Battery>(op) || std::holds_alternative<Clearance>(op) ||
         std::holds_alternative<Distance>(op) || std::holds_alternative<Speed>(op) ||
         std::holds_alternative<Altitude>(op) || std::holds_alternative<EnergyTo>(op) ||
         std::holds_alternative<AgentDistance>(op) ||
         std::holds_alternative<ReceivedClearance>(op) || std::holds_alternative<CountOthers>(op);
}

// Rounded up to the grid, one step more when the comparison is strict; kept to what int64 holds.
std::int64_t least_step(const Rational& least, bool strict) {
  const Rational limit(static_cast<long>(beyond_grid));
  const Rational kept = std::clamp(least, Rational(-limit), limit);
  return (strict ? floor_to_int(kept) + 1 : ceil_to_int(kept));
}

// `rest` * by, as what is asked for.
Need need_of(const Affine& rest, const Rational& by, bool strict,
             const std::vector<Param>& params) {
  Need need;
  const Rational fixed(rest.constant * by);
  need.fixed = least_step(fixed, strict);
  Rational most(static_cast<long>(need.fixed)), least(most);
  for (const auto& [param, coefficient] : rest.params) {
    const Rational k(coefficient * by);
    need.params[param] = k;
    const Range& range = params[param].range;
    const Rational limit(static_cast<long>(beyond_grid));
    const auto steps = [&](std::int64_t value) {
      return ceil_to_int(
          std::clamp(Rational(k * static_cast<long>(value)), Rational(-limit), limit));
    };
    most += steps(sgn(k) > 0 ? range.hi : range.lo);
    least += steps(sgn(k) > 0 ? range.lo : range.hi);
  }
  need.strictest = least_step(most, false);
  need.laxest = least_step(least, false);
  return need;
}

}  // namespace

bool has_form(const Block& block, const AtLeast& compare) {
  return has_form(block, compare.a) && has_form(block, compare.b);
}

Linear linear_form(const Block& block, const AtLeast& compare) {
  return combine(quantity_form(block, compare.a), -1, quantity_form(block, compare.b));
}

std::optional<LowerBound> lower_bound(const Block& block, const AtLeast& compare,
                                      const std::vector<Param>& params) {
  const Linear form = linear_form(block, compare);
  if (form.terms.size() != 1) return std::nullopt;
  const auto& [leaf, coefficient] = *form.terms.begin();
  if (sgn(coefficient) <= 0) return std::nullopt;
  return LowerBound{leaf, need_of(form.rest, Rational(-1 / coefficient), compare.strict, params)};
}

std::optional<UpperBound> upper_bound(const Block& block, const AtLeast& compare) {
  const Linear form = linear_form(block, compare);
  if (form.terms.size() != 1 || !form.rest.params.empty()) return std::nullopt;
  const auto& [leaf, coefficient] = *form.terms.begin();
  if (sgn(coefficient) >= 0) return std::nullopt;
  // k leaf + c >= 0 with k < 0: -leaf >= c / k
  const Rational least(form.rest.constant / coefficient);
  return UpperBound{leaf, -least_step(least, compare.strict)};
}

std::optional<ChargeForWay> charge_for_way(const Block& block, const AtLeast& compare,
                                           const std::vector<Param>& params) {
  const Linear form = linear_form(block, compare);
  if (form.terms.size() != 2) return std::nullopt;
  const auto charge = form.terms.find({Leaf::Kind::battery, 0});
  const auto way = std::find_if(form.terms.begin(), form.terms.end(), [](const auto& term) {
    return term.first.kind == Leaf::Kind::energy_to;
  });
  if (charge == form.terms.end() || way == form.terms.end()) return std::nullopt;
  if (charge->second != 1 || way->second != -1) return std::nullopt;
  return ChargeForWay{SiteIndex(way->first.table),
                      need_of(form.rest, Rational(-1), compare.strict, params)};
}

std::map<AgentIndex, std::int64_t> agent_gaps(const Decision& decision) {
  std::map<AgentIndex, std::int64_t> gaps;
  for (const Monitor& monitor : decision.monitors) {
    for_each_comparison(monitor.property, [&](const Block& block, const AtLeast& compare) {
      const auto bound = lower_bound(block, compare, decision.facts.params);
      if (!bound || bound->leaf.kind != Leaf::Kind::agent) return;
      const auto [gap, added] = gaps.emplace(AgentIndex{bound->leaf.table}, bound->need.strictest);
      gap->second = std::max(gap->second, bound->need.strictest);
    });
  }
  return gaps;
}

bool asks_for_received(const Block& block) {
  return std::any_of(block.values.begin(), block.values.end(), [](const Value& v) {
    const Block* const others = body_of(v.op);
    return others != nullptr ? asks_for_received(*others)
                             : std::holds_alternative<ReceivedClearance>(v.op);
  });
}

void for_each_comparison(const Block& block,
                         const std::function<void(const Block&, const AtLeast&)>& visit) {
  for (const Value& value : block.values) {
    if (const auto* compare = std::get_if<AtLeast>(&value.op)) visit(block, *compare);
    if (const Block* others = body_of(value.op)) for_each_comparison(*others, visit);
  }
}

}  // namespace rtac::ir
