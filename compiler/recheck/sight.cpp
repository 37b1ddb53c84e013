#include "compiler/recheck/sight.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "compiler/recheck/grid.h"
#include "compiler/recheck/legs.h"

namespace rtac::recheck {
namespace {

double nearest(const Box& b, Place p) {
  return length(std::max({b.x - p.x, p.x - b.right, 0.0}), std::max({b.y - p.y, p.y - b.top, 0.0}));
}
double farthest(const Box& b, Place p) {
  return length(std::max(p.x - b.x, b.right - p.x), std::max(p.y - b.y, b.top - p.y));
}

// A cell with room; `surely`: in the tables of the robot, too, which are up to 4 mm less clear.
struct Aim {
  Place place;
  bool surely;
};

class Sights {
 public:
  Sights(const std::vector<Segment>& all, const Grid& grid, const SightLimits& limits)
      : all_(all),
        grid_(grid),
        limits_(limits),
        columns_(static_cast<int>(grid.columns)),
        rows_(static_cast<int>(grid.rows)) {}

  std::variant<std::optional<geometry::Point>, BadCells> run() {
    for (int r = 0; r < rows_; ++r) {
      for (int c = 0; c < columns_; ++c) {
        if (clearance(c, r) >= limits_.aim + table_m || sees(c, r)) continue;
        if (steps_ > steps_max) return BadCells{};
        const Place m = middle(box(c, r));
        return std::optional(geometry::Point{Rational(m.x), Rational(m.y)});
      }
    }
    return std::optional<geometry::Point>();
  }

 private:
  static constexpr int quarters_max = 7;
  static constexpr std::int64_t steps_max = 1'000'000'000;
  // The runtime forgives 2 mm, of which half may be lost to the grid.
  static constexpr double forgiven_m = 0.001;

  [[nodiscard]] Box box(int c, int r) const {
    return grid_.box(static_cast<std::size_t>(c), static_cast<std::size_t>(r), 1);
  }
  [[nodiscard]] double clearance(int c, int r) const {
    return grid_.clearance[static_cast<std::size_t>(r * columns_ + c)];
  }

  // The cells with room in a growing square, up to where no other one can be the nearest.
  std::vector<Aim> aims_of(int column, int row) {
    std::vector<Aim> found;
    const Box here = box(column, row);
    double least = 1e300;
    for (int off = 0; off <= std::max(columns_, rows_); ++off) {
      if ((off - 1) * grid_.cell > least) break;
      for (int r = std::max(0, row - off); r <= std::min(rows_ - 1, row + off); ++r) {
        for (int c = std::max(0, column - off); c <= std::min(columns_ - 1, column + off); ++c) {
          if (std::max(std::abs(c - column), std::abs(r - row)) != off) continue;
          if (++steps_ > steps_max) return {};
          if (clearance(c, r) < limits_.aim) continue;
          found.push_back({middle(box(c, r)), clearance(c, r) >= limits_.aim + table_m});
          if (found.back().surely) least = std::min(least, farthest(here, found.back().place));
        }
      }
    }
    return found;
  }
  bool sees(int column, int row) {
    const Box here = box(column, row);
    const std::vector<Aim> aims = aims_of(column, row);
    double reach = 0;
    for (const Aim& aim : aims) reach = std::max(reach, farthest(here, aim.place));
    const double within =
        reach + 2 * grid_.cell + std::max({limits_.route, limits_.body, limits_.aim}) + snap_m;
    const Boundary boundary(all_, middle(here), within);
    return sees(boundary, here, aims, quarters_max);
  }
  bool sees(const Boundary& boundary, const Box& here, const std::vector<Aim>& aims, int times) {
    if (boundary.holds_nobody(here, limits_.body)) return true;
    // who has as much room already stays
    const double clear = boundary.asked_from(here, 1e300, 0) - 2 * radius(here);
    if (clear >= limits_.aim + table_m) return true;
    double least = 1e300;
    for (const Aim& aim : aims) {
      if (aim.surely) least = std::min(least, farthest(here, aim.place));
    }
    steps_ += 20 * static_cast<std::int64_t>(aims.size());
    const double asked = boundary.asked_from(here, limits_.route, forgiven_m);
    const bool all = std::ranges::all_of(aims, [&](const Aim& aim) {
      return nearest(here, aim.place) > least + slack_m || boundary.keeps(here, aim.place, asked);
    });
    if (all && least < 1e300) return true;
    if (times == 0 || steps_ > steps_max) return false;
    return std::ranges::all_of(quarters(here), [&](const Box& quarter) {
      return sees(boundary, quarter, aims, times - 1);
    });
  }

  const std::vector<Segment>& all_;
  const Grid& grid_;
  const SightLimits limits_;
  const int columns_, rows_;
  std::int64_t steps_ = 0;
};

}  // namespace

std::variant<std::optional<geometry::Point>, BadCells> out_of_sight(const geometry::Region& zone,
                                                                    const Cells& cells,
                                                                    const SightLimits& limits) {
  const std::vector<Segment> all = segments_of(zone);
  const std::optional<Grid> grid = grid_of(all, cells);
  if (!grid) return BadCells{};
  return Sights(all, *grid, limits).run();
}

}  // namespace rtac::recheck
