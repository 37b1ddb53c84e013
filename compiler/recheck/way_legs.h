// Of how many straight legs a retreat's way consists, once more. In m.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "compiler/recheck/zones.h"

namespace rtac::recheck {

// Of any way that the search may find from the middle of a cell on, to the nearest cell that is as
// clear as one of the goals, each by itself: over cells as clear as `route`, or as where it starts,
// which is `body` at least. nullopt: not known, as of outlines that do not run along the axes.
std::optional<std::size_t> legs_of_ways(const geometry::Region& zone, const Cells& cells,
                                        const Rational& body, const Rational& route,
                                        const std::vector<Rational>& goals);
// The same of ways over cells as clear as `route` to each of the sites, by itself.
std::optional<std::size_t> legs_to_sites(const geometry::Region& zone, const Cells& cells,
                                         const Rational& route,
                                         const std::vector<geometry::Point>& sites);
// The longest legs in sight that are taken by who is seen with less than its `body` takes, but at
// least `seen`, from anywhere in the zone: the first to a place as clear as `route`, or else all
// the way to one as clear as the last of `aims` that is in sight.
struct LedIn {
  Rational first, all;
  std::vector<double> from;  // by cell: the longer one
};
std::optional<LedIn> leads_in_within(const geometry::Region& zone, const Cells& cells,
                                     const Rational& seen, const Rational& body,
                                     const Rational& route, const std::vector<Rational>& aims);

}  // namespace rtac::recheck
