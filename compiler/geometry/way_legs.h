// How many straight legs the ways have that a search over cells finds (runtime: grid_route), which
// leads on from each place of a way to the last of its cells in plain sight.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/geometry/bake.h"

namespace rtac::geometry {

struct WayLegsQuery {
  // A way leads over cells as clear as `route_mm`, or as the place that it starts from, which has
  // `least_mm`; to the nearest cell as clear as one of the goals asks for, each by itself.
  std::int32_t least_mm = 0, route_mm = 0;
  std::vector<std::int32_t> goals_mm;
  bool operator==(const WayLegsQuery&) const = default;
};

// The most legs from the middle of any cell on; whichever of the ways it finds that are as short.
// Whatever lies in a rectangle of clear cells is in sight of each other: a way has no more legs
// than it takes such rectangles to cover it, one after the other, with a cell in common. nullopt:
// that takes too long, or ways are so long that rounding may prefer longer ones.
std::optional<int> most_legs(const CellGrid& cells, const WayLegsQuery& query);
// The same of ways over cells as clear as `route_mm` to the cell that holds a site, and in that to
// the site itself. nullopt as well: that cell is not as clear.
std::optional<int> most_legs_to(const CellGrid& cells, std::int32_t route_mm, GridPoint site);

}  // namespace rtac::geometry
