// Room for all robots of a decision at once.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/verify/proofs.h"

namespace rtac::verify {

// How far apart the centres of any two robots of the decision are to be, by its properties.
// 0: nothing is asked of the others.
std::int64_t centres_apart_mm(const Subject& s);

// Places in the plane for all robots, each as clear as `all` asks (which is not empty).
class RoomForAll {
 public:
  RoomForAll(const Subject& s, const std::vector<Need>& all);

  // Centres, one a robot and in whole millimetres, any two at least `apart_mm` apart. none: none
  // were found, which shows nothing.
  [[nodiscard]] std::optional<std::vector<geometry::Point>> centres(std::int64_t apart_mm) const;
  // The largest distance below one that no centres were found for, for which they are. none: there
  // is none.
  [[nodiscard]] std::optional<std::int64_t> most_apart_mm(std::int64_t below_mm) const;

 private:
  // In millimetres, which doubles hold exactly.
  struct Spot {
    double x, y;
  };
  using Spots = std::vector<Spot>;
  static double square(const Spot& a, const Spot& b);

  [[nodiscard]] Spots found(double apart_mm) const;
  [[nodiscard]] Spots one_by_one(const Spots& net, double apart_mm) const;
  [[nodiscard]] Spots farthest_first(std::size_t first, double apart_mm) const;

  std::size_t robots_;
  Spots by_row_, by_column_;
};

}  // namespace rtac::verify
