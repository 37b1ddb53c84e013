#include "compiler/geometry/way_legs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

#include "compiler/geometry/kept.h"

namespace rtac::geometry {
namespace {

constexpr double diagonal = 1.41422;  // from above
// In sides of cells: by so much a way may be longer than the shortest one. The search reckons in
// floats, and each step may be off by 2^-23 of what it has come, or less. All of them have to be
// off by less than is to spare: by less than what the recheck is sure of, too, which is 0.45.
constexpr double spare = 0.5, of_step = 1.2e-7, of_steps_max = 0.44;
// Of cells times limits and goals; of cells of rectangles.
constexpr std::int64_t cells_max = 6'000'000, covered_max = 4'000'000;
// The analysis rounds goals up to millimetres, each of two, and the search takes metres.
constexpr std::array<std::int32_t, 4> roundings_mm = {-2, -1, 0, 1};

// Of cells, both corners included.
struct Box {
  int west, south, east, north;
  [[nodiscard]] bool holds(int column, int row) const {
    return column >= west && column <= east && row >= south && row <= north;
  }
  auto operator<=>(const Box&) const = default;
};

// The cells that a way with one limit may lead over, and rectangles of them.
class Clear {
 public:
  Clear(const CellGrid& cells, std::int32_t limit_mm)
      : columns_(cells.columns), rows_(cells.rows), clear_(cells.clearance_mm_lo.size()) {
    for (std::size_t i = 0; i < clear_.size(); ++i) {
      clear_[i] = cells.clearance_mm_lo[i] >= std::max(limit_mm, 0);
    }
    find_runs();
  }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] bool at(int column, int row) const {
    return column >= 0 && row >= 0 && column < columns_ && row < rows_ &&
           clear_[index(column, row)];
  }
  // Calls `visit` with the cells that lie one step off, and how long that is. A diagonal step
  // touches both cells beside it.
  template <class Visit>
  void steps_from(int column, int row, const Visit& visit) const {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if ((dx == 0 && dy == 0) || !at(column + dx, row + dy)) continue;
        if (dx != 0 && dy != 0 && (!at(column + dx, row) || !at(column, row + dy))) continue;
        visit(column + dx, row + dy, dx != 0 && dy != 0 ? diagonal : 1.0);
      }
    }
  }
  // Such that each step lies in one: what each cell, and each square of four, grows to, along one
  // axis first and then along the other.
  [[nodiscard]] std::vector<Box> rectangles() const {
    std::set<Box> found;
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        if (!at(column, row)) continue;
        const bool square = at(column + 1, row) && at(column, row + 1) && at(column + 1, row + 1);
        for (int side = 0; side <= (square ? 1 : 0); ++side) {
          const Box seed{column, row, column + side, row + side};
          found.insert(grown_up(grown_along(seed)));
          found.insert(grown_along(grown_up(seed)));
        }
      }
    }
    return {found.begin(), found.end()};
  }

 private:
  // Ends of the run of clear cells, along its row and its column, that each one lies in.
  struct Run {
    int west, east, south, north;
  };
  void find_runs() {
    runs_.resize(clear_.size());
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        Run& run = runs_[index(column, row)];
        run.west = at(column - 1, row) ? runs_[index(column - 1, row)].west : column;
        run.south = at(column, row - 1) ? runs_[index(column, row - 1)].south : row;
      }
    }
    for (int row = rows_ - 1; row >= 0; --row) {
      for (int column = columns_ - 1; column >= 0; --column) {
        Run& run = runs_[index(column, row)];
        run.east = at(column + 1, row) ? runs_[index(column + 1, row)].east : column;
        run.north = at(column, row + 1) ? runs_[index(column, row + 1)].north : row;
      }
    }
  }
  [[nodiscard]] Box grown_along(Box box) const {
    int west = 0, east = columns_;
    for (int row = box.south; row <= box.north; ++row) {
      west = std::max(west, runs_[index(box.west, row)].west);
      east = std::min(east, runs_[index(box.west, row)].east);
    }
    return {west, box.south, east, box.north};
  }
  [[nodiscard]] Box grown_up(Box box) const {
    int south = 0, north = rows_;
    for (int column = box.west; column <= box.east; ++column) {
      south = std::max(south, runs_[index(column, box.south)].south);
      north = std::min(north, runs_[index(column, box.south)].north);
    }
    return {box.west, south, box.east, north};
  }

  int columns_, rows_;
  std::vector<bool> clear_;
  std::vector<Run> runs_;
};

