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

// What crosses too often to be combined, at `range`.
diag::Diagnostic too_intricate(const SourceRange& range);

}  // namespace rtac::analysis
