// A zone that is received as the text of a file in degrees: by the readers, the projection and the
// combination that a file of a specification goes through. Bounded time and memory; never on the
// real-time path.
#pragma once

#include <cstddef>
#include <string>
#include <variant>

#include "compiler/geometry/import/areas.h"
#include "compiler/geometry/place/placer.h"
#include "compiler/geometry/receive/receive_zone.h"

namespace rtac::geometry {

// Which areas of the file are the zone. `all`, `any`: inside all areas to stay in, or inside any;
// areas to keep out of are taken away. `exclusions`: the areas to keep out of are the zone.
// `unstated`: of a file without areas to stay in or keep out of, all; of another one, the only area
// to stay in, less those to keep out of.
enum class FileAreas { unstated, all, any, exclusions };

struct ReceivedFile {
  import::Format format = import::Format::geojson;  // geojson, kml or qgc_plan
  Origin origin;                                    // of the map of the specification
  FileAreas areas = FileAreas::unstated;
};

// Both regions are farther apart by the error of the projection. More than `edges_most` vertices,
// those of circles and within long edges included, are refused before anything is computed of them.
// Limits of height and of time are refused, and so is a file of another format than is said.
std::variant<ReceivedRegions, RefusedZone> receive_file(const std::string& text,
                                                        const ReceivedFile& as,
                                                        std::size_t edges_most);

// Most bytes of such a text: GeoJSON with a vertex in four lines, and KML, stay well below.
constexpr std::size_t file_bytes_most(std::size_t edges_most) {
  return 400 * edges_most + 65'536;
}

}  // namespace rtac::geometry
