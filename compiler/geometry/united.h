// Many regions as one.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "compiler/geometry/region.h"

namespace rtac::geometry {

// What a combination may cost. A place where two edges cross takes about 0.3 ms and 10 kB, one
// where they touch or lie on one another a thirtieth of it.
inline constexpr std::size_t crossings_max = 30'000, touches_max = 30 * crossings_max;

// Looks at two edges, or at boxes around edges, to find those places: 10^9 take seconds.
inline constexpr std::size_t looks_max = 1'000'000'000;

// Of the boundaries of different regions, a touch being 1; more than touches_max: too often, or too
// many of them lie side by side. Equal regions count as one.
std::size_t meeting_cost(const std::vector<Region>& regions);
bool cross_too_often(const std::vector<Region>& regions);

// The union, in one sweep, however many they are; of equal ones one is taken. nullopt: they cross
// too often.
std::optional<Region> united(std::vector<Region> regions);

}  // namespace rtac::geometry
