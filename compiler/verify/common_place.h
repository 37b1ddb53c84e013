// A place that is clear enough of the boundaries of several zones at once.
#pragma once

#include <optional>
#include <vector>

#include "compiler/verify/proofs.h"

namespace rtac::verify {

// Whether a place is as clear of each zone as is asked.
bool is_clear(const Subject& s, const std::vector<Need>& all, const geometry::Point& p);

// In the plane: of the cells of the narrowest zone or its widest one, or else, to a millimetre, of
// all that is left of the zones. `all` is not empty.
std::optional<geometry::Point> common_place(const Subject& s, const std::vector<Need>& all);

// Where a robot fits into all of them, whether control is given back there or not.
std::optional<geometry::Point> any_place(const Subject& s, std::vector<Need> all);

}  // namespace rtac::verify
