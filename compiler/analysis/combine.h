// Zones of the plane and zones with height are combined by the same words.
#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "compiler/analysis/one_sided.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/sema/nested_offsets.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// The parts of `a | (b | c) | d`, in order.
std::vector<const sema::ZoneExpr*> united_parts(const sema::ZoneBinary& node);

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

// A zone is known from within, where robots or points have to be in it, and from without.
enum class Side { inner, outer };
inline Side other(Side side) {
  return side == Side::inner ? Side::outer : Side::inner;
}

// Zones by name and by the operators of zones. `Evaluator` has `eval(node, range, side)` of all
// other expressions, `combined(op, left, right, range)` and `report_empty(zone)`.
template <class Evaluator, class Shape>
class ZoneAlgebra {
 public:
  using Result = std::optional<Shape>;  // nullopt: faulty, and reported where the fault is
  ZoneAlgebra(const sema::Spec& spec, diag::Engine& diagnostics)
      : spec_(spec),
        diagnostics_(diagnostics),
        nested_(spec),
        one_sided_(spec),
        shapes_(2 * spec.zones.size()),
        visited_(2 * spec.zones.size(), false) {}

  Result zone(sema::ZoneId id, Side side) {
    if (one_sided_.none(id)) side = Side::inner;
    const auto i = 2 * static_cast<std::size_t>(id) + (side == Side::inner ? 0 : 1);
    if (!visited_[i]) {
      visited_[i] = true;
      shapes_[i] = expr(*spec_[id].value, side);
      if (shapes_[i] && shapes_[i]->empty()) {
        self().report_empty(spec_[id]);
        shapes_[i].reset();
      }
    }
    return shapes_[i];
  }

 protected:
  Result expr(const sema::ZoneExpr& e, Side side) {
    return std::visit([&](const auto& node) { return self().eval(node, e.range, side); }, e.node);
  }
  Result eval(const sema::ZoneRef& reference, const SourceRange&, Side side) {
    return zone(reference.zone, side);
  }
  Result eval(const sema::ZoneComplement& complement, const SourceRange&, Side side) {
    const Result of = zone(complement.zone, other(side));
    return of ? Result(Shape::everywhere().subtract(*of)) : std::nullopt;
  }
  Result eval(const sema::ZoneBinary& node, const SourceRange& range, Side side) {
    if (node.op == sema::ZoneOp::unite) return halves_united(united_parts(node), range, side);
    const Result left = expr(*node.left, side);
    const Result right = expr(*node.right, node.op == sema::ZoneOp::subtract ? other(side) : side);
    if (!left || !right) return std::nullopt;
    return self().combined(node.op, *left, *right, range);
  }

  const sema::Spec& spec_;
  diag::Engine& diagnostics_;
  const sema::NestedOffsets nested_;

 private:
  // One by one, what is united already would be gone through for every part.
  Result halves_united(std::span<const sema::ZoneExpr* const> parts, const SourceRange& range,
                       Side side) {
    if (parts.size() == 1) return expr(*parts[0], side);
    const Result first = halves_united(parts.first(parts.size() / 2), range, side);
    const Result second = halves_united(parts.subspan(parts.size() / 2), range, side);
    if (!first || !second) return std::nullopt;
    return self().combined(sema::ZoneOp::unite, *first, *second, range);
  }
  Evaluator& self() { return static_cast<Evaluator&>(*this); }

  OneSided one_sided_;
  std::vector<Result> shapes_;
  std::vector<bool> visited_;
};

// What has so many vertices, at `range`: more than `geometry::points_max`.
diag::Diagnostic too_many_vertices(std::size_t vertices, const SourceRange& range);
// More than `geometry::offset_vertices_max`.
diag::Diagnostic too_many_to_move(std::size_t vertices, const SourceRange& range);
// The same of a file, whose boundary is moved by the error of the map, in m.
diag::Diagnostic too_many_to_place(std::size_t vertices, const Rational& error,
                                   const SourceRange& range);
std::size_t vertices_of(const sema::ZonePolygon& polygon);
// Of all the areas of a file that make a zone, circles as the polygons that stand for them.
std::size_t vertices_of(const sema::ZoneImport& import);

// What does not fit the grid, at `range`.
diag::Diagnostic too_large(const SourceRange& range);

// What crosses too often to be combined, at `range`.
diag::Diagnostic too_intricate(const SourceRange& range);

}  // namespace rtac::analysis
