#include "compiler/analysis/liveness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

#include "compiler/analysis/asked_ways.h"
#include "compiler/analysis/in_sight.h"
#include "compiler/analysis/keeps_off.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/analysis/tables.h"
#include "compiler/analysis/travel.h"
#include "compiler/geometry/joining.h"
#include "compiler/geometry/kept.h"
#include "compiler/geometry/way_legs.h"

namespace rtac::analysis {
namespace {

constexpr std::int64_t unreached = std::numeric_limits<std::int64_t>::max();

// The cells by their neighbours. A diagonal step touches both cells beside it.
class Grid {
 public:
  Grid(const ir::Cells& cells, std::int64_t route_mm)
      : cells_(cells), route_mm_(route_mm), count_(cells.clearance_mm_lo.size()) {}

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::int64_t clearance(std::size_t at) const { return cells_.clearance_mm_lo[at]; }
  // What a way that starts here asks of every cell.
  [[nodiscard]] std::int64_t floor_of(std::size_t at) const {
    return std::min(route_mm_, clearance(at));
  }
  template <class Visit>
  void beside(std::size_t at, const Visit& visit) const {
    const auto columns = static_cast<std::size_t>(cells_.columns);
    const std::size_t column = at % columns, row = at / columns;
    if (column > 0) visit(at - 1);
    if (column + 1 < columns) visit(at + 1);
    if (row > 0) visit(at - columns);
    if (row + 1 < static_cast<std::size_t>(cells_.rows)) visit(at + columns);
  }
  // Steps from `from` into cells that are at least as clear as `from` asks for, with their lengths.
  template <class Visit>
  void steps_into(std::size_t to, const Visit& visit) const {
    beside(to, [&](std::size_t from) {
      if (clearance(from) >= 0 && clearance(to) >= floor_of(from)) visit(from, cells_.cell_mm);
    });
  }

 private:
  const ir::Cells& cells_;
  std::int64_t route_mm_;
  std::size_t count_;
};

// For every cell, the length of a way to a goal on which no cell is less clear than what the cell
// before it asks for: one that the search would find, too. unreached: there is no such way.
std::vector<std::int64_t> climbing_ways(const Grid& grid, const std::vector<bool>& goals) {
  using Entry = std::pair<std::int64_t, std::size_t>;
  std::vector<std::int64_t> length(grid.count(), unreached);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (std::size_t i = 0; i < grid.count(); ++i) {
    if (!goals[i]) continue;
    length[i] = 0;
    open.emplace(0, i);
  }
  while (!open.empty()) {
    const std::int64_t so_far = open.top().first;
    const std::size_t to = open.top().second;
    open.pop();
    if (so_far > length[to]) continue;
    grid.steps_into(to, [&](std::size_t from, std::int64_t step_mm) {
      if (so_far + step_mm >= length[from]) return;
      length[from] = so_far + step_mm;
      open.emplace(length[from], from);
    });
  }
  return length;
}

// Sets of cells that are joined one by one.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count), marked_(count, false) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t at) {
    while (parent_[at] != at) at = parent_[at] = parent_[parent_[at]];
    return at;
  }
  void join(std::size_t a, std::size_t b) {
    a = find(a), b = find(b);
    if (a == b) return;
    parent_[a] = b;
    marked_[b] = marked_[b] || marked_[a];
  }
  void mark(std::size_t at) { marked_[find(at)] = true; }
  bool marked(std::size_t at) { return marked_[find(at)]; }

 private:
  std::vector<std::size_t> parent_;
  std::vector<bool> marked_;
};

// Whether the search finds a way at all, from every cell: the cells are opened from the clearest
// on, those that are clear enough for every way at once.
std::vector<bool> has_way(const Grid& grid, const std::vector<bool>& goals) {
  std::vector<std::size_t> order(grid.count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return grid.floor_of(a) > grid.floor_of(b);
  });
  Sets sets(grid.count());
  std::vector<bool> opened(grid.count(), false), found(grid.count(), false);
  for (std::size_t i = 0; i < order.size();) {
    const std::int64_t floor = grid.floor_of(order[i]);
    if (floor < 0) break;
    std::size_t end = i;
    for (; end < order.size() && grid.floor_of(order[end]) == floor; ++end) {
      const std::size_t at = order[end];
      opened[at] = true;
      if (goals[at]) sets.mark(at);
      grid.beside(at, [&](std::size_t other) {
        if (opened[other]) sets.join(at, other);
      });
    }
    for (; i < end; ++i) found[order[i]] = sets.marked(order[i]);
  }
  return found;
}

