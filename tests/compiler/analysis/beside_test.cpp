// How far beside its leg a recovery drives, against its pilot: measurements as late and as wrong as
// they may be, with errors that last, that change sides at every pace, and that pull it off.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

#include "compiler/analysis/travel.h"
#include "rtac/safe/pilot.h"

namespace rtac::analysis {
namespace {

struct Late {
  double speed, position_error, other_error;   // m/s, m; of the velocity, m/s, or the heading, rad
  std::int64_t position_age_ms, other_age_ms;  // of the velocity or the heading
  double push = 0;                             // m/s^2
  std::int64_t period_ms = 50, latency_ms = 50;
  double accel = 2, turn_accel = 10;  // m/s^2, rad/s^2
};

sema::Quantity milli_si(double value) {
  return {Rational(static_cast<long>(std::lround(1000 * value)), 1000), {}};
}
sema::Sense late_sense(double error, std::int64_t age_ms) {
  return {milli_si(error), milli_si(1e-3 * static_cast<double>(age_ms))};
}

constexpr double turn_radps = 2;

sema::RobotKind late_kind(const Late& c, bool wheels) {
  sema::RobotKind k;
  k.radius = milli_si(0.1);
  k.motion.model = wheels ? sema::MotionModel::unicycle : sema::MotionModel::point;
  k.motion.speed = milli_si(c.speed), k.motion.accel = k.motion.brake = milli_si(c.accel);
  k.position = late_sense(c.position_error, c.position_age_ms);
  k.latency = milli_si(1e-3 * static_cast<double>(c.latency_ms));
  if (wheels) {
    k.motion.turn = milli_si(turn_radps), k.motion.turn_accel = milli_si(c.turn_accel);
    k.heading = late_sense(c.other_error, c.other_age_ms);
    k.velocity = late_sense(0.01, 50);
  } else {
    k.motion.disturbance = milli_si(c.push);
    k.velocity = late_sense(c.other_error, c.other_age_ms);
  }
  return k;
}

safe::Setting late_setting(const Late& c, bool wheels) {
  safe::Setting s;
  RobotLimits& l = s.limits;
  l.speed_mps = c.speed, l.accel_mps2 = l.brake_mps2 = c.accel;
  l.position_error_m = c.position_error, l.position_age_us = 1000 * c.position_age_ms;
  l.latency_us = 1000 * c.latency_ms;
  l.velocity_error_mps = wheels ? 0.01 : c.other_error;
  l.velocity_age_us = wheels ? 50'000 : 1000 * c.other_age_ms;
  if (wheels) {
    l.unicycle = true, l.turn_radps = turn_radps, l.turn_accel_radps2 = c.turn_accel;
    l.heading_error_rad = c.other_error, l.heading_age_us = 1000 * c.other_age_ms;
  } else {
    l.disturbance_mps2 = c.push;
  }
  s.period_us = 1000 * c.period_ms, s.speed_mps = c.speed;
  return s;
}

struct State {
  double x = 0, y = 0, heading = 0, vx = 0, vy = 0, speed = 0, turn = 0;
};

// Sides that the errors of the place and the other measurement are on: they last, on one side or
// against each other, change every `half_s` in the same ways, or show the robot nearer to its leg
// than it is.
struct Errors {
  int kind;
  double half_s;
};
std::pair<double, double> sides(const Errors& e, double t_s, double beside_m) {
  const double swings = static_cast<std::int64_t>(t_s / e.half_s) % 2 == 0 ? 1 : -1;
  if (e.kind == 0) return {1, 1};
  if (e.kind == 1) return {swings, swings};
  if (e.kind == 2) return {swings, -swings};
  if (e.kind == 4) return {1, -1};
  return beside_m > 0 ? std::pair{-1.0, -1.0} : std::pair{1.0, 1.0};
}

void act(const Acceleration& out, const Late& c, double side, double dt, State& s) {
  s.vx += out.value_mps2.x * dt, s.vy += (out.value_mps2.y + side * c.push) * dt;
  s.x += s.vx * dt, s.y += s.vy * dt;
}
void act(const Twist& out, const Late& c, double, double dt, State& s) {
  const auto slew = [&](double& value, double target, double rate) {
    value += std::clamp(target - value, -rate * dt, rate * dt);
  };
  slew(s.speed, out.speed_mps, c.accel);
  slew(s.turn, out.turn_radps, c.turn_accel);
  s.heading += s.turn * dt;
  s.vx = s.speed * std::cos(s.heading), s.vy = s.speed * std::sin(s.heading);
  s.x += s.vx * dt, s.y += s.vy * dt;
}

// The largest distance from a leg of 60 s along the x-axis.
template <class Output>
double farthest_m(const Late& c, const Errors& errors) {
  constexpr bool wheels = std::is_same_v<Output, Twist>;
  const safe::Setting setting = late_setting(c, wheels);
  safe::Pilot<Output> pilot(setting);
  Path way;
  double leg_y = 0;  // where it is measured to be when it sets out
  State now;
  now.heading = 2;
  double farthest = 0;
  std::deque<State> past;  // the newest first, one a millisecond
  std::deque<std::pair<std::int64_t, Output>> coming;
  Output acting{};
  for (std::int64_t ms = 0; ms < 60'000; ++ms) {
    past.push_front(now);
    if (past.size() > 3'000) past.pop_back();
    const auto [a, b] = sides(errors, 1e-3 * static_cast<double>(ms), now.y - leg_y);
    if (ms % c.period_ms == 0) {
      const auto seen_at = [&](std::int64_t age_ms) {
        return past[static_cast<std::size_t>(std::min(age_ms, ms))];
      };
      const auto stamp_us = [&](std::int64_t age_ms) { return 1000 * (ms - std::min(age_ms, ms)); };
      Observation o;
      o.now_us = 1000 * ms;
      const State& place = seen_at(c.position_age_ms);
      o.position = {{place.x, place.y + a * c.position_error}, stamp_us(c.position_age_ms)};
      const State& other = seen_at(c.other_age_ms);
      if constexpr (wheels) {
        o.velocity = {{now.vx, now.vy}, 1000 * ms};
        o.heading = {other.heading + b * c.other_error, stamp_us(c.other_age_ms)};
      } else {
        o.velocity = {{other.vx, other.vy + b * c.other_error}, stamp_us(c.other_age_ms)};
      }
      if (ms == 0) {
        pilot.engage(o);
        leg_y = o.position.value.y;
        (void)way.points.push({1000, leg_y});
      }
      coming.emplace_back(ms + c.latency_ms, pilot.drive(o, o.position.value, way));
    }
    while (!coming.empty() && coming.front().first <= ms) {
      acting = coming.front().second;
      coming.pop_front();
    }
    act(acting, c, b, 1e-3, now);
    farthest = std::max(farthest, std::fabs(now.y - leg_y));
  }
  EXPECT_GT(now.x, 1) << "it does not drive";
  return farthest;
}

// Once more the error of the place: `beside_mm` is of where it is measured to be.
template <class Output>
void keeps(const Late& c) {
  const bool wheels = std::is_same_v<Output, Twist>;
  const auto beside = static_cast<double>(
      beside_mm(late_kind(c, wheels), milli_si(c.speed).value, 1000 * c.period_ms));
  double worst = 0;
  for (const int kind : {0, 1, 2, 3, 4}) {
    for (double half_s = 0.4; half_s < 25; half_s *= kind == 1 || kind == 2 ? 1.4 : 100) {
      worst = std::max(worst, farthest_m<Output>(c, {kind, half_s}));
    }
  }
  EXPECT_LE(1000 * worst, beside + 1000 * c.position_error)
      << c.speed << " m/s, ages " << c.position_age_ms << " and " << c.other_age_ms << " ms";
}

// With the gain of 1.5/s of a heading that is new, wheels swing about their leg by metres.
TEST(Beside, WheelsKeepToTheirLegHoweverLateTheySee) {
  for (const Late& c : {
           Late{0.15, 0.02, 0.035, 100, 100},
           Late{0.5, 0.05, 0.02, 100, 100},
           Late{2, 0.05, 0.02, 100, 100},
           Late{0.5, 0.05, 0.02, 200, 1'000},
           Late{0.5, 0.02, 0.05, 200, 2'000},
           Late{0.3, 0.05, 0.02, 2'000, 100},
           Late{1, 0.05, 0.02, 1'000, 1'000},
           Late{1, 0.1, 0.01, 2'000, 2'000},
       }) {
    keeps<Twist>(c);
  }
}

// Their turns end earlier, and they set out by as much as they err on top.
TEST(Beside, WheelsMaySeeBadly) {
  for (const Late& c : {
           Late{0.11, 0.02, 0.035, 100, 100},
           Late{0.2, 0.03, 0.05, 60, 60},
           Late{0.5, 0.02, 0.15, 100, 100},
           Late{0.8, 0.1, 0.05, 300, 20},
           Late{1.5, 0.05, 0.16, 20, 300},
           Late{0.05, 0.01, 0.15, 1'000, 200},
       }) {
    keeps<Twist>(c);
  }
}

// With the gain of 1/s of a place that is new, a point mass weaves.
TEST(Beside, PointMassesKeepToTheirLegHoweverLateTheySee) {
  for (const Late& c : {
           Late{0.3, 0.02, 0.02, 50, 50},
           Late{1, 0.05, 0.05, 100, 100, 0.1},
           Late{1, 0.05, 0.05, 200, 600},
           Late{0.5, 0.05, 0.05, 900, 900},
           Late{1, 0.1, 0.05, 2'000, 100, 0.1},
           Late{1, 0.05, 0.02, 1'000, 2'000},
       }) {
    keeps<Acceleration>(c);
  }
}

// They pass the end of a turn by half a radian, and swing about their leg.
TEST(Beside, WheelsMayTurnSluggishly) {
  for (const Late& c : {
           Late{0.782, 0.006, 0.019, 1'000, 50, 0, 5, 10, 2.904, 0.32},
           Late{0.729, 0.001, 0.018, 300, 20, 0, 50, 100, 1.081, 0.68},
           Late{0.624, 0.038, 0.01, 300, 20, 0, 100, 300, 0.936, 0.94},
       }) {
    keeps<Twist>(c);
  }
}

// While it speeds up for nine seconds there is little left to steer with against what pushes.
TEST(Beside, PointMassesMaySpeedUpSlowly) {
  for (const Late& c : {
           Late{3.863, 0.004, 0.008, 1, 50, 0.043, 50, 10, 0.437},
           Late{2.653, 0.007, 0.012, 1'000, 20, 0.05, 10, 100, 0.522},
       }) {
    keeps<Acceleration>(c);
  }
}

}  // namespace
}  // namespace rtac::analysis
