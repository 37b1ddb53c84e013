// When control comes back (theory, P2b): how far a recovery has to drive over the cells of its
// zone, how long that takes, and from where no way leads to a place where control can be given
// back.
#pragma once

#include <optional>
#include <vector>

#include "compiler/geometry/bake.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// A part of a zone where the robot can be and from where no way leads to a goal.
struct Stranded {
  std::int64_t x_mm = 0, y_mm = 0;                // its widest cell, the first one
  std::int64_t middle_x_mm = 0, middle_y_mm = 0;  // the one among these that is in their middle
  std::int64_t clearance_mm = 0;                  // of all of that cell
  std::int64_t cells = 0;
};
struct Ways {
  // The longest one, of those places that have one; none: no bound was found. The leg to where its
  // cells begin is left out, up to `joins_within_mm`.
  std::optional<std::int64_t> longest_mm = 0;
  std::vector<std::int64_t> rest_mm;  // by cell, from its middle on
  std::vector<std::int64_t> from_mm;  // by cell: from any place of it, what joins it included
  std::optional<std::int64_t> deeper_mm = 0;  // a leg that may be taken as well, from some cell
  std::vector<bool> lost;                     // by cell: from some place of it no way is known
  std::vector<bool> unseen;        // by cell: to look for one would take too long; may be empty
  std::vector<Stranded> stranded;  // the parts that lost cells make up, the largest first
};
// The ways that the search of a recovery finds (rtac/safe/grid_route.h): over cells as clear as
// `route_mm`, or as the cell it starts from; from every cell as clear as `body_mm`.
Ways ways_to(const ir::Cells& cells, const std::vector<bool>& goals, std::int64_t body_mm,
             std::int64_t route_mm);

// Corridors and rooms that are wide enough for a body, and nowhere wide enough for control to be
// given back: what is more than two clearances of return away from where it is.
std::vector<Stranded> narrow_parts(const ir::Cells& cells, std::int64_t body_mm,
                                   std::int64_t return_mm);

// The narrowest places between rooms that are `need_mm` wide on either side, as clear as a body at
// least: the narrowest first.
std::vector<Stranded> passages(const ir::Cells& cells, std::int64_t body_mm, std::int64_t need_mm);

// How far off the cells of a way begin, mostly: of those within this, at the one with the shortest
// way, and else at the nearest one (connector_reach_m of the search).
std::int64_t joins_within_mm(const ir::Cells& cells);

// Where a recovery leads and for how long; of one that stands nothing.
Ways ways_of(const ir::Module& module, const ir::Decision& decision, const ir::Recovery& recovery);
// The same if its zone had these cells, but for whether ways begin from everywhere.
Ways ways_over(const ir::Cells& cells, const ir::Module& module, const ir::Decision& decision,
               const ir::Recovery& recovery);
// The same if its zone had these edges and cells.
Ways ways_over(const std::vector<geometry::EdgeRow>& edges, const ir::Cells& cells,
               const ir::Module& module, const ir::Decision& decision,
               const ir::Recovery& recovery);

// The parts of those `lost` cells that have been looked at: no way leads from there.
std::vector<Stranded> shut_off(const ir::Cells& cells, const ir::Recovery& recovery,
                               const Ways& ways);
// The robot to whose site, of several, no way leads from there; nullopt: of all robots one does.
std::optional<std::size_t> robot_without_way(const ir::Module& module, const ir::Recovery& route,
                                             const Stranded& from);

// The longest leg of a retreat of the plane that takes one straight leg from everywhere, and no way
// over cells. none: it may take a way.
std::optional<std::int64_t> straight_mm(const ir::Module& module, const ir::Decision& decision,
                                        const ir::Recovery& last);

// The legs of a recovery of the plane, if they are counted.
struct Legs {
  int count = 1;  // of its way, that to its first cell included
  int looks = 1;  // for a way: who is seen with less than its body takes is led in first,
  std::int64_t led_in_mm = 0;  // by one more leg, which adds no more than this
};
// Of its way over cells, `way_mm` long, if that is one piece; none: as many as it has cells.
std::optional<Legs> way_legs(const ir::Module& module, const ir::Decision& decision,
                             const ir::Recovery& last, std::int64_t way_mm);

// Upper bounds of the time from taking over until control is given back, as long as no other robot
// is near and nothing else keeps it (braking, looking, driving, dwelling), and of how far it drives
// meanwhile, in m: to where its way begins, along that, past where control is given back, and
// before that and after it as it waits. none: there is no bound.
struct Ending {
  Rational seconds, metres;
  std::optional<Legs> legs = {};  // that it is reckoned with; none: as many as cells
};
std::optional<Ending> ending_of(const sema::RobotKind& kind, const ir::Module& module,
                                const ir::Decision& decision, const ir::Recovery& recovery);
std::optional<Rational> return_seconds(const sema::RobotKind& kind, const ir::Module& module,
                                       const ir::Decision& decision, const ir::Recovery& recovery);

// How long a run waits for control to return before it takes it that it does not, in s: twice as
// long as the longest shortest way in such a zone, along half of all of its edges and across. It
// proves nothing. 0: it does not move in the plane.
std::int64_t patience_s(const sema::RobotKind& kind, const ir::Module& module,
                        const ir::Decision& decision, const ir::Recovery& recovery);

}  // namespace rtac::analysis
