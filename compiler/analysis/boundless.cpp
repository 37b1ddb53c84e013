#include "compiler/analysis/boundless.h"

#include <algorithm>

#include "compiler/analysis/recovery_places.h"

namespace rtac::analysis {
namespace {

// Zones that are written lie within 100 km of the origin: what reaches farther is a complement.
constexpr std::int64_t far_mm = 100'000'000;

bool is_far(const ir::Edge& e) {
  const auto beyond = [](std::int64_t mm) { return mm < -far_mm || mm > far_mm; };
  return beyond(e.ax) || beyond(e.ay) || beyond(e.bx) || beyond(e.by);
}
std::string place(std::int64_t x_m, std::int64_t y_m) {
  return "(" + std::to_string(x_m) + " m, " + std::to_string(y_m) + " m)";
}

}  // namespace

bool is_boundless(const ir::ZoneTable& zone) {
  return std::ranges::any_of(zone.edges, is_far);
}

std::string bounded(const ir::ZoneTable& zone, std::int64_t wider_mm) {
  std::int64_t low_x = INT64_MAX, low_y = INT64_MAX, high_x = INT64_MIN, high_y = INT64_MIN;
  for (const ir::Edge& e : zone.edges) {
    if (is_far(e)) continue;
    low_x = std::min<std::int64_t>({low_x, e.ax, e.bx});
    low_y = std::min<std::int64_t>({low_y, e.ay, e.by});
    high_x = std::max<std::int64_t>({high_x, e.ax, e.bx});
    high_y = std::max<std::int64_t>({high_y, e.ay, e.by});
  }
  if (low_x > high_x) low_x = low_y = high_x = high_y = 0;
  const std::int64_t wider_m = wider_mm / 1000 + 1;
  std::string name = name_as_written(zone);
  std::erase(name, '`');
  return name + " & rectangle " + place(low_x / 1000 - wider_m, low_y / 1000 - wider_m) + " to " +
         place(high_x / 1000 + wider_m, high_y / 1000 + wider_m);
}

}  // namespace rtac::analysis
