#include "compiler/analysis/effort.h"

#include <algorithm>
#include <cmath>

namespace rtac::analysis {

// Measured over some dozens of specifications of 5'000 to 200'000 cells, within a factor of three.
std::int64_t effort_of(const ir::Module& module, bool same_zones) {
  constexpr std::int64_t of_any = 1'000, edges_in_a_step = 300;
  std::int64_t steps = of_any;
  for (const ir::Decision& d : module.decisions) {
    for (const ir::Monitor& m : d.monitors) {
      const ir::Recovery& last = ir::last_step(m.recovery);
      const bool over_cells = !d.on_plan && !d.body.in_space && ir::moves(last.kind);
      if (over_cells) steps += std::int64_t(module[last.zone].cells.clearance_mm_lo.size());
    }
  }
  for (const ir::ZoneTable& zone : module.zones) {
    if (same_zones) break;
    steps += std::int64_t(zone.cells.clearance_mm_lo.size() * zone.edges.size()) / edges_in_a_step;
  }
  return steps;
}

std::int64_t effort_of_looks(std::int64_t looks) {
  constexpr std::int64_t looks_in_a_step = 400;
  return looks / looks_in_a_step;
}

std::int64_t effort_of_pairs(const ir::Module& module) {
  constexpr double pairs_in_a_step = 700;
  double pairs = 0;
  for (const ir::Decision& d : module.decisions) {
    for (const ir::Monitor& m : d.monitors) {
      const ir::Recovery& last = ir::last_step(m.recovery);
      if (last.kind != ir::RecoveryKind::yield) continue;
      const auto& cells = module[last.zone].cells;
      const double all = double(cells.clearance_mm_lo.size());
      const double across = 2.0 * double(last.pass_gap_mm) / cells.cell_mm;
      pairs += all * std::min(all, across * across) / 2;
    }
  }
  return std::llround(pairs / pairs_in_a_step);
}

}  // namespace rtac::analysis
