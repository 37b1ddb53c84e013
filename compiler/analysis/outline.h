// The boundary of a zone in doubles, in mm, to look for places where something goes wrong: what is
// proved, and what kernels decide, is exact (compiler/geometry).
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "compiler/geometry/region.h"
#include "compiler/ir/module.h"

namespace rtac::analysis::outline {

struct P {
  double x = 0, y = 0;
};
inline P operator+(P a, P b) {
  return {a.x + b.x, a.y + b.y};
}
inline P operator-(P a, P b) {
  return {a.x - b.x, a.y - b.y};
}
inline P operator*(double k, P a) {
  return {k * a.x, k * a.y};
}
double norm(P a);

struct Segment {
  P a, b;
};

// The boundary of a zone, and on which side of it a place lies.
class Outline {
 public:
  explicit Outline(std::vector<Segment> edges) : edges_(std::move(edges)) {}
  static Outline of(const geometry::Region& region);
  static Outline of(const ir::ZoneTable& zone);

  [[nodiscard]] const std::vector<Segment>& edges() const { return edges_; }
  [[nodiscard]] bool contains(P p) const;
  [[nodiscard]] P nearest(P p) const;
  // Negative outside.
  [[nodiscard]] double clearance(P p) const;
  // Whether every place of a segment is so clear.
  [[nodiscard]] bool keeps(P a, P b, double least) const;
  // Where a segment is farthest outside, and how far; none: it stays within, give or take
  // `strays_mm`.
  struct Outside {
    P at;
    double deep;
  };
  [[nodiscard]] std::optional<Outside> left_on(P a, P b, double strays_mm) const;

 private:
  std::vector<Segment> edges_;
};

}  // namespace rtac::analysis::outline
