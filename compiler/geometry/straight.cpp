#include "compiler/geometry/straight.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/looks.h"

namespace rtac::geometry {
namespace {

// Of the cells that hold places of the zone it tries so many, ring by ring (max_cell_tests).
constexpr int tests_max = 2000;
// Mostly one of the nearest ones is in sight.
constexpr std::size_t enough = 256;
// A cell is cut into four, its quarters again, at most so often.
constexpr int halvings_max = 7;
// Of what the recovery forgives a leg (loss_m of runtime/core/retreat.cpp), 1 mm is to spare.
constexpr double forgiven_mm = 1;
// A goal is so much clearer than is asked for: the recheck finds clearances of cells to 4 mm.
constexpr std::int32_t surely_mm = 6;
// A goal that is taken from lengths is rounded up to millimetres, each of two; the recheck takes it
// for 3 less.
constexpr std::int32_t rounded_mm = 3;
// Of cells that the recheck is sure are tried.
constexpr std::int32_t surely_tried_mm = 4;
// Of places that bodies are seen at: the recheck adds 3 mm to the error.
constexpr std::int32_t seen_rounds_mm = 4;
// It takes for tried what lies within 4 mm of the exact outline, which is 3 mm off these edges.
constexpr double perhaps_tried_mm = 8;
// Of edges; what has not been looked at is not known.
constexpr std::int64_t looks_max = 40'000'000, of_cell_max = 400'000;

// One ring, with its inside to the left of every edge, that turns round once and never to the
// right.
bool is_convex(const std::vector<EdgeRow>& edges) {
  std::int64_t upward = 0;  // edges that begin to lead up
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const EdgeRow &e = edges[i], &next = edges[(i + 1) % edges.size()];
    if (e.b.x_mm != next.a.x_mm || e.b.y_mm != next.a.y_mm) return false;
    const Rational turn = Rational(e.b.x_mm - e.a.x_mm) * Rational(next.b.y_mm - next.a.y_mm) -
                          Rational(e.b.y_mm - e.a.y_mm) * Rational(next.b.x_mm - next.a.x_mm);
    if (turn < 0) return false;
    if (e.b.y_mm <= e.a.y_mm && next.b.y_mm > next.a.y_mm) ++upward;
  }
  return upward == 1;
}

// The cells that an edge passes by so near that the recheck may take them for tried: row by row,
// those beside the part of it that lies beside the row.
void mark_beside(const EdgeRow& edge, const CellGrid& cells, std::vector<bool>& all) {
  const double size = cells.cell_mm, by = perhaps_tried_mm;
  const auto index = [&](double at_mm, std::int32_t origin_mm, std::int32_t count) {
    const double cell = std::floor((at_mm - origin_mm) / size);
    return static_cast<std::size_t>(std::clamp<double>(cell, 0, count - 1));
  };
  const bool up = edge.a.y_mm <= edge.b.y_mm;
  const GridPoint &low = up ? edge.a : edge.b, &top = up ? edge.b : edge.a;
  const double rise = top.y_mm - low.y_mm, run = top.x_mm - low.x_mm;
  const auto x_at = [&](double y_mm, double level) {
    return low.x_mm + run * (rise == 0 ? level : std::clamp((y_mm - low.y_mm) / rise, 0.0, 1.0));
  };
  const std::size_t last = index(top.y_mm + by, cells.origin.y_mm, cells.rows);
  for (std::size_t r = index(low.y_mm - by, cells.origin.y_mm, cells.rows); r <= last; ++r) {
    const double south = cells.origin.y_mm + static_cast<double>(r) * size;
    const double x0 = x_at(south - by, 0), x1 = x_at(south + size + by, 1);
    const std::size_t end = index(std::max(x0, x1) + by, cells.origin.x_mm, cells.columns);
    std::size_t c = index(std::min(x0, x1) - by, cells.origin.x_mm, cells.columns);
    for (; c <= end; ++c) all[r * static_cast<std::size_t>(cells.columns) + c] = true;
  }
}
std::vector<bool> cells_beside(const std::vector<EdgeRow>& edges, const CellGrid& cells) {
  std::vector<bool> all(cells.clearance_mm_lo.size(), false);
  if (all.empty()) return all;
  for (const EdgeRow& edge : edges) mark_beside(edge, cells, all);
  return all;
}

}  // namespace

StraightLegs::StraightLegs(const std::vector<EdgeRow>& edges, const CellGrid& cells,
                           std::int32_t body_mm, std::int32_t goal_mm)
    : cells_(cells),
      goal_mm_(goal_mm),
      clearest_mm_(cells.clearance_mm_lo.empty() ? -1 : std::ranges::max(cells.clearance_mm_lo)),
      convex_(is_convex(edges)),
      beside_(cells_beside(edges, cells)),
      legs_(edges, goal_mm, body_mm, forgiven_mm),
      around_(edges, goal_mm + 2 * cells.cell_mm, body_mm) {}

StraightLegs::StraightLegs(const std::vector<EdgeRow>& edges, const CellGrid& cells,
                           std::int32_t body_mm, std::int32_t goal_mm, const Region& starts,
                           std::int32_t error_mm)
    : StraightLegs(edges, cells, body_mm, goal_mm) {
  starts_.emplace(starts, error_mm + seen_rounds_mm);
}

