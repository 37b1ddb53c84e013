// Dates and times of day in ISO 8601, as ED-269 and ED-318 write them. Internal to this folder.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "compiler/geometry/import/areas.h"

namespace rtac::geometry::import {

// `2024-03-31T22:00[:00[.5]]` with `Z`, `+02:00` or `+0200`; nullopt: another text, a day that does
// not exist, or no zone of time, which nobody may guess.
std::optional<std::int64_t> parse_moment_us(std::string_view text);

// Whether a fraction of a second is written in a moment or time, and is not 0.
bool has_fraction_of_second(std::string_view text);

// On the clocks of a zone of time that is `offset_s` ahead of UTC.
struct TimeOfDay {
  std::int32_t earliest_s = 0, latest_s = 0;  // whole seconds around a fraction of one
  std::int32_t offset_s = 0;
};

// `22:00[:00[.5]]` with a zone.
std::optional<TimeOfDay> parse_time_of_day(std::string_view text);

// The periods of UTC days that cover [from, until) of each of the weekdays of `base`, on which it
// begins; an end that is not after the beginning is on the next day. With the moments of `base`.
std::vector<Period> daily_periods(const Period& base, TimeOfDay from, TimeOfDay until,
                                  std::int32_t longer_s = 0);
}  // namespace rtac::geometry::import
