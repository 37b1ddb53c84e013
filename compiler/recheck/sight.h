// Places that a robot in space sees on its level, once more: docs/templates.md, in space, retreat.
#pragma once

#include <optional>
#include <variant>

#include "compiler/recheck/zones.h"

namespace rtac::recheck {

struct SightLimits {
  double aim;    // clearance of the cells that legs lead to
  double route;  // that legs keep, or that of where they begin
  double body;   // with less clearance a robot is nowhere
};
// A place from which the nearest cells with room may not be in sight; none: there is none.
// `BadCells`: the cells are not those of the zone, or there are too many of them.
std::variant<std::optional<geometry::Point>, BadCells> out_of_sight(const geometry::Region& zone,
                                                                    const Cells& cells,
                                                                    const SightLimits& limits);

}  // namespace rtac::recheck
