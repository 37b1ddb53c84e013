#include "rtac/safe/grid_route.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "rtac/sample.h"

namespace rtac::safe {
namespace {

constexpr double m_per_mm = 1e-3;
// Clearance that a connector may lose: less than the 10 mm by which a hold may stray, which every
// look-ahead has room for. The compiler's connectors rely on 7 mm of it.
constexpr double connector_loss_m = 8e-3;
// A way joins the grid at any cell with its centre within this: the compiler's connectors, between
// centres 0.4 m or two cells, and half a diagonal. What the compiler says of the length of a way
// rests on it.
double connector_reach_m(double cell_m) {
  return std::max(0.4, 2 * cell_m) + 0.8 * cell_m;
}
// Bounds the effort of looking for a cell in sight: a disc of about 2.5 m with 10 cm cells.
constexpr int max_cell_tests = 2000;
constexpr float unreached = std::numeric_limits<float>::infinity();

// What a cell is asked. `may` reads a table, and is asked of every cell; `does` looks along a leg,
// and is asked of `max_cell_tests` at most: of those alone that may.
template <class May, class Does>
struct CellTest {
  May may;
  Does does;
};
template <class May, class Does>
CellTest(May, Does) -> CellTest<May, Does>;

}  // namespace

struct GridRoute::Goal {
  const PlaceTest* test = nullptr;  // null: the cell `cell`
  int cell = -1;
  Vec2 point;
};

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double length2 = dot(d, d);
  const double t = length2 > 0 ? std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : 0.0;
  return norm(p - (a + t * d));
}

GridRoute::GridRoute(const ZoneView& zone) : zone_(zone) {
  const auto cells = static_cast<std::size_t>(std::max(0, zone.columns)) *
                     static_cast<std::size_t>(std::max(0, zone.rows));
  if (cells > max_cells || zone.clearance_mm_lo == nullptr || zone.cell_mm <= 0) return;
  cost_.resize(cells);
  rank_.resize(cells);
  parent_.resize(cells);
  heap_.resize(cells);
  place_in_heap_.resize(cells);
}

int GridRoute::cell_of(Vec2 p) const {
  if (cost_.empty() || !std::isfinite(p.x) || !std::isfinite(p.y)) return -1;
  // 0.6 m / 0.1 m is a hair below 6: a point between two cells belongs to the eastern and northern
  constexpr double hair_mm = 1e-6;
  const double column = std::floor((p.x / m_per_mm - zone_.origin_x_mm + hair_mm) / zone_.cell_mm);
  const double row = std::floor((p.y / m_per_mm - zone_.origin_y_mm + hair_mm) / zone_.cell_mm);
  if (column < 0 || row < 0 || column >= zone_.columns || row >= zone_.rows) return -1;
  return static_cast<int>(row) * zone_.columns + static_cast<int>(column);
}

Vec2 GridRoute::centre(int cell) const {
  const int column = cell % zone_.columns, row = cell / zone_.columns;
  return {(zone_.origin_x_mm + (column + 0.5) * zone_.cell_mm) * m_per_mm,
          (zone_.origin_y_mm + (row + 0.5) * zone_.cell_mm) * m_per_mm};
}

bool GridRoute::admissible(int cell, double clearance_m) const {
  constexpr double hair_mm = 1e-6;  // a limit of 0.263 m is no exact double: 263 mm are enough
  const std::int32_t clearance_mm = zone_.clearance_mm_lo[cell];
  return clearance_mm >= 0 && clearance_mm + hair_mm >= 1000 * clearance_m;
}

bool GridRoute::leg_allowed(const RouteQuery& query, Vec2 a, Vec2 b) const {
  for (const Circle& circle : query.avoid) {
    if (distance_to_segment(circle.centre, a, b) >= circle.radius_m) continue;
    const bool leaving = norm(query.start - circle.centre) < circle.radius_m &&
                         norm(a - circle.centre) < circle.radius_m && recedes(a, b, circle.centre);
    if (!leaving) return false;
  }
  for (const Vec2 from : query.recede_from) {
    if (!recedes(a, b, from)) return false;
  }
  return true;
}