// Counts the rectangles that a way takes from each cell on, from the goals backwards.
class Counting {
 public:
  Counting(const CellGrid& cells, std::int32_t limit_mm)
      : cells_(cells), clear_(cells, limit_mm), boxes_(clear_.rectangles()) {}

  // To the nearest cell as clear as that.
  std::optional<int> most(std::int32_t goal_mm) {
    std::vector<std::size_t> goals;
    for (std::size_t at = 0; at < cells_.clearance_mm_lo.size(); ++at) {
      if (cells_.clearance_mm_lo[at] >= goal_mm && is_clear(at)) goals.push_back(at);
    }
    return most_to(goals);
  }
  std::optional<int> most_to(const std::vector<std::size_t>& goals) {
    if (!find_ways(goals) || !hold_boxes()) return std::nullopt;
    int most = 0;
    for (const std::size_t at : order_) {
      if (to_go_[at] > 0) most = std::max(most, count_from(at));
    }
    return most;
  }
  [[nodiscard]] bool is_clear(std::size_t at) const { return clear_.at(column_of(at), row_of(at)); }

 private:
  static constexpr double unreached = std::numeric_limits<double>::infinity();
  // A way that is in a rectangle takes so many others yet.
  struct Piece {
    std::size_t box;
    int others = 0;
  };
  [[nodiscard]] int column_of(std::size_t at) const {
    return static_cast<int>(at) % cells_.columns;
  }
  [[nodiscard]] int row_of(std::size_t at) const { return static_cast<int>(at) / cells_.columns; }

  // How far it is from each cell to the nearest goal. false: too far.
  bool find_ways(const std::vector<std::size_t>& goals) {
    using Entry = std::pair<double, std::size_t>;
    to_go_.assign(cells_.clearance_mm_lo.size(), unreached);
    order_.clear();
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (const std::size_t at : goals) {
      to_go_[at] = 0;
      open.emplace(0, at);
    }
    double longest = 0;
    while (!open.empty()) {
      const double so_far = open.top().first;
      const std::size_t at = open.top().second;
      open.pop();
      if (so_far > to_go_[at]) continue;
      order_.push_back(at);
      longest = so_far;
      clear_.steps_from(column_of(at), row_of(at), [&](int column, int row, double step) {
        double& other = to_go_[clear_.index(column, row)];
        if (so_far + step >= other) return;
        other = so_far + step;
        open.emplace(other, clear_.index(column, row));
      });
    }
    // with the leg that leads to its first cell
    const double in_all = longest + cells_.columns + cells_.rows;
    return (longest + 2) * in_all * of_step < of_steps_max;
  }
  bool hold_boxes() {
    std::int64_t covered = 0;
    for (const Box& box : boxes_) {
      covered += std::int64_t{box.east - box.west + 1} * (box.north - box.south + 1);
    }
    if (covered > covered_max) return false;
    pieces_.assign(to_go_.size(), {});
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const Box& box = boxes_[i];
      for (int row = box.south; row <= box.north; ++row) {
        for (int column = box.west; column <= box.east; ++column) {
          pieces_[clear_.index(column, row)].push_back({i});
        }
      }
    }
    return true;
  }
  // Of all ways that are about the shortest; those from what lies nearer to a goal are counted.
  int count_from(std::size_t at) {
    const int column = column_of(at), row = row_of(at);
    int most = 0;
    clear_.steps_from(column, row, [&](int x, int y, double step) {
      const std::size_t to = clear_.index(x, y);
      if (to_go_[to] + step > to_go_[at] + spare) return;
      // where it leaves a rectangle it goes on in the best one that holds the step
      int anew = std::numeric_limits<int>::max();
      for (const Piece& piece : pieces_[to]) {
        if (boxes_[piece.box].holds(column, row)) anew = std::min(anew, 1 + piece.others);
      }
      most = std::max(most, anew);
      auto next = pieces_[to].begin();
      for (Piece& piece : pieces_[at]) {
        while (next != pieces_[to].end() && next->box < piece.box) ++next;
        const bool stays = next != pieces_[to].end() && next->box == piece.box;
        piece.others = std::max(piece.others, stays ? next->others : anew);
      }
    });
    return most;
  }

  const CellGrid& cells_;
  const Clear clear_;
  const std::vector<Box> boxes_;
  std::vector<double> to_go_;
  std::vector<std::size_t> order_;          // the nearest to a goal first
  std::vector<std::vector<Piece>> pieces_;  // by cell, in the order of the rectangles
};

