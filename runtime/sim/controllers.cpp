#include "rtac/sim/controllers.h"

#include <algorithm>
#include <utility>

#include "rtac/sim/math.h"

namespace rtac::sim {
namespace {

constexpr double us_to_s = 1e-6;

bool usable(const Sample<Vec2>& sample) {
  return sample.stamp_us != never_us && is_finite(sample.value);
}

double limit_or(double chosen, double limit) {
  return chosen > 0 ? std::min(chosen, limit) : limit;
}

Vec2 limited(Vec2 v, double bound) {
  const double norm_v = length(v);
  return norm_v > bound ? (bound / norm_v) * v : v;
}

double age_s(TimeUs now_us, TimeUs stamp_us) {
  return us_to_s * static_cast<double>(now_us - stamp_us);
}

// Where the robot is now, if it kept its measured velocity since the fix.
Vec2 present_place(const Observation& observation) {
  const Sample<Vec2>& position = observation.position;
  if (!usable(observation.velocity)) return position.value;
  return position.value + age_s(observation.now_us, position.stamp_us) * observation.velocity.value;
}

// Way along the plan from `here` to its end.
double remaining_m(const Path& plan, Vec2 here) {
  double sum = 0;
  for (std::size_t i = plan.index; i < plan.points.size(); ++i) {
    sum += length(plan.points[i] - here);
    here = plan.points[i];
  }
  return sum;
}

// Speed at which the next way-point may be passed: what the bend allows, and what can be braked
// away on the leg behind it.
double passing_speed(const Path& plan, Vec2 here, double speed_max, double brake_mps2) {
  if (plan.index + 1 >= plan.points.size()) return 0;
  const Vec2 leg = plan.points[plan.index] - here;
  const Vec2 next = plan.points[plan.index + 1] - plan.points[plan.index];
  const double leg_m = length(leg);
  const double next_m = length(next);
  if (leg_m < 1e-6 || next_m < 1e-6) return 0;
  const double straightness = std::max(0.0, dot(leg, next) / (leg_m * next_m));
  return std::min(speed_max * straightness, std::sqrt(2 * brake_mps2 * next_m));
}

// Velocity set-point of the point mass.
Vec2 approach_velocity(const Path& plan, Vec2 here, const RobotLimits& limits,
                       const FollowOptions& options) {
  const Vec2 to = plan.points[plan.index] - here;
  const double distance = length(to);
  if (distance < 1e-6) return {};
  const double cap = limit_or(options.speed_mps, limits.speed_mps);
  const double brake = options.brake_share * limits.brake_mps2;
  const double passing = passing_speed(plan, here, cap, brake);
  const double braked = std::sqrt(passing * passing + 2 * brake * distance);
  const double speed = std::min({cap, braked, passing + options.gain_per_s * distance});
  return (speed / distance) * to;
}

Twist follow(const Observation& observation, const RobotLimits& limits,
             const FollowOptions& options) {
  const Sample<double>& heading = observation.heading;
  if (heading.stamp_us == never_us || !std::isfinite(heading.value)) return {};
  const Path& plan = observation.plan;
  const Vec2 here = present_place(observation);
  const Vec2 to = plan.points[plan.index] - here;
  if (length(to) < 1e-6) return {};
  const double error = wrap_angle(angle_of(to) - heading.value);
  const double turn_max = limit_or(options.turn_radps, limits.turn_radps);
  const double speed_max = limit_or(options.speed_mps, limits.speed_mps);
  const double straight = std::max(0.0, 1 - std::abs(error) / options.turn_in_place_rad);
  const double speed = clamp(options.gain_per_s * remaining_m(plan, here), -speed_max, speed_max);
  return {speed * straight, clamp(options.heading_gain_per_s * error, -turn_max, turn_max)};
}

// The hold of the point mass; a unicycle at rest needs none.
struct Hold {
  bool active = false;
  Vec2 place;
};

void command_of(const Observation& observation, const RobotLimits& limits,
                const FollowOptions& options, Hold& /*hold*/, Twist& output) {
  if (!observation.plan.finished()) output = follow(observation, limits, options);
}

void command_of(const Observation& observation, const RobotLimits& limits,
                const FollowOptions& options, Hold& hold, Acceleration& output) {
  if (!usable(observation.velocity)) return;
  const Vec2 velocity = observation.velocity.value;
  const Vec2 here = present_place(observation);
  Vec2 wanted;
  if (observation.plan.finished()) {
    // A velocity-only hold would creep away on the velocity error: hold a place.
    const double speed = length(velocity);
    const double stop_s = speed / (2 * std::max(limits.brake_mps2, 1e-6));
    if (!hold.active) hold = {true, here + stop_s * velocity};
    wanted = limited(options.gain_per_s * (hold.place - here), limits.speed_mps);
  } else {
    hold.active = false;
    wanted = approach_velocity(observation.plan, here, limits, options);
  }
  output.value_mps2 = limited((1 / options.response_s) * (wanted - velocity),
                              std::max(limits.accel_mps2, limits.brake_mps2));
}

}  // namespace

template <class Output>
FollowPlan<Output>::FollowPlan(const RobotLimits& limits, const FollowOptions& options)
    : limits_(limits), options_(options) {}

template <class Output>
Output FollowPlan<Output>::command(const Observation& observation) {
  Output output{};
  if (!usable(observation.position)) return output;
  Hold hold{holding_, hold_};
  command_of(observation, limits_, options_, hold, output);
  holding_ = hold.active;
  hold_ = hold.place;
  return output;
}

template <class Output>
Lapses<Output>::Lapses(std::unique_ptr<Controller<Output>> honest,
                       std::unique_ptr<Controller<Output>> faulty, const LapseOptions& options)
    : honest_(std::move(honest)),
      faulty_(std::move(faulty)),
      options_(options),
      random_(options.seed),
      change_us_(draw(options.mean_interval_us)) {}

template <class Output>
TimeUs Lapses<Output>::draw(TimeUs mean_us) {
  const TimeUs mean = std::max<TimeUs>(2, mean_us);
  return mean / 2 + random_.below(mean + 1);
}

template <class Output>
Output Lapses<Output>::command(const Observation& observation) {
  while (change_us_ <= observation.now_us) {
    lapsing_ = !lapsing_;
    lapses_ += lapsing_ ? 1 : 0;
    change_us_ += draw(lapsing_ ? options_.mean_duration_us : options_.mean_interval_us);
  }
  const Output honest = honest_->command(observation);
  const Output faulty = faulty_->command(observation);
  return lapsing_ ? faulty : honest;
}

template class FollowPlan<Acceleration>;
template class FollowPlan<Twist>;
template class Lapses<Acceleration>;
template class Lapses<Twist>;

}  // namespace rtac::sim
