// Is what the author wrote a polygon with holes? Internal to this folder.
#pragma once

#include <optional>
#include <vector>

#include "compiler/geometry/region.h"

namespace rtac::geometry {

// The first problem in the order that Problem states; nullopt: valid.
std::optional<Problem> find_problem(const Ring& outer, const std::vector<Ring>& holes);

}  // namespace rtac::geometry
