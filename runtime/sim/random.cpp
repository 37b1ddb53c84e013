#include "rtac/sim/random.h"

namespace rtac::sim {

Vec2 Random::unit_disc() {
  // Rejection instead of polar coordinates: no trigonometry, exactly uniform.
  for (;;) {
    const Vec2 v{uniform(-1, 1), uniform(-1, 1)};
    if (dot(v, v) <= 1.0 - 0x1p-48) return v;  // room for the rounding of a later scaling
  }
}

Vec2 Random::on_circle(double radius) {
  for (;;) {
    const Vec2 v = unit_disc();
    const double norm_v = length(v);
    if (norm_v < 0.1) continue;  // too short to give a direction with full accuracy
    return (radius * (1 - 0x1p-50) / norm_v) * v;
  }
}

Vec3 Random::unit_ball() {
  for (;;) {
    const Vec3 v{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    if (v.x * v.x + v.y * v.y + v.z * v.z <= 1.0 - 0x1p-48) return v;
  }
}

Vec3 Random::on_sphere(double radius) {
  for (;;) {
    const Vec3 v = unit_ball();
    const double norm_v = length(v);
    if (norm_v < 0.1) continue;
    return (radius * (1 - 0x1p-50) / norm_v) * v;
  }
}

}  // namespace rtac::sim