// Every cell that the segment touches is admissible: the rows are taken per column, a hair wider
// than exact arithmetic would, so that rounding never skips a cell.
bool GridRoute::straight(const RouteQuery& query, Vec2 a, Vec2 b) const {
  constexpr double hair = 1e-9;
  const double size = zone_.cell_mm * m_per_mm;
  const auto in_cells = [&](Vec2 p) {
    return Vec2{(p.x - zone_.origin_x_mm * m_per_mm) / size,
                (p.y - zone_.origin_y_mm * m_per_mm) / size};
  };
  Vec2 p = in_cells(a), q = in_cells(b);
  if (p.x > q.x) std::swap(p, q);
  const auto first = static_cast<int>(std::floor(p.x - hair));
  const auto last = static_cast<int>(std::floor(q.x + hair));
  for (int column = first; column <= last; ++column) {
    double y0 = p.y, y1 = q.y;
    if (q.x - p.x > hair) {
      const double slope = (q.y - p.y) / (q.x - p.x);
      y0 = p.y + slope * (std::clamp<double>(column, p.x, q.x) - p.x);
      y1 = p.y + slope * (std::clamp<double>(column + 1, p.x, q.x) - p.x);
    }
    const auto low = static_cast<int>(std::floor(std::min(y0, y1) - hair));
    const auto high = static_cast<int>(std::floor(std::max(y0, y1) + hair));
    for (int row = low; row <= high; ++row) {
      if (column < 0 || row < 0 || column >= zone_.columns || row >= zone_.rows) return false;
      if (!admissible(row * zone_.columns + column, query.clearance_m)) return false;
    }
  }
  return leg_allowed(query, a, b);
}

// The nearest cell centre that `accept` (a CellTest) allows, ring by ring around the cell of `p`
// (or around the point of the grid nearest to it), so that the costly test is asked near cells
// first. -1: none within the bounded number of tests.
template <class Accept>
int GridRoute::nearest_cell(Vec2 p, const Accept& accept) const {
  if (cost_.empty() || !is_finite(p)) return -1;
  const double size = zone_.cell_mm * m_per_mm;
  const auto clamped = [&](double x, double origin_mm, int count) {
    const double cell = std::floor((x - origin_mm * m_per_mm) / size);
    return static_cast<int>(std::clamp<double>(cell, 0, count - 1));
  };
  const int column = clamped(p.x, zone_.origin_x_mm, zone_.columns);
  const int row = clamped(p.y, zone_.origin_y_mm, zone_.rows);
  double best_m = std::numeric_limits<double>::infinity();
  int best = -1, tests_left = max_cell_tests;
  const auto visit = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= zone_.columns || y >= zone_.rows || tests_left == 0) return;
    const int cell = y * zone_.columns + x;
    const double distance_m = norm(centre(cell) - p);
    if (distance_m >= best_m || !accept.may(cell)) return;
    --tests_left;
    if (!accept.does(cell)) return;
    best_m = distance_m;
    best = cell;
  };
  for (int ring = 0; ring <= std::max(zone_.columns, zone_.rows); ++ring) {
    if ((ring - 0.5) * size > best_m) break;  // no centre of this ring is nearer
    for (int x = column - ring; x <= column + ring; ++x) {
      const bool side = std::abs(x - column) == ring;
      for (int y = row - ring; y <= row + ring; y += side || ring == 0 ? 1 : 2 * ring) visit(x, y);
    }
  }
  return best;
}

// A point that leaves (or reaches) the grid at this cell does so straight, and without coming
// closer to the boundary than it already is.
bool GridRoute::joins(const RouteQuery& query, Vec2 p, int cell, bool leaving) const {
  if (!admissible(cell, query.clearance_m)) return false;
  const Vec2 c = centre(cell);
  if (!(leaving ? leg_allowed(query, p, c) : leg_allowed(query, c, p))) return false;
  if (cell == cell_of(p)) return true;
  const double floor_m = std::min(signed_clearance(zone_, p), query.clearance_m);
  return keeps_clearance(zone_, p, c, floor_m - connector_loss_m);
}

// The cell at which a way ends for a goal: the goal's own, or the nearest one that joins.
int GridRoute::landing(const RouteQuery& query, Vec2 goal) const {
  const int own = cell_of(goal);
  if (own >= 0 && joins(query, goal, own, false)) return own;
  return nearest_cell(goal, CellTest{[&](int cell) { return admissible(cell, query.clearance_m); },
                                     [&](int cell) { return joins(query, goal, cell, false); }});
}

// Opens the cell of the start, if a way may begin there.
bool GridRoute::open_own_start(const RouteQuery& query, const Goal& goal) {
  const int own = cell_of(query.start);
  if (own < 0 || !joins(query, query.start, own, true)) return false;
  open(goal, own, -1, norm(centre(own) - query.start));
  return true;
}

