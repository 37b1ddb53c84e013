#include "compiler/analysis/zones.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "compiler/analysis/combine.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/reach.h"
#include "compiler/analysis/ring_problems.h"
#include "compiler/analysis/sites.h"
#include "compiler/geometry/apart.h"
#include "compiler/geometry/place/placer.h"
#include "compiler/geometry/united.h"
#include "compiler/sema/dimension.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

using diag::Code;
using sema::ZoneId;

class Evaluator : public ZoneAlgebra<Evaluator, geometry::Region> {
 public:
  Evaluator(const sema::Spec& spec, diag::Engine& diagnostics)
      : ZoneAlgebra(spec, diagnostics),
        solids_(spec, diagnostics,
                [this](const sema::ZoneExpr& base, Side side) { return expr(base, side); }) {}

  using ZoneAlgebra::zone;
  // The zone as a keep-in: never larger than the exact one.
  Result zone(ZoneId id) { return zone(id, Side::inner); }
  // The zone as a keep-out: never smaller than the exact one.
  Result around(ZoneId id) { return zone(id, Side::outer); }
  // Zones with height.
  SolidEvaluator& solids() { return solids_; }

 private:
  friend ZoneAlgebra;
  using ZoneAlgebra::eval;
  // Curves are approximated from within, or from without where the zone is subtracted.

  Result eval(const sema::ZonePrism&, const SourceRange&, Side) { return std::nullopt; }
  Result eval(const sema::ZoneCircle& circle, const SourceRange&, Side side) {
    return geometry::Region::circle({circle.centre.x, circle.centre.y}, circle.radius,
                                    side == Side::inner);
  }
  Result combined(sema::ZoneOp op, const geometry::Region& left, const geometry::Region& right,
                  const SourceRange& range) {
    if (!is_small(left.vertices() + right.vertices(), range)) return std::nullopt;
    if (geometry::cross_too_often({left, right})) return intricate(range);
    return combine(op, left, right);
  }
  bool is_small(std::size_t vertices, const SourceRange& range) {
    if (vertices <= geometry::points_max) return true;
    diagnostics_.report(too_many_vertices(vertices, range));
    return false;
  }
  std::nullopt_t intricate(const SourceRange& range) {
    diagnostics_.report(too_intricate(range));
    return std::nullopt;
  }
  // Offsets reach a little too far, to the side that `shrink` and `grow` are usually wanted on; on
  // the other side the distance makes up for it.
  Result eval(const sema::ZoneOffset& node, const SourceRange& range, Side side) {
    const Result operand = expr(*node.operand, side);
    if (!operand) return std::nullopt;
    const bool shrinks = sgn(node.distance) < 0;
    Rational by = abs(node.distance);
    if (by > grid_reach_m() && !(shrinks && fits_grid(*operand))) {
      diagnostics_.report(too_large(range));
      return std::nullopt;
    }
    const std::size_t nested = nested_.with(node);
    if (shrinks != (side == Side::inner)) {
      by = std::max(Rational(by - geometry::offset_excess_m(nested)), Rational(0));
    }
    Result moved = operand->offset(shrinks ? Rational(-by) : by, nested);
    if (!moved) diagnostics_.report(too_many_to_move(operand->vertices(), range));
    return moved;
  }
  // What a file says is off by at most its error: of a zone to stay in the boundary is moved
  // inwards by it, else outwards. Its areas lie to each other as in the file, so they are combined
  // before.
  Result eval(const sema::ZoneImport& node, const SourceRange& range, Side side) {
    if (!is_small(vertices_of(node), range)) return std::nullopt;
    std::vector<geometry::Region> groups, exclusions;
    for (const auto& group : node.inclusions) {
      if (group.empty()) continue;
      Result all = common(group, range, side);
      if (!all) return std::nullopt;
      groups.push_back(std::move(*all));
    }
    for (const auto& each : node.exclusions) {
      auto region = area(each, range, other(side));
      if (!region) return std::nullopt;
      exclusions.push_back(std::move(*region));
    }
    Result zone = united(std::move(groups), range);
    if (!zone) return std::nullopt;
    if (!exclusions.empty()) {
      const Result without = united(std::move(exclusions), range);
      if (!without) return std::nullopt;
      zone = combined(sema::ZoneOp::subtract, *zone, *without, range);
      if (!zone) return std::nullopt;
    }
    Result widened = zone->widened(side == Side::inner ? Rational(-node.error) : node.error);
    if (!widened) diagnostics_.report(too_many_to_place(zone->vertices(), node.error, range));
    return widened;
  }
  // What all areas of a group have in common.
  Result common(const std::vector<sema::ZoneImport::Area>& group, const SourceRange& range,
                Side side) {
    Result all;
    for (const auto& each : group) {
      Result next = area(each, range, side);
      if (!next) return std::nullopt;
      if (all) next = combined(sema::ZoneOp::intersect, *all, *next, range);
      if (!next) return std::nullopt;
      all = std::move(next);
    }
    return all;
  }
  Result area(const sema::ZoneImport::Area& area, const SourceRange& range, Side side) {
    std::vector<geometry::Region> parts;
    for (const auto& part : area.parts) {
      auto region = std::visit([&](const auto& shape) { return eval(shape, range, side); }, part);
      if (!region) return std::nullopt;
      parts.push_back(std::move(*region));
    }
    return united(std::move(parts), range);
  }
  Result united(std::vector<geometry::Region> regions, const SourceRange& range) {
    Result all = geometry::united(std::move(regions));
    return all ? std::move(all) : intricate(range);
  }
  // What it is nobody knows before it is received.
  static Result eval(const sema::ZoneReceived&, const SourceRange&, Side) { return std::nullopt; }
  Result eval(const sema::ZonePolygon& polygon, const SourceRange& range, Side) {
    const auto ring = [](const sema::ZonePolygon::Ring& from) {
      geometry::Ring to;
      for (const sema::Point& p : from.points) to.push_back({p.x, p.y});
      return to;
    };
    if (!is_small(vertices_of(polygon), range)) return std::nullopt;
    std::vector<geometry::Ring> holes;
    for (const auto& hole : polygon.holes) holes.push_back(ring(hole));
    auto result = geometry::Region::polygon(ring(polygon.outer), holes);
    if (const auto* problem = std::get_if<geometry::Problem>(&result)) {
      diagnostics_.report(describe(*problem, polygon, range));
      return std::nullopt;
    }
    return std::get<geometry::Region>(std::move(result));
  }

