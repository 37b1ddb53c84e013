// From outside of its zone a recovery makes straight for it, whatever lies between (runtime:
// retreat, grid_route, space): what it keeps on that way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/analysis/recoveries_in_space.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// Places that many pairs of a decision ask for: those within a zone, by how far from its boundary
// in mm, and those where monitors hold, by the zones and standoffs that they ask for.
struct KnownPlaces {
  using Off = std::pair<ir::ZoneIndex, std::int64_t>;
  std::map<Off, std::optional<geometry::Region>> within;
  std::map<std::vector<std::vector<Off>>, geometry::Region> held;
};

// Where a recovery may take over while the property of monitor `judged` holds, and those of all
// monitors that are relied on (fences.h).
struct TakeOver {
  const ir::Module& module;
  const ir::Decision& decision;
  const ExactZone& exact;
  const ExactSolid& solid;
  std::size_t judged = 0;
  KnownPlaces* known = nullptr;  // none: each is found anew
};

// Whether each body that may be there lies in the zone: from nowhere has it to be led in. false
// also where that is not known: an outline of very many vertices is not offset.
bool starts_within(const TakeOver& at, ir::ZoneIndex zone);

// In space: where the centres of bodies may be that are led into the zone from outside of it while
// the property asks something of that fence.
geometry::Solid led_in_from(const TakeOver& at, ir::ZoneIndex zone, ir::ZoneIndex fence);

// What makes it so.
std::string begins_inside(const ir::ZoneTable& zone);

// The clearance that a recovery of the plane looks for first, of cells.
std::int64_t aims_at_mm(const ir::Decision& decision, const ir::Recovery& step);

// Whether the straight way into the zone of the step, which lies in the fence, stays in that: the
// fence is convex, or there is no such way. In space the way is upright and then level; a zone of
// the plane is entered on the level, so that each level counts by itself.
bool comes_in_within(const TakeOver& at, const ir::Recovery& step, ir::ZoneIndex fence);

// What it takes for that. nullopt: it stays in the fence. "": nobody knows of anything that would
// do; in space it is said past which blocks of the fence it has no room.
std::optional<std::string> missing_to_come_in(const TakeOver& at, const ir::Recovery& step,
                                              ir::ZoneIndex fence);

// Whether that way stays, of each `or`, in one of these zones or another, of which each body in the
// zone of the step lies in one: the places of bodies in them are convex, or there is no such way,
// or each one stays in them that may be taken from where a body may be in one of them.
bool comes_in_by_sides(const TakeOver& at, const ir::Recovery& step,
                       const std::vector<std::vector<ir::ZoneIndex>>& either);

}  // namespace rtac::analysis
