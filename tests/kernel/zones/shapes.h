// Outlines that are hard for tables of edges, in families: the same seed gives the same outlines on
// every machine. All are valid: simple rings that touch each other in single points at most.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "tests/kernel/zones/exact_zone.h"

namespace rtac::kernel_test {

// mt19937_64 is specified bit by bit, the distributions of the library are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  std::int64_t in(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(bits_() % static_cast<std::uint64_t>(high - low + 1));
  }
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }  // [0, 1)
  bool one_in(int n) { return in(1, n) == 1; }

 private:
  std::mt19937_64 bits_;
};

// Vertices lie within +-extent_mm.
constexpr std::int64_t extent_mm = std::int64_t{1} << 29;

enum class Family {
  tiny,      // three or four vertices within 5 mm
  cells,     // squares of a chessboard, touching at corners, some enclosed
  star,      // a star with a star-shaped hole
  round,     // a polygon with 8 to 200 equal sides
  corridor,  // 1 to 3 mm wide, in any direction
  spiky,     // needles inwards and outwards, their tips 1 mm wide
  comb,      // teeth with gaps of 1 to 3 mm
  spiral,    // a corridor that winds
  touching,  // holes that touch each other and the outer ring
  stairs,    // steps of 1 mm along a slope: each vertex is level with others
  runs,      // collinear vertices along every side, not merged
  fence,     // noise on every scale, a hole; vertices half a metre apart
  huge,      // up to the extent
  count,
};
const char* name_of(Family family);
// Somewhere within the extent, at any place as good as another.
Zone random_zone(Family family, Random& random);

// Where answers are delicate: at vertices and on edges, one unit off, on lines through edges, level
// with vertices; or anywhere about the zone.
Place delicate_place(const std::vector<Edge>& edges, Random& random);
// Legs through vertices, along edges, beside them, from place to place.
Edge delicate_leg(const std::vector<Edge>& edges, Random& random);
// Evenly over the box about the zone.
Place uniform_place(const std::vector<Edge>& edges, Random& random);

}  // namespace rtac::kernel_test
