// Places that a robot sees: whether straight legs lead to the nearest places with room, as
// recoveries in space look for them on a level (runtime: space).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/geometry/bake.h"

namespace rtac::geometry {

struct SightQuery {
  std::int32_t aim_mm = 0;        // clearance of the cells that legs lead to, at least
  std::int32_t clearance_mm = 0;  // that legs keep, or that of where they begin
  std::int32_t body_mm = 0;       // with less clearance a robot is nowhere
};

struct Sight {
  // too_large: that has not been looked at, for the number of cells.
  enum class How { clear, hidden, too_large };
  How how = How::clear;
  GridPoint place;  // hidden: from about there
};

// Of every place where a body can be, whether a cell is in sight such that all cells with room
// which may be as near are in sight, too: whichever of them is tried first does. Of cells only
// `clearance_mm_lo` counts.
Sight sight(const std::vector<EdgeRow>& edges, const CellGrid& cells, const SightQuery& query);

}  // namespace rtac::geometry
