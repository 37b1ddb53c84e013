#include "unverified.h"

#include <algorithm>
#include <cmath>

#include "rtac/sim/math.h"

namespace rtac::simulate {
namespace {

using sim::TruthState;

constexpr TimeUs phase_us_min = 200'000, phase_us_max = 3'000'000;
constexpr double turn_gain_per_s = 6;
// A lag of the first order that acts late does not overshoot while it is late by less than 1/e of
// its time constant: of so many of what it is late by.
constexpr double lags = 3;
constexpr double s_per_us = 1e-6;

// Speeds up and slows down so gently that it never gets faster than is wanted.
void drive(Vec3 wanted, double settles_s, const TruthState& truth, const RobotLimits& limits,
           Acceleration& to) {
  const Vec3 wish = (1 / settles_s) * (wanted - sim::velocity_of(truth));
  const double size = norm(wish);
  const Vec3 push = size > limits.accel_mps2 ? (limits.accel_mps2 / size) * wish : wish;
  to = {{push.x, push.y}, push.z};
}

// Its own wheels see to the speed; backwards, when that is the shorter turn.
void drive(Vec3 wanted_in_space, double /*settles_s*/, const TruthState& truth,
           const RobotLimits& limits, Twist& to) {
  const Vec2 wanted{wanted_in_space.x, wanted_in_space.y};
  to = {norm(wanted), 0};
  double error = sim::wrap_angle(sim::angle_of(wanted) - truth.heading_rad);
  if (std::abs(error) > sim::pi / 2) {
    error = sim::wrap_angle(error + sim::pi);
    to.speed_mps = -to.speed_mps;
  }
  to.turn_radps = sim::clamp(turn_gain_per_s * error, -limits.turn_radps, limits.turn_radps);
}

}  // namespace

template <class Output>
Unverified<Output>::Unverified(const sim::Arena& arena, int robot, sim::Aim aim, double speed_mps,
                               TimeUs acts_us, std::uint64_t seed)
    : arena_(arena),
      robot_(robot),
      aim_(aim),
      settles_s_(lags * static_cast<double>(acts_us) * s_per_us),
      random_(seed) {
  // what pushes the robot makes it faster until that is noticed
  speed_mps_ = std::max(0.0, speed_mps - arena.limits().disturbance_mps2 * settles_s_);
}

template <class Output>
void Unverified<Output>::choose(TimeUs now_us) {
  if (until_us_ == never_us) until_us_ = now_us;
  while (until_us_ <= now_us) {
    until_us_ += phase_us_min + random_.below(phase_us_max - phase_us_min);
    const double draw = random_.uniform();
    towards_ = draw < 0.5 ? 1 : (draw < 0.75 ? -1 : 0.3);
    across_ = draw < 0.75 ? 0 : random_.sign();
  }
}

template <class Output>
Output Unverified<Output>::command(const Observation& observation) {
  choose(observation.now_us);
  Output output{};
  const sim::Threat threat = arena_.threat(robot_, aim_, observation.now_us);
  const Vec3 to = threat.direction;
  const Vec3 way = towards_ * to + across_ * Vec3{-to.y, to.x, 0};
  const double size = norm(way);
  const Vec3 wanted = size > 0 ? (speed_mps_ / size) * way : Vec3{};
  drive(wanted, settles_s_, arena_.truth(robot_), arena_.limits(), output);
  return output;
}

template class Unverified<Acceleration>;
template class Unverified<Twist>;

}  // namespace rtac::simulate
