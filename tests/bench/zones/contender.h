// Ways to ask about a zone. Each is prepared once for an outline and for the places that it will be
// asked about, so that only the asking is timed.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "tests/bench/zones/outline.h"

namespace rtac::bench {

enum class Question {
  inside,     // is the place in the zone
  clearance,  // how far is it from the boundary
  leg,        // does the leg meet the boundary, and how far is it from it
};

struct Contender {
  std::string name;
  // Asks about the places (legs: pairs of places) from `first` up to `end`; a sum of the answers.
  std::function<double(std::size_t first, std::size_t end)> ask;
  // Whether the sum is the number of places inside, or of distances in mm: else it is something
  // weaker, that can only be timed.
  bool is_comparable = true;
};

// What a library has for a question, at its best; none where it has nothing, or is not installed.
std::vector<Contender> cgal_inside(const Outline& outline, const std::vector<GridPlace>& places);
std::vector<Contender> cgal_clearance(const Outline& outline, const std::vector<GridPlace>& places);
std::vector<Contender> cgal_legs(const Outline& outline, const std::vector<GridPlace>& legs);
std::vector<Contender> geos_contenders(Question question, const Outline& outline,
                                       const std::vector<GridPlace>& places);

}  // namespace rtac::bench
