// Ways that lead nowhere nearer to something: of all places of squares at once. Internal to this
// folder.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace rtac::geometry {

// Errors of the doubles of a search at run time, over coordinates of at most 2^29 mm: a leg that is
// meant to recede does so by as much, in mm^2.
inline constexpr double slack_mm2 = 1;

struct Vec {
  double x = 0, y = 0;
};
// All places within `half` of the middle, on either axis.
struct Box {
  Vec middle;
  double half = 0;
};
inline double squared(double x) {
  return x * x;
}
// Square of the shortest way from p to the box.
inline double nearest_squared(Vec p, const Box& box) {
  const double x = std::max(std::abs(p.x - box.middle.x) - box.half, 0.0);
  const double y = std::max(std::abs(p.y - box.middle.y) - box.half, 0.0);
  return squared(x) + squared(y);
}
// Whether every place of the box is at least so far from p.
inline bool is_beyond(Vec p, const Box& box, double far) {
  return nearest_squared(p, box) >= squared(far);
}
// Square of the longest way between the boxes.
inline double farthest_squared(const Box& a, const Box& b) {
  return squared(std::abs(a.middle.x - b.middle.x) + a.half + b.half) +
         squared(std::abs(a.middle.y - b.middle.y) + a.half + b.half);
}

struct Range {
  double low, high;
};
inline Range along_x(const Box& box) {
  return {box.middle.x - box.half, box.middle.x + box.half};
}
inline Range along_y(const Box& box) {
  return {box.middle.y - box.half, box.middle.y + box.half};
}
// Least (c - p) (p - q) of one axis: concave in p, linear in q.
inline double least_product(double c, Range p, Range q) {
  double least = 1e300;
  for (const double at : {p.low, p.high}) {
    for (const double from : {q.low, q.high}) least = std::min(least, (c - at) * (at - from));
  }
  return least;
}
// Whether the way from anywhere in the box to c leads nowhere nearer to anywhere in the other one.
// What is not negative on either axis is not in doubles either.
inline bool recedes(double on_x, double on_y) {
  return (on_x >= 0 && on_y >= 0) || on_x + on_y >= slack_mm2;
}

inline bool recedes(Vec c, const Box& from, const Box& other) {
  return recedes(least_product(c.x, along_x(from), along_x(other)),
                 least_product(c.y, along_y(from), along_y(other)));
}
// Most (c - p) (p - q) of one axis.
inline double most_product(double c, Range p, Range q) {
  double most = -1e300;
  for (const double from : {q.low, q.high}) {
    const double at = std::clamp((c + from) / 2, p.low, p.high);
    most = std::max(most, (c - at) * (at - from));
  }
  return most;
}
// Whether the way to c leads nearer to the other robot from wherever in their boxes they are.
inline bool comes_nearer(Vec c, const Box& from, const Box& other) {
  return most_product(c.x, along_x(from), along_x(other)) +
             most_product(c.y, along_y(from), along_y(other)) <
         -slack_mm2;
}
// As `recedes`, of all directions between two, by which the one robot is off the other: linear in
// both.
using Octant = std::array<Vec, 2>;
inline bool recedes(Vec c, const Box& from, const Octant& off) {
  return std::all_of(off.begin(), off.end(), [&](Vec v) {
    const double x = v.x * (c.x - from.middle.x) - std::abs(v.x) * from.half;
    const double y = v.y * (c.y - from.middle.y) - std::abs(v.y) * from.half;
    return recedes(x, y);
  });
}
// Some of them.
struct Octants {
  std::array<Octant, 8> all;
  std::size_t count = 0;
  void push_back(const Octant& o) { all[count++] = o; }
  [[nodiscard]] auto begin() const { return all.begin(); }
  [[nodiscard]] auto end() const { return all.begin() + count; }
};
// In which directions the places of one box are off those of another one.
inline Octants octants(const Box& one, const Box& other) {
  Octants all;
  const double half = one.half + other.half;
  const Vec off{one.middle.x - other.middle.x, one.middle.y - other.middle.y};
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      const double x_most = sx * off.x + half, y_most = sy * off.y + half;
      if (x_most <= 0 || y_most <= 0) continue;  // their rims count to the others
      if (x_most >= sy * off.y - half) all.push_back({Vec{sx, 0}, Vec{sx, sy}});
      if (y_most >= sx * off.x - half) all.push_back({Vec{0, sy}, Vec{sx, sy}});
    }
  }
  return all;
}

}  // namespace rtac::geometry
