// What ED-269 and ED-318 have in common: periods, limits of height, restrictions. Internal to this
// folder.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compiler/geometry/import/json_reader.h"

namespace rtac::geometry::import {

// Adds the periods of an object with `startDateTime`, `endDateTime` and `schedule`, which may all
// be missing. A schedule that follows the sun, or says no times, refuses the area.
bool add_periods(JsonReader& json, Json period, Area& area);

// The names of the members of one limit of height.
struct LimitNames {
  std::string_view value, reference;
};

// Missing limits are open. `metres` are those of the unit that the limits are in.
bool read_limits(JsonReader& json, Json object, LimitNames lower, LimitNames upper, double metres,
                 Band& band);

// `M` and `FT`, or `m` and `ft`: nullopt, with a failure, for anything else.
std::optional<double> metres_of_unit(JsonReader& json, Json object, std::string_view name);

// Only a prohibition says on which side of the outline to stay. The others depend on permissions,
// which the specification has to know.
bool set_restriction(JsonReader& json, Json object, std::string_view name, Area& area);

}  // namespace rtac::geometry::import