Stranded at_cell(const Grid& grid, const ir::Cells& cells, std::size_t at) {
  const auto columns = static_cast<std::size_t>(cells.columns);
  const std::int64_t half = cells.cell_mm / 2;
  const std::int64_t x_mm = cells.origin_x_mm + std::int64_t(at % columns) * cells.cell_mm + half;
  const std::int64_t y_mm = cells.origin_y_mm + std::int64_t(at / columns) * cells.cell_mm + half;
  return {x_mm, y_mm, x_mm, y_mm, grid.clearance(at), 1};
}

// Of several cells that of them which is nearest to their middle: of a passage half-way through it.
std::size_t in_the_middle(const std::vector<std::size_t>& all, std::size_t columns) {
  const auto column = [&](std::size_t at) { return static_cast<double>(at % columns); };
  const auto row = [&](std::size_t at) {
    const std::size_t whole = at / columns;
    return static_cast<double>(whole);
  };
  double x = 0, y = 0;
  for (const std::size_t at : all) {
    x += column(at) / static_cast<double>(all.size());
    y += row(at) / static_cast<double>(all.size());
  }
  return *std::ranges::min_element(
      all, {}, [&](std::size_t at) { return std::hypot(column(at) - x, row(at) - y); });
}

// The connected parts of the cells for which `inside` holds.
std::vector<Stranded> parts_of(const Grid& grid, const ir::Cells& cells,
                               const std::vector<bool>& inside) {
  std::vector<Stranded> all;
  std::vector<bool> seen(grid.count(), false);
  for (std::size_t first = 0; first < grid.count(); ++first) {
    if (!inside[first] || seen[first]) continue;
    std::int64_t count = 0;
    std::vector<std::size_t> widest, open = {first};
    seen[first] = true;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      ++count;
      if (!widest.empty() && grid.clearance(at) > grid.clearance(widest.front())) widest.clear();
      if (widest.empty() || grid.clearance(at) == grid.clearance(widest.front())) {
        widest.push_back(at);
      }
      grid.beside(at, [&](std::size_t other) {
        if (!inside[other] || seen[other]) return;
        seen[other] = true;
        open.push_back(other);
      });
    }
    const auto columns = static_cast<std::size_t>(cells.columns);
    const Stranded middle = at_cell(grid, cells, in_the_middle(widest, columns));
    all.push_back(at_cell(grid, cells, widest.front()));
    all.back().middle_x_mm = middle.x_mm;
    all.back().middle_y_mm = middle.y_mm;
    all.back().cells = count;
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Stranded& a, const Stranded& b) { return a.cells > b.cells; });
  return all;
}

std::vector<bool> clear_cells(const ir::Cells& cells, std::int64_t least_mm) {
  std::vector<bool> goals;
  for (const std::int32_t clearance : cells.clearance_mm_lo) goals.push_back(clearance >= least_mm);
  return goals;
}
// By place of the site, of those that are told apart: each robot has its own.
std::vector<std::vector<bool>> site_cells(const ir::Module& module, const ir::Recovery& route,
                                          const ir::Cells& cells) {
  std::vector<std::vector<bool>> all;
  const ir::SiteTable& site = module[route.site];
  for (std::size_t robot = 0; robot < site.places.size(); ++robot) {
    if (site.table_of(robot) != robot) continue;
    std::vector<bool>& goals = all.emplace_back(cells.clearance_mm_lo.size(), false);
    const ir::SiteTable::Place& place = site.places[robot];
    const std::int64_t column = (place.x_mm - cells.origin_x_mm) / cells.cell_mm;
    const std::int64_t row = (place.y_mm - cells.origin_y_mm) / cells.cell_mm;
    if (column < 0 || row < 0 || column >= cells.columns || row >= cells.rows) continue;
    goals[static_cast<std::size_t>(row * cells.columns + column)] = true;
  }
  return all;
}

