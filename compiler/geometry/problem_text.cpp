#include "compiler/geometry/receive/problem_text.h"

#include "compiler/support/rational.h"

namespace rtac::geometry {

using Kind = Problem::Kind;

std::string place_text(const Point& p) {
  return "(" + to_decimal(p.x) + " m, " + to_decimal(p.y) + " m)";
}
std::string ring_text(std::size_t polygon, std::size_t count, std::size_t ring) {
  const std::string name = ring == 0 ? "the outer ring" : "hole " + std::to_string(ring);
  return count == 1 ? name : name + " of polygon " + std::to_string(polygon + 1);
}
std::string vertex_text(std::size_t vertex) {
  return "vertex " + std::to_string(vertex + 1);
}

std::string message_of(const Problem& problem) {
  switch (problem.kind) {
    case Kind::too_short:
      return "has fewer than three different vertices";
    case Kind::repeats_vertex:
      return "repeats " + vertex_text(problem.other);
    case Kind::self_intersects:
      return "starts an edge that meets the one from " + vertex_text(problem.other) + " at " +
             place_text(problem.where);
    case Kind::no_area:
      return "encloses no area";
    case Kind::hole_outside_ring:
      return "does not lie inside the outer ring, see " + place_text(problem.where);
    case Kind::holes_overlap:
      return "overlaps hole " + std::to_string(problem.other) + " at " + place_text(problem.where);
    case Kind::cuts_area:
      return "touches " + ring_text(0, 1, problem.other) + " at " + place_text(problem.where) +
             " and cuts the area in two";
  }
  return "";
}
std::string help_of(Problem::Kind kind) {
  switch (kind) {
    case Kind::too_short:
      return "a ring needs at least three vertices that do not lie on one line";
    case Kind::repeats_vertex:
      return "remove one of the two; rings are closed by themselves";
    case Kind::self_intersects:
      return "order the vertices along the boundary, or send two polygons";
    case Kind::no_area:
      return "move at least one vertex off the line through the others";
    case Kind::hole_outside_ring:
      return "a notch in the edge is part of the outer ring, not a hole";
    case Kind::holes_overlap:
      return "make one hole of them";
    case Kind::cuts_area:
      return "send two polygons, or move the hole";
  }
  return "";
}
bool is_of_whole_ring(Kind kind) {
  return kind == Kind::too_short || kind == Kind::no_area || kind == Kind::holes_overlap;
}

}  // namespace rtac::geometry
