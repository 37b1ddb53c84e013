#include "free_space.h"

#include <algorithm>
#include <limits>

namespace rtac::planning {
namespace {

constexpr double pi = 3.14159265358979323846;
// A leg out of the band is compared with its own start: only rounding may separate the two.
constexpr double rounding_m = 1e-9;
constexpr int escape_directions = 64;
constexpr double escape_first_m = 1e-3, escape_last_m = 2.0, escape_growth = 1.25;

double disc_slack_m(const Disc& disc, Vec2 a, Vec2 b) {
  return segment_distance(a, b, disc.centre) - disc.radius_m;
}

}  // namespace

double segment_distance(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 d = b - a;
  const double length2 = dot(d, d);
  if (length2 <= 0) return norm(p - a);
  return norm(p - (a + std::clamp(dot(p - a, d) / length2, 0.0, 1.0) * d));
}

double FreeSpace::wall_slack_m(Vec2 a, Vec2 b) const {
  if (zone_ == nullptr) return std::numeric_limits<double>::infinity();
  return signed_clearance(*zone_, a, b) - clearance_m_;
}

// How far outside a leg leads that is not free is nobody's question here, and the most costly one.
bool FreeSpace::leg_free(Vec2 a, Vec2 b) const {
  // Written so that a NaN is not free.
  for (const Disc& disc : *discs_) {
    if (!(disc_slack_m(disc, a, b) >= 0)) return false;
  }
  return zone_ == nullptr || keeps_clearance(*zone_, a, b, clearance_m_);
}

bool FreeSpace::leg_no_worse_than(Vec2 start, Vec2 a, Vec2 b) const {
  for (const Disc& disc : *discs_) {
    const double least = std::min(disc_slack_m(disc, start, start), 0.0) - rounding_m;
    if (!(disc_slack_m(disc, a, b) >= least)) return false;
  }
  return wall_slack_m(a, b) >= std::min(wall_slack_m(start, start), 0.0) - rounding_m;
}

bool FreeSpace::escape(Vec2 start, Vec2& end) const {
  for (double length = escape_first_m; length <= escape_last_m; length *= escape_growth) {
    double best_m = -1;
    for (int i = 0; i < escape_directions; ++i) {
      const double angle = 2 * pi * i / escape_directions;
      const Vec2 p = start + length * Vec2{std::cos(angle), std::sin(angle)};
      if (!point_free(p) || !leg_no_worse_than(start, start, p)) continue;
      const double slack_m = std::min(wall_slack_m(p, p), escape_last_m);
      if (slack_m <= best_m) continue;
      best_m = slack_m;
      end = p;
    }
    if (best_m >= 0) return true;
  }
  return false;
}

}  // namespace rtac::planning
