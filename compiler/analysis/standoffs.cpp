#include "compiler/analysis/standoffs.h"

#include <algorithm>

#include "compiler/analysis/speed_limits.h"
#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

// Beyond the grid nothing is clear any more.
constexpr std::int64_t off_grid_mm = 1 << 30;

void raise(std::int64_t& wanted_mm, std::int64_t least_mm) {
  wanted_mm = std::max(wanted_mm, std::min(least_mm, off_grid_mm));
}

std::int64_t sure_separation(const ir::Block& block, ir::ValueId id,
                             const std::vector<ir::Param>& params) {
  if (const auto* both = std::get_if<ir::And>(&block[id].op)) {
    return std::max(sure_separation(block, both->a, params),
                    sure_separation(block, both->b, params));
  }
  if (const auto* either = std::get_if<ir::Or>(&block[id].op)) {
    return std::min(sure_separation(block, either->a, params),
                    sure_separation(block, either->b, params));
  }
  if (const auto* others = std::get_if<ir::ForOthers>(&block[id].op)) {
    return others->universal ? sure_separation(*others->body, others->body->result, params) : 0;
  }
  const auto* compare = std::get_if<ir::AtLeast>(&block[id].op);
  const auto bound = compare != nullptr ? ir::lower_bound(block, *compare, params) : std::nullopt;
  if (!bound || bound->leaf.kind != ir::Leaf::Kind::distance) return 0;
  return std::clamp<std::int64_t>(bound->need.strictest, 0, off_grid_mm);
}

}  // namespace

std::int64_t sure_separation_mm(const ir::Block& property, const std::vector<ir::Param>& params) {
  return sure_separation(property, property.result, params);
}

std::int64_t sure_separation_mm(const ir::Decision& decision) {
  std::int64_t most = 0;
  for (const ir::Monitor& m : decision.monitors) {
    most = std::max(most, sure_separation_mm(m.property, decision.facts.params));
  }
  return most;
}

void ask_for_standoffs(const ir::Block& property, const std::vector<ir::Param>& params,
                       Standoffs& wanted) {
  ir::for_each_comparison(property, [&](const ir::Block& block, const ir::AtLeast& compare) {
    const auto bound = ir::lower_bound(block, compare, params);
    if (!bound) return;
    if (bound->leaf.kind == ir::Leaf::Kind::clearance ||
        bound->leaf.kind == ir::Leaf::Kind::received) {
      raise(wanted.fence_mm, bound->need.strictest);
    }
    if (bound->leaf.kind == ir::Leaf::Kind::distance) {
      raise(wanted.separation_mm, bound->need.strictest);
    }
  });
}

Standoffs standoffs_of(const ir::Decision& decision) {
  Standoffs wanted;
  for (const ir::Monitor& m : decision.monitors) {
    ask_for_standoffs(m.property, decision.facts.params, wanted);
  }
  return wanted;
}

std::vector<Standoff> fence_standoffs(const ir::Block& property,
                                      const std::vector<ir::Param>& params) {
  std::vector<Standoff> all;
  ir::for_each_comparison(property, [&](const ir::Block& block, const ir::AtLeast& compare) {
    const auto bound = ir::lower_bound(block, compare, params);
    if (!bound || bound->leaf.kind != ir::Leaf::Kind::clearance) return;
    all.push_back({ir::ZoneIndex{bound->leaf.table}, std::min(bound->need.strictest, off_grid_mm)});
  });
  return all;
}

std::int64_t fence_standoff_mm(const ir::Block& property, const std::vector<ir::Param>& params,
                               ir::ZoneIndex zone) {
  std::int64_t most = 0;
  for (const Standoff& each : fence_standoffs(property, params)) {
    if (each.zone == zone) most = std::max(most, each.mm);
  }
  return most;
}

std::int64_t depth_mm(ir::ZoneIndex inner, const Standoff& outer, const HowItLies& lies) {
  const auto deep = [&](std::int64_t mm) { return lies(inner, {outer.zone, mm}) == Lies::deep; };
  if (inner == outer.zone || outer.mm <= 0 || !deep(1)) return 0;
  std::int64_t low = 1, high = outer.mm + 1;
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (deep(middle) ? low : high) = middle;
  }
  return low;
}

std::int64_t standoff_of(const ir::Block& property, const std::vector<ir::Param>& params, bool own,
                         ir::ZoneIndex zone, const HowItLies& lies) {
  std::int64_t most = 0;
  for (const Standoff& each : fence_standoffs(property, params)) {
    if (each.mm <= most) continue;
    const Lies how = each.zone == zone ? Lies::in : lies(zone, each);
    if (how == Lies::in || (how == Lies::elsewhere && own)) most = each.mm;
  }
  return most;
}

std::int64_t standoff_in(const ir::Decision& decision, const ir::Monitor& own, ir::ZoneIndex zone,
                         const HowItLies& lies) {
  std::int64_t most = 0;
  const auto k = static_cast<std::size_t>(&own - decision.monitors.data());
  for (const ir::Monitor& m : decision.monitors) {
    // slow enough, it need not keep away from anything else than its zone
    const bool slow = holds_while_driving(decision, k, m);
    const HowItLies only_own = [](ir::ZoneIndex, const Standoff&) { return Lies::deep; };
    most = std::max(
        most, standoff_of(m.property, decision.facts.params, m.recovery.name == own.recovery.name,
                          zone, slow ? only_own : lies));
  }
  return most;
}

}  // namespace rtac::analysis
