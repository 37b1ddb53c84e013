#include "compiler/geometry/problem_text.h"

#include "compiler/support/rational.h"

namespace rtac::geometry {

using Kind = Problem::Kind;

std::string place_text(const Point& p) {
  return "(" + to_decimal(p.x) + " m, " + to_decimal(p.y) + " m)";
}

Problem in_file(Problem problem, const std::vector<std::uint32_t>& vertices) {
  const auto divides = [&](std::size_t point) {
    return point > 0 && point < vertices.size() && vertices[point] == vertices[point - 1];
  };
  const bool on_edge = divides(problem.vertex) || divides(problem.other);
  if (problem.kind == Kind::repeats_vertex && on_edge) problem.kind = Kind::self_intersects;
  return problem;
}

std::string message_of(const Problem& problem, const RingNames& names) {
  switch (problem.kind) {
    case Kind::too_short:
      return "has fewer than three different vertices";
    case Kind::repeats_vertex:
      return "repeats " + names.vertex(problem.other);
    case Kind::self_intersects:
      return "starts an edge that meets the one from " + names.vertex(problem.other) + " at " +
             place_text(problem.where);
    case Kind::no_area:
      return "encloses no area";
    case Kind::hole_outside_ring:
      return "does not lie inside " + names.ring(0) + ", see its " +
             (problem.of_edge ? "edge from " : "") + names.vertex(problem.vertex);
    case Kind::holes_overlap:
      return "overlaps " + names.ring(problem.other) + " at " + place_text(problem.where) +
             (problem.of_edge ? ", see its edge from " + names.vertex(problem.vertex) : "");
    case Kind::cuts_area:
      return "touches " + names.ring(problem.other) + " at " + place_text(problem.where) +
             ", on its edge from " + names.vertex(problem.vertex) + ", and cuts the area in two";
  }
  return "";
}
bool is_said_of_vertex(Kind kind) {
  return kind == Kind::repeats_vertex || kind == Kind::self_intersects;
}

std::string help_of(Kind kind) {
  switch (kind) {
    case Kind::too_short:
      return "a ring needs at least three vertices that do not lie on one line";
    case Kind::repeats_vertex:
      return "remove one of the two; rings are closed by themselves";
    case Kind::self_intersects:
      return "order the vertices along the boundary, or make two areas of it";
    case Kind::no_area:
      return "move at least one vertex off the line through the others";
    case Kind::hole_outside_ring:
      return "the outline comes first, around all holes; a notch in its edge is a part of it";
    case Kind::holes_overlap:
      return "make one hole of them";
    case Kind::cuts_area:
      return "make two areas of it, or move the hole";
  }
  return "";
}

}  // namespace rtac::geometry
