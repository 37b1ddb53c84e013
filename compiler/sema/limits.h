// What an input can be at all: declared limits on its grid, and how far one without limits is
// taken to go. Both are part of the meaning of a specification, so that whoever judges it, on exact
// numbers or on integers, takes the same values for unknown.
#pragma once

#include <cstdint>

#include "compiler/sema/spec.h"

namespace rtac::sema {

// The widest grid that any value is counted on: doubles are exact on all of it.
inline constexpr std::int64_t grid_steps_max = 1'000'000'000'000'000;

// In steps of the grid, to either side: beyond it an input without limits is unknown. Coordinates
// are squared in norms, so it is less for them.
std::int64_t reach_steps(const Input& input);

// Takes limits between two steps of the grid outward to the next one: what is known includes all
// that was declared. Whole numbers lie on no step in between: inward, which leaves none of them
// out.
void round_limits(Input& input);

}  // namespace rtac::sema
