#include "rtac/sim/distance_field.h"

#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace rtac::sim {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

}  // namespace

DistanceField::DistanceField(const ZoneView& zone, Vec2 goal, double clearance_m)
    : zone_(zone),
      goal_(goal),
      value_m_(static_cast<std::size_t>(zone.columns) * static_cast<std::size_t>(zone.rows),
               unknown) {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const int first = cell_of(goal);
  if (first < 0) return;
  value_m_[static_cast<std::size_t>(first)] = norm(goal - centre(first));
  open.push({value_m_[static_cast<std::size_t>(first)], first});
  while (!open.empty()) {
    const auto [value, cell] = open.top();
    open.pop();
    if (value > value_m_[static_cast<std::size_t>(cell)]) continue;
    const int column = cell % zone_.columns, row = cell / zone_.columns;
    for (int step = 0; step < 9; ++step) {
      const int c = column + step % 3 - 1, r = row + step / 3 - 1;
      if (c < 0 || r < 0 || c >= zone_.columns || r >= zone_.rows) continue;
      const int next = r * zone_.columns + c;
      if (signed_clearance(zone_, centre(next)) < clearance_m) continue;
      const double longer = value + norm(centre(next) - centre(cell));
      if (longer >= value_m_[static_cast<std::size_t>(next)]) continue;
      value_m_[static_cast<std::size_t>(next)] = longer;
      open.push({longer, next});
    }
  }
}

int DistanceField::cell_of(Vec2 p) const {
  const double column = std::floor((p.x * 1000 - zone_.origin_x_mm) / zone_.cell_mm);
  const double row = std::floor((p.y * 1000 - zone_.origin_y_mm) / zone_.cell_mm);
  if (!(column >= 0 && row >= 0 && column < zone_.columns && row < zone_.rows)) return -1;
  return static_cast<int>(row) * zone_.columns + static_cast<int>(column);
}

Vec2 DistanceField::centre(int cell) const {
  const double half_mm = 0.5 * zone_.cell_mm;
  const int row = cell / zone_.columns, column = cell % zone_.columns;
  return {1e-3 * (zone_.origin_x_mm + column * zone_.cell_mm + half_mm),
          1e-3 * (zone_.origin_y_mm + row * zone_.cell_mm + half_mm)};
}

double DistanceField::distance_m(Vec2 from) const {
  const int cell = cell_of(from);
  const double value = cell < 0 ? unknown : value_m_[static_cast<std::size_t>(cell)];
  return value < unknown ? value : norm(goal_ - from);
}

}  // namespace rtac::sim