// What the search finds over cells, without the legs that lead to them.
struct OverCells {
  Ways ways;  // of the longest one without cells that are endless
  // From where no way leads, and those of which nothing bounds it.
  Marks lost, endless;
};

// From where no way begins, though one leads on from every cell that is clear enough, it is
// stranded, too; but for places from which a leg leads straight to the end of a way.
class WithLegs {
 public:
  WithLegs(const std::vector<geometry::EdgeRow>& edges, const ir::Cells& cells,
           const ir::Decision& decision, const ir::Recovery& recovery, const OverCells& over)
      : edges_(edges),
        cells_(cells),
        decision_(decision),
        recovery_(recovery),
        over_(over),
        in_sight_(edges, cells, decision, recovery) {}

  Ways run() {
    Ways bounded = found(true);
    // a way that begins where nothing bounds it is one
    if (bounded.longest_mm && bounded.stranded.empty()) return bounded;
    return found(false);
  }

 private:
  Ways found(bool bounded) {
    ways_ = over_.ways;
    std::vector<std::int64_t> rest_mm = ways_.rest_mm;
    ways_.from_mm.assign(rest_mm.size(), 0);
    for (std::size_t goal = 0; goal < over_.endless.size(); ++goal) {
      for (std::size_t at = 0; at < over_.endless[goal].size(); ++at) {
        if (!over_.endless[goal][at]) continue;
        count_from(at, bounded ? in_sight_.longest_mm(at, goal) : std::nullopt);
        if (bounded) rest_mm[at] = geometry::no_way_mm;
      }
    }
    for (std::size_t at = 0; at < ways_.lost.size(); ++at) {
      if (!ways_.lost[at] || !leads_straight(at)) continue;
      ways_.lost[at] = false;
      rest_mm[at] = geometry::no_way_mm;
    }
    join(std::move(rest_mm));
    if (ways_.longest_mm) {
      ways_.deeper_mm = in_sight_.longest_deeper_mm(over_.lost, over_.endless);
      count(ways_.deeper_mm);
    }
    ways_.stranded = parts_of(Grid(cells_, recovery_.route_clearance_mm), cells_, ways_.lost);
    return std::move(ways_);
  }
  // A leg is counted with that to the cells of a way, which is left out.
  void count(std::optional<std::int64_t> leg_mm) {
    if (!leg_mm || !ways_.longest_mm) {
      ways_.longest_mm = std::nullopt;
      return;
    }
    ways_.longest_mm = std::max(*ways_.longest_mm, *leg_mm - joins_within_mm(cells_));
  }
  void count_from(std::size_t at, std::optional<std::int64_t> leg_mm) {
    count(leg_mm);
    if (leg_mm) ways_.from_mm[at] = std::max(ways_.from_mm[at], *leg_mm);
  }
  bool leads_straight(std::size_t at) {
    const auto leg_mm = in_sight_.longest_mm(at);
    if (leg_mm) count_from(at, leg_mm);
    return leg_mm.has_value();
  }
  void join(std::vector<std::int64_t> rest_mm) {
    const auto mm = [](std::int64_t length) { return static_cast<std::int32_t>(length); };
    geometry::Joins found =
        geometry::joins(edges_, grid_of(cells_),
                        {.route_mm = mm(recovery_.route_clearance_mm),
                         .body_mm = mm(decision_.body.radius_mm),
                         .as_clear_as_here = recovery_.kind != ir::RecoveryKind::route,
                         .return_mm = mm(recovery_.return_clearance_mm),
                         .reach_mm = mm(joins_within_mm(cells_) - cells_.cell_mm / 5),
                         .rest_mm = std::move(rest_mm)});
    count(found.longest_mm);
    ways_.unseen = std::move(found.unseen);
    for (std::size_t at = 0; at < found.apart.size(); ++at) {
      // of all cells in reach the one with the shortest way is taken
      const std::int64_t joined_mm =
          found.way_mm[at] > 0 ? found.way_mm[at] : ways_.rest_mm[at] + joins_within_mm(cells_);
      ways_.from_mm[at] = std::max(ways_.from_mm[at], joined_mm);
      // where no way leads on over cells it does not matter what would join them
      if (ways_.lost[at]) {
        ways_.unseen[at] = in_sight_.gave_up(at);
      } else if (found.apart[at] && !leads_straight(at)) {
        ways_.lost[at] = true;
        ways_.unseen[at] = ways_.unseen[at] || in_sight_.gave_up(at);
      }
    }
  }

