#include "compiler/verify/other_recoveries.h"

#include <algorithm>

#include "compiler/analysis/limits.h"
#include "compiler/ir/linear.h"
#include "compiler/ir/operands.h"
#include "compiler/support/words.h"

namespace rtac::verify {
namespace {

// What an `acknowledge` names has to stay a recovery of the decision.
bool has_to_stay(const ir::Decision& d, const std::string& recovery) {
  const auto& acknowledged = d.acknowledgements;
  return std::ranges::find(acknowledged, recovery, &ir::Acknowledgement::recovery) !=
             acknowledged.end() &&
         std::ranges::count_if(
             d.monitors, [&](const ir::Monitor& m) { return m.recovery.name == recovery; }) == 1;
}
template <class Takes>
void add_recoveries_of_others(const ir::Decision& d, const ir::Monitor& of, const Takes& takes,
                              std::vector<Mend>& all) {
  if (has_to_stay(d, of.recovery.name)) return;
  std::set<std::string> tried{of.recovery.name};
  for (const ir::Monitor& other : d.monitors) {
    if (!takes(other) || !tried.insert(other.recovery.name).second) continue;
    all.emplace_back(SameRecovery{of.name, other.recovery.name});
  }
}

// The greatest speed at which a recovery is never seen to be faster than that. 0: there is none.
std::int64_t slow_enough_mmps(const ir::Decision& d, std::int64_t limit_mmps) {
  const auto fastest = [&](std::int64_t mmps) {
    return analysis::fastest_mmps(d.body, d.pushed_mmps, d.period_us, mmps);
  };
  std::int64_t low = 0, high = limit_mmps + 1;
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (fastest(middle) <= limit_mmps ? low : high) = middle;
  }
  return low;
}

// The heights that a monitor allows, and the standoff that it asks for from the boundary of a zone.
struct Allows {
  std::optional<std::int64_t> least_mm{}, most_mm{};
  std::int64_t off_mm = 0;
};
Allows allowed_by(const ir::Decision& d, const ir::Monitor& m, ir::ZoneIndex zone) {
  const auto& params = d.facts.params;
  Allows all;
  ir::for_each_comparison(m.property, [&](const ir::Block& block, const ir::AtLeast& compare) {
    const auto most = ir::upper_bound(block, compare);
    if (most && most->leaf.kind == ir::Leaf::Kind::altitude) {
      all.most_mm = std::min(all.most_mm.value_or(most->most), most->most);
    }
    const auto least = ir::lower_bound(block, compare, params);
    if (!least) return;
    const std::int64_t need = least->need.strictest;
    if (least->leaf.kind == ir::Leaf::Kind::altitude) {
      all.least_mm = std::max(all.least_mm.value_or(need), need);
    }
    const bool own =
        least->leaf.kind == ir::Leaf::Kind::clearance && ir::ZoneIndex{least->leaf.table} == zone;
    if (own) all.off_mm = std::max(all.off_mm, need);
  });
  return all;
}
// Who goes back on its height leads to no height that another monitor asks for: it does in a zone
// that is no higher, or lower.
std::optional<OtherZone> between_heights(const Subject& s, const ir::Monitor& leads,
                                         const ir::Monitor& asks) {
  const ir::Recovery& last = ir::last_step(leads.recovery);
  const auto from = s.zone_of(last.zone);
  if (!s.decision.body.in_space || !ir::goes_back(last.kind) || !from) return std::nullopt;
  const Allows heights = allowed_by(s.decision, asks, last.zone);
  if (!heights.least_mm && !heights.most_mm) return std::nullopt;
  const bool tall = s.module[last.zone].has_height();
  // above the ground, if nothing else is said
  if (!tall && !heights.most_mm) return std::nullopt;
  const auto around =
      tall ? analysis::layer_around(s.solid(last.zone)) : analysis::Layer{{}, 0, *heights.most_mm};
  const auto layer =
      around ? analysis::between(*around, heights.least_mm, heights.most_mm) : std::nullopt;
  if (!layer) return std::nullopt;
  std::int64_t off_mm = 0;
  for (const ir::Monitor& m : s.decision.monitors) {
    if (m.recovery.name != leads.recovery.name) continue;
    off_mm = std::max(off_mm, allowed_by(s.decision, m, last.zone).off_mm);
  }
  return OtherZone{leads.recovery.name, *from, {{{*from}, off_mm}, {{}, 0, layer}}};
}

}  // namespace

std::vector<Mend> other_recoveries(const Subject& s, const analysis::Arbitration& matrix,
                                   const std::set<std::string>& in_turns) {
  const ir::Decision& d = s.decision;
  const auto takes_turns = [&](const ir::Monitor& m) { return in_turns.contains(m.recovery.name); };
  std::vector<Mend> all;
  // rather who ranks lower follows
  for (auto m = d.monitors.rbegin(); m != d.monitors.rend(); ++m) {
    if (takes_turns(*m)) add_recoveries_of_others(d, *m, takes_turns, all);
  }
  for (std::size_t i = 0; i < d.monitors.size(); ++i) {
    for (std::size_t j = 0; j < d.monitors.size(); ++j) {
      if (i == j || !takes_turns(d.monitors[i]) || !takes_turns(d.monitors[j])) continue;
      for (const analysis::Within& within : matrix[i][j].within) {
        const auto from = s.zone_of(within.from);
        const auto parts = analysis::declared(within.parts, s.zone_of);
        if (from && parts) all.emplace_back(OtherZone{d.monitors[i].recovery.name, *from, *parts});
      }
      if (auto zone = between_heights(s, d.monitors[i], d.monitors[j])) {
        all.emplace_back(*std::move(zone));
      }
    }
  }
  std::set<std::int64_t> limits_mmps;
  for (const ir::Monitor& m : d.monitors) {
    ir::for_each_comparison(m.property, [&](const ir::Block& block, const ir::AtLeast& compare) {
      const auto most = ir::upper_bound(block, compare);
      if (most && most->leaf.kind == ir::Leaf::Kind::speed) limits_mmps.insert(most->most);
    });
  }
  std::set<std::string> tried;
  for (const ir::Monitor& m : d.monitors) {
    if (!takes_turns(m) || !tried.insert(m.recovery.name).second) continue;
    for (const std::int64_t limit : limits_mmps) {
      const std::int64_t mmps = slow_enough_mmps(d, limit);
      const bool is_slower = mmps > 0 && mmps < ir::last_step(m.recovery).speed_mmps;
      if (is_slower) all.emplace_back(SlowerRecovery{m.recovery.name, mmps});
    }
  }
  return all;
}

std::vector<Mend> recoveries_to_its_condition(const Subject& s, std::size_t k) {
  const ir::Decision& d = s.decision;
  const ir::Monitor& m = d.monitors[k];
  const auto moves = [](const ir::Monitor& other) {
    return ir::moves(ir::last_step(other.recovery).kind);
  };
  std::vector<Mend> all;
  add_recoveries_of_others(d, m, moves, all);
  if (!m.return_when || !moves(m)) return all;
  const auto from = s.zone_of(ir::last_step(m.recovery).zone);
  ir::for_each_comparison(*m.return_when, [&](const ir::Block& block, const ir::AtLeast& compare) {
    const auto least = ir::lower_bound(block, compare, d.facts.params);
    if (!least || least->leaf.kind != ir::Leaf::Kind::clearance) return;
    const auto zone = s.zone_of(ir::ZoneIndex{least->leaf.table});
    if (from && zone) all.emplace_back(OtherZone{m.recovery.name, *from, {{{*zone}}}});
  });
  return all;
}

}  // namespace rtac::verify
