// Boolean combination of two sets of rings, exactly. Internal to this folder.
#pragma once

#include <vector>

#include "compiler/geometry/region.h"

namespace rtac::geometry {

enum class Combine { unite, intersect, subtract };

// A point belongs to an operand where the winding number of the operand's rings is positive, so
// that an operand may be any heap of counter-clockwise pieces, overlapping or not, as well as
// outer rings with clockwise holes. The result is regular (closed, without dangling edges) and
// canonical: see Region::polygons.
std::vector<PolygonWithHoles> overlay(const std::vector<Ring>& left, const std::vector<Ring>& right,
                                      Combine how);

// The same, where the right operand is a heap of pieces whose neighbours in the list overlap: in
// near n log n also when each of them overlaps hundreds of others.
std::vector<PolygonWithHoles> overlay_band(const std::vector<Ring>& rings,
                                           const std::vector<Ring>& pieces, Combine how);

}  // namespace rtac::geometry
