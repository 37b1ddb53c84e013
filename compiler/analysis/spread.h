// As geometry/spread.h, of a zone with height.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/analysis/solids.h"

namespace rtac::analysis {

std::optional<std::int64_t> spread_mm(const std::vector<BakedSlab>& within,
                                      const std::vector<BakedSlab>& around);

}  // namespace rtac::analysis
