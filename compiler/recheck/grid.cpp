#include "compiler/recheck/grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace rtac::recheck {

namespace {

// In whole millimetres, where doubles tell them apart even squared. Asked of the exact number: what
// is off by however little, the robot has up to 1 mm elsewhere.
bool is_on_grid(const geometry::Point& p) {
  const Rational far_m = 10'000;
  const auto whole = [&](const Rational& m) {
    return abs(m) < far_m && Rational(m * 1000).get_den() == 1;
  };
  return whole(p.x) && whole(p.y);
}

}  // namespace

std::vector<Segment> segments_of(const geometry::Region& region) {
  std::vector<Segment> all;
  for (const geometry::Ring& ring : region.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const geometry::Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      all.push_back(
          {a.x.get_d(), a.y.get_d(), b.x.get_d(), b.y.get_d(), is_on_grid(a) && is_on_grid(b)});
    }
  }
  return all;
}

double square_to(const Segment& s, double x, double y) {
  const double dx = s.bx - s.ax, dy = s.by - s.ay;
  const double along =
      std::clamp(((x - s.ax) * dx + (y - s.ay) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  const double ex = s.ax + along * dx - x, ey = s.ay + along * dy - y;
  return ex * ex + ey * ey;
}

namespace {

bool holds(const Box& box, double x, double y) {
  return x >= box.x && x <= box.right && y >= box.y && y <= box.top;
}
// Whether the segment passes through the box: clipped by its four sides.
bool crosses(const Box& box, const Segment& s) {
  double from = 0, to = 1;
  const auto clip = [&](double start, double step, double low, double high) {
    if (step == 0) return start >= low && start <= high;
    const double a = (low - start) / step, b = (high - start) / step;
    from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
    return from <= to;
  };
  return clip(s.ax, s.bx - s.ax, box.x, box.right) && clip(s.ay, s.by - s.ay, box.y, box.top);
}
// Of the nearest two places of both.
double square_to(const Segment& s, const Box& box) {
  if (holds(box, s.ax, s.ay) || crosses(box, s)) return 0;
  double least = 1e300;
  for (const double x : {box.x, box.right}) {
    for (const double y : {box.y, box.top}) least = std::min(least, square_to(s, x, y));
  }
  for (const auto& [x, y] : {std::pair{s.ax, s.ay}, std::pair{s.bx, s.by}}) {
    const double dx = x - std::clamp(x, box.x, box.right), dy = y - std::clamp(y, box.y, box.top);
    least = std::min(least, dx * dx + dy * dy);
  }
  return least;
}

__extension__ using Wide = __int128;
constexpr double per_mm = 1e-3;
constexpr double same_m = 1e-9;  // what two doubles of one length differ by, and more

// Whether a place of the segment is nearer to the box than `mm`, exactly, where both are on the
// grid and have no place in common: one of the nearest two is an end or a corner.
// Within the range of such coordinates (is_on_grid) no product has more than 105 bits.
bool is_nearer(const Segment& s, const Box& box, long mm) {
  const auto exact = [](double m) { return Wide{std::lround(m / per_mm)}; };
  const Wide ax = exact(s.ax), ay = exact(s.ay), bx = exact(s.bx), by = exact(s.by);
  const Wide left = exact(box.x), right = exact(box.right);
  const Wide low = exact(box.y), top = exact(box.top);
  const Wide limit = Wide{mm} * mm, dx = bx - ax, dy = by - ay, along = dx * dx + dy * dy;
  const auto end_is_near = [&](Wide x, Wide y) {
    const Wide off_x = x - std::clamp(x, left, right), off_y = y - std::clamp(y, low, top);
    return off_x * off_x + off_y * off_y < limit;
  };
  const auto corner_is_near = [&](Wide x, Wide y) {
    const Wide part = (x - ax) * dx + (y - ay) * dy, beside = (y - ay) * dx - (x - ax) * dy;
    return part > 0 && part < along && beside * beside < limit * along;
  };
  return end_is_near(ax, ay) || end_is_near(bx, by) || corner_is_near(left, low) ||
         corner_is_near(right, low) || corner_is_near(left, top) || corner_is_near(right, top);
}

// Blocks of cells are quartered, and each hands on the segments that may be the nearest ones of
// some cell of it.
class Filler {
 public:
  Filler(const std::vector<Segment>& all, Grid& grid)
      : all_(all), grid_(grid), on_grid_(std::ranges::all_of(all, &Segment::on_grid)) {
    grid_.clearance.assign(grid_.columns * grid_.rows, -1);
    if (on_grid_) grid_.less = -same_m;
  }
  void run() {
    std::size_t side = 1;
    while (side < std::max(grid_.columns, grid_.rows)) side *= 2;
    std::vector<std::size_t> every(all_.size());
    std::iota(every.begin(), every.end(), std::size_t{0});
    find_insides();
    fill(0, 0, side, every);
  }

 private:
  void find_insides() {
    inside_.assign(grid_.clearance.size(), false);
    std::vector<std::vector<double>> crossings(grid_.rows);
    for (const Segment& s : all_) {
      const double low = std::min(s.ay, s.by), high = std::max(s.ay, s.by);
      const double first = std::max(0.0, std::ceil((low - grid_.y) / grid_.cell - 0.5));
      for (double row = first; row < double(grid_.rows); ++row) {
        const double y = grid_.y + (row + 0.5) * grid_.cell;
        if (y > high) break;
        if ((s.ay > y) == (s.by > y)) continue;
        crossings[std::size_t(row)].push_back(s.ax + (y - s.ay) / (s.by - s.ay) * (s.bx - s.ax));
      }
    }
    for (std::size_t row = 0; row < grid_.rows; ++row) {
      std::sort(crossings[row].begin(), crossings[row].end());
      std::size_t passed = 0;
      for (std::size_t column = 0; column < grid_.columns; ++column) {
        const double x = grid_.x + (double(column) + 0.5) * grid_.cell;
        while (passed < crossings[row].size() && crossings[row][passed] < x) ++passed;
        inside_[row * grid_.columns + column] = passed % 2 == 1;
      }
    }
  }
  void fill(std::size_t column, std::size_t row, std::size_t side,
            const std::vector<std::size_t>& candidates) {
    if (column >= grid_.columns || row >= grid_.rows) return;
    const Box box = grid_.box(column, row, side);
    std::vector<double> squares;
    double least = 1e300;
    for (const std::size_t s : candidates) {
      squares.push_back(square_to(all_[s], box));
      least = std::min(least, squares.back());
    }
    if (side == 1) {
      const std::size_t at = row * grid_.columns + column;
      if (!inside_[at]) return;
      grid_.clearance[at] = on_grid_ ? rounded_down(std::sqrt(least), box, candidates, squares)
                                     : std::sqrt(least) - slack_m;
      return;
    }
    // nowhere in the block is the nearest one farther than the block is wide, across, from it
    const double reach = std::sqrt(least) + (box.right - box.x) * std::sqrt(2.0) + slack_m;
    std::vector<std::size_t> near;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      if (squares[k] <= reach * reach) near.push_back(candidates[k]);
    }
    const std::size_t half = side / 2;
    for (const std::size_t c : {column, column + half}) {
      for (const std::size_t r : {row, row + half}) fill(c, r, half, near);
    }
  }

  // To whole millimetres; what a double cannot tell is found exactly.
  [[nodiscard]] double rounded_down(double least, const Box& box,
                                    const std::vector<std::size_t>& candidates,
                                    const std::vector<double>& squares) const {
    constexpr double unsure = 1e-3;  // mm
    const double mm = least / per_mm, whole = std::round(mm);
    if (std::abs(mm - whole) > unsure || whole == 0) return std::floor(mm) * per_mm;
    const double surely_farther = (whole + unsure) * per_mm;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      if (squares[k] > surely_farther * surely_farther) continue;
      if (is_nearer(all_[candidates[k]], box, std::lround(whole))) return (whole - 1) * per_mm;
    }
    return whole * per_mm;
  }

  const std::vector<Segment>& all_;
  Grid& grid_;
  const bool on_grid_;
  std::vector<bool> inside_;
};

}  // namespace

