// Elementary functions that give the same bits on every IEEE machine: only + - * /, square roots
// and rounding. The C library's sin, cos, atan2 and hypot choose other code paths on processors
// with fused multiply-add, so that a seeded run would depend on the machine.
#pragma once

#include "rtac/types.h"

namespace rtac::sim {

inline constexpr double pi = 3.14159265358979323846;
// Times this, a unit vector scaled by a bound is no longer than the bound, rounding included.
inline constexpr double rounded_down = 1 - 1e-12;

struct SinCos {
  double sin = 0, cos = 1;
};
// |error| < 1e-15 for |angle_rad| <= 1e5; beyond that, the error of the reduction grows in
// proportion. Angles that are not finite give sin 0, cos 1.
SinCos sin_cos(double angle_rad);

// Angle of (x, y) in (-pi, pi]; 0 for the zero vector. |error| < 1e-15.
double angle_of(Vec2 v);

// The angle plus or minus whole turns, in (-pi, pi]. Not finite: 0.
double wrap_angle(double angle_rad);

// Euclidean length; no protection against overflow beyond 1e150.
inline double length(Vec2 v) {
  return std::sqrt(v.x * v.x + v.y * v.y);
}

inline double length(Vec3 v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

inline double clamp(double value, double lo, double hi) {
  return value < lo ? lo : (value > hi ? hi : value);
}

inline bool is_finite(Vec2 v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}

}  // namespace rtac::sim
