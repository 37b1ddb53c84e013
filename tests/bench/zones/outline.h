// Outlines on the grid of millimetres, and places and legs to ask about. The same seed gives the
// same ones on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/fences.h"

namespace rtac::bench {

struct GridPlace {
  std::int32_t x_mm, y_mm;
};
struct Outline {
  std::string name;
  std::vector<std::vector<GridPlace>> rings;  // the first one is the outer one
  [[nodiscard]] std::size_t vertices() const;
};
Outline outline_of(const std::string& name, const Fence& fence);
// As well-known text, in metres.
std::string well_known_text(const Outline& outline);

// Evenly over the box about the outline.
std::vector<GridPlace> uniform_places(const Outline& outline, std::size_t count,
                                      std::uint64_t seed);
// Within `near_mm` of places on its edges, each vertex as likely as the other.
std::vector<GridPlace> near_places(const Outline& outline, std::int32_t near_mm, std::size_t count,
                                   std::uint64_t seed);
// As one robot sees them that moves along the outline, `step_mm` from tick to tick, and by a step
// at most towards it or off it, within `near_mm`.
std::vector<GridPlace> way_places(const Outline& outline, std::int32_t near_mm,
                                  std::int32_t step_mm, std::size_t count, std::uint64_t seed);
// Legs of up to `length_mm` from such places: from places[2 i] to places[2 i + 1].
std::vector<GridPlace> legs_from(const std::vector<GridPlace>& starts, std::int32_t length_mm,
                                 std::uint64_t seed);

}  // namespace rtac::bench
