#include "compiler/analysis/ways_in.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "compiler/analysis/outline.h"

namespace rtac::analysis {
namespace {

// All in mm. Numbers of the runtime are named after it: retreat.cpp, loiter.cpp, grid_route.cpp.
constexpr double loss_mm = 2, connector_loss_mm = 8, loiter_room_mm = 500;
constexpr double resolution_mm = 1;
constexpr int cell_tests_most = 2000;
// How far a way may leave what is allowed: by the 10 mm that a hold strays, which the look-ahead
// has room for, and what offsets round.
constexpr double strays_mm = 12;
// Looked at: so many places, times edges of the zones, at most; and as many places at least.
constexpr double effort = 60'000, places_least = 200, places_most = 3000;
// Ways out that are told of start so far apart: nearer ones show the same.
constexpr double apart_mm = 300;

using outline::norm;
using outline::Outline;
using outline::P;

// The ways of the runtime from a place outside of the zone of a recovery, or within.
class RuntimeWays {
 public:
  RuntimeWays(const ir::Module& module, const ir::Decision& decision, const ir::Recovery& step,
              std::int64_t run_out_mm = 0)
      : decision_(decision),
        step_(step),
        run_out_mm_(double(run_out_mm)),
        zone_(Outline::of(module[step.zone])),
        cells_(module[step.zone].cells) {
    if (step.kind == ir::RecoveryKind::route) {
      for (const ir::SiteTable::Place& place : module[step.site].places) {
        ways_.push_back(ways_to({double(place.x_mm), double(place.y_mm)}));
      }
    }
  }

  [[nodiscard]] const Outline& zone() const { return zone_; }
  // The ends of the first legs that it may take.
  [[nodiscard]] std::vector<P> aims(P p) const {
    if (step_.kind == ir::RecoveryKind::route) return towards_sites(p);
    if (step_.kind == ir::RecoveryKind::yield) return joins(p);
    return inwards(p);
  }
  // The places that ways lead over from one in the zone, where control is not given back: each of
  // them begins with a leg to the first of these. Others that stand in the way are not known here.
  [[nodiscard]] std::vector<std::vector<P>> ways(P p) const {
    std::vector<std::vector<P>> all;
    if (step_.kind == ir::RecoveryKind::route) {
      const std::vector<P> firsts = towards_sites(p);
      for (std::size_t i = 0; i < firsts.size() && i < ways_.size(); ++i) {
        all.push_back(followed(ways_[i], firsts[i]));
      }
      return all;
    }
    const double now = zone_.clearance(p), error = double(decision_.body.position_error_mm);
    const double reach = double(decision_.body.end_reach_mm);
    const double wanted = double(step_.return_clearance_mm) + reach + error;
    if (now >= double(step_.return_clearance_mm)) return all;
    if (const auto q = straight_in(p, wanted)) return {run_out({*q}, p)};
    const auto deep = [&](std::size_t at) {
      return double(clear_mm(at)) >= wanted && zone_.keeps(p, centre(at), now - loss_mm);
    };
    const auto cell = nearest_cell(p, &RuntimeWays::holds_body, deep, 2 * wanted);
    if (cell) return {run_out({centre(*cell)}, p)};
    const std::vector<std::size_t> starts = joined(p);
    if (deep_.empty()) {
      deep_ = ways_over([&](std::size_t at) { return double(clear_mm(at)) >= wanted; });
    }
    if (!starts.empty()) all.push_back(run_out(followed(deep_, centre(starts.front())), p));
    return all;
  }