std::optional<double> StraightLegs::longest_from(std::size_t cell, double most_mm) {
  const auto columns = static_cast<std::size_t>(cells_.columns);
  const auto column = static_cast<std::int32_t>(cell % columns);
  const auto row = static_cast<std::int32_t>(cell / columns);
  const double size = cells_.cell_mm;
  const double west = cells_.origin.x_mm + column * size;
  const double south = cells_.origin.y_mm + row * size;
  if (starts_ && !starts_->are_near(west + size / 2, south + size / 2, size)) return 0;
  const std::vector<End> ends = ends_of(cell, false);
  gave_up_ = !ends.empty() && looks_ > looks_max;
  if (ends.empty() || gave_up_) return std::nullopt;
  // there the clearance along a leg is no less than at the end that has less, and the place that it
  // leads from has less than a goal
  if (convex_ && ends.front().off_mm + size <= most_mm) return ends.front().off_mm + size;
  double reach = 0;
  for (const End& end : ends) reach = std::max(reach, end.off_mm);
  const std::int64_t before = looks();
  looks_end_ = before + of_cell_max;
  (void)legs_.look_around(west, south, size, reach);
  const Connectors::Spot whole = around_.look_around(west, south, size, 0);
  const auto longest = longest_in(whole, ends, most_mm, halvings_max);
  looks_ += looks() - before;
  return longest;
}

bool StraightLegs::needs_none(const Connectors::Spot& spot) const {
  if (around_.holds_nobody(spot) || spot.gap_mm - spot.radius_mm() >= goal_mm_) return true;
  return starts_ && !starts_->are_near(spot.x_mm, spot.y_mm, spot.radius_mm());
}

// The nearest one in sight is taken, and none that is tried is left out for one that is farther.
std::optional<double> StraightLegs::longest_in(const Connectors::Spot& spot, std::vector<End> ends,
                                               double most_mm, int halvings) {
  using Sight = Connectors::Sight;
  if (needs_none(spot)) return 0;
  std::size_t left = 0;
  for (End& end : ends) {
    const double leg =
        std::hypot(end.at.x_mm - spot.x_mm, end.at.y_mm - spot.y_mm) + spot.radius_mm();
    const auto seen = leg <= most_mm ? legs_.sight(spot, end.at, end.refused_by) : Sight::unknown;
    if (seen == Sight::from_all) return leg;
    if (seen == Sight::unknown) ends[left++] = end;
  }
  ends.resize(left);
  if (ends.empty() && !needs_none({spot.x_mm, spot.y_mm, 0, spot.gap_mm})) return std::nullopt;
  if (halvings == 0 || looks() > looks_end_) return std::nullopt;
  double longest = 0;
  for (const Connectors::Spot& part : around_.quarters(spot)) {
    const auto of_part = longest_in(part, ends, most_mm, halvings - 1);
    if (!of_part) return std::nullopt;
    longest = std::max(longest, *of_part);
  }
  return longest;
}

double StraightLegs::farthest_from(std::size_t cell) const {
  double most = 0;
  for (const End& end : ends_of(cell, true)) most = std::max(most, end.off_mm + cells_.cell_mm);
  return most;
}

std::vector<StraightLegs::End> StraightLegs::ends_of(std::size_t cell, bool perhaps) const {
  std::vector<End> found;
  if (clearest_mm_ < least_mm(perhaps)) return found;
  int tested = 0;
  const std::int32_t last = std::max(cells_.columns, cells_.rows);
  for (std::int32_t ring = 0; ring <= last && tested <= tests_max; ++ring) {
    if (!perhaps && found.size() >= enough) break;
    std::vector<End> of_ring;
    tested += add_ring(cell, ring, perhaps, of_ring);
    if (!perhaps && tested > tests_max) break;
    found.insert(found.end(), of_ring.begin(), of_ring.end());
  }
  std::ranges::stable_sort(found, {}, &End::off_mm);
  return found;
}

std::int32_t StraightLegs::least_mm(bool perhaps) const {
  return perhaps ? goal_mm_ - rounded_mm : goal_mm_ + surely_mm;
}

int StraightLegs::add_ring(std::size_t cell, std::int32_t ring, bool perhaps,
                           std::vector<End>& ends) const {
  const auto columns = static_cast<std::size_t>(cells_.columns);
  const auto column = static_cast<std::int32_t>(cell % columns);
  const auto row = static_cast<std::int32_t>(cell / columns);
  const double size = cells_.cell_mm;
  int tested = 0;
  for (std::int32_t r = std::max(0, row - ring); r <= std::min(cells_.rows - 1, row + ring); ++r) {
    const bool side = std::abs(r - row) == ring;
    for (std::int32_t c = column - ring; c <= column + ring;
         c += side || ring == 0 ? 1 : 2 * ring) {
      if (c < 0 || c >= cells_.columns) continue;
      const std::size_t at = static_cast<std::size_t>(r) * columns + static_cast<std::size_t>(c);
      const std::int32_t clearance = cells_.clearance_mm_lo[at];
      if (perhaps ? clearance >= surely_tried_mm : clearance >= 0 || beside_[at]) ++tested;
      if (clearance < std::max(least_mm(perhaps), 0)) continue;
      ends.push_back(
          {{cells_.origin.x_mm + (c + 0.5) * size, cells_.origin.y_mm + (r + 0.5) * size, 0},
           std::hypot((c - column) * size, (r - row) * size)});
    }
  }
  return tested;
}

}  // namespace rtac::geometry
