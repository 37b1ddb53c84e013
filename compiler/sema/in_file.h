// Where a vertex of an imported ring is in its file, for messages.
#pragma once

#include <array>
#include <string>

#include "compiler/sema/spec.h"

namespace rtac::sema {

// `(47.39801, 8.54633)`, with as many digits as the file may have.
std::string position_text(const std::array<double, 2>& position);

// `vertex 17 (47.39801, 8.54633)` for the point of this number; of a point within a long edge, the
// vertex where that starts.
std::string vertex_text(const ZonePolygon::InFile& in_file, std::size_t point);

}  // namespace rtac::sema
