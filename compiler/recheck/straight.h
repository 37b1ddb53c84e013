// Legs straight to where a retreat ends, once more: of a place from which no way leads over cells.
// In m.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/recheck/grid.h"
#include "compiler/recheck/legs.h"
#include "compiler/recheck/starts.h"

namespace rtac::recheck {

class Straight {
 public:
  // `zone` and `grid` have to outlive it. Where the zone is `convex`, every leg to a goal keeps
  // what the robot has.
  Straight(const std::vector<Segment>& zone, const Grid& grid, double body, bool convex);
  // Only places count from then on where somebody may be.
  void begin_at(Starts starts) { starts_ = std::move(starts); }
  // How long the leg is that is taken from any place of a cell to one that is so clear, at most;
  // a body that has as much needs none. nullopt: from some place none is known that is no longer
  // than `most`.
  std::optional<double> longest_from(std::size_t cell, double goal, double most = 1e300);
  // Of a cell whose middle lies outside: whether the boundary may be in it.
  [[nodiscard]] bool holds_some(std::size_t cell) const { return met_[cell]; }
  // To the farthest one that may be tried from anywhere in the cell; 0: there is none.
  [[nodiscard]] double farthest_from(std::size_t cell, double goal) const;

 private:
  // How many of the cells that are off by one ring the search tries.
  struct Tried {
    int surely = 0, perhaps = 0;
  };
  template <class Visit>
  Tried visit_ring(std::size_t cell, int ring, const Visit& visit) const;
  std::optional<double> longest_in(const Boundary& boundary, const Box& from, double goal,
                                   double most, const std::vector<Place>& ends, int times);
  [[nodiscard]] std::vector<bool> met() const;

  const std::vector<Segment>& zone_;
  const Grid& grid_;
  const double body_;
  const bool convex_;
  const std::vector<bool> met_;   // by cell: the boundary may be there
  std::optional<Starts> starts_;  // none: anywhere
  std::int64_t steps_ = 0, steps_end_ = 0;
};

}  // namespace rtac::recheck
