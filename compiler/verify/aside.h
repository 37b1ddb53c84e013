// Where the other robots of a fleet begin a run that is about one of them.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/verify/proofs.h"

namespace rtac::verify {

// Of robots that do not begin at one of `begins`, but for one as many as there are: each where
// every property holds with what a robot at rest needs to spare, as far from all others as there is
// room. Coordinates in mm, as those of `begins`; fewer, where a grid shows no more room.
std::vector<std::vector<std::int64_t>> aside_of(
    const Subject& s, const std::vector<std::vector<std::int64_t>>& begins);

}  // namespace rtac::verify
