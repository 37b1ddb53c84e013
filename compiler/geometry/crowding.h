// Whether so many places fit into a region, far enough from each other.
#pragma once

#include <cstddef>

#include "compiler/geometry/region.h"

namespace rtac::geometry {

// Whether so many places of the region cannot be, no two of them less than `apart` (m, positive)
// from each other: since discs of half as much around them, which overlap nowhere, take more than
// all that is within their radius of the region; or since of the convex hull of it, of area A and
// perimeter P, no more than 2 A / (sqrt(3) apart^2) + P / (2 apart) + 1 are so far apart (N. Oler,
// "An inequality in the geometry of numbers", Acta Mathematica 105, 1961); or since boxes that are
// fewer, and no wider than that from corner to corner, cover it. Rounded to "they can";
// whether they do fit is not shown.
bool too_many_for(const Region& region, std::size_t places, const Rational& apart);

}  // namespace rtac::geometry
