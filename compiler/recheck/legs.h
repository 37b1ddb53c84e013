// Straight legs from anywhere in a square, and how clear of a boundary they stay. In m.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
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
  // What a leg from anywhere in the square has to keep: the clearance that the robot has there, or
  // else `clearance`, but for what is forgiven.
  [[nodiscard]] double asked_from(const Box& square, double clearance, double forgiven) const;
  // The leg from everywhere in the square keeps that.
  [[nodiscard]] bool keeps(const Box& from, Place to, double asked) const {
    return keeps(from, to, to, asked);
  }
  // The same of all legs to between two places no farther from each other than the square is wide.
  [[nodiscard]] bool keeps(const Box& from, Place a, Place b, double asked) const {
    return keeps_to(from, {a, b}, asked);
  }
  // And of all to between several ones.
  [[nodiscard]] bool keeps_to(const Box& from, const std::vector<Place>& ends, double asked) const;
  // The ends of each segment off the place that it was taken around, in whole nm; of one along an
  // axis the parts are left out that are farther off than segments were asked for.
  [[nodiscard]] std::vector<std::array<std::int64_t, 4>> outline() const;

 private:
  [[nodiscard]] double gap(Place p) const;
  [[nodiscard]] bool inside(Place p) const;

  const std::vector<Segment>& all_;
  Place around_;
  double within_;
  std::vector<Segment> near_;
};

}  // namespace rtac::recheck
