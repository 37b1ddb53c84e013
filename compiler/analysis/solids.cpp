#include "compiler/analysis/solids.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "compiler/analysis/zones.h"
#include "compiler/geometry/place/placer.h"
#include "compiler/geometry/united.h"

namespace rtac::analysis {

using diag::Code;

namespace {

// Sideways.
bool fits_grid(const geometry::Solid& solid) {
  return std::ranges::all_of(
      solid.slabs(), [](const geometry::Slab& slab) { return analysis::fits_grid(slab.region); });
}

}  // namespace

SolidEvaluator::SolidEvaluator(const sema::Spec& spec, diag::Engine& diagnostics, Base base)
    : ZoneAlgebra(spec, diagnostics), base_(std::move(base)) {}

SolidEvaluator::Result SolidEvaluator::eval(const sema::ZonePrism& prism, const SourceRange&,
                                            Side side) {
  auto base = base_(*prism.base, side);
  if (!base) return std::nullopt;
  return geometry::Solid::prism(std::move(*base), prism.floor, prism.ceiling);
}

// As of zones of the plane: the boundary is moved sideways by the error of the file, and its areas
// are combined before.
SolidEvaluator::Result SolidEvaluator::eval(const sema::ZoneImport& node, const SourceRange& range,
                                            Side side) {
  if (vertices_of(node) > geometry::points_max) {
    diagnostics_.report(too_many_vertices(vertices_of(node), range));
    return std::nullopt;
  }
  std::vector<geometry::Slab> groups;
  for (const auto& group : node.inclusions) {
    Result all;
    for (const auto& area : group) {
      std::vector<geometry::Slab> slabs;
      if (!add(area, side, slabs) || !is_simple(slabs, range)) return std::nullopt;
      geometry::Solid one = geometry::Solid::of_slabs(slabs);
      all = all ? combined(sema::ZoneOp::intersect, *all, one, range) : std::move(one);
      if (!all) return std::nullopt;
    }
    if (all) std::ranges::copy(all->slabs(), std::back_inserter(groups));
  }
  std::vector<geometry::Slab> exclusions;
  for (const auto& area : node.exclusions) {
    if (!add(area, other(side), exclusions)) return std::nullopt;
  }
  if (!is_simple(groups, range) || !is_simple(exclusions, range)) return std::nullopt;
  const Result zone = combined(sema::ZoneOp::subtract, geometry::Solid::of_slabs(groups),
                               geometry::Solid::of_slabs(exclusions), range);
  if (!zone) return std::nullopt;
  return side == Side::inner ? zone->shrink(node.error, 0) : zone->grow(node.error, 0);
}

bool SolidEvaluator::add(const sema::ZoneImport::Area& area, Side side,
                         std::vector<geometry::Slab>& slabs) {
  const geometry::Solid everywhere = geometry::Solid::everywhere();
  const geometry::Slab& all = everywhere.slabs().front();
  for (std::size_t i = 0; i < area.parts.size(); ++i) {
    sema::ZoneExpr shape{};
    std::visit([&](const auto& part) { shape.node = part; }, area.parts[i]);
    auto base = base_(shape, side);
    if (!base) return false;
    if (base->empty()) continue;
    slabs.push_back({area.bands[i].floor.value_or(all.floor),
                     area.bands[i].ceiling.value_or(all.ceiling), std::move(*base)});
  }
  return true;
}

// Whatever lies above one another may meet in a combination.
bool SolidEvaluator::is_simple(const std::vector<geometry::Slab>& slabs, const SourceRange& range) {
  std::vector<geometry::Region> regions;
  for (const geometry::Slab& slab : slabs) regions.push_back(slab.region);
  if (!geometry::cross_too_often(regions)) return true;
  diagnostics_.report(too_intricate(range));
  return false;
}

SolidEvaluator::Result SolidEvaluator::combined(sema::ZoneOp op, const geometry::Solid& left,
                                                const geometry::Solid& right,
                                                const SourceRange& range) {
  std::size_t cost = 0;
  for (const geometry::Slab& l : left.slabs()) {
    for (const geometry::Slab& r : right.slabs()) {
      if (r.floor >= l.ceiling || l.floor >= r.ceiling) continue;
      cost += geometry::meeting_cost({l.region, r.region});
      if (cost <= geometry::touches_max) continue;
      diagnostics_.report(too_intricate(range));
      return std::nullopt;
    }
  }
  return combine(op, left, right);
}

// Sideways as the offsets of zones of the plane, up and down exact.
SolidEvaluator::Result SolidEvaluator::eval(const sema::ZoneOffset& node, const SourceRange& range,
                                            Side side) {
  const Result operand = expr(*node.operand, side);
  if (!operand) return std::nullopt;
  const Rational by = abs(node.distance);
  const bool shrinks = sgn(node.distance) < 0;
  if (by > grid_reach_m() && !(shrinks && fits_grid(*operand))) {
    diagnostics_.report(too_large(range));
    return std::nullopt;
  }
  const std::size_t nested = nested_.with(node);
  const bool errs_well = shrinks == (side == Side::inner);
  const Rational across = errs_well ? by : Rational(by - geometry::offset_excess_m(nested));
  return shrinks ? operand->shrink(across, by, nested) : operand->grow(across, by, nested);
}

void SolidEvaluator::report(Code code, const sema::Zone& zone, std::string message,
                            std::string help) {
  const SourceRange range = zone.name.empty() ? zone.value->range : zone.name_range;
  diagnostics_.report({code, range, std::move(message), "", {}, std::move(help), {}});
}

void SolidEvaluator::report_empty(const sema::Zone& zone) {
  std::string help = "the operands of `&` must overlap, in height as well";
  if (std::holds_alternative<sema::ZoneOffset>(zone.value->node)) {
    help = "`shrink` takes its distance away on every side, above and below as well";
  } else if (const auto* binary = std::get_if<sema::ZoneBinary>(&zone.value->node)) {
    if (binary->op == sema::ZoneOp::subtract) {
      help = "what is subtracted must leave a part of the zone";
    }
  }
  report(Code::empty_zone, zone,
         zone.name.empty() ? "this zone is empty" : "zone `" + zone.name + "` is empty",
         std::move(help));
}

void SolidEvaluator::too_many_slabs(const sema::Zone& zone, std::size_t slabs) {
  report(Code::too_many_edges, zone,
         "the zone has " + std::to_string(slabs) + " slabs, a decision checks at most " +
             std::to_string(slabs_max),
         "watch parts of the zone by monitors of their own");
}

namespace {

// A body that reaches through several slabs has to fit into what they have in common. Runs that
// cannot be wider than what was found are not looked at.
EvaluatedSolid::Widest widest_of(const geometry::Solid& solid,
                                 const std::vector<BakedSlab>& slabs) {
  EvaluatedSolid::Widest best;
  const auto try_run = [&](const geometry::BakedZone& base, std::int64_t floor_mm,
                           std::int64_t ceiling_mm) {
    const std::int64_t mm = std::min<std::int64_t>(base.widest_mm, (ceiling_mm - floor_mm) / 2);
    if (mm <= best.mm) return;
    best = {static_cast<std::int32_t>(mm),
            static_cast<std::int32_t>(floor_mm + (ceiling_mm - floor_mm) / 2), base.widest_at};
  };
  for (const BakedSlab& slab : slabs) try_run(slab.baked, slab.floor_mm, slab.ceiling_mm);
  const std::vector<geometry::Slab>& exact = solid.slabs();
  for (std::size_t i = 0; i + 1 < exact.size(); ++i) {
    geometry::Region common = exact[i].region;
    for (std::size_t j = i + 1; j < exact.size() && exact[j].floor == exact[j - 1].ceiling; ++j) {
      common = common.intersect(exact[j].region);
      const auto snapped = geometry::snap_inside(common);
      if (!snapped || snapped->rings.empty()) break;
      try_run(baked(*snapped), ceil_to_int(Rational(exact[i].floor * 1000)),
              floor_to_int(Rational(exact[j].ceiling * 1000)));
    }
  }
  return best;
}

}  // namespace

std::optional<SnappedSides> SolidEvaluator::snapped(sema::ZoneId id) {
  const auto inner = zone(id, Side::inner), outer = zone(id, Side::outer);
  if (!inner || !outer) return std::nullopt;
  const sema::Zone& declared = spec_[id];
  const bool small = fits_grid(*inner) && fits_grid(*outer);
  // Those of 2 mm and more are slabs on the grid, of the zone as a keep-out at least.
  const auto is_thick = [](const geometry::Slab& slab) {
    return slab.ceiling - slab.floor >= Rational(2, 1000);
  };
  const auto thick = std::ranges::count_if(outer->slabs(), is_thick);
  if (small && static_cast<std::size_t>(thick) > slabs_max) {
    too_many_slabs(declared, static_cast<std::size_t>(thick));
    return std::nullopt;
  }
  auto within = small ? geometry::snap_inside(*inner) : std::nullopt;
  auto around = small ? geometry::snap_around(*outer) : std::nullopt;
  if (!within || !around) {
    report(Code::zone_too_large, declared, "the zone reaches beyond the grid of 1 mm",
           "coordinates and heights of at most 536.8 km from the origin work");
    return std::nullopt;
  }
  return SnappedSides{std::move(*within), std::move(*around)};
}

std::optional<EvaluatedSolid> SolidEvaluator::bake(sema::ZoneId id, std::int64_t exact_mm,
                                                   bool robots) {
  const auto sides = snapped(id);
  if (!sides) return std::nullopt;
  const sema::Zone& declared = spec_[id];
  if (sides->within.empty()) {
    report(Code::zone_vanishes_on_grid, declared, "nothing of the zone is left on the grid of 1 mm",
           "a zone of more than 2 mm in all directions works");
    return std::nullopt;
  }
  auto inside = baked(declared, sides->within, exact_mm);
  auto outside = inside ? baked(declared, sides->around, exact_mm) : std::nullopt;
  if (!outside) return std::nullopt;
  EvaluatedSolid solid{std::move(*inside), std::move(*outside)};
  if (!robots) return solid;
  for (BakedSlab& slab : solid.within) slab.baked = analysis::baked(slab.snapped);
  solid.exact = *zone(id, Side::inner);  // which has been evaluated
  solid.widest = widest_of(solid.exact, solid.within);
  return solid;
}

std::optional<std::vector<BakedSlab>> SolidEvaluator::baked(const sema::Zone& zone,
                                                            const geometry::SnappedSolid& solid,
                                                            std::int64_t exact_mm) {
  if (solid.size() > slabs_max) {
    too_many_slabs(zone, solid.size());
    return std::nullopt;
  }
  std::vector<BakedSlab> slabs;
  for (const geometry::SnappedSlab& slab : solid) {
    auto grown = geometry::grow_cell_tree(slab.zone, exact_mm);
    if (const auto* dense = std::get_if<geometry::TooDense>(&grown)) {
      report(Code::too_many_edges, zone,
             std::to_string(dense->edges) +
                 " edges of a slab of the zone are equally near to a place; a decision checks at "
                 "most " +
                 std::to_string(geometry::cell_edges_max),
             "an outline with fewer vertices there works");
      return std::nullopt;
    }
    slabs.push_back({slab.floor_mm, slab.ceiling_mm, geometry::edge_rows(slab.zone),
                     std::move(std::get<geometry::CellTree>(grown)), slab.zone});
  }
  return slabs;
}

}  // namespace rtac::analysis
