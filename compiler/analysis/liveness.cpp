#include "compiler/analysis/liveness.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/tables.h"
#include "compiler/analysis/travel.h"
#include "compiler/geometry/joining.h"

namespace rtac::analysis {
namespace {

constexpr std::int64_t unreached = std::numeric_limits<std::int64_t>::max();
// More clearance than it needs that a loitering robot would like to have (LoiterManoeuvre).
constexpr std::int64_t loiter_room_mm = 500;

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
  return {cells.origin_x_mm + std::int64_t(at % columns) * cells.cell_mm + half,
          cells.origin_y_mm + std::int64_t(at / columns) * cells.cell_mm + half, grid.clearance(at),
          1};
}

// The connected parts of the cells for which `inside` holds.
std::vector<Stranded> parts_of(const Grid& grid, const ir::Cells& cells,
                               const std::vector<bool>& inside) {
  std::vector<Stranded> all;
  std::vector<bool> seen(grid.count(), false);
  for (std::size_t first = 0; first < grid.count(); ++first) {
    if (!inside[first] || seen[first]) continue;
    Stranded part;
    part.clearance_mm = -1;
    std::vector<std::size_t> open = {first};
    seen[first] = true;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      ++part.cells;
      if (grid.clearance(at) > part.clearance_mm) {
        const std::int64_t so_far = part.cells;
        part = at_cell(grid, cells, at);
        part.cells = so_far;
      }
      grid.beside(at, [&](std::size_t other) {
        if (!inside[other] || seen[other]) return;
        seen[other] = true;
        open.push_back(other);
      });
    }
    all.push_back(part);
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
std::vector<bool> site_cells(const ir::Module& module, const ir::Recovery& route,
                             const ir::Cells& cells) {
  std::vector<bool> goals(cells.clearance_mm_lo.size(), false);
  for (const ir::SiteTable::Place& place : module[route.site].places) {
    const std::int64_t column = (place.x_mm - cells.origin_x_mm) / cells.cell_mm;
    const std::int64_t row = (place.y_mm - cells.origin_y_mm) / cells.cell_mm;
    if (column < 0 || row < 0 || column >= cells.columns || row >= cells.rows) continue;
    goals[static_cast<std::size_t>(row * cells.columns + column)] = true;
  }
  return goals;
}

// From where no way begins, though one leads on from every cell that is clear enough, it is
// stranded, too.
void add_joins(const std::vector<geometry::EdgeRow>& edges, const ir::Cells& cells,
               const ir::Decision& decision, const ir::Recovery& recovery, Ways& ways) {
  const auto mm = [](std::int64_t length) { return static_cast<std::int32_t>(length); };
  const geometry::Joins found =
      geometry::joins(edges, grid_of(cells),
                      {.route_mm = mm(recovery.route_clearance_mm),
                       .body_mm = mm(decision.body.radius_mm),
                       .as_clear_as_here = recovery.kind != ir::RecoveryKind::route,
                       .return_mm = mm(recovery.return_clearance_mm),
                       .reach_mm = mm(joins_within_mm(cells) - cells.cell_mm / 5),
                       .rest_mm = ways.rest_mm});
  if (ways.longest_mm) {
    ways.longest_mm = std::max(*ways.longest_mm, found.longest_mm - joins_within_mm(cells));
  }
  const Grid grid(cells, recovery.route_clearance_mm);
  for (std::size_t at = 0; at < found.apart.size(); ++at) {
    if (found.apart[at]) ways.lost[at] = true;
  }
  ways.stranded = parts_of(grid, cells, ways.lost);
}

// The larger of two lengths; none: one of them has no bound.
std::optional<std::int64_t> longer(std::optional<std::int64_t> a, std::optional<std::int64_t> b) {
  return a && b ? std::optional<std::int64_t>{std::max(*a, *b)} : std::nullopt;
}

}  // namespace

std::int64_t joins_within_mm(const ir::Cells& cells) {
  const std::int64_t cell_mm = cells.cell_mm;
  return std::max<std::int64_t>(400, 2 * cell_mm) + cell_mm;
}

Ways ways_to(const ir::Cells& cells, const std::vector<bool>& goals, std::int64_t body_mm,
             std::int64_t route_mm) {
  const Grid grid(cells, route_mm);
  const std::vector<std::int64_t> length = climbing_ways(grid, goals);
  const std::vector<bool> found = has_way(grid, goals);
  Ways ways;
  ways.rest_mm.resize(grid.count(), 0);
  std::vector<bool> stranded(grid.count(), false);
  for (std::size_t at = 0; at < grid.count(); ++at) {
    if (grid.clearance(at) < body_mm) continue;
    stranded[at] = !found[at];
    if (!found[at]) continue;
    if (length[at] != unreached) ways.rest_mm[at] = length[at];
    if (length[at] == unreached) {
      ways.longest_mm = std::nullopt;
    } else if (ways.longest_mm) {
      ways.longest_mm = std::max(*ways.longest_mm, length[at]);
    }
  }
  ways.stranded = parts_of(grid, cells, stranded);
  ways.lost = std::move(stranded);
  return ways;
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

Ways ways_of(const ir::Module& module, const ir::Decision& decision, const ir::Recovery& recovery) {
  const ir::ZoneTable& zone = module[recovery.zone];
  return ways_over(edges_of(zone), zone.cells, module, decision, recovery);
}
Ways ways_over(const std::vector<geometry::EdgeRow>& edges, const ir::Cells& cells,
               const ir::Module& module, const ir::Decision& decision,
               const ir::Recovery& recovery) {
  Ways ways = ways_over(cells, module, decision, recovery);
  add_joins(edges, cells, decision, recovery, ways);
  return ways;
}
Ways ways_over(const ir::Cells& cells, const ir::Module& module, const ir::Decision& decision,
               const ir::Recovery& recovery) {
  const std::int64_t body_mm = decision.body.radius_mm + standoff_mm(decision, recovery);
  const std::int64_t route_mm = recovery.route_clearance_mm;
  if (recovery.kind == ir::RecoveryKind::route) {
    return ways_to(cells, site_cells(module, recovery, cells), body_mm, route_mm);
  }
  // A retreat aims a little deeper than it needs, as far as a way leads there.
  const std::int64_t needed_mm = recovery.return_clearance_mm;
  const std::int64_t error_mm = decision.body.position_error_mm;
  std::int64_t wanted_mm = needed_mm + decision.body.end_reach_mm + error_mm;
  Ways ways = ways_to(cells, clear_cells(cells, needed_mm), body_mm, route_mm);
  for (int i = recovery.kind == ir::RecoveryKind::loiter ? 2 : 1; i > 0; --i) {
    const Ways deeper = ways_to(cells, clear_cells(cells, wanted_mm), body_mm, route_mm);
    for (std::size_t at = 0; at < ways.rest_mm.size(); ++at) {
      ways.rest_mm[at] = std::max(ways.rest_mm[at], deeper.rest_mm[at]);
    }
    ways.longest_mm = longer(ways.longest_mm, deeper.longest_mm);
    // the first leg in sight that is no longer than this is taken, whatever the search would find
    ways.longest_mm = longer(ways.longest_mm, 2 * wanted_mm);
    wanted_mm += loiter_room_mm;
  }
  return ways;
}

namespace {

// What moves in space goes up or down and on a level straight to where there is room, as far as
// such legs lead there (verify: legs_back); to circle there it goes on to where that has room, too.
std::optional<Rational> seconds_of_legs(const sema::RobotKind& kind, const ir::Module& module,
                                        const ir::Decision& decision, const ir::Recovery& last) {
  const int looks = last.kind == ir::RecoveryKind::loiter ? 2 : 1;
  const Rational speed(static_cast<long>(last.speed_mmps), 1000);
  // no longer than its box is high, and than that is wide and deep together
  const auto [dx, dy, up] = extent_of(module, module[last.zone]);
  return legs_seconds(kind, speed, decision.period_us, 2 * looks, looks * (dx + dy + up));
}

// Over cells; it begins where it stands, beside the centre of one.
std::optional<Rational> seconds_over_cells(const sema::RobotKind& kind, const ir::Module& module,
                                           const ir::Decision& decision, const ir::Recovery& last) {
  const Ways ways = ways_of(module, decision, last);
  if (!ways.longest_mm || !ways.stranded.empty()) return std::nullopt;
  const std::int64_t cell_mm = module[last.zone].cells.cell_mm;
  const Rational speed(static_cast<long>(last.speed_mmps), 1000);
  const std::int64_t joined_mm = *ways.longest_mm + joins_within_mm(module[last.zone].cells);
  const auto cell = static_cast<std::int32_t>(cell_mm);
  if (decision.body.in_space) {
    return carried_seconds(kind, speed, decision.period_us, cell, joined_mm);
  }
  const Rational driven = travel_seconds(kind, speed, decision.period_us, cell, joined_mm);
  if (last.kind == ir::RecoveryKind::route) return driven;
  // the last leg goes straight on
  const Rational slowest = speed - lasting_speed(kind, decision.period_us);
  return driven + Rational(run_out_mm(kind, speed, decision.period_us), 1000) / slowest;
}

}  // namespace

std::optional<Rational> return_seconds(const sema::RobotKind& kind, const ir::Module& module,
                                       const ir::Decision& decision, const ir::Recovery& recovery) {
  const ir::Recovery& last = ir::last_step(recovery);
  if (!ir::moves(last.kind) || last.kind == ir::RecoveryKind::yield) return std::nullopt;
  const bool legs = decision.body.in_space && last.kind != ir::RecoveryKind::route;
  const std::optional<Rational> driven = legs ? seconds_of_legs(kind, module, decision, last)
                                              : seconds_over_cells(kind, module, decision, last);
  if (!driven) return std::nullopt;
  Rational seconds = *driven;
  for (const ir::Recovery& step : recovery.steps) {
    seconds += Rational(static_cast<long>(step.lasts_us), 1'000'000);
  }
  std::int64_t after_us = 0;
  for (const ir::Monitor& m : decision.monitors) {
    if (m.recovery.name != recovery.name) continue;
    if (m.returns.how != ir::Returns::How::itself) return std::nullopt;
    after_us = std::max(after_us, m.returns.after_us);
  }
  const std::int64_t dwell_us = (decision.dwell_ticks + 2) * decision.period_us;
  return seconds + Rational(static_cast<long>(dwell_us + after_us), 1'000'000);
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
