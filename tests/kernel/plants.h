// Robots that obey their declared bounds and nothing else: any admissible control, then a brake.
// Lengths in mm, speeds in mm/s, times in s.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/kernel/exact.h"

namespace rtac::kernel_test {

constexpr double dt_s = 0.002;

struct Real {
  double x = 0, y = 0;
};
inline Real operator+(Real a, Real b) {
  return {a.x + b.x, a.y + b.y};
}
inline Real operator-(Real a, Real b) {
  return {a.x - b.x, a.y - b.y};
}
inline Real operator*(double k, Real a) {
  return {k * a.x, k * a.y};
}
inline double norm(Real a) {
  return std::hypot(a.x, a.y);
}
inline Real heading(double angle) {
  return {std::cos(angle), std::sin(angle)};
}
inline Real real(probe_vec v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}
inline double distance(Real p, Real a, Real b) {
  const Real d = b - a, q = p - a;
  const double length = d.x * d.x + d.y * d.y;
  const double t = length > 0 ? std::clamp((q.x * d.x + q.y * d.y) / length, 0.0, 1.0) : 0;
  return norm(q - t * d);
}
// Noise up to the bound, half of the time exactly at it.
inline Real noise(Random& random, double bound) {
  return (random.one_in(2) ? bound : random.real(0, bound)) * heading(random.real(-3.2, 3.2));
}

// How an adversary chooses its control: once, or anew every so often.
class Whim {
 public:
  explicit Whim(Random& random) : random_(random), bold_(!random.one_in(3)) {}
  // In [-1, 1], mostly at the ends.
  double next(double t_s) {
    if (t_s >= until_s_) {
      value_ = random_.one_in(4) ? random_.real(-1, 1) : (random_.one_in(2) ? 1 : -1);
      angle_ = random_.real(-3.2, 3.2);
      until_s_ = t_s + (bold_ ? 1e9 : random_.real(0, 0.3));
    }
    return value_;
  }
  [[nodiscard]] double angle() const { return angle_; }
  // From now on this and nothing else.
  void settle(double value, double angle) {
    bold_ = true;
    value_ = value;
    angle_ = angle;
    until_s_ = 1e9;
  }
  [[nodiscard]] bool bold() const { return bold_; }

 private:
  Random& random_;
  bool bold_;
  double value_ = 1, angle_ = 0, until_s_ = -1;
};

// Point mass: |a| <= accel, |v| <= cap.
struct PointPlant {
  Real p, v;
  double accel, brake, cap;

  void free(Whim& whim, double t_s) {
    const double push = accel * std::fabs(whim.next(t_s));
    move(push * heading(whim.angle()));
  }
  // Ideal: straight against the velocity.
  void stop() {
    const double speed = norm(v);
    const double least = std::min(speed, brake * dt_s);
    const Real before = v;
    v = speed > 0 ? (1 - least / speed) * v : Real{};
    p = p + (0.5 * dt_s) * (before + v);
  }
  [[nodiscard]] bool rests() const { return norm(v) == 0; }
  void move(Real a) {
    const Real before = v;
    v = v + dt_s * a;
    if (const double speed = norm(v); speed > cap) v = (cap / speed) * v;
    p = p + (0.5 * dt_s) * (before + v);
  }
  [[nodiscard]] Real velocity() const { return v; }
};

// The same, pushed with up to `push` besides: while anybody controls it (its `accel` contains that)
// and while it brakes.
struct PushedPlant : PointPlant {
  double push;
  Real wind{};

  void free(Whim& whim, double t_s) {
    PointPlant::free(whim, t_s);
    // the most while it brakes is across the way, or along it
    wind = push * heading(std::atan2(v.y, v.x) + (whim.bold() ? 0 : whim.angle()));
    if (whim.angle() > 0) wind = {-wind.y, wind.x};
  }
  void stop() {
    const double speed = norm(v);
    const Real before = v;
    if (speed <= brake * dt_s) {
      v = {};  // it can hold its place
    } else {
      v = (1 - brake * dt_s / speed) * v + dt_s * wind;
    }
    p = p + (0.5 * dt_s) * (before + v);
  }
};

// Unicycle: |speed| <= cap in either direction, |turn| <= turn_max. The advanced side may turn at
// once; the brake sets the turn to 0, which takes its time.
struct CartPlant {
  Real p;
  double angle = 0, speed = 0, turn = 0;
  double accel, brake, cap, turn_max, turn_accel;

  void free(Whim& whim, double t_s) {
    const double push = whim.next(t_s);
    turn = turn_max * (whim.bold() ? std::clamp(whim.angle(), -1.0, 1.0)
                                   : std::clamp(2 * std::sin(7 * whim.angle()), -1.0, 1.0));
    const double before = speed;
    speed = std::clamp(speed + push * accel * dt_s, -std::max(cap, std::fabs(speed)),
                       std::max(cap, std::fabs(speed)));
    roll(0.5 * (before + speed));
  }
  void stop() {
    const double before = speed;
    const double least = std::min(std::fabs(speed), brake * dt_s);
    speed -= std::copysign(least, speed);
    turn -= std::copysign(std::min(std::fabs(turn), turn_accel * dt_s), turn);
    roll(0.5 * (before + speed));
  }
  [[nodiscard]] bool rests() const { return speed == 0; }
  void roll(double mean) {
    p = p + (dt_s * mean) * heading(angle + 0.5 * dt_s * turn);
    angle += dt_s * turn;
  }
  [[nodiscard]] Real velocity() const { return speed * heading(angle); }
};

// The grid values around a measurement, as the wrapper makes them.
inline probe_point measured(Real value, std::int64_t stamp_us) {
  return {static_cast<std::int64_t>(std::floor(value.x)),
          static_cast<std::int64_t>(std::ceil(value.x)),
          static_cast<std::int64_t>(std::floor(value.y)),
          static_cast<std::int64_t>(std::ceil(value.y)),
          stamp_us,
          1};
}

// A start on the move, somewhere between two millimetres.
inline Real somewhere(Random& random, double size) {
  return {random.real(-size, size), random.real(-size, size)};
}

// When samples were taken, when the decision is made, until when any control may act.
struct Timing {
  std::int64_t position_us, velocity_us, now_us, horizon_us;
  [[nodiscard]] double end_s() const { return 1e-6 * static_cast<double>(now_us + horizon_us); }
};
// The older of both samples is of time 0; all times are multiples of the step.
inline Timing random_timing(Random& random, const probe_body& b, std::int64_t horizon_us) {
  const auto age = [&](std::int64_t most) {
    constexpr auto step_us = static_cast<std::int64_t>(1e6 * dt_s);
    const std::int64_t us = random.one_in(3) ? most : (random.one_in(4) ? 0 : random.in(0, most));
    return us - us % step_us;
  };
  const std::int64_t p = age(b.position_age_us), v = age(b.velocity_age_us);
  const std::int64_t now = std::max(p, v);
  return {now - p, now - v, now, horizon_us};
}

}  // namespace rtac::kernel_test
