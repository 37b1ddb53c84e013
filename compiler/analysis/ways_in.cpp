#include "compiler/analysis/ways_in.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace rtac::analysis {
namespace {

// All in mm. Numbers of the runtime are named after it: retreat.cpp, loiter.cpp, grid_route.cpp.
constexpr double end_reach_mm = 20, loss_mm = 2, connector_loss_mm = 8, loiter_room_mm = 500;
constexpr double resolution_mm = 1;
constexpr int cell_tests_most = 2000;
// How far a way may leave what is allowed: by the 10 mm that a hold strays, which the look-ahead
// has room for, and what offsets round.
constexpr double strays_mm = 12;
// Looked at: so many places, times edges of the zones, at most; and as many places at least.
constexpr double effort = 60'000, places_least = 200, places_most = 3000;

struct P {
  double x = 0, y = 0;
};
P operator+(P a, P b) {
  return {a.x + b.x, a.y + b.y};
}
P operator-(P a, P b) {
  return {a.x - b.x, a.y - b.y};
}
P operator*(double k, P a) {
  return {k * a.x, k * a.y};
}
double norm(P a) {
  return std::hypot(a.x, a.y);
}

struct Segment {
  P a, b;
};
P closest_on(const Segment& s, P p) {
  const P d = s.b - s.a, ap = p - s.a;
  const double length2 = d.x * d.x + d.y * d.y;
  const double t = length2 > 0 ? std::clamp((ap.x * d.x + ap.y * d.y) / length2, 0.0, 1.0) : 0.0;
  return s.a + t * d;
}

// The boundary of a zone, and on which side of it a place lies.
class Outline {
 public:
  explicit Outline(std::vector<Segment> edges) : edges_(std::move(edges)) {}
  static Outline of(const geometry::Region& region) {
    std::vector<Segment> edges;
    for (const geometry::Ring& ring : region.rings()) {
      const auto mm = [](const geometry::Point& p) {
        return P{1000 * p.x.get_d(), 1000 * p.y.get_d()};
      };
      for (std::size_t i = 0; i < ring.size(); ++i) {
        edges.push_back({mm(ring[i]), mm(ring[(i + 1) % ring.size()])});
      }
    }
    return Outline(std::move(edges));
  }
  static Outline of(const ir::ZoneTable& zone) {
    std::vector<Segment> edges;
    for (const ir::Edge& e : zone.edges) {
      edges.push_back({{double(e.ax), double(e.ay)}, {double(e.bx), double(e.by)}});
    }
    return Outline(std::move(edges));
  }

  [[nodiscard]] const std::vector<Segment>& edges() const { return edges_; }
  [[nodiscard]] bool contains(P p) const {
    bool inside = false;
    for (const auto& [a, b] : edges_) {
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
  }
  [[nodiscard]] P nearest(P p) const {
    P best = p;
    double least = std::numeric_limits<double>::infinity();
    for (const Segment& e : edges_) {
      const P q = closest_on(e, p);
      if (const double away = norm(q - p); away < least) {
        least = away;
        best = q;
      }
    }
    return best;
  }
  [[nodiscard]] double clearance(P p) const {
    const double away = norm(nearest(p) - p);
    return contains(p) ? away : -away;
  }
  // Clearance changes no faster than the place.
  [[nodiscard]] bool keeps(P a, P b, double least) const {
    const P middle = 0.5 * (a + b);
    const double half = norm(b - a) / 2, here = clearance(middle);
    if (here < least) return false;
    if (here - half >= least || half <= resolution_mm) return true;
    return keeps(a, middle, least) && keeps(middle, b, least);
  }
  // Where a segment is farthest outside, and how far; none: it stays within, give or take what a
  // hold strays.
  struct Outside {
    P at;
    double deep;
  };
  [[nodiscard]] std::optional<Outside> left_on(P a, P b) const {
    std::vector<double> cuts = {0, 1};
    const P d = b - a;
    for (const auto& [c, e] : edges_) {
      const P f = e - c, ac = c - a;
      const double cross = d.x * f.y - d.y * f.x;
      if (cross == 0) continue;
      const double t = (ac.x * f.y - ac.y * f.x) / cross, s = (ac.x * d.y - ac.y * d.x) / cross;
      if (t > 0 && t < 1 && s >= 0 && s <= 1) cuts.push_back(t);
    }
    std::sort(cuts.begin(), cuts.end());
    std::optional<Outside> found;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      constexpr int looks = 4;
      for (int k = 1; k < looks; ++k) {
        const P at = a + (cuts[i] + (cuts[i + 1] - cuts[i]) * k / looks) * d;
        const double deep = -clearance(at);
        if (deep > (found ? found->deep : strays_mm)) found = {at, deep};
      }
    }
    return found;
  }

