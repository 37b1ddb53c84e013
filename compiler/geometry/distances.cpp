#include <algorithm>
#include <cstdlib>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "compiler/geometry/bake.h"

namespace rtac::geometry {
namespace {

// Path lengths are summed in 2^-10 mm, so that rounding every diagonal step up costs at most 1 mm
// per thousand steps.
constexpr std::int64_t kFine = 1024;
constexpr std::int64_t kUnreached = std::numeric_limits<std::int64_t>::max();

// The smallest integer whose square is at least `value`.
std::int64_t ceil_sqrt(std::int64_t value) {
  std::int64_t lo = 0;
  std::int64_t hi = 3'037'000'499;  // the largest whose square fits
  while (lo < hi) {
    const std::int64_t middle = lo + (hi - lo) / 2;
    if (middle * middle < value) {
      lo = middle + 1;
    } else {
      hi = middle;
    }
  }
  return lo;
}

// At least factor * sqrt(value); `value` is a squared distance in cells.
std::int64_t times_root_up(std::int64_t factor, std::int64_t value) {
  // Beyond 2^32 the root itself has 16 bits, enough for a relative error below 2e-5.
  const std::int64_t scale = value < (std::int64_t{1} << 32) ? 1 << 15 : 1;
  const std::int64_t root = ceil_sqrt(value * scale * scale);
  return (factor * root + scale - 1) / scale;
}

struct Cell {
  std::int32_t column, row;
};

class Router {
 public:
  Router(const CellGrid& grid, std::int32_t clearance_mm, std::int32_t body_mm)
      : grid_(grid),
        clearance_mm_(std::max(clearance_mm, 0)),
        body_mm_(body_mm),
        fine_(grid.clearance_mm_lo.size(), kUnreached) {}

  // Fills `fine_` for everything that is connected to the site.
  void route_from(GridPoint site) {
    const Cell start = site_cell(site);
    if (start.column < 0) return;
    using Entry = std::pair<std::int64_t, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const std::int64_t straight = grid_.cell_mm * kFine;
    const std::int64_t diagonal = times_root_up(straight, 2);
    fine_[index(start)] = 0;
    queue.emplace(0, index(start));
    while (!queue.empty()) {
      const auto [length, at] = queue.top();
      queue.pop();
      if (length > fine_[at]) continue;
      for (const auto& [next, is_diagonal] : steps(cell(at))) {
        const std::int64_t sum = length + (is_diagonal ? diagonal : straight);
        if (sum >= fine_[next]) continue;
        fine_[next] = sum;
        queue.emplace(sum, next);
      }
    }
  }

  [[nodiscard]] std::vector<std::int32_t> values(std::int32_t connector_mm) const {
    // Half a diagonal at either end.
    const std::int64_t ends = times_root_up(grid_.cell_mm * kFine, 2);
    std::vector<std::int32_t> result(fine_.size(), -1);
    for (std::size_t i = 0; i < fine_.size(); ++i) {
      if (fine_[i] != kUnreached) result[i] = to_mm(fine_[i] + ends);
    }
    const std::vector<std::int32_t> routed = result;
    const std::vector<Offset> offsets = offsets_within(connector_mm);
    for (std::size_t i = 0; i < result.size(); ++i) {
      if (grid_.clearance_mm_lo[i] < clearance_mm_ && grid_.clearance_mm_hi[i] >= body_mm_ &&
          grid_.clearance_mm_hi[i] >= 0) {
        result[i] = connect(cell(i), offsets, routed);
      }
    }
    return result;
  }

 private:
  struct Offset {
    std::int64_t squared;  // in cells
    std::int32_t columns, rows;
  };

  [[nodiscard]] bool in_grid(const Cell& c) const {
    return c.column >= 0 && c.row >= 0 && c.column < grid_.columns && c.row < grid_.rows;
  }
  [[nodiscard]] std::size_t index(const Cell& c) const {
    return static_cast<std::size_t>(c.row) * static_cast<std::size_t>(grid_.columns) +
           static_cast<std::size_t>(c.column);
  }
  [[nodiscard]] Cell cell(std::size_t at) const {
    const auto columns = static_cast<std::size_t>(grid_.columns);
    return {static_cast<std::int32_t>(at % columns), static_cast<std::int32_t>(at / columns)};
  }
  [[nodiscard]] bool admissible(const Cell& c) const {
    return in_grid(c) && grid_.clearance_mm_lo[index(c)] >= clearance_mm_;
  }
  [[nodiscard]] bool passable(const Cell& c) const {
    return in_grid(c) && grid_.clearance_mm_hi[index(c)] >= std::max(body_mm_, 0);
  }

  static std::int32_t to_mm(std::int64_t fine) {
    const std::int64_t mm = (fine + kFine - 1) / kFine;
    return mm > std::numeric_limits<std::int32_t>::max() ? -1 : static_cast<std::int32_t>(mm);
  }

