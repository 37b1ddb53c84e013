// Properties of plain GeoJSON and data of KML, which may be anything, that limit an area for the
// program that wrote them. Nobody else can tell how; that they are there must be told. Internal to
// this folder.
#pragma once

#include <string_view>

#include "compiler/geometry/import/json_tree.h"

namespace rtac::geometry::import {

// In height: `"upperLimit": 120`, `"floor": "FL95"`; not `"floor": "lobby"`, and not
// `"altitudeMode": "clampToGround"`, which is no height.
bool is_limit_of_height(Json property);
// In time: `"valid_from": "2024-05-01"`, `"schedule": "Mon-Fri"`; not `"expires": "never"`, and not
// `"start": "Route 12"`.
bool is_limit_of_time(Json property);
// The same of values that are text.
bool is_limit_of_height(std::string_view name, std::string_view text);
bool is_limit_of_time(std::string_view name, std::string_view text);

}  // namespace rtac::geometry::import
