#include "compiler/geometry/receive/receive_zone.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "compiler/geometry/place/placer.h"
#include "compiler/geometry/problem_text.h"
#include "compiler/geometry/receive/names.h"
#include "compiler/geometry/receive/refusals.h"
#include "compiler/geometry/united.h"
#include "compiler/support/rational.h"

namespace rtac::geometry {
namespace {

class Receiver {
 public:
  Receiver(const std::vector<import::Polygon>& polygons, std::size_t edges_most)
      : polygons_(polygons), edges_most_(edges_most), placer_({false, false, true}, std::nullopt) {}

  std::variant<ReceivedRegions, RefusedZone> run() {
    if (is_too_much()) return std::move(*refused_);
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      if (!take(i)) return std::move(*refused_);
    }
    const auto all = united(std::move(regions_));
    if (!all) {
      refuse("the zone", "has polygons that cross one another too often",
             "unite them in the program that drew them");
      return std::move(*refused_);
    }
    if (sgn(placer_.error()) == 0) return ReceivedRegions{*all, *all};
    auto within = all->widened(Rational(-placer_.error())), around = all->widened(placer_.error());
    if (!within || !around) return too_sharp(placer_.error());
    ReceivedRegions regions{std::move(*within), std::move(*around)};
    if (regions.within.empty()) {
      refuse("the zone", "is nowhere wider than its coordinates are exact",
             "a zone of more than 2 mm in both directions works");
      return std::move(*refused_);
    }
    return regions;
  }

 private:
  bool refuse(std::string where, std::string message, std::string help) {
    refused_ = RefusedZone{std::move(where), std::move(message), std::move(help)};
    return false;
  }
  bool is_too_much() {
    std::size_t vertices = 0;
    for (const import::Polygon& polygon : polygons_) {
      vertices += polygon.outer.positions.size();
      for (const import::Ring& hole : polygon.holes) vertices += hole.positions.size();
    }
    if (polygons_.empty()) return !refuse("the zone", "has no polygon", "send at least one");
    if (vertices <= edges_most_) return false;
    return !refuse("the zone",
                   "has " + std::to_string(vertices) + " vertices, " + std::to_string(edges_most_) +
                       " are the most",
                   "leave out vertices that change the outline by little, or declare `zone[" +
                       std::to_string(vertices) + "]`");
  }
  std::optional<Ring> placed(const import::Ring& from, const std::string& where) {
    const auto& all = from.positions;
    const auto bad = std::find_if(all.begin(), all.end(), [](const import::Position& p) {
      return !std::isfinite(p.x) || !std::isfinite(p.y);
    });
    if (bad != all.end()) {
      refuse(where + ", " + vertex_text(static_cast<std::size_t>(bad - all.begin())),
             "has a coordinate that is not finite", "send numbers, in metres");
      return std::nullopt;
    }
    auto places = placer_.place(from);
    if (const auto* fault = std::get_if<NoPlace>(&places)) {
      refuse(where + ", " + vertex_text(fault->vertex), "lies too far away, or nowhere",
             "coordinates of at most 500 km from (0 m, 0 m) work");
      return std::nullopt;
    }
    Ring ring;
    for (const PlacedPoint& p : std::get<PlacedRing>(places).points) ring.push_back({p.x, p.y});
    return ring;
  }
  bool take(std::size_t i) {
    const import::Polygon& polygon = polygons_[i];
    const auto where = [&](std::size_t ring) { return ring_text(i, polygons_.size(), ring); };
    auto outer = placed(polygon.outer, where(0));
    if (!outer) return false;
    std::vector<Ring> holes;
    for (std::size_t k = 0; k < polygon.holes.size(); ++k) {
      auto hole = placed(polygon.holes[k], where(k + 1));
      if (!hole) return false;
      holes.push_back(std::move(*hole));
    }
    auto made = Region::polygon(*outer, holes);
    if (const auto* problem = std::get_if<Problem>(&made)) {
      const bool of_vertex = is_said_of_vertex(problem->kind);
      return refuse(where(problem->ring) + (of_vertex ? ", " + vertex_text(problem->vertex) : ""),
                    message_of(*problem, {where, vertex_text}), help_of(problem->kind));
    }
    regions_.push_back(std::get<Region>(std::move(made)));
    return true;
  }
  const std::vector<import::Polygon>& polygons_;
  const std::size_t edges_most_;
  Placer placer_;
  std::vector<Region> regions_;
  std::optional<RefusedZone> refused_;
};

RefusedZone refused(const import::Failure& failure) {
  return {failure.where, failure.message, failure.help};
}

std::variant<OutlineTable, RefusedZone> outline_table(const SnappedZone& zone,
                                                      std::size_t edges_most) {
  OutlineTable table;
  table.edges = edge_rows(zone);
  if (table.edges.size() > edges_most) {
    return RefusedZone{"the zone",
                       "has " + std::to_string(table.edges.size()) +
                           " edges on the grid of 1 mm, " + std::to_string(edges_most) +
                           " are the most",
                       "vertices between two places of the grid take more edges: leave out those "
                       "that change the outline by little, or declare `zone[" +
                           std::to_string(table.edges.size()) + "]`"};
  }
  auto grown = grow_cell_tree(zone, exact_mm_wanted);
  if (const auto* dense = std::get_if<TooDense>(&grown)) {
    const Point at{Rational(dense->at.x_mm, 1000), Rational(dense->at.y_mm, 1000)};
    return RefusedZone{"the zone, at " + place_text(at),
                       "has " + std::to_string(dense->edges) + " edges within " +
                           to_decimal(Rational(dense->within_mm, 1000)) + " m, " +
                           std::to_string(cell_edges_max) + " can be checked there",
                       "an outline with fewer vertices there works"};
  }
  table.tree = std::move(std::get<CellTree>(grown));
  return table;
}

}  // namespace

