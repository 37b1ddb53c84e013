// Large outlines moved in one step: a vertex for a vertex, some where a corner becomes round, none
// where edges vanish. Internal to this folder.
#pragma once

#include <optional>
#include <vector>

#include "compiler/geometry/offset.h"

namespace rtac::geometry {

// The parts less everything within `distance` (> 0) of their boundary, or with it (exterior), as
// offsets are: never nearer to the boundary than that, and at most `excess` farther.
// Verified; nullopt where it does not work out: rings that vanish, or meet others on the way, very
// sharp corners, rings that touch.
std::optional<std::vector<PolygonWithHoles>> moved_at_once(
    const std::vector<PolygonWithHoles>& parts, const Rational& distance, const Rational& excess,
    BandSide side);

}  // namespace rtac::geometry