 private:
  // RetreatManoeuvre::run_out: where there is room the last leg goes on.
  [[nodiscard]] std::vector<P> run_out(std::vector<P> way, P from) const {
    const P end = way.back(), before = way.size() > 1 ? way[way.size() - 2] : from;
    const double leg = norm(end - before);
    if (leg < resolution_mm) return way;
    const P beyond = end + (run_out_mm_ / leg) * (end - before);
    if (zone_.keeps(end, beyond, zone_.clearance(end) - loss_mm)) way.back() = beyond;
    return way;
  }

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
    const double slack = double(decision_.body.end_reach_mm) + error;
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
      const auto cell = nearest_cell(p, &RuntimeWays::holds_body, [&](std::size_t at) {
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
    const double inward = zone_.contains(p) ? -1 : 1;
    const P q = border + (inward * wanted / away) * (border - p);
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
    const auto joins = [&](std::size_t at) {
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
    if (const auto nearest = nearest_cell(p, &RuntimeWays::is_way, joins)) all.push_back(*nearest);
    return all;
  }
  [[nodiscard]] std::optional<std::size_t> cell_at(int column, int row) const {
    if (column < 0 || row < 0 || column >= cells_.columns || row >= cells_.rows) {
      return std::nullopt;
    }
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_.columns) +
           static_cast<std::size_t>(column);
  }

  [[nodiscard]] bool holds_body(std::size_t at) const { return clear_mm(at) >= 0; }
  [[nodiscard]] bool is_way(std::size_t at) const { return on_way(at); }
  static bool any(std::size_t) { return true; }
  // GridRoute::nearest_cell: ring by ring; `accept` is asked of so many cells that `may`, and are
  // nearer than `most_mm`.
  using May = bool (RuntimeWays::*)(std::size_t) const;
  template <class Accept>
  [[nodiscard]] std::optional<std::size_t> nearest_cell(
      P p, May may, const Accept& accept,
      double most_mm = std::numeric_limits<double>::infinity()) const {
    const double size = cells_.cell_mm;
    const auto clamped = [&](double x, double origin, int count) {
      return static_cast<int>(std::clamp(std::floor((x - origin) / size), 0.0, count - 1.0));
    };
    const int column = clamped(p.x, cells_.origin_x_mm, cells_.columns);
    const int row = clamped(p.y, cells_.origin_y_mm, cells_.rows);
    double least_squared = most_mm * most_mm;
    std::optional<std::size_t> best;
    int tests_left = cell_tests_most;
    const auto visit = [&](int x, int y) {
      const auto cell = cell_at(x, y);
      if (!cell || tests_left == 0 || !(this->*may)(*cell)) return;
      const P way = centre(*cell) - p;
      const double squared = way.x * way.x + way.y * way.y;
      if (squared >= least_squared) return;
      --tests_left;
      if (!accept(*cell)) return;
      least_squared = squared;
      best = cell;
    };
    const int last_column = cells_.columns - 1, last_row = cells_.rows - 1;
    for (int ring = 0; ring <= std::max(last_column, last_row) + 1; ++ring) {
      const double away = std::max(ring - 0.5, 0.0) * size;
      if (away * away > least_squared || tests_left == 0) break;
      for (int x = std::max(0, column - ring); x <= std::min(last_column, column + ring); ++x) {
        if (std::abs(x - column) < ring) {
          visit(x, row - ring);
          visit(x, row + ring);
          continue;
        }
        const int up_to = std::min(last_row, row + ring);
        for (int y = std::max(0, row - ring); y <= up_to; ++y) visit(x, y);
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
  [[nodiscard]] std::vector<double> ways_to(P goal) const {
    const auto first = nearest_cell(goal, &RuntimeWays::is_way, any);
    return ways_over([&](std::size_t at) { return at == first; });
  }
  [[nodiscard]] bool on_way(std::optional<std::size_t> at) const {
    return at && clear_mm(*at) >= std::max<std::int64_t>(step_.route_clearance_mm, 0);
  }
  // To a goal from every cell that is clear enough, over its eight neighbours.
  template <class IsGoal>
  [[nodiscard]] std::vector<double> ways_over(const IsGoal& is_goal) const {
    std::vector<double> length(cells_.clearance_mm_lo.size(),
                               std::numeric_limits<double>::infinity());
    using Open = std::pair<double, std::size_t>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    for (std::size_t at = 0; at < length.size(); ++at) {
      if (!on_way(at) || !is_goal(at)) continue;
      length[at] = 0;
      open.emplace(0.0, at);
    }
    while (!open.empty()) {
      const auto [so_far, at] = open.top();
      open.pop();
      if (so_far > length[at]) continue;
      for (const std::size_t to : beside(at)) {
        const double way = so_far + norm(centre(to) - centre(at));
        if (way >= length[to]) continue;
        length[to] = way;
        open.emplace(way, to);
      }
    }
    return length;
  }
  [[nodiscard]] std::vector<std::size_t> beside(std::size_t at) const {
    const int column = static_cast<int>(at % static_cast<std::size_t>(cells_.columns));
    const int row = static_cast<int>(at / static_cast<std::size_t>(cells_.columns));
    std::vector<std::size_t> all;
    for (int i = 0; i < 9; ++i) {
      const int x = column + i % 3 - 1, y = row + i / 3 - 1;
      if (!on_way(cell_at(x, y)) || !on_way(cell_at(x, row)) || !on_way(cell_at(column, y))) {
        continue;
      }
      all.push_back(*cell_at(x, y));
    }
    return all;
  }
  // Downwards over lengths that `ways_over` has found.
  [[nodiscard]] std::vector<P> followed(const std::vector<double>& length, P first) const {
    std::vector<P> way{first};
    const auto start = nearest_cell(first, &RuntimeWays::holds_body, any);
    for (std::optional<std::size_t> at = start; at && length[*at] > 0;) {
      std::optional<std::size_t> next;
      for (const std::size_t to : beside(*at)) {
        if (length[to] < length[next.value_or(*at)]) next = to;
      }
      at = next;
      if (at) way.push_back(centre(*at));
    }
    return way;
  }

  const ir::Decision& decision_;
  const ir::Recovery& step_;
  const double run_out_mm_;
  Outline zone_;
  const ir::Cells& cells_;
  std::vector<std::vector<double>> ways_;  // by robot
  mutable std::vector<double> deep_;       // to where control is given back; once asked for
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
  const RuntimeWays entry(module, decision, step);
  const Outline may_start = Outline::of(from), may_be = Outline::of(allowed);
  const std::size_t edges = entry.zone().edges().size() + may_be.edges().size();
  WaysIn found;
  double deepest = 0;
  for (const P p : places_of(may_start, edges)) {
    if (entry.zone().clearance(p) > -loss_mm) continue;  // on its boundary: as good as inside
    const std::vector<P> aims = entry.aims(p);
    // a parameter that has become stricter leaves it outside: then the way must lead no farther out
    const double out_mm = std::max(-may_be.clearance(p), 0.0);
    for (const P q : aims) {
      const auto left = may_be.left_on(p, q, out_mm + strays_mm);
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

std::vector<WaysIn::Leaves> ways_out(const ir::Module& module, const ir::Decision& decision,
                                     const ir::Recovery& step, std::int64_t run_out_mm,
                                     const geometry::Region& from, const geometry::Region& allowed,
                                     std::size_t most) {
  const RuntimeWays entry(module, decision, step, run_out_mm);
  const Outline may_start = Outline::of(from), may_be = Outline::of(allowed);
  using Way = std::pair<double, WaysIn::Leaves>;
  std::vector<Way> all;
  for (const P p : places_of(may_start, entry.zone().edges().size() + may_be.edges().size())) {
    if (entry.zone().clearance(p) < 0) continue;
    for (const std::vector<P>& way : entry.ways(p)) {
      std::optional<Outline::Outside> deepest;
      P before = p;
      for (const P next : way) {
        const auto left = may_be.left_on(before, next, deepest ? deepest->deep : strays_mm);
        if (left) deepest = left;
        before = next;
      }
      if (deepest) all.push_back({deepest->deep, {rounded(p), rounded(deepest->at)}});
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Way& a, const Way& b) { return a.first > b.first; });
  std::vector<WaysIn::Leaves> found;
  for (const auto& [deep, way] : all) {
    const auto near = [&way = way](const WaysIn::Leaves& other) {
      return std::hypot(double(other.from.x_mm - way.from.x_mm),
                        double(other.from.y_mm - way.from.y_mm)) < apart_mm;
    };
    if (std::none_of(found.begin(), found.end(), near)) found.push_back(way);
    if (found.size() == most) break;
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
      const auto left = may_be.left_on(p, {double(site.x_mm), double(site.y_mm)}, strays_mm);
      if (!left || left->deep <= deepest) continue;
      deepest = left->deep;
      found = {rounded(p), rounded(left->at)};
    }
  }
  return found;
}

}  // namespace rtac::analysis