std::variant<ZoneTables, RefusedZone> make_zone_tables(const ReceivedRegions& regions,
                                                       std::size_t edges_most) {
  const auto inner = snap_inside(regions.within), outer = snap_around(regions.around);
  if (!inner || !outer) {
    return RefusedZone{"the zone", "has nothing left on the grid of 1 mm",
                       "a zone of more than 2 mm in both directions works"};
  }
  auto within = outline_table(*inner, edges_most);
  if (auto* refusal = std::get_if<RefusedZone>(&within)) return std::move(*refusal);
  ZoneTables tables{std::move(std::get<OutlineTable>(within)), std::nullopt};
  if (inner->rings == outer->rings) return tables;
  auto around = outline_table(*outer, edges_most);
  if (auto* refusal = std::get_if<RefusedZone>(&around)) return std::move(*refusal);
  tables.around = std::move(std::get<OutlineTable>(around));
  return tables;
}

std::variant<ReceivedRegions, RefusedZone> receive_zone(
    const std::vector<import::Polygon>& polygons, std::size_t edges_most) {
  return Receiver(polygons, edges_most).run();
}

std::variant<ReceivedRegions, RefusedZone> receive_wkt(const std::string& text,
                                                       std::size_t edges_most) {
  import::Limits limits;
  limits.areas_max = limits.positions_max = 2 * edges_most + 16;  // rings repeat a vertex
  limits.values_max = 8 * edges_most + 64;
  limits.bytes_max = wkt_bytes_most(edges_most);
  auto read = import::read(import::Format::wkt, text, limits);
  if (const auto* failure = std::get_if<import::Failure>(&read)) return refused(*failure);
  const auto& areas = std::get<import::Areas>(read);
  if (areas.unit == import::Unit::degrees) {
    return RefusedZone{"the whole text", "is in degrees", "send metres, x to the east"};
  }
  // Who sends heights may mean them, and has nobody to read a note.
  if (!areas.notes.empty()) {
    return RefusedZone{areas.notes.front().where,
                       "has heights or measures, and a zone that is received has neither",
                       "send POLYGON or MULTIPOLYGON with two numbers for each position"};
  }
  std::vector<import::Polygon> polygons;
  for (const import::Area& area : areas.areas) {
    if (area.refusal) return refused(*area.refusal);
    for (const import::Part& part : area.parts) {
      const auto* polygon = std::get_if<import::Polygon>(&part.shape);
      if (polygon == nullptr) {
        return RefusedZone{"the whole text", "has a circle", "send a polygon"};
      }
      polygons.push_back(*polygon);
    }
  }
  return receive_zone(polygons, edges_most);
}

}  // namespace rtac::geometry
