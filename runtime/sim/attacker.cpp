#include "rtac/sim/attacker.h"

#include <algorithm>
#include <cmath>

#include "rtac/sim/math.h"

namespace rtac::sim {
namespace {

constexpr double heading_gain_per_s = 6.0;
constexpr TimeUs phase_us_min = 200'000, phase_us_max = 3'000'000;
// Creeping: the spare look-ahead is used up with this time constant, down to a few mm.
constexpr double creep_time_s = 0.4;
constexpr double burst_m_max = 0.02;

// A velocity that is wanted, or full effort that way.
void drive(Vec3 wanted, bool all_out, const TruthState& truth, const RobotLimits& limits,
           Acceleration& output) {
  const double size = length(wanted);
  constexpr double response_s = 0.1;
  Vec3 push = (1 / response_s) * (wanted - velocity_of(truth));
  if (all_out) push = size > 0 ? (limits.accel_mps2 / size) * wanted : Vec3{};
  output = {{push.x, push.y}, push.z};
}

void drive(Vec3 wanted_in_space, bool all_out, const TruthState& truth, const RobotLimits& limits,
           Twist& output) {
  const Vec2 wanted{wanted_in_space.x, wanted_in_space.y};
  const double speed = all_out ? limits.speed_mps : std::min(length(wanted), limits.speed_mps);
  output = {speed, 0};
  double error = wrap_angle(angle_of(wanted) - truth.heading_rad);
  if (std::abs(error) > pi / 2) {
    error = wrap_angle(error + pi);
    output.speed_mps = -speed;
  }
  const double turn_max = limits.turn_radps > 0 ? limits.turn_radps : 1.0;
  output.turn_radps = clamp(heading_gain_per_s * error, -turn_max, turn_max);
}

}  // namespace

template <class Output>
Chase<Output>::Chase(const Arena& arena, int robot, Aim aim, std::uint64_t seed, Manner manner)
    : arena_(arena), robot_(robot), aim_(aim), manner_(manner), random_(seed) {}

template <class Output>
void Chase<Output>::choose(TimeUs now_us) {
  if (manner_ == Manner::only_pushes) return;
  if (until_us_ == never_us) until_us_ = now_us;
  while (until_us_ <= now_us) {
    until_us_ += phase_us_min + random_.below(phase_us_max - phase_us_min);
    const double draw = random_.uniform();
    phase_ = draw < 0.45
                 ? Phase::push
                 : (draw < 0.6 ? Phase::run_up : (draw < 0.75 ? Phase::slide : Phase::creep));
    side_ = random_.sign();
    burst_m_ = random_.uniform(0, burst_m_max);
  }
}

template <class Output>
Vec3 Chase<Output>::wanted(const Threat& threat, bool& all_out) {
  const double speed = arena_.limits().speed_mps;
  Vec3 across = side_ * Vec3{-threat.direction.y, threat.direction.x, 0};
  // towards a floor or a ceiling: any way on its level
  if (length(across) < 0.1) across = {side_, 0, 0};
  switch (phase_) {
    case Phase::push:
      return threat.direction;
    case Phase::run_up:
      return -1.0 * threat.direction;
    case Phase::slide:
      return across + 0.3 * threat.direction;
    case Phase::creep:
      break;
  }
  const MonitorRecord& found =
      arena_.record(robot_).monitors[static_cast<std::size_t>(threat.monitor)];
  if (!(found.margin > burst_m_)) {
    phase_ = Phase::push;
    return threat.direction;
  }
  all_out = false;
  return std::min(speed, found.margin / creep_time_s) * threat.direction;
}

template <class Output>
Output Chase<Output>::command(const Observation& observation) {
  choose(observation.now_us);
  const Threat threat = arena_.threat(robot_, aim_, observation.now_us);
  Output output{};
  if (threat.monitor < 0) return output;
  bool all_out = true;
  const Vec3 way = wanted(threat, all_out);
  drive(way, all_out, arena_.truth(robot_), arena_.limits(), output);
  return output;
}

template class Chase<Acceleration>;
template class Chase<Twist>;

}  // namespace rtac::sim
