// The edges of several rings, and a sweep over them that tells whether any two meet. Exact:
// doubles only decide what they are certain of. Internal to this folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/geometry/region.h"

namespace rtac::geometry {

struct Bounds {
  double lo, hi;
};
inline bool disjoint(const Bounds& a, const Bounds& b) {
  return a.hi < b.lo || b.hi < a.lo;
}

// From vertex `index` of a ring to the next one.
struct Edge {
  const Point* a;
  const Point* b;
  std::size_t ring, index;
  Bounds x, y;                   // contain the exact values
  double ax, ay, bx, by;         // relative to `Edges::origin`
  std::uint32_t rank_a, rank_b;  // order of the vertices by x, then y: the same for equal ones
  [[nodiscard]] bool rising() const { return rank_a < rank_b; }
};

// Edges of all rings, ring by ring. The rings must outlive it.
class Edges {
 public:
  explicit Edges(const std::vector<const Ring*>& rings);

  [[nodiscard]] std::size_t rings() const { return first_.size() - 1; }
  [[nodiscard]] std::size_t first(std::size_t ring) const { return first_[ring]; }
  [[nodiscard]] std::size_t size(std::size_t ring) const { return first_[ring + 1] - first_[ring]; }
  [[nodiscard]] const Edge& operator[](std::size_t i) const { return edges_[i]; }

  // +1: vertex `v` lies on the left of the edge seen along its direction, 0: on its line.
  [[nodiscard]] int side(const Edge& e, const Edge& v, bool second_end) const;
  // The lowest-left common point of two edges; of neighbours in one ring, which always share a
  // vertex, the tip of the spike when the second runs back along the first.
  [[nodiscard]] std::optional<Point> meeting(const Edge& e, const Edge& f) const;

 private:
  void add_ring(const Ring& ring, const Point& origin);
  void rank_vertices();
  [[nodiscard]] bool beside(const Edge& e, const Edge& f) const;
  [[nodiscard]] std::optional<Point> common_point(const Edge& e, const Edge& f) const;

  std::vector<Edge> edges_;
  std::vector<std::size_t> first_{0};
  double error_ = 0;  // of the sign of an orientation in doubles
};

// No ring encloses it.
inline constexpr std::size_t no_ring = static_cast<std::size_t>(-1);

struct Swept {
  bool meet = false;  // two of the edges do
  // Where none do, and the edges are those of whole rings: by ring, the smallest ring around it.
  std::vector<std::size_t> parents;
  std::uint64_t comparisons = 0;  // of two edges: how the work grows
};
// Of the edges [from, to). n log n comparisons, whatever the edges are.
Swept sweep(const Edges& edges, std::size_t from, std::size_t to);

}  // namespace rtac::geometry
