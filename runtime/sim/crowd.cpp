#include "rtac/sim/crowd.h"

#include <algorithm>
#include <limits>

#include "rtac/sim/math.h"

namespace rtac::sim {
namespace {

constexpr std::uint64_t crowd_stream = 2003, crowd_noise_stream = 2004, lasting_stream = 2006;
constexpr double s_per_us = 1e-6;
constexpr TimeUs phase_us_min = 300'000, phase_us_max = 4'000'000;
constexpr double nearest_m = 1, farthest_m = 6;   // from a robot, at the start
constexpr int tries_max = 400, tries_near = 200;  // then, up to 300 km, by this factor each time
constexpr double farther = 1.04;

}  // namespace

Crowd::Crowd(const std::vector<AgentSetup>& agents, const std::vector<Property>& properties,
             Surroundings& surroundings, const std::vector<TruthState>& truths,
             const Hostility& hostility, std::uint64_t seed, Tape& tape)
    : agents_(agents),
      truths_(truths),
      hostility_(hostility),
      tape_(tape),
      moves_(Random::stream(seed, crowd_stream, 0)),
      noise_(Random::stream(seed, crowd_noise_stream, 0)),
      minds_(agents.size()),
      seen_(truths.size(), std::vector<Sample<Vec3>>(agents.size())) {
  surroundings.agents = &places_;
  surroundings.agent_radius_m.clear();
  surroundings.agent_in_space.clear();
  for (const AgentSetup& agent : agents) {
    surroundings.agent_radius_m.push_back(agent.radius_m);
    surroundings.agent_in_space.push_back(agent.in_space);
    longest_us_ = std::max(longest_us_, agent.age_us);
  }
  Random lasting = Random::stream(seed, lasting_stream, 0);
  for (std::size_t k = 0; k < agents.size(); ++k) {
    minds_[k].seen_off = rounded_down * any_way(lasting, k, 1);
  }
  place(properties, surroundings);
}

// Where the properties of all robots hold, near one of them; farther and farther away. Where they
// hold nowhere, as robots that start outside of what they say, anywhere near.
void Crowd::place(const std::vector<Property>& properties, const Surroundings& surroundings) {
  const auto holds = [&] {
    for (const Property& p : properties) {
      for (std::size_t r = 0; r < truths_.size(); ++r) {
        if (!(margin_of(p, scene_of(surroundings, truths_, static_cast<int>(r))) > 0)) return false;
      }
    }
    return true;
  };
  for (std::size_t k = 0; k < agents_.size(); ++k) {
    places_.emplace_back();
    Vec3 near{};
    double far_m = farthest_m;
    for (int tries = 0; tries < tries_max; ++tries) {
      far_m = tries <= tries_near ? farthest_m * (1 + 0.1 * tries) : far_m * farther;
      const auto robot = static_cast<std::size_t>(moves_.below(std::int64_t(truths_.size())));
      const double reach_m = moves_.uniform(nearest_m, far_m);
      places_.back() = level(k, position_of(truths_[robot])) + any_way(moves_, k, reach_m);
      if (holds()) break;
      if (tries == tries_near) near = places_.back();
      if (tries + 1 == tries_max) places_.back() = near;
    }
  }
}

Vec3 Crowd::level(std::size_t agent, Vec3 way) const {
  return agents_[agent].in_space ? way : Vec3{way.x, way.y, 0};
}

Vec3 Crowd::any_way(Random& random, std::size_t agent, double size) const {
  if (agents_[agent].in_space) return random.on_sphere(size);
  const Vec2 flat = random.on_circle(size);
  return {flat.x, flat.y, 0};
}

Vec3 Crowd::way_to_nearest(std::size_t agent) const {
  Vec3 nearest{};
  double least = std::numeric_limits<double>::infinity();
  for (const TruthState& truth : truths_) {
    const Vec3 way = level(agent, position_of(truth) - places_[agent]);
    const double gap = length(way);
    if (gap < least) nearest = way;
    least = std::min(least, gap);
  }
  return nearest;
}

// Straight at the nearest robot, until it touches it; then off again.
void Crowd::decide(std::size_t agent, TimeUs now_us) {
  Mind& mind = minds_[agent];
  const Vec3 towards = way_to_nearest(agent);
  const double gap = length(towards);
  const bool touches = mind.phase == Phase::charge && gap < agents_[agent].radius_m;
  if (now_us >= mind.until_us || touches) {
    const double draw = moves_.uniform();
    mind.phase = touches       ? Phase::away
                 : draw < 0.6  ? Phase::charge
                 : draw < 0.75 ? Phase::away
                 : draw < 0.95 ? Phase::wander
                               : Phase::stand;
    mind.until_us = now_us + phase_us_min + moves_.below(phase_us_max - phase_us_min);
    mind.direction = any_way(moves_, agent, 1);
  }
  if (gap <= 0 || mind.phase == Phase::wander) return;
  if (mind.phase == Phase::charge) mind.direction = (1 / gap) * towards;
  if (mind.phase == Phase::away) mind.direction = (-1 / gap) * towards;
}

void Crowd::move(TimeUs now_us) {
  if (agents_.empty()) return;
  const double time_s = now_us_ == never_us ? 0 : static_cast<double>(now_us - now_us_) * s_per_us;
  now_us_ = now_us;
  for (std::size_t k = 0; k < agents_.size(); ++k) {
    decide(k, now_us);
    if (minds_[k].phase == Phase::stand) continue;
    places_[k] = places_[k] + (agents_[k].speed_mps * time_s * rounded_down) * minds_[k].direction;
  }
  const auto old = std::partition_point(
      log_.begin(), log_.end(), [&](const Moment& m) { return m.time_us <= now_us - longest_us_; });
  // one that is older stays, so that there is always one as old as may be
  if (old - log_.begin() > 256) log_.erase(log_.begin(), old - 1);
  log_.push_back({now_us, places_});
}

const Crowd::Moment& Crowd::at(TimeUs time_us) const {
  const auto found = std::lower_bound(log_.begin(), log_.end(), time_us,
                                      [](const Moment& m, TimeUs us) { return m.time_us < us; });
  return found == log_.end() ? log_.back() : *found;
}

// Aimed noise: seen farther away than it is.
Vec3 Crowd::offset(std::size_t agent, Vec3 away) {
  const double error = agents_[agent].error_m;
  const double gap = length(away);
  switch (hostility_.noise) {
    case Noise::none:
      return {};
    case Noise::uniform: {
      if (agents_[agent].in_space) return noise_.in_ball(error);
      const Vec2 flat = noise_.in_disc(error);
      return {flat.x, flat.y, 0};
    }
    case Noise::aimed:
      if (gap > 0) return (error * rounded_down / gap) * away;
      break;
    case Noise::lasting:
      return error * minds_[agent].seen_off;
    case Noise::extreme:
      break;
  }
  return any_way(noise_, agent, error);
}

Sample<Vec3> Crowd::see(int robot, int agent, TimeUs now_us) {
  const auto r = static_cast<std::size_t>(robot), k = static_cast<std::size_t>(agent);
  Sample<Vec3>& sample = seen_[r][k];
  const TimeUs most_us = agents_[k].age_us;
  TimeUs age_us = most_us;
  if (hostility_.ages == Ages::fresh) age_us = 0;
  if (hostility_.ages == Ages::wandering) age_us = noise_.below(most_us + 1);
  const Moment& moment = at(std::max(now_us - age_us, sample.stamp_us));
  if (moment.time_us > sample.stamp_us) {
    const Vec3 place = moment.places[k];
    sample = {place + offset(k, level(k, place - position_of(truths_[r]))), moment.time_us};
  }
  std::vector<std::int64_t> whole{robot, agent, sample.stamp_us};
  std::vector<double> real{sample.value.x, sample.value.y};
  if (agents_[k].in_space) real.push_back(sample.value.z);
  if (tape_.playing() && tape_.read("agent", whole, real, 2)) {
    sample = {{real[0], real[1], real.size() > 2 ? real[2] : 0}, whole[2]};
  }
  tape_.write("agent", whole, real);
  return sample;
}

}  // namespace rtac::sim
