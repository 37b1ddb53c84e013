#include "compiler/analysis/around.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/keeps_off.h"
#include "compiler/analysis/led_from.h"
#include "compiler/analysis/limits.h"

namespace rtac::analysis {
namespace {

using geometry::Point;
using geometry::Region;

struct Wall {
  Point a, b;
};
std::vector<Wall> walls_of(const Region& region) {
  std::vector<Wall> all;
  for (const geometry::Ring& ring : region.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      all.push_back({ring[i], ring[(i + 1) % ring.size()]});
  }
  return all;
}
bool lies_on(const Point& p, const Wall& w) {
  const Rational dx = w.b.x - w.a.x, dy = w.b.y - w.a.y, px = p.x - w.a.x, py = p.y - w.a.y;
  const Rational along = px * dx + py * dy;
  return px * dy == py * dx && along >= 0 && along <= dx * dx + dy * dy;
}

// Distances from places, in mm.
class Walls {
 public:
  void add(const Wall& w) {
    all_.push_back(
        {w.a.x.get_d() * 1000, w.a.y.get_d() * 1000, w.b.x.get_d() * 1000, w.b.y.get_d() * 1000});
  }
  [[nodiscard]] double from(double x, double y) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Segment& s : all_) {
      const double dx = s.bx - s.ax, dy = s.by - s.ay, length = dx * dx + dy * dy;
      const double along = length > 0 ? ((x - s.ax) * dx + (y - s.ay) * dy) / length : 0;
      const double t = std::clamp(along, 0.0, 1.0);
      nearest = std::min(nearest, std::hypot(s.ax + t * dx - x, s.ay + t * dy - y));
    }
    return nearest;
  }

 private:
  struct Segment {
    double ax, ay, bx, by;
  };
  std::vector<Segment> all_;
};

// Of what has more walls than that nothing is known.
constexpr std::size_t walls_most = 600;

struct Boundary {
  Walls fence, others;  // of the zone, those that are not of the fence
};
std::optional<Boundary> boundary_of(const Region& zone, const Region& fence) {
  const std::vector<Wall> own = walls_of(zone), outer = walls_of(fence);
  if (own.size() > walls_most || outer.size() > walls_most) return std::nullopt;
  Boundary boundary;
  for (const Wall& w : outer) boundary.fence.add(w);
  for (const Wall& w : own) {
    const bool of_fence = std::ranges::any_of(
        outer, [&](const Wall& other) { return lies_on(w.a, other) && lies_on(w.b, other); });
    if (!of_fence) boundary.others.add(w);
  }
  return boundary;
}

}  // namespace

bool keeps_around(const sema::RobotKind& kind, const ir::Module& module,
                  const ir::Decision& decision, const ExactZone& exact, const ir::Monitor& driving,
                  const ir::Monitor& judged, const Standoff& fence) {
  const ir::Recovery& retreat = ir::last_step(driving.recovery);
  const bool has_it = driving.name == judged.name || relied_on(decision, driving);
  if (!has_it || module[fence.zone].has_height() ||
      surely_off_mm(driving.property, decision.facts.params, fence.zone) < fence.mm) {
    return false;
  }
  const auto led = led_from(kind, module, decision, driving);
  // legs keep it as well
  if (!led || standoff_mm(decision, retreat) < fence.mm) return false;
  const auto boundary = boundary_of(exact(retreat.zone), exact(fence.zone));
  if (!boundary) return false;
  const ir::Cells& cells = module[retreat.zone].cells;
  const auto size = static_cast<double>(cells.cell_mm), around = size * std::sqrt(0.5);
  const auto keeps = static_cast<double>(decision.body.radius_mm + fence.mm + led->strays_mm);
  for (std::size_t at = 0; at < led->from_mm.size(); ++at) {
    if (led->from_mm[at] < 0) continue;
    const auto columns = static_cast<std::size_t>(cells.columns);
    const std::size_t column = at % columns, row = at / columns;
    const double x = static_cast<double>(cells.origin_x_mm) + (double(column) + 0.5) * size;
    const double y = static_cast<double>(cells.origin_y_mm) + (double(row) + 0.5) * size;
    if (boundary->others.from(x, y) - around >= keeps) continue;
    const auto way = static_cast<double>(led->from_mm[at]);
    if (boundary->fence.from(x, y) - around < keeps + way) return false;
  }
  return true;
}

}  // namespace rtac::analysis
