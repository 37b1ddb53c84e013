// Large outlines moved by a small distance, in one step: a vertex for a vertex. Internal to this
// folder.
#pragma once

#include <optional>
#include <vector>

#include "compiler/geometry/offset.h"

namespace rtac::geometry {

// The parts less everything within `distance` (> 0) of their boundary, or with it (exterior), as
// offsets are: never nearer to the boundary than that, less than 1 mm farther along edges and at
// corners that stay sharp, within 2 mm at those that would be round. Verified; nullopt where it
// does not work out: edges that vanish, very sharp corners, rings that touch.
std::optional<std::vector<PolygonWithHoles>> moved_at_once(
    const std::vector<PolygonWithHoles>& parts, const Rational& distance, BandSide side);

}  // namespace rtac::geometry
