#include "compiler/geometry/starts.h"

#include <algorithm>

namespace rtac::geometry {

Starts::Starts(const Region& region, std::int32_t off_mm) : off_mm_(off_mm) {
  for (const Ring& ring : region.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      lines_.push_back(
          {1e3 * a.x.get_d(), 1e3 * a.y.get_d(), 1e3 * b.x.get_d(), 1e3 * b.y.get_d()});
    }
  }
}

std::optional<CellGrid> Starts::cells() const {
  constexpr double far_mm = 1e8, most = 40'000;  // zones lie within 100 km of the origin
  double left = far_mm, low = far_mm, right = -far_mm, top = -far_mm;
  for (const Line& e : lines_) {
    left = std::min(left, e.ax), right = std::max(right, e.ax);
    low = std::min(low, e.ay), top = std::max(top, e.ay);
  }
  CellGrid grid;
  if (lines_.empty()) return grid;
  if (std::max({-left, -low, right, top}) > far_mm) return std::nullopt;
  const double wide = right - left, high = top - low;
  while (wide * high > most * grid.cell_mm * grid.cell_mm) grid.cell_mm *= 2;
  grid.origin = {static_cast<std::int32_t>(left) - 2 * off_mm_,
                 static_cast<std::int32_t>(low) - 2 * off_mm_};
  grid.columns = static_cast<std::int32_t>((wide + 4 * off_mm_) / grid.cell_mm) + 1;
  grid.rows = static_cast<std::int32_t>((high + 4 * off_mm_) / grid.cell_mm) + 1;
  grid.clearance_mm_lo.assign(
      static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), 0);
  return grid;
}

bool Starts::are_near(double x_mm, double y_mm, double within_mm) const {
  const double far = within_mm + off_mm_;
  bool inside = false;
  for (const Line& e : lines_) {
    const double dx = e.bx - e.ax, dy = e.by - e.ay, x = x_mm - e.ax, y = y_mm - e.ay;
    const double t = std::clamp((x * dx + y * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    const double off_x = x - t * dx, off_y = y - t * dy;
    if (off_x * off_x + off_y * off_y <= far * far) return true;
    if ((e.ay > y_mm) == (e.by > y_mm)) continue;
    if (x < y / dy * dx) inside = !inside;
  }
  return inside;
}

}  // namespace rtac::geometry
