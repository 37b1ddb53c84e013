#include "compiler/analysis/led_from.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "compiler/analysis/asked_ways.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/in_sight.h"
#include "compiler/analysis/keeps_off.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/liveness.h"
#include "compiler/analysis/tables.h"
#include "compiler/analysis/travel.h"

namespace rtac::analysis {
namespace {

using Lengths = std::optional<std::vector<std::int64_t>>;

// By a leg in sight that is taken whatever the search finds, or else by that or a way over cells.
Lengths lengths_from(const std::vector<geometry::EdgeRow>& edges, const ir::Module& module,
                     const ir::Decision& decision, const ir::Recovery& retreat) {
  const ir::ZoneTable& zone = module[retreat.zone];
  const Ways ways = ways_of(module, decision, retreat);
  const auto in = led_in(edges, zone.cells, decision, retreat);
  if (!ways.longest_mm || !ways.deeper_mm || !ways.stranded.empty() || !in) return std::nullopt;
  InSight legs(edges, zone.cells, decision, retreat);
  const std::int64_t deepest_mm = goals_mm(decision, retreat).back();
  const auto& clearance_mm = zone.cells.clearance_mm_lo;
  std::vector<std::int64_t> all(clearance_mm.size(), -1);
  for (std::size_t at = 0; at < all.size(); ++at) {
    if (clearance_mm[at] >= retreat.return_clearance_mm || !legs.holds_some(at)) continue;
    const auto leg_mm = legs.surely_taken_mm(at);
    all[at] = leg_mm.value_or(std::max({2 * deepest_mm, ways.from_mm[at], *ways.deeper_mm}));
    if (!in->from_mm.empty()) all[at] = std::max(all[at], in->from_mm[at]);
  }
  return all;
}

bool is_retreat(const ir::Module& module, const ir::Decision& d, const ir::Recovery& recovery) {
  const auto steps = ir::steps_of(recovery);
  const ir::Recovery& last = ir::last_step(recovery);
  const bool brakes_before =
      std::all_of(steps.begin(), std::prev(steps.end()),
                  [](const ir::Recovery* step) { return step->kind == ir::RecoveryKind::brake; });
  return last.kind == ir::RecoveryKind::retreat && !last.claims && brakes_before &&
         !d.body.in_space && !module[last.zone].has_height();
}

}  // namespace

std::optional<Led> led_from(const sema::RobotKind& kind, const ir::Module& module,
                            const ir::Decision& decision, const ir::Monitor& driving) {
  const bool alone = decision.robots == 1 && !decision.open_fleet;
  if (!alone || !is_retreat(module, decision, driving.recovery)) return std::nullopt;
  const ir::Recovery& retreat = ir::last_step(driving.recovery);
  // somebody may have broken before what the robot has where its ways begin
  if (!relied_on(decision, driving) && starts_off_mm(decision, retreat) > 0) return std::nullopt;
  const ir::ZoneTable& zone = module[retreat.zone];
  const std::int64_t aims_mm = goals_mm(decision, retreat).back();
  // where the tables bound distances from below alone, it is not measured to be as clear as it is
  const auto exact_mm = zone.tree.exact_inside_mm;
  if (exact_mm && *exact_mm < std::max(aims_mm, retreat.route_clearance_mm)) return std::nullopt;
  const std::vector<geometry::EdgeRow> edges = edges_of(zone);
  thread_local geometry::Kept<AskedWays, Lengths> kept;
  Lengths lengths = kept.find(AskedWays(edges, zone.cells, decision, retreat),
                              [&] { return lengths_from(edges, module, decision, retreat); });
  if (!lengths) return std::nullopt;
  const ir::Body& body = decision.body;
  const Rational speed(static_cast<long>(retreat.speed_mmps), 1000);
  constexpr std::int64_t grid_mm = 10;
  const std::int64_t strays_mm = run_out_mm(kind, speed, decision.period_us) +
                                 beside_leg_mm(decision, retreat) + 3 * body.position_error_mm +
                                 body.end_reach_mm + off_hold_mm(body) + body.hold_mm + grid_mm;
  return Led{std::move(*lengths), strays_mm, aims_mm};
}

}  // namespace rtac::analysis
