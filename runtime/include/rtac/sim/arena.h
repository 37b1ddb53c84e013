// What an attack knows: everything. True states, properties, and what the decision of each robot
// has just found.
#pragma once

#include <vector>

#include "rtac/decision.h"
#include "rtac/sim/property.h"

namespace rtac::sim {

// Where a property fails soonest.
struct Threat {
  Vec3 direction;     // unit vector in which the robot's margin falls fastest; in the plane z is 0
  double margin = 0;  // that it has, in scales of its unit
  int monitor = -1;   // -1: no property depends on where the robot is
};

// What an attack aims at.
enum class Aim { anything, fence, robot, charge };

class Arena {
 public:
  // All of it outlives the arena; `truths` are those of the running world.
  Arena(const Surroundings& surroundings, const std::vector<Property>& properties,
        const RobotLimits& limits, int robots);
  void watch(const std::vector<TruthState>& truths) { truths_ = &truths; }
  void found(const DecisionRecord& record);

  [[nodiscard]] const RobotLimits& limits() const { return limits_; }
  [[nodiscard]] int robots() const { return static_cast<int>(records_.size()); }
  [[nodiscard]] const std::vector<TruthState>& truths() const { return *truths_; }
  [[nodiscard]] const TruthState& truth(int robot) const {
    return (*truths_)[static_cast<std::size_t>(robot)];
  }
  [[nodiscard]] const DecisionRecord& record(int robot) const {
    return records_[static_cast<std::size_t>(robot)];
  }
  // Of the properties that are aimed at the one whose margin is least.
  [[nodiscard]] Threat threat(int robot, Aim aim) const;
  // The same, sought once for each moment: who disturbs senses and who commands both ask for it.
  [[nodiscard]] Threat threat(int robot, Aim aim, TimeUs now_us) const;
  [[nodiscard]] bool has(Aim aim) const;

 private:
  struct Asked {
    TimeUs at_us = never_us;
    Aim aim = Aim::anything;
    Threat threat;
  };
  [[nodiscard]] double margin(std::size_t monitor, int robot, Vec3 at) const;
  [[nodiscard]] bool is_aim(std::size_t monitor, Aim aim) const;
  [[nodiscard]] Vec2 steepest(std::size_t monitor, int robot, double reach_m) const;
  [[nodiscard]] Vec3 steepest_in_space(std::size_t monitor, int robot, double reach_m) const;

  const Surroundings& surroundings_;
  const std::vector<Property>& properties_;
  RobotLimits limits_;
  const std::vector<TruthState>* truths_ = nullptr;
  std::vector<DecisionRecord> records_;
  std::vector<Aim> kinds_;            // of the properties
  mutable std::vector<Asked> asked_;  // last, of each robot
};

}  // namespace rtac::sim
