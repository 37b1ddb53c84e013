#include "compiler/analysis/by_border.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <utility>
#include <vector>

#include "compiler/analysis/asked_ways.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/in_sight.h"
#include "compiler/analysis/keeps_off.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/liveness.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/tables.h"
#include "compiler/analysis/travel.h"
#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

// Cells by how far their places may be from the boundary of the zone.
class Depths {
 public:
  explicit Depths(const ir::Cells& cells)
      : cells_(cells), across_mm_((3 * cells.cell_mm + 1) / 2) {}
  // Of all places no farther than `mm` from some place of the cell.
  [[nodiscard]] std::int64_t within(std::size_t at, std::int64_t mm) const {
    const std::int64_t columns = cells_.columns, rows = cells_.rows, size_mm = cells_.cell_mm;
    const auto column = static_cast<std::int64_t>(at) % columns;
    const auto row = static_cast<std::int64_t>(at) / columns;
    const std::int64_t around = mm / size_mm + 1;
    std::int64_t most = 0;
    for (auto r = std::max<std::int64_t>(0, row - around); r <= std::min(rows - 1, row + around);
         ++r) {
      for (auto c = std::max<std::int64_t>(0, column - around);
           c <= std::min(columns - 1, column + around); ++c) {
        const std::int64_t depth = depth_mm(static_cast<std::size_t>(r * columns + c));
        if (depth <= most) continue;
        const std::int64_t dx = gap_mm(c, column), dy = gap_mm(r, row);
        if (dx * dx + dy * dy <= mm * mm) most = depth;
      }
    }
    return std::min(most, depth_mm(at) + mm);
  }

 private:
  [[nodiscard]] std::int64_t depth_mm(std::size_t at) const {
    return std::max<std::int64_t>(cells_.clearance_mm_lo[at], 0) + across_mm_;
  }
  // Between two columns, or rows.
  [[nodiscard]] std::int64_t gap_mm(std::int64_t a, std::int64_t b) const {
    return std::max<std::int64_t>(std::abs(a - b) - 1, 0) * cells_.cell_mm;
  }

  const ir::Cells& cells_;
  const std::int64_t across_mm_;
};

// How far from the boundary it is led, but for what it strays by: no farther from where it sets out
// than its way is long, which is where it is measured to be less clear than control takes.
std::optional<std::int64_t> found_within_mm(const std::vector<geometry::EdgeRow>& edges,
                                            const ir::ZoneTable& zone, const ir::Module& module,
                                            const ir::Decision& decision,
                                            const ir::Recovery& retreat) {
  const Ways ways = ways_of(module, decision, retreat);
  const auto in = led_in(edges, zone.cells, decision, retreat);
  if (!ways.longest_mm || !ways.deeper_mm || !ways.stranded.empty() || !in) return std::nullopt;
  InSight legs(edges, zone.cells, decision, retreat);
  const Depths depths(zone.cells);
  const std::int64_t deepest_mm = goals_mm(decision, retreat).back();
  // where the tables bound distances from below alone, it is not measured to be as clear as it is
  const auto exact_mm = zone.tree.exact_inside_mm;
  if (exact_mm && *exact_mm < std::max(deepest_mm, retreat.route_clearance_mm)) return std::nullopt;
  std::int64_t most_mm = deepest_mm;
  for (std::size_t at = 0; at < zone.cells.clearance_mm_lo.size(); ++at) {
    if (zone.cells.clearance_mm_lo[at] >= retreat.return_clearance_mm || !legs.holds_some(at))
      continue;
    const auto leg_mm = legs.surely_taken_mm(at);
    std::int64_t way_mm =
        leg_mm.value_or(std::max({2 * deepest_mm, ways.from_mm[at], *ways.deeper_mm}));
    if (!in->from_mm.empty()) way_mm = std::max(way_mm, in->from_mm[at]);
    most_mm = std::max(most_mm, depths.within(at, way_mm));
  }
  return most_mm;
}
std::optional<std::int64_t> led_within_mm(const ir::Module& module, const ir::Decision& decision,
                                          const ir::Recovery& retreat) {
  const ir::ZoneTable& zone = module[retreat.zone];
  const std::vector<geometry::EdgeRow> edges = edges_of(zone);
  thread_local geometry::Kept<AskedWays, std::optional<std::int64_t>> kept;
  return kept.find(AskedWays(edges, zone.cells, decision, retreat),
                   [&] { return found_within_mm(edges, zone, module, decision, retreat); });
}

