// A retreat takes the leg straight to where its way ends that is in sight, if that is the shorter
// one, whatever the search over cells finds (runtime: retreat). Internal to this folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "compiler/geometry/straight.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// How clear the places are that a recovery looks for one after the other, from what it needs on:
// it aims a little deeper, as far as a way leads there, and who loiters would like to have more
// room still.
std::vector<std::int64_t> goals_mm(const ir::Decision& decision, const ir::Recovery& recovery);

// A cell near the boundary from which a robot may find no way, as it is seen with less clearance
// than its body takes: by its position error, where it has that much. Then it takes no detours over
// cells (runtime: RetreatManoeuvre), but a leg straight in sight to where it is seen to fit.
// `kept_mm`: what its monitor surely keeps from the boundary of `zone` beyond touching it. nullopt:
// from everywhere there is one.
std::optional<std::size_t> led_nowhere(const std::vector<geometry::EdgeRow>& edges,
                                       const ir::Cells& cells, const ir::Decision& decision,
                                       const ir::Recovery& recovery, std::int64_t kept_mm,
                                       const geometry::Region& zone);

// The longest legs by which a recovery leads in who may be seen with less clearance than its body
// takes: the first to where ways begin, or else all the way to where control is given back. 0:
// nobody is; nullopt: it may be seen outside.
struct LedIn {
  std::int64_t first_mm = 0, all_mm = 0;
  std::vector<std::int64_t> from_mm{};  // by cell: the longer one; empty: nobody is
};
std::optional<LedIn> led_in(const std::vector<geometry::EdgeRow>& edges, const ir::Cells& cells,
                            const ir::Decision& decision, const ir::Recovery& recovery);

// By goal and cell.
using Marks = std::vector<std::vector<bool>>;

class InSight {
 public:
  // Of a recovery to a site there are no such legs.
  InSight(const std::vector<geometry::EdgeRow>& edges, const ir::Cells& cells,
          const ir::Decision& decision, const ir::Recovery& recovery);
  InSight(const InSight&) = delete;  // legs refer to its cells
  InSight& operator=(const InSight&) = delete;

  // The longest leg from anywhere in a cell to where it ends; nullopt: from some place of it none
  // is known. Asked once more it says the same.
  std::optional<std::int64_t> longest_mm(std::size_t at, std::size_t goal = 0);
  // Whether none has been looked for from there, since others took too long.
  [[nodiscard]] bool gave_up(std::size_t at) const { return given_up_.contains(at); }
  // The longest leg from anywhere where control is not given back yet, if one is taken from all of
  // it and no way over cells: one to the goal that is tried first, and short enough. nullopt: from
  // some place none is known.
  std::optional<std::int64_t> always_mm();
  // The same of a cell: it is taken from all of it, whatever the search finds.
  std::optional<std::int64_t> surely_taken_mm(std::size_t at);
  // Whether some of the cell may lie in the zone.
  [[nodiscard]] bool holds_some(std::size_t at) const {
    return !legs_.empty() && legs_.back().holds_some(at);
  }
  // The longest leg that may be taken where the search may not lead to a goal beyond the first,
  // from cells of which none is `lost`; nullopt: it may, along a way of which nothing is known.
  std::optional<std::int64_t> longest_deeper_mm(const Marks& lost, const Marks& endless);

 private:
  template <class Visit>
  void for_each_around(std::size_t at, std::int64_t within, const Visit& visit) const;
  [[nodiscard]] std::vector<bool> cut_off(const std::vector<bool>& lost) const;
  [[nodiscard]] std::vector<bool> beside(const std::vector<bool>& lost) const;

  const ir::Cells& cells_;
  const geometry::CellGrid grid_;
  const std::int64_t route_mm_, body_mm_, return_mm_;
  std::int64_t deepest_mm_ = 0;               // of the goals
  std::vector<geometry::StraightLegs> legs_;  // by goal
  std::map<std::pair<std::size_t, std::size_t>, std::optional<std::int64_t>> found_;  // goal, cell
  std::set<std::size_t> given_up_;  // of the first goal
};

}  // namespace rtac::analysis
