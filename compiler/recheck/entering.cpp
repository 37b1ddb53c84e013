#include "compiler/recheck/entering.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "compiler/recheck/grid.h"
#include "compiler/recheck/legs.h"

namespace rtac::recheck {
namespace {

// Where a way may end, and the share of it after which it has been found to be farthest off.
struct End {
  Place place;
  double clearance;
  int ring;  // of cells, around the one that the search begins at
  double farthest = 0.5;
};
double turn(Place a, Place b, Place c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class Entries {
 public:
  Entries(const std::vector<Segment>& zone, const Grid& grid, const std::vector<Segment>& fence,
          const EnteringLimits& limits)
      : zone_(zone), grid_(grid), fence_(fence), limits_(limits) {
    for (const geometry::Region& region : limits.starts) {
      const std::vector<Segment> edges = segments_of(region);
      starts_.insert(starts_.end(), edges.begin(), edges.end());
    }
    if (starts_.empty()) return;
    for (const Segment& s : zone_) depth_ = std::min(depth_, between(s, fence_));
    for (const Segment& s : fence_) depth_ = std::min(depth_, between(s, zone_));
  }

  std::variant<std::optional<geometry::Point>, BadCells> run() {
    double left = 1e300, low = 1e300, right = -1e300, top = -1e300;
    const double more = limits_.starts_off;
    for (const Segment& s : starts_.empty() ? fence_ : starts_) {
      left = std::min({left, s.ax, s.bx}), right = std::max({right, s.ax, s.bx});
      low = std::min({low, s.ay, s.by}), top = std::max({top, s.ay, s.by});
    }
    for (double y = low - more; y < top + more; y += square_m) {
      for (double x = left - more; x < right + more; x += square_m) {
        const Box square{x, y, x + square_m, y + square_m};
        if (starts_.empty() ? is_inside(square) : !may_start(square)) continue;
        const std::vector<End> ends = ends_near(middle(square));
        double reach = 0;
        for (const End& e : ends) reach = std::max(reach, apart(e.place, middle(square)));
        const Boundary boundary(
            fence_, middle(square),
            reach + 2 * square_m + std::max(limits_.clearance, limits_.body) + snap_m);
        const bool stays = stays_within(boundary, square, ends, quarters_max);
        if (steps_ > steps_max) return BadCells{};
        if (!stays) return std::optional(geometry::Point{Rational(x), Rational(y)});
      }
    }
    return std::optional<geometry::Point>();
  }

 private:
  static constexpr double square_m = 0.1;
  static constexpr int quarters_max = 9, ways_followed_after = 3, parts = 16;
  static constexpr std::int64_t steps_max = 12'000'000'000;
  // The search tries so many cells, ring by ring; with two rings more for the place that it begins
  // at and for cells that are none in its table.
  static constexpr int tests_max = 2000, more_rings = 3, rings_surely = 18;
  // Of the clearance in the fence so much is forgiven, in all: less than the 10 mm that a hold has
  // room for, and more than a way may lose, for the grids.
  [[nodiscard]] double forgiven() const { return std::max(0.0082, limits_.loss + 0.0018); }

  static double apart(Place a, Place b) { return length(a.x - b.x, a.y - b.y); }
  [[nodiscard]] bool contains(Place p) const {
    bool in = false;
    for (const Segment& s : zone_) {
      if ((s.ay > p.y) == (s.by > p.y)) continue;
      if (p.x < s.ax + (p.y - s.ay) / (s.by - s.ay) * (s.bx - s.ax)) in = !in;
    }
    return in;
  }
  double to_zone(Place p) {
    steps_ += static_cast<std::int64_t>(zone_.size());
    double least = 1e300;
    for (const Segment& s : zone_) least = std::min(least, square_to(s, p.x, p.y));
    return std::sqrt(least);
  }
  // Some body may be in the square.
  [[nodiscard]] bool may_start(const Box& b) const {
    const double within = radius(b) + limits_.starts_off;
    const Place m = middle(b);
    bool in = false;
    for (const Segment& s : starts_) {
      if (square_to(s, m.x, m.y) <= within * within) return true;
      if ((s.ay > m.y) == (s.by > m.y)) continue;
      if (m.x < s.ax + (m.y - s.ay) / (s.by - s.ay) * (s.bx - s.ax)) in = !in;
    }
    return in;
  }
  // From the ends of one segment.
  static double between(const Segment& s, const std::vector<Segment>& others) {
    double square = 1e300;
    for (const Segment& o : others) {
      square = std::min({square, square_to(o, s.ax, s.ay), square_to(o, s.bx, s.by)});
    }
    return std::sqrt(square);
  }
  // A way in the zone loses little of the clearance there, and of that in the fence no more: all of
  // the zone is `depth_` from its boundary.
  bool keeps_what_it_has(const Boundary& boundary, const Box& from) {
    const double nearest = to_zone(middle(from)) - radius(from) - snap_m;
    const double kept = std::min(nearest, limits_.least) - limits_.loss;
    return nearest > 0 && contains(middle(from)) &&
           depth_ + kept >= boundary.asked_from(from, limits_.clearance, forgiven());
  }
  // With what the zone of a robot may be smaller by.
  bool is_inside(const Box& b) {
    return to_zone(middle(b)) > radius(b) + snap_m && contains(middle(b));
  }

  std::vector<End> ends_near(Place p) const {
    const auto cell = [](double at, std::size_t count) {
      return static_cast<int>(std::clamp(std::floor(at), 0.0, double(count) - 1));
    };
    const int columns = static_cast<int>(grid_.columns), rows = static_cast<int>(grid_.rows);
    const int column = cell((p.x - grid_.x) / grid_.cell, grid_.columns);
    const int row = cell((p.y - grid_.y) / grid_.cell, grid_.rows);
    std::vector<End> found;
    int last = std::max(columns, rows), tested = 0;
    for (int off = 0; off <= last; ++off) {
      for (int r = std::max(0, row - off); r <= std::min(rows - 1, row + off); ++r) {
        for (int c = std::max(0, column - off); c <= std::min(columns - 1, column + off); ++c) {
          if (std::max(std::abs(c - column), std::abs(r - row)) != off) continue;
          const double clearance = grid_.clearance[static_cast<std::size_t>(r * columns + c)];
          if (clearance >= limits_.tested + table_m) ++tested;  // surely one of the tables, too
          if (clearance < limits_.least) continue;
          found.push_back(
              {middle(grid_.box(static_cast<std::size_t>(c), static_cast<std::size_t>(r), 1)),
               clearance, off});
        }
      }
      if (tested >= tests_max) last = std::min(last, off + more_rings);
    }
    return found;
  }

  bool stays_within(const Boundary& boundary, const Box& from, const std::vector<End>& ends,
                    int times) {
    if (boundary.holds_nobody(from, limits_.body)) return true;
    const bool done =
        starts_.empty() ? is_inside(from) : !may_start(from) || keeps_what_it_has(boundary, from);
    if (done || steps_ > steps_max) return done;
    // what begins outside goes on in the zone, wherever that is
    if (!starts_.empty() && depth_ + forgiven() < limits_.clearance) {
      return times > 0 && std::ranges::all_of(quarters(from), [&](const Box& quarter) {
               return stays_within(boundary, quarter, ends, times - 1);
             });
    }
    const double off = contains(middle(from)) ? 0 : to_zone(middle(from));
    const double asked = boundary.asked_from(from, limits_.clearance, forgiven());
    const double farthest = limits_.alone ? farthest_taken(from, ends, off) : 1e300;
    std::vector<End> taken, open;
    for (End e : ends) {
      if (apart(e.place, middle(from)) - radius(from) > farthest) continue;
      steps_ += 30;
      const bool stays = boundary.keeps(from, e.place, asked) ||
                         leads_off(from, e, off, times <= quarters_max - ways_followed_after);
      taken.push_back(e);
      if (!stays) open.push_back(e);
    }
    if (open.empty() && to_the_nearest(boundary, from, off, asked)) return true;
    if (times == 0) return false;
    return std::ranges::all_of(quarters(from), [&](const Box& quarter) {
      return stays_within(boundary, quarter, limits_.alone ? taken : open, times - 1);
    });
  }
  // Somewhere on the way it is farther from the zone than it may be, from wherever it begins.
  bool leads_off(const Box& from, End& end, double off, bool closely) {
    const Place m = middle(from);
    const double most = off + 2 * radius(from) + limits_.loss + 0.0001;
    double farthest = 0;
    const auto look = [&](double t) {
      const Place at{m.x + t * (end.place.x - m.x), m.y + t * (end.place.y - m.y)};
      const double way = to_zone(at);
      if (way <= farthest || contains(at)) return;
      end.farthest = t, farthest = way;
    };
    look(end.farthest);
    double low = 0, high = 1;
    for (int round = 0; round < (closely ? 3 : 1) && farthest <= most; ++round) {
      const int count = closely ? parts : parts / 4;
      for (int i = 0; i <= count && farthest <= most; ++i) look(low + (high - low) * i / count);
      const double step = (high - low) / count;
      low = std::max(0.0, end.farthest - step), high = std::min(1.0, end.farthest + step);
    }
    return farthest > most;
  }
  // It takes no cell that is farther off than one to which straight ways in the zone lead from all
  // places of it that may be the nearest one: along its own way there it comes nearer to those.
  double farthest_taken(const Box& from, const std::vector<End>& ends, double off) {
    double nearest = 1e300;
    for (const End& e : ends) {
      const double way = apart(e.place, middle(from)) + radius(from);
      if (e.ring <= rings_surely && e.clearance >= limits_.alone->aim + table_m && way < nearest &&
          in_sight(from, off, e.place)) {
        nearest = way;
      }
    }
    return std::max(nearest, limits_.alone->reach);
  }
  bool in_sight(const Box& from, double off, Place end) {
    steps_ += static_cast<std::int64_t>(zone_.size());
    return std::ranges::all_of(zone_, [&](const Segment& s) {
      const Place m = middle(from);
      if (std::sqrt(square_to(s, m.x, m.y)) > off + 2 * radius(from) + snap_m) return true;
      const auto [a, b] = nearest_of(s, from);
      return is_free(a, b, end);
    });
  }
  // No line of the zone meets the triangle, but for what is near its two first corners.
  bool is_free(Place a, Place b, Place end) {
    constexpr double first = 0.001;
    for (Place* p : {&a, &b}) {
      const double way = apart(*p, end);
      if (way <= first) return false;
      *p = {p->x + first / way * (end.x - p->x), p->y + first / way * (end.y - p->y)};
      if (!contains(*p)) return false;
    }
    steps_ += 2 * static_cast<std::int64_t>(zone_.size());
    const auto meets = [](Place p, Place q, const Segment& s) {
      const Place c{s.ax, s.ay}, d{s.bx, s.by};
      return turn(p, q, c) * turn(p, q, d) <= 0 && turn(c, d, p) * turn(c, d, q) <= 0;
    };
    return std::ranges::none_of(zone_, [&](const Segment& s) {
      const Place c{s.ax, s.ay};
      const double ab = turn(a, b, c), be = turn(b, end, c), ea = turn(end, a, c);
      const bool within = (ab > 0 && be > 0 && ea > 0) || (ab < 0 && be < 0 && ea < 0);
      return within || meets(a, end, s) || meets(b, end, s);
    });
  }
  // The places of a line that are nearest to places of the square lie between these.
  static std::pair<Place, Place> nearest_of(const Segment& s, const Box& from) {
    const Place d{s.bx - s.ax, s.by - s.ay};
    double first = 1, last = 0;
    for (const Place p : corners(from)) {
      const double t = std::clamp(inner({p.x - s.ax, p.y - s.ay}, d) / inner(d, d), 0.0, 1.0);
      first = std::min(first, t), last = std::max(last, t);
    }
    return {{s.ax + first * d.x, s.ay + first * d.y}, {s.ax + last * d.x, s.ay + last * d.y}};
  }
  // To the nearest place of each line that may be nearest: between those of the corners.
  bool to_the_nearest(const Boundary& boundary, const Box& from, double off, double asked) {
    return std::ranges::all_of(zone_, [&](const Segment& s) {
      const Place m = middle(from);
      if (std::sqrt(square_to(s, m.x, m.y)) > off + 2 * radius(from) + snap_m) return true;
      const auto [a, b] = nearest_of(s, from);
      return boundary.keeps(from, a, b, asked);
    });
  }

  const std::vector<Segment>& zone_;
  const Grid& grid_;
  const std::vector<Segment>& fence_;
  const EnteringLimits limits_;
  std::vector<Segment> starts_;
  double depth_ = 1e300;  // of the zone in the fence
  std::int64_t steps_ = 0;
};

}  // namespace

std::variant<std::optional<geometry::Point>, BadCells> enters_beyond(const geometry::Region& zone,
                                                                     const Cells& cells,
                                                                     const geometry::Region& fence,
                                                                     const EnteringLimits& limits) {
  const std::vector<Segment> inner_edges = segments_of(zone), outer_edges = segments_of(fence);
  const std::optional<Grid> grid = grid_of(inner_edges, cells);
  if (!grid) return BadCells{};
  return Entries(inner_edges, *grid, outer_edges, limits).run();
}

}  // namespace rtac::recheck
