// The boundary of a zone, in exact numbers: which places lie inside, and how far from it they are.
#pragma once

#include <utility>
#include <vector>

#include "compiler/geometry/region.h"
#include "compiler/interp/number.h"

namespace rtac::interp {

struct Place {  // m
  Rational x, y;
};
inline Place minus(const Place& a, const Place& b) {
  return {a.x - b.x, a.y - b.y};
}
inline Rational cross(const Place& a, const Place& b) {
  return a.x * b.y - a.y * b.x;
}
inline Rational dot(const Place& a, const Place& b) {
  return a.x * b.x + a.y * b.y;
}

class Outline {
 public:
  // Of a region that is not empty.
  explicit Outline(const geometry::Region& region);

  // The boundary belongs to the zone.
  [[nodiscard]] bool contains(const Place& place) const;
  // Of every place of the straight way from one to the other.
  [[nodiscard]] bool contains(const Place& from, const Place& to) const;
  // Between a place and the boundary.
  [[nodiscard]] Root distance(const Place& place) const { return square_root(square_to(place)); }
  [[nodiscard]] Rational square_to(const Place& place) const;
  // Between that way and the boundary.
  [[nodiscard]] Root distance(const Place& from, const Place& to) const;
  // No place of this box is farther from the zone, no place of the zone farther from its boundary.
  [[nodiscard]] Rational farthest(const Place& low, const Place& high) const {
    return square_root(square_of_farthest(low, high)).above;
  }
  [[nodiscard]] Rational square_of_farthest(const Place& low, const Place& high) const;
  [[nodiscard]] Rational deepest() const;
  // The corners of the rectangle around it.
  [[nodiscard]] std::pair<Place, Place> extent() const;

 private:
  struct Edge {
    Place a, b, d;
    Rational square;  // of its length
    // Doubles find the edges that may matter; exact numbers decide.
    double ax, ay, dx, dy;
    double x1, y0, y1;  // its right end, its lower and its upper one
  };
  static Edge edge(const Place& a, const Place& b);
  // Where the way meets the boundary, as shares of it between 0 and 1, in order, not its ends.
  [[nodiscard]] std::vector<Rational> meetings(const Edge& way) const;
  static Rational square_to(const Edge& edge, const Place& place);
  [[nodiscard]] double slack(double x, double y) const;

  std::vector<Edge> edges_;
  double reach_ = 0;  // of the largest coordinate
};

}  // namespace rtac::interp
