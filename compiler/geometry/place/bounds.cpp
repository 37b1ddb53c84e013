#include "compiler/geometry/place/bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rtac::geometry {
namespace {

// WGS 84 (NIMA TR8350.2). The Gaussian curvature is largest at the equator, 1 / b^2; the radii of
// curvature are largest at the poles, a^2 / b.
constexpr double semi_major_m = 6'378'137.0;
constexpr double semi_minor_m = 6'356'752.314245;
constexpr double radius_m_most = semi_major_m * semi_major_m / semi_minor_m;
constexpr double curvature_most = 1 / (semi_minor_m * semi_minor_m);

constexpr double radians(double deg) {
  return deg * std::numbers::pi / 180;
}

}  // namespace

double distance_error_m(double reach_m) {
  return reach_m * reach_m * reach_m * curvature_most / 3;
}

double length_m_up(const DegreeEdge& edge) {
  const double least = std::min(std::abs(edge.latitude_a_deg), std::abs(edge.latitude_b_deg));
  const bool crosses_equator = edge.latitude_a_deg * edge.latitude_b_deg <= 0;
  const double widest = crosses_equator ? 1 : std::cos(radians(least));
  return radius_m_most * std::hypot(radians(edge.latitude_b_deg - edge.latitude_a_deg),
                                    widest * radians(edge.longitude_b_deg - edge.longitude_a_deg));
}

// The first part bends the edge on the globe: 2 / sqrt(3) tan(latitude) / b, more by the
// flattening. The second part bends it on the map: 2/3 of the curvature times the distance.
double bend_per_m(const DegreeEdge& edge) {
  constexpr double of_parallels = 1.2;
  const double most = std::max(std::abs(edge.latitude_a_deg), std::abs(edge.latitude_b_deg));
  return of_parallels * std::tan(radians(most)) / semi_minor_m +
         (reach_m_max + around_m) * curvature_most;
}

}  // namespace rtac::geometry
