// Straight legs from anywhere in a square, and how clear of a boundary they stay. In m.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "compiler/recheck/grid.h"

namespace rtac::recheck {

struct Place {
  double x, y;
};
inline double inner(Place a, Place b) {
  return a.x * b.x + a.y * b.y;
}
// Far from what overflows, and faster than hypot.
inline double length(double x, double y) {
  return std::sqrt(x * x + y * y);
}
inline Place operator-(Place a, Place b) {
  return {a.x - b.x, a.y - b.y};
}
std::array<Place, 4> corners(const Box& b);
Place middle(const Box& b);
double radius(const Box& b);  // of the circle around it
std::array<Box, 4> quarters(const Box& b);

// What of an outline is within a distance of a place.
class Boundary {
 public:
  Boundary(const std::vector<Segment>& all, Place around, double within);
  // A body that needs so much clearance is nowhere in the square.
  [[nodiscard]] bool holds_nobody(const Box& square, double body) const;
  // The leg to there from everywhere in the square keeps the clearance that the robot has there, or
  // else `clearance`, but for what is forgiven.
  [[nodiscard]] bool keeps(const Box& from, Place to, double clearance, double forgiven) const;

 private:
  [[nodiscard]] double gap(Place p) const;
  [[nodiscard]] bool inside(Place p) const;

  const std::vector<Segment>& all_;
  std::vector<Segment> near_;
};

}  // namespace rtac::recheck