  void report_empty(const sema::Zone& zone) {
    diag::Diagnostic d{};
    d.code = Code::empty_zone;
    d.range = zone.name.empty() ? zone.value->range : zone.name_range;
    d.message = zone.name.empty() ? "this zone is empty" : "zone `" + zone.name + "` is empty";
    if (const auto* offset = std::get_if<sema::ZoneOffset>(&zone.value->node)) {
      const Result operand = expr(*offset->operand, Side::inner);
      if (operand) d.help = largest_shrink(*operand);
    } else if (const auto* imported = std::get_if<sema::ZoneImport>(&zone.value->node)) {
      d.help = empty_import(*imported);
    } else if (std::holds_alternative<sema::ZoneComplement>(zone.value->node)) {
      d.help = "the zone covers all that a map holds: nothing is outside it";
    } else {
      const auto* binary = std::get_if<sema::ZoneBinary>(&zone.value->node);
      d.help = binary && binary->op == sema::ZoneOp::subtract
                   ? "what is subtracted must leave a part of the zone"
                   : "the operands of `&` must overlap";
    }
    diagnostics_.report(std::move(d));
  }
  static std::string empty_import(const sema::ZoneImport& imported) {
    const auto& groups = imported.inclusions;
    if (std::ranges::any_of(groups, [](const auto& group) { return group.size() > 1; })) {
      return "areas that a place has to be inside of at once must overlap: in a plan all of them, "
             "but with `inclusions any` one of them will do; among fence items those of a group";
    }
    const std::string error = "the boundary may be off by " + metres(imported.error) + ": ";
    return error + (imported.exclusions.empty()
                        ? "nothing of the areas of the file is farther within them"
                        : "what the file excludes leaves nothing that is farther within the rest");
  }
  static std::string largest_shrink(const geometry::Region& region) {
    const auto snapped = geometry::snap_inside(region);
    const auto shrunk = snapped ? baked(*snapped) : geometry::BakedZone{};
    if (shrunk.widest_mm <= 0) {
      return "what is shrunk is itself too thin: a zone of more than 2 mm in both directions works";
    }
    return "shrinking by less than " + metres(Rational(shrunk.widest_mm, 1000)) +
           " leaves something; the widest place is at (" +
           metres(Rational(shrunk.widest_at.x_mm, 1000)) + ", " +
           metres(Rational(shrunk.widest_at.y_mm, 1000)) + ")";
  }

  SolidEvaluator solids_;
};

}  // namespace

