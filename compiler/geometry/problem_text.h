// What is wrong with a polygon, in words that are the same whether it was written, imported or
// received.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "compiler/geometry/region.h"

namespace rtac::geometry {

// "(1 m, 2 m)".
std::string place_text(const Point& p);

// The same of a ring whose edges were divided, `vertices` telling of each point the vertex of the
// file that it is, or whose edge it is on: where edges meet at such points no vertex is repeated.
Problem in_file(Problem problem, const std::vector<std::uint32_t>& vertices);

// What rings are called, and the vertices of the one that is spoken of; both from 0.
struct RingNames {
  std::function<std::string(std::size_t)> ring, vertex;
};
// Goes behind the name of the ring `problem.ring` or, where that is said of its vertex
// `problem.vertex`, behind the name of both.
std::string message_of(const Problem& problem, const RingNames& names);
bool is_said_of_vertex(Problem::Kind kind);
// Of areas that other programs draw: whoever writes polygons has more means.
std::string help_of(Problem::Kind kind);

}  // namespace rtac::geometry
