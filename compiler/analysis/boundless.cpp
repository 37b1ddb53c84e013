#include "compiler/analysis/boundless.h"

#include <algorithm>

#include "compiler/analysis/recovery_places.h"

namespace rtac::analysis {
namespace {

// geometry, Region::everywhere: a complement reaches 536 km from the origin along each axis, and is
// snapped to the grid there.
constexpr std::int64_t end_mm = 536'000'000 - 1'000;

bool is_at_the_end(const ir::Edge& e) {
  const auto beyond = [](std::int64_t mm) { return mm <= -end_mm || mm >= end_mm; };
  return beyond(e.ax) || beyond(e.ay) || beyond(e.bx) || beyond(e.by);
}
std::string place(std::int64_t x_m, std::int64_t y_m) {
  return "(" + std::to_string(x_m) + " m, " + std::to_string(y_m) + " m)";
}

}  // namespace

bool is_boundless(const ir::ZoneTable& zone) {
  return std::ranges::any_of(zone.edges, is_at_the_end);
}

Box box_around(const ir::ZoneTable& zone, const std::vector<ir::SiteTable::Place>& places,
               std::int64_t wider_mm) {
  std::vector<std::int64_t> xs, ys;
  for (const ir::SiteTable::Place& p : places) {
    xs.push_back(p.x_mm);
    ys.push_back(p.y_mm);
  }
  for (const ir::Edge& e : zone.edges) {
    if (is_at_the_end(e)) continue;
    xs.insert(xs.end(), {e.ax, e.bx});
    ys.insert(ys.end(), {e.ay, e.by});
  }
  if (xs.empty()) xs = ys = {0};
  const auto low = [&](const std::vector<std::int64_t>& all) {
    return (std::ranges::min(all) - wider_mm) / 1000 - 1;
  };
  const auto high = [&](const std::vector<std::int64_t>& all) {
    return (std::ranges::max(all) + wider_mm) / 1000 + 1;
  };
  return {low(xs), low(ys), high(xs), high(ys)};
}

std::string bounded(const ir::ZoneTable& zone, const Box& box) {
  std::string name = name_as_written(zone);
  std::erase(name, '`');
  return name + " & rectangle " + place(box.low_x, box.low_y) + " to " +
         place(box.high_x, box.high_y);
}

}  // namespace rtac::analysis
