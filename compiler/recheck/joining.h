// Where ways over cells begin, found once more from exact outlines, in m.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "compiler/recheck/grid.h"

namespace rtac::recheck {

struct JoiningLimits {
  double body;   // with less clearance a robot is nowhere
  double route;  // clearance of the cells that ways lead over
  // From where there is less than `route`, cells as clear as that place itself do, too.
  bool as_clear_as_here;
  double back;   // and with so much clearance control is given back at once
  double reach;  // within this of all cells the one with the shortest way is taken
  // By cell: how long the way on from its middle is; negative: there is none.
  std::vector<double> rest;
  // From a cell where no way begins, how long a leg to where ways end is; nullopt: there is none.
  std::function<std::optional<double>(std::size_t)> straight;
  std::function<bool(std::size_t)> of{};   // the cells that are asked about; none: all
  std::optional<double> middles_within{};  // of a leg's two cells: none is looked for farther off
};
struct Joining {
  std::optional<std::size_t> apart;  // a cell with a place from which none is known to begin
  double longest = 0;                // of the ways with such a leg, the leg included
  std::vector<double> from{};        // by cell: the longest of them; negative: it needs none
};
// Of every place where a body can be, whether a leg leads from there to a cell that is clear
// enough, and loses no more of the clearance than a way may.
Joining joining(const std::vector<Segment>& zone, const Grid& grid, const JoiningLimits& limits);

}  // namespace rtac::recheck
