// How much two boundaries of one zone may disagree about distances.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/geometry/bake.h"

namespace rtac::geometry {

// The signed distance of any place from the boundary of `around` is that from the boundary of
// `within`, which lies in it, or more, by this many mm at most. nullopt: their rings do not
// correspond, or are too many to be compared; nothing is said then.
std::optional<std::int64_t> spread_mm(const std::vector<EdgeRow>& within,
                                      const std::vector<EdgeRow>& around);

}  // namespace rtac::geometry