 private:
  std::vector<Segment> edges_;
};

// The ways of the runtime from a place outside of the zone of a recovery.
class Entry {
 public:
  Entry(const ir::Module& module, const ir::Decision& decision, const ir::Recovery& step)
      : decision_(decision),
        step_(step),
        zone_(Outline::of(module[step.zone])),
        cells_(module[step.zone].cells) {
    if (step.kind != ir::RecoveryKind::route) return;
    for (const ir::SiteTable::Place& place : module[step.site].places) {
      ways_.push_back(ways_to({double(place.x_mm), double(place.y_mm)}));
    }
  }

  [[nodiscard]] const Outline& zone() const { return zone_; }
  // The ends of the first legs that it may take.
  [[nodiscard]] std::vector<P> aims(P p) const {
    if (step_.kind == ir::RecoveryKind::route) return towards_sites(p);
    if (step_.kind == ir::RecoveryKind::yield) return joins(p);
    return inwards(p);
  }

 private:
  using Accept = std::function<bool(std::size_t)>;

  [[nodiscard]] P centre(std::size_t cell) const {
    const auto columns = static_cast<std::size_t>(cells_.columns);
    const std::size_t column = cell % columns, row = cell / columns;
    return {cells_.origin_x_mm + (double(column) + 0.5) * cells_.cell_mm,
            cells_.origin_y_mm + (double(row) + 0.5) * cells_.cell_mm};
  }
  [[nodiscard]] std::int32_t clear_mm(std::size_t cell) const {
    return cells_.clearance_mm_lo[cell];
  }

  // RetreatManoeuvre::look: straight in through the nearest place of the boundary, or to the
  // nearest cell in sight. Where others stand in the way, any of them.
  [[nodiscard]] std::vector<P> inwards(P p) const {
    const double now = zone_.clearance(p), error = double(decision_.body.position_error_mm);
    const double slack = std::max(end_reach_mm, error) + error;
    const double back = double(step_.return_clearance_mm);
    std::vector<double> wishes = {back + slack, back, double(step_.route_clearance_mm),
                                  double(decision_.body.radius_mm) + slack};
    if (step_.kind == ir::RecoveryKind::loiter) {
      wishes.insert(wishes.begin(), back + slack + loiter_room_mm);
    }
    std::vector<P> all;
    for (const double wanted : wishes) {
      if (const auto q = straight_in(p, wanted)) all.push_back(*q);
      if (!all.empty() && decision_.robots < 2) return all;
      const auto cell = nearest_cell(p, [&](std::size_t at) {
        return clear_mm(at) >= wanted && zone_.keeps(p, centre(at), now - loss_mm);
      });
      if (cell) all.push_back(centre(*cell));
      if (!all.empty() && decision_.robots < 2) return all;
    }
    return all;
  }
  [[nodiscard]] std::optional<P> straight_in(P p, double wanted) const {
    const P border = zone_.nearest(p);
    const double away = norm(p - border);
    if (away < 1e-3) return std::nullopt;
    const P q = border + (wanted / away) * (border - p);
    if (zone_.clearance(q) < wanted - 1e-3) return std::nullopt;
    return q;
  }