// Opens the cells at which a way may begin: all that join within reach, or else the nearest one
// that does. Which of them is best, the search finds out.
void GridRoute::open_starts(const RouteQuery& query, const Goal& goal) {
  const Vec2 p = query.start;
  if (!is_finite(p)) return;
  const auto start_at = [&](int cell) { open(goal, cell, -1, norm(centre(cell) - p)); };
  const int own = cell_of(p);
  const double cell_m = zone_.cell_mm * m_per_mm, reach_m = connector_reach_m(cell_m);
  const int steps = static_cast<int>(std::ceil(reach_m / cell_m));
  if (own >= 0) {
    const int column = own % zone_.columns, row = own / zone_.columns;
    for (int y = std::max(0, row - steps); y <= std::min(zone_.rows - 1, row + steps); ++y) {
      for (int x = std::max(0, column - steps); x <= std::min(zone_.columns - 1, column + steps);
           ++x) {
        const int cell = y * zone_.columns + x;
        if (norm(centre(cell) - p) > reach_m) continue;
        if (joins(query, p, cell, true)) start_at(cell);
      }
    }
  }
  if (heap_size_ > 0) return;
  const int nearest =
      nearest_cell(p, CellTest{[&](int cell) { return admissible(cell, query.clearance_m); },
                               [&](int cell) { return joins(query, p, cell, true); }});
  if (nearest >= 0) start_at(nearest);
}

void GridRoute::sift_up(int at) {
  const auto index = [](int i) { return static_cast<std::size_t>(i); };
  const int cell = heap_[index(at)];
  while (at > 0) {
    const int up = (at - 1) / 2, other = heap_[index(up)];
    if (rank_[index(other)] <= rank_[index(cell)]) break;
    heap_[index(at)] = other;
    place_in_heap_[index(other)] = at;
    at = up;
  }
  heap_[index(at)] = cell;
  place_in_heap_[index(cell)] = at;
}

void GridRoute::sift_down(int at) {
  const auto index = [](int i) { return static_cast<std::size_t>(i); };
  const int cell = heap_[index(at)];
  for (int down = 2 * at + 1; down < heap_size_; down = 2 * at + 1) {
    const auto rank_at = [&](int i) { return rank_[index(heap_[index(i)])]; };
    if (down + 1 < heap_size_ && rank_at(down + 1) < rank_at(down)) ++down;
    if (rank_[index(cell)] <= rank_at(down)) break;
    heap_[index(at)] = heap_[index(down)];
    place_in_heap_[index(heap_[index(at)])] = at;
    at = down;
  }
  heap_[index(at)] = cell;
  place_in_heap_[index(cell)] = at;
}

int GridRoute::pop() {
  const int top = heap_[0];
  --heap_size_;
  if (heap_size_ > 0) {
    heap_[0] = heap_[static_cast<std::size_t>(heap_size_)];
    sift_down(0);
  }
  return top;
}

void GridRoute::relax(const RouteQuery& query, const Goal& goal, int from) {
  const auto index = [](int i) { return static_cast<std::size_t>(i); };
  const int column = from % zone_.columns, row = from / zone_.columns;
  const Vec2 a = centre(from);
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const int x = column + dx, y = row + dy;
      if ((dx == 0 && dy == 0) || x < 0 || y < 0 || x >= zone_.columns || y >= zone_.rows) continue;
      const int to = y * zone_.columns + x;
      if (!admissible(to, query.clearance_m)) continue;
      // A diagonal step touches both neighbours at their common corner.
      if (dx != 0 && dy != 0 &&
          (!admissible(row * zone_.columns + x, query.clearance_m) ||
           !admissible(y * zone_.columns + column, query.clearance_m))) {
        continue;
      }
      const Vec2 b = centre(to);
      const double cost = cost_[index(from)] + norm(b - a);
      if (static_cast<float>(cost) < cost_[index(to)] && leg_allowed(query, a, b)) {
        open(goal, to, from, cost);
      }
    }
  }
}

