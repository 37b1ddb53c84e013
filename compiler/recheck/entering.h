// Straight ways into a zone from outside of it, once more, and what they keep from the boundary of
// a fence (docs/templates.md, retreat). In m.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "compiler/recheck/zones.h"

namespace rtac::recheck {

struct EnteringLimits {
  double clearance;  // to keep from the boundary of the fence, or what one has
  double body;       // with less clearance in the fence a robot is nowhere
  double least;      // clearance of the cells that ways lead to, at least
  double tested;     // and of those that count among the ones that are tried
  double kept;       // of the clearance in the zone that a way begins with, at most
  double loss;       // how much farther from the zone a way may lead than it begins
  // How far from the boundary of the zone ways end that lead straight away from the nearest place
  // of it, or in through that, at least and at most; 0: there.
  double straight_least = 0, straight_most = 0;
  // Of a robot that no other one is in the way of: the clearance that it looks for first, and how
  // far off it considers all cells.
  struct Alone {
    double aim, reach;
  };
  std::optional<Alone> alone{};
  // How far all of the zone is from the boundary of the fence, at least; of one that reaches beyond
  // it less than 0. none: it lies in the fence.
  std::optional<double> depth{};
  // Nobody is farther than so much from these; none: a body may be anywhere in the fence. The zone
  // lies in that.
  std::vector<geometry::Region> starts{};
  double starts_off = 0;
};
// A place from which a way that is straight may come too near to the boundary of the fence; none:
// there is none. `BadCells`: the cells are not those of the zone, or there are too many ways.
std::variant<std::optional<geometry::Point>, BadCells> enters_beyond(const geometry::Region& zone,
                                                                     const Cells& cells,
                                                                     const geometry::Region& fence,
                                                                     const EnteringLimits& limits);

}  // namespace rtac::recheck
