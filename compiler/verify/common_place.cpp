#include "compiler/verify/common_place.h"

#include <algorithm>

#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/sides.h"
#include "compiler/support/words.h"

namespace rtac::verify {
namespace {

using geometry::Point;
using geometry::Region;

// Where the rings of a polygon cross a horizontal line, from left to right: between the first and
// the second it is inside, and so on. A vertex on the line counts as above it.
std::vector<Rational> crossings(const geometry::PolygonWithHoles& polygon, const Rational& y) {
  std::vector<Rational> all;
  const auto of_ring = [&](const geometry::Ring& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
      if ((a.y < y) == (b.y < y)) continue;
      all.emplace_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
    }
  };
  of_ring(polygon.outer);
  for (const geometry::Ring& hole : polygon.holes) of_ring(hole);
  std::ranges::sort(all);
  return all;
}

// In the middle of what a polygon has at one of a few heights.
template <class Is>
std::optional<Point> place_in(const geometry::PolygonWithHoles& polygon, const Is& is_good) {
  constexpr int heights = 16;
  const auto [low, high] =
      std::ranges::minmax_element(polygon.outer, {}, [](const Point& p) { return p.y; });
  for (int k = 1; k < heights; ++k) {
    // the middle first
    const int part = k % 2 == 1 ? heights / 2 + k / 2 : heights / 2 - k / 2;
    const Rational y = low->y + (high->y - low->y) * part / heights;
    const std::vector<Rational> at = crossings(polygon, y);
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
      const Rational x = (at[i] + at[i + 1]) / 2;
      const Point whole{analysis::metres_of(in_mm(x)), analysis::metres_of(in_mm(y))};
      if (is_good(whole)) return whole;
    }
  }
  return std::nullopt;
}

std::optional<Point> place_in_common(const Subject& s, const std::vector<Need>& all,
                                     const IsClear& is_clear) {
  Region common = Region::everywhere();
  for (const Need& need : all) {
    const auto deep = analysis::within(s.exact(need.zone), need.clearance_mm);
    if (!deep) return std::nullopt;
    common = common.intersect(*deep);
  }
  for (const geometry::PolygonWithHoles& polygon : common.polygons()) {
    if (const auto at = place_in(polygon, is_clear)) return at;
  }
  return std::nullopt;
}

}  // namespace

IsClear::IsClear(const Subject& s, const std::vector<Need>& all) {
  for (const Need& need : all) {
    const Region& region = s.exact(need.zone);
    zones_.push_back({region, analysis::outline::Outline::of(region), need.clearance_mm});
  }
}

bool IsClear::operator()(const Point& p) const {
  constexpr double unsure_mm = 1;  // far more than doubles are off
  const analysis::outline::P at{1000 * p.x.get_d(), 1000 * p.y.get_d()};
  const bool perhaps = std::ranges::all_of(zones_, [&](const Zone& zone) {
    return zone.outline.clearance(at) >= double(zone.clearance_mm) - unsure_mm;
  });
  return perhaps && std::ranges::all_of(zones_, [&](const Zone& zone) {
           const Rational metres = analysis::metres_of(zone.clearance_mm);
           return zone.region.contains(p) && square_to(zone.region.rings(), p) >= metres * metres;
         });
}

std::optional<Point> common_place(const Subject& s, const std::vector<Need>& all) {
  const Need& narrowest =
      *std::min_element(all.begin(), all.end(), [&](const Need& a, const Need& b) {
        return s.module[a.zone].widest_mm - a.clearance_mm <
               s.module[b.zone].widest_mm - b.clearance_mm;
      });
  const ir::ZoneTable& zone = s.module[narrowest.zone];
  const IsClear is_clear(s, all);
  const Point widest{analysis::metres_of(zone.widest_x_mm), analysis::metres_of(zone.widest_y_mm)};
  if (is_clear(widest)) return widest;
  const ir::Cells& cells = zone.cells;
  for (std::size_t at = 0; at < cells.clearance_mm_lo.size(); ++at) {
    if (cells.clearance_mm_lo[at] < narrowest.clearance_mm) continue;
    const auto columns = static_cast<std::size_t>(cells.columns);
    const std::int64_t half = cells.cell_mm / 2;
    const Point centre{
        analysis::metres_of(cells.origin_x_mm + std::int64_t(at % columns) * cells.cell_mm + half),
        analysis::metres_of(cells.origin_y_mm + std::int64_t(at / columns) * cells.cell_mm + half)};
    if (is_clear(centre)) return centre;
  }
  return place_in_common(s, all, is_clear);
}

std::optional<Point> any_place(const Subject& s, std::vector<Need> all) {
  for (Need& need : all) need.clearance_mm = s.decision.body.radius_mm;
  return common_place(s, all);
}

}  // namespace rtac::verify
