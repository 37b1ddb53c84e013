// What the parts of a zone that was received are called. Internal to this folder.
#pragma once

#include <string>

namespace rtac::geometry {

// "the outer ring", "hole 2", of several polygons with "of polygon 3".
inline std::string ring_text(std::size_t polygon, std::size_t count, std::size_t ring) {
  const std::string name = ring == 0 ? "the outer ring" : "hole " + std::to_string(ring);
  return count == 1 ? name : name + " of polygon " + std::to_string(polygon + 1);
}
// Counted from 1.
inline std::string vertex_text(std::size_t vertex) {
  return "vertex " + std::to_string(vertex + 1);
}

}  // namespace rtac::geometry