// What it asks for are clearances of the zone alone: it fails nowhere but near the boundary.
bool asks_for_zone_alone(const ir::Decision& d, const ir::Block& block, ir::ValueId id,
                         ir::ZoneIndex zone) {
  const ir::Op& op = block[id].op;
  if (const auto* both = std::get_if<ir::And>(&op)) {
    return asks_for_zone_alone(d, block, both->a, zone) &&
           asks_for_zone_alone(d, block, both->b, zone);
  }
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  if (compare == nullptr) return false;
  const auto bound = ir::lower_bound(block, *compare, d.facts.params);
  return bound && bound->leaf.kind == ir::Leaf::Kind::clearance &&
         ir::ZoneIndex{bound->leaf.table} == zone;
}

}  // namespace

std::optional<std::int64_t> by_border_mm(const sema::RobotKind& kind, const TakeOver& at,
                                         const ir::Monitor& driving) {
  const ir::Decision& decision = at.decision;
  const ir::Recovery& retreat = ir::last_step(driving.recovery);
  const auto steps = ir::steps_of(driving.recovery);
  const bool brakes_before =
      std::all_of(steps.begin(), std::prev(steps.end()),
                  [](const auto* step) { return step->kind == ir::RecoveryKind::brake; });
  if (retreat.kind != ir::RecoveryKind::retreat || retreat.claims || !brakes_before ||
      decision.body.in_space || at.module[retreat.zone].has_height() || decision.robots != 1 ||
      decision.open_fleet || !starts_within(at, retreat.zone)) {
    return std::nullopt;
  }
  const auto led_mm = led_within_mm(at.module, decision, retreat);
  if (!led_mm) return std::nullopt;
  const ir::Body& body = decision.body;
  const Rational speed(static_cast<long>(retreat.speed_mmps), 1000);
  constexpr std::int64_t grid_mm = 10;
  return *led_mm + run_out_mm(kind, speed, decision.period_us) + beside_leg_mm(decision, retreat) +
         3 * body.position_error_mm + body.end_reach_mm + off_hold_mm(body) + body.hold_mm +
         body.radius_mm + grid_mm;
}

std::optional<std::int64_t> let_go_within_mm(const sema::RobotKind& kind, const TakeOver& at,
                                             std::size_t k) {
  const ir::Decision& d = at.decision;
  const ir::Recovery& retreat = ir::last_step(d.monitors[k].recovery);
  // a look-ahead under commands may fail elsewhere
  const auto near_mm =
      ir::judges_commands(d) ? std::nullopt : by_border_mm(kind, at, d.monitors[k]);
  if (!near_mm) return std::nullopt;
  std::int64_t ahead_us = 0, asked_mm = 0;
  for (const ir::Monitor& m : d.monitors) {
    if (m.recovery.name != d.monitors[k].recovery.name) continue;
    const auto asks = [&](const ir::Block& says) {
      return asks_for_zone_alone(d, says, says.result, retreat.zone);
    };
    if (!asks(m.property) || (m.return_when && !asks(*m.return_when))) {
      return std::nullopt;
    }
    ahead_us = std::max(ahead_us, m.lookahead.duration_us);
    asked_mm = std::max(asked_mm, fence_standoff_mm(m.property, d.facts.params, retreat.zone));
  }
  // a look-ahead that fails covers the stop as well, whichever way that leads
  const std::int64_t fails_mm =
      cruise_clearance_mm(d, d.motions[0], ahead_us + d.return_extra_us) + asked_mm;
  const std::int64_t brakes_mm = std::max(2 * fails_mm, fails_mm + retreat.return_clearance_mm) +
                                 off_hold_mm(d.body) + d.body.hold_mm;
  return std::max(*near_mm, brakes_mm);
}

bool border_lies_deep(const TakeOver& at, ir::ZoneIndex zone, std::int64_t near_mm,
                      const Standoff& fence) {
  if (at.module[fence.zone].has_height()) return false;
  const auto middle = within(at.exact(zone), near_mm);
  if (!middle) return false;
  return region_lies_deep(at.exact(zone).subtract(*middle), at.exact(fence.zone), fence.mm);
}

}  // namespace rtac::analysis
