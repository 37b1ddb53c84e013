#include "rtac/sim/math.h"

namespace rtac::sim {
namespace {

// pi/2 as a sum whose first part has 33 significant bits, so that its product with a whole number
// below 2^20 is exact (Cody and Waite reduction).
constexpr double half_pi_hi = 0x1.921fb544p+0;
constexpr double half_pi_lo = 0x1.0b4611a626331p-34;

// Taylor polynomials on [-pi/4, pi/4]; the first omitted terms are below 1e-18.
double sin_kernel(double x) {
  const double z = x * x;
  double sum = -1.0 / 1307674368000.0;
  sum = sum * z + 1.0 / 6227020800.0;
  sum = sum * z - 1.0 / 39916800.0;
  sum = sum * z + 1.0 / 362880.0;
  sum = sum * z - 1.0 / 5040.0;
  sum = sum * z + 1.0 / 120.0;
  sum = sum * z - 1.0 / 6.0;
  return x + x * z * sum;
}

double cos_kernel(double x) {
  const double z = x * x;
  double sum = 1.0 / 20922789888000.0;
  sum = sum * z - 1.0 / 87178291200.0;
  sum = sum * z + 1.0 / 479001600.0;
  sum = sum * z - 1.0 / 3628800.0;
  sum = sum * z + 1.0 / 40320.0;
  sum = sum * z - 1.0 / 720.0;
  sum = sum * z + 1.0 / 24.0;
  return 1.0 - 0.5 * z + z * z * sum;
}

// arctan for 0 <= t <= 1: two halvings bring it below tan(pi/16), then the series.
double arctan(double t) {
  t = t / (1.0 + std::sqrt(1.0 + t * t));
  t = t / (1.0 + std::sqrt(1.0 + t * t));
  const double z = t * t;
  double sum = 0;
  for (int k = 23; k >= 3; k -= 2) {
    sum = z * ((k % 4 == 3 ? -1.0 : 1.0) / k + sum);
  }
  return 4.0 * (t + t * sum);
}

}  // namespace

SinCos sin_cos(double angle_rad) {
  if (!std::isfinite(angle_rad)) return {};
  const double turns = std::nearbyint(angle_rad * (2.0 / pi));
  const double rest = (angle_rad - turns * half_pi_hi) - turns * half_pi_lo;
  const double s = sin_kernel(rest);
  const double c = cos_kernel(rest);
  const double quarter = turns - 4.0 * std::floor(turns * 0.25);  // 0, 1, 2 or 3
  if (quarter < 0.5) return {s, c};
  if (quarter < 1.5) return {c, -s};
  if (quarter < 2.5) return {-s, -c};
  return {-c, s};
}

double angle_of(Vec2 v) {
  const double ax = std::abs(v.x);
  const double ay = std::abs(v.y);
  if (!(ax > 0) && !(ay > 0)) return 0;
  double angle = ay <= ax ? arctan(ay / ax) : pi / 2 - arctan(ax / ay);
  if (v.x < 0) angle = pi - angle;
  return v.y < 0 ? -angle : angle;
}

double wrap_angle(double angle_rad) {
  if (!std::isfinite(angle_rad)) return 0;
  if (angle_rad > -pi && angle_rad <= pi) return angle_rad;
  const double wrapped = angle_rad - 2 * pi * std::nearbyint(angle_rad / (2 * pi));
  return wrapped <= -pi ? wrapped + 2 * pi : wrapped;
}

}  // namespace rtac::sim
