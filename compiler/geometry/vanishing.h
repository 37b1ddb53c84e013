// Which edges of a ring vanish when all of them move along their normals: those of an arc that
// moves to its centre. Internal to this folder.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "compiler/geometry/nearby.h"

namespace rtac::geometry {

struct MovingEdge {
  Segment from;
  Vector normal;  // of length 1, where to
};

// Where the lines of the two meet when both have moved so far, seen from their own place: `first`
// comes before `second`, with others between them that are gone or none. nullopt: they are nearly
// parallel.
std::optional<Vector> meeting_after(const MovingEdge& first, const MovingEdge& second,
                                    double distance_m);

// An edge that gets shorter than `least_m` is gone, and its neighbours meet. Only edges vanish
// whose corners both stay points: where neighbours part by more than an angle they do not. It is a
// guess, in doubles, that takes no account of edges that meet others far away.
class Vanishing {
 public:
  Vanishing(const std::vector<MovingEdge>& ring, double distance_m, double least_m,
            double part_rad_max);
  // An edge, and the two it is between by then, meet in a point.
  struct Event {
    std::size_t before, edge, after;
    Vector at;
  };
  struct Result {
    std::vector<std::size_t> remaining;  // in their order
    std::vector<Event> events;           // in theirs
  };
  // nullopt: fewer than three edges remain, or two that come to meet are nearly parallel.
  std::optional<Result> run();

 private:
  [[nodiscard]] bool is_point(std::size_t first, std::size_t second) const;
  [[nodiscard]] std::optional<double> length_after(std::size_t edge, double distance_m) const;
  [[nodiscard]] std::optional<double> vanishes_after(std::size_t edge) const;

  const std::vector<MovingEdge>& ring_;
  double distance_m_, least_m_, part_rad_max_;
  std::vector<std::size_t> before_, after_;  // of those that are left
};

}  // namespace rtac::geometry