  const std::vector<geometry::EdgeRow>& edges_;
  const ir::Cells& cells_;
  const ir::Decision& decision_;
  const ir::Recovery& recovery_;
  const OverCells& over_;
  InSight in_sight_;
  Ways ways_;
};

}  // namespace

std::int64_t joins_within_mm(const ir::Cells& cells) {
  const std::int64_t cell_mm = cells.cell_mm;
  return std::max<std::int64_t>(400, 2 * cell_mm) + cell_mm;
}

namespace {

OverCells over_cells(const ir::Cells& cells, const std::vector<bool>& goals, std::int64_t body_mm,
                     std::int64_t route_mm) {
  const Grid grid(cells, route_mm);
  const std::vector<std::int64_t> length = climbing_ways(grid, goals);
  const std::vector<bool> found = has_way(grid, goals);
  Ways ways;
  ways.rest_mm.resize(grid.count(), 0);
  ways.lost.resize(grid.count(), false);
  std::vector<bool> endless(grid.count(), false);
  std::int64_t longest_mm = 0;
  for (std::size_t at = 0; at < grid.count(); ++at) {
    if (grid.clearance(at) < body_mm) continue;
    ways.lost[at] = !found[at];
    if (!found[at]) continue;
    endless[at] = length[at] == unreached;
    if (endless[at]) continue;
    ways.rest_mm[at] = length[at];
    longest_mm = std::max(longest_mm, length[at]);
  }
  ways.longest_mm = longest_mm;
  ways.stranded = parts_of(grid, cells, ways.lost);
  const std::vector<bool> lost = ways.lost;
  return {std::move(ways), {lost}, {std::move(endless)}};
}
Ways without_legs(OverCells over) {
  const bool bounded = std::ranges::none_of(over.endless, [](const std::vector<bool>& of_goal) {
    return std::ranges::count(of_goal, true) > 0;
  });
  if (!bounded) over.ways.longest_mm = std::nullopt;
  return std::move(over.ways);
}

}  // namespace

Ways ways_to(const ir::Cells& cells, const std::vector<bool>& goals, std::int64_t body_mm,
             std::int64_t route_mm) {
  return without_legs(over_cells(cells, goals, body_mm, route_mm));
}

// In steps over cells a corner of a room is twice as far from its inner corner as a wall is.
std::vector<Stranded> narrow_parts(const ir::Cells& cells, std::int64_t body_mm,
                                   std::int64_t return_mm) {
  const Grid grid(cells, body_mm);
  std::vector<std::int64_t> away_mm(grid.count(), unreached);
  std::vector<std::size_t> open;
  for (std::size_t at = 0; at < grid.count(); ++at) {
    if (grid.clearance(at) < return_mm) continue;
    away_mm[at] = 0;
    open.push_back(at);
  }
  for (std::size_t i = 0; i < open.size(); ++i) {  // by distance: every step is as long
    grid.beside(open[i], [&](std::size_t other) {
      if (away_mm[other] != unreached || grid.clearance(other) < 0) return;
      away_mm[other] = away_mm[open[i]] + cells.cell_mm;
      open.push_back(other);
    });
  }
  std::vector<bool> narrow(grid.count(), false);
  for (std::size_t at = 0; at < grid.count(); ++at) {
    narrow[at] = grid.clearance(at) >= body_mm && away_mm[at] > 2 * return_mm + 2 * cells.cell_mm;
  }
  return parts_of(grid, cells, narrow);
}