// Straight distance never overestimates, so the first arrival at the goal is shortest.
void GridRoute::open(const Goal& goal, int cell, int parent, double cost_m) {
  const auto at = static_cast<std::size_t>(cell);
  cost_[at] = static_cast<float>(cost_m);
  parent_[at] = parent;
  const double estimate_m = goal.test == nullptr ? norm(goal.point - centre(cell)) : 0.0;
  rank_[at] = static_cast<float>(cost_m + estimate_m);
  const int place = place_in_heap_[at];
  if (place < 0 || place >= heap_size_ || heap_[static_cast<std::size_t>(place)] != cell) {
    heap_[static_cast<std::size_t>(heap_size_)] = cell;
    place_in_heap_[at] = heap_size_++;
  }
  sift_up(place_in_heap_[at]);
}

void GridRoute::forget() {
  std::fill(cost_.begin(), cost_.end(), unreached);
  std::fill(place_in_heap_.begin(), place_in_heap_.end(), -1);
  heap_size_ = 0;
}

bool GridRoute::begin_and_search(const RouteQuery& query, const Goal& goal, int& last) {
  forget();
  if (open_own_start(query, goal)) {
    if (search(query, goal, last)) return true;
    // beside another robot the middle of its cell may lie on the wrong side
    if (goal.test == nullptr || query.recede_from.empty()) return false;
    forget();
  }
  open_starts(query, goal);
  return search(query, goal, last);
}

bool GridRoute::search(const RouteQuery& query, const Goal& goal, int& last) {
  // Rounding of the costs may re-open a cell; the bound keeps the effort fixed all the same.
  std::size_t visits_left = 4 * cost_.size();
  while (heap_size_ > 0 && visits_left-- > 0) {
    const int cell = pop();
    const double clearance_m = zone_.clearance_mm_lo[cell] * m_per_mm;
    const bool found =
        goal.test == nullptr ? cell == goal.cell : goal.test->accepts(centre(cell), clearance_m);
    if (found) {
      last = cell;
      return true;
    }
    relax(query, goal, cell);
  }
  return false;
}

// Straightens the chain of cells: from each kept point on to the last cell in plain sight. What
// does not fit into a path is measured, but left out: `cut`.
void GridRoute::trace(const RouteQuery& query, int last, const Vec2* end, Path& way) {
  const auto index = [](int i) { return static_cast<std::size_t>(i); };
  int count = 0;
  for (int cell = last; cell >= 0; cell = parent_[index(cell)]) heap_[index(count++)] = cell;
  std::reverse(heap_.begin(), heap_.begin() + count);
  way.points.clear();
  way.index = 0;
  length_m_ = cost_[index(last)];
  if (end != nullptr) length_m_ += norm(*end - centre(last));
  const int total = count + (end != nullptr ? 1 : 0);
  const auto point = [&](int i) { return i < count ? centre(heap_[index(i)]) : *end; };
  Vec2 anchor = query.start;
  way_length_m_ = 0;
  cut_ = query.over_start && !way.points.push(anchor);
  for (int i = 0; i < total; ++i) {
    while (i + 1 < total && straight(query, anchor, point(i + 1))) ++i;
    way_length_m_ += norm(point(i) - anchor);
    anchor = point(i);
    cut_ = !way.points.push(anchor) || cut_;
  }
}

bool GridRoute::to_point(const RouteQuery& query, Vec2 goal, Path& way) {
  if (cost_.empty()) return false;
  const int aim = landing(query, goal);
  int last = -1;
  if (aim < 0 || !begin_and_search(query, {nullptr, aim, centre(aim)}, last)) return false;
  trace(query, last, &goal, way);
  return true;
}

bool GridRoute::to_place(const RouteQuery& query, const PlaceTest& test, Path& way) {
  if (cost_.empty()) return false;
  int last = -1;
  if (!begin_and_search(query, {&test, -1, {}}, last)) return false;
  trace(query, last, nullptr, way);
  return true;
}

bool GridRoute::straight_to_place(const RouteQuery& query, const PlaceTest& test, double floor_m,
                                  Path& way) const {
  const auto holds_body = [&](int at) { return zone_.clearance_mm_lo[at] >= 0; };
  const auto in_sight = [&](int at) {
    const Vec2 c = centre(at);
    return test.accepts(c, zone_.clearance_mm_lo[at] * m_per_mm) &&
           leg_allowed(query, query.start, c) && keeps_clearance(zone_, query.start, c, floor_m);
  };
  const int cell = nearest_cell(query.start, CellTest{holds_body, in_sight});
  way.points.clear();
  way.index = 0;
  return cell >= 0 && way.points.push(centre(cell));
}

}  // namespace rtac::safe
