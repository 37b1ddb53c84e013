// Outlines as they occur in the field, of any number of vertices: for timing exact geometry. The
// same seed gives the same outline on every machine.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/region.h"

namespace rtac::bench {

struct Fence {
  geometry::Ring outer;
  std::vector<geometry::Ring> holes;
};

// Where vertices lie: on the 1 mm grid, as surveyed plans give them, or off it, as positions on the
// globe become after projection.
enum class Vertices { on_grid, off_grid };

// A rough ring about the origin, noise on every vertex, with a tenth of the vertices in round
// holes.
Fence noisy_star(std::size_t vertices, Vertices where, std::uint64_t seed);
// The same with noise as high as neighbouring vertices are apart, so that its edges stay short.
Fence mild_star(std::size_t vertices, Vertices where, std::uint64_t seed);
// A regular polygon, with a tenth of the vertices in round holes.
Fence circle_fence(std::size_t vertices, Vertices where, std::uint64_t seed);
// A coast: roughness on every scale, bays behind narrow entries; islands in it are holes.
Fence coast(std::size_t vertices, Vertices where, std::uint64_t seed);
// Long narrow teeth side by side: every vertical line meets few edges, every horizontal one all.
Fence comb(std::size_t vertices, Vertices where, std::uint64_t seed);

}  // namespace rtac::bench
