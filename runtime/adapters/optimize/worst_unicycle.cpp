#include "rtac/optimize/worst_unicycle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

#include "trajectory.h"
#include "unicycle_nlp.h"

namespace rtac {
namespace {

using optimize::SolveStatus;
using optimize::UnicycleCandidate;

constexpr double pi = 3.14159265358979323846;
constexpr int steps_per_interval = 16;

bool valid(const UnicycleProblem& q) {
  for (const double x : {q.position.x, q.position.y, q.velocity.x, q.velocity.y, q.heading_rad,
                         q.accel_mps2, q.brake_mps2, q.turn_radps, q.turn_accel_radps2, q.horizon_s,
                         q.position_error_m, q.velocity_error_mps, q.heading_error_rad}) {
    if (!std::isfinite(x)) return false;
  }
  const Vec2 way{std::cos(q.heading_rad), std::sin(q.heading_rad)};
  const double ahead_mps = std::clamp(dot(way, q.velocity), 0.0, std::max(q.speed_mps, 0.0));
  constexpr double rounding = 1e-6;
  return std::abs(norm(q.normal) - 1) <= rounding && q.accel_mps2 > 0 && q.brake_mps2 > 0 &&
         q.speed_mps > 0 && q.turn_radps > 0 && q.turn_accel_radps2 >= 0 && q.horizon_s > 0 &&
         q.position_error_m >= 0 && q.velocity_error_mps >= 0 && q.heading_error_rad >= 0 &&
         q.intervals > 1 && q.starts > 0 &&
         norm(ahead_mps * way - q.velocity) <= q.velocity_error_mps + rounding;
}

// ---- driving a candidate

struct Body {
  Vec2 place;
  double speed_mps = 0, heading_rad = 0, turn_radps = 0;
};

double towards(double from, double to, double by) {
  return from + std::clamp(to - from, -by, by);
}

// The turn at its limit, the speed as it is told. A chord is shorter than its arc: seen from the
// middle, by no more than (turned / 2)^2 / 6.
void drive(const UnicycleProblem& q, double speed_mps, double turn_radps, double step_s, Body& b) {
  const double slew = q.turn_accel_radps2 > 0 ? q.turn_accel_radps2 * step_s : HUGE_VAL;
  const double turn = towards(b.turn_radps, turn_radps, slew);
  const double turned = step_s * (b.turn_radps + turn) / 2;
  const double middle = b.heading_rad + turned / 2;
  const double chord = 1 - turned * turned / 24;
  const double moved_m = chord * step_s * (b.speed_mps + speed_mps) / 2;
  b.place = b.place + moved_m * Vec2{std::cos(middle), std::sin(middle)};
  b.speed_mps = speed_mps;
  b.heading_rad += turned;
  b.turn_radps = turn;
}

void note(const Body& b, UnicycleMotion& to) {
  to.places_m.push_back(b.place);
  to.speeds_mps.push_back(b.speed_mps);
  to.headings_rad.push_back(b.heading_rad);
  to.turns_radps.push_back(b.turn_radps);
}

// A true state that fits the measurements, near what was proposed.
Body start_of(const UnicycleProblem& q, const UnicycleCandidate& c) {
  Body b;
  b.place = q.position + q.position_error_m * q.normal;
  const double heading = q.heading_rad + std::clamp(c.headings_rad[0] - q.heading_rad,
                                                    -q.heading_error_rad, q.heading_error_rad);
  const auto at = [&](double keep) {
    const double h = q.heading_rad + keep * (heading - q.heading_rad);
    const Vec2 way{std::cos(h), std::sin(h)};
    const double along = std::clamp(dot(way, q.velocity), 0.0, q.speed_mps);
    const double v = along + keep * (std::clamp(c.speeds_mps[0], 0.0, q.speed_mps) - along);
    b.heading_rad = h;
    b.speed_mps = v;
    return norm(v * way - q.velocity) <= q.velocity_error_mps;
  };
  // Ipopt exceeds constraints by about 1e-8; by less and less is given away for that.
  for (double keep = 1; keep > 0; keep = 1 - std::max(2 * (1 - keep), 1e-12)) {
    if (at(keep)) return b;
  }
  (void)at(0);
  return b;
}

// Of the whole candidate, without a stop.
UnicycleMotion driven(const UnicycleProblem& q, const UnicycleCandidate& c) {
  UnicycleMotion m;
  const double interval_s = q.horizon_s / q.intervals;
  m.step_s = interval_s / steps_per_interval;
  Body b = start_of(q, c);
  const auto turn_in = [&](std::size_t k) {
    return std::clamp((c.headings_rad[k + 1] - c.headings_rad[k]) / interval_s, -q.turn_radps,
                      q.turn_radps);
  };
  b.turn_radps = turn_in(0);
  note(b, m);
  for (std::size_t k = 0; k + 1 < c.speeds_mps.size(); ++k) {
    const double wanted = std::clamp(c.speeds_mps[k + 1], 0.0, q.speed_mps);
    for (int i = 0; i < steps_per_interval; ++i) {
      const double share = 1.0 / (steps_per_interval - i);
      const double next =
          b.speed_mps + std::clamp(share * (wanted - b.speed_mps), -q.brake_mps2 * m.step_s,
                                   q.accel_mps2 * m.step_s);
      drive(q, next, turn_in(k), m.step_s, b);
      note(b, m);
    }
  }
  return m;
}

// From there on the brake, until it rests.
void stop(const UnicycleProblem& q, Body b, UnicycleMotion& m) {
  while (b.speed_mps > 0) {
    drive(q, std::max(0.0, b.speed_mps - q.brake_mps2 * m.step_s), 0, m.step_s, b);
    note(b, m);
  }
}

double farthest_m(const UnicycleProblem& q, const UnicycleMotion& m) {
  double most = -HUGE_VAL;
  for (const Vec2 p : m.places_m) most = std::max(most, dot(q.normal, p - q.position));
  return most;
}

// The worst moment for the brake.
UnicycleMotion judged(const UnicycleProblem& q, const UnicycleCandidate& c) {
  const UnicycleMotion free = driven(q, c);
  UnicycleMotion worst;
  for (std::size_t k = 0; k < free.places_m.size(); k += steps_per_interval) {
    UnicycleMotion m = free;
    m.places_m.resize(k + 1);
    m.speeds_mps.resize(k + 1);
    m.headings_rad.resize(k + 1);
    m.turns_radps.resize(k + 1);
    stop(q, {m.places_m[k], m.speeds_mps[k], m.headings_rad[k], m.turns_radps[k]}, m);
    m.reach_m = farthest_m(q, m);
    if (m.reach_m >= worst.reach_m) worst = std::move(m);
  }
  return worst;
}

// ---- where searches begin

double uniform(std::mt19937_64& random) {
  return optimize::draw_share(random);
}

// Turns to where it should drive and speeds up, as fast as `share` of its limits allows.
UnicycleCandidate turned_to(const UnicycleProblem& q, double heading_rad, double share) {
  UnicycleCandidate c;
  const double step_s = q.horizon_s / q.intervals;
  double v = std::min(norm(q.velocity) + share * q.velocity_error_mps, q.speed_mps);
  double gap = std::remainder(heading_rad - q.heading_rad, 2 * pi);
  double h = q.heading_rad + std::clamp(gap, -q.heading_error_rad, q.heading_error_rad);
  for (int k = 0; k <= q.intervals; ++k) {
    c.speeds_mps.push_back(v);
    c.headings_rad.push_back(h);
    v = std::min(v + share * q.accel_mps2 * step_s, q.speed_mps);
    gap = std::remainder(heading_rad - h, 2 * pi);
    h += std::clamp(gap, -share * q.turn_radps * step_s, share * q.turn_radps * step_s);
  }
  return c;
}

// The n-th: to the normal, straight on, as it is, anywhere.
UnicycleCandidate starting_point(const UnicycleProblem& q, int n, std::mt19937_64& random) {
  constexpr double inside = 0.9;  // an interior point method starts inside the limits
  const double normal_rad = std::atan2(q.normal.y, q.normal.x);
  if (n == 0) return turned_to(q, normal_rad, inside);
  if (n == 1) return turned_to(q, q.heading_rad, inside);
  if (n == 2) return turned_to(q, q.heading_rad, 0);
  return turned_to(q, 2 * pi * uniform(random), inside * uniform(random));
}

// At full effort: each push and each turn is held for a while.
UnicycleCandidate drawn(const UnicycleProblem& q, std::mt19937_64& random) {
  constexpr double change = 0.15;  // of the intervals begin with another control
  const double step_s = q.horizon_s / q.intervals;
  const double away = 2 * uniform(random) - 1, faster = 2 * uniform(random) - 1;
  UnicycleCandidate c;
  double h = q.heading_rad + away * q.heading_error_rad;
  double v = std::clamp(norm(q.velocity) + faster * q.velocity_error_mps, 0.0, q.speed_mps);
  double push = q.accel_mps2, turn = q.turn_radps * (2 * uniform(random) - 1);
  for (int k = 0; k <= q.intervals; ++k) {
    c.speeds_mps.push_back(v);
    c.headings_rad.push_back(h);
    if (uniform(random) < change) turn = q.turn_radps * std::floor(3 * uniform(random) - 1);
    if (uniform(random) < change) push = uniform(random) < 0.75 ? q.accel_mps2 : -q.brake_mps2;
    v = std::clamp(v + push * step_s, 0.0, q.speed_mps);
    h += turn * step_s;
  }
  return c;
}

void keep_worse(UnicycleMotion found, UnicycleMotion& worst) {
  if (found.reach_m > worst.reach_m) worst = std::move(found);
}

}  // namespace

UnicycleMotion worst_motion(const UnicycleProblem& problem) {
  UnicycleMotion worst;
  if (!valid(problem)) return worst;
  bool converged = false;
  std::mt19937_64 random(problem.seed);
  for (int n = 0; n < problem.starts; ++n) {
    UnicycleCandidate candidate = starting_point(problem, n, random);
    // A failed search leaves the starting point, which is as good a motion as any.
    converged = optimize::solve(problem, candidate) == SolveStatus::converged || converged;
    keep_worse(judged(problem, candidate), worst);
  }
  worst.status = converged ? SearchStatus::converged : SearchStatus::stopped_early;
  return worst;
}

UnicycleMotion worst_motion_by_restarts(const UnicycleProblem& problem, int restarts) {
  UnicycleMotion worst;
  if (!valid(problem)) return worst;
  std::mt19937_64 random(problem.seed);
  const double normal_rad = std::atan2(problem.normal.y, problem.normal.x);
  for (int n = 0; n < restarts; ++n) {
    const UnicycleCandidate c = n == 0 ? turned_to(problem, normal_rad, 1) : drawn(problem, random);
    keep_worse(judged(problem, c), worst);
  }
  worst.status = SearchStatus::stopped_early;  // nobody knows whether there is a worse one
  return worst;
}

}  // namespace rtac