  // A closed cell that contains the site and is admissible; column -1: there is none. A site on a
  // line between cells belongs to those on both sides, the north-eastern first.
  [[nodiscard]] Cell site_cell(GridPoint site) const {
    const std::int64_t x = std::int64_t{site.x_mm} - grid_.origin.x_mm;
    const std::int64_t y = std::int64_t{site.y_mm} - grid_.origin.y_mm;
    const std::int64_t size = grid_.cell_mm;
    if (x < 0 || y < 0 || x > size * grid_.columns || y > size * grid_.rows) return {-1, -1};
    for (const std::int32_t down : {0, 1}) {
      for (const std::int32_t left : {0, 1}) {
        if ((down == 1 && y % size != 0) || (left == 1 && x % size != 0)) continue;
        const Cell c{static_cast<std::int32_t>(x / size) - left,
                     static_cast<std::int32_t>(y / size) - down};
        if (admissible(c)) return c;
      }
    }
    return {-1, -1};
  }

  // Admissible neighbours, and whether the step to them is diagonal.
  [[nodiscard]] std::vector<std::pair<std::size_t, bool>> steps(const Cell& from) const {
    std::vector<std::pair<std::size_t, bool>> result;
    result.reserve(8);
    for (std::int32_t rows = -1; rows <= 1; ++rows) {
      for (std::int32_t columns = -1; columns <= 1; ++columns) {
        const bool is_diagonal = rows != 0 && columns != 0;
        const Cell to{from.column + columns, from.row + rows};
        if ((rows == 0 && columns == 0) || !admissible(to)) continue;
        if (is_diagonal &&
            !(admissible({from.column, to.row}) && admissible({to.column, from.row})))
          continue;
        result.emplace_back(index(to), is_diagonal);
      }
    }
    return result;
  }

  // Nearest first; equally near ones from the south-west row by row.
  [[nodiscard]] std::vector<Offset> offsets_within(std::int32_t connector_mm) const {
    std::vector<Offset> offsets;
    const std::int64_t reach = std::min(connector_mm, 1 << 30);
    const std::int64_t size = grid_.cell_mm;
    if (connector_mm <= 0 || size <= 0) return offsets;
    const auto rows = static_cast<std::int32_t>(std::min<std::int64_t>(reach / size, grid_.rows));
    const auto columns =
        static_cast<std::int32_t>(std::min<std::int64_t>(reach / size, grid_.columns));
    for (std::int32_t r = -rows; r <= rows; ++r) {
      for (std::int32_t c = -columns; c <= columns; ++c) {
        const std::int64_t squared = std::int64_t{r} * r + std::int64_t{c} * c;
        if (squared == 0 || squared * size * size > reach * reach) continue;
        offsets.push_back({squared, c, r});
      }
    }
    std::stable_sort(offsets.begin(), offsets.end(),
                     [](const Offset& a, const Offset& b) { return a.squared < b.squared; });
    return offsets;
  }

  // The cells that the straight way between two centres passes are passable; where it passes a
  // corner, both cells beside it.
  [[nodiscard]] bool open_way(const Cell& from, const Offset& offset) const {
    const std::int64_t width = std::abs(offset.columns);
    const std::int64_t height = std::abs(offset.rows);
    const std::int32_t east = offset.columns < 0 ? -1 : 1;
    const std::int32_t north = offset.rows < 0 ? -1 : 1;
    Cell at = from;
    // The way leaves the i-th column at (2 i + 1) / (2 width) of its length, rows likewise.
    for (std::int64_t i = 0, j = 0; i < width || j < height;) {
      const std::int64_t order = (2 * i + 1) * height - (2 * j + 1) * width;
      if (order == 0 &&
          !(passable({at.column + east, at.row}) && passable({at.column, at.row + north}))) {
        return false;
      }
      if (order <= 0) {
        at.column += east;
        ++i;
      }
      if (order >= 0) {
        at.row += north;
        ++j;
      }
      if (!passable(at)) return false;
    }
    return true;
  }

  [[nodiscard]] std::int32_t connect(const Cell& from, const std::vector<Offset>& offsets,
                                     const std::vector<std::int32_t>& routed) const {
    std::int32_t best = -1;
    std::int64_t best_squared = kUnreached;
    for (const Offset& offset : offsets) {
      if (offset.squared > best_squared) break;
      const Cell to{from.column + offset.columns, from.row + offset.rows};
      if (!in_grid(to) || routed[index(to)] < 0) continue;
      if ((best >= 0 && routed[index(to)] >= best) || !open_way(from, offset)) continue;
      best = routed[index(to)];
      best_squared = offset.squared;
    }
    if (best < 0) return -1;
    // From anywhere in the cell: half a diagonal more than from its centre.
    const std::int64_t size = grid_.cell_mm * kFine;
    const std::int64_t half_diagonal = (times_root_up(size, 2) + 1) / 2;
    return to_mm(best * kFine + times_root_up(size, best_squared) + half_diagonal);
  }

  const CellGrid& grid_;
  std::int32_t clearance_mm_;
  std::int32_t body_mm_;
  std::vector<std::int64_t> fine_;
};

}  // namespace

std::vector<std::int32_t> distances_to(const CellGrid& cells, GridPoint site,
                                       std::int32_t clearance_mm, std::int32_t body_mm,
                                       std::int32_t connector_mm) {
  Router router(cells, clearance_mm, body_mm);
  router.route_from(site);
  return router.values(connector_mm);
}

}  // namespace rtac::geometry