// Cells are opened from the clearest on; where two rooms meet, the passage between them is as wide
// as the cell that joins them.
std::vector<Stranded> passages(const ir::Cells& cells, std::int64_t body_mm, std::int64_t need_mm) {
  const Grid grid(cells, need_mm);
  std::vector<std::size_t> order(grid.count());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return grid.clearance(a) > grid.clearance(b);
  });
  Sets rooms(grid.count());
  std::vector<bool> opened(grid.count(), false);
  std::vector<Stranded> all;
  for (const std::size_t at : order) {
    if (grid.clearance(at) < body_mm) break;
    opened[at] = true;
    if (grid.clearance(at) >= need_mm) rooms.mark(at);
    grid.beside(at, [&](std::size_t other) {
      if (!opened[other] || rooms.find(at) == rooms.find(other)) return;
      const bool joins = rooms.marked(at) && rooms.marked(other) && grid.clearance(at) < need_mm;
      if (joins) all.push_back(at_cell(grid, cells, at));
      rooms.join(at, other);
    });
  }
  std::reverse(all.begin(), all.end());
  return all;
}

std::vector<Stranded> shut_off(const ir::Cells& cells, const ir::Recovery& recovery,
                               const Ways& ways) {
  std::vector<bool> shut = ways.lost;
  for (std::size_t at = 0; at < ways.unseen.size(); ++at) shut[at] = shut[at] && !ways.unseen[at];
  return parts_of(Grid(cells, recovery.route_clearance_mm), cells, shut);
}

std::optional<std::size_t> robot_without_way(const ir::Module& module, const ir::Recovery& route,
                                             const Stranded& from) {
  const ir::Cells& cells = module[route.zone].cells;
  const std::int64_t column = (from.x_mm - cells.origin_x_mm) / cells.cell_mm;
  const std::int64_t row = (from.y_mm - cells.origin_y_mm) / cells.cell_mm;
  const auto at = static_cast<std::size_t>(row * cells.columns + column);
  const Grid grid(cells, route.route_clearance_mm);
  const std::vector<std::vector<bool>> sites = site_cells(module, route, cells);
  std::size_t next = 0;
  for (std::size_t robot = 0; robot < module[route.site].places.size(); ++robot) {
    if (module[route.site].table_of(robot) != robot) continue;
    if (!has_way(grid, sites[next++])[at]) return robot;
  }
  return std::nullopt;
}

Ways ways_of(const ir::Module& module, const ir::Decision& decision, const ir::Recovery& recovery) {
  const ir::ZoneTable& zone = module[recovery.zone];
  return ways_over(edges_of(zone), zone.cells, module, decision, recovery);
}
namespace {

// Of the ways to two goals those that are longer, and all from where there is none to one of them.
void take_worse(OverCells& all, const OverCells& other) {
  all.ways.longest_mm = std::max(*all.ways.longest_mm, *other.ways.longest_mm);
  for (std::size_t at = 0; at < all.ways.lost.size(); ++at) {
    all.ways.rest_mm[at] = std::max(all.ways.rest_mm[at], other.ways.rest_mm[at]);
    all.ways.lost[at] = all.ways.lost[at] || other.ways.lost[at];
    all.lost[0][at] = all.lost[0][at] || other.lost[0][at];
    all.endless[0][at] = all.endless[0][at] || other.endless[0][at];
  }
}

OverCells over_cells(const ir::Cells& cells, const ir::Module& module, const ir::Decision& decision,
                     const ir::Recovery& recovery) {
  const std::int64_t body_mm = decision.body.radius_mm + starts_off_mm(decision, recovery);
  const std::int64_t route_mm = recovery.route_clearance_mm;
  if (recovery.kind == ir::RecoveryKind::route) {
    std::optional<OverCells> all;
    for (const std::vector<bool>& site : site_cells(module, recovery, cells)) {
      OverCells to_site = over_cells(cells, site, body_mm, route_mm);
      if (all) take_worse(*all, to_site);
      if (!all) all = std::move(to_site);
    }
    if (!all) return over_cells(cells, clear_cells(cells, unreached), body_mm, route_mm);
    all->ways.stranded = parts_of(Grid(cells, route_mm), cells, all->ways.lost);
    return std::move(*all);
  }
  const std::vector<std::int64_t> goals = goals_mm(decision, recovery);
  OverCells all = over_cells(cells, clear_cells(cells, goals.front()), body_mm, route_mm);
  for (std::size_t i = 1; i < goals.size(); ++i) {
    OverCells deeper = over_cells(cells, clear_cells(cells, goals[i]), body_mm, route_mm);
    for (std::size_t at = 0; at < all.ways.rest_mm.size(); ++at) {
      all.ways.rest_mm[at] = std::max(all.ways.rest_mm[at], deeper.ways.rest_mm[at]);
    }
    // the first leg in sight that is no longer than this is taken, whatever the search would find
    all.ways.longest_mm = std::max({*all.ways.longest_mm, *deeper.ways.longest_mm, 2 * goals[i]});
    all.lost.push_back(std::move(deeper.lost.front()));
    all.endless.push_back(std::move(deeper.endless.front()));
  }
  return all;
}

}  // namespace

