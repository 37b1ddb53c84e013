#include "compiler/analysis/by_border.h"

#include <algorithm>
#include <cstdlib>

#include "compiler/analysis/keeps_off.h"
#include "compiler/analysis/led_from.h"
#include "compiler/analysis/limits.h"
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
  const ir::ZoneTable& zone = at.module[ir::last_step(driving.recovery).zone];
  const auto led = led_from(kind, at.module, at.decision, driving);
  if (!led || !starts_within(at, ir::last_step(driving.recovery).zone)) return std::nullopt;
  const Depths depths(zone.cells);
  std::int64_t most_mm = led->aims_mm;
  for (std::size_t cell = 0; cell < led->from_mm.size(); ++cell) {
    const std::int64_t way_mm = led->from_mm[cell];
    if (way_mm >= 0) most_mm = std::max(most_mm, depths.within(cell, way_mm));
  }
  return most_mm + led->strays_mm + at.decision.body.radius_mm;
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