  // GridRoute::open_starts: the cells within reach that join, or else the nearest one.
  [[nodiscard]] std::vector<P> joins(P p) const {
    std::vector<P> all;
    for (const std::size_t cell : joined(p)) all.push_back(centre(cell));
    return all;
  }
  [[nodiscard]] std::vector<std::size_t> joined(P p) const {
    const double route = double(step_.route_clearance_mm), size = cells_.cell_mm;
    const double floor = std::min(zone_.clearance(p), route) - connector_loss_mm;
    const Accept joins = [&](std::size_t at) {
      return clear_mm(at) >= route && zone_.keeps(p, centre(at), floor);
    };
    const double reach = std::max(400.0, 2 * size) + 0.8 * size;
    std::vector<std::size_t> all;
    const double x = std::floor((p.x - cells_.origin_x_mm) / size);
    const double y = std::floor((p.y - cells_.origin_y_mm) / size);
    const bool on_grid = x >= 0 && y >= 0 && x < cells_.columns && y < cells_.rows;
    const int steps = static_cast<int>(std::ceil(reach / size));
    for (int dy = -steps; on_grid && dy <= steps; ++dy) {
      for (int dx = -steps; dx <= steps; ++dx) {
        const auto cell = cell_at(static_cast<int>(x) + dx, static_cast<int>(y) + dy);
        if (cell && norm(centre(*cell) - p) <= reach && joins(*cell)) all.push_back(*cell);
      }
    }
    if (!all.empty()) return all;
    if (const auto nearest = nearest_cell(p, joins)) all.push_back(*nearest);
    return all;
  }
  [[nodiscard]] std::optional<std::size_t> cell_at(int column, int row) const {
    if (column < 0 || row < 0 || column >= cells_.columns || row >= cells_.rows) {
      return std::nullopt;
    }
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_.columns) +
           static_cast<std::size_t>(column);
  }

  // GridRoute::nearest_cell: ring by ring.
  [[nodiscard]] std::optional<std::size_t> nearest_cell(P p, const Accept& accept) const {
    const double size = cells_.cell_mm;
    const auto clamped = [&](double x, double origin, int count) {
      return static_cast<int>(std::clamp(std::floor((x - origin) / size), 0.0, count - 1.0));
    };
    const int column = clamped(p.x, cells_.origin_x_mm, cells_.columns);
    const int row = clamped(p.y, cells_.origin_y_mm, cells_.rows);
    double least = std::numeric_limits<double>::infinity();
    std::optional<std::size_t> best;
    int tests_left = cell_tests_most;
    const auto visit = [&](int x, int y) {
      const auto cell = cell_at(x, y);
      if (!cell || tests_left == 0 || clear_mm(*cell) < 0) return;
      const double away = norm(centre(*cell) - p);
      if (away >= least) return;
      --tests_left;
      if (!accept(*cell)) return;
      least = away;
      best = cell;
    };
    for (int ring = 0; ring <= std::max(cells_.columns, cells_.rows); ++ring) {
      if ((ring - 0.5) * size > least) break;
      for (int x = column - ring; x <= column + ring; ++x) {
        const bool side = std::abs(x - column) == ring;
        for (int y = row - ring; y <= row + ring; y += side || ring == 0 ? 1 : 2 * ring) {
          visit(x, y);
        }
      }
    }
    return best;
  }

  // Of the cells that join, the one with the shortest way: of each robot to its own site.
  [[nodiscard]] std::vector<P> towards_sites(P p) const {
    const std::vector<std::size_t> starts = joined(p);
    std::vector<P> all;
    for (const std::vector<double>& way : ways_) {
      double least = std::numeric_limits<double>::infinity();
      std::optional<P> best;
      for (const std::size_t cell : starts) {
        const double length = norm(centre(cell) - p) + way[cell];
        if (length >= least) continue;
        least = length;
        best = centre(cell);
      }
      // to a site that nothing leads to (5012) it joins its zone all the same
      if (!best && !starts.empty()) best = centre(starts.front());
      if (best) all.push_back(*best);
    }
    return all;
  }
  // From every cell that is clear enough, over its eight neighbours.
  [[nodiscard]] std::vector<double> ways_to(P goal) const {
    const auto clear = [&](std::optional<std::size_t> at) {
      return at && clear_mm(*at) >= std::max<std::int64_t>(step_.route_clearance_mm, 0);
    };
    std::vector<double> length(cells_.clearance_mm_lo.size(),
                               std::numeric_limits<double>::infinity());
    using Open = std::pair<double, std::size_t>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    const auto first = nearest_cell(goal, [&](std::size_t at) { return clear(std::optional(at)); });
    if (!first) return length;
    length[*first] = 0;
    open.emplace(0.0, *first);
    while (!open.empty()) {
      const auto [so_far, at] = open.top();
      open.pop();
      if (so_far > length[at]) continue;
      const int column = static_cast<int>(at % static_cast<std::size_t>(cells_.columns));
      const int row = static_cast<int>(at / static_cast<std::size_t>(cells_.columns));
      for (int i = 0; i < 9; ++i) {
        const int x = column + i % 3 - 1, y = row + i / 3 - 1;
        if (!clear(cell_at(x, y)) || !clear(cell_at(x, row)) || !clear(cell_at(column, y)))
          continue;
        const std::size_t to = *cell_at(x, y);
        const double way = so_far + norm(centre(to) - centre(at));
        if (way >= length[to]) continue;
        length[to] = way;
        open.emplace(way, to);
      }
    }
    return length;
  }

