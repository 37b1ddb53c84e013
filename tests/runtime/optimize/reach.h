// Closed forms and an independent simulation to compare the adversary with.
#pragma once

#include <algorithm>
#include <cmath>

#include "rtac/optimize/worst_case.h"

namespace rtac::test {

inline ReachProblem problem(Vec2 velocity, Vec2 normal) {
  ReachProblem q;
  q.position = {1, 2};
  q.velocity = velocity;
  q.accel_mps2 = 1.5;
  q.brake_mps2 = 2;
  q.horizon_s = 0.4;
  q.normal = normal;
  q.offset_m = dot(normal, q.position);  // excursions count from the measured position
  return q;
}

// theory: disc test, without disturbance and body. Farthest reach from the measured position.
inline double disc_bound_m(const ReachProblem& q) {
  const double V = q.speed_mps, A = q.accel_mps2, T = q.horizon_s;
  const double s0 = std::min(V, norm(q.velocity) + q.velocity_error_mps);
  const double s1 = std::min(V, s0 + A * T);
  const double S = s0 + A * T <= V ? s0 * T + A * T * T / 2 : V * T - (V - s0) * (V - s0) / (2 * A);
  return q.position_error_m + S + s1 * s1 / (2 * q.brake_mps2);
}

// theory: capsule test, the part that reaches across the line.
inline double capsule_bound_m(const ReachProblem& q) {
  const double A = q.accel_mps2, T = q.horizon_s, b = q.brake_mps2, s = norm(q.velocity);
  const double s1 = std::min(q.speed_mps, s + q.velocity_error_mps + A * T);
  const Vec2 along = (T + s / (2 * b)) * q.velocity;
  return std::max(0.0, dot(q.normal, along)) + q.position_error_m + q.velocity_error_mps * T +
         A * T * T / 2 + (s + s1) * (q.velocity_error_mps + A * T) / (2 * b);
}

// Mitsch et al., IJRR 2017, theorem 1: stopping distance with exact sensing and no cap.
inline double mitsch_bound_m(double v, double A, double b, double T) {
  return v * v / (2 * b) + (A / b + 1) * (A * T * T / 2 + T * v);
}

struct Replay {
  double excursion_m = 0;  // farthest point of the whole motion, braking included
  double speed_max_mps = 0, accel_max_mps2 = 0;
  Vec2 end;  // where it rests
};

// Replays start and controls alone in small explicit steps, braking from `brake_at` on: shares no
// formula with the search.
inline Replay replay(const ReachProblem& q, const WorstCase& w) {
  constexpr double dt = 1e-5;
  Replay r;
  Vec2 p = w.positions_m[0], v = w.velocities_mps[0];
  r.excursion_m = dot(q.normal, p) - q.offset_m;
  const auto advance = [&](Vec2 a, double h) {
    p = p + h * (v + (h / 2) * a);
    v = v + h * a;
    r.speed_max_mps = std::max(r.speed_max_mps, norm(v));
    r.excursion_m = std::max(r.excursion_m, dot(q.normal, p) - q.offset_m);
  };
  r.speed_max_mps = norm(v);
  const double interval = q.horizon_s / q.intervals;
  const int steps = static_cast<int>(std::ceil(interval / dt));
  for (std::size_t k = 0; k < w.brake_at; ++k) {
    r.accel_max_mps2 = std::max(r.accel_max_mps2, norm(w.controls_mps2[k]));
    for (int i = 0; i < steps; ++i) advance(w.controls_mps2[k], interval / steps);
  }
  while (norm(v) > q.brake_mps2 * dt) advance((-q.brake_mps2 / norm(v)) * v, dt);
  r.end = p;
  return r;
}

}  // namespace rtac::test
