// Vertices to the 1 mm grid, on the safe side: nothing is believed before Region::contains has
// confirmed it exactly.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "compiler/geometry/bake.h"
#include "compiler/geometry/ring.h"

namespace rtac::geometry {
namespace {

constexpr std::int32_t kLimitMm = 1 << 29;
// How far around a vertex the nearest grid point is searched; only corners of less than about 20
// degrees have none so near.
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

struct Direction {
  double x, y;  // of length one, nearly
};

Direction direction(const Point& from, const Point& to) {
  const double x = Rational(to.x - from.x).get_d();
  const double y = Rational(to.y - from.y).get_d();
  const double length = std::sqrt(x * x + y * y);
  return {x / length, y / length};
}

GridPoint near(const Point& from, double x_mm, double y_mm) {
  return nearest_grid_point({from.x + Rational(x_mm), from.y + Rational(y_mm)});
}

// Sharp corners have no grid point near that suits both edges. Every disc with a radius of
// 1/sqrt(2) mm contains a grid point, so a disc of kReachMm that touches the edges will do. Doubles
// find the points; whether they are safe is decided exactly, later.
constexpr double kReachMm = 0.75;

// A convex corner is cut off where it becomes as wide as the disc.
GridPoint cut_tip(const Point& at, const Direction& incoming, const Direction& outgoing) {
  const Direction sum{outgoing.x - incoming.x, outgoing.y - incoming.y};
  const Direction difference{outgoing.x + incoming.x, outgoing.y + incoming.y};
  const double twice_cosine = std::sqrt(sum.x * sum.x + sum.y * sum.y);  // of half the angle
  const double twice_sine = std::sqrt(difference.x * difference.x + difference.y * difference.y);
  constexpr double kDeepestMm = 1e6;
  const double depth = 2 * kReachMm / twice_sine / twice_cosine;
  if (!(depth < kDeepestMm)) return nearest_grid_point(at);
  return near(at, depth * sum.x, depth * sum.y);
}

// In front of a reflex corner a second vertex makes a blunt end: both are nearer to it than this.
const Rational kBluntMm(9, 5);
void add_blunt_end(const Point& at, const Direction& in, const Direction& out,
                   std::vector<GridPoint>& rounded) {
  rounded.push_back(near(at, kReachMm * (in.x - in.y), kReachMm * (in.y + in.x)));
  rounded.push_back(near(at, kReachMm * (-out.x - out.y), kReachMm * (-out.y + out.x)));
}

Rational squared_distance(const GridPoint& p, const Point& at) {
  const Rational x = p.x_mm - at.x, y = p.y_mm - at.y;
  return x * x + y * y;
}

// The nearest grid point on the inner side of both edges at `at`, so that every edge of the
// rounded ring lies on the inner side of the edge that it replaces.
std::optional<GridPoint> inner_neighbour(const Point& before, const Point& at, const Point& after) {
  const std::int32_t x0 = floor_mm(at.x);
  const std::int32_t y0 = floor_mm(at.y);
  for (std::int32_t reach = 0; reach < kSearchMm; ++reach) {
    std::optional<GridPoint> best;
    Rational best_distance;
    for (std::int32_t y = y0 - reach; y <= y0 + 1 + reach; ++y) {
      for (std::int32_t x = x0 - reach; x <= x0 + 1 + reach; ++x) {
        const Point p{Rational(x), Rational(y)};
        if (orientation(before, at, p) < 0 || orientation(at, after, p) < 0) continue;
        const Rational distance = squared_distance({x, y}, at);
        if (best && best_distance <= distance) continue;
        best = GridPoint{x, y};
        best_distance = distance;
      }
    }
    if (best) return best;
  }
  return std::nullopt;
}

void round_vertex(const Point& before, const Point& at, const Point& after,
                  std::vector<GridPoint>& rounded) {
  if (on_grid(at)) {
    rounded.push_back(nearest_grid_point(at));
    return;
  }
  const bool is_convex = orientation(before, at, after) > 0;
  const auto neighbour = inner_neighbour(before, at, after);
  if (neighbour && (is_convex || squared_distance(*neighbour, at) <= kBluntMm * kBluntMm)) {
    rounded.push_back(*neighbour);
  } else if (is_convex) {
    rounded.push_back(cut_tip(at, direction(before, at), direction(at, after)));
  } else {
    add_blunt_end(at, direction(before, at), direction(at, after), rounded);
  }
}

Ring round_ring(const Ring& ring) {
  Ring exact_mm;
  std::transform(ring.begin(), ring.end(), std::back_inserter(exact_mm), to_mm);
  std::vector<GridPoint> rounded;
  const std::size_t n = exact_mm.size();
  for (std::size_t i = 0; i < n; ++i) {
    round_vertex(exact_mm[(i + n - 1) % n], exact_mm[i], exact_mm[(i + 1) % n], rounded);
  }
  Ring result;
  std::transform(rounded.begin(), rounded.end(), std::back_inserter(result), from_grid);
  return result;
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

// A rectangle on the grid, 1 m wider than the region on every side.
Region frame_of(const Region& region) {
  Point low = region.polygons().front().outer.front(), high = low;
  for_each_ring(region, [&](const Ring& ring) {
    for (const Point& p : ring) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  });
  const auto floor_m = [](const Rational& v) { return Rational(floor_to_int(v) - 1); };
  const auto ceil_m = [](const Rational& v) { return Rational(ceil_to_int(v) + 1); };
  const Rational x0 = floor_m(low.x), y0 = floor_m(low.y);
  const Rational x1 = ceil_m(high.x), y1 = ceil_m(high.y);
  return Region::of_rings({{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}});
}

}  // namespace

bool is_on_grid(const Region& region) {
  bool all = true;
  for_each_ring(region, [&](const Ring& ring) {
    all = all &&
          std::all_of(ring.begin(), ring.end(), [](const Point& p) { return on_grid(to_mm(p)); });
  });
  return all;
}

std::optional<SnappedZone> snap_inside(const Region& region) {
  if (region.empty() || !fits(region)) return std::nullopt;
  if (is_on_grid(region)) return to_zone(region);
  for (const int step_mm : kShrinkStepsMm) {
    Rational step(step_mm, 1000);
    step.canonicalize();
    Region candidate = region.shrink(step);
    for (int round = 0; round < kRounds && !candidate.empty(); ++round) {
      const Region snapped = rounded(candidate);
      if (snapped.empty()) break;
      if (is_on_grid(snapped) && region.contains(snapped)) return to_zone(snapped);
      candidate = snapped.intersect(region);
    }
  }
  return std::nullopt;
}

std::optional<SnappedZone> snap_around(const Region& region) {
  if (region.empty() || !fits(region)) return std::nullopt;
  if (is_on_grid(region)) return to_zone(region);
  // Rounded to the other side, most outlines do.
  std::vector<Ring> rings;
  for_each_ring(region,
                [&](const Ring& ring) { rings.push_back(reversed(round_ring(reversed(ring)))); });
  const Region simple = Region::of_rings(rings);
  if (fits(simple) && is_on_grid(simple) && simple.contains(region)) return to_zone(simple);
  // What is around it, within a frame, is snapped from within.
  const Region frame = frame_of(region);
  const auto outside = snap_inside(frame.subtract(region));
  if (!outside) return std::nullopt;
  const Region around = frame.subtract(to_region(*outside));
  if (!is_on_grid(around) || !around.contains(region)) return std::nullopt;
  return to_zone(around);
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
