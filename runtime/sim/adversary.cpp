#include "rtac/sim/adversary.h"

#include <algorithm>
#include <utility>

#include "rtac/sim/math.h"

namespace rtac::sim {
namespace {

constexpr double heading_gain_per_s = 6.0;

bool usable(const Sample<Vec2>& sample) {
  return sample.stamp_us != never_us && is_finite(sample.value);
}

void push(Vec2 direction, const Observation& /*observation*/, const RobotLimits& limits,
          Acceleration& output) {
  output.value_mps2 = limits.accel_mps2 * direction;
}

void push(Vec2 direction, const Observation& observation, const RobotLimits& limits,
          Twist& output) {
  output = {limits.speed_mps, 0};
  const Sample<double>& heading = observation.heading;
  if (heading.stamp_us == never_us || !std::isfinite(heading.value)) return;
  double error = wrap_angle(angle_of(direction) - heading.value);
  if (std::abs(error) > pi / 2) {
    error = wrap_angle(error + pi);
    output.speed_mps = -limits.speed_mps;
  }
  const double turn_max = limits.turn_radps > 0 ? limits.turn_radps : 1.0;
  output.turn_radps = clamp(heading_gain_per_s * error, -turn_max, turn_max);
}

void draw(Random& random, const RobotLimits& limits, Acceleration& output) {
  const double most_mps2 = std::max(limits.accel_mps2, limits.brake_mps2);
  if (limits.in_space) {
    const Vec3 push = random.on_sphere(most_mps2);
    output = {{push.x, push.y}, push.z};
    return;
  }
  output.value_mps2 = random.on_circle(most_mps2);
}

void draw(Random& random, const RobotLimits& limits, Twist& output) {
  output.speed_mps = random.sign() * limits.speed_mps;
  output.turn_radps = static_cast<double>(random.below(3) - 1) * limits.turn_radps;
}

}  // namespace

template <class Output>
PushAtNearest<Output>::PushAtNearest(const RobotLimits& limits, const ZoneView* zone)
    : limits_(limits), zone_(zone) {}

template <class Output>
Vec2 PushAtNearest<Output>::push_direction(const Observation& observation) const {
  const Vec2 here = observation.position.value;
  Vec2 towards{};
  double nearest_gap = HUGE_VAL;
  if (zone_ != nullptr) {
    const double clearance = signed_clearance(*zone_, here);
    nearest_gap = clearance - limits_.radius_m;
    const Vec2 boundary = nearest_boundary(*zone_, here);
    towards = clearance >= 0 ? boundary - here : here - boundary;
  }
  for (int i = 0; i < observation.robots && i < static_cast<int>(max_robots); ++i) {
    const Sample<Vec2>& other = observation.others[static_cast<std::size_t>(i)].position;
    if (i == observation.self || !usable(other)) continue;
    const double gap = length(other.value - here) - 2 * limits_.radius_m;
    if (gap < nearest_gap) {
      nearest_gap = gap;
      towards = other.value - here;
    }
  }
  const double distance = length(towards);
  return distance > 1e-6 ? (1 / distance) * towards : last_direction_;
}

template <class Output>
Output PushAtNearest<Output>::command(const Observation& observation) {
  if (usable(observation.position)) last_direction_ = push_direction(observation);
  Output output{};
  push(last_direction_, observation, limits_, output);
  return output;
}

template <class Output>
BangBang<Output>::BangBang(const RobotLimits& limits, std::uint64_t seed, TimeUs hold_us_min,
                           TimeUs hold_us_max)
    : limits_(limits),
      random_(seed),
      hold_us_min_(std::max<TimeUs>(1, hold_us_min)),
      hold_us_max_(std::max(hold_us_min_, hold_us_max)) {}

template <class Output>
Output BangBang<Output>::command(const Observation& observation) {
  if (until_us_ == never_us) until_us_ = observation.now_us;
  while (until_us_ <= observation.now_us) {
    draw(random_, limits_, held_);
    until_us_ += hold_us_min_ + random_.below(hold_us_max_ - hold_us_min_ + 1);
  }
  return held_;
}

template <class Output>
Replay<Output>::Replay(std::vector<Entry> entries) : entries_(std::move(entries)) {
  std::stable_sort(entries_.begin(), entries_.end(),
                   [](const Entry& a, const Entry& b) { return a.from_us < b.from_us; });
}

template <class Output>
Output Replay<Output>::command(const Observation& observation) {
  const auto after =
      std::upper_bound(entries_.begin(), entries_.end(), observation.now_us,
                       [](TimeUs now_us, const Entry& entry) { return now_us < entry.from_us; });
  return after == entries_.begin() ? Output{} : std::prev(after)->output;
}

template class PushAtNearest<Acceleration>;
template class PushAtNearest<Twist>;
template class BangBang<Acceleration>;
template class BangBang<Twist>;
template class Replay<Acceleration>;
template class Replay<Twist>;

}  // namespace rtac::sim
