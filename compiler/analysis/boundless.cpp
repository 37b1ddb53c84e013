#include "compiler/analysis/boundless.h"

#include <algorithm>
#include <cstdlib>

#include "compiler/analysis/recovery_places.h"
#include "compiler/geometry/region.h"
#include "compiler/support/rational.h"

namespace rtac::analysis {
namespace {

std::string place(std::int64_t x_m, std::int64_t y_m) {
  return "(" + std::to_string(x_m) + " m, " + std::to_string(y_m) + " m)";
}

}  // namespace

bool is_at_the_end(const ir::Edge& edge) {
  // a corner of the square that complements are taken from
  static const std::int64_t end_mm = std::abs(
      floor_to_int(Rational(geometry::Region::everywhere().rings().front().front().x * 1000)));
  const auto ends = [](std::int64_t mm) { return std::abs(mm) >= end_mm; };
  return ends(edge.ax) || ends(edge.ay) || ends(edge.bx) || ends(edge.by);
}

bool is_boundless(const ir::ZoneTable& zone) {
  return std::ranges::any_of(zone.edges, is_at_the_end);
}

bool is_boundless(const ir::Module& module, ir::ZoneIndex zone) {
  const ir::ZoneTable& table = module[zone];
  return is_boundless(table) ||
         std::ranges::any_of(table.slabs, [&](const ir::ZoneTable::Slab& slab) {
           return is_boundless(module[slab.base]);
         });
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
