// Evaluates zones with height exactly, from the zones of the plane under their prisms, and bakes
// those that are used.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "compiler/analysis/combine.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/geometry/cell_tree.h"
#include "compiler/geometry/solid.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

struct BakedSlab {
  std::int32_t floor_mm = 0, ceiling_mm = 0;
  std::vector<geometry::EdgeRow> edges;
  geometry::CellTree tree;  // of its edges
  geometry::SnappedZone snapped{};
  geometry::BakedZone baked{};  // for robots
};
// Every place is held against all of them.
inline constexpr std::size_t slabs_max = 64;
struct EvaluatedSolid {
  std::vector<BakedSlab> within, around;  // from below to above
  // For robots: the place from which most has to be gone to leave it, up, down or sideways.
  struct Widest {
    std::int32_t mm = 0, z_mm = 0;
    geometry::GridPoint at{};
  } widest{};
  geometry::Solid exact{};  // for robots
};

struct SnappedSides {
  geometry::SnappedSolid within, around;
};

class SolidEvaluator : public ZoneAlgebra<SolidEvaluator, geometry::Solid> {
 public:
  // A zone of the plane; nullopt: faulty, and reported.
  using Base = std::function<std::optional<geometry::Region>(const sema::ZoneExpr& base, Side)>;
  SolidEvaluator(const sema::Spec& spec, diag::Engine& diagnostics, Base base);

  // On the grid, as keep-in and keep-out; nullopt: beyond it, or in too many slabs, which is
  // reported.
  std::optional<SnappedSides> snapped(sema::ZoneId id);
  // As tables, in which distances up to `exact_mm` are exact where they may be large enough;
  // nullopt: reported.
  // `robots`: they move in it, and need the cells of its slabs.
  std::optional<EvaluatedSolid> bake(sema::ZoneId id, std::int64_t exact_mm, bool robots);

 private:
  friend ZoneAlgebra;
  using ZoneAlgebra::eval;
  Result eval(const sema::ZonePrism& prism, const SourceRange& range, Side side);
  Result eval(const sema::ZoneImport& node, const SourceRange& range, Side side);
  bool add(const sema::ZoneImport::Area& area, Side side, std::vector<geometry::Slab>& slabs);
  Result eval(const sema::ZoneOffset& node, const SourceRange& range, Side side);
  // Zones of the plane stand under a prism.
  template <class Flat>
  Result eval(const Flat&, const SourceRange&, Side) {
    return std::nullopt;
  }
  // False: reported.
  bool is_simple(const std::vector<geometry::Slab>& slabs, const SourceRange& range);
  // nullopt: reported.
  Result combined(sema::ZoneOp op, const geometry::Solid& left, const geometry::Solid& right,
                  const SourceRange& range);
  void report(diag::Code code, const sema::Zone& zone, std::string message, std::string help);
  void report_empty(const sema::Zone& zone);
  void too_many_slabs(const sema::Zone& zone, std::size_t slabs);
  std::optional<std::vector<BakedSlab>> baked(const sema::Zone& zone,
                                              const geometry::SnappedSolid& solid,
                                              std::int64_t exact_mm);

  Base base_;
};

}  // namespace rtac::analysis
