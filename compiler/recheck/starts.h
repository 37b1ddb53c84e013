// Where bodies may be, once more: places in regions, or hardly beyond them. In m.
#pragma once

#include <vector>

#include "compiler/recheck/grid.h"
#include "compiler/recheck/legs.h"

namespace rtac::recheck {

// What is known of offsets from inside and outside (geometry/region.h).
inline const Rational offsets_round(3, 1000);

class Starts {
 public:
  // Nobody is farther than `off` from all of them.
  Starts(const std::vector<geometry::Region>& regions, double off);
  [[nodiscard]] bool empty() const { return outlines_.empty(); }
  [[nodiscard]] double off() const { return off_; }
  [[nodiscard]] const std::vector<std::vector<Segment>>& outlines() const { return outlines_; }
  // Somebody may be in the square.
  [[nodiscard]] bool may_be_in(const Box& square) const;

 private:
  std::vector<std::vector<Segment>> outlines_;
  double off_;
};

// Whether a place lies inside, even-odd, of one outline.
bool holds(const std::vector<Segment>& outline, Place p);

}  // namespace rtac::recheck
