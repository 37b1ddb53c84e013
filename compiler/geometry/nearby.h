// Distances between segments in doubles, and which of many lie near one another. Internal to this
// folder.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace rtac::geometry {

struct Vector {
  double x, y;
};
inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y};
}
inline Vector operator*(double k, const Vector& v) {
  return {k * v.x, k * v.y};
}
inline double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y;
}
inline double cross(const Vector& a, const Vector& b) {
  return a.x * b.y - a.y * b.x;
}

struct Segment {
  Vector a, b;
};
double distance(const Vector& p, const Segment& s);
// Of segments that do not cross.
double distance(const Segment& s, const Segment& t);

// Boxes around segments, halved again and again: finds those near another one in log n.
class Nearby {
 public:
  // Of segments that must outlive it.
  explicit Nearby(const std::vector<Segment>& segments);
  // How far the nearest one is from `p`, or `most_m` where none is nearer.
  [[nodiscard]] double nearest(const Vector& p, double most_m) const;
  // Calls `visit` with the index of each that is no farther from `p`.
  void each_within(const Vector& p, double distance_m,
                   const std::function<void(std::size_t)>& visit) const;
  // Does every segment keep that distance from `s`?
  [[nodiscard]] bool keeps(const Segment& s, double distance_m) const {
    return segments_.empty() || keeps(0, segments_.size(), 0, s, distance_m);
  }

 private:
  struct Box {
    double x0, y0, x1, y1;
  };
  static Box box(const Segment& s);
  // The halves of node i are 2 i + 1 and 2 i + 2.
  Box build(std::size_t from, std::size_t to, std::size_t node, int axis);
  [[nodiscard]] bool keeps(std::size_t from, std::size_t to, std::size_t node, const Segment& s,
                           double distance_m) const;
  struct Part {
    std::size_t from, to, node;
  };
  [[nodiscard]] Part all() const { return {0, segments_.size(), 0}; }
  [[nodiscard]] double to_box(const Vector& p, const Part& part) const;
  void shorten(const Part& part, const Vector& p, double& least) const;
  void visit(const Part& part, const Vector& p, double distance_m,
             const std::function<void(std::size_t)>& each) const;

  const std::vector<Segment>& segments_;
  std::vector<std::size_t> order_;
  std::vector<Box> boxes_;
};

}  // namespace rtac::geometry
