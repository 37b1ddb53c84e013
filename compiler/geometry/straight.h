// Legs that lead a recovery straight to the end of its way (runtime: grid_route), where no way over
// cells does: out of a corner, along whose middle cells have no neighbour that is clearer.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "compiler/geometry/bake.h"
#include "compiler/geometry/connectors.h"
#include "compiler/geometry/starts.h"

namespace rtac::geometry {

class StraightLegs {
 public:
  // To the middles of cells that are clearer than `goal_mm`; a place that is so clear needs none,
  // and a body of less than `body_mm` of clearance is nowhere. Of cells only `clearance_mm_lo`
  // counts. `edges` and `cells` have to outlive it.
  StraightLegs(const std::vector<EdgeRow>& edges, const CellGrid& cells, std::int32_t body_mm,
               std::int32_t goal_mm);
  // The same of places that are no farther than `error_mm` from some of `starts`.
  StraightLegs(const std::vector<EdgeRow>& edges, const CellGrid& cells, std::int32_t body_mm,
               std::int32_t goal_mm, const Region& starts, std::int32_t error_mm);
  // In mm, of the leg that is taken from any place of the cell, at most; nullopt: from some place
  // none is known, or it may be longer than `most_mm`.
  [[nodiscard]] std::optional<double> longest_from(
      std::size_t cell, double most_mm = std::numeric_limits<double>::infinity());
  // Whether some of the cell may lie in the zone; of what does not there is nothing to ask.
  [[nodiscard]] bool holds_some(std::size_t cell) const {
    return cells_.clearance_mm_lo[cell] >= 0 || beside_[cell];
  }
  // Whether the last one has not been looked for, since those before it took too long.
  [[nodiscard]] bool gave_up() const { return gave_up_; }
  // In mm, to the farthest one that may be tried from anywhere in the cell; 0: there is none.
  [[nodiscard]] double farthest_from(std::size_t cell) const;

 private:
  struct End {
    Landing at;
    double off_mm;                                  // from the middle of the cell
    std::uint32_t refused_by = Connectors::nobody;  // the last one
  };
  // Those that are tried, whichever place of the cell it is; or, `perhaps`, may be.
  [[nodiscard]] std::vector<End> ends_of(std::size_t cell, bool perhaps) const;
  // Appends those of one ring; how many of its cells are tried: at most, or, `perhaps`, at least.
  int add_ring(std::size_t cell, std::int32_t ring, bool perhaps, std::vector<End>& ends) const;
  [[nodiscard]] std::int32_t least_mm(bool perhaps) const;
  [[nodiscard]] bool needs_none(const Connectors::Spot& spot) const;
  // Of `ends`, which are in sight from some places of what the spot is a part of, perhaps.
  std::optional<double> longest_in(const Connectors::Spot& spot, std::vector<End> ends,
                                   double most_mm, int halvings);

  const CellGrid& cells_;
  const std::int32_t goal_mm_;
  const std::int32_t clearest_mm_;  // of all cells
  const bool convex_;
  const std::vector<bool> beside_;  // by cell: the recheck may take it for one that is tried
  std::optional<Starts> starts_{};
  Connectors legs_;                         // what they keep
  Connectors around_;                       // of places
  std::int64_t looks_ = 0, looks_end_ = 0;  // so many taken, and where a cell has had its share
  bool gave_up_ = false;
};

}  // namespace rtac::geometry
