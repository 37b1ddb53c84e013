#include "compiler/recheck/on_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/geometry/bake.h"

namespace rtac::recheck {

bool is_convex(const std::vector<geometry::Ring>& rings) {
  if (rings.size() != 1) return false;
  const geometry::Ring& ring = rings.front();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const geometry::Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    for (const geometry::Point& p : ring) {
      if ((b.x - a.x) * (p.y - a.y) < (b.y - a.y) * (p.x - a.x)) return false;
    }
  }
  return true;
}

std::optional<OnGrid> on_grid(const geometry::Region& zone, const Cells& cells) {
  const auto snapped = geometry::snap_inside(zone);
  if (!snapped) return std::nullopt;
  const geometry::Region region = geometry::to_region(*snapped);
  if (region.empty() || !zone.contains(region)) return std::nullopt;
  OnGrid found{segments_of(region), {}, is_convex(region.rings())};
  std::optional<Grid> grid = grid_of(found.edges, cells);
  if (!grid) return std::nullopt;
  // its cells begin at its corner, to the millimetre
  double left = found.edges[0].ax, low = found.edges[0].ay;
  for (const Segment& s : found.edges) left = std::min(left, s.ax), low = std::min(low, s.ay);
  if (std::abs(grid->x - left) > slack_m || std::abs(grid->y - low) > slack_m) return std::nullopt;
  constexpr double hair_mm = 1e-6;  // a length of 0.3 m is no exact double
  for (double& clearance : grid->clearance) {
    if (clearance >= 0) clearance = std::floor((clearance + slack_m) * 1000 + hair_mm) / 1000;
  }
  found.cells = std::move(*grid);
  return found;
}

}  // namespace rtac::recheck
