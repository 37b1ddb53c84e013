// One reader per format. `text` is UTF-8 without a byte order mark. Internal to this folder.
#pragma once

#include <string_view>
#include <variant>

#include "compiler/geometry/import/areas.h"

namespace rtac::geometry::import {

using Outcome = std::variant<Areas, Failure>;

Outcome read_geojson(std::string_view text, const Limits& limits);
Outcome read_ed269(std::string_view text, const Limits& limits);
Outcome read_ed318(std::string_view text, const Limits& limits);
Outcome read_kml(std::string_view text, const Limits& limits);
Outcome read_qgc_plan(std::string_view text, const Limits& limits);
Outcome read_waypoints(std::string_view text, const Limits& limits);
Outcome read_wkt(std::string_view text, const Limits& limits);

}  // namespace rtac::geometry::import