Ways ways_over(const std::vector<geometry::EdgeRow>& edges, const ir::Cells& cells,
               const ir::Module& module, const ir::Decision& decision,
               const ir::Recovery& recovery) {
  thread_local geometry::Kept<AskedWays, Ways> kept;
  AskedWays asked(edges, cells, decision, recovery);
  if (recovery.kind == ir::RecoveryKind::route) asked.add_sites(module[recovery.site]);
  return kept.find(std::move(asked), [&] {
    const OverCells over = over_cells(cells, module, decision, recovery);
    return WithLegs(edges, cells, decision, recovery, over).run();
  });
}
Ways ways_over(const ir::Cells& cells, const ir::Module& module, const ir::Decision& decision,
               const ir::Recovery& recovery) {
  return without_legs(over_cells(cells, module, decision, recovery));
}

std::optional<std::int64_t> straight_mm(const ir::Module& module, const ir::Decision& decision,
                                        const ir::Recovery& last) {
  if (!ir::goes_back(last.kind) || decision.body.in_space) return std::nullopt;
  const ir::ZoneTable& zone = module[last.zone];
  const std::vector<geometry::EdgeRow> edges = edges_of(zone);
  thread_local geometry::Kept<AskedWays, std::optional<std::int64_t>> kept;
  return kept.find(AskedWays(edges, zone.cells, decision, last),
                   [&] { return InSight(edges, zone.cells, decision, last).always_mm(); });
}

namespace {

// To the worst of its robots' sites.
std::optional<int> legs_to_sites(const ir::SiteTable& site, const geometry::CellGrid& cells,
                                 std::int32_t route_mm) {
  int most = 0;
  for (std::size_t robot = 0; robot < site.places.size(); ++robot) {
    if (site.table_of(robot) != robot) continue;
    const ir::SiteTable::Place& place = site.places[robot];
    const auto legs = geometry::most_legs_to(cells, route_mm, {place.x_mm, place.y_mm});
    if (!legs) return std::nullopt;
    most = std::max(most, *legs);
  }
  return most;
}
std::optional<Legs> in_one_piece(const std::optional<int>& over_cells, const LedIn& in) {
  const int looks = in.first_mm > 0 ? 2 : 1;
  if (!over_cells || *over_cells + looks > pace::waypoints) return std::nullopt;
  return Legs{*over_cells + 1, looks, std::max(in.first_mm, in.all_mm)};
}

}  // namespace

std::optional<Legs> way_legs(const ir::Module& module, const ir::Decision& decision,
                             const ir::Recovery& last, std::int64_t way_mm) {
  if (!ir::moves(last.kind) || decision.body.in_space) return std::nullopt;
  const ir::ZoneTable& zone = module[last.zone];
  const auto mm = [](std::int64_t length) { return static_cast<std::int32_t>(length); };
  const std::int32_t route_mm = mm(last.route_clearance_mm);
  if (last.kind == ir::RecoveryKind::route) {
    return in_one_piece(legs_to_sites(module[last.site], grid_of(zone), route_mm), {});
  }
  if (!ir::goes_back(last.kind)) return std::nullopt;
  auto in = led_in(edges_of(zone), zone.cells, decision, last);
  if (!in) return std::nullopt;
  geometry::WayLegsQuery query{mm(decision.body.radius_mm), route_mm, {}};
  for (const std::int64_t goal_mm : goals_mm(decision, last)) query.goals_mm.push_back(mm(goal_mm));
  in->all_mm -= way_mm;
  return in_one_piece(geometry::most_legs(grid_of(zone), query), *in);
}

