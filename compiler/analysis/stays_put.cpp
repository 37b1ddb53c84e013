#include "compiler/analysis/stays_put.h"

#include <algorithm>

#include "compiler/analysis/fences.h"

namespace rtac::analysis {

std::optional<Standoff> stays_put(const ir::Module& module, const ir::Decision& decision,
                                  const ExactZone& exact, const ir::Monitor& driving,
                                  const ir::Recovery& step, const ir::Monitor& judged) {
  if (&driving == &judged || step.kind != ir::RecoveryKind::retreat || step.claims ||
      decision.body.in_space || module[step.zone].has_height()) {
    return std::nullopt;
  }
  // what is asked beyond a clearance may have it lead elsewhere
  const bool asks = std::ranges::any_of(decision.monitors, [&](const ir::Monitor& m) {
    return m.recovery.name == driving.recovery.name && m.return_when.has_value();
  });
  if (asks) return std::nullopt;
  // as measured, and on the grid of zones
  constexpr std::int64_t grid_mm = 4;
  const std::int64_t deep_mm = step.return_clearance_mm + decision.body.position_error_mm + grid_mm;
  std::optional<geometry::Region> deep;
  for (const ir::ZoneIndex fence : sure_fences(judged.property, decision.facts.params)) {
    if (module[fence].has_height() || fence == step.zone) continue;
    if (!exact(step.zone).contains(exact(fence))) continue;  // an offset takes longer
    if (!deep) deep = within(exact(step.zone), deep_mm);
    if (!deep) return std::nullopt;
    if (deep->contains(exact(fence))) return Standoff{fence, deep_mm};
  }
  return std::nullopt;
}

}  // namespace rtac::analysis
