// Vertices to the 1 mm grid, on the safe side: nothing is believed before Region::contains has
// confirmed it exactly.
#include <algorithm>
#include <cstddef>

#include "compiler/geometry/bake.h"
#include "compiler/geometry/ring.h"

namespace rtac::geometry {
namespace {

constexpr std::int32_t kLimitMm = 1 << 29;
// A corner of less than about 15 degrees may have no grid point within this many millimetres.
constexpr int kSearchMm = 4;
// Rounding moves an outline by at most 1/sqrt(2) mm, so that shrinking by 1 mm first makes it
// safe; the further steps and rounds are for outlines that fold over themselves when rounded.
constexpr int kShrinkStepsMm[] = {0, 1, 2, 3, 5, 8};
constexpr int kRounds = 6;

Point to_mm(const Point& p) {
  return {p.x * 1000, p.y * 1000};
}

Point from_grid(const GridPoint& p) {
  Point result{Rational(p.x_mm, 1000), Rational(p.y_mm, 1000)};
  result.x.canonicalize();
  result.y.canonicalize();
  return result;
}

bool on_grid(const Point& p_mm) {
  return p_mm.x.get_den() == 1 && p_mm.y.get_den() == 1;
}

std::int32_t floor_mm(const Rational& value_mm) {
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), value_mm.get_num_mpz_t(), value_mm.get_den_mpz_t());
  return static_cast<std::int32_t>(whole.get_si());
}

GridPoint nearest_grid_point(const Point& p_mm) {
  const Rational half(1, 2);
  return {floor_mm(p_mm.x + half), floor_mm(p_mm.y + half)};
}

// The grid point to use for `at`: on the inner side of both its edges, so that every edge of the
// rounded ring lies on the inner side of the edge that it replaces. Squares of growing size about
// `at` are searched; where none has such a point, the nearest one is taken.
GridPoint round_inwards(const Point& before, const Point& at, const Point& after) {
  if (on_grid(at)) return nearest_grid_point(at);
  const std::int32_t x0 = floor_mm(at.x);
  const std::int32_t y0 = floor_mm(at.y);
  for (std::int32_t reach = 0; reach < kSearchMm; ++reach) {
    std::optional<GridPoint> best;
    Rational best_distance;
    for (std::int32_t y = y0 - reach; y <= y0 + 1 + reach; ++y) {
      for (std::int32_t x = x0 - reach; x <= x0 + 1 + reach; ++x) {
        const Point p{Rational(x), Rational(y)};
        if (orientation(before, at, p) < 0 || orientation(at, after, p) < 0) continue;
        const Rational distance = (p.x - at.x) * (p.x - at.x) + (p.y - at.y) * (p.y - at.y);
        if (best && best_distance <= distance) continue;
        best = GridPoint{x, y};
        best_distance = distance;
      }
    }
    if (best) return *best;
  }
  return nearest_grid_point(at);
}

Ring round_ring(const Ring& ring) {
  Ring mm;
  std::transform(ring.begin(), ring.end(), std::back_inserter(mm), to_mm);
  Ring rounded;
  const std::size_t n = mm.size();
  for (std::size_t i = 0; i < n; ++i) {
    rounded.push_back(from_grid(round_inwards(mm[(i + n - 1) % n], mm[i], mm[(i + 1) % n])));
  }
  return rounded;
}

template <typename Visit>
void for_each_ring(const Region& region, Visit visit) {
  for (const PolygonWithHoles& part : region.polygons()) {
    visit(part.outer);
    for (const Ring& hole : part.holes) visit(hole);
  }
}

Region rounded(const Region& region) {
  std::vector<Ring> rings;
  for_each_ring(region, [&](const Ring& ring) { rings.push_back(round_ring(ring)); });
  return Region::of_rings(rings);
}

bool all_on_grid(const Region& region) {
  bool all = true;
  for_each_ring(region, [&](const Ring& ring) {
    all = all &&
          std::all_of(ring.begin(), ring.end(), [](const Point& p) { return on_grid(to_mm(p)); });
  });
  return all;
}

bool fits(const Region& region) {
  const auto in_range = [](const Rational& v) { return abs(v) * 1000 <= kLimitMm; };
  bool all = true;
  for_each_ring(region, [&](const Ring& ring) {
    all = all && std::all_of(ring.begin(), ring.end(),
                             [&](const Point& p) { return in_range(p.x) && in_range(p.y); });
  });
  return all;
}

SnappedZone to_zone(const Region& on_grid_region) {
  SnappedZone zone;
  for_each_ring(on_grid_region, [&](const Ring& ring) {
    std::vector<GridPoint>& out = zone.rings.emplace_back();
    for (const Point& p : ring) out.push_back(nearest_grid_point(to_mm(p)));
  });
  return zone;
}

}  // namespace

std::optional<SnappedZone> snap_inside(const Region& region) {
  if (region.empty() || !fits(region)) return std::nullopt;
  if (all_on_grid(region)) return to_zone(region);
  for (const int step_mm : kShrinkStepsMm) {
    Rational step(step_mm, 1000);
    step.canonicalize();
    Region candidate = region.shrink(step);
    for (int round = 0; round < kRounds && !candidate.empty(); ++round) {
      const Region snapped = rounded(candidate);
      if (snapped.empty()) break;
      if (all_on_grid(snapped) && region.contains(snapped)) return to_zone(snapped);
      candidate = snapped.intersect(region);
    }
  }
  return std::nullopt;
}

Region to_region(const SnappedZone& zone) {
  std::vector<Ring> rings;
  for (const auto& grid_ring : zone.rings) {
    Ring& ring = rings.emplace_back();
    for (const GridPoint& p : grid_ring) ring.push_back(from_grid(p));
  }
  return Region::of_rings(rings);
}

}  // namespace rtac::geometry
