// Checks of outlines that all formats share. Internal to this folder.
#pragma once

#include <string>
#include <string_view>

#include "compiler/geometry/import/findings.h"

namespace rtac::geometry::import {

// Whether the format wants the first position again at the end of a ring.
enum class Closing { required, implied };

// Takes a last position that repeats the first one away. Fails on an open ring where closing is
// required, and on fewer than three positions.
bool finish_ring(Ring& ring, Closing closing, Findings& findings);

// `FIRST, position 3`: vertices are counted from 1.
std::string place_of_position(const Ring& ring, std::size_t index);

// Fails when both ends have one reference and the floor is above the ceiling.
bool check_band(const Band& band, const std::string& where, Findings& findings);

// Fails on a radius that is not positive.
bool check_radius(double radius_m, const std::string& where, Findings& findings);

// The area cannot be honoured: it stays in the file without parts. The first reason stays.
void refuse(Area& area, std::string where, std::string message, std::string help);

// Help for an area of a format with names that cannot be used.
inline constexpr const char* take_other_areas =
    "take it out, or select areas of polygons by `feature \"name\"`";

// Fails on more areas than the limit.
bool add_area(Area area, const Limits& limits, Areas& areas, Findings& findings);

// After all areas have been read: positions of degrees lie on the globe, perhaps only when they are
// turned, which is noted; those of metres or of no stated unit no further away than the globe is
// round.
bool check_positions(Areas& areas, Findings& findings);

}  // namespace rtac::geometry::import
