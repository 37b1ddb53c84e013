#include "compiler/geometry/crowding.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace rtac::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
// What doubles may lose of sums of a few thousand lengths and areas, many times over.
constexpr double excess = 1 + 1e-9;

struct Hull {
  double area_m2 = 0, perimeter_m = 0;
};

Hull hull_of(const Region& region) {
  std::vector<Kernel::Point_2> points;
  for (const Ring& ring : region.rings()) {
    for (const Point& p : ring) points.emplace_back(Kernel::FT(p.x), Kernel::FT(p.y));
  }
  CGAL::Polygon_2<Kernel> hull;
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  Hull found{CGAL::to_double(hull.area()), 0};
  for (const auto& edge : hull.edges()) {
    found.perimeter_m += std::sqrt(CGAL::to_double(edge.squared_length()));
  }
  return found;
}

// Places within the convex hull, by Oler's inequality.
bool beyond_hull(const Region& region, double places, double apart_m) {
  const auto [area_m2, perimeter_m] = hull_of(region);
  const double most =
      2 / std::sqrt(3.0) * area_m2 / (apart_m * apart_m) + perimeter_m / (2 * apart_m) + 1;
  return places > most * excess;
}

// Of boxes in rows and columns, one fewer than there are places, two places share one, and are no
// farther apart than its corners.
bool beyond_boxes(const Region& region, std::size_t places, const Rational& apart) {
  const auto rings = region.rings();
  Point low = rings.front().front(), high = low;
  for (const Ring& ring : rings) {
    for (const Point& p : ring) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  for (std::size_t columns = 1; columns < places; ++columns) {
    const Rational width = (high.x - low.x) / static_cast<unsigned long>(columns);
    const Rational height = (high.y - low.y) / static_cast<unsigned long>((places - 1) / columns);
    if (width * width + height * height < apart * apart) return true;
  }
  return false;
}

// Discs that overlap nowhere.
bool beyond_area(const Region& region, double places, const Rational& apart) {
  constexpr double quarter_pi = 0.785398;  // rounded down
  const auto around = region.offset(apart / 2);
  const double apart_m = apart.get_d();
  return around && places * quarter_pi * apart_m * apart_m > around->area().get_d() * excess;
}

}  // namespace

bool too_many_for(const Region& region, std::size_t places, const Rational& apart) {
  if (places < 2) return false;
  if (region.empty()) return true;
  const auto many = static_cast<double>(places);
  return beyond_hull(region, many, apart.get_d()) || beyond_boxes(region, places, apart) ||
         beyond_area(region, many, apart);
}

}  // namespace rtac::geometry
