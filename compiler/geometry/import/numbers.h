// Numbers in plain text. Internal to this folder.
#pragma once

#include <optional>
#include <string_view>

namespace rtac::geometry::import {

// The whole text as a decimal number, `+` allowed, `nan` and `inf` not; nullopt: it is none, or
// beyond any double.
std::optional<double> parse_number(std::string_view text);

}  // namespace rtac::geometry::import
