#include "compiler/analysis/ring_problems.h"

#include <string>

#include "compiler/geometry/problem_text.h"
#include "compiler/sema/in_file.h"

namespace rtac::analysis {
namespace {

using diag::Code;
using Kind = geometry::Problem::Kind;

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

// Zones that are written have operators, too.
std::string help_of(Kind kind, bool in_file) {
  if (!in_file) {
    if (kind == Kind::self_intersects) {
      return "order the vertices along the boundary, or write two polygons joined by `|`";
    }
    if (kind == Kind::hole_outside_ring) {
      return "to cut a notch from the edge, subtract a polygon: `outer - notch`";
    }
    if (kind == Kind::holes_overlap) {
      return "write them as one hole, or subtract both: `outer - (a | b)`";
    }
    if (kind == Kind::cuts_area) {
      return "subtract the hole: `outer - hole` may be in several parts";
    }
  }
  return geometry::help_of(kind);
}

// The names of rings and vertices in the text of a message.
class Description {
 public:
  Description(const geometry::Problem& problem, const sema::ZonePolygon& polygon)
      : problem_(problem), polygon_(polygon) {}

  [[nodiscard]] std::string message() const {
    const std::string ring = ring_text(problem_.ring);
    const bool of_vertex = geometry::is_said_of_vertex(problem_.kind);
    if (problem_.kind == Kind::self_intersects && !in_file()) {  // its labels name the edges
      return ring + " crosses or touches itself at " + geometry::place_text(problem_.where);
    }
    return (of_vertex ? vertex_text(problem_.vertex) + " of " : "") + ring + " " +
           geometry::message_of(problem_, {[&](std::size_t i) { return ring_text(i); },
                                           [&](std::size_t i) { return vertex_text(i); }});
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
  const geometry::Problem& problem_;
  const sema::ZonePolygon& polygon_;
};

}  // namespace

diag::Diagnostic describe(const geometry::Problem& found, const sema::ZonePolygon& polygon,
                          const SourceRange& range) {
  const auto& ring = found.ring == 0 ? polygon.outer : polygon.holes[found.ring - 1];
  const geometry::Problem problem =
      ring.in_file ? geometry::in_file(found, ring.in_file->vertices) : found;
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
