// Zones with height: walls around each slab, and floors and ceilings where neighbours differ.
#include <algorithm>
#include <cmath>
#include <limits>

#include "rtac/zone.h"

namespace rtac {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// To the part of a level that is a floor or a ceiling: straight up or down. The nearest place of it
// elsewhere lies on its edge, where a wall begins.
double to_level(double z, double level_m, bool below, bool on_top) {
  return below == on_top ? infinite : std::abs(z - level_m);
}

}  // namespace

double signed_clearance(const SolidView& zone, Vec3 p) {
  const Vec2 at{p.x, p.y};
  double nearest_m = infinite, top_m = -infinite;
  bool inside = false, below = false;  // below: the slab before is over or under the place
  for (std::size_t i = 0; i < zone.slab_count; ++i) {
    const SlabView& slab = zone.slabs[i];
    const double beside_m = signed_clearance(*slab.base, at);
    const bool here = beside_m >= 0;
    const bool joined = top_m == slab.floor_m;
    if (!joined) nearest_m = std::min(nearest_m, to_level(p.z, top_m, below, false));
    nearest_m = std::min(nearest_m, to_level(p.z, slab.floor_m, joined && below, here));
    const double up_m = std::max({slab.floor_m - p.z, p.z - slab.ceiling_m, 0.0});
    const double wall_m = up_m > 0 ? norm(Vec2{beside_m, up_m}) : std::abs(beside_m);
    nearest_m = std::min(nearest_m, wall_m);
    inside = inside || (here && up_m <= 0);
    top_m = slab.ceiling_m;
    below = here;
  }
  nearest_m = std::min(nearest_m, to_level(p.z, top_m, below, false));
  return inside ? nearest_m : -nearest_m;
}

}  // namespace rtac