std::vector<const sema::ZoneExpr*> united_parts(const sema::ZoneBinary& node) {
  std::vector<const sema::ZoneExpr*> parts;
  for (const sema::ZoneExpr* part : {node.left.get(), node.right.get()}) {
    const auto* inner = std::get_if<sema::ZoneBinary>(&part->node);
    if (inner != nullptr && inner->op == sema::ZoneOp::unite) {
      std::ranges::copy(united_parts(*inner), std::back_inserter(parts));
    } else {
      parts.push_back(part);
    }
  }
  return parts;
}

std::size_t vertices_of(const sema::ZonePolygon& polygon) {
  std::size_t all = polygon.outer.points.size();
  for (const auto& hole : polygon.holes) all += hole.points.size();
  return all;
}
std::size_t vertices_of(const sema::ZoneImport& import) {
  std::size_t all = 0;
  const auto add = [&](const sema::ZoneImport::Area& area) {
    for (const auto& part : area.parts) {
      const auto* circle = std::get_if<sema::ZoneCircle>(&part);
      all += circle != nullptr ? geometry::circle_edges(circle->radius)
                               : vertices_of(std::get<sema::ZonePolygon>(part));
    }
  };
  for (const auto& group : import.inclusions) std::ranges::for_each(group, add);
  std::ranges::for_each(import.exclusions, add);
  return all;
}

diag::Diagnostic too_many_vertices(std::size_t vertices, const SourceRange& range) {
  return {Code::too_many_vertices,
          range,
          "the outlines of the zone have " + std::to_string(vertices) + " vertices",
          "too many vertices",
          {},
          "up to " + std::to_string(geometry::points_max) +
              " work: leave out vertices that change an outline by little, or watch parts of the "
              "zone by monitors of their own",
          {}};
}

diag::Diagnostic too_many_to_move(std::size_t vertices, const SourceRange& range) {
  return {
      Code::too_many_vertices,
      range,
      "the zone that is to be moved has " + std::to_string(vertices) + " vertices",
      "too many vertices",
      {},
      "up to " + std::to_string(geometry::offset_vertices_max) +
          " work, where corners become round: leave out vertices that change the outline by "
          "little; or compare the clearance of the zone with the distance, which takes any zone",
      {}};
}

diag::Diagnostic too_many_to_place(std::size_t vertices, const Rational& error,
                                   const SourceRange& range) {
  return {
      Code::too_many_vertices,
      range,
      "the areas of the file have " + std::to_string(vertices) +
          " vertices, and corners so sharp, or edges so near to others, that they cannot all be "
          "moved by the " +
          to_decimal(Rational(error * 1000)) + " mm that their places may be off",
      "too many vertices",
      {},
      "up to " + std::to_string(geometry::offset_vertices_max) +
          " work then: simplify the outlines in the program that drew them, or take fewer areas "
          "by `feature \"name\"`",
      {}};
}

diag::Diagnostic too_large(const SourceRange& range) {
  return {Code::zone_too_large,
          range,
          "the zone reaches beyond the grid of 1 mm",
          "",
          {},
          "coordinates of at most 536.8 km from the origin work",
          {}};
}

diag::Diagnostic too_intricate(const SourceRange& range) {
  return {Code::zone_file_unusable,
          range,
          "boundaries cross one another at more than " + std::to_string(geometry::crossings_max) +
              " places, touch at more than " + std::to_string(geometry::touches_max) +
              ", or lie side by side too often to be looked at",
          "too many crossings",
          {},
          "take fewer areas of a file with `feature`, or unite them in the program that drew them",
          {}};
}

geometry::BakedZone baked(const geometry::SnappedZone& zone) {
  if (zone.rings.empty()) return {};
  geometry::GridPoint low = zone.rings[0][0], high = low;
  for (const auto& ring : zone.rings) {
    for (const geometry::GridPoint& p : ring) {
      low = {std::min(low.x_mm, p.x_mm), std::min(low.y_mm, p.y_mm)};
      high = {std::max(high.x_mm, p.x_mm), std::max(high.y_mm, p.y_mm)};
    }
  }
  return geometry::bake(
      zone, cell_mm_for(std::int64_t{high.x_mm} - low.x_mm, std::int64_t{high.y_mm} - low.y_mm));
}

Rational grid_reach_m() {
  return {536'870'911, 1000};
}

bool fits_grid(const geometry::Region& region) {
  const Rational limit = grid_reach_m();
  const auto beyond = [&](const geometry::Point& p) {
    return abs(p.x) > limit || abs(p.y) > limit;
  };
  for (const geometry::PolygonWithHoles& part : region.polygons()) {
    if (std::any_of(part.outer.begin(), part.outer.end(), beyond)) return false;
  }
  return true;
}

