#include "compiler/recheck/straight.h"

#include <algorithm>
#include <cmath>

namespace rtac::recheck {
namespace {

// The search tries so many cells of the zone, ring by ring; and some of them are enough.
constexpr int tests_max = 2000, quarters_max = 7;
constexpr std::size_t enough = 320;
// It forgives 2 mm, of which half may be lost to the grid.
constexpr double forgiven_m = 0.001;
constexpr std::int64_t steps_max = 60'000'000, of_cell_max = 600'000;

double apart(Place a, Place b) {
  return length(a.x - b.x, a.y - b.y);
}

}  // namespace

Straight::Straight(const std::vector<Segment>& zone, const Grid& grid, double body, bool convex)
    : zone_(zone), grid_(grid), body_(body), convex_(convex), met_(met()) {}

// Row by row, beside the piece of a segment that is in it: some more than it meets.
std::vector<bool> Straight::met() const {
  constexpr double near = table_m + 2 * slack_m;
  std::vector<bool> all(grid_.clearance.size(), false);
  const auto cell = [&](double at, double origin, std::size_t count) {
    return static_cast<std::size_t>(
        std::clamp(std::floor((at - origin) / grid_.cell), 0.0, double(count - 1)));
  };
  for (const Segment& s : zone_) {
    const auto [low, top] = std::minmax(s.ay, s.by);
    const std::size_t last = cell(top + near, grid_.y, grid_.rows);
    for (std::size_t r = cell(low - near, grid_.y, grid_.rows); r <= last; ++r) {
      const Box row = grid_.box(0, r, 1);
      double from = 0, to = 1;  // of the segment
      if (low < top) {
        const double a = (row.y - near - s.ay) / (s.by - s.ay);
        const double b = (row.top + near - s.ay) / (s.by - s.ay);
        from = std::clamp(std::min(a, b), 0.0, 1.0), to = std::clamp(std::max(a, b), 0.0, 1.0);
      }
      const double x0 = s.ax + (s.bx - s.ax) * from, x1 = s.ax + (s.bx - s.ax) * to;
      const std::size_t end = cell(std::max(x0, x1) + near, grid_.x, grid_.columns);
      std::size_t c = cell(std::min(x0, x1) - near, grid_.x, grid_.columns);
      for (; c <= end; ++c) all[r * grid_.columns + c] = true;
    }
  }
  return all;
}

template <class Visit>
Straight::Tried Straight::visit_ring(std::size_t cell, int ring, const Visit& visit) const {
  const auto columns = static_cast<int>(grid_.columns), rows = static_cast<int>(grid_.rows);
  const int column = static_cast<int>(cell) % columns, row = static_cast<int>(cell) / columns;
  Tried tried;
  for (int r = std::max(0, row - ring); r <= std::min(rows - 1, row + ring); ++r) {
    const bool side = std::abs(r - row) == ring;
    for (int c = column - ring; c <= column + ring; c += side || ring == 0 ? 1 : 2 * ring) {
      if (c < 0 || c >= columns) continue;
      const auto at = static_cast<std::size_t>(r * columns + c);
      const bool inside = grid_.clearance[at] >= table_m;
      tried.surely += inside ? 1 : 0;
      tried.perhaps += inside || met_[at] ? 1 : 0;
      visit(grid_.clearance[at],
            middle(grid_.box(static_cast<std::size_t>(c), static_cast<std::size_t>(r), 1)));
    }
  }
  return tried;
}

std::optional<double> Straight::longest_from(std::size_t cell, double goal, double most) {
  const Box here = grid_.box(cell % grid_.columns, cell / grid_.columns, 1);
  if (starts_ && !starts_->may_be_in(here)) return 0.0;
  std::vector<Place> ends;
  int tried = 0;
  const auto last = static_cast<int>(std::max(grid_.columns, grid_.rows));
  for (int ring = 0; ring <= last && ends.size() < enough; ++ring) {
    std::vector<Place> of_ring;
    tried += visit_ring(cell, ring, [&](double clearance, Place end) {
               if (clearance >= goal + table_m) of_ring.push_back(end);
             }).perhaps;
    if (tried > tests_max) break;
    ends.insert(ends.end(), of_ring.begin(), of_ring.end());
  }
  std::ranges::stable_sort(ends, {}, [&](Place end) { return apart(end, middle(here)); });
  steps_ += static_cast<std::int64_t>(zone_.size());
  if (ends.empty() || steps_ > steps_max) return std::nullopt;
  const double roughly = apart(ends.front(), middle(here)) + grid_.cell;
  if (convex_ && roughly <= most) return roughly;
  steps_end_ = std::min(steps_max, steps_ + of_cell_max);
  const double within =
      apart(ends.back(), middle(here)) + 3 * grid_.cell + std::max(goal, body_) + snap_m;
  return longest_in(Boundary(zone_, middle(here), within), here, goal, most, ends, quarters_max);
}

std::optional<double> Straight::longest_in(const Boundary& boundary, const Box& from, double goal,
                                           double most, const std::vector<Place>& ends, int times) {
  if (boundary.holds_nobody(from, body_)) return 0.0;
  if (starts_ && !starts_->may_be_in(from)) return 0.0;
  const double counts = goal + table_m + 2 * radius(from);  // no more of the clearance matters
  if (boundary.asked_from(from, counts, 0) >= counts) return 0.0;
  const double asked = boundary.asked_from(from, goal, forgiven_m);
  for (const Place end : ends) {
    ++steps_;
    const double leg = apart(end, middle(from)) + radius(from);
    if (leg <= most && boundary.keeps(from, end, asked)) return leg;
  }
  if (times == 0 || steps_ > steps_end_) return std::nullopt;
  double longest = 0;
  for (const Box& quarter : quarters(from)) {
    const auto leg = longest_in(boundary, quarter, goal, most, ends, times - 1);
    if (!leg) return std::nullopt;
    longest = std::max(longest, *leg);
  }
  return longest;
}

double Straight::farthest_from(std::size_t cell, double goal) const {
  const Place here = middle(grid_.box(cell % grid_.columns, cell / grid_.columns, 1));
  double most = 0;
  int tried = 0;
  const auto last = static_cast<int>(std::max(grid_.columns, grid_.rows));
  for (int ring = 0; ring <= last && tried <= tests_max; ++ring) {
    tried += visit_ring(cell, ring, [&](double clearance, Place end) {
               if (clearance >= goal - snap_m) most = std::max(most, apart(end, here) + grid_.cell);
             }).surely;
  }
  return most;
}

}  // namespace rtac::recheck
