#include "hostile_senses.h"

#include <algorithm>
#include <limits>

#include "rtac/sim/math.h"

namespace rtac::sim {
namespace {

constexpr std::uint64_t senses_stream = 2001, lasting_stream = 2005;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
// Of a run: how often aimed noise is aimed exactly.
constexpr double aimed_share = 0.6;

Vec3 turned(Vec3 v, double angle_rad) {
  const SinCos turn = sin_cos(angle_rad);
  return {turn.cos * v.x - turn.sin * v.y, turn.sin * v.x + turn.cos * v.y, v.z};
}

Vec2 level(Vec3 v) {
  return {v.x, v.y};
}

Vec3 level_offset(Vec2 v) {
  return {v.x, v.y, 0};
}

}  // namespace

HostileSenses::HostileSenses(const Arena& arena, const Hostility& hostility, int robot)
    : arena_(arena),
      hostility_(hostility),
      robot_(robot),
      random_(Random::stream(hostility.seed, senses_stream, static_cast<std::uint64_t>(robot))),
      old_position_(random_.sign() > 0),
      turn_rad_(random_.uniform() < aimed_share ? 0 : random_.uniform(-pi, pi)),
      lasting_(draw_lasting()) {}

// What is measured of the motion points the way of the place, against it, or anywhere.
HostileSenses::Lasting HostileSenses::draw_lasting() const {
  Random random =
      Random::stream(hostility_.seed, lasting_stream, static_cast<std::uint64_t>(robot_));
  const auto any_way = [&] {
    return arena_.limits().in_space ? random.on_sphere(1) : level_offset(random.on_circle(1));
  };
  Lasting lasting;
  lasting.position = any_way();
  lasting.velocity = random.uniform() < 0.5 ? random.sign() * lasting.position : any_way();
  lasting.sign = random.sign();
  return lasting;
}

TimeUs HostileSenses::age(Sense sense, TimeUs max_age_us) {
  switch (hostility_.ages) {
    case Ages::fresh:
      return 0;
    case Ages::oldest:
      return max_age_us;
    case Ages::unequal:
      return (sense == Sense::position) == old_position_ ? max_age_us : 0;
    case Ages::wandering:
      return random_.below(max_age_us + 1);
  }
  return 0;
}

void HostileSenses::plan_faults(TimeUs now_us) {
  if (hostility_.fault_every_us <= 0 || now_us < fault_.until_us) return;
  static constexpr std::array<Sense, 5> senses{Sense::position, Sense::velocity, Sense::heading,
                                               Sense::battery, Sense::announcements};
  fault_.sense = senses[static_cast<std::size_t>(random_.below(senses.size()))];
  fault_.broken = random_.uniform() < 0.5;
  fault_.from_us = now_us + random_.below(2 * hostility_.fault_every_us);
  fault_.until_us = fault_.from_us + random_.below(hostility_.fault_us_max + 1);
}

void HostileSenses::aim(TimeUs now_us) {
  if (hostility_.noise != Noise::aimed || aimed_us_ == now_us) return;
  aimed_us_ = now_us;
  const Threat threat = arena_.threat(robot_, hostility_.aim, now_us);
  if (threat.monitor >= 0) away_ = turned(-1.0 * threat.direction, turn_rad_);
}

Vec3 HostileSenses::offset(double error, Vec3 lasting) {
  const bool in_space = arena_.limits().in_space;
  switch (hostility_.noise) {
    case Noise::none:
      return {};
    case Noise::uniform:
      return in_space ? random_.in_ball(error) : level_offset(random_.in_disc(error));
    case Noise::extreme:
      return in_space ? random_.on_sphere(error) : level_offset(random_.on_circle(error));
    case Noise::aimed:
      return (error * rounded_down) * away_;
    case Noise::lasting:
      return (error * rounded_down) * lasting;
  }
  return {};
}

double HostileSenses::offset(double error) {
  switch (hostility_.noise) {
    case Noise::none:
      return 0;
    case Noise::uniform:
      return random_.uniform(-error, error);
    case Noise::extreme:
    case Noise::aimed:
      return error * random_.sign();
    case Noise::lasting:
      return error * lasting_.sign;
  }
  return 0;
}

template <class T>
const TruthState* HostileSenses::take(Sense sense, TimeUs now_us, TimeUs max_age_us,
                                      const TruthLog& log, Sample<T>& sample) {
  const TimeUs wanted_us = now_us - age(sense, max_age_us);
  if (faulty(sense, now_us) && !fault_.broken) return nullptr;
  const TruthLog::Moment& moment = log.at(std::max(wanted_us, sample.stamp_us));
  if (moment.time_us <= sample.stamp_us) return nullptr;
  sample.stamp_us = moment.time_us;
  return &moment.truths[static_cast<std::size_t>(robot_)];
}

void HostileSenses::measure(TimeUs now_us, const TruthLog& log, Observation& observation) {
  const RobotLimits& limits = arena_.limits();
  plan_faults(now_us);
  aim(now_us);
  if (const TruthState* truth =
          take(Sense::position, now_us, limits.position_age_us, log, position_)) {
    position_.value = position_of(*truth) + offset(limits.position_error_m, lasting_.position);
  }
  if (const TruthState* truth =
          take(Sense::velocity, now_us, limits.velocity_age_us, log, velocity_)) {
    velocity_.value = velocity_of(*truth) + offset(limits.velocity_error_mps, lasting_.velocity);
  }
  if (const TruthState* truth =
          take(Sense::heading, now_us, limits.heading_age_us, log, heading_)) {
    heading_.value = wrap_angle(truth->heading_rad + offset(limits.heading_error_rad));
  }
  if (const TruthState* truth =
          take(Sense::battery, now_us, limits.battery_age_us, log, battery_)) {
    const double error =
        hostility_.noise == Noise::aimed ? limits.battery_error : offset(limits.battery_error);
    battery_.value = clamp(truth->battery + error, 0, 1);
  }
  observation.position = {level(position_.value), position_.stamp_us};
  observation.velocity = {level(velocity_.value), velocity_.stamp_us};
  observation.height_m = position_.value.z;
  observation.climb_mps = velocity_.value.z;
  observation.heading = heading_;
  observation.battery = battery_;
  if (!fault_.broken) return;
  if (faulty(Sense::position, now_us)) observation.position.value = {not_a_number, not_a_number};
  if (faulty(Sense::velocity, now_us)) observation.velocity.value = {not_a_number, not_a_number};
  if (faulty(Sense::heading, now_us)) observation.heading.value = not_a_number;
  if (faulty(Sense::battery, now_us)) observation.battery.value = not_a_number;
}

// How old a robot's own measurement may be that it tells the others of: as old as it senses, for a
// period longer where it is told of between two decisions. Half of what they admit is left for the
// message, and it can still be heard a period later: that nobody is ever heard is no assumption.
TimeUs HostileSenses::told_age(TimeUs max_age_us) const {
  const TimeUs hears_us = arena_.limits().hears_age_us;
  const TimeUs next_us = hears_us - hostility_.period_us - hostility_.jitter_us;
  return std::max<TimeUs>(0, std::min({max_age_us + hostility_.period_us, hears_us / 2, next_us}));
}

void HostileSenses::announce(TimeUs now_us, const TruthLog& log, Announcement& announcement) {
  const RobotLimits& limits = arena_.limits();
  aim(now_us);
  const bool unequal = hostility_.ages == Ages::unequal;
  const auto stamp = [&](bool old, TimeUs max_age_us, TimeUs& last_us) -> const TruthLog::Moment& {
    const TimeUs age_us = unequal && old ? told_age(max_age_us) : 0;
    const TruthLog::Moment& moment = log.at(std::max(now_us - age_us, last_us));
    last_us = moment.time_us;
    return moment;
  };
  const TruthLog::Moment& p = stamp(old_position_, limits.position_age_us, announced_position_us_);
  const TruthLog::Moment& v = stamp(!old_position_, limits.velocity_age_us, announced_velocity_us_);
  const auto self = static_cast<std::size_t>(robot_);
  const Vec3 at = position_of(p.truths[self]) + offset(limits.position_error_m, lasting_.position);
  const Vec3 moves =
      velocity_of(v.truths[self]) + offset(limits.velocity_error_mps, lasting_.velocity);
  announcement.position = {level(at), p.time_us};
  announcement.velocity = {level(moves), v.time_us};
  announcement.height_m = at.z;
  announcement.climb_mps = moves.z;
}

}  // namespace rtac::sim
