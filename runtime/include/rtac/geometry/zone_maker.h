// From a zone that arrives while the monitors run to the tables that they check: validated, snapped
// to the grid of 1 mm and indexed as a zone of the specification is. It takes milliseconds to
// seconds and allocates: never on the real-time path. What goes there is in zone_slot.h.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "rtac/geometry/zone_slot.h"
#include "rtac/types.h"

namespace rtac {

// Rings in m, closed by themselves (a last vertex that repeats the first one is left out), in
// either direction.
struct ZonePolygon {
  std::vector<Vec2> outer;
  std::vector<std::vector<Vec2>> holes;
};

// Why a zone is refused. `where`: the ring and, where one is at fault, its vertex, counted from 1.
struct ZoneRefusal {
  std::string where, message, help;
};

using MadeZone = std::variant<std::unique_ptr<HeldZone>, ZoneRefusal>;

// The union of the polygons. `edges_most`: what the specification declares, `input fence :
// zone[64]`. More vertices are refused before anything is computed, so that time and memory have
// bounds.
MadeZone make_zone(const std::vector<ZonePolygon>& polygons, std::size_t edges_most);

// The same of well-known text in m: POLYGON, MULTIPOLYGON, two numbers for each position. One with
// heights is refused: such a zone has none.
MadeZone make_zone_of_wkt(const std::string& text, std::size_t edges_most);

// The formats of files in degrees; each states its axes and how rings end.
enum class ZoneFormat { geojson, kml, qgc_plan };
// Which areas of a plan are the zone, for who uploads cannot be asked. `all`, `any`: inside all of
// its inclusions, or inside any, less its exclusions. `exclusions`: those are the zone.
// `unstated`: its only inclusion, less its exclusions; of GeoJSON and KML all areas.
enum class ZoneAreas { unstated, all, any, exclusions };

struct ZoneFile {
  ZoneFormat format = ZoneFormat::geojson;
  // Where (0 m, 0 m) of the map is, as the specification declares it by `origin`: generated classes
  // name it `origin_latitude_deg` and `origin_longitude_deg`.
  double origin_latitude_deg = 0, origin_longitude_deg = 0;
  ZoneAreas areas = ZoneAreas::unstated;
};

// What a file says besides its areas, and the zone does not have: a return point, heights of
// vertices, which no format takes for limits. `where` is a place in the file.
struct ZoneNote {
  std::string where, message;
};

// The same of the text of a file, for zones of the frame `map`: projected as a file of the
// specification is, by whose error the zone is smaller for who has to stay in it, and larger for
// who has to keep out. An area with limits of height or time is refused, and so is a text of
// another format: nothing that limits an area is left out. `where` is a place in the file. What is
// left out is told in `notes`, unless null, of a zone that is made.
MadeZone make_zone_of_file(const std::string& text, const ZoneFile& as, std::size_t edges_most,
                           std::vector<ZoneNote>* notes = nullptr);

}  // namespace rtac
