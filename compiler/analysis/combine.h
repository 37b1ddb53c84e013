// Zones of the plane and zones with height are combined by the same words.
#pragma once

#include "compiler/diagnostics/engine.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

template <class Shape>
Shape combine(sema::ZoneOp op, const Shape& left, const Shape& right) {
  switch (op) {
    case sema::ZoneOp::unite:
      return left.unite(right);
    case sema::ZoneOp::intersect:
      return left.intersect(right);
    case sema::ZoneOp::subtract:
      break;
  }
  return left.subtract(right);
}

// What has so many vertices, at `range`: more than `geometry::points_max`.
diag::Diagnostic too_many_vertices(std::size_t vertices, const SourceRange& range);
std::size_t vertices_of(const sema::ZonePolygon& polygon);
// Of all the areas of a file that make a zone, circles as the polygons that stand for them.
std::size_t vertices_of(const sema::ZoneImport& import);

// What crosses too often to be combined, at `range`.
diag::Diagnostic too_intricate(const SourceRange& range);

}  // namespace rtac::analysis
