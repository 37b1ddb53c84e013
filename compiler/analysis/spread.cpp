#include "compiler/analysis/spread.h"

#include <algorithm>

#include "compiler/geometry/spread.h"

namespace rtac::analysis {

// Where floors and ceilings agree, places disagree by no more than in the plane: walls are as far
// apart, and what is floor of one alone ends at a wall of the other.
std::optional<std::int64_t> spread_mm(const std::vector<BakedSlab>& within,
                                      const std::vector<BakedSlab>& around) {
  const auto same_heights = [](const BakedSlab& a, const BakedSlab& b) {
    return a.floor_mm == b.floor_mm && a.ceiling_mm == b.ceiling_mm;
  };
  if (!std::ranges::equal(within, around, same_heights)) return std::nullopt;
  std::optional<std::int64_t> most = 0;
  for (std::size_t k = 0; k < within.size() && most; ++k) {
    const auto of_slab = geometry::spread_mm(within[k].edges, around[k].edges);
    most = of_slab ? std::optional(std::max(*most, *of_slab)) : std::nullopt;
  }
  return most;
}

}  // namespace rtac::analysis
