// Bounds of the projection, held against true geodesics on random zones everywhere on the globe.
// The distances come from GeographicLib's geodesic solver, which the bounds do not use.
#include "compiler/geometry/place/bounds.h"

#include <gtest/gtest.h>

#include <GeographicLib/AzimuthalEquidistant.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/GeodesicLine.hpp>
#include <algorithm>
#include <cmath>
#include <random>

namespace rtac::geometry {
namespace {

using GeographicLib::Geodesic;

// Of the solver and the projection together (15 nm each), and of their doubles.
constexpr double numeric_m = 1e-7;

struct Place {
  double longitude, latitude, x, y;
};

class Globe {
 public:
  Place origin() {
    latitude_ = draw(-88, 88);
    longitude_ = draw(-180, 180);
    return {longitude_, latitude_, 0, 0};
  }
  // Anywhere within `reach_m` of the origin, often at the very limit.
  Place place(double reach_m) {
    Place p{};
    const double distance = draw(0, 1) < 0.3 ? reach_m : reach_m * std::sqrt(draw(0, 1));
    Geodesic::WGS84().Direct(latitude_, longitude_, draw(-180, 180), distance, p.latitude,
                             p.longitude);
    return at(p.longitude, p.latitude);
  }
  Place at(double longitude, double latitude) const {
    Place p{longitude, latitude, 0, 0};
    projection_.Forward(latitude_, longitude_, latitude, longitude, p.x, p.y);
    return p;
  }
  double draw(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

 private:
  std::mt19937_64 random_{20};
  double latitude_ = 0, longitude_ = 0;
  GeographicLib::AzimuthalEquidistant projection_;
};

double true_distance(const Place& a, const Place& b) {
  double distance = 0;
  Geodesic::WGS84().Inverse(a.latitude, a.longitude, b.latitude, b.longitude, distance);
  return distance;
}
double distance_to_segment(const Place& p, const Place& a, const Place& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double share =
      square == 0 ? 0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
  return std::hypot(p.x - a.x - share * dx, p.y - a.y - share * dy);
}

// Between any two places the map is never short, and long by no more than the bound. The largest
// share of the bound that was seen shows that it is no idle one.
TEST(ProjectionBounds, DistancesAreTrueOrTooLargeWithinTheBound) {
  Globe globe;
  double largest_share = 0;
  for (int zone = 0; zone < 400; ++zone) {
    globe.origin();
    const double reach_m = std::pow(10, globe.draw(2, 4.7));  // 100 m to 50 km
    const double bound_m = distance_error_m(reach_m);
    for (int pair = 0; pair < 50; ++pair) {
      const Place a = globe.place(reach_m), b = globe.place(reach_m);
      const double excess = std::hypot(a.x - b.x, a.y - b.y) - true_distance(a, b);
      EXPECT_GE(excess, -numeric_m);
      EXPECT_LE(excess, bound_m + numeric_m);
      if (bound_m > 100 * numeric_m) largest_share = std::max(largest_share, excess / bound_m);
    }
  }
  EXPECT_GT(largest_share, 0.2);
}

// An edge that is straight in degrees, and the shortest way between its ends, stay as near to the
// straight line on the map as is said, up to 89 degrees of latitude and at the edge of the map.
TEST(ProjectionBounds, EdgesDeviateFromTheStraightLineWithinTheBound) {
  Globe globe;
  double largest_share = 0;
  for (int i = 0; i < 4'000; ++i) {
    globe.origin();
    const Place a = globe.place(reach_m_max);
    const double length = std::pow(10, globe.draw(1, 4.7));
    Place b{};
    Geodesic::WGS84().Direct(a.latitude, a.longitude, globe.draw(-180, 180), length, b.latitude,
                             b.longitude);
    b = globe.at(b.longitude, b.latitude);
    const double limit = 89;
    if (std::abs(a.latitude) > limit || std::abs(b.latitude) > limit) continue;
    if (std::abs(a.longitude - b.longitude) > 180) continue;
    const DegreeEdge edge{a.longitude, a.latitude, b.longitude, b.latitude};
    const double bound = length_m_up(edge) * length_m_up(edge) * bend_per_m(edge) / 8;
    EXPECT_GE(length_m_up(edge), true_distance(a, b) - numeric_m);
    const auto line =
        Geodesic::WGS84().InverseLine(a.latitude, a.longitude, b.latitude, b.longitude);
    for (int k = 1; k < 16; ++k) {
      const double share = k / 16.0;
      const Place straight = globe.at(a.longitude + share * (b.longitude - a.longitude),
                                      a.latitude + share * (b.latitude - a.latitude));
      Place shortest{};
      line.Position(share * line.Distance(), shortest.latitude, shortest.longitude);
      shortest = globe.at(shortest.longitude, shortest.latitude);
      const double off = distance_to_segment(straight, a, b);
      EXPECT_LE(off, bound + numeric_m) << a.latitude << " " << length;
      EXPECT_LE(distance_to_segment(shortest, a, b), bound + numeric_m);
      if (bound > 100 * numeric_m) largest_share = std::max(largest_share, off / bound);
    }
  }
  EXPECT_GT(largest_share, 0.5);
}

}  // namespace
}  // namespace rtac::geometry
