#include "compiler/analysis/led_in_height.h"

#include <algorithm>

#include "compiler/analysis/standoffs.h"

namespace rtac::analysis {
namespace {

// How much room who loiters looks for beyond what it needs, for its laps (LoiterManoeuvre).
constexpr std::int64_t lap_mm = 500;
// Of lengths that are rounded up to millimetres, here and where certificates are checked.
constexpr std::int64_t rounding_mm = 20;

// The most clearance that it looks for: with less of it, it may set out up or down. It has the
// standoffs that count in this zone; those of all zones come on top, as a recheck counts them.
std::int64_t looks_for_mm(const ir::Body& body, const ir::Recovery& step) {
  const std::int64_t sway_mm = body.end_reach_mm;
  const std::int64_t most_mm = std::max(step.return_clearance_mm, step.route_clearance_mm);
  if (step.kind != ir::RecoveryKind::loiter) return most_mm + sway_mm;
  return most_mm + 2 * sway_mm + 2 * body.position_error_mm + lap_mm;
}
std::int64_t most_standoff_mm(const ir::Decision& decision) {
  std::int64_t most_mm = 0;
  for (const ir::Monitor& m : decision.monitors) {
    for (const Standoff& each : fence_standoffs(m.property, decision.facts.params)) {
      most_mm = std::max(most_mm, each.mm);
    }
  }
  return most_mm;
}

}  // namespace

std::pair<std::int64_t, std::int64_t> led_between_mm(const ir::Decision& decision,
                                                     const ir::Recovery& step,
                                                     const ir::ZoneTable& zone) {
  const std::int64_t floor_mm = zone.slabs.front().floor_mm;
  const std::int64_t ceiling_mm = zone.slabs.back().ceiling_mm;
  const bool asks = std::ranges::any_of(
      decision.monitors, [](const ir::Monitor& m) { return m.return_when.has_value(); });
  if (!decision.body.in_space || step.claims || !ir::goes_back(step.kind) || asks ||
      zone.slabs.size() != 1) {
    return {floor_mm, ceiling_mm};
  }
  const std::int64_t strays_mm = step.route_clearance_mm - decision.body.radius_mm;
  const std::int64_t led_mm =
      looks_for_mm(decision.body, step) + most_standoff_mm(decision) + strays_mm + rounding_mm;
  return {std::max(ceiling_mm - led_mm, floor_mm), std::min(floor_mm + led_mm, ceiling_mm)};
}

}  // namespace rtac::analysis
