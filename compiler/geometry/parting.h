// Two robots that stand too near to each other: whether one of them always finds a way out of the
// other's, as recoveries that make room look for it (runtime: yield, passage, grid_route).
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/bake.h"

namespace rtac::geometry {

// Of distances between middles.
struct PartingQuery {
  std::int32_t clearance_mm = 0;  // of the cells that ways lead over, at least
  std::int32_t body_mm = 0;       // with less clearance a robot is nowhere
  std::int32_t nearest_mm = 0;    // no two robots are nearer to each other
  std::int32_t apart_mm = 0;      // at which they need not part
  std::int32_t goal_mm = 0;       // at which a way may end
  std::int32_t stands_mm = 0;     // with less clearance none is put at what is `stuck`
  // Not all corners that were written are on the grid: the recheck does not know each cell to the
  // millimetre, and is to find what is shown.
  bool off_grid = false;
  bool each_alone = false;  // pairs that look alike are each looked at, for tests
  friend bool operator==(const PartingQuery&, const PartingQuery&) = default;
};

struct Parting {
  // too_large: that has not been looked at, for the number of pairs of cells.
  enum class How { shown, stuck, too_large };
  How how = How::shown;
  GridPoint one, other;  // stuck: from about there neither may find a way
};

// Of every two places of the zone where robots can stand nearer than `apart_mm`, whether the search
// for ways finds one for the first robot or else one for the second: to a cell at `goal_mm` from
// the other robot, straight to a cell near the robot and then from cell to cell, no piece of it
// leading nearer to where the other one stands. Of cells only `clearance_mm_lo` counts, of legs
// what they keep off edges.
Parting parting(const std::vector<EdgeRow>& edges, const CellGrid& cells,
                const PartingQuery& query);

}  // namespace rtac::geometry
