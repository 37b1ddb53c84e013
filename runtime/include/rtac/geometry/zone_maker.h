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

// The same of well-known text in m: POLYGON, MULTIPOLYGON.
MadeZone make_zone_of_wkt(const std::string& text, std::size_t edges_most);

}  // namespace rtac
