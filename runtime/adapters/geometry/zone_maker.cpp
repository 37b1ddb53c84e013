#include "rtac/geometry/zone_maker.h"

#include <utility>

#include "compiler/geometry/receive/receive_file.h"
#include "compiler/geometry/receive/receive_zone.h"

namespace rtac {
namespace {

using geometry::import::Format;
using geometry::import::Polygon;
using geometry::import::Ring;

Ring ring_of(const std::vector<Vec2>& from) {
  Ring to;
  for (const Vec2& p : from) to.positions.push_back({p.x, p.y});
  const auto& all = to.positions;
  to.closed = all.size() > 1 && all.front().x == all.back().x && all.front().y == all.back().y;
  if (to.closed) to.positions.pop_back();
  return to;
}

Format format_of(ZoneFormat format) {
  switch (format) {
    case ZoneFormat::geojson:
      return Format::geojson;
    case ZoneFormat::kml:
      return Format::kml;
    case ZoneFormat::qgc_plan:
      return Format::qgc_plan;
  }
  return Format::wkt;  // none of them, which is refused
}
geometry::FileAreas areas_of(ZoneAreas areas) {
  switch (areas) {
    case ZoneAreas::unstated:
      return geometry::FileAreas::unstated;
    case ZoneAreas::all:
      return geometry::FileAreas::all;
    case ZoneAreas::any:
      return geometry::FileAreas::any;
    case ZoneAreas::exclusions:
      return geometry::FileAreas::exclusions;
  }
  return geometry::FileAreas::unstated;
}

ZoneRefusal refusal(const geometry::RefusedZone& why) {
  return {why.where, why.message, why.help};
}

ZoneOutline outline_of(const geometry::CellTree& t) {
  ZoneOutline o;
  o.x_mm = t.x_mm;
  o.y_mm = t.y_mm;
  o.shift = t.shift;
  o.column = t.column;
  o.row = t.row;
  o.columns = t.columns;
  o.rows = t.rows;
  o.depth = t.depth;
  o.leaves = t.leaves;
  return o;
}
HeldZone::Arrays arrays_of(geometry::OutlineTable table) {
  HeldZone::Arrays arrays{{}, std::move(table.tree.words), std::move(table.tree.lists)};
  arrays.edges.reserve(6 * table.edges.size());
  for (const geometry::EdgeRow& e : table.edges) {
    for (const std::int32_t n : {e.a.x_mm, e.a.y_mm, e.b.x_mm, e.b.y_mm, e.ux_q30, e.uy_q30}) {
      arrays.edges.push_back(n);
    }
  }
  return arrays;
}

MadeZone made(std::variant<geometry::ReceivedRegions, geometry::RefusedZone> received,
              std::size_t edges_most) {
  if (const auto* why = std::get_if<geometry::RefusedZone>(&received)) return refusal(*why);
  auto tables =
      geometry::make_zone_tables(std::get<geometry::ReceivedRegions>(received), edges_most);
  if (const auto* why = std::get_if<geometry::RefusedZone>(&tables)) return refusal(*why);
  auto& [within, around] = std::get<geometry::ZoneTables>(tables);
  const ZoneOutline inner = outline_of(within.tree);
  const ZoneOutline outer = around ? outline_of(around->tree) : inner;
  return std::make_unique<HeldZone>(inner, arrays_of(std::move(within)), outer,
                                    around ? arrays_of(std::move(*around)) : HeldZone::Arrays{});
}

}  // namespace

MadeZone make_zone(const std::vector<ZonePolygon>& polygons, std::size_t edges_most) {
  std::vector<Polygon> to;
  for (const ZonePolygon& from : polygons) {
    Polygon& polygon = to.emplace_back();
    polygon.outer = ring_of(from.outer);
    for (const auto& hole : from.holes) polygon.holes.push_back(ring_of(hole));
  }
  return made(geometry::receive_zone(to, edges_most), edges_most);
}

MadeZone make_zone_of_wkt(const std::string& text, std::size_t edges_most) {
  return made(geometry::receive_wkt(text, edges_most), edges_most);
}

MadeZone make_zone_of_file(const std::string& text, const ZoneFile& as, std::size_t edges_most,
                           std::vector<ZoneNote>* notes) {
  const geometry::ReceivedFile file{
      format_of(as.format), {as.origin_latitude_deg, as.origin_longitude_deg}, areas_of(as.areas)};
  auto received = geometry::receive_file(text, file, edges_most);
  std::vector<ZoneNote> besides;
  if (auto* regions = std::get_if<geometry::ReceivedRegions>(&received)) {
    for (auto& note : regions->notes) {
      besides.push_back({std::move(note.where), std::move(note.message)});
    }
  }
  MadeZone zone = made(std::move(received), edges_most);
  if (notes != nullptr && !std::holds_alternative<ZoneRefusal>(zone)) *notes = std::move(besides);
  return zone;
}

}  // namespace rtac
