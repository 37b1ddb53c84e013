// What a picture of the zones of a specification shows: plain data, in metres.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/driver/compile.h"
#include "compiler/geometry/region.h"

namespace rtac::driver {

// The centre of a robot stays so far from the boundary, for these reasons.
struct ZoneErosion {
  std::int64_t distance_mm;
  std::string reasons;
  geometry::Region region;  // may be empty
};
struct ZoneLayer {
  std::string name;
  std::string origin;      // file and line, and what is written there
  std::string conditions;  // what it moves with and when it is there; may be empty
  geometry::Region region;
  std::vector<ZoneErosion> erosions;  // by distance
  std::vector<std::string> remarks;   // what is mended; what is not shown, and why
};
struct SiteMark {
  std::string name;
  double x_m, y_m;
};
// What lies in one frame of coordinates.
struct ZoneSheet {
  std::string frame;
  std::vector<ZoneLayer> layers;
  std::vector<SiteMark> sites;
};

// Erosions of zones with more vertices are not drawn: they take minutes.
inline constexpr std::size_t eroded_vertices_max = 20'000;

// Frames without zones and sites are left out.
std::vector<ZoneSheet> zone_sheets(const Compilation& c);

}  // namespace rtac::driver
