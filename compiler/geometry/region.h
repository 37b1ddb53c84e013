// Exact planar regions. The only place, with its siblings in this folder, that knows CGAL; what
// leaves it is plain data. All coordinates are exact rationals in metres, map frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/support/rational.h"

namespace rtac::geometry {

struct Point {
  Rational x, y;
  friend bool operator==(const Point&, const Point&) = default;
};
using Ring = std::vector<Point>;

struct PolygonWithHoles {
  Ring outer;               // counter-clockwise
  std::vector<Ring> holes;  // clockwise
};

// Why a polygon as written is not one. `ring` 0 is the outer ring, 1.. the holes in order;
// `vertex` is the index in that ring as written. Problems are looked for in the order of `Kind`,
// then of ring and vertex; of two edges or holes, by the later one first.
struct Problem {
  enum class Kind {
    too_short,        // fewer than three different vertices
    repeats_vertex,   // `vertex` equals vertex `other`, which comes first
    self_intersects,  // edge from `vertex` meets the edge from `other` at `where`
    no_area,          // all vertices on one line
    // `vertex` of hole `ring` lies outside, at `where`. Or its edge from there (`of_edge`) meets
    // the edge from `other` of the outer ring at `where`, and neither of its ends is outside.
    // Rings may touch in points.
    hole_outside_ring,
    // Holes `ring` < `other` (both ring numbers) cross at `where`, on the edge from `vertex` of
    // `ring`, or share a part of it (`of_edge`); or one lies inside the other and `where` is the
    // inner one's vertex 0.
    holes_overlap,
    // Hole `ring` touches ring `other`, at `where` on its edge from `vertex`, and with that touch
    // rings that touch one another surround a part of the area: it is in two pieces.
    cuts_area,
  };
  Kind kind;
  std::size_t ring = 0, vertex = 0, other = 0;
  Point where;
  bool of_edge = false;
};

// Edges of the polygon that stands for a circle, radius in m: 32 to 256, the least power of two
// with which it is within 1 cm of the circle. How far off it is at most, in m; of large circles
// that is up to 1/12,000 of the radius.
std::size_t circle_edges(const Rational& radius);
Rational circle_error(const Rational& radius, std::size_t edges);

inline constexpr std::size_t offset_vertices_max = 20'000;

// How much farther than it is told an offset may reach, at most, whatever the distance: round
// corners become polygons, of more edges the larger they are. Whoever needs the other side moves by
// so much less. Of offsets within one another, each takes its share: told how many there are, none
// more than 1,000, they reach no farther together.
inline constexpr std::int64_t offset_excess_um = 1000;
Rational offset_excess_m(std::size_t nested = 1);

class Region {
 public:
  Region();  // empty
  ~Region();
  Region(const Region&);
  Region(Region&&) noexcept;
  Region& operator=(Region);

  // Any orientation, closed implicitly. Collinear vertices are merged silently.
  static std::variant<Region, Problem> polygon(const Ring& outer, const std::vector<Ring>& holes);
  // Every point about which the rings wind at least once: outer rings counter-clockwise, holes
  // clockwise; they may overlap and touch.
  static Region of_rings(const std::vector<Ring>& rings);
  // The places that coordinates on the grid may name: a square of 1,072 km about the origin.
  static Region everywhere();
  // A regular polygon of `circle_edges` inscribed in the circle (inner) or circumscribed about it
  // (!inner), with rational vertices that lie exactly inside / outside.
  static Region circle(const Point& centre, const Rational& radius, bool inner);

  [[nodiscard]] Region unite(const Region& other) const;
  [[nodiscard]] Region intersect(const Region& other) const;
  [[nodiscard]] Region subtract(const Region& other) const;
  // One-sided: every point of the result has a distance of at least `distance` to the complement.
  // The result may be smaller than the true erosion, by a few um where the boundary is convex or
  // straight; round reflex corners are polygonised from the inside, within
  // `offset_excess_m(nested)`. A distance of zero or less changes nothing.
  [[nodiscard]] Region shrink(const Rational& distance, std::size_t nested = 1) const;
  // One-sided: contains every point within `distance` of the region; at most
  // `offset_excess_m(nested)` larger. A distance of zero or less changes nothing.
  [[nodiscard]] Region grow(const Rational& distance, std::size_t nested = 1) const;

  // The region grown by `distance`, or shrunk by its amount if it is negative. nullopt: that would
  // take minutes, of more than `offset_vertices_max` vertices with corners that become round.
  [[nodiscard]] std::optional<Region> offset(const Rational& distance,
                                             std::size_t nested = 1) const;

  // What a region may be whose boundary is off by `error` at most, grown or (negative) shrunk: as
  // by `offset`, but at corners up to twice as far, so that it has few more vertices.
  [[nodiscard]] std::optional<Region> widened(const Rational& error) const;

  [[nodiscard]] bool empty() const;
  [[nodiscard]] std::size_t vertices() const;
  [[nodiscard]] bool contains(const Point& p) const;       // closed
  [[nodiscard]] bool contains(const Region& other) const;  // other is a subset of this, exactly
  [[nodiscard]] Rational area() const;
  // Connected components in a canonical order (by lowest-left vertex: the lowest, of
  // several the leftmost), each ring starting at its lowest-left vertex, without collinear
  // vertices. Every ring is simple; where a region touches itself, rings share a point: the same
  // region always gives the same list.
  [[nodiscard]] std::vector<PolygonWithHoles> polygons() const;
  // The rings of all of them.
  [[nodiscard]] std::vector<Ring> rings() const;

 private:
  explicit Region(std::vector<PolygonWithHoles> canonical_parts);

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rtac::geometry