std::int32_t cell_mm_for(std::int64_t width_mm, std::int64_t height_mm) {
  constexpr std::int64_t step_mm = 10;
  const auto fits = [&](std::int64_t steps) {
    const std::int64_t cell_mm = steps * step_mm;
    const std::int64_t columns = (width_mm + cell_mm - 1) / cell_mm;
    const std::int64_t rows = (height_mm + cell_mm - 1) / cell_mm;
    return columns * rows <= cells_most;
  };
  std::int64_t low = cell_mm_least / step_mm;
  std::int64_t high = std::max(low, std::max(width_mm, height_mm) / step_mm + 1);  // one cell
  while (low < high) {
    const std::int64_t middle = (low + high) / 2;
    fits(middle) ? high = middle : low = middle + 1;
  }
  return static_cast<std::int32_t>(low * step_mm);
}

namespace {

// From what is exact to tables; a zone that the grid cannot hold is reported.
class Baker {
 public:
  Baker(std::int64_t exact_mm, diag::Engine& diagnostics)
      : exact_mm_(exact_mm), diagnostics_(diagnostics) {}

  // False: it reaches beyond the grid, which is reported.
  bool check_extent(const sema::Zone& zone, const ZoneUse& use, const geometry::Region& region,
                    const std::optional<geometry::Region>& around) {
    range_ = zone.name.empty() ? zone.value->range : zone.name_range;
    if (fits_grid(region) && (!use.both_sides() || (around && fits_grid(*around)))) return true;
    beyond();
    return false;
  }
  // `around`: the zone as a keep-out, of one that points ask for.
  std::optional<EvaluatedZone> bake(const sema::Zone& zone, const ZoneUse& use,
                                    geometry::Region region,
                                    const std::optional<geometry::Region>& around) {
    if (!check_extent(zone, use, region, around)) return std::nullopt;
    auto snapped = geometry::snap_inside(region);
    if (!snapped) return vanishes();
    EvaluatedZone to{std::move(region), std::move(*snapped), {}, {}, {}, {}};
    if (use.robots) {
      to.baked = baked(to.snapped);
    } else {
      to.baked.edges = geometry::edge_rows(to.snapped);
    }
    const auto outer = use.points ? geometry::snap_around(*around) : std::nullopt;
    if (use.points && !outer) return beyond();
    if (!grow(to.snapped, to.tree)) return std::nullopt;
    if (!outer) return to;
    to.around = geometry::edge_rows(*outer);
    if (outer->rings == to.snapped.rings) {
      to.around_tree = to.tree;
    } else if (!grow(*outer, to.around_tree)) {
      return std::nullopt;
    }
    return to;
  }

 private:
  std::nullopt_t report(Code code, std::string message, std::string help) {
    diagnostics_.report({code, range_, std::move(message), "", {}, std::move(help), {}});
    return std::nullopt;
  }
  std::nullopt_t beyond() {
    diagnostics_.report(too_large(range_));
    return std::nullopt;
  }
  std::nullopt_t vanishes() {
    return report(Code::zone_vanishes_on_grid, "nothing of the zone is left on the grid of 1 mm",
                  "a zone of more than 2 mm in both directions works");
  }
  // False: reported.
  bool grow(const geometry::SnappedZone& zone, geometry::CellTree& to) {
    auto grown = geometry::grow_cell_tree(zone, exact_mm_);
    if (const auto* dense = std::get_if<geometry::TooDense>(&grown)) {
      too_dense(*dense);
      return false;
    }
    to = std::move(std::get<geometry::CellTree>(grown));
    return true;
  }
  void too_dense(const geometry::TooDense& at) {
    report(Code::too_many_edges,
           std::to_string(at.edges) + " edges of the zone lie within " +
               metres(Rational(at.within_mm, 1000)) + " of (" + metres(Rational(at.at.x_mm, 1000)) +
               ", " + metres(Rational(at.at.y_mm, 1000)) + "); a decision checks at most " +
               std::to_string(geometry::cell_edges_max) +
               " for a place, with tables of 64 bytes an edge and 64 KiB",
           "an outline with fewer vertices there works; one inside this one is safe for a zone to "
           "stay in, one around it for a zone to keep out of");
  }

