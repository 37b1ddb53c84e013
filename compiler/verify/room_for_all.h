// Room for all robots of a decision at once.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "compiler/verify/proofs.h"

namespace rtac::verify {

// Where a robot is given back: places of the plane, or all of one height.
struct Floor {
  std::vector<geometry::Ring> around;  // none of them lies outside of the box of these
  std::size_t corners = 0;             // of zones, which each look at a place goes through
  std::function<bool(const geometry::Point&)> has;
  std::optional<std::int64_t> z_mm{};
};

// Places for all robots on such a floor.
class RoomForAll {
 public:
  RoomForAll(std::size_t robots, const Floor& floor);

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

// Of zones of the plane, where a robot is as clear as `all` asks.
Floor floor_of(const Subject& s, const std::vector<Need>& all);

// Of `o`, by which one robot at rest is given back on that floor, that all of them are, while each
// keeps from the others what it is asked. As it is where nothing is asked of others.
Obligation all_at_once(const Subject& s, const std::vector<Need>& zones, const Floor& floor,
                       Obligation o);

// To `o`, what works, or may, instead of a distance that leaves no room for all robots in these
// zones of the plane: a smaller one, or a wider zone.
void offer_room(const Subject& s, const std::vector<Need>& zones, Obligation& o);

}  // namespace rtac::verify