namespace {

// What moves in space goes up or down and on a level straight to where there is room, as far as
// such legs lead there (verify: legs_back); to circle there it goes on to where that has room, too.
std::optional<Ending> by_legs(const sema::RobotKind& kind, const ir::Module& module,
                              const ir::Decision& decision, const ir::Recovery& last) {
  const int looks = last.kind == ir::RecoveryKind::loiter ? 2 : 1;
  const Rational speed(static_cast<long>(last.speed_mmps), 1000);
  // no longer than its box is high, and than that is wide and deep together
  const auto [dx, dy, up] = extent_of(module, module[last.zone]);
  const std::int64_t way_mm = looks * (dx + dy + up);
  const auto seconds = legs_seconds(kind, speed, decision.period_us, 2 * looks, way_mm);
  return seconds ? std::optional(Ending{*seconds, metres_of(way_mm)}) : std::nullopt;
}

// By one leg, by the legs that are counted, or by as many as a way of `joined_mm` has cells.
Ending in_the_plane(const sema::RobotKind& kind, const ir::Module& module,
                    const ir::Decision& decision, const ir::Recovery& last,
                    std::int64_t joined_mm) {
  const Rational speed(static_cast<long>(last.speed_mmps), 1000);
  const auto of_legs = [&](const Legs& legs, std::int64_t way_mm) {
    return few_legs_seconds(kind, speed, decision.period_us, legs.count + legs.looks - 1,
                            legs.looks + 1, way_mm + legs.led_in_mm);
  };
  if (const auto leg_mm = straight_mm(module, decision, last)) {
    return {of_legs({}, *leg_mm), metres_of(*leg_mm)};
  }
  const auto cell_mm = static_cast<std::int32_t>(module[last.zone].cells.cell_mm);
  const Ending by_cells{travel_seconds(kind, speed, decision.period_us, cell_mm, joined_mm),
                        metres_of(joined_mm)};
  const auto legs = way_legs(module, decision, last, joined_mm);
  if (!legs) return by_cells;
  const Ending by_legs{of_legs(*legs, joined_mm), metres_of(joined_mm + legs->led_in_mm), legs};
  return by_legs.seconds < by_cells.seconds ? by_legs : by_cells;
}

// Over cells; it begins where it stands, beside the centre of one.
std::optional<Ending> by_cells(const sema::RobotKind& kind, const ir::Module& module,
                               const ir::Decision& decision, const ir::Recovery& last) {
  const Ways ways = ways_of(module, decision, last);
  if (!ways.longest_mm || !ways.stranded.empty()) return std::nullopt;
  const auto cell_mm = static_cast<std::int32_t>(module[last.zone].cells.cell_mm);
  const Rational speed(static_cast<long>(last.speed_mmps), 1000);
  const std::int64_t joined_mm = *ways.longest_mm + joins_within_mm(module[last.zone].cells);
  if (decision.body.in_space) {
    const auto seconds = carried_seconds(kind, speed, decision.period_us, cell_mm, joined_mm);
    return seconds ? std::optional(Ending{*seconds, metres_of(joined_mm)}) : std::nullopt;
  }
  Ending end = in_the_plane(kind, module, decision, last, joined_mm);
  if (last.kind == ir::RecoveryKind::route) return end;
  // the last leg goes straight on
  const Rational slowest = speed - lasting_speed(kind, decision.period_us);
  const Rational past = metres_of(run_out_mm(kind, speed, decision.period_us));
  end.seconds += past / slowest;
  end.metres += past;
  return end;
}

// For so long it drives at its speed, which errors and pushes make no greater than that.
Rational driven_for(const Rational& seconds, const sema::RobotKind& kind,
                    const ir::Decision& decision, const ir::Recovery& step) {
  if (!ir::moves(step.kind)) return 0;
  const Rational speed(static_cast<long>(step.speed_mmps), 1000);
  return seconds * (speed + lasting_speed(kind, decision.period_us));
}

// Who brakes alone lets go at rest, if all that it brakes for is fulfilled there.
std::optional<Ending> by_braking(const sema::RobotKind& kind, const ir::Decision& decision,
                                 const ir::Recovery& recovery) {
  if (ir::steps_of(recovery).size() != 1) return std::nullopt;
  const bool lets_go = std::ranges::all_of(decision.monitors, [&](const ir::Monitor& m) {
    return m.recovery.name != recovery.name || holds_in_hold(decision, m);
  });
  if (!lets_go) return std::nullopt;
  const Stop stop = stop_of(kind, decision.period_us);
  return Ending{stop.seconds, stop.metres};
}

}  // namespace

