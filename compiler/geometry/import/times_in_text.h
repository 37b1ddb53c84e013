// Whether a text tells a time, whatever way people write it. Internal to this folder.
#pragma once

#include <string_view>

namespace rtac::geometry::import {

// A date, a time of day, days of the week or months: `2024-05-01T08:00Z`, `1.5.24`, `Mon-Fri`,
// `8 am`; not `Route 1234`. Of a huge text only the beginning is looked at.
bool tells_time(std::string_view text);

}  // namespace rtac::geometry::import
