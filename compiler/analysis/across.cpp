#include "compiler/analysis/across.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "compiler/analysis/recovery_places.h"

namespace rtac::analysis {

std::optional<std::int64_t> farthest_apart_mm(const ir::Module& module, bool in_space,
                                              const ExactZones& exact, ir::ZoneIndex fence,
                                              std::int64_t clearance_mm) {
  constexpr std::size_t corners_most = 2'000;
  constexpr std::int64_t offset_mm = 2;  // by which an offset may be smaller
  const ir::ZoneTable& zone = module[fence];
  const std::int64_t by_mm = std::max<std::int64_t>(clearance_mm - offset_mm, 0);
  std::vector<std::pair<double, double>> corners;
  const auto add = [&](const geometry::Region& region) {
    const auto deep = within(region, by_mm);
    if (!deep) return false;
    for (const geometry::Ring& ring : deep->rings()) {
      for (const geometry::Point& p : ring) corners.emplace_back(p.x.get_d(), p.y.get_d());
    }
    return corners.size() <= corners_most;
  };
  double up_mm = 0;
  if (zone.has_height()) {
    const geometry::Solid solid = exact.solid(fence);
    if (solid.slabs().empty()) return std::nullopt;
    const Rational high = solid.slabs().back().ceiling - solid.slabs().front().floor;
    up_mm = std::max(0.0, 1000 * high.get_d() - 2 * static_cast<double>(by_mm));
    for (const geometry::Slab& slab : solid.slabs()) {
      if (!add(slab.region)) return std::nullopt;
    }
  } else if (in_space || zone.edges.empty() || !add(exact.flat(fence))) {
    return std::nullopt;
  }
  double most_m = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      most_m = std::max(most_m, std::hypot(corners[i].first - corners[k].first,
                                           corners[i].second - corners[k].second));
    }
  }
  return std::llround(std::ceil(std::hypot(1000 * most_m, up_mm)));
}

}  // namespace rtac::analysis
