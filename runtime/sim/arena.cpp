#include "rtac/sim/arena.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "rtac/sim/math.h"

namespace rtac::sim {
namespace {

constexpr std::size_t directions = 16;  // looked at first; then the best one is refined
constexpr int refinements = 5;
// How far around the robot it looks: to where the property fails, within these limits.
constexpr double nearest_m = 0.02, farthest_m = 10;

double angle_of_ring(std::size_t k, std::size_t of) {
  return 2 * pi * static_cast<double>(k) / static_cast<double>(of);
}
Vec2 unit_of(double angle_rad) {
  const SinCos unit = sin_cos(angle_rad);
  return {unit.cos, unit.sin};
}
template <std::size_t size>
std::array<Vec2, size> ring_of() {
  std::array<Vec2, size> ring;
  for (std::size_t k = 0; k < size; ++k) ring[k] = unit_of(angle_of_ring(k, size));
  return ring;
}

Aim kind_of(const Property& p) {
  if (speaks_of(p, PropertyOp::battery) || speaks_of(p, PropertyOp::energy_to)) return Aim::charge;
  const bool others =
      speaks_of(p, PropertyOp::distance) || speaks_of(p, PropertyOp::agent_distance);
  return others ? Aim::robot : Aim::fence;
}

}  // namespace

Arena::Arena(const Surroundings& surroundings, const std::vector<Property>& properties,
             const RobotLimits& limits, int robots)
    : surroundings_(surroundings),
      properties_(properties),
      limits_(limits),
      records_(static_cast<std::size_t>(robots)),
      asked_(static_cast<std::size_t>(robots)) {
  for (const Property& p : properties) kinds_.push_back(kind_of(p));
}

void Arena::found(const DecisionRecord& record) {
  records_[static_cast<std::size_t>(record.robot)] = record;
}

double Arena::margin(std::size_t monitor, int robot, Vec3 at) const {
  return margin_of(properties_[monitor], {surroundings_, *truths_, robot, {at.x, at.y}, at.z});
}

bool Arena::is_aim(std::size_t monitor, Aim aim) const {
  return aim == Aim::anything || kinds_[monitor] == aim;
}

bool Arena::has(Aim aim) const {
  for (std::size_t m = 0; m < kinds_.size(); ++m) {
    if (is_aim(m, aim)) return true;
  }
  return false;
}

Vec2 Arena::steepest(std::size_t monitor, int robot, double reach_m) const {
  const Vec3 here = position_of(truth(robot));
  static const std::array<Vec2, directions> ring = ring_of<directions>();
  Vec2 best{1, 0};
  double best_rad = 0, least = std::numeric_limits<double>::infinity();
  const auto look = [&](double angle_rad, Vec2 way) {
    const double m = margin(monitor, robot, here + reach_m * Vec3{way.x, way.y, 0});
    if (!(m < least)) return;
    least = m;
    best = way;
    best_rad = angle_rad;
  };
  for (std::size_t k = 0; k < directions; ++k) look(angle_of_ring(k, directions), ring[k]);
  double turn_rad = pi / directions;
  for (int k = 0; k < refinements; ++k, turn_rad /= 2) {
    const double centre_rad = best_rad;
    for (const double angle_rad : {centre_rad - turn_rad, centre_rad + turn_rad}) {
      look(angle_rad, unit_of(angle_rad));
    }
  }
  return best;
}

Threat Arena::threat(int robot, Aim aim) const {
  Threat threat;
  threat.margin = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < properties_.size(); ++m) {
    if (!is_aim(m, aim)) continue;
    const double found = margin(m, robot, position_of(truth(robot)));
    if (!(found < threat.margin)) continue;
    threat.margin = found;
    threat.monitor = static_cast<int>(m);
  }
  if (threat.monitor < 0) return threat;
  const double reach_m =
      kinds_[static_cast<std::size_t>(threat.monitor)] == Aim::charge ? 1 : threat.margin;
  const auto monitor = static_cast<std::size_t>(threat.monitor);
  const double look_m = clamp(std::abs(reach_m) + nearest_m, nearest_m, farthest_m);
  if (limits_.in_space) {
    threat.direction = steepest_in_space(monitor, robot, look_m);
  } else {
    const Vec2 level = steepest(monitor, robot, look_m);
    threat.direction = {level.x, level.y, 0};
  }
  return threat;
}

Threat Arena::threat(int robot, Aim aim, TimeUs now_us) const {
  Asked& last = asked_[static_cast<std::size_t>(robot)];
  if (last.at_us != now_us || last.aim != aim) last = {now_us, aim, threat(robot, aim)};
  return last.threat;
}

// Straight up and down, and rings of directions between; then around the best of them. Walls are
// flat, so that a margin falls over the half of all directions that lead to one: few rings do.
Vec3 Arena::steepest_in_space(std::size_t monitor, int robot, double reach_m) const {
  const Vec3 here = position_of(truth(robot));
  constexpr int tilts = 4, turns = 8;
  Vec3 best{0, 0, 1};
  double least = std::numeric_limits<double>::infinity(), best_tilt = 0, best_turn = 0;
  const auto look = [&](double tilt_rad, double turn_rad) {
    const SinCos tilt = sin_cos(tilt_rad), turn = sin_cos(turn_rad);
    const Vec3 way{tilt.cos * turn.cos, tilt.cos * turn.sin, tilt.sin};
    const double m = margin(monitor, robot, here + reach_m * way);
    if (!(m < least)) return;
    least = m;
    best = way;
    best_tilt = tilt_rad;
    best_turn = turn_rad;
  };
  for (int t = -tilts / 2; t <= tilts / 2; ++t) {
    const int of_ring = std::abs(t) == tilts / 2 ? 1 : turns;  // up and down there is one way
    for (int k = 0; k < of_ring; ++k) look(pi * t / tilts, 2 * pi * k / turns);
  }
  double by_rad = pi / turns;
  for (int k = 0; k < refinements; ++k, by_rad /= 2) {
    const double tilt_rad = best_tilt, turn_rad = best_turn;
    for (const double by : {-by_rad, by_rad}) {
      look(tilt_rad + by, turn_rad);
      look(tilt_rad, turn_rad + by);
    }
  }
  return best;
}

}  // namespace rtac::sim