std::optional<Ending> ending_of(const sema::RobotKind& kind, const ir::Module& module,
                                const ir::Decision& decision, const ir::Recovery& recovery) {
  const ir::Recovery& last = ir::last_step(recovery);
  const bool brakes = last.kind == ir::RecoveryKind::brake;
  if (!brakes && !ir::moves(last.kind)) return std::nullopt;
  if (last.kind == ir::RecoveryKind::yield) return std::nullopt;
  const bool legs = decision.body.in_space && last.kind != ir::RecoveryKind::route;
  std::optional<Ending> end = brakes ? by_braking(kind, decision, recovery)
                              : legs ? by_legs(kind, module, decision, last)
                                     : by_cells(kind, module, decision, last);
  if (!end) return std::nullopt;
  for (const ir::Recovery& step : recovery.steps) {
    if (step.lasts_us == 0) continue;  // the last one
    const Rational lasts(static_cast<long>(step.lasts_us), 1'000'000);
    const Rational speed(static_cast<long>(step.speed_mmps), 1000);
    end->seconds += lasts;
    end->metres += driven_for(lasts, kind, decision, step);
    if (ir::moves(step.kind)) {
      end->metres += metres_of(run_out_mm(kind, speed, decision.period_us));
    }
  }
  std::int64_t asked_us = 0;
  for (const ir::Monitor& m : decision.monitors) {
    if (m.recovery.name != recovery.name) continue;
    if (m.returns.how != ir::Returns::How::itself) return std::nullopt;
    asked_us = std::max(asked_us, m.returns.after_us);
  }
  const std::int64_t dwell_us = (decision.dwell_ticks + 2) * decision.period_us;
  const Rational after(static_cast<long>(dwell_us + asked_us), 1'000'000);
  end->seconds += after;
  // what does not stand there goes on
  if (last.kind == ir::RecoveryKind::loiter) {
    end->metres += driven_for(after, kind, decision, last);
  }
  return end;
}

std::optional<Rational> return_seconds(const sema::RobotKind& kind, const ir::Module& module,
                                       const ir::Decision& decision, const ir::Recovery& recovery) {
  const auto end = ending_of(kind, module, decision, recovery);
  return end ? std::optional(end->seconds) : std::nullopt;
}

std::int64_t patience_s(const sema::RobotKind& kind, const ir::Module& module,
                        const ir::Decision& decision, const ir::Recovery& recovery) {
  const ir::Recovery& last = ir::last_step(recovery);
  const bool moves = ir::moves(last.kind) && last.kind != ir::RecoveryKind::yield;
  if (!moves || decision.body.in_space) return 0;
  const ir::ZoneTable& zone = module[last.zone];
  const auto [dx, dy, up] = extent_of(module, zone);
  std::int64_t edges_mm = 0;
  for (const ir::Edge& e : zone.edges) edges_mm += std::abs(e.bx - e.ax) + std::abs(e.by - e.ay);
  const Rational speed(static_cast<long>(last.speed_mmps), 1000);
  const Rational slowest = speed - lasting_speed(kind, decision.period_us);
  return ceil_to_int(Rational(2 * Rational(edges_mm / 2 + dx + dy, 1000) / slowest));
}

}  // namespace rtac::analysis
