// From outside of its zone a recovery makes straight for it (runtime/core: retreat, grid_route):
// what it crosses on that way, and from where it finds none. And where its ways within lead out of
// another zone.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/geometry/region.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

struct PlaceMm {
  std::int64_t x_mm = 0, y_mm = 0;
};
struct WaysIn {
  struct Leaves {
    PlaceMm from, at;
  };
  std::optional<Leaves> leaves;     // a way that is taken leads out of what is allowed
  std::optional<PlaceMm> stranded;  // no way in, where control is not given back either
};

// Of the places of `from`, which lie outside of the zone of `step`, a few thousand at most, along
// its boundary and within: the ways that the runtime takes from there, by the same rules. What is
// found is there; what lies between these places is not looked at. `allowed`: the centres of bodies
// that the property allows.
WaysIn ways_in(const ir::Module& module, const ir::Decision& decision, const ir::Recovery& step,
               const geometry::Region& from, const geometry::Region& allowed);

// Of the places of `from` in the zone of `step` where control is not given back, those from which
// the way that the runtime takes, with nobody on it, leads out of `allowed`: `most` of them, the
// worst first. For runs that may show it: a way of the runtime may differ by some cells.
// `run_out_mm`: how far a retreat goes on where there is room (travel.h).
std::vector<WaysIn::Leaves> ways_out(const ir::Module& module, const ir::Decision& decision,
                                     const ir::Recovery& step, std::int64_t run_out_mm,
                                     const geometry::Region& from, const geometry::Region& allowed,
                                     std::size_t most);

// Of a route in a convex zone, from places of `from` in it: its way is straight.
std::optional<WaysIn::Leaves> straight_across(const ir::Module& module, const ir::Recovery& step,
                                              const geometry::Region& from,
                                              const geometry::Region& allowed);

}  // namespace rtac::analysis
