// Properties of robots as they are written, judged on the true state in doubles.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "rtac/sim/math.h"
#include "rtac/sim/world.h"
#include "rtac/zone.h"

namespace rtac::sim {

enum class PropertyOp {
  // quantities: m, m/s, share of a full battery
  constant,
  battery,
  speed,
  clearance,       // of the body from the boundary of zone `index`, negative outside
  distance,        // between the bodies of the robot and the other one
  agent_distance,  // between the bodies of the robot and of agent `index`
  altitude,        // of the centre
  energy_to,       // to site `index`: at least what the straight way takes
  add,
  subtract,
  multiply,
  divide,
  negate,
  minimum,
  maximum,
  absolute,
  square_root,
  norm,
  sine,  // of radians
  cosine,
  choice,  // of[1] where of[0] holds, else of[2]
  count,   // of other robots for which it holds
  // margins, in multiples of the scale of their unit
  truth,
  open,  // zone `index` of those with times is there
  inside,
  at_least,  // of[0] >= of[1]; `flag`: strictly
  logical_not,
  logical_and,
  logical_or,
  forall,
  exists
};

struct Property {
  PropertyOp op = PropertyOp::truth;
  double value = 1;   // of constants and truths; of at_least: the scale of its unit
  int index = 0;      // zone, zone with times, site or agent
  bool flag = false;  // of at_least: strictly; of battery and speed: those of the other robot
  std::vector<Property> of;
};

// What properties speak of. The views' tables outlive whoever has them.
struct Surroundings {
  std::vector<ZoneView> zones;
  std::vector<std::vector<Vec2>> sites;  // by site, then by robot
  double radius_m = 0;
  double drive_per_m = 0;
  // By zone: those with height have slabs, the others none.
  std::vector<SolidView> solids{};
  // A robot that is told to stand does so up to here.
  double rest_mps = 0;
  const std::vector<bool>* told_to_stand = nullptr;  // by robot; null: nobody is
  const std::vector<Vec3>* agents = nullptr;         // where they are now; null: far away
  std::vector<double> agent_radius_m{};
  std::vector<bool> agent_in_space{};  // the others are near whatever their height is
  std::vector<bool> open{};            // by zone with times, whether it is there now
};

// A robot `self` that stands at `at` while everything else is as in `truths`.
struct Scene {
  const Surroundings& surroundings;
  const std::vector<TruthState>& truths;
  int self = 0;
  Vec2 at;
  double height_m = 0;
  // Nobody keeps agents from a robot that stands: as if they were far away from it then.
  bool passive = false;
};
// Where it is.
Scene scene_of(const Surroundings& surroundings, const std::vector<TruthState>& truths, int self);

// What arithmetic makes of `count` numbers, each `at(k)`; no number of another operation.
template <class At>
double combined(PropertyOp op, std::size_t count, const At& at) {
  double result = at(0);
  switch (op) {
    case PropertyOp::add:
      return result + at(1);
    case PropertyOp::subtract:
      return result - at(1);
    case PropertyOp::multiply:
      return result * at(1);
    case PropertyOp::divide:
      return result / at(1);
    case PropertyOp::negate:
      return -result;
    case PropertyOp::minimum:
      for (std::size_t k = 1; k < count; ++k) result = std::fmin(result, at(k));
      return result;
    case PropertyOp::maximum:
      for (std::size_t k = 1; k < count; ++k) result = std::fmax(result, at(k));
      return result;
    case PropertyOp::absolute:
      return std::fabs(result);
    case PropertyOp::square_root:
      return std::sqrt(result);
    case PropertyOp::norm:
      for (std::size_t k = 1; k < count; ++k) result = std::hypot(result, at(k));
      return std::fabs(result);
    case PropertyOp::sine:
      return sin_cos(result).sin;
    case PropertyOp::cosine:
      return sin_cos(result).cos;
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

// Signed: not negative where it holds. Atoms without a quantity are infinite. Zones are looked at
// edge by edge, whatever tables there are.
double margin_of(const Property& property, const Scene& scene);

// The margin of a property that compares lengths with constants, and joins that by and, or and
// quantifiers, and by what no robot changes, falls by no more than this a metre that robots move;
// 0: it is another one.
double steepness_per_m(const Property& property);
// Does it speak of other robots, or of charge?
bool speaks_of(const Property& property, PropertyOp op);

}  // namespace rtac::sim
