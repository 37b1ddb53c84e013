#include "rtac/sim/property.h"

#include <algorithm>
#include <limits>

#include "rtac/sim/math.h"

namespace rtac::sim {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int nobody = -1;

class Evaluation {
 public:
  explicit Evaluation(const Scene& scene) : scene_(scene) {}

  double margin(const Property& p, int other) const {
    switch (p.op) {
      case PropertyOp::truth:
        return p.value != 0 ? infinite : -infinite;
      case PropertyOp::open:
        return scene_.surroundings.open[static_cast<std::size_t>(p.index)] ? infinite : -infinite;
      case PropertyOp::inside:
        return clearance(p.index);
      case PropertyOp::at_least:
        return at_least(p, other);
      case PropertyOp::logical_not:
        return -margin(p.of[0], other);
      case PropertyOp::logical_and:
        return extreme(p, other, true);
      case PropertyOp::logical_or:
        return extreme(p, other, false);
      case PropertyOp::forall:
      case PropertyOp::exists:
        return others(p, p.op == PropertyOp::forall);
      default:
        return -infinite;  // no condition: nothing holds
    }
  }

 private:
  double at_least(const Property& p, int other) const {
    const double m = (quantity(p.of[0], other) - quantity(p.of[1], other)) / p.value;
    return p.flag && m == 0 ? -std::numeric_limits<double>::min() : m;
  }
  double extreme(const Property& p, int other, bool least) const {
    double found = least ? infinite : -infinite;
    for (const Property& each : p.of) {
      const double m = margin(each, other);
      found = least ? std::min(found, m) : std::max(found, m);
    }
    return found;
  }
  double others(const Property& p, bool all) const {
    double found = all ? infinite : -infinite;
    for (int j = 0; j < static_cast<int>(scene_.truths.size()); ++j) {
      if (j == scene_.self) continue;
      const double m = margin(p.of[0], j);
      found = all ? std::min(found, m) : std::max(found, m);
    }
    return found;
  }
  double quantity(const Property& p, int other) const {
    switch (p.op) {
      case PropertyOp::constant:
        return p.value;
      case PropertyOp::battery:
        return truth(p, other).battery;
      case PropertyOp::speed:
        return length(velocity_of(truth(p, other)));
      case PropertyOp::clearance:
        return clearance(p.index);
      case PropertyOp::distance:
        return distance(other);
      case PropertyOp::altitude:
        return scene_.height_m;
      case PropertyOp::agent_distance:
        return agent_distance(static_cast<std::size_t>(p.index));
      case PropertyOp::energy_to:
        return energy_to(p.index);
      case PropertyOp::choice:
        return quantity(p.of[margin(p.of[0], other) >= 0 ? 1 : 2], other);
      case PropertyOp::count:
        return count(p);
      case PropertyOp::truth:
      case PropertyOp::open:
      case PropertyOp::inside:
      case PropertyOp::at_least:
      case PropertyOp::logical_not:
      case PropertyOp::logical_and:
      case PropertyOp::logical_or:
      case PropertyOp::forall:
      case PropertyOp::exists:
        return std::numeric_limits<double>::quiet_NaN();
      default:
        return combined(p.op, p.of.size(), [&](std::size_t k) { return quantity(p.of[k], other); });
    }
  }
  double count(const Property& p) const {
    int found = 0;
    for (int j = 0; j < static_cast<int>(scene_.truths.size()); ++j) {
      if (j != scene_.self && margin(p.of[0], j) >= 0) ++found;
    }
    return found;
  }
  const TruthState& truth(const Property& p, int other) const {
    return scene_.truths[static_cast<std::size_t>(p.flag ? other : scene_.self)];
  }
  double clearance(int zone) const {
    const auto& solids = scene_.surroundings.solids;
    const auto index = static_cast<std::size_t>(zone);
    if (index < solids.size() && solids[index].slab_count > 0) {
      return signed_clearance(solids[index], {scene_.at.x, scene_.at.y, scene_.height_m}) -
             scene_.surroundings.radius_m;
    }
    return signed_clearance(scene_.surroundings.zones[static_cast<std::size_t>(zone)], scene_.at) -
           scene_.surroundings.radius_m;
  }
  double distance(int other) const {
    const Vec3 there = position_of(scene_.truths[static_cast<std::size_t>(other)]);
    const Vec3 here{scene_.at.x, scene_.at.y, scene_.height_m};
    return length(there - here) - 2 * scene_.surroundings.radius_m;
  }
  bool stands() const {
    const Surroundings& s = scene_.surroundings;
    const auto self = static_cast<std::size_t>(scene_.self);
    return s.told_to_stand != nullptr && (*s.told_to_stand)[self] &&
           length(velocity_of(scene_.truths[self])) <= s.rest_mps;
  }
  double agent_distance(std::size_t agent) const {
    const Surroundings& s = scene_.surroundings;
    if (s.agents == nullptr || agent >= s.agents->size()) return infinite;
    if (scene_.passive && stands()) return infinite;
    const Vec3 way = (*s.agents)[agent] - Vec3{scene_.at.x, scene_.at.y, scene_.height_m};
    const double apart_m = s.agent_in_space[agent] ? length(way) : length(Vec2{way.x, way.y});
    return apart_m - s.radius_m - s.agent_radius_m[agent];
  }
  double energy_to(int site) const {
    const auto& places = scene_.surroundings.sites[static_cast<std::size_t>(site)];
    const Vec2 way = places[static_cast<std::size_t>(scene_.self)] - scene_.at;
    return length(way) * scene_.surroundings.drive_per_m;
  }

  const Scene& scene_;
};

bool is_length(const Property& p) {
  return p.op == PropertyOp::clearance || p.op == PropertyOp::distance ||
         p.op == PropertyOp::altitude;
}

}  // namespace

Scene scene_of(const Surroundings& surroundings, const std::vector<TruthState>& truths, int self) {
  const TruthState& own = truths[static_cast<std::size_t>(self)];
  return {surroundings, truths, self, own.position, own.height_m};
}

double margin_of(const Property& property, const Scene& scene) {
  return Evaluation(scene).margin(property, nobody);
}

double steepness_per_m(const Property& p) {
  switch (p.op) {
    case PropertyOp::inside:
      return 1;
    case PropertyOp::truth:
    case PropertyOp::open:  // nothing that a robot does
      return std::numeric_limits<double>::min();
    case PropertyOp::at_least: {
      const bool plain = (is_length(p.of[0]) && p.of[1].op == PropertyOp::constant) ||
                         (is_length(p.of[1]) && p.of[0].op == PropertyOp::constant);
      return plain ? 1 / p.value : 0;
    }
    case PropertyOp::logical_not:
    case PropertyOp::logical_and:
    case PropertyOp::logical_or:
    case PropertyOp::forall:
    case PropertyOp::exists: {
      double most = 0;
      for (const Property& each : p.of) {
        const double steepness = steepness_per_m(each);
        if (steepness <= 0) return 0;
        most = std::max(most, steepness);
      }
      return most;
    }
    default:
      return 0;
  }
}

bool speaks_of(const Property& property, PropertyOp op) {
  return property.op == op || std::any_of(property.of.begin(), property.of.end(),
                                          [&](const Property& p) { return speaks_of(p, op); });
}

}  // namespace rtac::sim
