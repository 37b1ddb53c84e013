// Straight ways into a zone from outside of it: what they keep from the boundary of a fence around
// it (runtime: retreat, grid_route).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/geometry/bake.h"
#include "compiler/geometry/region.h"

namespace rtac::geometry {

// A zone as its table has it.
struct Table {
  std::vector<EdgeRow> edges;
  CellGrid cells;  // of its clearances only the lower ones count
};
struct EntryQuery {
  std::int32_t clearance_mm = 0;  // to keep from the boundary of the fence, or what one has
  std::int32_t body_mm = 0;       // with less clearance in the fence a robot is nowhere
  std::int32_t least_mm = 0;      // clearance of the cells of the zone that ways lead to, at least
  std::int32_t tested_mm = 0;     // and of those that count among the ones that it tries
  std::int32_t kept_mm = 0;       // of the clearance in the zone that a way begins with, at most
  std::int32_t loss_mm = 0;       // how much farther from the zone a way may lead than it begins
  // How far from the boundary of the zone a way ends that leads straight away from the nearest
  // place of it, or in through that, farthest first; 0: there.
  std::vector<std::int32_t> straight_mm{0};
  // Of a robot that no other one is in the way of: the clearance that it looks for first, and how
  // far off it considers all cells, whatever is nearest. none: of others anything may be.
  struct Alone {
    std::int32_t aim_mm = 0, reach_mm = 0;
  };
  std::optional<Alone> alone{};
  // How far all of the zone is from the boundary of the fence, at least; of one that reaches beyond
  // that less than 0. none: it lies in the fence, as far as that is.
  std::optional<std::int32_t> depth_mm{};
  // Where bodies may be seen; none: everywhere in the fence.
  std::optional<Region> starts{};
};

struct Entry {
  // too_large: that has not been looked at, for the number of cells.
  enum class How { within, beyond, too_large };
  How how = How::within;
  GridPoint place;  // beyond: from about there
};

// Of every place in the fence where a body can be, but does not fit in the zone, whether each way
// that is straight stays as clear of the fence as is asked: through the nearest place of its
// boundary, and to each cell of it near enough to be tried which leads nowhere farther from it, or
// in it nearer to its boundary; of a robot that is alone, to none beyond the nearest one that is
// surely seen.
Entry entry(const Table& zone, const Table& fence, const EntryQuery& query);

}  // namespace rtac::geometry
