#include "compiler/analysis/by_border.h"

#include <algorithm>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/keeps_off.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/liveness.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/tables.h"
#include "compiler/analysis/travel.h"
#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

// How far from the boundary it is led, by legs that are straight or over cells, but for what it
// strays by. It sets out where it is measured to be less clear than control takes.
std::optional<ByBorder> led_by(const ir::Module& module, const ir::Decision& decision,
                               const ir::Recovery& retreat) {
  const ir::ZoneTable& zone = module[retreat.zone];
  const auto in = led_in(edges_of(zone), zone.cells, decision, retreat);
  if (!in) return std::nullopt;
  ByBorder by;
  by.led_in_mm = std::max(in->first_mm, in->all_mm);
  by.leg = straight_leg(module, decision, retreat);
  if (by.leg) {
    by.near_mm = by.leg->deepest_mm;
  } else {
    const Ways ways = ways_of(module, decision, retreat);
    if (!ways.longest_mm || !ways.stranded.empty()) return std::nullopt;
    by.near_mm = retreat.return_clearance_mm + *ways.longest_mm + joins_within_mm(zone.cells);
  }
  by.near_mm = std::max(by.near_mm, decision.body.radius_mm + by.led_in_mm);
  return by;
}

// It fails nowhere but near the boundary of the zone, or because its robot is fast there.
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

std::optional<ByBorder> by_border(const sema::RobotKind& kind, const TakeOver& at,
                                  const ir::Monitor& driving) {
  const ir::Decision& decision = at.decision;
  const ir::Recovery& retreat = driving.recovery;
  const bool plain = retreat.kind == ir::RecoveryKind::retreat && !retreat.claims;
  if (!plain || decision.body.in_space || at.module[retreat.zone].has_height() ||
      decision.robots != 1 || decision.open_fleet) {
    return std::nullopt;
  }
  // ways are known from where it fits with what its own monitor keeps
  const auto& params = decision.facts.params;
  const std::int64_t keeps_mm = standoff_mm(decision, retreat);
  const bool has_it = relied_on(decision, driving) &&
                      surely_off_mm(driving.property, params, retreat.zone) >= keeps_mm;
  if (keeps_mm > touching_mm && !has_it) return std::nullopt;
  if (!starts_within(at, retreat.zone)) return std::nullopt;
  auto by = led_by(at.module, decision, retreat);
  if (!by) return std::nullopt;
  const ir::Body& body = decision.body;
  const Rational speed(static_cast<long>(retreat.speed_mmps), 1000);
  constexpr std::int64_t grid_mm = 10;
  by->near_mm += run_out_mm(kind, speed, decision.period_us) + beside_leg_mm(decision, retreat) +
                 3 * body.position_error_mm + body.end_reach_mm + off_hold_mm(body) + body.hold_mm +
                 body.radius_mm + grid_mm;
  return by;
}

std::optional<std::int64_t> let_go_within_mm(const sema::RobotKind& kind, const TakeOver& at,
                                             std::size_t k) {
  const ir::Decision& d = at.decision;
  const ir::Recovery& retreat = d.monitors[k].recovery;
  // a look-ahead under commands may fail elsewhere
  const auto by = ir::judges_commands(d) ? std::nullopt : by_border(kind, at, d.monitors[k]);
  if (!by) return std::nullopt;
  std::int64_t ahead_us = 0, asked_mm = 0;
  for (const ir::Monitor& m : d.monitors) {
    if (m.recovery.name != retreat.name) continue;
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
  return std::max(by->near_mm, brakes_mm);
}

bool border_lies_deep(const TakeOver& at, ir::ZoneIndex zone, std::int64_t near_mm,
                      const Standoff& fence) {
  if (at.module[fence.zone].has_height()) return false;
  const auto middle = within(at.exact(zone), near_mm);
  if (!middle) return false;
  return region_lies_deep(at.exact(zone).subtract(*middle), at.exact(fence.zone), fence.mm);
}

}  // namespace rtac::analysis