  std::int64_t exact_mm_;  // distances that are to be exact
  diag::Engine& diagnostics_;
  SourceRange range_;
};

// Lengths that properties of points name, and what any robot looks ahead at full speed; at least
// 10 m, for margins. Bytes are spent on this before cells at the boundary get small.
std::int64_t exact_wanted_mm(const sema::Spec& spec) {
  std::int64_t most_mm = 10'000;
  std::int64_t ahead_us = 1'000'000;
  for (const sema::Monitor& m : spec.monitors) {
    if (m.ahead.duration) {
      ahead_us = std::max(ahead_us, ceil_to_int(m.ahead.duration->value * 1'000'000));
    }
  }
  const auto named = [&](const sema::Expr& e) {
    const auto* constant = std::get_if<sema::Constant>(&e.node);
    if (!constant || e.dimension != sema::dims::length) return;
    most_mm = std::max(most_mm, ceil_to_int(abs(constant->value) * 1500));
  };
  for (const sema::Watch& w : spec.watches) sema::for_each_expr(*w.always, named);
  for (const sema::RobotKind& kind : spec.kinds) {
    const ir::Body body = body_of(kind, ahead_us);
    if (body.brake_mmps2 <= body.disturbance_mmps2) continue;  // reported
    const ir::Motion motion = any_control(kind);
    most_mm = std::max(
        most_mm, 2 * disc_mm(body, motion, motion.speed_mmps, horizon_us_max(body, ahead_us)));
  }
  return most_mm;
}

// The square of how far they are apart, in m^2: as keep-ins, or as keep-outs.
Rational square_apart(Evaluator& evaluator, const sema::Spec& spec, const sema::ZoneDistance& of,
                      Side side) {
  if (spec[of.zone].has_height) {
    return geometry::square_apart(*evaluator.solids().zone(of.zone, side),
                                  *evaluator.solids().zone(of.other, side));
  }
  return geometry::square_apart(*evaluator.zone(of.zone, side), *evaluator.zone(of.other, side));
}

// The root in steps of 1 mm, down; whether something is left.
std::pair<mpz_class, bool> root_mm(const Rational& square) {
  const Rational mm2 = square * 1'000'000;
  const mpz_class whole = mm2.get_num() / mm2.get_den();
  const mpz_class root = sqrt(whole);
  return {root, Rational(root * root) != mm2};
}

ZoneGaps gaps_of(Evaluator& evaluator, const sema::Spec& spec) {
  ZoneGaps gaps;
  const auto add = [&](const sema::Expr& e) {
    const auto* of = std::get_if<sema::ZoneDistance>(&e.node);
    if (of == nullptr || gaps.contains(ir::TableMap::pair(*of))) return;
    const Rational nearer = square_apart(evaluator, spec, *of, Side::outer);
    const Rational farther = square_apart(evaluator, spec, *of, Side::inner);
    const auto [lo, some] = root_mm(nearer);
    const auto [hi, more] = root_mm(farther);
    const std::int64_t last = hi.get_si() + (more ? 1 : 0);
    gaps[ir::TableMap::pair(*of)] = {lo.get_si(), last, some && more && last == lo.get_si() + 1};
  };
  for (const sema::Watch& w : spec.watches) sema::for_each_expr(*w.always, add);
  return gaps;
}

}  // namespace

std::vector<std::vector<ShownSlab>> exact_zones(const sema::Spec& spec) {
  diag::Engine reported_before;
  Evaluator evaluator(spec, reported_before);
  std::vector<std::vector<ShownSlab>> zones;
  for (std::uint32_t i = 0; i < spec.zones.size(); ++i) {
    std::vector<ShownSlab>& slabs = zones.emplace_back();
    if (spec.zones[i].has_height) {
      const auto solid = evaluator.solids().zone(ZoneId(i), Side::inner);
      if (!solid) continue;
      for (const geometry::Slab& slab : solid->slabs()) {
        slabs.push_back({slab.region, std::pair(slab.floor, slab.ceiling)});
      }
    } else if (auto region = evaluator.zone(ZoneId(i))) {
      slabs.push_back({std::move(*region), std::nullopt});
    }
  }
  return zones;
}

