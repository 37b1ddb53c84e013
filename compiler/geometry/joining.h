// Where a way over cells may begin (runtime: grid_route): straight from a place to the middle of a
// cell that is clear enough.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/bake.h"

namespace rtac::geometry {

// Of a cell from which no way leads on.
constexpr std::int64_t no_way_mm = -1;

struct JoinQuery {
  std::int32_t route_mm = 0;  // clearance of the cells that a way leads over
  std::int32_t body_mm = 0;   // with less clearance a robot is nowhere
  // From where there is less than `route_mm`, cells as clear as that place itself do, too.
  bool as_clear_as_here = false;
  std::int32_t return_mm = 0;  // and with so much clearance control is given back at once
  // Within this of all cells the one with the shortest way is taken, and else the nearest one.
  std::int32_t reach_mm = 0;
  std::vector<std::int64_t>
      rest_mm;  // by cell: how long the way on is from its middle, or no_way_mm
  bool operator==(const JoinQuery&) const = default;
};

struct Joins {
  // By cell: from some place of it, as far as is known, no way begins.
  std::vector<bool> apart;
  std::vector<bool> unseen;          // by cell: that is because to find one would take too long
  std::int64_t longest_mm = 0;       // of the ways that begin with a leg, the leg included
  std::vector<std::int64_t> way_mm;  // by cell: the longest of them; 0: none begins so
};

// From all places of all cells where a body can be. Of cells only `clearance_mm_lo` counts.
Joins joins(const std::vector<EdgeRow>& edges, const CellGrid& cells, const JoinQuery& query);

}  // namespace rtac::geometry
