// Large outlines moved by a small distance, in one step: a vertex for a vertex, or some where a
// corner becomes round. Internal to this folder.
#pragma once

#include <optional>
#include <vector>

#include "compiler/geometry/offset.h"

namespace rtac::geometry {

// The parts less everything within `distance` (> 0) of their boundary, or with it (exterior), as
// offsets are: never nearer to the boundary than that, and at most `excess` farther.
// Verified; nullopt where it does not work out: edges that vanish, very sharp corners, rings that
// touch.
std::optional<std::vector<PolygonWithHoles>> moved_at_once(
    const std::vector<PolygonWithHoles>& parts, const Rational& distance, const Rational& excess,
    BandSide side);

}  // namespace rtac::geometry
