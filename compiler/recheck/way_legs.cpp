#include "compiler/recheck/way_legs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <queue>
#include <utility>

#include "compiler/recheck/on_grid.h"
#include "compiler/recheck/straight.h"

namespace rtac::recheck {
namespace {

using Int = std::int64_t;
constexpr double endless = 1e300;
// Of all steps that are looked at; of a rectangle's cells, together.
constexpr Int work_max = 8'000'000, area_max = 5'000'000;

// West, south, and the first cell beyond it to the east and north.
struct Area {
  Int west, south, east, north;
  auto operator<=>(const Area&) const = default;
  [[nodiscard]] bool holds(Int x, Int y) const {
    return west <= x && x < east && south <= y && y < north;
  }
  [[nodiscard]] std::size_t at(Int x, Int y) const {
    return static_cast<std::size_t>((y - south) * (east - west) + x - west);
  }
  [[nodiscard]] Int size() const { return (east - west) * (north - south); }
};

// Cells with at least as much clearance as a limit, which any two of a rectangle of them see each
// other over: a leg leads on at least to the last cell of a way in its rectangle, from wherever in
// it the leg begins.
class Floor {
 public:
  Floor(const std::vector<Int>& clearance_mm, Int columns, Int rows, Int limit_mm)
      : columns_(columns), rows_(rows), free_(clearance_mm.size()) {
    blocked_.assign(static_cast<std::size_t>((columns + 1) * (rows + 1)), 0);
    for (Int y = 0; y < rows; ++y) {
      for (Int x = 0; x < columns; ++x) {
        const std::size_t cell = static_cast<std::size_t>(y * columns + x);
        free_[cell] = clearance_mm[cell] >= limit_mm;
        sum(x + 1, y + 1) = sum(x, y + 1) + sum(x + 1, y) - sum(x, y) + (free_[cell] ? 0 : 1);
      }
    }
  }
  // On the floor, all of it.
  [[nodiscard]] bool free(const Area& a) const {
    if (a.west < 0 || a.south < 0 || a.east > columns_ || a.north > rows_) return false;
    return sum(a.east, a.north) + sum(a.west, a.south) ==
           sum(a.west, a.north) + sum(a.east, a.south);
  }
  // A step from one cell to another that is beside it: it touches all cells of what holds both.
  [[nodiscard]] bool leads(Int x, Int y, Int dx, Int dy) const {
    return free({std::min(x, x + dx), std::min(y, y + dy), std::max(x, x + dx) + 1,
                 std::max(y, y + dy) + 1});
  }
  // Every step lies in one of these.
  [[nodiscard]] std::vector<Area> areas() const {
    std::vector<Area> all;
    for (Int y = 0; y < rows_; ++y) {
      for (Int x = 0; x < columns_; ++x) {
        for (const Int side : {1, 2}) {
          const Area seed{x, y, x + side, y + side};
          if (!free(seed)) continue;
          all.push_back(upright(level(seed)));
          all.push_back(level(upright(seed)));
        }
      }
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

 private:
  [[nodiscard]] Int& sum(Int x, Int y) {
    return blocked_[static_cast<std::size_t>(y * (columns_ + 1) + x)];
  }
  [[nodiscard]] Int sum(Int x, Int y) const {
    return blocked_[static_cast<std::size_t>(y * (columns_ + 1) + x)];
  }
  // As wide, and as deep, as it gets: by halves.
  template <class Grown>
  [[nodiscard]] Area grown(const Grown& by) const {
    Int free_up_to = 0, blocked = columns_ + rows_;
    while (blocked - free_up_to > 1) {
      const Int half = (free_up_to + blocked) / 2;
      (free(by(half)) ? free_up_to : blocked) = half;
    }
    return by(free_up_to);
  }
  [[nodiscard]] Area level(const Area& a) const {
    const Area b = grown([&](Int n) { return Area{a.west - n, a.south, a.east, a.north}; });
    return grown([&](Int n) { return Area{b.west, b.south, b.east + n, b.north}; });
  }
  [[nodiscard]] Area upright(const Area& a) const {
    const Area b = grown([&](Int n) { return Area{a.west, a.south - n, a.east, a.north}; });
    return grown([&](Int n) { return Area{b.west, b.south, b.east, b.north + n}; });
  }

  Int columns_, rows_;
  std::vector<bool> free_;
  std::vector<Int> blocked_;  // south-west of each corner
};

class WayLegs {
 public:
  WayLegs(const std::vector<Int>& clearance_mm, Int columns, Int rows, Int limit_mm)
      : clearance_mm_(clearance_mm),
        columns_(columns),
        floor_(clearance_mm, columns, rows, limit_mm),
        limit_mm_(limit_mm),
        longest_leg_(columns + rows),
        areas_(floor_.areas()) {}

  // To what is as clear as that.
  std::optional<std::size_t> most(Int goal_mm) {
    std::vector<std::size_t> goals;
    for (std::size_t at = 0; at < clearance_mm_.size(); ++at) {
      if (clearance_mm_[at] >= std::max(goal_mm, limit_mm_)) goals.push_back(at);
    }
    return most_to(goals);
  }
  std::optional<std::size_t> most_to(const std::vector<std::size_t>& goals) {
    Int size = 0;
    for (const Area& area : areas_) size += area.size();
    if (size > area_max) return std::nullopt;
    const std::vector<std::size_t> cells = by_distance(goals);
    if (cells.empty()) return 0;
    // A float is off by 2^-24 of itself at most; each way is as many of them off as it has steps,
    // and so is the shortest one. What a step is longer than the shortest way has to be less.
    const double longest = distance_[cells.back()];
    constexpr double per_step = 1.0 / (1 << 23);
    if (per_step * (longest + 1) * (longest + double(longest_leg_)) > 0.45) return std::nullopt;
    left_.clear();
    over_.assign(clearance_mm_.size(), {});
    for (std::size_t k = 0; k < areas_.size(); ++k) {
      left_.emplace_back(static_cast<std::size_t>(areas_[k].size()), 0U);
      for (Int y = areas_[k].south; y < areas_[k].north; ++y) {
        for (Int x = areas_[k].west; x < areas_[k].east; ++x) over_[cell(x, y)].push_back(k);
      }
    }
    std::size_t most = 0;
    for (const std::size_t at : cells) most = std::max(most, from(at));
    return most;
  }

 private:
  [[nodiscard]] std::size_t cell(Int x, Int y) const {
    return static_cast<std::size_t>(y * columns_ + x);
  }
  template <class Visit>
  void around(std::size_t at, const Visit& visit) const {
    const Int x = static_cast<Int>(at) % columns_, y = static_cast<Int>(at) / columns_;
    for (const auto& [dx, dy] : std::array<std::array<Int, 2>, 8>{
             {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}}) {
      if (floor_.leads(x, y, dx, dy)) visit(x + dx, y + dy, dx * dy == 0 ? 1 : std::sqrt(2.0));
    }
  }
  // From those that lead there, the nearest first.
  std::vector<std::size_t> by_distance(const std::vector<std::size_t>& goals) {
    distance_.assign(clearance_mm_.size(), endless);
    std::vector<std::size_t> found;
    std::priority_queue<std::pair<double, std::size_t>> open;  // less than 0
    const auto reach = [&](std::size_t at, double distance) {
      if (distance >= distance_[at]) return;
      distance_[at] = distance;
      open.emplace(-distance, at);
    };
    for (const std::size_t at : goals) reach(at, 0);
    while (!open.empty()) {
      const auto top = open.top();
      open.pop();
      if (-top.first > distance_[top.second]) continue;
      found.push_back(top.second);
      around(top.second, [&](Int x, Int y, double step) { reach(cell(x, y), step - top.first); });
    }
    return found;
  }
  // How many rectangles a way takes at most that begins there. Each of them is left where the way
  // leaves it, for the one that holds that step and takes the fewest others.
  std::size_t from(std::size_t at) {
    if (distance_[at] == 0) return 0;
    const Int column = static_cast<Int>(at) % columns_, row = static_cast<Int>(at) / columns_;
    std::size_t most = 0;
    around(at, [&](Int x, Int y, double step) {
      if (distance_[cell(x, y)] + step - distance_[at] > 0.5) return;
      std::size_t next = clearance_mm_.size();
      for (const std::size_t k : over_[cell(x, y)]) {
        if (areas_[k].holds(column, row)) next = std::min(next, left_[k][areas_[k].at(x, y)] + 1);
      }
      most = std::max(most, next);
      for (const std::size_t k : over_[at]) {
        std::size_t& left = left_[k][areas_[k].at(column, row)];
        left = std::max(left, areas_[k].holds(x, y) ? left_[k][areas_[k].at(x, y)] : next);
      }
    });
    return most;
  }

  const std::vector<Int>& clearance_mm_;
  const Int columns_;
  const Floor floor_;
  const Int limit_mm_, longest_leg_;
  const std::vector<Area> areas_;
  std::vector<double> distance_;                // by cell, in sides of one
  std::vector<std::vector<std::size_t>> left_;  // by rectangle and cell of it: of others, then
  std::vector<std::vector<std::size_t>> over_;  // by cell: the rectangles that hold it
};

std::vector<Int> in_mm(const Grid& grid) {
  std::vector<Int> all;
  for (const double clearance : grid.clearance) all.push_back(std::llround(1000 * clearance));
  return all;
}
// Those values of cells that such a limit may stand for.
std::vector<Int> told_apart(const std::vector<Int>& clearance_mm, Int from_mm, Int to_mm) {
  std::vector<Int> all{to_mm};
  for (const Int mm : clearance_mm) {
    if (mm >= from_mm && mm < to_mm) all.push_back(mm);
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}
Int whole_mm(const Rational& m) {
  return std::llround(1000 * m.get_d());
}

}  // namespace

std::optional<std::size_t> legs_of_ways(const geometry::Region& zone, const Cells& cells,
                                        const Rational& body, const Rational& route,
                                        const std::vector<Rational>& goals) {
  const std::optional<OnGrid> found = on_grid(zone, cells);
  // where doubles tell no millimetres apart, a cell may be one off
  if (!found || found->cells.less > 0) return std::nullopt;
  const std::vector<Int> clearance = in_mm(found->cells);
  // as the kernel has them, in metres, and off by as much as two lengths are that are rounded up
  std::map<Int, Int> ends;  // by the least clearance that is enough
  for (const Rational& goal : goals) {
    for (Int mm = whole_mm(goal) - 2; mm <= whole_mm(goal) + 1; ++mm) {
      Int least = -1;
      for (const Int each : clearance) {
        if (each >= mm && (least < 0 || each < least)) least = each;
      }
      if (least >= 0) ends[least] = mm;
    }
  }
  const std::vector<Int> limits = told_apart(clearance, whole_mm(body), whole_mm(route));
  if (Int(limits.size() * ends.size() * clearance.size()) > work_max) return std::nullopt;
  std::size_t most = 0;
  for (const Int limit : limits) {
    WayLegs ways(clearance, Int(found->cells.columns), Int(found->cells.rows), limit);
    for (const auto& [least, goal] : ends) {
      const auto legs = ways.most(goal);
      if (!legs) return std::nullopt;
      most = std::max(most, *legs);
    }
  }
  return most;
}

namespace {

// The cells that a robot may take for that of a site, which it knows to the millimetre.
std::vector<std::size_t> around(const Grid& grid, const geometry::Point& site) {
  const bool known =
      Rational(site.x * 1000).get_den() == 1 && Rational(site.y * 1000).get_den() == 1;
  const double rounded_m = known ? slack_m : 0.001 + slack_m;
  std::vector<std::size_t> all;
  const double x = site.x.get_d(), y = site.y.get_d();
  for (std::size_t at = 0; at < grid.clearance.size(); ++at) {
    const Box box = grid.box(at % grid.columns, at / grid.columns, 1);
    const double off = std::max({box.x - x, x - box.right, box.y - y, y - box.top});
    if (off <= rounded_m) all.push_back(at);
  }
  return all;
}

}  // namespace

std::optional<std::size_t> legs_to_sites(const geometry::Region& zone, const Cells& cells,
                                         const Rational& route,
                                         const std::vector<geometry::Point>& sites) {
  const std::optional<OnGrid> found = on_grid(zone, cells);
  if (!found || found->cells.less > 0) return std::nullopt;
  const std::vector<Int> clearance = in_mm(found->cells);
  WayLegs ways(clearance, Int(found->cells.columns), Int(found->cells.rows), whole_mm(route));
  std::size_t most = 1;  // in the cell of the site to that itself
  for (const geometry::Point& site : sites) {
    const std::vector<std::size_t> goals = around(found->cells, site);
    std::optional<std::size_t> of_site;
    std::size_t last = 0;  // beside a cell that is not clear it is seen from its own cell alone
    for (const std::size_t goal : goals) {
      if (clearance[goal] < whole_mm(route)) {
        last = 1;
        continue;
      }
      const auto legs = ways.most_to({goal});
      if (!legs) return std::nullopt;
      of_site = std::max(of_site.value_or(0), *legs);
    }
    if (!of_site) return std::nullopt;
    most = std::max(most, *of_site + last);
  }
  return most;
}

std::optional<LedIn> leads_in_within(const geometry::Region& zone, const Cells& cells,
                                     const Rational& seen, const Rational& body,
                                     const Rational& route, const std::vector<Rational>& aims) {
  const std::optional<OnGrid> found = on_grid(zone, cells);
  if (!found || found->cells.less > 0) return std::nullopt;
  const Grid& grid = found->cells;
  Straight straight(found->edges, grid, seen.get_d(), found->convex);
  LedIn in{0, 0, std::vector<double>(grid.clearance.size(), 0)};
  for (std::size_t at = 0; at < grid.clearance.size(); ++at) {
    if (grid.clearance[at] >= body.get_d() - slack_m) continue;
    if (grid.clearance[at] < 0 && !straight.holds_some(at)) continue;
    const auto leg = straight.longest_from(at, route.get_d());
    const double first = leg ? *leg : straight.farthest_from(at, route.get_d());
    double all = 0;
    for (auto aim = aims.rbegin(); aim != aims.rend(); ++aim) {  // the deepest first
      const auto seen_to = straight.longest_from(at, aim->get_d());
      all = std::max(all, seen_to ? *seen_to : straight.farthest_from(at, aim->get_d()));
      if (seen_to) break;  // what is in sight is taken
    }
    in.first = std::max(in.first, Rational(first));
    in.all = std::max(in.all, Rational(all));
    in.from[at] = std::max(first, all);
  }
  return in;
}

}  // namespace rtac::recheck