std::vector<ZoneUse> wanted_zones(const sema::Spec& spec) {
  std::vector<ZoneUse> wanted(spec.zones.size());
  const auto of = [&](ZoneId id) -> ZoneUse& { return wanted[static_cast<std::size_t>(id)]; };
  const auto in = [&](const sema::Expr& e) {
    if (const auto* c = std::get_if<sema::Clearance>(&e.node)) of(c->zone).robots = true;
    if (const auto* i = std::get_if<sema::InsideZone>(&e.node)) of(i->zone).robots = true;
    if (const auto* p = std::get_if<sema::PlanInside>(&e.node)) of(p->zone).robots = true;
  };
  for (const sema::Monitor& m : spec.monitors) {
    sema::for_each_expr(*m.always, in);
    if (m.return_when) sema::for_each_expr(*m.return_when, in);
  }
  for (const sema::Controller& c : spec.controllers) {
    for (const sema::Template& what : sema::templates_of(c)) {
      if (const auto moves = sema::moves_of(what)) of(moves->zone).robots = true;
    }
    if (const auto claim = sema::claim_of(c)) of(claim->zone).robots = true;
  }
  const auto places = [&](const sema::Expr& e) {
    if (const auto* c = std::get_if<sema::PointClearance>(&e.node)) of(c->zone).points = true;
    if (const auto* i = std::get_if<sema::PointInside>(&e.node)) of(i->zone).points = true;
    if (const auto* c = std::get_if<sema::TrailClearance>(&e.node)) of(c->zone).points = true;
    if (const auto* i = std::get_if<sema::TrailInside>(&e.node)) of(i->zone).points = true;
    if (const auto* d = std::get_if<sema::ZoneDistance>(&e.node)) {
      of(d->zone).apart = of(d->other).apart = true;
    }
  };
  for (const sema::Watch& w : spec.watches) sema::for_each_expr(*w.always, places);
  return wanted;
}

void check_zones(const sema::Spec& spec, diag::Engine& diagnostics) {
  Evaluator evaluator(spec, diagnostics);
  Baker baker(0, diagnostics);
  const std::vector<ZoneUse> wanted = wanted_zones(spec);
  for (std::uint32_t i = 0; i < spec.zones.size(); ++i) {
    const ZoneUse& use = wanted[i];
    const auto id = ZoneId(i);
    if (spec.zones[i].has_height) {
      const auto exact = evaluator.solids().zone(id, Side::inner);
      if (exact && use.any()) evaluator.solids().snapped(id);
      continue;
    }
    const auto region = evaluator.zone(id);
    if (!region || !use.any()) continue;
    const auto around = use.both_sides() ? evaluator.around(id) : std::nullopt;
    baker.check_extent(spec.zones[i], use, *region, around);
  }
  const RegionOf region_of = [&](ZoneId id) { return evaluator.zone(id); };
  check_idle_sites(spec, region_of, diagnostics);
  check_fenced_out_sites(spec, region_of, diagnostics);
}

EvaluatedZones evaluate_zones(const sema::Spec& spec, const std::vector<ZoneUse>& wanted,
                              diag::Engine& diagnostics) {
  Evaluator evaluator(spec, diagnostics);
  const std::int64_t exact_mm = diagnostics.has_errors() ? 0 : exact_wanted_mm(spec);
  Baker baker(exact_mm, diagnostics);
  std::vector<std::optional<EvaluatedZone>> result(spec.zones.size());
  for (std::uint32_t i = 0; i < spec.zones.size(); ++i) {
    const ZoneUse& use = wanted[i];
    if (spec.zones[i].has_height) {
      const auto exact = evaluator.solids().zone(ZoneId(i), Side::inner);
      if (exact && use.is_apart_alone()) evaluator.solids().snapped(ZoneId(i));
      const bool has_table = use.any() && !use.is_apart_alone();
      auto solid = exact && has_table ? evaluator.solids().bake(ZoneId(i), exact_mm, use.robots)
                                      : std::nullopt;
      if (solid) {
        result[i].emplace();
        result[i]->solid = std::move(solid);
      }
      continue;
    }
    auto region = evaluator.zone(ZoneId(i));  // unused zones are validated too
    if (!region || !use.any()) continue;
    std::optional<geometry::Region> around;
    if (use.both_sides()) around = evaluator.around(ZoneId(i));
    if (use.is_apart_alone()) {
      baker.check_extent(spec.zones[i], use, *region, around);
      continue;
    }
    result[i] = baker.bake(spec.zones[i], use, std::move(*region), around);
  }
  const RegionOf region_of = [&](ZoneId id) { return evaluator.zone(id); };
  check_idle_sites(spec, region_of, diagnostics);
  check_fenced_out_sites(spec, region_of, diagnostics);
  EvaluatedZones all{std::move(result), {}};
  if (!diagnostics.has_errors()) all.gaps = gaps_of(evaluator, spec);
  return all;
}

}  // namespace rtac::analysis