std::optional<Grid> grid_of(const std::vector<Segment>& all, const Cells& cells) {
  Grid grid;
  double right = all[0].ax, top = all[0].ay, left = right, low = top;
  for (const Segment& s : all) {
    left = std::min(left, s.ax), low = std::min(low, s.ay);
    right = std::max(right, s.ax), top = std::max(top, s.ay);
  }
  grid.x = double(cells.x_mm) / 1000, grid.y = double(cells.y_mm) / 1000;
  grid.cell = double(cells.cell_mm) / 1000;
  // it begins where the zone does, of which robots know corners in whole millimetres as they are
  const double off = std::ranges::all_of(all, &Segment::on_grid) ? same_m : snap_m;
  if (std::abs(grid.x - left) > off || std::abs(grid.y - low) > off) return std::nullopt;
  // 40,000 of them at most, each 10 cm wide or a larger multiple of 1 cm
  const auto count = [&](double cell) {
    return std::ceil((right - left) / cell) * std::ceil((top - low) / cell);
  };
  if (cells.cell_mm % 10 != 0) return std::nullopt;
  constexpr double least_m = 0.1, step_m = 0.01, most = 40'000;
  constexpr double ends = 400;  // cells at two ends, where the grid has made the zone smaller
  const bool wide_enough = count(grid.cell) <= most + 2 * ends;
  const bool narrow_enough =
      grid.cell < least_m + step_m / 2 || count(grid.cell - step_m) > most - 2 * ends;
  if (grid.cell < least_m - slack_m || !wide_enough || !narrow_enough) return std::nullopt;
  grid.columns = static_cast<std::size_t>(std::ceil((right - grid.x) / grid.cell - snap_m));
  grid.rows = static_cast<std::size_t>(std::ceil((top - grid.y) / grid.cell - snap_m));
  Filler(all, grid).run();
  return grid;
}

}  // namespace rtac::recheck
