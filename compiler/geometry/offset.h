// Pieces that cover everything within a distance of a boundary, on one of its sides. Internal to
// this folder.
#pragma once

#include <vector>

#include "compiler/geometry/region.h"

namespace rtac::geometry {

// `count` (at least 1) rational unit vectors in every quadrant, counter-clockwise from (1, 0):
// exactly of length one, so that tangents and their intersections stay rational. The angle between
// two neighbours is at most 2 / count.
std::vector<Point> unit_directions(std::size_t count);

// `count` of them in all, a multiple of four, evenly spaced to within 5e-4 rad: the
// tangents of half their angles are rounded to 2^-12.
std::vector<Point> regular_directions(std::size_t count);

// The polygon whose edges touch the circle at the directions: it contains the disc.
Ring circumscribed(const Point& centre, const Rational& radius,
                   const std::vector<Point>& directions);
Ring inscribed(const Point& centre, const Rational& radius, const std::vector<Point>& directions);

enum class BandSide { interior, exterior };

// Counter-clockwise pieces that lie within distance + excess of the boundary of `parts`, and cover
// every point of the chosen side that is closer to it than `distance` (> 0), or exactly as close.
// They have more corners the larger the distance and the smaller the excess, which is more than the
// half of a um given away along edges.
std::vector<Ring> boundary_band(const std::vector<PolygonWithHoles>& parts,
                                const Rational& distance, const Rational& excess, BandSide side);

}  // namespace rtac::geometry
