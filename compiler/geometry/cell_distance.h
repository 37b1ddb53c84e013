// Distances between grid squares and boundary edges. Internal to this folder. All coordinates in
// mm, |coordinate| <= 2^29 for edges, <= 2^32 for squares, so that no product below overflows.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/bake.h"

namespace rtac::geometry {

struct Square {
  std::int64_t x_mm, y_mm;  // south-west corner
  std::int64_t side_mm;
};

struct PreparedEdge {
  std::int64_t ax, ay, bx, by;
  std::int64_t dx, dy;
  std::int64_t squared_length;
  // Whether the boundary turns to the right at either end: there the region's angle exceeds 180
  // degrees.
  bool reflex_at_a, reflex_at_b;
};
std::vector<PreparedEdge> prepare_edges(const SnappedZone& zone);

// The edge has a point in the closed square / in its interior.
bool meets_closed(const Square& square, const PreparedEdge& edge);
bool meets_interior(const Square& square, const PreparedEdge& edge);

// Smallest distance between the closed square and the edge, and largest distance of a point of
// the square from the edge (reached at a corner: the distance from a convex set is convex).
// Doubles, with a relative error below 1e-12: for choosing candidates.
double nearest(const Square& square, const PreparedEdge& edge);
double farthest(const Square& square, const PreparedEdge& edge);
// The same, exactly, then rounded down / up.
std::int64_t nearest_floor(const Square& square, const PreparedEdge& edge);
std::int64_t farthest_ceil(const Square& square, const PreparedEdge& edge);

// The edges of `candidates` that can be nearest to some point of the square, those that can decide
// the bound `least_farthest` included.
struct Candidates {
  std::vector<std::uint32_t> edges;
  std::vector<double> nearest;  // of each of them, to the square
  double least_nearest = 0;
  double least_farthest = 0;  // bounds the clearance in the square
  [[nodiscard]] bool meets_boundary() const { return least_nearest == 0; }
};
Candidates narrow(const Square& square, const std::vector<PreparedEdge>& edges,
                  const std::vector<std::uint32_t>& candidates);

// Fewer of them, for a square of at most 2^30 mm: without those that lie farther than one and the
// same point b of the boundary from every place p of the square. That is so when it is so at the
// corners: dist(p, edge)^2 - |p - b|^2 is the least of linear functions of p, one for every point
// of the edge, thus concave, and least at a corner. Points b: those nearest to corners and middle.
Candidates sharpen(const Square& square, const std::vector<PreparedEdge>& edges,
                   const Candidates& near);

// Floor of the square root, exact.
std::uint64_t floor_sqrt(std::uint64_t value);

}  // namespace rtac::geometry
