#include "compiler/analysis/ring_problems.h"

#include <string>

#include "compiler/sema/in_file.h"

namespace rtac::analysis {
namespace {

using diag::Code;
using Kind = geometry::Problem::Kind;

std::string place(const geometry::Point& p) {
  return "(" + to_decimal(p.x) + " m, " + to_decimal(p.y) + " m)";
}

Code code_of(Kind kind) {
  switch (kind) {
    case Kind::too_short:
      return Code::ring_too_short;
    case Kind::repeats_vertex:
      return Code::ring_repeats_vertex;
    case Kind::self_intersects:
      return Code::ring_self_intersects;
    case Kind::no_area:
      return Code::ring_has_no_area;
    case Kind::hole_outside_ring:
      return Code::hole_outside_ring;
    case Kind::holes_overlap:
      return Code::holes_overlap;
    case Kind::cuts_area:
      return Code::hole_cuts_area;
  }
  return Code::ring_self_intersects;
}

std::string help_of(Kind kind, bool in_file) {
  switch (kind) {
    case Kind::too_short:
      return "a ring needs at least three vertices that do not lie on one line";
    case Kind::repeats_vertex:
      return "remove one of the two; rings are closed by themselves";
    case Kind::self_intersects:
      return in_file ? "order the vertices along the boundary, or make two areas of it"
                     : "order the vertices along the boundary, or write two polygons joined by `|`";
    case Kind::no_area:
      return "move at least one vertex off the line through the others";
    case Kind::hole_outside_ring:
      return in_file ? "a notch in the edge is part of the outline, not a hole"
                     : "to cut a notch from the edge, subtract a polygon: `outer - notch`";
    case Kind::holes_overlap:
      return in_file ? "make one hole of them"
                     : "write them as one hole, or subtract both: `outer - (a | b)`";
    case Kind::cuts_area:
      return in_file ? "make two areas of it, or move the hole"
                     : "subtract the hole: `outer - hole` may be in several parts";
  }
  return "";
}

// The names of rings and vertices in the text of a message.
class Description {
 public:
  Description(const geometry::Problem& problem, const sema::ZonePolygon& polygon)
      : problem_(problem), polygon_(polygon) {}

  [[nodiscard]] std::string message() const {
    const std::string which = ring_text(problem_.ring);
    const std::string vertex = vertex_text(problem_.vertex);
    switch (problem_.kind) {
      case Kind::too_short:
        return which + " has fewer than three different vertices";
      case Kind::repeats_vertex:
        return vertex + " of " + which + " repeats vertex " +
               std::to_string(number(problem_.other));
      case Kind::self_intersects:
        return which + edges(vertex) + " at " + place(problem_.where);
      case Kind::no_area:
        return which + " encloses no area";
      case Kind::hole_outside_ring:
        return which + " does not lie inside " + (in_file() ? ring_text(0) : "the outer ring") +
               ", see its " + vertex;
      case Kind::holes_overlap:
        return which + " and " + ring_text(problem_.other) + " overlap, see " +
               place(problem_.where);
      case Kind::cuts_area:
        return which + " touches " + ring_text(problem_.other) + " at " + place(problem_.where) +
               ", and cuts the area in two";
    }
    return "";
  }

 private:
  [[nodiscard]] const sema::ZonePolygon::Ring& ring(std::size_t number) const {
    return number == 0 ? polygon_.outer : polygon_.holes[number - 1];
  }
  [[nodiscard]] bool in_file() const { return polygon_.outer.in_file.has_value(); }
  [[nodiscard]] std::string ring_text(std::size_t number) const {
    if (const auto& file = ring(number).in_file) return file->where;
    return number == 0 ? "the outer ring" : "hole " + std::to_string(number);
  }
  // From 1, in the specification or in the file.
  [[nodiscard]] std::size_t number(std::size_t vertex) const {
    const auto& file = ring(problem_.ring).in_file;
    return (file && vertex < file->vertices.size() ? file->vertices[vertex] : vertex) + 1;
  }
  [[nodiscard]] std::string vertex_text(std::size_t vertex) const {
    const auto& file = ring(problem_.ring).in_file;
    return file && vertex < file->vertices.size() ? sema::vertex_text(*file, vertex)
                                                  : "vertex " + std::to_string(number(vertex));
  }
  [[nodiscard]] std::string edges(const std::string& vertex) const {
    if (!in_file()) return " crosses or touches itself";
    return ": the edge from " + vertex + " meets the one from " + vertex_text(problem_.other);
  }

  const geometry::Problem& problem_;
  const sema::ZonePolygon& polygon_;
};

}  // namespace

diag::Diagnostic describe(const geometry::Problem& problem, const sema::ZonePolygon& polygon,
                          const SourceRange& range) {
  const auto& ring = problem.ring == 0 ? polygon.outer : polygon.holes[problem.ring - 1];
  const auto at = [&](std::size_t i) {
    return i < ring.point_ranges.size() ? ring.point_ranges[i] : range;
  };
  const bool whole = problem.kind == Kind::too_short || problem.kind == Kind::no_area;
  diag::Diagnostic d{};
  d.code = code_of(problem.kind);
  d.range = whole ? ring.range : at(problem.vertex);
  d.message = Description(problem, polygon).message();
  d.help = help_of(problem.kind, ring.in_file.has_value());
  if (ring.in_file) return d;
  if (problem.kind == Kind::repeats_vertex) {
    d.notes.push_back({at(problem.other), "the vertex was here first"});
  }
  if (problem.kind == Kind::self_intersects) {
    d.label = "the edge that starts at this vertex";
    d.notes.push_back({at(problem.other), "it meets the edge that starts here"});
  }
  return d;
}

}  // namespace rtac::analysis
