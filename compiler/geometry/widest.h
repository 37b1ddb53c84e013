// The place of largest clearance. Internal to this folder.
#pragma once

#include <vector>

#include "compiler/geometry/cell_distance.h"

namespace rtac::geometry {

struct Widest {
  GridPoint at;
  std::int32_t clearance_mm = 0;  // rounded down
};

// Within 1 mm of the largest clearance. Where thousands of metres of corridor are equally wide the
// search stops after a fixed number of steps, with a place that may be a few mm narrower; the
// clearance is always that of the place. `edges` is not empty.
Widest find_widest(const std::vector<PreparedEdge>& edges);

}  // namespace rtac::geometry