  const ir::Decision& decision_;
  const ir::Recovery& step_;
  Outline zone_;
  const ir::Cells& cells_;
  std::vector<std::vector<double>> ways_;  // by robot
};

// Half of them along the boundary, half on a grid.
std::vector<P> places_of(const Outline& from, std::size_t edges) {
  const double most = std::clamp(effort / double(edges), places_least, places_most);
  std::vector<P> all;
  double length = 0;
  P low{1e18, 1e18}, high{-1e18, -1e18};
  for (const auto& [a, b] : from.edges()) {
    length += norm(b - a);
    low = {std::min(low.x, a.x), std::min(low.y, a.y)};
    high = {std::max(high.x, a.x), std::max(high.y, a.y)};
  }
  for (const auto& [a, b] : from.edges()) {
    const double parts = std::ceil(norm(b - a) * most / 2 / length);
    for (double i = 0; i < parts; ++i) all.push_back(a + (i / parts) * (b - a));
  }
  const double step = std::sqrt((high.x - low.x) * (high.y - low.y) * 2 / most) + 1;
  for (double x = low.x + step / 2; x < high.x; x += step) {
    for (double y = low.y + step / 2; y < high.y; y += step) {
      if (from.contains({x, y})) all.push_back({x, y});
    }
  }
  return all;
}
PlaceMm rounded(P p) {
  return {std::llround(p.x), std::llround(p.y)};
}

}  // namespace

WaysIn ways_in(const ir::Module& module, const ir::Decision& decision, const ir::Recovery& step,
               const geometry::Region& from, const geometry::Region& allowed) {
  const Entry entry(module, decision, step);
  const Outline may_start = Outline::of(from), may_be = Outline::of(allowed);
  const std::size_t edges = entry.zone().edges().size() + may_be.edges().size();
  WaysIn found;
  double deepest = 0;
  for (const P p : places_of(may_start, edges)) {
    if (entry.zone().clearance(p) > -loss_mm) continue;  // on its boundary: as good as inside
    const std::vector<P> aims = entry.aims(p);
    for (const P q : aims) {
      const auto left = may_be.left_on(p, q);
      if (!left || left->deep <= deepest) continue;
      deepest = left->deep;
      found.leaves = {rounded(p), rounded(left->at)};
    }
    const bool given_back =
        may_be.clearance(p) + double(decision.body.radius_mm) >= double(step.return_clearance_mm);
    if (!aims.empty() || given_back || found.stranded) continue;
    if (step.kind != ir::RecoveryKind::yield) found.stranded = rounded(p);
  }
  return found;
}

std::optional<WaysIn::Leaves> straight_across(const ir::Module& module, const ir::Recovery& step,
                                              const geometry::Region& from,
                                              const geometry::Region& allowed) {
  const Outline may_start = Outline::of(from), may_be = Outline::of(allowed);
  std::optional<WaysIn::Leaves> found;
  double deepest = 0;
  for (const P p : places_of(may_start, may_start.edges().size() + may_be.edges().size())) {
    for (const ir::SiteTable::Place& site : module[step.site].places) {
      const auto left = may_be.left_on(p, {double(site.x_mm), double(site.y_mm)});
      if (!left || left->deep <= deepest) continue;
      deepest = left->deep;
      found = {rounded(p), rounded(left->at)};
    }
  }
  return found;
}

}  // namespace rtac::analysis
