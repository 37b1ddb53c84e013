// What is wrong with a polygon that was received, in words. Internal to this folder.
#pragma once

#include <string>

#include "compiler/geometry/region.h"

namespace rtac::geometry {

// "(1 m, 2 m)".
std::string place_text(const Point& p);
// "the outer ring", "hole 2", of several polygons with "of polygon 3".
std::string ring_text(std::size_t polygon, std::size_t count, std::size_t ring);
// Counted from 1.
std::string vertex_text(std::size_t vertex);

// Behind the ring and, of some, its vertex.
std::string message_of(const Problem& problem);
std::string help_of(Problem::Kind kind);
bool is_of_whole_ring(Problem::Kind kind);

}  // namespace rtac::geometry