// The limits that leave different cells: `from_mm`, what single cells have below `to_mm`, and that.
std::set<std::int32_t> limits_between(const CellGrid& cells, std::int32_t from_mm,
                                      std::int32_t to_mm) {
  std::set<std::int32_t> found = {to_mm};
  for (const std::int32_t clearance : cells.clearance_mm_lo) {
    if (clearance >= from_mm && clearance < to_mm) found.insert(clearance);
  }
  return found;
}
// The least clearance of a cell that is a goal; none: there is no such cell.
std::optional<std::int32_t> least_from(const CellGrid& cells, std::int32_t goal_mm) {
  std::optional<std::int32_t> least;
  for (const std::int32_t clearance : cells.clearance_mm_lo) {
    if (clearance >= goal_mm && (!least || clearance < *least)) least = clearance;
  }
  return least;
}

std::optional<int> count(const CellGrid& cells, const WayLegsQuery& query) {
  std::set<std::int32_t> goals;
  for (const std::int32_t goal_mm : query.goals_mm) {
    for (const std::int32_t rounding : roundings_mm) {
      if (const auto least = least_from(cells, goal_mm + rounding)) goals.insert(*least);
    }
  }
  const std::set<std::int32_t> limits = limits_between(cells, query.least_mm, query.route_mm);
  const auto asked = static_cast<std::int64_t>(limits.size() * goals.size());
  if (asked * std::int64_t{cells.columns} * cells.rows > cells_max) return std::nullopt;
  int most = 0;
  for (const std::int32_t limit_mm : limits) {
    Counting counting(cells, limit_mm);
    for (const std::int32_t goal_mm : goals) {
      const auto found = counting.most(goal_mm);
      if (!found) return std::nullopt;
      most = std::max(most, *found);
    }
  }
  return most;
}

// The cells that touch a place: the first of them, the eastern and northern one, is said to hold
// it.
std::vector<std::size_t> cells_at(const CellGrid& cells, GridPoint place) {
  const std::int64_t x = std::int64_t{place.x_mm} - cells.origin.x_mm;
  const std::int64_t y = std::int64_t{place.y_mm} - cells.origin.y_mm;
  std::vector<std::size_t> all;
  if (x < 0 || y < 0) return all;
  const std::int64_t column = x / cells.cell_mm, row = y / cells.cell_mm;
  for (std::int64_t r = row; r >= row - (y % cells.cell_mm == 0 ? 1 : 0); --r) {
    for (std::int64_t c = column; c >= column - (x % cells.cell_mm == 0 ? 1 : 0); --c) {
      if (r < 0 || c < 0 || c >= cells.columns || r >= cells.rows) continue;
      all.push_back(static_cast<std::size_t>(r * cells.columns + c));
    }
  }
  return all;
}

// Within the goal's cell the last leg goes on to the site: one more for who is in that already. A
// site between cells is in plain sight only of what sees all of these: if one of them is not clear,
// the way leads to the middle of its own cell first.
std::optional<int> count_to(const CellGrid& cells, std::int32_t route_mm, GridPoint site) {
  const std::vector<std::size_t> around = cells_at(cells, site);
  Counting counting(cells, route_mm);
  if (around.empty() || !counting.is_clear(around.front())) return std::nullopt;
  const std::optional<int> found = counting.most_to({around.front()});
  if (!found) return std::nullopt;
  const bool in_sight =
      std::ranges::all_of(around, [&](std::size_t at) { return counting.is_clear(at); });
  return in_sight ? std::max(1, *found) : *found + 1;
}

}  // namespace

std::optional<int> most_legs_to(const CellGrid& cells, std::int32_t route_mm, GridPoint site) {
  using Question = std::tuple<Drawn, std::int32_t, GridPoint>;
  thread_local Kept<Question, std::optional<int>> kept;
  return kept.find({Drawn({}, cells), route_mm, site},
                   [&] { return count_to(cells, route_mm, site); });
}

std::optional<int> most_legs(const CellGrid& cells, const WayLegsQuery& query) {
  thread_local Kept<std::pair<Drawn, WayLegsQuery>, std::optional<int>> kept;
  return kept.find({Drawn({}, cells), query}, [&] { return count(cells, query); });
}

}  // namespace rtac::geometry
