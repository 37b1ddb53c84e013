#include "reference_design.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>

namespace rtac::campaign {
namespace {

// Places and velocities of the plane, m and m/s.
using Plane = std::complex<double>;

constexpr double room_m = 5, speed_most = 1.5, accel = 1, brake = 1, retreat_mps = 1;
constexpr double late_s = 0.02, hysteresis_s = 0.05, error_m = 0.02, error_mps = 0.02;
constexpr double step_s = 0.005;

double clearance_of(Plane p) {
  return std::min(
      {p.real(), room_m - p.real(), p.imag(), room_m - p.imag()});  // nearest of the walls
}

Plane to_the_nearest_wall(Plane p) {
  const double least = clearance_of(p);
  if (least == p.real()) return {-1, 0};
  if (least == room_m - p.real()) return {1, 0};
  if (least == p.imag()) return {0, -1};
  return {0, 1};
}

// The capsule: both ends far enough from the walls, which are those of a convex room.
bool passes(Plane p, Plane v, double horizon_s) {
  const double speed = std::abs(v);
  const double strays = error_mps + accel * horizon_s;
  const double speed_then = std::min(speed_most, speed + strays);
  const double radius = error_m + error_mps * horizon_s + accel * horizon_s * horizon_s / 2 +
                        (speed + speed_then) * strays / (2 * brake);
  const Plane end = p + v * (horizon_s + speed / (2 * brake));
  return std::min(clearance_of(p), clearance_of(end)) >= radius;
}

Plane no_more_than(double most, Plane value) {
  const double size = std::abs(value);
  return size > most ? value * (most / size) : value;
}

class Experiment {
 public:
  Experiment(int delta_ms, int period_ms, unsigned seed)
      : ahead_s_(2 * delta_ms * 1e-3 + late_s), period_s_(period_ms * 1e-3), random_(seed) {}

  void run(double duration_s, double& advanced_s, double& least_m) {
    const long steps = std::lround(duration_s / step_s);
    const long between = std::max(1L, std::lround(period_s_ / step_s));
    for (long i = 0; i < steps; ++i) {
      if (i % between == 0) decide();
      const Plane push = advanced_ ? accel * to_the_nearest_wall(p_) : back();
      p_ += step_s * v_ + step_s * step_s / 2 * push;
      v_ = no_more_than(speed_most, v_ + step_s * push);
      if (advanced_) advanced_s += step_s;
      least_m = std::min(least_m, clearance_of(p_));
    }
  }

 private:
  Plane noise(double most) {
    std::uniform_real_distribution<double> part(-1, 1);
    return no_more_than(most, {most * part(random_), most * part(random_)});
  }

  void decide() {
    const bool passed = passes(p_ + noise(error_m), v_ + noise(error_mps),
                               ahead_s_ + (advanced_ ? 0 : hysteresis_s));
    if (advanced_ && !passed) stands_ = false;
    advanced_ = passed;
  }

  // Brakes to a stand, then drives straight away from the nearest wall.
  Plane back() {
    if (std::abs(v_) <= 2 * brake * step_s) stands_ = true;
    const Plane wanted = stands_ ? -retreat_mps * to_the_nearest_wall(p_) : Plane{};
    return no_more_than(brake, (wanted - v_) / (2 * step_s));
  }

  double ahead_s_, period_s_;
  std::mt19937 random_;
  Plane p_{room_m / 2, room_m / 2}, v_{};
  bool advanced_ = true, stands_ = true;
};

}  // namespace

Left left_by_the_reference(int delta_ms, int period_ms, int runs, int duration_s) {
  double advanced_s = 0;
  Left left{0, room_m};
  for (int seed = 1; seed <= runs; ++seed) {
    Experiment(delta_ms, period_ms, static_cast<unsigned>(seed))
        .run(duration_s, advanced_s, left.clearance_m);
  }
  left.percent = 100 * advanced_s / (runs * duration_s);
  return left;
}

}  // namespace rtac::campaign
