#include "compiler/analysis/share.h"

#include <algorithm>

namespace rtac::analysis {

std::optional<Share> share_of(const ir::ZoneTable& zone, std::int64_t body_mm,
                              std::int64_t any_speed_mm, std::int64_t return_mm) {
  const auto& cells = zone.cells.clearance_mm_lo;
  const auto cells_with = [&](std::int64_t least_mm) {
    return std::count_if(cells.begin(), cells.end(), [&](auto mm) { return mm >= least_mm; });
  };
  const auto room = cells_with(std::max<std::int64_t>(body_mm, 1));
  if (zone.has_height() || room == 0) return std::nullopt;
  return Share{static_cast<int>(100 * cells_with(any_speed_mm) / room),
               static_cast<int>(100 * cells_with(return_mm) / room)};
}

}  // namespace rtac::analysis
