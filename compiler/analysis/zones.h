// Evaluates the zones of a specification exactly and bakes those that are used.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "compiler/analysis/solids.h"
#include "compiler/diagnostics/engine.h"
#include "compiler/geometry/bake.h"
#include "compiler/geometry/cell_tree.h"
#include "compiler/geometry/region.h"
#include "compiler/ir/table_map.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// Width of the cells of a zone that is small enough, in mm: of routes and energy tables.
inline constexpr std::int32_t cell_mm_least = 100;
// Most cells of one zone: a recovery searches them while its robot waits. Generated code refuses a
// runtime that searches fewer.
inline constexpr std::int64_t cells_most = 40'000;

// Who asks for a zone: the robots move in it and need its cells, points are only held against its
// edges. `apart`: how far it is from another one, which needs no table.
struct ZoneUse {
  bool robots = false, points = false, apart = false;
  [[nodiscard]] bool any() const { return robots || points || apart; }
  [[nodiscard]] bool both_sides() const { return points || apart; }
  [[nodiscard]] bool is_apart_alone() const { return apart && !robots && !points; }
};
std::vector<ZoneUse> wanted_zones(const sema::Spec& spec);  // by ZoneId

struct EvaluatedZone {
  geometry::Region exact;
  geometry::SnappedZone snapped;
  geometry::BakedZone baked;              // for robots; else the edges alone
  geometry::CellTree tree;                // of its edges
  std::vector<geometry::EdgeRow> around;  // for points: of a zone that contains the exact one
  geometry::CellTree around_tree;
  std::optional<EvaluatedSolid> solid{};  // of a zone with height, which has nothing of the above
};

// Width of the cells of a zone of this size: `cell_mm_least`, or the least multiple of 1 cm with
// which there are `cells_most` at most. What holds for a cell holds for every place of it, so that
// a wider one is only more careful.
std::int32_t cell_mm_for(std::int64_t width_mm, std::int64_t height_mm);

// With cells of that width; of no zone: nothing.
geometry::BakedZone baked(const geometry::SnappedZone& zone);

// How far the coordinates of the grid reach that kernels compute on: to 2^29 mm, less one.
Rational grid_reach_m();
// Whether its coordinates lie on that grid.
bool fits_grid(const geometry::Region& region);

// By ZoneId, as keep-ins: never larger than the exact zones; a zone of the plane is one slab
// without heights, a faulty one has none. For pictures, of a specification without errors.
struct ShownSlab {
  geometry::Region region;
  std::optional<std::pair<Rational, Rational>> heights;
};
std::vector<std::vector<ShownSlab>> exact_zones(const sema::Spec& spec);

using ZoneGaps = decltype(ir::TableMap::gaps);
struct EvaluatedZones {
  // By ZoneId; nullopt for a zone that is faulty (reported) or needs no table.
  std::vector<std::optional<EvaluatedZone>> zones;
  ZoneGaps gaps;  // of those that monitors ask about; none where something was reported
};
EvaluatedZones evaluate_zones(const sema::Spec& spec, const std::vector<ZoneUse>& wanted,
                              diag::Engine& diagnostics);

// Reports what is wrong with zones without baking any, for those that need no tables. That a site
// is barred by a monitor is no matter of zones (well_formed.cpp).
void check_zones(const sema::Spec& spec, diag::Engine& diagnostics);

}  // namespace rtac::analysis
