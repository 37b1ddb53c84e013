// Properties of plain GeoJSON, which may be anything, that limit an area for the program that wrote
// them. Nobody else can tell how; that they are there must be told. Internal to this folder.
#pragma once

#include "compiler/geometry/import/json_tree.h"

namespace rtac::geometry::import {

// In height: `"upperLimit": 120`, `"floor": "FL95"`; not `"floor": "lobby"`, and not
// `"altitudeMode": "clampToGround"`, which is no height.
bool is_limit_of_height(Json property);
// In time: `"valid_from": "2024-05-01"`, `"schedule": "08:00-17:00"`.
bool is_limit_of_time(Json property);

}  // namespace rtac::geometry::import
